// The documentation: links lead somewhere, paths that it names exist, licences fit.
import assert from 'node:assert/strict';
import { dirname, join, normalize } from 'node:path';
import { test } from 'node:test';
import { exists, files, lineOf, read } from './lib.mjs';

const pages = files.filter((path) => path.endsWith('.md'));
const withoutFences = (text) => text.replace(/^```[\s\S]*?^```/gm, (block) => block.replace(/[^\n]/g, ''));

/** GitHub's anchor for a heading. */
const anchor = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replace(/\s/g, '-');
const anchorsOf = (path) => [...withoutFences(read(path)).matchAll(/^#+\s+(.+)$/gm)].map((match) => anchor(match[1]));

function brokenLinks(page) {
  const text = withoutFences(read(page));
  return [...text.matchAll(/\]\(([^)\s]+)\)/g)].flatMap((match) => {
    const [path, fragment] = match[1].split('#');
    if (/^[a-z]+:/.test(match[1])) return [];
    const target = path === '' ? page : normalize(join(dirname(page), path));
    const found = exists(target) && (!fragment || !target.endsWith('.md') || anchorsOf(target).includes(fragment));
    return found ? [] : [`${page}:${lineOf(text, match.index)} -> ${match[1]}`];
  });
}

test('every link of the documentation leads to something', () => {
  assert.ok(pages.length > 3);
  assert.deepEqual(pages.flatMap(brokenLinks), []);
});

test('every path that the documentation names exists', () => {
  const paths = /`((?:runtime|blocks|src|ui|tests|docs|scripts)\/[\w./-]*\w)`/g;
  const missing = pages.flatMap((page) => {
    const text = withoutFences(read(page));
    return [...text.matchAll(paths)]
      .filter((match) => !exists(match[1]) && !/\/dist$/.test(match[1]))
      .map((match) => `${page}:${lineOf(text, match.index)} names ${match[1]}`);
  });
  assert.deepEqual(missing, []);
});

test('the schemas are JSON and say what they are for', () => {
  for (const path of files.filter((name) => /^docs\/schema\/.*\.json$/.test(name))) {
    const schema = JSON.parse(read(path));
    assert.ok(schema.$schema && schema.title, `${path} lacks $schema or title`);
  }
});

test('everything that the editor takes from npm has a licence that fits Apache-2.0', () => {
  const fits = /^\(?(?:(?:MIT|MIT-0|ISC|Apache-2\.0|BSD-2-Clause|BSD-3-Clause|0BSD|BlueOak-1\.0\.0|CC0-1\.0|CC-BY-4\.0|OFL-1\.1|Python-2\.0|Unlicense|WTFPL)(?: (?:OR|AND) )?)+\)?$/;
  const lock = JSON.parse(read('ui/package-lock.json'));
  const others = Object.entries(lock.packages).filter(([name, entry]) => name !== '' && !fits.test(entry.license ?? ''));
  assert.deepEqual(others.map(([name, entry]) => `${name}: ${entry.license}`), []);
});

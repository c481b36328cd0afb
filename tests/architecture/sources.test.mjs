// Sizes, names and habits that the house does not want, by reading the sources.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { test } from 'node:test';
import { files, isCpp, lineOf, read, root, shapeOf } from './lib.mjs';

const cpp = files.filter((path) => isCpp(path) && /^(runtime|blocks|src|tests)\//.test(path));
const product = cpp.filter((path) => !path.startsWith('tests/'));
const scripts = files.filter((path) => /\.(ts|tsx|mjs|css|sh)$/.test(path) || /^(scripts|\.ci)\/[\w-]+$/.test(path));
const prose = files.filter((path) => path.endsWith('.md'));
const length = (path) => read(path).split('\n').length - 1;

test('no source has more than 500 lines, no header more than 300', () => {
  const limit = (path) => (path.endsWith('.h') ? 300 : 500);
  const long = [...cpp, ...scripts].filter((path) => length(path) > limit(path));
  assert.deepEqual(long.map((path) => `${path}: ${length(path)} lines`), []);
});

test('half of the sources have at most 120 lines', () => {
  const lengths = product.filter((path) => path.endsWith('.cpp')).map(length).sort((a, b) => a - b);
  const median = lengths[Math.floor(lengths.length / 2)];
  assert.ok(median <= 120, `the median source has ${median} lines`);
});

/** Every hit of a pattern in the files, as "path:line: text". */
function hits(paths, pattern, textOf = read) {
  return paths.flatMap((path) => {
    const text = textOf(path);
    return [...text.matchAll(pattern)].map((match) => `${path}:${lineOf(text, match.index)}: ${match[0].trim()}`);
  });
}
const codeOf = (path) => shapeOf(read(path));

test('no singletons: nothing hands out a static of its own', () => {
  assert.deepEqual(hits(product, /\bstatic\b[^;{}()]*[&*]\s*(?:get_?)?(?:the_)?instance\s*\(/gi, codeOf), []);
});

test('no state outside objects: a static is constant', () => {
  const pattern = /^[ \t]*(?:inline\s+)?static\s+(?!const\b|constexpr\b|inline\s+const|thread_local\s+const)[\w:<>,&*\s]+?\s[\w]+\s*(?:=|\{|;)/gm;
  assert.deepEqual(hits(product, pattern, codeOf), []);
});

test('no static registration: no object is made just to register something', () => {
  const pattern = /^(?:static|const|namespace\s*\{)?\s*(?:const\s+)?(?:bool|int|auto|\w*Registra\w*)\s+\w*regist(?:ered|rar|ration)\w*\s*[={(]/gim;
  assert.deepEqual(hits(product, pattern, codeOf), []);
});

test('headers are guarded once and open no namespace for others', () => {
  const headers = cpp.filter((path) => path.endsWith('.h'));
  const unguarded = headers.filter((path) => !/^(?:\/\/[^\n]*\n)*#pragma once\n/.test(read(path)));
  assert.deepEqual([...unguarded, ...hits(headers, /^using namespace [\w:]+/gm, codeOf)], []);
});

test('nothing waits in a test', () => {
  const pattern = /\b(?:sleep_for|sleep_until|usleep|nanosleep)\s*\(/g;
  assert.deepEqual(hits(cpp.filter((path) => path.startsWith('tests/runtime/')), pattern, codeOf), []);
});

test('nothing is left for later', () => {
  const pattern = new RegExp(`\\b(?:${['TO' + 'DO', 'FIX' + 'ME', 'XX' + 'X', 'HA' + 'CK'].join('|')})\\b`, 'g');
  assert.deepEqual(hits([...cpp, ...scripts, ...prose], pattern), []);
});

test('nothing names a place on one machine', () => {
  const texts = files.filter((path) => /\.(cpp|h|def|ts|tsx|mjs|json|md|sh|txt|css|html|cmake)$/.test(path) || scripts.includes(path));
  const pattern = /(?<![\w.$}/])\/(?:work|root|home\/\w+)\/[\w.-]*/g;
  assert.deepEqual(hits(texts, pattern), []);
});

test('lock files name no download address', () => {
  const locks = files.filter((path) => /(?:package-lock|npm-shrinkwrap)\.json$/.test(path));
  assert.deepEqual(hits(locks, /"resolved": "http[^"]*"/g), []);
  assert.deepEqual(hits(files.filter((path) => /\.npmrc$/.test(path)), /^.*registry\s*=.*$/gm), []);
});

test('the top of the tree holds what docs/house.md lists', () => {
  const listed = read('docs/house.md').match(/^```tree\n([\s\S]*?)^```/m)?.[1] ?? '';
  const known = new Set([...listed.matchAll(/^([\w.-]+)\/?(?=\s|$)/gm)].map((match) => match[1]));
  const passing = new Set(['.git', 'build', '.cache', 'compile_commands.json']);
  const strangers = readdirSync(root).filter((name) => !known.has(name) && !passing.has(name));
  assert.deepEqual(strangers, []);
});

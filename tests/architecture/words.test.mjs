// Words shown to people: in every language, with the same arguments.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { files, lineOf, read, withoutComments } from './lib.mjs';

const placeholders = (text) => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1]).sort();
const slots = (text) => [...text.matchAll(/\[(\w+)\]/g)].map((match) => match[1]).sort();
const same = (a, b) => a.length === b.length && a.every((word, i) => word === b[i]);
const distinct = (words) => [...new Set(words)];

/** The C++ string literals of a text, with neighbours joined as the compiler joins them. */
function literals(text) {
  const joined = text.replace(/"\s*\n?\s*"/g, '');
  return [...joined.matchAll(/"((?:\\.|[^"\\])*)"/g)].map((match) => match[1]);
}

/** Every `Message name{"code", "en", "es"}` of a file. */
function messagesOf(path) {
  const text = withoutComments(read(path));
  return [...text.matchAll(/\bconstexpr\s+Message\s+(\w+)\s*\{((?:[^"{}]|"(?:\\.|[^"\\])*")*)\}/g)].map((match) => {
    const [code, en, es, ...more] = literals(match[2]);
    return { where: `${path}:${lineOf(text, match.index)} ${match[1]}`, name: match[1], code, en, es, more };
  });
}

const sources = files.filter((path) => /^(runtime|blocks|src)\/.*\.(h|cpp)$/.test(path));
const messages = sources.flatMap(messagesOf);
const faulty = (list, wrong) => list.filter(wrong).map((message) => message.where);

test('every message has a code and a sentence in each language', () => {
  assert.ok(messages.length > 10, 'no messages were found');
  assert.deepEqual(faulty(messages, (m) => !m.code || !m.en || !m.es || m.more.length > 0), []);
});

test('every row that says Message was read by this test', () => {
  for (const path of sources) {
    const rows = [...withoutComments(read(path)).matchAll(/\bconstexpr\s+Message\s+\w+/g)];
    assert.equal(messagesOf(path).length, rows.length, `${path} has a Message row that this test cannot read`);
  }
});

test('both languages name the same arguments', () => {
  const differs = (m) => !same(distinct(placeholders(m.en ?? '')), distinct(placeholders(m.es ?? '')));
  assert.deepEqual(faulty(messages, differs), []);
});

test('a code belongs to one message', () => {
  const seen = new Map();
  const doubles = messages.filter((m) => seen.size === seen.set(m.code, m.where).size);
  assert.deepEqual(doubles.map((m) => `${m.where}: ${m.code}`), []);
});

test('messages stand in a file messages.h', () => {
  const elsewhere = messages.filter((m) => !/messages\.h:/.test(m.where));
  assert.deepEqual(elsewhere.map((m) => m.where), []);
});

const packs = files.filter((path) => /^blocks\/[^/]+\/pack\.json$/.test(path));
const dataFiles = files.filter((path) => /^(blocks|runtime)\/.*\.json$/.test(path));

/** Every {en, es} in a JSON value with its path. */
function texts(value, path = '') {
  if (value === null || typeof value !== 'object') return [];
  const own = 'en' in value || 'es' in value ? [{ path, ...value }] : [];
  return [...own, ...Object.entries(value).flatMap(([key, inner]) => texts(inner, `${path}/${key}`))];
}

test('every text of a data file is there in each language', () => {
  const lacking = dataFiles.flatMap((path) =>
    texts(JSON.parse(read(path)))
      .filter((text) => ['en', 'es'].some((lang) => typeof text[lang] !== 'string' || text[lang].trim() === ''))
      .map((text) => `${path}${text.path}`),
  );
  assert.deepEqual(lacking, []);
});

test('every block has its sentence, its help and its menus in each language, with every argument in its place', () => {
  const problems = [];
  for (const path of packs) {
    for (const block of JSON.parse(read(path)).blocks) {
      const args = (block.args ?? []).map((arg) => arg.name).sort();
      for (const lang of ['en', 'es']) {
        if (!same(slots(block.text?.[lang] ?? ''), args)) problems.push(`${path} ${block.opcode} text.${lang}`);
        if (block.toolbox !== false && !block.help?.[lang]) problems.push(`${path} ${block.opcode} help.${lang}`);
      }
    }
  }
  assert.deepEqual(problems, []);
});

test('an opcode is declared once', () => {
  const opcodes = packs.flatMap((path) => JSON.parse(read(path)).blocks.map((block) => block.opcode));
  assert.deepEqual(opcodes.filter((opcode, i) => opcodes.indexOf(opcode) !== i), []);
});

// The checks can fail: one offence against each is planted in a copy of the tree, and each must be found.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { appendFileSync, cpSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { files, root } from './lib.mjs';

const place = ['', 'home', 'somebody', 'src'].join('/');
const later = 'TO' + 'DO';
const message = (name, code, en, es) =>
  `inline constexpr Message ${name}{"${code}", "${en}", "${es}"};\n`;

/** File, what is added to it (a new file when it is not there), the test that must say so, and by which word. */
const offences = [
  ['runtime/base/a.cpp', '#include "vm/machine.h"\n', 'every include is allowed by the table'],
  ['blocks/motion/b.cpp', '#include "hal/drive.h"\n', 'every include is allowed by the table'],
  ['runtime/cellar/a.cpp', '\n', 'the table names every room', 'runtime/cellar'],
  ['runtime/base/c.cpp', '#include "base/nowhere.h"\n', 'what is ours is included in quotes and exists'],
  ['runtime/base/d.cpp', '#include <base/clock.h>\n', 'what is ours is included in quotes and exists'],
  ['runtime/model/e.cpp', '#include <opencv2/opencv.hpp>\n', 'OpenCV comes by its module headers, never by the umbrella'],
  ['runtime/base/f.h', '#pragma once\n#include <nlohmann/json.hpp>\n', 'headers take only json_fwd.hpp, sources the whole of nlohmann'],
  ['runtime/cellar/b.cpp', '\n', 'every room with sources has tests', 'cellar'],
  ['runtime/base/g.cpp', '\n'.repeat(501), 'no source has more than 500 lines, no header more than 300'],
  ['runtime/base/h.h', `#pragma once\n${'\n'.repeat(300)}`, 'no source has more than 500 lines, no header more than 300'],
  ['runtime/base/i.h', '#pragma once\nstatic Thing& instance();\n', 'no singletons: nothing hands out a static of its own'],
  ['runtime/base/j.cpp', 'void f() {\n  static int calls = 0;\n}\n', 'no state outside objects: a static is constant'],
  ['runtime/base/k.cpp', 'const bool registered = add();\n', 'no static registration: no object is made just to register something'],
  ['runtime/base/l.h', '#pragma once\nusing namespace std;\n', 'headers are guarded once and open no namespace for others'],
  ['tests/runtime/base/m_test.cpp', 'std::this_thread::sleep_for(1s);\n', 'nothing waits in a test'],
  ['runtime/base/ll.h', 'struct L;\n', 'headers are guarded once and open no namespace for others'],
  ['runtime/base/n.cpp', `// ${later}: more\n`, 'nothing is left for later'],
  ['docs/o.md', `See ${place}.\n`, 'nothing names a place on one machine'],
  ['tests/package-lock.json', '{"resolved": "https://example.org/a.tgz"}\n', 'lock files name no download address'],
  ['attic/p.txt', '\n', 'the top of the tree holds what docs/house.md lists', 'attic'],
  ['runtime/q/messages.h', message('q', 'q', '', 'algo'), 'every message has a code and a sentence in each language'],
  ['runtime/r/messages.h', 'constexpr Message r = {kCode, kEn, kEs};\n', 'every row that says Message was read by this test'],
  ['runtime/s/messages.h', message('s', 's', 'a {file}', 'un {archivo}'), 'both languages name the same arguments'],
  ['runtime/t/messages.h', message('t', 's', 'a', 'un'), 'a code belongs to one message'],
  ['runtime/base/u.cpp', message('u', 'u', 'a', 'un'), 'messages stand in a file messages.h'],
  ['blocks/v/pack.json', '{"name": {"en": "V"}, "blocks": []}\n', 'every text of a data file is there in each language'],
  [
    'blocks/w/pack.json',
    '{"blocks": [{"opcode": "w", "text": {"en": "a [B]", "es": "a"}, "args": [{"name": "B"}]}]}\n',
    'every block has its sentence, its help and its menus in each language, with every argument in its place',
  ],
  ['blocks/x/pack.json', '{"blocks": [{"opcode": "w"}]}\n', 'an opcode is declared once', "'w'"],
  ['docs/y.md', '[there](nowhere.md)\n', 'every link of the documentation leads to something'],
  ['docs/z.md', 'in `runtime/base/nowhere.cpp`\n', 'every path that the documentation names exists'],
  ['docs/schema/zz.schema.json', '{}\n', 'the schemas are JSON and say what they are for'],
];

let copy;
before(() => {
  copy = mkdtempSync(join(tmpdir(), 'mirada-offences-'));
  for (const path of files) cpSync(join(root, path), join(copy, path));
  for (const [path, text] of offences) {
    mkdirSync(dirname(join(copy, path)), { recursive: true });
    appendFileSync(join(copy, path), text);
  }
});
after(() => rmSync(copy, { recursive: true, force: true }));

test('each planted offence is found by its test, with its file named', () => {
  const suites = ['layering', 'sources', 'words', 'docs'].map((name) => join(copy, `tests/architecture/${name}.test.mjs`));
  const environment = { ...process.env };
  delete environment.NODE_TEST_CONTEXT; // else the inner run would report to the outer one
  const run = spawnSync(process.execPath, ['--test', '--test-reporter=tap', ...suites], {
    encoding: 'utf8',
    env: environment,
  });
  const failed = new Map(
    run.stdout
      .split(/^(?=not ok|ok|# Subtest)/m)
      .filter((part) => part.startsWith('not ok'))
      .map((part) => [part.match(/^not ok \d+ - (.*)$/m)[1], part]),
  );
  const missed = offences.filter(([path, , name, word]) => !failed.get(name)?.includes(word ?? path));
  assert.deepEqual(missed.map(([path, , name]) => `${path}: ${name}`), []);
});

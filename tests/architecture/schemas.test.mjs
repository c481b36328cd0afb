// What ships fits the schemas in docs/schema, and what does not fit them is found.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { exists, files, read } from './lib.mjs';
import { faults } from './json_schema.mjs';

const shipped = {
  robot: /^runtime\/model\/robots\/.*\.json$/,
  world: /^runtime\/world\/rooms\/.*\.json$/,
  pack: /^blocks\/[^/]+\/pack\.json$/,
  program: /^blocks\/[^/]+\/examples\/.*\.json$/,
};

for (const [name, pattern] of Object.entries(shipped)) {
  test(`every shipped ${name} fits its schema, and a broken one does not`, () => {
    const path = `docs/schema/${name}.schema.json`;
    assert.ok(exists(path), `${path} is missing`);
    const schema = JSON.parse(read(path));
    const found = files.filter((file) => pattern.test(file));
    assert.ok(found.length > 0);
    const wrong = found.flatMap((file) => faults(JSON.parse(read(file)), schema).map((fault) => `${file}${fault}`));
    assert.deepEqual(wrong, []);
    const broken = { ...JSON.parse(read(found[0])), format: 'something else' };
    for (const field of schema.required) assert.ok(faults({ ...broken, [field]: undefined }, schema).length > 0);
    assert.ok(faults(broken, schema).length > 0);
    assert.ok(faults([], schema).length > 0);
  });
}

test('each keyword is understood', () => {
  const cases = [
    [{ type: ['integer', 'null'] }, [1, null], [1.5, 'a']],
    [{ enum: [1, 'a'] }, ['a'], [2]],
    [{ minimum: 1, exclusiveMaximum: 3 }, [1, 2.9], [0.9, 3]],
    [{ minItems: 1, maxItems: 2, items: { type: 'string' } }, [['a']], [[], ['a', 'b', 'c'], [1]]],
    [{ required: ['a'], properties: { a: { const: 1 } }, additionalProperties: false }, [{ a: 1 }], [{}, { a: 2 }, { a: 1, b: 1 }]],
    [{ additionalProperties: { type: 'number' } }, [{ a: 1 }], [{ a: 'b' }]],
    [{ pattern: '^a+$', minLength: 2 }, ['aa', 7], ['a', 'ab']],
    [{ oneOf: [{ type: 'number' }, { minimum: 5 }] }, [3], [7]],
    [{ anyOf: [{ const: 1 }, { const: 2 }] }, [2], [3]],
    [{ $defs: { n: { type: 'number' } }, items: { $ref: '#/$defs/n' } }, [[1]], [['a']]],
  ];
  for (const [schema, fitting, wrong] of cases) {
    for (const value of fitting) assert.deepEqual(faults(value, schema), [], JSON.stringify([schema, value]));
    for (const value of wrong) assert.notDeepEqual(faults(value, schema), [], JSON.stringify([schema, value]));
  }
  assert.throws(() => faults(1, { multipleOf: 2 }), /multipleOf/);
});

// The part of JSON Schema 2020-12 that docs/schema uses. A keyword that is not here is an error, so nothing is skipped.

const typeOf = (value) => {
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'array';
  return typeof value;
};
const isType = (value, type) => (type === 'integer' ? Number.isInteger(value) : typeOf(value) === type);
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
const asList = (value) => (Array.isArray(value) ? value : [value]);
const onlyFor = (type, check) => (value, ...rest) => (typeOf(value) === type ? check(value, ...rest) : []);
const failsIf = (wrong, place, words) => (wrong ? [`${place}: ${words}`] : []);

function additional(value, rule, place, schema, root) {
  const known = new Set(Object.keys(schema.properties ?? {}));
  const others = Object.keys(value).filter((name) => !known.has(name));
  if (rule === false) return others.map((name) => `${place}/${name}: not known here`);
  return others.flatMap((name) => faults(value[name], rule, `${place}/${name}`, root));
}

function matching(value, schemas, place, root) {
  return schemas.filter((schema) => faults(value, schema, place, root).length === 0).length;
}

const atMost = (value, limit, place) => failsIf(value > limit, place, `more than ${limit}`);
const atLeast = (value, limit, place) => failsIf(value < limit, place, `less than ${limit}`);

/** One function a keyword: (value, the keyword's value, place, the whole schema, root schema) -> list of faults. */
const keywords = {
  type: (value, types, place) => failsIf(!asList(types).some((type) => isType(value, type)), place, `not ${types}`),
  enum: (value, choices, place) => failsIf(!choices.some((choice) => same(choice, value)), place, 'none of the choices'),
  const: (value, wanted, place) => failsIf(!same(value, wanted), place, `not ${JSON.stringify(wanted)}`),
  minimum: onlyFor('number', atLeast),
  maximum: onlyFor('number', atMost),
  exclusiveMinimum: onlyFor('number', (value, limit, place) => failsIf(value <= limit, place, `not above ${limit}`)),
  exclusiveMaximum: onlyFor('number', (value, limit, place) => failsIf(value >= limit, place, `not below ${limit}`)),
  minItems: onlyFor('array', (value, limit, place) => atLeast(value.length, limit, place)),
  maxItems: onlyFor('array', (value, limit, place) => atMost(value.length, limit, place)),
  minLength: onlyFor('string', (value, limit, place) => atLeast(value.length, limit, place)),
  maxLength: onlyFor('string', (value, limit, place) => atMost(value.length, limit, place)),
  pattern: onlyFor('string', (value, text, place) => failsIf(!new RegExp(text, 'u').test(value), place, `not like ${text}`)),
  required: onlyFor('object', (value, names, place) =>
    names.filter((name) => !(name in value)).map((name) => `${place}/${name}: missing`),
  ),
  properties: onlyFor('object', (value, schemas, place, _, root) =>
    Object.keys(schemas)
      .filter((name) => name in value)
      .flatMap((name) => faults(value[name], schemas[name], `${place}/${name}`, root)),
  ),
  additionalProperties: onlyFor('object', additional),
  items: onlyFor('array', (value, schema, place, _, root) =>
    value.flatMap((item, i) => faults(item, schema, `${place}/${i}`, root)),
  ),
  anyOf: (value, schemas, place, _, root) => failsIf(matching(value, schemas, place, root) === 0, place, 'fits none'),
  oneOf: (value, schemas, place, _, root) => failsIf(matching(value, schemas, place, root) !== 1, place, 'fits not one'),
  allOf: (value, schemas, place, _, root) => schemas.flatMap((schema) => faults(value, schema, place, root)),
  $ref: (value, reference, place, _, root) => {
    const steps = reference.replace(/^#\/?/, '').split('/').filter(Boolean);
    return faults(value, steps.reduce((schema, step) => schema[step], root), place, root);
  },
};
const remarks = new Set(['$schema', '$id', '$defs', '$comment', 'title', 'description', 'default', 'examples', 'deprecated']);

/** Every place where the value does not fit the schema, in words. */
export function faults(value, schema, place = '', root = schema) {
  if (typeof schema === 'boolean') return failsIf(!schema, place, 'nothing may stand here');
  return Object.entries(schema).flatMap(([keyword, wanted]) => {
    if (remarks.has(keyword)) return [];
    if (!(keyword in keywords)) throw new Error(`json_schema.mjs does not know the keyword ${keyword}`);
    return keywords[keyword](value, wanted, place, schema, root);
  });
}

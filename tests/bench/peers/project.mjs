// Writes Scratch projects from short words. A command is [opcode, inputs, fields, mouths, mutation]; an
// expression a number, a text, or [opcode, inputs, fields].

const literal = (value) => [1, [typeof value === 'number' ? 4 : 10, String(value)]];
const truths = new Set(['CONDITION', 'OPERAND']);

export class Project {
  constructor(variables, lists = []) {
    this.blocks = {};
    this.count = 0;
    this.variables = Object.fromEntries(variables.map((name) => [`v_${name}`, [name, 0]]));
    this.lists = Object.fromEntries(lists.map((name) => [`l_${name}`, [name, []]]));
  }

  add(opcode, parent, fields = {}, extra = {}) {
    const id = `b${++this.count}`;
    this.blocks[id] = { opcode, next: null, parent, inputs: {}, fields, shadow: false, topLevel: false, ...extra };
    return id;
  }

  expression(parent, [opcode, inputs = {}, fields = {}]) {
    const id = this.add(opcode, parent, fields);
    this.inputs(id, inputs);
    return id;
  }

  inputs(id, inputs) {
    for (const [name, value] of Object.entries(inputs)) {
      if (!Array.isArray(value)) this.blocks[id].inputs[name] = literal(value);
      else if (value[0] === 'variable') this.blocks[id].inputs[name] = [3, [12, value[1], `v_${value[1]}`], [10, '']];
      else if (truths.has(name)) this.blocks[id].inputs[name] = [2, this.expression(id, value)];
      else this.blocks[id].inputs[name] = [3, this.expression(id, value), [10, '']];
    }
  }

  /** A chain of commands below `parent`; its first block's id. */
  stack(parent, commands) {
    let first = null;
    let above = parent;
    for (const [opcode, inputs = {}, fields = {}, mouths = {}, mutation] of commands) {
      const id = this.add(opcode, above, fields, mutation ? { mutation } : {});
      this.inputs(id, inputs);
      for (const [name, inner] of Object.entries(mouths)) this.blocks[id].inputs[name] = [2, this.stack(id, inner)];
      if (first === null) first = id;
      else this.blocks[above].next = id;
      above = id;
    }
    return first;
  }

  script(commands) {
    const hat = this.add('event_whenflagclicked', null, {}, { topLevel: true, x: 0, y: 0 });
    this.blocks[hat].next = this.stack(hat, commands);
  }

  /** A my block that runs without screen refresh. `name` is its proccode, "fib %s". */
  define(name, parameters, commands) {
    const ids = parameters.map((_, i) => `${name}_${i}`);
    const hat = this.add('procedures_definition', null, {}, { topLevel: true, x: 0, y: 0 });
    const mutation = { tagName: 'mutation', children: [], proccode: name, argumentids: JSON.stringify(ids), warp: 'true' };
    mutation.argumentnames = JSON.stringify(parameters);
    mutation.argumentdefaults = JSON.stringify(parameters.map(() => ''));
    const prototype = this.add('procedures_prototype', hat, {}, { shadow: true, mutation });
    parameters.forEach((parameter, i) => {
      const shown = this.expression(prototype, argument(parameter));
      this.blocks[shown].shadow = true;
      this.blocks[prototype].inputs[ids[i]] = [1, shown];
    });
    this.blocks[hat].inputs.custom_block = [1, prototype];
    this.blocks[hat].next = this.stack(hat, commands);
  }

  text() {
    const costume = { name: 'c', dataFormat: 'svg', assetId: 'cd21514d0531fdffb22204e0ec5ed84a', rotationCenterX: 0, rotationCenterY: 0 };
    costume.md5ext = `${costume.assetId}.svg`;
    const stage = { isStage: true, name: 'Stage', variables: this.variables, lists: this.lists, broadcasts: {}, blocks: this.blocks };
    Object.assign(stage, { comments: {}, currentCostume: 0, costumes: [costume], sounds: [], volume: 100, layerOrder: 0 });
    Object.assign(stage, { tempo: 60, videoTransparency: 50, videoState: 'off', textToSpeechLanguage: null });
    return JSON.stringify({ targets: [stage], monitors: [], extensions: [], meta: { semver: '3.0.0', vm: '0.2.0', agent: 'bench' } });
  }
}

const ofVariable = (name) => ({ VARIABLE: [name, `v_${name}`] });
const ofList = (name) => ({ LIST: [name, `l_${name}`] });
export const variable = (name) => ['variable', name];
export const argument = (name) => ['argument_reporter_string_number', {}, { VALUE: [name, null] }];
export const set = (name, value) => ['data_setvariableto', { VALUE: value }, ofVariable(name)];
export const change = (name, value) => ['data_changevariableby', { VALUE: value }, ofVariable(name)];
export const calculate = (word, a, b) => [`operator_${word}`, { NUM1: a, NUM2: b }];
export const compare = (word, a, b) => [`operator_${word}`, { OPERAND1: a, OPERAND2: b }];
export const repeat = (times, body) => ['control_repeat', { TIMES: times }, {}, { SUBSTACK: body }];
export const repeatUntil = (condition, body) => ['control_repeat_until', { CONDITION: condition }, {}, { SUBSTACK: body }];
export const forever = (body) => ['control_forever', {}, {}, { SUBSTACK: body }];
export const when = (condition, body) => ['control_if', { CONDITION: condition }, {}, { SUBSTACK: body }];
export const choose = (condition, yes, no) => ['control_if_else', { CONDITION: condition }, {}, { SUBSTACK: yes, SUBSTACK2: no }];
export const addTo = (list, item) => ['data_addtolist', { ITEM: item }, ofList(list)];
export const clear = (list) => ['data_deletealloflist', {}, ofList(list)];
export const itemOf = (list, index) => ['data_itemoflist', { INDEX: index }, ofList(list)];
export const replaceIn = (list, index, item) => ['data_replaceitemoflist', { INDEX: index, ITEM: item }, ofList(list)];
export const call = (name, ...values) => {
  const ids = values.map((_, i) => `${name}_${i}`);
  const mutation = { tagName: 'mutation', children: [], proccode: name, argumentids: JSON.stringify(ids), warp: 'true' };
  return ['procedures_call', Object.fromEntries(values.map((value, i) => [ids[i], value])), {}, {}, mutation];
};

// The seven programs. blocks(n): block executions = commands + reporters + one check a loop turn, counted from
// the source (literals are not counted). sizes: how much each engine does in one measurement.
import * as p from './project.mjs';

const v = p.variable;
const step = [p.change('i', 1), p.set('x', p.calculate('add', p.calculate('multiply', v('x'), 1.0001), p.calculate('mod', v('i'), 7)))];
const work = (body, lists = [], variables = ['i', 'x']) => {
  const project = new p.Project([...variables, 'fin'], lists);
  project.define('work', [], body);
  project.script([p.set('fin', 0), p.call('work'), p.set('fin', 1)]);
  return project;
};

/** Every `turns` of a list program goes through this many items. */
const kItems = 20_000;

const compute = {
  title: 'compute, plain loop',
  sizes: { scratch: 600e3, turbowarp: 6e6, mirada: 100e6 },
  build: (n) => {
    const project = new p.Project(['i', 'x', 'fin']);
    project.script([p.set('i', 0), p.set('x', 0), p.repeat(n, step), p.set('fin', 1)]);
    return project;
  },
  blocks: (n) => 8 * n,
};

const computeWarp = {
  title: 'compute, all at once',
  sizes: { scratch: 600e3, turbowarp: 40e6, mirada: 120e6 },
  build: (n) => work([p.set('i', 0), p.set('x', 0), p.repeat(n, step)]),
  blocks: (n) => 8 * n,
};

const lists = {
  title: 'lists',
  sizes: { scratch: 5, turbowarp: 400, mirada: 2500 },
  build: (n) => work([p.repeat(n, [
    p.clear('L'), p.set('i', 0), p.repeat(kItems, [p.change('i', 1), p.addTo('L', v('i'))]), p.set('i', 0), p.set('x', 0),
    p.repeat(kItems, [p.change('i', 1), p.change('x', p.itemOf('L', v('i'))),
      p.replaceIn('L', v('i'), p.calculate('add', p.itemOf('L', v('i')), 1))]),
  ])], ['L']),
  blocks: (n) => n * (14 * kItems + 7),
};

const fib = {
  title: 'recursive fib',
  sizes: { scratch: 23, turbowarp: 36, mirada: 37 },
  build: (n) => {
    const project = new p.Project(['r', 'fin']);
    const smaller = (by) => p.call('fib %s', p.calculate('subtract', p.argument('n'), by));
    project.define('fib %s', ['n'], [p.choose(p.compare('lt', p.argument('n'), 2), [p.change('r', p.argument('n'))], [smaller(1), smaller(2)])]);
    project.script([p.set('fin', 0), p.set('r', 0), p.call('fib %s', n), p.set('fin', 1)]);
    return project;
  },
  blocks: (n) => {
    let [leaves, next] = [1, 1];
    for (let i = 1; i < n; ++i) [leaves, next] = [next, leaves + next];
    leaves = next; // calls that go no deeper: fib(n + 1)
    return leaves * 6 + (leaves - 1) * 8;
  },
};

const sieve = {
  title: 'sieve',
  sizes: { scratch: 3, turbowarp: 500, mirada: 1500 },
  build: (n) => work([p.repeat(n, [
    p.clear('S'), p.repeat(kItems, [p.addTo('S', 1)]), p.set('i', 2), p.set('c', 0),
    p.repeatUntil(p.compare('gt', v('i'), kItems), [
      p.when(p.compare('equals', p.itemOf('S', v('i')), 1), [
        p.change('c', 1), p.set('j', p.calculate('multiply', v('i'), v('i'))),
        p.repeatUntil(p.compare('gt', v('j'), kItems), [p.replaceIn('S', v('j'), 0), p.change('j', v('i'))]),
      ]),
      p.change('i', 1),
    ]),
  ])], ['S'], ['i', 'j', 'c']),
  blocks: (n) => {
    const free = new Uint8Array(kItems + 1).fill(1);
    let [struck, primes] = [0, 0];
    for (let i = 2; i <= kItems; ++i) {
      if (!free[i]) continue;
      ++primes;
      for (let j = i * i; j <= kItems; j += i, ++struck) free[j] = 0;
    }
    return n * (8 + 2 * kItems + (kItems - 1) * 8 + primes * (5 + 3) + struck * 7);
  },
};

const scripts = (count) => (n) => {
  const project = new p.Project(['v']);
  for (let i = 0; i < count; ++i) project.script([p.forever([p.change('v', 1)])]);
  return project;
};

/** Size: block executions; they never end by themselves. */
const thousand = {
  title: '1,000 scripts',
  endless: true,
  sizes: { scratch: 5e6, turbowarp: 5e6, mirada: 100e6 },
  build: scripts(1000),
  blocks: (n) => n,
};
const ten = {
  title: '10 scripts',
  endless: true,
  sizes: { scratch: 5e6, turbowarp: 30e6, mirada: 200e6 },
  build: scripts(10),
  blocks: (n) => n,
};

export const programs = { compute, compute_warp: computeWarp, list: lists, fib, sieve, threads: thousand, threads10: ten };

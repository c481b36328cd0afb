// A robot that lives in the test: for what a real one cannot be asked to do (vanish, answer late, refuse, be another's).
import { readFileSync, readdirSync, existsSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './browser.mjs';

export const origin = 'http://robot.test';
const types = {
  html: 'text/html',
  js: 'text/javascript',
  css: 'text/css',
  svg: 'image/svg+xml',
  woff2: 'font/woff2',
};
const csp =
  "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; " +
  "media-src 'self'; connect-src 'self' ws://robot.test; font-src 'self'";

function packs() {
  const folders = readdirSync(join(root, 'blocks')).filter((f) =>
    existsSync(join(root, 'blocks', f, 'pack.json')),
  );
  return folders
    .map((folder) => JSON.parse(readFileSync(join(root, 'blocks', folder, 'pack.json'), 'utf8')))
    .sort((a, b) => (a.order ?? 0) - (b.order ?? 0) || a.id.localeCompare(b.id));
}

const number = (id, value) => ({ shadow: { type: 'math_number', id, fields: { NUM: value } } });
const whenClear = { type: 'vision_way_clear', id: 'clear', inputs: { DISTANCE: number('n1', 40) } };
const speeds = {
  type: 'motion_set_speeds',
  id: 'speeds',
  inputs: { LEFT: number('n2', 60), RIGHT: number('n3', 60) },
};
const turn = {
  type: 'motion_turn',
  id: 'turn',
  fields: { SIDE: 'left' },
  inputs: { ANGLE: number('n4', 30) },
};
const choice = {
  type: 'control_if_else',
  id: 'choice',
  inputs: { CONDITION: { block: whenClear }, SUBSTACK: { block: speeds }, SUBSTACK2: { block: turn } },
};
const loop = { type: 'control_forever', id: 'loop', inputs: { SUBSTACK: { block: choice } } };
const hat = { type: 'event_whenflagclicked', id: 'hat', x: 40, y: 40, next: { block: loop } };

function examples() {
  const workspace = { blocks: { languageVersion: 0, blocks: [hat] } };
  const program = { format: 'mirada-program', version: 1, name: 'Avoid the obstacles', packs: [], workspace };
  const name = { en: 'Avoid the obstacles', es: 'Esquiva los obstáculos' };
  return [{ id: 'avoid', pack: 'vision', name, program }];
}

const circle = (n, r, x, y) =>
  Array.from({ length: n + 1 }, (_, i) => [
    x + r * Math.cos((2 * Math.PI * i) / n),
    y + r * Math.sin((2 * Math.PI * i) / n),
  ]);

function sceneAt(t) {
  const angle = t * 0.5;
  return {
    bounds: { min_x_m: -2.2, min_y_m: -1.6, max_x_m: 2.2, max_y_m: 1.6 },
    floor_colour: '#3f8f55',
    lines: [
      {
        points: [
          [-2, -1.4],
          [2, -1.4],
          [2, 1.4],
          [-2, 1.4],
          [-2, -1.4],
        ],
        width_m: 0.05,
        colour: '#ffffff',
      },
      {
        points: [
          [0, -1.4],
          [0, 1.4],
        ],
        width_m: 0.05,
        colour: '#ffffff',
      },
      { points: circle(40, 0.45, 0, 0), width_m: 0.05, colour: '#ffffff' },
    ],
    walls: [
      {
        points: [
          [-2.2, -1.6],
          [2.2, -1.6],
          [2.2, 1.6],
          [-2.2, 1.6],
          [-2.2, -1.6],
        ],
        colour: '#d8d2c4',
      },
    ],
    boxes: [{ x_m: -1.3, y_m: 0.8, heading_deg: 20, length_m: 0.4, width_m: 0.3, colour: '#c2703d' }],
    cylinders: [{ x_m: 1.4, y_m: -0.8, radius_m: 0.13, colour: '#3d6bc2' }],
    people: [{ x_m: 1.5, y_m: 0.9, heading_deg: 200, radius_m: 0.22 }],
    robot: {
      x_m: 0.9 * Math.cos(angle),
      y_m: 0.9 * Math.sin(angle),
      heading_deg: (angle * 180) / Math.PI + 90,
      footprint: [
        [0.1, 0.07],
        [0.1, -0.07],
        [-0.08, -0.09],
        [-0.08, 0.09],
      ],
      pan_deg: 20 * Math.sin(t),
      hfov_deg: 62,
      contact: false,
    },
    contacts: 0,
    path_m: 0.45 * t,
  };
}

function sonarAt(t) {
  const readings = [];
  const boundary = [];
  for (let i = 0; i < 64; i++) {
    const bearing = 31 - i;
    const near = 0.5 + 0.3 * Math.sin(i / 9 + t);
    const answer = i > 44 ? 'clear' : 'blocked';
    readings.push([bearing + 20 * Math.sin(t), answer, answer === 'clear' ? 1.2 : near, 0.03]);
    boundary.push([i * 5, answer === 'clear' ? 60 : 130 - 40 * Math.sin(i / 9 + t), answer]);
  }
  return { frame: 1, t_us: t * 1e6, pan_deg: 20 * Math.sin(t), trusted: true, readings, boundary };
}

export class FakeRobot {
  constructor(page) {
    this.page = page;
    this.sockets = new Set();
    this.received = [];
    this.reachable = true;
    this.state = 'idle';
    this.run = 0;
    this.t = 0;
    this.refuse = null;
    this.owner = null;
    this.stopAnswers = true;
    this.endsAtOnce = '';
    this.extra = {};
    this.setup = { world: 'field', robot: 'classic', seed: 1, simulated: true };
  }

  static async serve(page, { picture } = {}) {
    const robot = new FakeRobot(page);
    robot.picture = picture;
    await page.route(`${origin}/**`, (route) => robot.answer(route));
    await page.routeWebSocket(`${origin.replace('http', 'ws')}/ws`, (socket) => robot.join(socket));
    robot.timer = setInterval(() => robot.tick(), 100);
    return robot;
  }

  dispose() {
    clearInterval(this.timer);
  }

  async answer(route) {
    const path = new URL(route.request().url()).pathname;
    if (!this.reachable) return route.abort('connectionrefused');
    const json = (body) => route.fulfill({ contentType: 'application/json', body: JSON.stringify(body) });
    if (path === '/api/packs') return json({ packs: packs() });
    if (path === '/api/examples') return json({ examples: examples() });
    if (path === '/api/setup') return json({ setup: this.setup, ...this.choices(), lang: 'en' });
    if (path === '/api/stop') {
      if (!this.stopAnswers) return;
      this.halt('stop_button');
      return route.fulfill({ status: 204 });
    }
    const file = join(root, 'ui/dist', path === '/' ? 'index.html' : path);
    if (!existsSync(file)) return route.fulfill({ status: 404 });
    const contentType = types[file.split('.').pop()] ?? 'application/octet-stream';
    return route.fulfill({
      body: readFileSync(file),
      contentType,
      headers: { 'Content-Security-Policy': csp },
    });
  }

  seat() {
    const { owner } = this;
    return {
      you: 'viewer-1',
      you_drive: owner === 'viewer-1',
      may_drive: true,
      owner,
      taken: owner !== null,
      viewers: 1,
    };
  }

  choices() {
    return {
      worlds: [
        { id: 'field', name: { en: 'Green field', es: 'Campo verde' } },
        { id: 'living', name: { en: 'Living room', es: 'Salón' } },
      ],
      robots: [{ id: 'classic', name: { en: 'Classic', es: 'Clásico' } }],
    };
  }

  join(socket) {
    if (!this.reachable) return socket.close();
    this.sockets.add(socket);
    socket.onClose(() => this.sockets.delete(socket));
    socket.onMessage((text) => this.hear(socket, JSON.parse(text)));
  }

  send(message) {
    for (const socket of this.sockets) socket.send(JSON.stringify(message));
  }

  hear(socket, message) {
    this.received.push(message);
    if (message.type === 'hello') {
      this.you = message.client;
      const welcome = { type: 'welcome', version: 1, ...this.seat() };
      socket.send(
        JSON.stringify({ ...welcome, setup: this.setup, ...this.choices(), robot_clock_us: this.t * 1e6 }),
      );
    }
    if (message.type === 'run') this.start(message);
    if (message.type === 'stop' && this.stopAnswers) this.halt('stop_button');
    if (message.type === 'pause') this.state = message.on ? 'paused' : 'running';
    if (message.type === 'evaluate') this.send({ type: 'value', request: message.request, value: 42.5 });
    if (message.type === 'choose') {
      this.setup = { ...this.setup, world: message.world, robot: message.robot, seed: message.seed };
      this.send({ type: 'setup', setup: this.setup });
    }
  }

  start(message) {
    if (this.refuse) return this.send({ type: 'refused', to: 'run', faults: this.refuse });
    this.program = message.program;
    this.run += 1;
    this.state = 'running';
    this.owner = 'viewer-1';
    this.send({ type: 'owner', ...this.seat() });
    if (this.endsAtOnce) this.halt(this.endsAtOnce);
    this.send({ type: 'started', run: this.run, warnings: [] });
  }

  halt(reason) {
    if (this.state === 'idle') return;
    this.state = 'idle';
    this.reason = reason;
    this.sendTelemetry();
  }

  tick() {
    if (this.state === 'running') this.t += 0.1;
    this.sendTelemetry();
    if (!this.picture) return;
    const header = Buffer.from(
      JSON.stringify({ frame: Math.round(this.t * 20), t_us: this.t * 1e6, width: 320, height: 240 }),
    );
    const length = Buffer.alloc(4);
    length.writeUInt32LE(header.length);
    for (const socket of this.sockets) socket.send(Buffer.concat([length, header, this.picture]));
  }

  sendTelemetry() {
    const moving = this.state === 'running';
    this.send({
      type: 'telemetry',
      t_us: this.t * 1e6,
      run: this.run,
      state: this.state,
      stop_reason: moving ? 'none' : (this.reason ?? 'none'),
      blocks: moving ? ['loop', 'clear'] : [],
      variables: {},
      lists: {},
      list_lengths: {},
      say: '',
      say_log: [],
      faults: [],
      odometry: { x_m: 0, y_m: 0, heading_deg: 0 },
      neck: { pan_deg: 0, tilt_deg: 0 },
      wheels: moving ? { left_mps: 0.2, right_mps: 0.2 } : { left_mps: 0, right_mps: 0 },
      camera_trouble: '',
      sonar: sonarAt(this.t),
      faces: null,
      scene: sceneAt(this.t),
      ...this.extra,
    });
  }

  /** The network goes away: sockets close, requests fail. */
  async vanish() {
    this.reachable = false;
    for (const socket of this.sockets) await socket.close();
    this.sockets.clear();
  }
}

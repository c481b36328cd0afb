// The real `mirada serve`, with a simulated robot, on a port of its own.
import { spawn } from 'node:child_process';
import { createServer } from 'node:net';
import { root } from './browser.mjs';

function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

async function answers(url) {
  try {
    return (await fetch(`${url}/api/setup`)).ok;
  } catch {
    return false;
  }
}

export class RealRobot {
  static async start(...options) {
    const robot = new RealRobot();
    robot.port = await freePort();
    robot.url = `http://127.0.0.1:${robot.port}`;
    await robot.launch(options);
    return robot;
  }

  async launch(options = []) {
    const program = process.env.MIRADA_BIN ?? `${root}build/release/bin/mirada`;
    this.words = '';
    this.process = spawn(program, [
      'serve',
      '--port',
      String(this.port),
      '--ui',
      `${root}ui/dist`,
      ...options,
    ]);
    this.process.stdout.on('data', (text) => (this.words += text));
    this.process.stderr.on('data', (text) => (this.words += text));
    this.ended = new Promise((resolve) => this.process.on('exit', resolve));
    for (let tries = 0; tries < 300; tries++) {
      if (await answers(this.url)) return;
      if (this.process.exitCode !== null) break;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    throw new Error(`mirada serve did not come up:\n${this.words}`);
  }

  async stop() {
    this.process.kill('SIGTERM');
    await this.ended;
  }
}

/** Notes what the robot tells this page: the newest telemetry, and which pictures came. */
export function listen(page) {
  const heard = { telemetry: null, frames: new Set(), messages: [] };
  page.on('websocket', (socket) => {
    socket.on('framereceived', ({ payload }) => {
      if (typeof payload === 'string') {
        const message = JSON.parse(payload);
        if (message.type === 'telemetry') heard.telemetry = message;
        else heard.messages.push(message);
        return;
      }
      const length = payload.readUInt32LE(0);
      heard.frames.add(JSON.parse(payload.subarray(4, 4 + length).toString()).frame);
    });
  });
  return heard;
}

/** Waits until `holds` gives something true; says what was waited for when it never does. */
export async function until(what, holds, seconds = 20) {
  const end = Date.now() + seconds * 1000;
  for (;;) {
    const value = await holds();
    if (value) return value;
    if (Date.now() > end) throw new Error(`waited ${seconds} s in vain for: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

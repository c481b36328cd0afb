/** What the page knows of the robot, as signals, and what it may ask of it. */
import { batch, computed, signal } from '@preact/signals';
import { type MessageKey, say, t } from '../messages';
import { newUuid } from '../model/ids';
import { writeJson } from '../model/json';
import type { Program } from '../model/program';
import type { Words } from '../model/words';
import { Connection, type Link } from '../wire/connection';
import { calibration, cameras, leaving } from './calibration';
import { facesRefused, knownFaces } from './known_faces';
import type {
  Choice,
  Fault,
  FromRobot,
  PictureHeader,
  Seat,
  Setup,
  SetupAnswer,
  Telemetry,
  ToRobot,
  Value,
  Watch,
} from '../wire/protocol';

export const link = signal<Link>('connecting');
const nobody: Seat = { you: '', you_drive: false, may_drive: true, owner: null, taken: false, viewers: 0 };
export const seat = signal<Seat>(nobody);
export const setup = signal<Setup | null>(null);
export const worlds = signal<Choice[]>([]);
export const robots = signal<Choice[]>([]);
export const telemetry = signal<Telemetry | null>(null);
/** When the newest telemetry arrived (performance.now). */
export const telemetryAt = signal(0);
export const picture = signal<{ header: PictureHeader; bitmap: ImageBitmap } | null>(null);
export const stopping = signal(false);
export const starting = signal(false);
/** Counts how often the robot asked for the join code. */
export const codeWanted = signal(0);
/** Faults of the newest try to start: errors when it was refused, warnings when it runs. */
export const startFaults = signal<Fault[]>([]);

export interface Note {
  at: number;
  severity: 'info' | 'warning' | 'error';
  words: () => string;
}
/** The newest words for the status line and the log. */
export const notes = signal<Note[]>([]);

export const running = computed(
  () => telemetry.value?.state === 'running' || telemetry.value?.state === 'paused',
);
export const paused = computed(() => telemetry.value?.state === 'paused');
export const youDrive = computed(() => seat.value.you_drive);
/** Nobody else holds the robot. */
export const free = computed(() => !seat.value.taken || seat.value.you_drive);
/** All faults to show: those of the start, and those of the run. */
export const faults = computed(() => {
  const all = [...startFaults.value, ...(telemetry.value?.faults ?? [])];
  const key = (fault: Fault) => `${fault.place} ${fault.code} ${say(fault.message)}`;
  return [...new Map(all.map((fault) => [key(fault), fault])).values()];
});

const waiting = new Map<number, (answer: { value?: Value; fault?: Fault }) => void>();
let connection: Connection | null = null;
let requests = 0;
let watched: Watch = { camera: true, sonar: true, faces: true, room: true, memory: false };

export function note(severity: Note['severity'], words: () => string): void {
  notes.value = [...notes.value.slice(-99), { at: Date.now(), severity, words }];
}

export function noteKey(
  severity: Note['severity'],
  key: MessageKey,
  values: Record<string, string | number> = {},
): void {
  note(severity, () => t(key, values));
}

function noteWords(severity: string, words: Words): void {
  note(severity === 'error' || severity === 'warning' ? severity : 'info', () => say(words));
}

function clientId(): string {
  const kept = sessionStorage.getItem('mirada.client');
  if (kept) return kept;
  const made = newUuid();
  sessionStorage.setItem('mirada.client', made);
  return made;
}

/** A duplicated tab starts with its original's client id: whoever holds it already says so, the copy takes a new one. */
function keepClientUnique(): void {
  const channel = new BroadcastChannel('mirada');
  const tab = newUuid();
  channel.onmessage = ({ data }: MessageEvent<{ tab: string; asks?: string; held?: string }>) => {
    if (data.asks === clientId()) channel.postMessage({ tab: data.tab, held: data.asks });
    if (data.tab !== tab || data.held !== clientId()) return;
    sessionStorage.removeItem('mirada.client');
    connection?.restart();
  };
  channel.postMessage({ tab, asks: clientId() });
}

function noteStop(before: Telemetry | null, after: Telemetry): void {
  // A run may begin and end between two of the robot's messages.
  const began = before && (before.state !== 'idle' || before.run !== after.run);
  const ended = began && after.state === 'idle';
  if (!ended || after.stop_reason === 'none') return;
  const words: Record<string, MessageKey> = {
    stop_button: 'why_stop_button',
    program_ended: 'why_program_ended',
    owner_lost: 'why_owner_lost',
    camera_lost: 'why_camera_lost',
    stuck: 'why_stuck',
    put_back: 'why_put_back',
    replaced: 'why_replaced',
    faulted: 'why_faulted',
  };
  const key = words[after.stop_reason];
  const calm = ['stop_button', 'put_back', 'replaced'].includes(after.stop_reason);
  if (key) noteKey(calm ? 'info' : 'warning', key);
}

function isOver(run: number): boolean {
  const now = telemetry.peek();
  return now !== null && now.run >= run && now.state === 'idle';
}

function receive(message: FromRobot): void {
  switch (message.type) {
    case 'welcome':
      seat.value = message;
      setup.value = message.setup;
      worlds.value = message.worlds;
      robots.value = message.robots;
      connection?.send({ type: 'watch', ...watched });
      break;
    case 'owner':
      seat.value = message;
      break;
    case 'telemetry':
      noteStop(telemetry.peek(), message);
      telemetry.value = message;
      telemetryAt.value = performance.now();
      if (message.state === 'idle') stopping.value = false;
      break;
    case 'notice':
      if (message.code === 'code_wrong') sessionStorage.removeItem('mirada.code');
      noteWords(message.severity, message.message);
      break;
    case 'started':
      starting.value = false;
      startFaults.value = message.warnings;
      if (!isOver(message.run)) noteKey('info', 'started');
      break;
    case 'refused':
      refused(message.to, message.faults);
      break;
    case 'stopped':
      stopping.value = false;
      break;
    case 'setup':
      setup.value = message.setup;
      break;
    case 'calibration':
      calibration.value = message;
      if (message.phase === 'off') leaving.value = false;
      break;
    case 'known_faces':
      knownFaces.value = message;
      break;
    case 'value':
      waiting.get(message.request)?.(message);
      waiting.delete(message.request);
      break;
  }
}

function refused(to: string, list: Fault[]): void {
  if (list.some((fault) => fault.code === 'code_needed')) {
    starting.value = false;
    codeWanted.value += 1;
    return;
  }
  if (to === 'faces') {
    facesRefused.value = list[0]?.message ?? null; // its dialog says it
    return;
  }
  if (to !== 'run') {
    for (const fault of list) noteWords(fault.severity, fault.message);
    return;
  }
  starting.value = false;
  startFaults.value = list;
  const errors = list.filter((fault) => fault.severity === 'error');
  const n = new Set(errors.map((fault) => fault.place)).size;
  const onBlocks = errors.length > 0 && errors.every((fault) => fault.place !== '');
  if (onBlocks) noteKey('error', n === 1 ? 'refused_one' : 'refused_many', { n });
  else for (const fault of list) noteWords(fault.severity, fault.message);
}

let decoding = false;
function showPicture(header: PictureHeader, jpeg: Uint8Array<ArrayBuffer>): void {
  if (decoding || document.hidden) return;
  decoding = true;
  createImageBitmap(new Blob([jpeg], { type: 'image/jpeg' }))
    .then((bitmap) => {
      picture.peek()?.bitmap.close();
      picture.value = { header, bitmap };
    })
    .catch(() => undefined)
    .finally(() => {
      decoding = false;
    });
}

function linkChanged(now: Link): void {
  const before = link.peek();
  batch(() => {
    link.value = now;
    if (now === 'lost') {
      starting.value = false;
      seat.value = nobody;
      telemetry.value = null;
      calibration.value = null;
      leaving.value = false;
    }
    if (now === 'up' && before === 'lost') noteKey('info', 'link_again');
  });
}

function hello(): ToRobot {
  const code = sessionStorage.getItem('mirada.code');
  return { type: 'hello', version: 1, client: clientId(), ...(code ? { code } : {}) };
}

/** Shows the robot the join code; it answers with a new welcome, or says that the code is wrong. */
export function giveCode(code: string): void {
  sessionStorage.setItem('mirada.code', code);
  connection?.send(hello());
}

export function connect(answer: SetupAnswer): void {
  setup.value = answer.setup;
  worlds.value = answer.worlds;
  robots.value = answer.robots;
  cameras.value = answer.cameras ?? [];
  keepClientUnique();
  connection = new Connection({
    link: linkChanged,
    message: (message) => batch(() => receive(message)),
    picture: showPicture,
    hello,
  });
}

/** Takes the robot and starts the program. Any depth of program: it is not written by JSON.stringify. */
export function run(program: Program): void {
  startFaults.value = [];
  starting.value = true;
  if (!connection?.sendText(writeJson({ type: 'run', program }))) {
    starting.value = false;
    noteKey('warning', 'not_connected');
  }
}

/** Stops by both ways that there are, and goes on until the robot has confirmed it. */
export function stop(): void {
  stopping.value = true;
  starting.value = false;
  connection?.send({ type: 'stop' });
  void postStop(0);
}

async function postStop(tries: number): Promise<void> {
  try {
    const answer = await fetch('/api/stop', { method: 'POST', signal: AbortSignal.timeout(2000) });
    if (answer.ok) {
      stopping.value = false;
      return;
    }
  } catch {
    // Said by the banner; the robot's own watchdog stops it meanwhile.
  }
  if (stopping.peek() && tries < 20) window.setTimeout(() => void postStop(tries + 1), 500);
  else stopping.value = false;
}

/** False when there is no robot to hear it, which is said. */
export function send(message: ToRobot): boolean {
  const sent = connection?.send(message) ?? false;
  if (!sent) noteKey('warning', 'not_connected');
  if (!sent && message.type === 'faces') facesRefused.value = bothWays('not_connected');
  return sent;
}

export function pause(on: boolean): void {
  send({ type: 'pause', on });
}

export function sendKey(key: string, down: boolean): void {
  connection?.send({ type: 'key', key, down });
}

export function choose(next: Pick<Setup, 'world' | 'robot' | 'seed'>): boolean {
  return send({ type: 'choose', world: next.world, robot: next.robot, seed: next.seed });
}

export function putBack(): void {
  const idle = telemetry.peek()?.state === 'idle';
  // A program that is ended by it says so itself.
  if (send({ type: 'put_back' }) && idle) noteKey('info', 'why_put_back');
}

export function release(): void {
  send({ type: 'release' });
}

/** Tells the robot which panels are open: it does no work for closed ones. */
export function watch(panels: Watch): void {
  watched = panels;
  connection?.send({ type: 'watch', ...panels });
}

/** The value of one reporter of this program, from the robot. */
export function evaluate(program: Program, block: string): Promise<{ value?: Value; fault?: Fault }> {
  requests += 1;
  const request = requests;
  const message = bothWays('nothing_running_value');
  const none = { fault: { place: block, code: 'no_answer', severity: 'error', message } as Fault };
  if (!connection?.sendText(writeJson({ type: 'evaluate', request, program, block })))
    return Promise.resolve(none);
  return new Promise((resolve) => {
    waiting.set(request, resolve);
    window.setTimeout(() => {
      if (waiting.delete(request)) resolve(none);
    }, 3000);
  });
}

function bothWays(key: MessageKey): Words {
  const words = t(key);
  return { en: words, es: words };
}

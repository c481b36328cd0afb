/** The messages of docs/protocol.md. */
import type { Program } from '../model/program';
import type { Lang, Words } from '../model/words';

export interface Fault {
  place: string;
  code: string;
  severity: 'error' | 'warning';
  message: Words;
}

export interface Choice {
  id: string;
  name: Words;
}

export interface Setup {
  world: string;
  robot: string;
  seed: number;
  simulated: boolean;
}

export interface SetupAnswer {
  setup: Setup;
  worlds: Choice[];
  robots: Choice[];
  cameras?: Choice[];
  lang: Lang;
}

export interface Example {
  id: string;
  pack: string;
  name: Words;
  program: Program;
}

export type Answer = 'blocked' | 'clear' | 'not_seen' | 'above_horizon';
export type Value = number | string | boolean | null;

export interface Sonar {
  frame: number;
  t_us: number;
  pan_deg: number;
  trusted: boolean;
  readings: [bearing_deg: number, answer: Answer, distance_m: number | null, sigma_m: number | null][];
  boundary: [u: number, v: number, answer: Answer][];
}

export type FollowState = '' | 'following' | 'predicted' | 'searching' | 'gone';

export interface Face {
  id: number;
  x: number;
  y: number;
  w: number;
  h: number;
  score: number;
  bearing_deg: number;
  distance_m: number;
  sigma_m: number;
  /** Not seen in this picture: where it should be. */
  predicted: boolean;
  name: string;
  who: 'known' | 'stranger' | 'unsure';
}

/** A face is being learnt. */
export interface Lesson {
  name: string;
  looks: number;
  needed: number;
  hint: Words | null;
}

export interface Faces {
  frame: number;
  t_us: number;
  width: number;
  height: number;
  detector: string;
  faces: Face[];
  /** People followed by what they wear while their face is not seen. */
  bodies: Face[];
  follow: { state: FollowState; id: number };
  lesson: Lesson | null;
}

export type Point = [x: number, y: number];

export interface SceneRobot {
  x_m: number;
  y_m: number;
  heading_deg: number;
  footprint: Point[];
  pan_deg: number;
  hfov_deg: number;
  contact: boolean;
}

export interface Scene {
  bounds: { min_x_m: number; min_y_m: number; max_x_m: number; max_y_m: number };
  floor_colour: string;
  lines: { points: Point[]; width_m: number; colour: string }[];
  walls: { points: Point[]; colour: string }[];
  boxes: {
    x_m: number;
    y_m: number;
    heading_deg: number;
    length_m: number;
    width_m: number;
    colour: string;
  }[];
  cylinders: { x_m: number; y_m: number; radius_m: number; colour: string }[];
  people: { x_m: number; y_m: number; heading_deg: number; radius_m: number }[];
  robot: SceneRobot;
  contacts: number;
  path_m: number;
}

export interface Memory {
  robot: { x_m: number; y_m: number; heading_deg: number; pan_deg: number; hfov_deg: number };
  places: [x_m: number, y_m: number, sigma_m: number, age_s: number][];
  segments: [x1_m: number, y1_m: number, x2_m: number, y2_m: number, sigma_m: number, age_s: number][];
  things: [
    kind: 'face' | 'tag' | 'red_ball',
    id: number,
    x_m: number,
    y_m: number,
    sigma_m: number,
    age_s: number,
  ][];
  /** How far floor is known free, all round from ahead to the left. */
  free: number[];
  next: { watching: string; why: string; pan_deg: number; moving: boolean };
}

export interface Telemetry {
  t_us: number;
  run: number;
  state: 'idle' | 'running' | 'paused';
  stop_reason: string;
  blocks: string[];
  variables: Record<string, Value>;
  lists: Record<string, Value[]>;
  list_lengths: Record<string, number>;
  say: string;
  say_log: { t_s: number; text: string }[];
  faults: Fault[];
  odometry: { x_m: number; y_m: number; heading_deg: number };
  neck: { pan_deg: number; tilt_deg: number };
  wheels: { left_mps: number; right_mps: number };
  camera_trouble: string;
  sonar: Sonar | null;
  faces: Faces | null;
  scene: Scene | null;
  memory: Memory | null;
}

/** What the calibration wizard shows; lengths in pixels of a picture of width x height. */
export interface CalibrationState {
  phase: 'off' | 'looking' | 'working' | 'ready' | 'poor' | 'saved';
  room_holds: boolean;
  width: number;
  height: number;
  corners: Point[];
  taken: Point[][];
  target: Point[];
  next: Words | null;
  now: Words | null;
  views: number;
  views_needed: number;
  views_good: number;
  coverage: number;
  tilt_deg: number;
  words: Fault[];
}

export interface Watch {
  camera: boolean;
  sonar: boolean;
  faces: boolean;
  room: boolean;
  memory: boolean;
}

export type ToRobot =
  | { type: 'hello'; version: 1; client: string; code?: string }
  | { type: 'run'; program: Program }
  | { type: 'stop' }
  | { type: 'pause'; on: boolean }
  | { type: 'key'; key: string; down: boolean }
  | { type: 'evaluate'; request: number; program: Program; block: string }
  | { type: 'choose'; world: string; robot: string; seed: number }
  | { type: 'put_back' }
  | { type: 'calibrate'; action: 'begin'; board: string; size: string; square_mm: number; camera: string }
  | { type: 'calibrate'; action: 'take' | 'finish' | 'save' | 'cancel' }
  | { type: 'faces'; action: 'allow'; on: boolean; code: string }
  | { type: 'faces'; action: 'rename'; name: string; to: string }
  | { type: 'faces'; action: 'forget'; name: string }
  | { type: 'faces'; action: 'forget_all' }
  | ({ type: 'watch' } & Watch)
  | { type: 'release' };

/** Who this page is for the robot, and who drives. */
export interface Seat {
  you: string;
  you_drive: boolean;
  /** False: the join code is missing. */
  may_drive: boolean;
  owner: string | null;
  taken: boolean;
  viewers: number;
}

export type FromRobot =
  | ({
      type: 'welcome';
      version: number;
      setup: Setup;
      worlds: Choice[];
      robots: Choice[];
      robot_clock_us: number;
    } & Seat)
  | ({ type: 'owner' } & Seat)
  | ({ type: 'telemetry' } & Telemetry)
  | { type: 'notice'; code: string; severity: string; message: Words }
  | { type: 'started'; run: number; warnings: Fault[] }
  | { type: 'refused'; to: string; faults: Fault[] }
  | { type: 'stopped' }
  | { type: 'value'; request: number; value?: Value; fault?: Fault }
  | { type: 'known_faces'; allowed: boolean; people: { name: string; looks: number }[] }
  | ({ type: 'calibration' } & CalibrationState)
  | { type: 'setup'; setup: Setup };

export interface PictureHeader {
  frame: number;
  t_us: number;
  width: number;
  height: number;
}

/** Splits a binary message: header length (u32, little-endian), header, JPEG. Null when it is none. */
export function readPicture(
  bytes: ArrayBuffer,
): { header: PictureHeader; jpeg: Uint8Array<ArrayBuffer> } | null {
  if (bytes.byteLength < 4) return null;
  const length = new DataView(bytes).getUint32(0, true);
  if (length > bytes.byteLength - 4) return null;
  try {
    const text = new TextDecoder().decode(new Uint8Array(bytes, 4, length));
    return { header: JSON.parse(text) as PictureHeader, jpeg: new Uint8Array(bytes, 4 + length) };
  } catch {
    return null;
  }
}

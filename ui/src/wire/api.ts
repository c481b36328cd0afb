import type { Pack } from '../blocks/pack';
import type { Bytes } from '../model/scratch_file';
import type { Example, Fault, SetupAnswer } from './protocol';

async function get<T>(path: string): Promise<T> {
  const answer = await fetch(path, { cache: 'no-store' });
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return (await answer.json()) as T;
}

export interface Robot {
  packs: Pack[];
  setup: SetupAnswer;
  examples: Example[];
}

export interface OpenedScratch {
  program: unknown;
  faults: Fault[];
}

/** Has the robot turn a Scratch file into a program for the editor; `program` is null when it refuses. */
export async function openScratch(bytes: Bytes): Promise<OpenedScratch> {
  const answer = await fetch('/api/scratch', { method: 'POST', body: bytes });
  const opened = (await answer.json()) as Partial<OpenedScratch>;
  return { program: opened.program ?? null, faults: opened.faults ?? [] };
}

/** All that the editor needs before it can show a block. */
export async function loadRobot(): Promise<Robot> {
  const [packs, setup, examples] = await Promise.all([
    get<{ packs: Pack[] }>('/api/packs'),
    get<SetupAnswer>('/api/setup'),
    get<{ examples: Example[] }>('/api/examples'),
  ]);
  return { packs: packs.packs, setup, examples: examples.examples };
}

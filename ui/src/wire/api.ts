import type { Pack } from '../blocks/pack';
import type { Example, SetupAnswer } from './protocol';

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

/** All that the editor needs before it can show a block. */
export async function loadRobot(): Promise<Robot> {
  const [packs, setup, examples] = await Promise.all([
    get<{ packs: Pack[] }>('/api/packs'),
    get<SetupAnswer>('/api/setup'),
    get<{ examples: Example[] }>('/api/examples'),
  ]);
  return { packs: packs.packs, setup, examples: examples.examples };
}

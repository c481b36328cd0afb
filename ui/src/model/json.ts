interface Frame {
  close: string;
  keys: string[] | null;
  values: unknown[];
  at: number;
  written: number;
}

function open(value: object): Frame {
  if (Array.isArray(value)) return { close: ']', keys: null, values: value, at: 0, written: 0 };
  const keys = Object.keys(value);
  const values = keys.map((key) => (value as Record<string, unknown>)[key]);
  return { close: '}', keys, values, at: 0, written: 0 };
}

/**
 * JSON text of plain data, as JSON.stringify writes it, at any depth: a stack of 5,000 blocks is nested 10,000 deep, more
 * than the recursion of JSON.stringify is sure to survive.
 */
export function writeJson(value: unknown): string {
  if (typeof value !== 'object' || value === null) return JSON.stringify(value) ?? 'null';
  const out: string[] = [];
  const stack: Frame[] = [];
  const enter = (inner: object) => {
    const frame = open(inner);
    out.push(frame.keys ? '{' : '[');
    stack.push(frame);
  };
  enter(value);
  for (let frame = stack.at(-1); frame; frame = stack.at(-1)) {
    if (frame.at === frame.values.length) {
      out.push(frame.close);
      stack.pop();
      continue;
    }
    const index = frame.at++;
    const item = frame.values[index];
    if (frame.keys && item === undefined) continue;
    if (frame.written++ > 0) out.push(',');
    if (frame.keys) out.push(JSON.stringify(frame.keys[index]), ':');
    if (typeof item === 'object' && item !== null) enter(item);
    else out.push(JSON.stringify(item) ?? 'null');
  }
  return out.join('');
}

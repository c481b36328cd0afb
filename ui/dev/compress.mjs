// Writes x.gz beside every file of dist/ that gains from it; the robot serves it to browsers that take gzip.
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { constants, gzipSync } from 'node:zlib';

const root = fileURLToPath(new URL('../dist/', import.meta.url));
let plain = 0;
let sent = 0;

function walk(folder) {
  for (const name of readdirSync(folder)) {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) walk(path);
    else if (!name.endsWith('.gz')) compress(path);
  }
}

function compress(path) {
  const bytes = readFileSync(path);
  const small = gzipSync(bytes, { level: constants.Z_BEST_COMPRESSION });
  const gains = small.length < bytes.length * 0.9;
  if (gains) writeFileSync(`${path}.gz`, small);
  plain += bytes.length;
  sent += gains ? small.length : bytes.length;
}

walk(root);
console.log(`dist: ${(plain / 1000).toFixed(0)} kB, as sent ${(sent / 1000).toFixed(0)} kB`);

// Puts the peers into build/peers, once (about 230 MB); nothing of it is part of the tree.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';

const kScratch = ['@scratch/scratch-vm@15.1.1', 'blockly@13.3.0', 'entities@6'];
const kTurboWarp = '@turbowarp/scaffolding@0.4.0';

export function install(folder) {
  const run = (program, ...words) => execFileSync(program, words, { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
  mkdirSync(folder, { recursive: true });
  if (!existsSync(`${folder}/package.json`)) writeFileSync(`${folder}/package.json`, '{"private": true}\n');
  if (!existsSync(`${folder}/node_modules/@scratch/scratch-vm`)) {
    run('npm', 'install', '--no-audit', '--no-fund', '--no-package-lock', '--ignore-scripts', ...kScratch);
  }
  // Scratch's node bundle holds jsdom, which opens these when it starts; empty ones will do.
  const scratch = `${folder}/node_modules/@scratch/scratch-vm`;
  mkdirSync(`${scratch}/browser`, { recursive: true });
  writeFileSync(`${scratch}/browser/default-stylesheet.css`, '');
  writeFileSync(`${scratch}/dist/node/xhr-sync-worker.js`, '');
  // TurboWarp's machine is in this bundle; its one dependency is types only, so the package alone is enough.
  if (existsSync(`${folder}/turbowarp/dist`)) return;
  run('npm', 'pack', '--silent', kTurboWarp);
  mkdirSync(`${folder}/turbowarp`, { recursive: true });
  run('tar', 'xzf', 'turbowarp-scaffolding-0.4.0.tgz', '-C', 'turbowarp', '--strip-components=1', 'package/dist/scaffolding-min.js');
}

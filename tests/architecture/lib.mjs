// What the architecture tests share: the tree's files, and the layering table of docs/house.md.
import { readdirSync, readFileSync, existsSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const unvisited = new Set(['.git', 'build', 'node_modules', 'dist', '.cache']);

function walk(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return unvisited.has(entry.name) ? [] : walk(path);
    return entry.isFile() ? [relative(root, path)] : [];
  });
}

/** Every file of the tree that is ours, as paths from the root with forward slashes. */
export const files = walk(root).sort();
export const read = (path) => readFileSync(join(root, path), 'utf8');
export const exists = (path) => existsSync(join(root, path));
export const isCpp = (path) => /\.(cpp|h|def)$/.test(path);
export const lineOf = (text, index) => text.slice(0, index).split('\n').length;

/**
 * The layering table: rows "| `runtime/base` | ... | rooms |" under the heading "The rooms".
 * Gives folder -> set of folders that its files may include from, itself among them.
 */
export function layering(house) {
  const section = house.split(/^## /m).find((part) => part.startsWith('The rooms')) ?? '';
  const rows = [...section.matchAll(/^\| `([a-z/]+)`\s*\|[^|]*\|([^|]*)\|\s*$/gm)];
  const table = new Map();
  for (const [, folder, mayInclude] of rows) {
    const words = [...mayInclude.matchAll(/`([a-z/]+)`/g)].map((match) => match[1]);
    const folders = words.map((word) => (word === 'blocks' || word === 'src' ? word : `runtime/${word}`));
    table.set(folder, new Set([folder, ...folders]));
  }
  return table;
}

/** The row of the table that a file belongs to: its longest listed folder. */
export function roomOf(path, table) {
  const rooms = [...table.keys()].filter((folder) => path.startsWith(`${folder}/`));
  return rooms.sort((a, b) => b.length - a.length)[0];
}

/** C++ without comments; strings stay. Newlines stay, so that line numbers hold. */
export function withoutComments(text) {
  const token = /\/\/[^\n]*|\/\*[\s\S]*?\*\/|R"([^()\s\\]*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'/g;
  return text.replace(token, (match) => (/^\/[/*]/.test(match) ? match.replace(/[^\n]/g, ' ') : match));
}

/** C++ without comments and with every string empty: for looking at the code's shape. */
export function shapeOf(text) {
  const strings = /R"([^()\s\\]*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"/g;
  return withoutComments(text).replace(strings, (match) => `""${match.replace(/[^\n]/g, '')}`);
}

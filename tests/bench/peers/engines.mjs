// The peers' engines without a browser, from the folder that install.mjs filled.
import { createRequire } from 'node:module';

const nothing = () => {};

/** As much of a document as TurboWarp's bundle touches while it loads. */
function pretendDocument() {
  const element = () => ({
    style: {}, classList: { add: nothing, remove: nothing }, sheet: {}, textContent: '', appendChild: nothing, setAttribute: nothing,
    addEventListener: nothing, remove: nothing,
    getContext: () => ({ fillRect: nothing, drawImage: nothing, measureText: () => ({ width: 0 }), getImageData: () => ({ data: [0, 0, 0, 0] }) }),
  });
  const place = { href: 'http://localhost/', protocol: 'http:', origin: 'http://localhost', search: '', hash: '' };
  const page = { head: element(), body: element(), documentElement: element(), createElement: element, createElementNS: element };
  Object.assign(page, { createTextNode: element, addEventListener: nothing, querySelector: () => null, getElementsByTagName: () => [] });
  Object.assign(page, { fonts: { add: nothing }, currentScript: null, baseURI: place.href, location: place });
  Object.assign(globalThis, { window: globalThis, self: globalThis, document: page, location: place });
  Object.assign(globalThis, { addEventListener: nothing, removeEventListener: nothing, cancelAnimationFrame: clearTimeout });
  globalThis.requestAnimationFrame = (then) => setTimeout(then, 16);
  globalThis.navigator ??= { userAgent: 'node', language: 'en', languages: ['en'] };
  const classes = ['HTMLElement', 'HTMLCanvasElement', 'HTMLImageElement', 'Image', 'FontFace', 'Worker', 'XMLHttpRequest', 'DOMParser'];
  for (const name of [...classes, 'AudioContext', 'FileReader', 'Node', 'Element', 'MutationObserver']) globalThis[name] ??= class {};
}

/** kind: scratch, or turbowarp with its compiler on. */
export function engine(kind, folder) {
  const require = createRequire(`${folder}/here.js`);
  if (kind === 'scratch') {
    const bundle = require('@scratch/scratch-vm');
    const Engine = bundle.default ?? bundle.VirtualMachine ?? bundle;
    return new Engine();
  }
  pretendDocument();
  const { Packages } = require('./turbowarp/dist/scaffolding-min.js');
  const machine = new Packages.VM();
  machine.setCompilerOptions({ enabled: true, warpTimer: false });
  return machine;
}

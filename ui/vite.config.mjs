import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const media = fileURLToPath(new URL('./node_modules/blockly/media/', import.meta.url));
const wanted = readdirSync(media).filter((name) => /\.(svg|cur|gif|png)$/.test(name));
const types = { svg: 'image/svg+xml', cur: 'image/x-icon', gif: 'image/gif', png: 'image/png' };

/** Serves Blockly's pictures from the robot: nothing may come from elsewhere. */
const blocklyMedia = {
  name: 'blockly-media',
  generateBundle() {
    for (const name of wanted) {
      this.emitFile({ type: 'asset', fileName: `media/${name}`, source: readFileSync(media + name) });
    }
  },
  configureServer(server) {
    server.middlewares.use('/media', (request, response, next) => {
      const name = (request.url ?? '').slice(1);
      if (!wanted.includes(name)) return next();
      response.setHeader('Content-Type', types[name.split('.').pop()]);
      response.end(readFileSync(media + name));
    });
  },
};

const robot = process.env.MIRADA_ROBOT ?? 'http://127.0.0.1:8600';

export default defineConfig({
  plugins: [blocklyMedia],
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  build: {
    target: 'es2021',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1500,
  },
  server: { port: 5173, proxy: { '/api': robot, '/ws': { target: robot, ws: true } } },
  test: {
    environment: 'node',
    testTimeout: 60_000,
    include: ['tests/**/*_test.ts'],
    // The Node entry of Blockly wants jsdom; its compressed core works headless without a page.
    alias: {
      'blockly/core': fileURLToPath(new URL('./node_modules/blockly/blockly_compressed.js', import.meta.url)),
    },
  },
});

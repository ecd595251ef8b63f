import { svelte } from '@sveltejs/vite-plugin-svelte';
import { writeFileSync } from 'node:fs';
import type { Plugin } from 'vite';
import { defineConfig } from 'vitest/config';
import { manual } from './scripts/manual.mjs';

/** Notes which packages have modules in the page: tools/third_party.py takes their licences. */
function shipped(): Plugin {
  const of = (id: string) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(id)?.[1];
  return {
    name: 'shipped',
    generateBundle(_options, bundle) {
      const names = new Set<string>();
      for (const part of Object.values(bundle)) {
        const ids = part.type === 'chunk' ? part.moduleIds : part.originalFileNames;
        for (const name of ids.map(of)) if (name) names.add(name);
      }
      writeFileSync('node_modules/.shipped.json', JSON.stringify([...names].sort()));
    },
  };
}

// `npm run dev` serves the page by itself and passes everything else to a panel server.
const server = process.env.KERF_SERVER ?? 'http://127.0.0.1:8080';

export default defineConfig({
  plugins: [svelte(), manual(), shipped()],
  base: './',
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 1200,
    assetsInlineLimit: 0,
    // One name for one content: the server may let browsers keep assets for good.
    rollupOptions: {
      output: {
        manualChunks: {
          three: ['three'],
          editor: [
            '@codemirror/state',
            '@codemirror/view',
            '@codemirror/lint',
            '@codemirror/commands',
            '@codemirror/search',
          ],
        },
      },
    },
  },
  server: {
    // The server looks at Host and Origin: both stay those of this page.
    proxy: {
      '/ws': { target: server, ws: true },
      '/library': { target: server },
      '/api': { target: server },
      '/notices': { target: server },
      '/health': { target: server },
    },
  },
  test: { include: ['tests/**/*.test.ts'], environment: 'node' },
});

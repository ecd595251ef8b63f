import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';
import { manual } from './scripts/manual.mjs';

// `npm run dev` serves the page by itself and passes everything else to a panel server.
const server = process.env.KERF_SERVER ?? 'http://127.0.0.1:8080';

export default defineConfig({
  plugins: [svelte(), manual()],
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
            '@codemirror/language',
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
      '/health': { target: server },
    },
  },
  test: { include: ['tests/**/*.test.ts'], environment: 'node' },
});

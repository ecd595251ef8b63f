// A `kerf serve` of its own for a run of the tests, with an empty data folder.
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const START_MS = 30_000;

export class Server {
  static async start(program) {
    const server = new Server(
      program,
      mkdtempSync(join(tmpdir(), 'kerf-panel-')),
      await free_port(),
    );
    await server.begin();
    return server;
  }

  constructor(program, data, port) {
    this.program = program;
    this.data = data;
    this.port = port;
    this.base = `http://127.0.0.1:${port}/`;
  }

  async begin() {
    const options = ['serve', '--port', String(this.port), '--data', this.data];
    this.process = spawn(this.program, options, {
      stdio: ['ignore', 'ignore', 'inherit'],
    });
    process.once('exit', () => this.process.kill('SIGKILL')); // also where the tests cannot begin
    await this.answers();
  }

  /** As a power failure ends it. */
  async kill() {
    const gone = new Promise((resolve) => this.process.once('exit', resolve));
    this.process.kill('SIGKILL');
    await gone;
  }

  /** No file of it can grow any more, or again: as a disk that is full for a while. */
  fill_disk(full) {
    const size = full ? '0' : 'unlimited';
    execFileSync('prlimit', [`--pid=${this.process.pid}`, `--fsize=${size}:unlimited`]);
  }

  /** As a line that hangs: it takes what comes, and answers nothing. */
  freeze() {
    this.process.kill('SIGSTOP');
  }
  thaw() {
    this.process.kill('SIGCONT');
  }

  async end() {
    if (this.process.exitCode === null && this.process.signalCode === null) await this.kill();
    rmSync(this.data, { recursive: true, force: true });
  }

  async answers() {
    const until = Date.now() + START_MS;
    while (Date.now() < until) {
      const answer = await fetch(`${this.base}health`).catch(() => null);
      if (answer?.ok) return;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    throw new Error(`${this.program} serve does not answer on port ${this.port}`);
  }
}

function free_port() {
  return new Promise((resolve, reject) => {
    const probe = createServer();
    probe.on('error', reject);
    probe.listen(0, '127.0.0.1', () => {
      const { port } = probe.address();
      probe.close(() => resolve(port));
    });
  });
}

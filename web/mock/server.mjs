// A stand-in for `kerf serve` while the page is developed: recorded runs of real programs, played in time.
import { execFileSync } from 'node:child_process';
import { createServer } from 'node:http';
import { createHash } from 'node:crypto';
import { readFileSync, existsSync, mkdtempSync } from 'node:fs';
import { join, extname, basename } from 'node:path';

const ROOT = '/work/main', KERF = `${ROOT}/build/release/bin/kerf`;
const DIST = new URL('../dist/', import.meta.url).pathname;
const TMP = mkdtempSync('/tmp/kerfmock');
const cart = (x, y, z, extra = []) => [['X', ...x], ['Y', ...y], ['Z', ...z], ...extra].map(([name, min, max]) => ({ name, min, max, rotary: 'AC'.includes(name), unit: 'mm', program: true }));
const DEFS = {
  mill3: { title: 'vertical machining centre, X Y Z', axes: cart([-400, 400], [-250, 250], [-500, 0]), kinematics: { kind: 'cartesian' }, laser: false },
  laser3: { title: 'laser engraver, X Y, Z for focus', axes: cart([-350, 350], [-250, 250], [-50, 50]), kinematics: { kind: 'cartesian' }, laser: true },
  laser5: { title: 'five-axis laser with an A/C head', axes: cart([-750, 750], [-750, 750], [-300, 700], [['A', -180, 180], ['C', null, null]]), kinematics: { kind: 'head-ac', r_a: 150, r_c: 80 }, laser: true },
  arm4: { title: 'two-link engraving arm', axes: cart([null, null], [null, null], [-50, 100], [['C', null, null]]), joints: ['T1', 'T2', 'T3', 'Z'], kinematics: { kind: 'arm', upper_arm: 132, forearm: 132, forearm_absolute: false }, laser: false },
  'laser-xtz': { title: 'laser over a turning work', axes: cart([null, null], [null, null], [-50, 50]), joints: ['X', 'C', 'Z'], kinematics: { kind: 'x-theta-z', x1: 25, theta0_deg: 10, z0: 5 }, laser: true },
};
const SAMPLES = { mill: ['mill3', '01_flanges/flanges.nc'], laser: ['laser3', '14_koch/koch.bas'], head: ['laser5', '13_tube/tube.tch'], arm: ['arm4', '16_flower/flower.nc'], lens: ['laser-xtz', '15_lens/lens.bas'] };
const library = new Map(), programs = {};
for (const e of ['01_flanges/flanges.nc', '08_pocket/pocket.nc', '09_cam_part/bracket.nc', '10_snowflake/snowflake.nc', '11_cardioid/cardioid.bas', '13_tube/tube.tch', '14_koch/koch.bas', '15_lens/lens.bas', '16_flower/flower.nc']) {
  library.set(basename(e), readFileSync(`${ROOT}/examples/${e}`, 'utf8'));
  programs[basename(e)] = `${ROOT}/examples/${e}`;
}
function record(def, path) {
  const [m, p] = [join(TMP, 'm'), join(TMP, 'p')];
  execFileSync(KERF, ['run', path, '--machine', def, '--motion', m, '--points', p, '--diagnostics', 'json'], { stdio: 'ignore' });
  const rows = readFileSync(p, 'utf8').trim().split('\n');
  const head = rows[0].split(',');
  const step = Math.max(1, Math.floor(rows.length / 40000));
  const points = [];
  let before = '';
  for (let i = 1; i < rows.length; i++) {
    const line = rows[i].slice(rows[i].lastIndexOf(',') + 1);
    if (i % step === 0 || line !== before || i === rows.length - 1) points.push(Object.fromEntries(rows[i].split(',').map((v, j) => [head[j], +v])));
    before = line;
  }
  const kinds = new Map(), feeds = new Map(), tools = new Map();
  let tool = 0;
  for (const l of readFileSync(m, 'utf8').trim().split('\n')) {
    const r = JSON.parse(l);
    if (r.kind === 'tool') tool = r.tool;
    if (['rapid', 'line', 'arc', 'space-arc', 'dwell', 'thread', 'probe'].includes(r.kind)) { kinds.set(r.line, { rapid: 0, dwell: 2, thread: 3, probe: 4 }[r.kind] ?? 1); feeds.set(r.line, r.feed ?? 0); }
    tools.set(r.line + ':' + tools.size, tool);
  }
  return { points, kinds, feeds, tool };
}
class Machine {
  constructor(name, def) {
    this.name = name; this.def = def; this.joints = DEFS[def].joints ?? DEFS[def].axes.map((a) => a.name);
    this.clients = new Set(); this.run = 0; this.time = 0; this.variables = { '#100': 3, '#101': 3, '#102': -9.7, '#103': 3.3, '#500': 12.5, '#1': null, '#2': 4, '#7': 20 };
    this.state = { status: 'idle', mode: 'auto', program: '', file: '', line: 0, text: '', time_s: 0, total_s: null, motion: 0, motions: 0, position: { machine: {}, work: {}, distance: {} }, joints: {}, modal: 'G01 G17 G90 G94 G21 G40 G43 G54 G64 G67 G69 G80 G98 G97 G50'.split(' '), feed: { programmed_mm_min: 0, actual_mm_min: 0 }, spindle: { speed_rpm: 2500, direction: 'clockwise', load: null }, tool: 1, coolant: 'flood', power_percent: 0, beam: false, override: { feed: 100, rapid: 100, spindle: 100 }, switches: {}, skip: [], alarm: null, messages: ['CHANGE TO TOOL 2'], stack: [], operator: null, clients: [], variables_revision: 1, printed: 'X  12.500\nY  -3.000\n', breakpoint: null };
  }
  load(name) {
    this.rec = record(this.def, programs[name]); this.file = name; this.text = library.get(name).split('\n'); this.run++; this.time = 0;
    Object.assign(this.state, { program: /O\d{4}/.exec(library.get(name))?.[0] ?? name.replace(/\..*/, ''), file: name, status: 'idle', alarm: null });
    this.place(0); for (const c of this.clients) this.sendPath(c);
  }
  place(t) {
    const p = this.rec.points; let lo = 0, hi = p.length - 1;
    while (lo < hi) { const m = (lo + hi) >> 1; if (p[m].t < t) lo = m + 1; else hi = m; }
    const q = p[lo], o = p[Math.max(0, lo - 1)];
    const axes = Object.fromEntries(DEFS[this.def].axes.map((a) => [a.name, q[a.name] ?? 0]));
    const v = Math.hypot(q.X - o.X, q.Y - o.Y, q.Z - o.Z) / Math.max(1e-3, q.t - o.t) * 60;
    Object.assign(this.state, { position: { machine: axes, work: Object.fromEntries(Object.entries(axes).map(([k, x]) => [k, k === 'Z' && this.def === 'mill3' ? x + 120 : x])), distance: Object.fromEntries(Object.keys(axes).map((k) => [k, 0])) }, joints: Object.fromEntries(this.joints.map((j, i) => [j, q['j' + (i + 1)]])), line: q.line, text: this.text[q.line - 1] ?? '', time_s: t, total_s: p.at(-1).t, motion: lo, motions: p.length, power_percent: q.power ?? 0, beam: (q.power ?? 0) > 0, feed: { programmed_mm_min: this.rec.feeds.get(q.line) ?? 0, actual_mm_min: v }, stack: [{ program: this.state.program, file: this.file, line: 46, level: 0 }, { program: 'O9100', file: this.file, line: q.line, level: 1 }] });
  }
  sendPath(c) {
    const p = this.rec.points, rotary = DEFS[this.def].axes.some((a) => a.rotary), R = DEFS[this.def].axes.filter((a) => a.rotary).map((a) => a.name);
    const path = (done) => c.send(JSON.stringify({ event: 'path', machine: this.name, run: this.run, done, motions: p.length, time_s: p.at(-1).t, bounds: null, files: [this.file], error: null }));
    path(false);
    for (let s = 0, k = 0; s < p.length - 1; s += 65535, k++) {
      const q = p.slice(s, s + 65536), n = q.length, parts = [];
      const head = Buffer.alloc(32); head.write('KPTH'); head.writeUInt16LE(1 | (rotary ? 256 : 0), 4); head.writeUInt32LE(this.run, 8); head.writeUInt32LE(k, 12); head.writeUInt32LE(s, 16); head.writeUInt32LE(n, 20); head.writeDoubleLE(q[0].t, 24);
      const pad = (a) => { const b = Buffer.from(a.buffer, a.byteOffset, a.byteLength); parts.push(b, Buffer.alloc((4 - (b.length & 3)) & 3)); };
      parts.push(head); pad(Float32Array.from(q.flatMap((x) => [x.X, x.Y, x.Z]))); pad(Float32Array.from(q, (x) => x.t - q[0].t)); pad(Float32Array.from(q, (x) => this.rec.feeds.get(x.line) ?? 0));
      pad(Float32Array.from(q, (x, i) => { const o = q[Math.max(0, i - 1)]; return (Math.hypot(x.X - o.X, x.Y - o.Y, x.Z - o.Z) / Math.max(1e-3, x.t - o.t)) * 60; }));
      pad(Uint32Array.from(q, (_, i) => s + i)); pad(Uint32Array.from(q, (x) => x.line)); pad(new Uint16Array(n));
      pad(Uint8Array.from(q, (x) => (x.power !== undefined ? (x.power > 0 ? 1 : 0) : this.rec.kinds.get(x.line) ?? 1))); pad(Uint8Array.from(q, (x) => 1 + (Math.floor((3 * x.t) / p.at(-1).t) % 3))); pad(Uint8Array.from(q, (x) => x.power ?? 0));
      if (rotary) pad(Float32Array.from(q.flatMap((x) => [x[R[0]] ?? 0, x[R[1]] ?? 0])));
      c.send(Buffer.concat(parts));
    }
    path(true);
  }
  tick(dt) { if (this.state.status === 'running' && this.rec) { const t = this.state.time_s + dt * (this.state.override.feed / 100); if (t >= this.rec.points.at(-1).t) { this.place(this.rec.points.at(-1).t); this.state.status = 'end'; } else this.place(t); this.publish(); } }
  publish() { this.state.clients = [...this.clients].map((c) => c.id); for (const c of this.clients) c.send(JSON.stringify({ event: 'state', machine: this.name, ...this.state })); }
}
const machines = new Map(Object.entries(SAMPLES).map(([n, [d, f]]) => { const m = new Machine(n, d); m.load(basename(f)); return [n, m]; }));
const DO = {
  machines: () => ({ machines: [...machines.values()].map((m) => ({ name: m.name, definition: m.def, status: m.state.status, operator: m.state.operator, clients: m.clients.size })), definitions: Object.keys(DEFS) }),
  watch: (a, c) => { c.machine?.clients.delete(c); c.machine = machines.get(a.machine); c.machine.clients.add(c); const m = c.machine; setTimeout(() => { m.publish(); m.sendPath(c); }, 5); const { joints: _j, ...rest } = DEFS[m.def]; return { definition: { ...rest, name: m.def, dialect: 'fanuc-mill', period_s: 0.001, rapid_mm_min: {}, joints: m.joints.map((n) => ({ name: n, rotary: /[TAC]/.test(n), min: null, max: null, unit: 'mm', program: false })) }, client: c.id, breakpoints: [] }; },
  operate: (a, c) => { const s = c.machine.state; if (a.take && s.operator && s.operator !== c.id) throw `${s.operator} operates this machine; ask for a hand-over.`; s.operator = a.take ? c.id : a.hand_to ?? null; },
  load: (a, c) => { if (a.program) c.machine.load(a.program); },
  mode: (a, c) => { c.machine.state.mode = a.mode; }, 'cycle-start': (a, c) => { c.machine.state.status = 'running'; }, 'feed-hold': (a, c) => { c.machine.state.status = 'held'; },
  reset: (a, c) => { Object.assign(c.machine.state, { status: 'idle', alarm: null }); c.machine.place(0); }, switch: (a, c) => { c.machine.state.switches = { ...c.machine.state.switches, [a.switch]: a.on }; }, 'block-skip': (a, c) => { c.machine.state.skip = a.levels; },
  override: (a, c) => { const { id, do: _, ...o } = a; c.machine.state.override = { ...c.machine.state.override, ...o }; }, breakpoints: (a) => ({ list: a.list }), step: (a, c) => { c.machine.place(c.machine.state.time_s + (a.how === 'back' ? -2 : 2)); c.machine.state.status = 'step'; },
  variables: (a, c) => ({ variables: Object.entries(c.machine.variables).filter(([n]) => !a.names || a.names.includes(n)).map(([name, value]) => ({ name, value, level: /^#\d\d?$/.test(name) ? 1 : null, changed: name === '#100' })), scopes: ['local', 'common', 'permanent'], levels: 2 }),
  'set-variable': (a, c) => { c.machine.variables[a.name] = a.value; c.machine.state.variables_revision++; },
  offsets: (a, c) => ({ offsets: ['EXT', 'G54', 'G55', 'G56', 'G57', 'G58', 'G59'].flatMap((offset) => DEFS[c.machine.def].axes.map((x) => ({ offset, axis: x.name, value: x.name === 'Z' && offset === 'G54' ? -120 : 0 }))) }), 'set-offset': () => {},
  tools: () => ({ tools: [95.2, 131, 88.5].map((l, i) => ({ number: i + 1, length_geometry: l, length_wear: 0, radius_geometry: i === 2 ? 5 : 0, radius_wear: 0 })) }),
  instant: (a, c) => { const m = c.machine, keep = { ...m.state }; m.place(a.time_s); const s = m.state; const r = { time_s: a.time_s, position: s.position, joints: s.joints, file: s.file, line: s.line, modal: s.modal, variables: [] }; m.state = Object.assign(m.state, keep); return r; },
  speeds: (a, c) => { const p = c.machine.rec.points, o = { time_s: [], speed_mm_min: [], line: [] }; const st = Math.max(1, Math.floor(p.length / a.points)); for (let i = st; i < p.length; i += st) { const x = p[i], b = p[i - 1]; o.time_s.push(x.t); o.line.push(x.line); o.speed_mm_min.push((Math.hypot(x.X - b.X, x.Y - b.Y, x.Z - b.Z) / (x.t - b.t)) * 60); } return o; },
  pulses: (a, c) => { const p = c.machine.rec.points, t = c.machine.state.time_s, axes = {}, lines = []; for (const j of ['X', 'Y', 'Z']) axes[j] = []; let b = p[0]; for (const x of p) { if (x.t < t - a.seconds) { b = x; continue; } if (x.t > t) break; if (lines.at(-1)?.line !== x.line) lines.push({ file: '', line: x.line, from_s: b.t, to_s: x.t }); else lines.at(-1).to_s = x.t; for (const j of ['X', 'Y', 'Z']) { const n = Math.round((x[j] - b[j]) * 200); for (let k = 0; k < Math.abs(n) && k < 500; k++) axes[j].push(b.t + ((x.t - b.t) * k) / Math.abs(n), Math.sign(n)); } b = x; } return { pulses: axes, lines: lines.map((l) => [l.from_s, l.to_s, l.line]), time_s: t }; },
  check: (a) => { const r = []; a.text.split('\n').forEach((l, i) => { const k = l.indexOf('X1.2.3'); if (k >= 0) r.push({ severity: 'error', code: 'PS0007', message: 'ILLEGAL USE OF DECIMAL POINT', line: i + 1, column: k + 1, length: 6, cause: 'An integer address has a decimal point, or a number has two.', remedy: 'Write one decimal point.' }); }); return { diagnostics: r }; },
  settings: (a, c) => ({ toml: readFileSync(`${ROOT}/machines/${c.machine.def}.toml`, 'utf8') }), programs: () => ({ programs: [...library].map(([name, t]) => ({ name, bytes: t.length, modified: '2026-11-20T10:00:00Z' })) }),
  read: (a) => { if (!library.has(a.name)) throw `There is no program ${a.name}.`; return { text: library.get(a.name) }; }, write: (a) => { library.set(a.name, a.text); }, rename: (a) => { library.set(a.to, library.get(a.from)); library.delete(a.from); }, delete: (a) => { library.delete(a.name); }, revisions: () => ({ revisions: [{ revision: 1, bytes: 100, modified: '2026-11-19T10:00:00Z', kept: true }] }),
  alarm: (a, c) => { Object.assign(c.machine.state, { status: 'alarm', alarm: { code: 'PS0112', message: 'ZERO DIVIDE', file: c.machine.file, line: 30, column: 6, cause: 'A divisor is 0 or vacant.', remedy: 'Test the divisor before, or give the argument that the macro expects.' } }); },
  home: () => {}, jog: () => {}, 'jog-stop': () => {}, mdi: () => {},
};
let next = 1;
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.woff2': 'font/woff2' };
const http = createServer((q, r) => { if (q.url.startsWith('/library/')) return r.end(library.get(decodeURIComponent(q.url.slice(9)))); const p = join(DIST, q.url.split('?')[0] === '/' ? 'index.html' : q.url.split('?')[0]); if (!existsSync(p)) return r.writeHead(404).end(); r.writeHead(200, { 'content-type': TYPES[extname(p)] ?? 'text/plain' }).end(readFileSync(p)); });
http.on('upgrade', (q, socket) => {
  socket.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${createHash('sha1').update(q.headers['sec-websocket-key'] + '258EAFA5-E914-47DA-95CA-C5AB0DC85B11').digest('base64')}\r\n\r\n`);
  const c = { id: `page ${next++}`, machine: null, send(data) { const b = Buffer.from(data), bin = typeof data !== 'string'; const h = b.length < 126 ? Buffer.from([0, b.length]) : b.length < 65536 ? Buffer.from([0, 126, b.length >> 8, b.length & 255]) : (() => { const x = Buffer.alloc(10); x[1] = 127; x.writeBigUInt64BE(BigInt(b.length), 2); return x; })(); h[0] = bin ? 0x82 : 0x81; socket.write(Buffer.concat([h, b])); } };
  let buffer = Buffer.alloc(0);
  socket.on('data', (d) => { buffer = Buffer.concat([buffer, d]); for (;;) { if (buffer.length < 6) return; let n = buffer[1] & 127, at = 2; if (n === 126) { n = buffer.readUInt16BE(2); at = 4; } else if (n === 127) { n = Number(buffer.readBigUInt64BE(2)); at = 10; } if (buffer.length < at + 4 + n) return; const mask = buffer.subarray(at, at + 4), body = Buffer.from(buffer.subarray(at + 4, at + 4 + n)).map((x, i) => x ^ mask[i & 3]), op = buffer[0] & 15; buffer = buffer.subarray(at + 4 + n); if (op === 8) return socket.end(); if (op !== 1) continue; const a = JSON.parse(body); try { const r = DO[a.do] ? DO[a.do](a, c) : (() => { throw `There is no command ${a.do}.`; })(); c.send(JSON.stringify({ id: a.id, ok: true, ...r })); } catch (e) { c.send(JSON.stringify({ id: a.id, ok: false, error: String(e) })); } if (c.machine && a.do !== 'instant') c.machine.publish(); } });
  const gone = () => { if (c.machine) { c.machine.clients.delete(c); if (c.machine.state.operator === c.id) c.machine.state.operator = null; } };
  socket.on('close', gone); socket.on('end', () => (gone(), socket.end())); socket.on('error', gone);
});
setInterval(() => machines.forEach((m) => m.tick(0.05)), 50);
http.listen(+(process.argv[2] ?? 8080), () => console.log('mock on', process.argv[2] ?? 8080));

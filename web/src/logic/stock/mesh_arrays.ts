/** Triangles and lines of a tile, as they are put together. */

export interface TileMesh {
  /** Three a vertex, mm from the zero of the stock. */
  positions: Float32Array;
  /** Four a vertex, -127 to 127; the fourth is 0. */
  normals: Int8Array;
  indices: Uint32Array;
  /** Two points an edge that is drawn as a line. */
  lines: Float32Array;
}

/** Arrays that grow, and are used again for the next tile. */
export class MeshArrays {
  private positions = new Float32Array(3 * 8192);
  private normals = new Int8Array(4 * 8192);
  private indices = new Uint32Array(3 * 16384);
  private lines = new Float32Array(6 * 4096);
  private vertices = 0;
  private corners = 0;
  private points = 0;

  clear(): void {
    this.vertices = this.corners = this.points = 0;
  }
  made(): TileMesh {
    return {
      positions: this.positions.slice(0, 3 * this.vertices),
      normals: this.normals.slice(0, 4 * this.vertices),
      indices: this.indices.slice(0, this.corners),
      lines: this.lines.slice(0, this.points),
    };
  }

  /** Another tile behind what is there. */
  add({ positions: p, normals: n, indices, lines }: TileMesh): void {
    const first = this.vertices;
    for (let v = 0; 3 * v < p.length; v++) {
      const at = this.vertex(p[3 * v], p[3 * v + 1], p[3 * v + 2], 0, 0, 0);
      for (let i = 0; i < 3; i++) this.normals[4 * at + i] = n[4 * v + i];
    }
    for (let i = 0; i < indices.length; i += 3)
      this.triangle(first + indices[i], first + indices[i + 1], first + indices[i + 2]);
    while (this.points + lines.length > this.lines.length) this.lines = grown(this.lines);
    this.lines.set(lines, this.points);
    this.points += lines.length;
  }

  vertex(x: number, y: number, z: number, nx: number, ny: number, nz: number): number {
    const at = this.vertices++;
    if (3 * at + 3 > this.positions.length) {
      this.positions = grown(this.positions);
      this.normals = grown(this.normals);
    }
    this.positions[3 * at] = x;
    this.positions[3 * at + 1] = y;
    this.positions[3 * at + 2] = z;
    this.normals[4 * at] = Math.round(127 * nx);
    this.normals[4 * at + 1] = Math.round(127 * ny);
    this.normals[4 * at + 2] = Math.round(127 * nz);
    return at;
  }
  /** At the same place, or at another height, with another normal. */
  copy(vertex: number, z: number | null, nx: number, ny: number, nz: number): number {
    const p = this.positions;
    return this.vertex(p[3 * vertex], p[3 * vertex + 1], z ?? p[3 * vertex + 2], nx, ny, nz);
  }
  triangle(a: number, b: number, c: number): void {
    if (this.corners + 3 > this.indices.length) this.indices = grown(this.indices);
    this.indices[this.corners++] = a;
    this.indices[this.corners++] = b;
    this.indices[this.corners++] = c;
  }
  two(a: number, b: number, c: number, d: number): void {
    this.triangle(a, b, c);
    this.triangle(a, c, d);
  }
  plate(x0: number, y0: number, x1: number, y1: number, z: number, up: 1 | -1): void {
    const a = this.vertex(x0, y0, z, 0, 0, up);
    const b = this.vertex(x1, y0, z, 0, 0, up);
    const c = this.vertex(x1, y1, z, 0, 0, up);
    const d = this.vertex(x0, y1, z, 0, 0, up);
    if (up > 0) this.two(a, b, c, d);
    else this.two(d, c, b, a);
  }
  line_if(a: number, b: number, is_drawn: boolean): void {
    if (!is_drawn) return;
    if (this.points + 6 > this.lines.length) this.lines = grown(this.lines);
    for (const vertex of [a, b])
      for (let i = 0; i < 3; i++) this.lines[this.points++] = this.positions[3 * vertex + i];
  }
  /** Whether a triangle faces a way of the plane; one without area faces none. */
  faces(a: number, b: number, c: number, x: number, y: number): boolean {
    const p = this.positions;
    const from = (v: number, w: number, i: number): number => p[3 * v + i] - p[3 * w + i];
    const nx = from(b, a, 1) * from(c, a, 2) - from(b, a, 2) * from(c, a, 1);
    const ny = from(b, a, 2) * from(c, a, 0) - from(b, a, 0) * from(c, a, 2);
    return nx * x + ny * y > 0;
  }
}

/** Twice as long. */
function grown<T extends Float32Array | Int8Array | Uint32Array>(from: T): T {
  const to = new (from.constructor as new (length: number) => T)(2 * from.length);
  to.set(from);
  return to;
}

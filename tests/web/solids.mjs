// Solids as STL files, for designs that parts are compared with.

/** Lines from corner to corner, counterclockwise in (Y, Z), from x0 to x1. */
export function bar(outline, x0, x1) {
  const n = outline.length;
  const points = [x0, x1].flatMap((x) => outline.map(([y, z]) => [x, y, z]));
  const sides = outline.flatMap((_, i) => {
    const k = (i + 1) % n;
    return [
      [i, n + k, n + i],
      [i, k, n + k],
    ];
  });
  const ends = ears(outline).flatMap(([a, b, c]) => [
    [c, b, a],
    [n + a, n + b, n + c],
  ]);
  return stl(points, [...sides, ...ends]);
}

/** Corners (Z, radius) from low to high Z, without those on the axis, turned about Z. */
export function turned(outline, sides = 360) {
  const points = [
    [0, 0, outline[0][0]],
    [0, 0, outline.at(-1)[0]],
  ];
  for (const [z, radius] of outline)
    for (let k = 0; k < sides; k++) {
      const angle = (2 * Math.PI * k) / sides;
      points.push([radius * Math.cos(angle), radius * Math.sin(angle), z]);
    }
  const last = 2 + (outline.length - 1) * sides;
  const triangles = [];
  for (let k = 0; k < sides; k++) {
    const n = (k + 1) % sides;
    triangles.push([0, 2 + n, 2 + k], [1, last + k, last + n]);
    for (let ring = 2; ring < last; ring += sides)
      triangles.push(
        [ring + k, ring + n, ring + sides + n],
        [ring + k, ring + sides + n, ring + sides + k],
      );
  }
  return stl(points, triangles);
}

function stl(points, triangles) {
  const file = Buffer.alloc(84 + 50 * triangles.length);
  file.writeUInt32LE(triangles.length, 80);
  triangles.forEach((triangle, i) => {
    const numbers = triangle.flatMap((corner) => points[corner]);
    numbers.forEach((value, k) => file.writeFloatLE(value, 84 + 50 * i + 12 + 4 * k));
  });
  return file;
}

/** Triangles of a polygon: one corner after the other is cut off that holds no other one. */
function ears(outline) {
  const turn = (a, b, c) =>
    (outline[b][0] - outline[a][0]) * (outline[c][1] - outline[a][1]) -
    (outline[b][1] - outline[a][1]) * (outline[c][0] - outline[a][0]);
  const holds = ([a, b, c], p) => turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  const left = outline.map((_, i) => i);
  const triangles = [];
  while (left.length > 2) {
    const at = left.findIndex((b, i) => {
      const ear = [left.at(i - 1), b, left[(i + 1) % left.length]];
      return turn(...ear) > 0 && !left.some((p) => !ear.includes(p) && holds(ear, p));
    });
    triangles.push([left.at(at - 1), left[at], left[(at + 1) % left.length]]);
    left.splice(at, 1);
  }
  return triangles;
}

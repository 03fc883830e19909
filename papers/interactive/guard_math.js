// Where a sweep first lays a triangle over finished ones. A mesh is {positions, triangles}, its triangles
// in the order they were laid.

const subtract = (a, b) => a.map((x, k) => x - b[k]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

// A triangle's corners, unit normal, middle and how far it reaches from there.
export function triangleOf({ positions, triangles }, t) {
  const p = triangles[t].map((v) => positions[v]), middle = [0, 1, 2].map((k) => (p[0][k] + p[1][k] + p[2][k]) / 3);
  return { p, middle, normal: unit(cross(subtract(p[1], p[0]), subtract(p[2], p[0]))),
    radius: Math.max(...p.map((x) => Math.hypot(...subtract(x, middle)))) };
}

// Whether two triangles that face the same way overlap, seen along the middle of their normals: no line
// along an edge of one has them on either side. Touching is no overlap.
export function overlap(a, b) {
  if (dot(a.normal, b.normal) <= 0) return false;
  const normal = unit(a.normal.map((x, k) => x + b.normal[k])), slack = 1e-6 * Math.min(a.radius, b.radius);
  return [[a, b], [b, a]].every(([one, other]) => [0, 1, 2].every((k) => {
    const outwards = unit(cross(subtract(one.p[(k + 1) % 3], one.p[k]), normal));
    return Math.min(...other.p.map((x) => dot(outwards, subtract(x, one.p[k])))) < -slack;
  }));
}

// The first triangle that overlaps earlier ones, with all of these: {triangle, over}; or null.
//
// Triangles are small against the length scale, so those this near that face the same way lie on one sheet.
export function firstOverlap(mesh) {
  const laid = [];
  for (let t = 0; t < mesh.triangles.length; ++t) {
    const a = triangleOf(mesh, t), over = [];
    laid.forEach((b, s) => {
      const [x, y, z] = [a.middle[0] - b.middle[0], a.middle[1] - b.middle[1], a.middle[2] - b.middle[2]];
      if (x * x + y * y + z * z < (a.radius + b.radius) ** 2 && overlap(a, b)) over.push(s);
    });
    if (over.length) return { triangle: t, over };
    laid.push(a);
  }
  return null;
}

// How many triangles two sweeps have in common at their start.
export function commonStart(one, other) {
  const corners = ({ positions, triangles }, t) => triangles[t]?.map((v) => positions[v].join()).join(' ');
  let t = 0;
  while (one.triangles[t] && corners(one, t) === corners(other, t)) ++t;
  return t;
}

// Edges that only one of the first `count` triangles has: the front.
export function frontEdges({ triangles }, count) {
  const open = new Map();
  for (const t of triangles.slice(0, count)) {
    for (let k = 0; k < 3; ++k) {
      const [a, b] = [t[k], t[(k + 1) % 3]], back = `${b} ${a}`;
      if (!open.delete(back)) open.set(`${a} ${b}`, [a, b]);
    }
  }
  return [...open.values()];
}

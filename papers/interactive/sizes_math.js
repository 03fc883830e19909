// The two size conditions (section 2.2) and the window of the tangent disk (4.2), at rho = 1 where
// lengths have no other unit.

const degrees = 180 / Math.PI;

export const angleBound = (Q) => Math.asin(1 / (Q * Q)) * degrees;

// Whether no insertion makes an edge that [L] forbids, and whether [U] makes a dense sample.
export const ends = (C, Q) => Q * Q > 2 + 4 * C * Q;
export const isDense = (C, Q) => C * Q <= 0.215;
export const smallestQ = (C) => 2 * C + Math.sqrt(4 * C * C + 2);

// Half an edge at a departure vertex, and the disk's radius: the least and the most of each.
export function window(C, Q) {
  const most = (C * Q) / (1 + 2 * C * Q);
  return {
    half: [C / (Q - 2 * C), most],
    disk: [(2 * C) / (Q - 2 * C), 2 * most * Math.sqrt(1 - most * most)],
    asPrinted: ((C * Q) / (1 + 2 * C * Q) ** 2) * Math.sqrt((1 + C * Q) * (1 + 3 * C * Q)),
  };
}

// The radii with which a fan triangle of an angle keeps [L] and [U]: with a constant length scale,
// or with one that changes as fast as it may along the sides, `fall` 1.
export function fanWindow(C, Q, angle, fall) {
  const half = angle / degrees / 2, third = Math.sin(half), wide = 2 * C * Q * Math.cos(half);
  const least = (share) => C / Q / (share - (fall * C) / Q);
  return [Math.max(least(0.5), least(third)), wide / (1 + fall * wide)];
}

const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

// [L] of each edge and [U] of a triangle with corners {x, rho}: half lengths and circumradius with
// their bounds. Edge k lies opposite corner k. Ratios as the program has them: [L] is kept above 1,
// [U] below 1.
export function measure(corners, C, Q) {
  const edges = [0, 1, 2].map((k) => {
    const a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
    const length = distance(a.x, b.x), bound = (C / Q) * Math.max(a.rho, b.rho);
    return { length, half: length / 2, bound, ratio: length / 2 / bound };
  });
  const [a, b, c] = edges.map(({ length }) => length);
  const s = (a + b + c) / 2, area = Math.sqrt(Math.max(0, s * (s - a) * (s - b) * (s - c)));
  const radius = (a * b * c) / (4 * area), bound = C * Q * Math.min(...corners.map(({ rho }) => rho));
  const angles = [0, 1, 2].map((k) => {
    const [p, q, r] = [edges[k], edges[(k + 1) % 3], edges[(k + 2) % 3]].map(({ length }) => length);
    return Math.acos(Math.max(-1, Math.min(1, (q * q + r * r - p * p) / (2 * q * r)))) * degrees;
  });
  return { edges, radius, bound, ratio: radius / bound, angles };
}

export function circumcentre([a, b, c]) {
  const d = 2 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  const square = (p) => (p[0] - a[0]) ** 2 + (p[1] - a[1]) ** 2;
  const p = square(b), q = square(c);
  return [a[0] + ((c[1] - a[1]) * p - (b[1] - a[1]) * q) / d,
    a[1] + ((b[0] - a[0]) * q - (c[0] - a[0]) * p) / d];
}

// The Morse-Smale complex of a smooth function on the torus, the unit square with its opposite sides
// glued, and what section 3.2 does with it: cancellation of a saddle with an extremum.
//
// A function is given by its waves {m, n, height, shift}. A complex is {points, arcs, cancelled}: points
// {x, value, index} stay when they are cancelled, arcs do not. An arc leads from a saddle to an extremum
// of index `kind`, 0 down or 2 up. Its line is in the plane that covers the torus; the first `own` of its
// points were traced, the others lie along arcs of the cancelled saddles `over`.

const turn = 2 * Math.PI;

// Value, gradient and second derivatives [xx, xy, yy] at x.
export function evaluate(waves, [x, y]) {
  const at = { value: 0, gradient: [0, 0], second: [0, 0, 0] };
  for (const { m, n, height, shift } of waves) {
    const phase = turn * (m * x + n * y) + shift;
    const cosine = height * Math.cos(phase), sine = height * Math.sin(phase) * turn;
    at.value += cosine;
    at.gradient[0] -= m * sine;
    at.gradient[1] -= n * sine;
    [m * m, m * n, n * n].forEach((square, k) => { at.second[k] -= square * turn * turn * cosine; });
  }
  return at;
}

// A landscape of all waves up to a frequency, the same for a seed; long waves are higher.
export function waves(seed, most = 2) {
  let state = seed;
  const random = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  for (let k = 0; k < 8; ++k) random();
  const made = [];
  for (let m = 0; m <= most; ++m) {
    for (let n = m === 0 ? 1 : -most; n <= most; ++n) {
      const height = (0.4 + 0.6 * random()) / (m * m + n * n) ** 0.6;
      made.push({ m, n, height, shift: turn * random() });
    }
  }
  return made;
}

// From a to the nearest image of b.
const towards = (a, b) => [0, 1].map((k) => b[k] - a[k] - Math.round(b[k] - a[k]));
const inSquare = (x) => x.map((c) => c - Math.floor(c));

// Newton's method for a zero of the gradient; undefined where it does not end.
function stationary(f, x) {
  for (let step = 0; step < 40; ++step) {
    const { gradient: [gx, gy], second: [xx, xy, yy] } = evaluate(f, x);
    const det = xx * yy - xy * xy;
    const d = [(xy * gy - yy * gx) / det, (xy * gx - xx * gy) / det], length = Math.hypot(...d);
    if (!Number.isFinite(length)) return undefined;
    const share = Math.min(1, 0.05 / length);
    x = x.map((c, k) => c + share * d[k]);
    if (length < 1e-13) return inSquare(x);
  }
  return undefined;
}

// All critical points, from a grid of starts. Throws where they do not add up to the torus's Euler
// characteristic 0: then one was missed.
export function criticalPoints(f, starts = 48) {
  const found = [];
  for (let i = 0; i < starts * starts; ++i) {
    const x = stationary(f, [(i % starts) / starts, Math.floor(i / starts) / starts]);
    if (!x || found.some((p) => Math.hypot(...towards(p.x, x)) < 1e-7)) continue;
    const { value, second: [xx, xy, yy] } = evaluate(f, x);
    found.push({ x, value, index: xx * yy < xy * xy ? 1 : xx > 0 ? 0 : 2 });
  }
  found.sort((p, q) => p.value - q.value);
  if (euler(found) !== 0) throw new Error('a critical point was missed');
  return found;
}

export const euler = (points) => points.reduce((sum, { index }) => sum + (index === 1 ? -1 : 1), 0);

const nearEnd = 0.002;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1];

function slope(f, x) {
  const { gradient } = evaluate(f, x), norm = Math.hypot(...gradient);
  return gradient.map((g) => g / norm);
}

// One step of order four along the direction of the gradient, up or down.
function stepped(f, x, length) {
  const from = (d, share) => x.map((c, k) => c + share * length * d[k]);
  const a = slope(f, x), b = slope(f, from(a, 0.5)), c = slope(f, from(b, 0.5)), d = slope(f, from(c, 1));
  return x.map((s, k) => s + (length * (a[k] + 2 * b[k] + 2 * c[k] + d[k])) / 6);
}

// A step that goes the right way and bends little, as long as may be; undefined where there is none.
function goodStep(f, x, sign, most) {
  const { value } = evaluate(f, x), before = slope(f, x);
  for (let length = most; length > 1e-9; length /= 2) {
    const next = stepped(f, x, sign * length);
    if (sign * (evaluate(f, next).value - value) > 0 && dot(before, slope(f, next)) > 0.995) return next;
  }
  return undefined;
}

// The integral line from a saddle along a direction: {end, line}. Rises (kind 2) or falls (0) strictly.
function integralLine(f, points, saddle, direction, kind, step) {
  const line = [points[saddle].x];
  let x = line[0].map((c, k) => c + 0.25 * step * direction[k]);
  while (x && line.length < 20000) {
    line.push(x);
    const end = points.findIndex((p) => p.index === kind && Math.hypot(...towards(x, p.x)) < nearEnd);
    if (end >= 0) {
      const last = towards(x, points[end].x);
      line.push(x.map((c, k) => c + last[k]));
      return { end, line };
    }
    x = goodStep(f, x, kind - 1, step);
  }
  throw new Error('an integral line does not end');
}

// Along which the function curves the most downwards (kind 0) or upwards (2), a unit vector.
function curvedMost([xx, xy, yy], kind) {
  const middle = (xx + yy) / 2, far = Math.hypot((xx - yy) / 2, xy);
  const value = middle + (kind - 1) * far;
  const one = [xy, value - xx], other = [value - yy, xy];
  const best = Math.hypot(...one) > Math.hypot(...other) ? one : other;
  return best.map((c) => c / Math.hypot(...best));
}

// With steps of at most this length along its lines.
export function complexOf(f, step = 0.004) {
  const points = criticalPoints(f), arcs = [];
  points.forEach(({ x, index }, saddle) => {
    if (index !== 1) return;
    for (const kind of [0, 2]) {
      const direction = curvedMost(evaluate(f, x).second, kind);
      for (const sign of [1, -1]) {
        const { end, line } = integralLine(f, points, saddle, direction.map((c) => sign * c), kind, step);
        arcs.push({ saddle, end, kind, line, own: line.length, over: [] });
      }
    }
  });
  return { points, arcs, cancelled: [] };
}

export const isLeft = ({ cancelled }, p) => !cancelled.some(({ saddle, extremum }) => saddle === p || extremum === p);
export const counts = (complex) => [0, 1, 2].map((index) =>
  complex.points.filter((p, i) => p.index === index && isLeft(complex, i)).length);

// The other arc of the same saddle to the same kind of extremum.
export const twin = ({ arcs }, arc) => arcs.find((other) => other !== arc && other.saddle === arc.saddle && other.kind === arc.kind);
const isLoop = (complex, arc) => twin(complex, arc).end === arc.end;
// Whether p comes before q for this kind: lower for minima, higher for maxima; ties fall by place.
const isBefore = (points, p, q, kind) => (kind - 1) * (points[p].value - points[q].value || p - q) > 0;

// Why the saddle and the extremum of an arc may not be cancelled: {why, ...}, or null if they may. With
// `byDistance` as section 3.2 prints it, where only a loop stands in the way; else by erratum 11.
export function refusal(complex, arc, byDistance = false) {
  const { points, arcs } = complex, { saddle: a, end: b, kind } = arc, { end: c } = twin(complex, arc);
  if (b === c) return { why: 'loop' };
  if (byDistance) return null;
  if (isBefore(points, b, c, kind)) return { why: 'elder' };
  const inner = arcs.filter((other) => other.end === b && other.saddle !== a && !isLoop(complex, other)
    && isBefore(points, other.saddle, a, kind));
  const nearest = (best, other) => (isBefore(points, other.saddle, best.saddle, kind) ? other : best);
  return inner.length ? { why: 'inner', inner: inner.reduce(nearest) } : null;
}

// A line that goes on along another, which begins where it ends on the torus.
function joined(line, next) {
  const end = line.at(-1), shift = next[0].map((c, k) => Math.round(end[k] - c));
  return [...line, ...next.slice(1).map((x) => x.map((c, k) => c + shift[k]))];
}

// The complex without the arc's saddle and extremum: arcs to the extremum go on to the saddle's other
// one. Before: the arc is no loop.
export function cancel(complex, arc) {
  const { saddle, end } = arc, other = twin(complex, arc);
  const bridge = joined([...arc.line].reverse(), other.line);
  const arcs = complex.arcs.filter((kept) => kept.saddle !== saddle).map((kept) => (kept.end !== end ? kept
    : { ...kept, end: other.end, line: joined(kept.line, bridge), over: [...kept.over, ...arc.over, saddle, ...other.over] }));
  return { ...complex, arcs, cancelled: [...complex.cancelled, { saddle, extremum: end }] };
}

// Whether an arc passes over a saddle beyond its own: no function near has such an arc. Loops may.
export function isImpossible(complex, arc) {
  const { points } = complex, { saddle, end, kind, over } = arc;
  if (isLoop(complex, arc)) return false;
  return !isBefore(points, end, saddle, kind) || over.some((other) => isBefore(points, saddle, other, kind));
}

// Persistence pairs {saddle, extremum, kind, persistence} of what is left: as the level passes a saddle
// that joins two parts, the part with the younger extremum ends.
export function persistencePairs({ points, arcs }) {
  const pairs = [];
  for (const kind of [0, 2]) {
    const eldest = points.map((_, p) => p);
    const find = (p) => (eldest[p] === p ? p : find(eldest[p]));
    const saddles = [...new Set(arcs.map(({ saddle }) => saddle))].sort((p, q) => (isBefore(points, p, q, kind) ? -1 : 1));
    for (const saddle of saddles) {
      const [p, q] = arcs.filter((arc) => arc.saddle === saddle && arc.kind === kind).map(({ end }) => find(end));
      if (p === q) continue;
      const [elder, younger] = isBefore(points, p, q, kind) ? [p, q] : [q, p];
      eldest[younger] = elder;
      pairs.push({ saddle, extremum: younger, kind, persistence: Math.abs(points[saddle].value - points[younger].value) });
    }
  }
  return pairs.sort((p, q) => p.persistence - q.persistence);
}

// The arc between the least persistent pair, or undefined when no pair is left.
export function leastPersistent(complex) {
  const [pair] = persistencePairs(complex);
  return pair && complex.arcs.find(({ saddle, end }) => saddle === pair.saddle && end === pair.extremum);
}

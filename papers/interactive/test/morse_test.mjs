// The Morse-Smale complex on the torus: laws of the lines, of cancellation and of its refusals.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as morse from '../morse_math.js';

const seeds = Array.from({ length: 8 }, (_, k) => k + 1);
// In the one of seed 23 a loop is lower than another saddle of its minimum.
const landscapes = [...[...seeds, 23].map((seed) => morse.waves(seed)), morse.waves(2, 3), morse.waves(5, 3)];
const complexes = landscapes.map((f) => ({ f, complex: morse.complexOf(f) }));
const gap = (a, b) => Math.hypot(...a.map((c, k) => b[k] - c - Math.round(b[k] - c)));

// Any sequence of arcs that may be cancelled, one of them at each step, until there is none.
function* cancellations(complex, byDistance = false) {
  for (let n = 0; ; ++n) {
    const allowed = complex.arcs.filter((arc) => morse.refusal(complex, arc, byDistance) === null);
    if (!allowed.length) return;
    const arc = allowed[(7 * n + 3) % allowed.length], after = morse.cancel(complex, arc);
    yield { before: complex, arc, after };
    complex = after;
  }
}

test('gradient and second derivatives are those of differences', () => {
  const e = 1e-5;
  for (const f of landscapes) {
    const x = [0.37, 0.81], at = morse.evaluate(f, x);
    const [right, left] = [[e, 0], [-e, 0]].map((d) => morse.evaluate(f, x.map((c, k) => c + d[k])));
    const [up, down] = [[0, e], [0, -e]].map((d) => morse.evaluate(f, x.map((c, k) => c + d[k])));
    const near = (ours, theirs) => assert.ok(Math.abs(ours - theirs) < 1e-5 * (1 + Math.abs(ours)), `${ours}, ${theirs}`);
    near(at.gradient[0], (right.value - left.value) / (2 * e));
    near(at.gradient[1], (up.value - down.value) / (2 * e));
    near(at.second[0], (right.gradient[0] - left.gradient[0]) / (2 * e));
    near(at.second[1], (right.gradient[1] - left.gradient[1]) / (2 * e));
    near(at.second[2], (up.gradient[1] - down.gradient[1]) / (2 * e));
  }
});

// Down (sign -1) or up the gradient from x in shrinking steps, until it is nearly 0.
function followed(f, x, sign) {
  for (let length = 0.01, at = morse.evaluate(f, x); length > 1e-12;) {
    const norm = Math.hypot(...at.gradient), y = x.map((c, k) => c + (sign * length * at.gradient[k]) / norm);
    const next = morse.evaluate(f, y);
    if (sign * (next.value - at.value) > 0) [x, at, length] = [y, next, 1.2 * length];
    else length /= 2;
  }
  return x;
}

test('minima less saddles plus maxima are 0, and from all low and high places of a grid one comes to them', () => {
  const n = 100;
  for (const { f, complex } of complexes) {
    const [minima, saddles, maxima] = morse.counts(complex);
    assert.equal(minima - saddles + maxima, 0);
    for (const { x } of complex.points) assert.ok(Math.hypot(...morse.evaluate(f, x).gradient) < 1e-9);
    const value = Array.from({ length: n * n }, (_, i) => morse.evaluate(f, [(i % n) / n, Math.floor(i / n) / n]).value);
    const at = (i, j) => value[((j + n) % n) * n + ((i + n) % n)];
    const around = [-1, 0, 1].flatMap((a) => [-1, 0, 1].map((b) => [a, b])).filter(([a, b]) => a || b);
    for (const index of [0, 2]) {
      const sign = index - 1, met = new Set();
      for (let i = 0; i < n * n; ++i) {
        const [a, b] = [i % n, Math.floor(i / n)];
        if (!around.every(([c, d]) => sign * (at(a, b) - at(a + c, b + d)) > 0)) continue;
        const x = followed(f, [a / n, b / n], sign);
        const end = complex.points.findIndex((p) => p.index === index && gap(p.x, x) < 1e-4);
        assert.ok(end >= 0, `index ${index}: ${x}`);
        met.add(end);
      }
      assert.equal(met.size, morse.counts(complex)[index]);
    }
  }
});

test('every saddle has two arcs down and two up, along which the function falls and rises strictly', () => {
  for (const { f, complex } of complexes) {
    complex.points.forEach(({ index }, p) => {
      const kinds = complex.arcs.filter(({ saddle }) => saddle === p).map(({ kind }) => kind).sort();
      assert.deepEqual(kinds, index === 1 ? [0, 0, 2, 2] : []);
    });
    for (const { saddle, end, kind, line } of complex.arcs) {
      assert.equal(complex.points[end].index, kind);
      assert.ok(gap(line[0], complex.points[saddle].x) < 1e-12);
      assert.ok(gap(line.at(-1), complex.points[end].x) < 1e-12);
      const values = line.map((x) => morse.evaluate(f, x).value);
      for (let k = 1; k < values.length; ++k) {
        assert.ok((kind - 1) * (values[k] - values[k - 1]) > 0, `${k} of ${values.length}`);
      }
    }
  }
});

test('four times smaller steps lead to the same extrema, along the same lines', () => {
  for (const { f, complex } of complexes) {
    const fine = morse.complexOf(f, 0.001);
    complex.arcs.forEach(({ saddle, end, line }, n) => {
      const reference = fine.arcs[n];
      assert.deepEqual([reference.saddle, reference.end], [saddle, end]);
      for (const x of line) {
        const far = Math.min(...reference.line.map((y) => Math.hypot(y[0] - x[0], y[1] - x[1])));
        assert.ok(far < 0.002, `arc ${n}: ${far}`);
      }
    });
  }
});

// Those to one extremum come closer to each other than the error of any step.
test('arcs to different extrema do not cross', () => {
  const side = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const crosses = ([a, b], [c, d]) => side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  for (const { complex } of complexes) {
    const pieces = complex.arcs.flatMap(({ line, end }) => line.slice(1).map((x, k) => {
      const shift = line[k].map(Math.floor);
      return { end, ends: [line[k], x].map((y) => y.map((c, i) => c - shift[i])) };
    })).sort((a, b) => a.ends[0][0] - b.ends[0][0]);
    for (let i = 0; i < pieces.length; ++i) {
      for (let j = i + 1; j < pieces.length; ++j) {
        const [a, b] = [pieces[i], pieces[j]];
        if (b.ends[0][0] - a.ends[0][0] > 0.01) break; // none is longer
        assert.ok(a.end === b.end || !crosses(a.ends, b.ends), `${a.ends} and ${b.ends}`);
      }
    }
  }
});

test('a cancellation takes a saddle and an extremum, so the sum stays, and leaves a sound complex', () => {
  for (const { complex } of complexes) {
    for (const byDistance of [false, true]) {
      let last = complex;
      for (const { before, arc, after } of cancellations(complex, byDistance)) {
        const [old, now] = [before, after].map(morse.counts), taken = [0, 0, 0];
        ++taken[1];
        ++taken[arc.kind];
        assert.deepEqual(now, old.map((n, k) => n - taken[k]));
        assert.equal(after.arcs.length, 4 * now[1]);
        for (const { saddle, end, line } of after.arcs) {
          assert.ok(morse.isLeft(after, saddle) && morse.isLeft(after, end));
          assert.ok(gap(line[0], after.points[saddle].x) < 1e-9 && gap(line.at(-1), after.points[end].x) < 1e-9);
          for (let k = 1; k < line.length; ++k) {
            assert.ok(Math.hypot(line[k][0] - line[k - 1][0], line[k][1] - line[k - 1][1]) < 0.02);
          }
        }
        last = after;
      }
      assert.deepEqual(morse.counts(last), [1, 2, 1]);
    }
  }
});

test('by distance alone an arc is refused exactly when both lines of its saddle end at one extremum', () => {
  let refused = 0;
  for (const { complex } of complexes) {
    for (const state of [complex, ...[...cancellations(complex, true)].map(({ after }) => after)]) {
      for (const arc of state.arcs) {
        const same = state.arcs.filter(({ saddle, end }) => saddle === arc.saddle && end === arc.end).length === 2;
        assert.equal(morse.refusal(state, arc, true)?.why === 'loop', same);
        assert.equal(morse.refusal(state, arc, true) !== null, same);
        refused += same;
      }
    }
  }
  assert.ok(refused > 100);
});

test('by erratum 11 no line ever passes a saddle beyond its own; by distance alone some do', () => {
  let impossible = 0;
  for (const { f, complex } of complexes) {
    for (const { after } of cancellations(complex)) {
      for (const arc of after.arcs) {
        assert.ok(!morse.isImpossible(after, arc));
        assert.ok((arc.kind - 1) * (after.points[arc.end].value - after.points[arc.saddle].value) > 0);
      }
    }
    for (const { after } of cancellations(complex, true)) {
      for (const arc of after.arcs.filter((one) => morse.twin(after, one).end !== one.end)) {
        const back = arc.line.map((x) => (arc.kind - 1) * (after.points[arc.saddle].value - morse.evaluate(f, x).value));
        assert.equal(morse.isImpossible(after, arc), Math.max(...back) > 1e-9);
        impossible += morse.isImpossible(after, arc);
      }
    }
  }
  assert.ok(impossible > 25, `${impossible}`);
});

test('what may be cancelled is a persistence pair, and to cancel it changes no other pair', () => {
  const named = (pairs) => pairs.map(({ saddle, extremum }) => `${saddle} ${extremum}`).sort();
  for (const { complex } of complexes) {
    for (const { before, arc, after } of cancellations(complex)) {
      const pairs = named(morse.persistencePairs(before)), pair = `${arc.saddle} ${arc.end}`;
      assert.ok(pairs.includes(pair));
      assert.deepEqual(named(morse.persistencePairs(after)), pairs.filter((name) => name !== pair));
    }
  }
});

test('the least persistent pair may always be cancelled, until all that is left are loops', () => {
  for (let { complex } of complexes) {
    for (let arc = morse.leastPersistent(complex); arc; arc = morse.leastPersistent(complex)) {
      assert.equal(morse.refusal(complex, arc), null);
      complex = morse.cancel(complex, arc);
    }
    assert.deepEqual(morse.counts(complex), [1, 2, 1]);
    assert.ok(complex.arcs.every((arc) => morse.refusal(complex, arc).why === 'loop'));
  }
});

// The part of a grid below (or above) the level of an arc's saddle that its extremum lies in.
function flooded(f, sign, level, start, n = 240) {
  const isIn = new Map(), queue = [start.map((c) => Math.round(c * n))];
  const key = ([i, j]) => ((j % n + n) % n) * n + ((i % n + n) % n);
  while (queue.length) {
    const at = queue.pop();
    if (isIn.has(key(at)) || sign * (morse.evaluate(f, at.map((c) => c / n)).value - level) >= 0) continue;
    isIn.set(key(at), true);
    for (const d of [[1, 0], [-1, 0], [0, 1], [0, -1]]) queue.push(at.map((c, k) => c + d[k]));
  }
  return (x) => [0, 1].flatMap((a) => [0, 1].map((b) => [Math.floor(x[0] * n) + a, Math.floor(x[1] * n) + b]))
    .some((place) => isIn.has(key(place)));
}

test('an arc is refused for an inner saddle exactly when the puddle of its extremum has joined another before', () => {
  for (const { f, complex } of complexes.filter(({ complex: { points } }) => {
    const values = points.filter(({ index }) => index === 1).map(({ value }) => value);
    return values.every((v, k) => k === 0 || v - values[k - 1] > 0.02); // else the grid is too coarse to tell
  }).slice(0, 5)) {
    for (const arc of complex.arcs) {
      const { points } = complex, { saddle, end, kind } = arc, other = morse.twin(complex, arc).end;
      const isIn = flooded(f, kind === 0 ? 1 : -1, points[saddle].value + (kind === 0 ? -0.003 : 0.003), points[end].x);
      const joined = points.some((p, k) => p.index === kind && k !== end && isIn(p.x));
      const refusal = morse.refusal(complex, arc);
      if (other === end) assert.equal(refusal.why, 'loop');
      else if ((kind - 1) * (points[end].value - points[other].value) > 0) assert.equal(refusal.why, 'elder');
      else assert.equal(refusal?.why === 'inner', joined);
    }
  }
});

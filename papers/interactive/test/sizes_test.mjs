// C and Q against the program's reports and notes, and the table of papers/4.2-curvature-adaptation.md.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import * as sizes from '../sizes_math.js';
import { mesh } from './program.mjs';

const dumbbell = [{ z: [-1, 0, 0], w: 2 }, { z: [1, 0, 0], w: 2 }];

test('[L], [U] and the smallest angle of a mesh are those of the program’s report', () => {
  for (const [C, Q] of [[0.08, 1.65], [0.1, 1.5], [0.15, 1.8]]) {
    const made = mesh(dumbbell, '-C', C, '-Q', Q);
    const all = made.triangles.map((t) => sizes.measure(t.map((v) =>
      ({ x: made.positions[v], rho: made.scales[v] })), C, Q));
    const near = (ours, theirs) => assert.ok(Math.abs(ours - theirs) < 1e-9 * theirs, `${ours}, ${theirs}`);
    near(Math.min(...all.flatMap(({ edges }) => edges.map(({ ratio }) => ratio))), made.report.worst_L);
    near(Math.max(...all.map(({ ratio }) => ratio)), made.report.worst_U);
    near(Math.min(...all.flatMap(({ angles }) => angles)), made.report.min_angle_deg);
  }
});

test('where refinement may not end, or the sample is not dense, the program says so', () => {
  for (const [C, Q] of [[0.08, 1.65], [0.08, 1.57], [0.08, 1.59], [0.13, 1.65], [0.13, 1.7], [0.2, 1.9]]) {
    const { said } = mesh(dumbbell, '-C', C, '-Q', Q);
    assert.equal(sizes.ends(C, Q), !/Q\^2 is not above/.test(said), `${C}, ${Q}: ${said}`);
    // It says so only where the mesh is otherwise as the theory wants it.
    if (/is above 0.215/.test(said)) assert.ok(!sizes.isDense(C, Q), `${C}, ${Q}: ${said}`);
    if (sizes.isDense(C, Q)) assert.ok(!/is above 0.215/.test(said));
  }
});

test('the windows of fans are those of the course’s table, and the disk’s is 0.107 to 0.208', () => {
  const page = readFileSync(new URL('../../4.2-curvature-adaptation.md', import.meta.url), 'utf8');
  const row = (name) => page.match(new RegExp(`^\\| ${name} \\|(.*)\\|$`, 'm'))[1].split('|').map((cell) => cell.trim());
  for (const [name, fall] of [['worst', 1], ['constant', 0]]) {
    const ours = [40, 45, 50, 60, 75, 90].map((angle) =>
      sizes.fanWindow(0.08, 1.65, angle, fall).map((r) => r.toFixed(3)).join(' to '));
    assert.deepEqual(ours, row(name));
  }
  const { half, disk, asPrinted } = sizes.window(0.08, 1.65);
  assert.deepEqual([...half, ...disk, asPrinted].map((x) => x.toFixed(4)),
    ['0.0537', '0.1044', '0.1074', '0.2077', '0.1039']);
});

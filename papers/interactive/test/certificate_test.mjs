// The page's conditions against the program: G, N and rho at its vertices, and `check`'s verdicts.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { certify, edits, evaluate } from '../certificate_math.js';
import { evaluate as inPlane, cellAt, mixedCells } from '../skin2d_math.js';
import { checked, mesh } from './program.mjs';

const balls = [{ z: [-1, 0, 0], w: 2 }, { z: [1, 0, 0], w: 2 }, { z: [0, 3.2, 0], w: 1.2 }];
const tetrahedron = [{ z: [1, 1, 1], w: 3.7 }, { z: [1, -1, -1], w: 4 }, { z: [-1, 1, -1], w: 3.5 },
  { z: [-1, -1, 1], w: 3.9 }];
const made = mesh(balls, '-C', '0.3');
const expected = { components: made.report.expected_components, euler: made.report.expected_euler_characteristic };

test('G is 0, and N and rho are the program’s, at the vertices of its meshes, round a void too', () => {
  for (const list of [balls, tetrahedron]) {
    const { positions, normals, scales } = mesh(list, '-C', '0.2');
    positions.forEach((x, v) => {
      const { G, N, rho } = evaluate(list, x);
      assert.ok(Math.abs(G) < 1e-10 && Math.abs(rho - scales[v]) < 1e-9, `vertex ${v}`);
      assert.ok(Math.hypot(...N.map((n, k) => n / rho - normals[v][k])) < 1e-7, `vertex ${v}`);
    });
  }
});

test('in the plane of the centres it is the plane skin’s G and N', () => {
  const discs = balls.map(({ z, w }) => ({ z: z.slice(0, 2), w })), cells = mixedCells(discs);
  for (let k = 0; k < 200; ++k) {
    const x = [3 * Math.cos(2.4 * k) * (k / 200), 3 * Math.sin(2.4 * k) * (k / 200)];
    const flat = inPlane(cellAt(cells, x), x), solid = evaluate(balls, [...x, 0]);
    assert.ok(Math.abs(flat.G - solid.G) < 1e-9 && Math.abs(flat.N[0] - solid.N[0]) < 1e-6);
  }
});

const twenty = {
  'as meshed': (m) => m,
  'one triangle turned': (m) => edits.turn(m, 3),
  'another turned': (m) => edits.turn(m, 120),
  'one dropped': (m) => edits.drop(m, 0),
  'two dropped': (m) => edits.drop(edits.drop(m, 80), 17),
  'the large component dropped': (m) => edits.dropComponent(m, 0),
  'the small component dropped': (m) => edits.dropComponent(m, m.triangles.length - 1),
  'covered twice': (m) => edits.double(m),
  'covered twice, one part of it dropped': (m) => edits.dropComponent(edits.double(m), 0),
  'inside out': (m) => edits.invert(m),
  'an edge flipped': (m) => edits.flip(m, 10),
  'another flipped': (m) => edits.flip(m, 60),
  'four flipped': (m) => [5, 30, 90, 130].reduce((n, t) => edits.flip(n, t), m),
  'a vertex slightly off': (m) => edits.move(m, 4, 0.01, balls),
  'a vertex moved in': (m) => edits.move(m, 9, -0.15, balls),
  'a vertex moved out': (m) => edits.move(m, 9, 0.2, balls),
  'a vertex far out': (m) => edits.move(m, 30, 0.8, balls),
  'a vertex slid a little': (m) => edits.slide(m, 12, 0.2, balls),
  'a vertex slid across': (m) => edits.slide(m, 12, 1.6, balls),
  'a vertex slid far and one dropped': (m) => edits.drop(edits.slide(m, 40, 1.5, balls), 2),
};

const names = { onSkin: 'vertices on the skin', upright: 'triangles face the way the skin does',
  tube: 'triangles small enough to be proved near the skin', degree: 'covers the skin once',
  counts: 'components, Euler characteristic and genus of the skin' };

test('on twenty edits all verdicts are those of check', () => {
  assert.equal(Object.keys(twenty).length, 20);
  assert.ok(made.triangles.length <= 500);
  const seen = new Set();
  for (const [what, edit] of Object.entries(twenty)) {
    const edited = edit(made), ours = certify(balls, edited, expected);
    const theirs = checked(balls, edited, '-C', '0.3');
    const verdicts = new Map(theirs.verdicts.map(({ name, holds }) => [name, holds]));
    assert.equal(ours.isHomeomorphic, theirs.homeomorphic, `${what}: ${theirs.reason}`);
    assert.equal(ours.manifold === null, theirs.closed_oriented_manifold, what);
    for (const [ourName, name] of Object.entries(names)) {
      const holds = verdicts.get(name);
      assert.equal(ours[ourName] === undefined ? undefined : ours[ourName] === null, holds, `${what}: ${name}`);
      seen.add(`${ourName} ${holds}`);
    }
  }
  // Every condition holds in one of them and is broken in another.
  for (const name of Object.keys(names)) assert.ok(seen.has(`${name} true`) && seen.has(`${name} false`), name);
});

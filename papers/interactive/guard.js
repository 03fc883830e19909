// Part (d), second half: two sweeps of one molecule, with the collision guard and without, on the triangles
// that the program laid. Where the second first lays one over finished ones is found here (guard_math.js).

import { button, check, data, element, player, question, ready, slider } from './common.js';
import { commonStart, firstOverlap, frontEdges, triangleOf } from './guard_math.js';
import { ballAround, Solid } from './solid.js';

const given = data();
const sweeps = given.sweeps.map((mesh) => ({ mesh, overlap: firstOverlap(mesh) }));
const [guarded, unguarded] = sweeps;
const apart = commonStart(guarded.mesh, unguarded.mesh);
const first = unguarded.overlap.triangle + 1; // triangles, with the one that lies over others
const most = Math.max(...sweeps.map(({ mesh }) => mesh.triangles.length));
const state = { step: apart, isPlaying: false, isNear: false, goesOn: false, apart, first };
const whole = ballAround(guarded.mesh.positions), near = triangleOf(unguarded.mesh, unguarded.overlap.triangle);

// How many of a sweep's triangles are there.
const laid = ({ mesh, overlap }) => Math.min(state.step, mesh.triangles.length, overlap && !state.goesOn ? overlap.triangle + 1 : Infinity);

function scene(sweep) {
  const { mesh, overlap } = sweep, count = laid(sweep), isLaid = overlap && count > overlap.triangle;
  const open = new Set(frontEdges(mesh, count).map((edge) => edge.join()));
  const triangles = mesh.triangles.slice(0, count), below = new Set(isLaid ? overlap.over : []);
  return { positions: mesh.positions, triangles, ...(state.isNear ? { middle: near.middle, radius: 5 * near.radius } : whole),
    colour: (t, isFront) => (isLaid && t === overlap.triangle ? [224, 98, 88] : below.has(t) ? [242, 178, 62]
      : t >= state.apart && isFront ? [168, 200, 232] : isFront ? [196, 205, 216] : [150, 140, 130]),
    mark: (t) => (isLaid ? t === overlap.triangle : t === count - 1),
    bold: (t) => [0, 1, 2].filter((k) => open.has(`${triangles[t][k]},${triangles[t][(k + 1) % 3]}`)) };
}

const solids = sweeps.map((sweep, i) => new Solid(i ? 'Without the guard' : 'With the guard', () => scene(sweep),
  { share: 1, turned: () => turnOther(i) }));
const faceIt = () => solids.forEach((solid) => solid.face(near.normal));
faceIt();

function turnOther(i) {
  solids[1 - i].turn = solids[i].turn;
  solids[1 - i].draw();
}

const notes = sweeps.map(() => element('p', { 'aria-live': 'off' }));
const steer = slider({ label: 'Triangles laid', min: 1, max: most, step: 1, value: state.step, shown: String, change: (x) => go(x) });

function note(sweep) {
  const { mesh, overlap } = sweep, count = laid(sweep), front = frontEdges(mesh, count).length;
  const facts = `${count} triangles, ${front ? `${front} edges in the front` : 'no front: closed'}. `;
  if (!overlap || count <= overlap.triangle) return [facts, element('span', { class: 'good' }, 'None lies over another.')];
  const names = `${overlap.over.length === 1 ? 'number' : 'numbers'} ${overlap.over.map((t) => t + 1).join(', ')}`;
  return [facts, element('b', { class: 'bad' }, state.goesOn ? 'It goes on over finished triangles.' : 'Stopped.'),
    ` Triangle number ${overlap.triangle + 1} (red) lies over ${names} (orange).`];
}

function show() {
  state.step = Math.max(1, Math.min(most, state.step));
  steer.set(state.step);
  sweeps.forEach((sweep, i) => {
    notes[i].replaceChildren(...note(sweep));
    solids[i].draw();
  });
}

function go(step) {
  state.isPlaying = false;
  state.step = step;
  show();
}

const closeUp = check('close up', false, (is) => {
  state.isNear = is;
  if (is) faceIt();
  show();
});

const play = player(state, 60, () => {
  if (sweeps.every((sweep) => laid(sweep) < state.step)) state.step = 1;
}, () => {
  state.step += state.isNear ? 1 : 6;
  show();
  return sweeps.some((sweep) => laid(sweep) === state.step);
});

document.getElementById('part').append(
  question('Two sweeps of cyclohexane. The second looks for collisions in protecting spheres only, as printed. What goes wrong first?', [
    { text: 'an angle gets too small', reply: 'Fans are as good as in the first sweep, and what is poor the refinement mends.' },
    { text: 'a triangle lies over another', isRight: true,
      reply: 'Far from every sphere two parts of the jagged front come close. Nobody looks, and a fan is laid over finished triangles.' },
    { text: 'a hole stays open', reply: 'Many do, but later: a front that has passed itself does not close.' },
  ]),
  element('div', { class: 'halves' },
    ...sweeps.map((_, i) => element('div', {}, element('h1', {}, i ? 'Without guard' : 'With guard'), solids[i].canvas, notes[i]))),
  steer,
  element('div', { class: 'row' }, button('‹', () => go(state.step - 1), { 'aria-label': 'one triangle less' }),
    button('›', () => go(state.step + 1), { 'aria-label': 'one triangle more' }), play,
    button('where they part', () => go(apart)), button('first overlap', () => go(first)),
    button('to the end', () => go(most)), closeUp,
    check('let the second go on', false, (is) => { state.goesOn = is; show(); })),
  element('p', { class: 'soft' }, `As swept, before refinement, C = ${given.C}. Orange edges: the front. Blue: triangles after the two sweeps part. `,
    'The page tries each triangle against all earlier ones nearby, seen along their normals. Drag to turn.'));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', show);
show();
window.part = { state, overlaps: sweeps.map(({ overlap }) => overlap), laid: () => sweeps.map(laid) };
ready();

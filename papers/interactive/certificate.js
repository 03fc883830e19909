// Part (f): spoil a mesh of a real skin and see which condition of the certificate refuses it.

import { certify, edits } from './certificate_math.js';
import { button, data, element, question, ready, slider } from './common.js';
import { ballAround, Solid } from './solid.js';

const given = data();
const start = { positions: given.positions, triangles: given.triangles };
const frame = ballAround(start.positions);
const state = { mesh: start, chosen: 0, corner: 0, result: null, history: [] };

const solid = new Solid('The mesh', () => ({
  ...state.mesh, ...frame,
  colour: (t, isFront) => (state.result.bad.has(t) ? [224, 98, 88] : isFront ? [168, 200, 232] : [214, 190, 140]),
  mark: (t) => t === state.chosen,
  points: state.mesh.triangles[state.chosen]
    ? [{ v: state.mesh.triangles[state.chosen][state.corner], colour: '#e08a00' }] : [],
}), { pick: (t, corner) => choose(t, corner) });

const conditions = [
  ['manifold', 'closed, oriented, a manifold'], ['onSkin', 'vertices on the skin (for “certified” only)'],
  ['upright', '(c1) upright: N · n > 0'], ['tube', '(c2) tube: |G| < |N|²'], ['degree', '(c3) covers the skin once'],
  ['counts', 'components and χ are the skin’s'],
];
const verdicts = element('table');
const verdict = element('p', { 'aria-live': 'polite' });
const where = element('span', { class: 'value' });

function choose(t, corner = 0) {
  const count = state.mesh.triangles.length;
  state.chosen = (t + count) % count;
  state.corner = corner;
  show();
}

function show() {
  const { result, mesh } = state;
  verdicts.replaceChildren(...conditions.map(([name, words]) => element('tr', {},
    element('th', { scope: 'row' }, words),
    element('td', { class: result[name] === null ? 'good' : result[name] === undefined ? 'soft' : 'bad' },
      result[name] === null ? 'holds' : result[name] === undefined ? 'not asked' : `broken: ${result[name]}`))));
  verdict.replaceChildren(result.isSound
    ? element('b', { class: 'good' }, 'Proved homeomorphic to the skin, with its vertices on it.')
    : result.isHomeomorphic ? element('b', { class: 'good' }, 'Proved homeomorphic, but not on the skin: no certificate.')
      : element('b', { class: 'bad' }, 'Not proved.'));
  where.textContent = `triangle ${state.chosen} of ${mesh.triangles.length}, vertex ${mesh.triangles[state.chosen][state.corner]}`;
  solid.draw();
}

function set(mesh) {
  state.mesh = mesh;
  state.result = certify(given.balls, mesh, given.expected);
  state.chosen = Math.min(state.chosen, mesh.triangles.length - 1);
  show();
}

function edit(make) {
  const made = make(state.mesh, state.chosen, state.mesh.triangles[state.chosen][state.corner]);
  if (made.triangles.length === 0 || made.triangles.length > 500) return;
  state.history.push(state.mesh);
  set(made);
}

const share = slider({ label: 'How far, over ρ', min: -0.8, max: 0.8, step: 0.01, value: 0.2, change: () => {} });
const far = () => Number(share.input.value);

document.getElementById('part').append(
  question('Lay the whole mesh a second time exactly on itself. All triangles are right, all vertices lie on the skin. Which condition notices?', [
    { text: 'closed manifold', reply: 'Each copy is one. Two surfaces in one place share no vertex.' },
    { text: '(c1) upright', reply: 'Both copies face the right way.' },
    { text: '(c2) tube', reply: 'Both copies lie near the skin.' },
    { text: '(c3) covers once', isRight: true, reply: 'Near the path through each vertex of one copy comes a triangle of the other. The count of components differs too, '
      + 'but a connected double cover of a ball can have the right counts.' },
  ]),
  element('div', { class: 'columns' },
    element('div', {}, solid.canvas, element('p', { class: 'soft' },
      'The skin of three balls, in two pieces, meshed coarsely by the program. Drag to turn, click a triangle near a corner to choose both. Red: (c1) or (c2) is not proved there.')),
    element('div', {}, verdict, verdicts,
      element('div', { class: 'row' }, button('‹', () => choose(state.chosen - 1), { 'aria-label': 'triangle before' }),
        button('›', () => choose(state.chosen + 1), { 'aria-label': 'next triangle' }),
        button('next corner', () => choose(state.chosen, (state.corner + 1) % 3)), where),
      element('div', { class: 'row' },
        button('turn it round', () => edit(edits.turn)), button('drop it', () => edit(edits.drop)),
        button('flip an edge', () => edit(edits.flip)), button('drop its component', () => edit(edits.dropComponent)),
        button('cover twice', () => edit(edits.double)), button('all inside out', () => edit(edits.invert))),
      share,
      element('div', { class: 'row' },
        button('move the vertex out', () => edit((mesh, t, v) => edits.move(mesh, v, far(), given.balls))),
        button('slide it over the skin', () => edit((mesh, t, v) => edits.slide(mesh, v, 2 * far(), given.balls)))),
      element('div', { class: 'row' },
        button('undo', () => state.history.length && set(state.history.pop())),
        button('start again', () => { state.history = []; set(start); })),
      element('p', { class: 'soft' }, 'Computed here in plain doubles; the program counts all rounding. Its verdicts agree on the twenty edits of a test.'))));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => solid.draw());
set(start);
window.part = { state };
ready();

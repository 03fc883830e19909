// Part (d): the front step by step on the triangles that the program's one front laid, with the lines of
// Algorithm 1 that lay them. The data are a page of `view`, read with the viewer's own modules.

import { PageData } from '../../viewer/src/page_data.js';
import { hex, operations as colours } from '../../viewer/src/palette.js';
import { operationNames, Scene } from '../../viewer/src/scene.js';
import { button, data, element, player, question, ready, slider } from './common.js';
import { ballAround, Solid } from './solid.js';

// Algorithm 1 with its numbers, and what stands before, in and after it; `by` are the operations that
// lie on a line.
const lines = [
  { text: '   creation() at every minimum', by: [0] },
  { text: ' 1 while Q is not empty' },
  { text: ' 2   t = ExtractMin(Q)' },
  { text: ' 3   if t is in a saddle c’s sphere' },
  { text: ' 4     if c is ready' },
  { text: ' 5       bridge()', by: [3] },
  { text: ' 6     else' },
  { text: ' 7       mark t red' },
  { text: ' 9   else if t is in a maximum’s' },
  { text: '10     mark t green' },
  { text: '11   else' },
  { text: '12     creep()', by: [1] },
  { text: '         and wing() at its end', by: [2] },
  { text: '14   refine what was added' },
  { text: '   seal() at every maximum', by: [4] },
];

async function scene() {
  const { about, packed } = data();
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Scene(new PageData(about, new Uint8Array(await new Response(stream).arrayBuffer())));
}

// The front's edges at a step: a triangle that is there on one side, none on the other.
function frontLength(mesh, birth, step) {
  const edges = mesh.edges();
  let count = 0;
  for (let i = 0; i < edges.length; i += 4) {
    if ((birth[edges[i + 2]] < step) !== (birth[edges[i + 3]] < step)) ++count;
  }
  return count;
}

function build(all) {
  const { mesh, birth, operation } = all, steps = all.page.about.sweep.steps;
  const positions = Array.from({ length: mesh.vertexCount }, (_, v) => [...mesh.positions.subarray(3 * v, 3 * v + 3)]);
  const order = [...all.order()], counts = all.birthCounts(), frame = ballAround(positions);
  const state = { step: 6, isPlaying: false };
  const solid = new Solid('The front', () => {
    const shown = order.slice(0, counts[state.step]);
    return { positions, ...frame, triangles: shown.map((t) => [...mesh.corners.subarray(3 * t, 3 * t + 3)]),
      colour: (i, isFront) => colours[operation[shown[i]]].map((c) => (isFront ? c : 0.55 * c + 60)),
      mark: (i) => birth[shown[i]] === state.step - 1 };
  });
  solid.turn = [0.4, -0.35];
  const code = element('pre', { 'aria-label': 'Algorithm 1' }, ...lines.map(({ text }) => element('span', {}, text)));
  const note = element('p', { 'aria-live': 'off' });
  const show = () => {
    state.step = Math.max(0, Math.min(steps, state.step));
    const last = state.step > 0 ? order[counts[state.step] - 1] : undefined;
    const kind = last === undefined ? -1 : operation[last];
    [...code.children].forEach((line, k) => line.classList.toggle('lit', lines[k].by?.includes(kind) ?? false));
    const front = frontLength(mesh, birth, state.step);
    note.replaceChildren(element('b', {}, kind < 0 ? 'Nothing is laid yet' : operationNames[kind]),
      `: ${counts[state.step]} of ${mesh.triangleCount} triangles, ${front > 0 ? `${front} edges in the front` : 'no front'}`);
    steer.set(state.step);
    solid.draw();
  };
  const go = (step) => { state.isPlaying = false; state.step = step; show(); };
  const steer = slider({ label: 'Step', min: 0, max: steps, step: 1, value: state.step, shown: String, change: go });
  // To the next step whose triangle was laid by the operation.
  const next = (kind) => {
    for (let s = state.step + 1; s <= steps; ++s) {
      if (operation[order[counts[s] - 1]] === kind) return go(s);
    }
    return go(steps);
  };
  const play = player(state, 40, () => { if (state.step >= steps) state.step = 0; }, () => {
    state.step += 1;
    show();
    return state.step < steps;
  });
  const present = operationNames.map((_, kind) => kind).filter((kind) => operation.includes(kind));
  document.getElementById('part').append(
    question('Two balls side by side, height upwards. How many bowls does Algorithm 1 lay, and how many bridges?', [
      { text: 'one bowl, no bridge', reply: 'Each ball has a lowest point of its own, a minimum.' },
      { text: 'two bowls, no bridge', reply: 'Two fronts must join where the neck’s lower saddle is.' },
      { text: 'two bowls, two bridges', isRight: true,
        reply: 'Two minima, two saddles on the neck: at the lower one the fronts join, at the upper one they part. Then the front closes at two maxima.' },
    ]),
    element('div', { class: 'columns' },
      element('div', {}, solid.canvas, element('p', { class: 'soft' },
        'The triangles that the program swept over the dumbbell with one front, C = 0.16, where they lie after refinement; outlined: the last. Drag to turn.')),
      element('div', {}, code, note, steer,
        element('div', { class: 'row' }, button('‹ step', () => go(state.step - 1)), button('step ›', () => go(state.step + 1)), play),
        element('p', {}, 'To the next triangle of'),
        element('div', { class: 'row' }, ...present.map((kind) => button(operationNames[kind], () => next(kind),
          { style: `border-left: 8px solid ${hex(colours[kind])}` }))))));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => solid.draw());
  show();
  window.part = { state, done: operationNames.map((_, k) => all.page.array(`sweep.done.${k}`).reduce((a, b) => a + b, 0)) };
  ready();
}

scene().then(build);

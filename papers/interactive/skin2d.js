// Part (b): discs to drag, the mixed cells and the skin that follow, and the mesh of the curve.

import { button, check, element, Plane, question, ready, shape, slider } from './common.js';
import { cellAt, clipped, edgeWeight, evaluate, meshOf, mixedCells, sizes, skin, splitDistance }
  from './skin2d_math.js';

const scenes = {
  'Two discs': [{ z: [-1, 0], w: 2 }, { z: [1, 0], w: 2 }],
  'Three, with a gap': [{ z: [-1.15, -0.7], w: 1.5 }, { z: [1.15, -0.7], w: 1.5 }, { z: [0, 1.25], w: 1.5 }],
  'Five': [{ z: [-2.1, -0.4], w: 1.3 }, { z: [-0.7, 0.6], w: 0.8 }, { z: [0.6, -0.5], w: 1.5 },
    { z: [1.9, 0.5], w: 1.1 }, { z: [0.2, 1.6], w: 0.5 }],
};
const limits = { w: [0.1, 4], z: 3.2 };
const state = { discs: [], chosen: 1, share: 0.2, probe: 0.12, cells: true, mesh: true, sandwich: true };
// The widest gap with one curve and the narrowest with two that the reader has found.
let found = {};

const plane = new Plane('Discs, their mixed cells and their skin', { width: 7.4, share: 0.68 });
const facts = element('table', { 'aria-live': 'polite' });
const task = element('div', { 'aria-live': 'polite' });
const graph = new Plane('The weight of the edge against the distance', { width: 6, share: 0.42,
  middle: [2.7, 0.2] });
const weight = slider({ label: 'Weight of the chosen disc', min: limits.w[0], max: limits.w[1],
  step: 0.05, value: 2, change: (w) => { state.discs[state.chosen].w = w; restart(); } });
const share = slider({ label: 'Edge over ρ', min: 0.05, max: 0.6, step: 0.01, value: 0.2,
  change: (x) => { state.share = x; draw(); } });
let parts;

// The curve's point at a share of all its points.
function probed() {
  const points = parts.loops.flat();
  return points[Math.min(points.length - 1, Math.floor(state.probe * points.length))];
}

function nearestOnCurve(x) {
  const points = parts.loops.flat();
  const far = ({ x: p }) => Math.hypot(p[0] - x[0], p[1] - x[1]);
  return points.reduce((best, p, k) => (far(p) < far(points[best]) ? k : best), 0) / points.length;
}

function restart() {
  found = {};
  draw();
}

function compute() {
  const cells = mixedCells(state.discs), loops = skin(cells);
  parts = { cells, loops, meshes: loops.map((loop) => meshOf(loop, state.share)) };
}

function drawLayers() {
  const { cells, loops, meshes } = parts, at = probed();
  const drawn = [];
  const visible = cells.filter((cell) => clipped(cell.polygon, plane.width).length > 2);
  if (state.cells) {
    drawn.push(visible.map((cell) => plane.path(clipped(cell.polygon, plane.width), { fill: `var(--cell-${cell.kind})`,
      stroke: 'var(--soft)', 'stroke-dasharray': '5 4', 'stroke-width': 0.8 }, true)));
  }
  drawn.push(state.discs.map(({ z, w }) => plane.circle(z, Math.sqrt(w),
    { stroke: 'var(--soft)', 'stroke-dasharray': '1 5', 'stroke-width': 2, 'stroke-linecap': 'round' })));
  drawn.push(loops.map((loop) => plane.path(loop.map(({ x }) => x),
    { stroke: 'var(--skin)', 'stroke-width': 2.5 }, true)));
  if (state.mesh) {
    drawn.push(meshes.map((mesh) => [
      plane.path(mesh.map(({ x }) => x), { stroke: 'var(--text)', 'stroke-width': 1 }, true),
      mesh.map(({ x }) => plane.dot(x, 2.6, { fill: 'var(--text)' }))]));
  }
  if (state.sandwich && at) {
    drawn.push([['c', 'var(--warm)'], ['q', 'var(--good)']].map(([name, colour]) => [
      plane.circle(at[name], at.rho, { stroke: colour, 'stroke-width': 1.6 }),
      plane.path([at.x, at[name]], { stroke: colour }), plane.dot(at[name], 3, { fill: colour }),
      shape('text', { x: plane.at(at[name])[0] + 6, y: plane.at(at[name])[1] - 6, fill: colour }, name)]));
  }
  plane.show(drawn);
}

function row(name, ...value) {
  return element('tr', {}, element('th', { scope: 'row' }, name), element('td', { class: 'value' }, ...value));
}

const kindNames = ['a disc’s cell', 'an edge’s cell', 'a triangle’s cell'];

function drawFacts() {
  const { loops, cells, meshes } = parts, at = probed();
  const all = meshes.map(sizes);
  const rows = [row('Closed curves', String(loops.length)),
    row('Edges of the mesh', String(meshes.reduce((n, mesh) => n + mesh.length, 0)))];
  if (all.length) {
    rows.push(row('Half edge over ρ', `${Math.min(...all.map((s) => s.least)).toFixed(3)} to ${
      Math.max(...all.map((s) => s.most)).toFixed(3)}`));
  }
  if (at) {
    const cell = cellAt(cells, at.x);
    rows.push(row('Point on the skin', `ρ = ${evaluate(cell, at.x).rho.toFixed(3)}, in ${kindNames[cell.kind]}`));
  }
  for (const cell of cells.filter(({ kind }) => kind > 0)) {
    rows.push(row(`w of ${cell.discs.map((i) => i + 1).join('–')}`, element('span',
      { class: cell.weight < 0 ? 'bad' : 'good' }, cell.weight.toFixed(3))));
  }
  facts.replaceChildren(...rows);
}

// With two discs: the weight of the edge over the distance, and how near the reader has come.
function drawTask() {
  const two = state.discs.length === 2;
  graph.svg.style.display = two ? '' : 'none';
  if (!two) {
    task.replaceChildren(element('p', { class: 'soft' },
      'The task needs the scene with two discs. Here: open and close the gap in the middle, and watch the ',
      'weight of the triangle. Below 0 there is a hole, a curve with the body outside.'));
    return;
  }
  const [a, b] = state.discs, d = Math.hypot(a.z[0] - b.z[0], a.z[1] - b.z[1]);
  const w = edgeWeight(a.w, b.w, d);
  const split = parts.loops.length > 1;
  if (split) found.split = Math.min(found.split ?? Infinity, d);
  else found.whole = Math.max(found.whole ?? 0, d);
  const gap = found.split - found.whole;
  const words = !(gap >= 0) ? ['Move a disc until the skin splits, then back and forth to find the distance.']
    : [`It splits between d = ${found.whole.toFixed(3)} and ${found.split.toFixed(3)}. `,
      gap < 0.02 ? element('b', { class: 'good' },
        `Found: √w₁ + √w₂ = ${splitDistance(a.w, b.w).toFixed(3)}, where the edge’s weight is 0.`)
        : 'Narrow it to 0.02; with Shift the arrow keys take small steps.'];
  task.replaceChildren(element('p', {}, element('b', {}, 'Task. '), ...words),
    element('p', { class: 'value' }, `d = ${d.toFixed(3)}, w = ${w.toFixed(3)}: ${split ? 'two curves' : 'one curve'}`));
  const far = 5.4, line = Array.from({ length: 80 }, (_, k) => [0.2 + (k * (far - 0.2)) / 79])
    .map(([x]) => [x, Math.max(-1.1, edgeWeight(a.w, b.w, x) / 3)]);
  const cut = Math.max(-1, Math.min(1.4, w / 3));
  graph.show(graph.path([[0, 0], [far, 0]], { stroke: 'var(--soft)' }),
    graph.path([[0, -1], [0, 1.3]], { stroke: 'var(--soft)' }),
    graph.path(line, { stroke: 'var(--skin)', 'stroke-width': 2 }),
    found.whole && graph.path([[found.whole, -0.12], [found.whole, 0.12]], { stroke: 'var(--good)', 'stroke-width': 3 }),
    Number.isFinite(found.split) && graph.path([[found.split, -0.12], [found.split, 0.12]], { stroke: 'var(--bad)', 'stroke-width': 3 }),
    graph.dot([d, cut], 6, { fill: split ? 'var(--bad)' : 'var(--good)' }),
    graph.text([far - 0.15, 0.12], 'd'), graph.text([0.08, 1.2], 'w'),
    graph.text([far - 0.7, -0.3], 'w = 0', { 'text-anchor': 'end' }));
}

function draw() {
  compute();
  drawLayers();
  drawFacts();
  drawTask();
}

const clamp = (x) => Math.max(-limits.z, Math.min(limits.z, x));

function build() {
  compute();
  plane.handles.replaceChildren();
  plane.handle(() => probed()?.x ?? [99, 99], 'Point on the skin: left and right move it along',
    (x, direction) => {
      state.probe = direction ? (state.probe + 0.01 * (direction[0] + direction[1]) + 1) % 1 : nearestOnCurve(x);
      draw();
    }, { r: 5, colour: 'var(--skin)' });
  state.discs.forEach((disc, i) => {
    const handle = plane.handle(() => disc.z, `Disc ${i + 1}: arrow keys move it`, ([x, y]) => {
      disc.z = [clamp(x), Math.max(-2.2, Math.min(2.2, y))];
      draw();
    });
    handle.addEventListener('focus', () => choose(i));
  });
  draw();
}

function choose(i) {
  state.chosen = i;
  weight.set(state.discs[i].w);
  weight.firstChild.textContent = `Weight of disc ${i + 1}`;
}

function take(name) {
  state.discs = scenes[name].map(({ z, w }) => ({ z: [...z], w }));
  found = {};
  choose(1);
  build();
  for (const other of picks) other.setAttribute('aria-pressed', other.textContent === name);
}

const picks = Object.keys(scenes).map((name) => button(name, () => take(name), { 'aria-pressed': 'false' }));
const layer = (name, words) => check(words, state[name], (is) => { state[name] = is; draw(); });

document.getElementById('part').append(
  question('Two discs of weight 2 move apart. At which distance does their skin split in two?', [
    { text: 'd = 2', reply: 'There the small circles of radius √(w/2) = 1 touch, but a neck still joins them.' },
    { text: 'd = 2.83', isRight: true,
      reply: 'The edge’s weight 2 − (d/2)² is 0 there: where the discs themselves, of radius √2, touch.' },
    { text: 'd = 4', reply: 'There the edge’s weight is 2 − 2² = −2, and the skin has long been two curves.' },
  ]),
  element('div', { class: 'row' }, ...picks),
  element('div', { class: 'columns' },
    element('div', {}, plane.svg, element('p', { class: 'soft' },
      'Drag a centre, or the blue point on the skin; the arrow keys do it too. Dotted: discs of radius √w. ',
      'Dashed: mixed cells. Orange and green: the sandwiching circles, of radius ρ, about c in the body and q outside.'),
    element('div', { class: 'row' }, layer('cells', 'mixed cells'), layer('mesh', 'mesh'),
      layer('sandwich', 'sandwich circles'))),
    element('div', {}, task, graph.svg, weight, share, facts)));
plane.draw = draw;
graph.draw = drawTask;
take('Two discs');
window.part = { state, plane, draw, parts: () => parts, found: () => found };
ready();

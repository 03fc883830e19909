// Part (c): C and Q, what they promise, the window of the tangent disk, and one triangle.

import { element, Plane, question, ready, slider } from './common.js';
import { angleBound, circumcentre, ends, fanWindow, isDense, measure, smallestQ, window as windowOf }
  from './sizes_math.js';

const state = { C: 0.08, Q: 1.65, r: 0.181, slope: 0,
  corners: [[-0.1, -0.06], [0.1, -0.06], [0, 0.12]] };
const range = { C: [0.01, 0.3], Q: [1.42, 2.4] };
const angles = [40, 45, 50, 60, 75, 90];

const region = new Plane('C and Q', { width: 1.3, share: 0.9, middle: [0.55, 0.46] });
const radii = new Plane('Radii of the disk', { width: 0.4, share: 0.72, middle: [0.17, 0] });
const triangle = new Plane('A triangle', { width: 0.8, share: 0.62 });
const promise = element('table', { 'aria-live': 'polite' });
const verdict = element('div', { 'aria-live': 'polite' });

// The place of C and Q in the drawing, and back.
const spot = (C, Q) => [C / range.C[1], (Q - 1.4) / (range.Q[1] - 1.4)];
const clamp = (x, [least, most]) => Math.max(least, Math.min(most, x));

const row = (name, ...value) => element('tr', {}, element('th', { scope: 'row' }, name),
  element('td', { class: 'value' }, ...value));
const yes = (is, words, otherwise) => element('span', { class: is ? 'good' : 'bad' }, is ? words : otherwise);

function drawRegion() {
  const { C, Q } = state, curve = [], dense = [];
  for (let k = 0; k <= 60; ++k) {
    const c = (range.C[1] * k) / 60;
    if (smallestQ(c) <= range.Q[1]) curve.push(spot(c, smallestQ(c)));
    if (c > 0 && 0.215 / c >= 1.4 && 0.215 / c <= range.Q[1]) dense.push(spot(c, 0.215 / c));
  }
  const top = curve.at(-1)[1] >= 1 ? [] : [[1, 1]];
  region.show(
    region.path([...curve, ...top, [0, 1]], { fill: 'var(--cell-2)' }, true),
    region.path(curve, { stroke: 'var(--good)', 'stroke-width': 2 }),
    region.path(dense, { stroke: 'var(--warm)', 'stroke-width': 2, 'stroke-dasharray': '6 4' }),
    region.path([[0, 1], [0, 0], [1, 0]], { stroke: 'var(--soft)' }),
    [0.1, 0.2, 0.3].map((c) => region.text([spot(c, 1.4)[0], -0.08], c.toFixed(1), { 'text-anchor': 'middle' })),
    [1.6, 1.8, 2, 2.2].map((q) => region.text([-0.015, spot(0, q)[1]], `${q.toFixed(1)}`, { 'text-anchor': 'end' })),
    region.text([0.9, -0.08], 'C'), region.text([-0.04, 1], 'Q', { 'text-anchor': 'end' }),
    region.text([0.03, 0.93], 'Q² > 2 + 4CQ', { fill: 'var(--good)' }),
    region.text([0.52, 0.06], 'CQ = 0.215', { fill: 'var(--warm)' }));
  const { half, disk, asPrinted } = windowOf(C, Q);
  promise.replaceChildren(
    row('Every angle is above', `${angleBound(Q).toFixed(2)}°`),
    row('Refinement', yes(ends(C, Q), 'provably ends', `may not end: needs Q > ${smallestQ(C).toFixed(3)}`)),
    row('Sample', yes(isDense(C, Q), 'dense enough for the theory', 'CQ is above 0.215')),
    row('Half an edge, over ρ', `${half[0].toFixed(4)} to ${half[1].toFixed(4)}`),
    row('Disk r/ρ', `${disk[0].toFixed(4)} to ${disk[1].toFixed(4)}`),
    row('Closed form as printed', `${asPrinted.toFixed(4)}: `,
      yes(asPrinted > disk[0], 'inside', 'below the least'), ', it lost a factor 2'));
}

const bar = ([from, to], y, attributes) => (to <= from ? null
  : radii.path([[from, y], [to, y]], { 'stroke-width': 8, ...attributes }));

function drawRadii() {
  const { C, Q, r } = state, { disk } = windowOf(C, Q), height = radii.width * radii.share;
  const y = (k) => height / 2 - (height * (k + 1.55)) / (angles.length + 2.4);
  const line = (x, colour, words, k, dashes) => [
    radii.path([[x, y(-0.7)], [x, y(angles.length - 0.4)]], { stroke: colour, 'stroke-width': 1.6, 'stroke-dasharray': dashes }),
    radii.text([x, y(k)], words, { fill: colour, 'text-anchor': 'middle' })];
  radii.show(angles.map((angle, k) => {
    const even = fanWindow(C, Q, angle, 0), worst = fanWindow(C, Q, angle, 1);
    const isIn = (w) => r > w[0] && r < w[1];
    return [bar(even, y(k) + 0.006, { stroke: isIn(even) ? 'var(--good)' : 'var(--line)' }),
      bar(worst, y(k) - 0.008, { stroke: isIn(worst) ? 'var(--skin)' : 'var(--line)' }),
      radii.text([-0.015, y(k) - 0.005], `${angle}°`)];
  }), line(disk[0], 'var(--warm)', disk[0].toFixed(3), -0.85), line(disk[1], 'var(--warm)', disk[1].toFixed(3), -0.85),
  line(r, 'var(--text)', `r = ${r.toFixed(3)}`, angles.length + 0.15, '4 3'));
}

const scaleAt = (x) => Math.max(0.05, 1 + state.slope * x[0]);

function drawTriangle() {
  const { C, Q, corners } = state;
  const m = measure(corners.map((x) => ({ x, rho: scaleAt(x) })), C, Q);
  const isSmall = m.ratio < 1, centre = circumcentre(corners);
  triangle.show(
    m.radius < 5 && triangle.circle(centre, m.radius, { stroke: isSmall ? 'var(--good)' : 'var(--bad)' }),
    m.radius < 5 && triangle.circle(centre, m.bound, { stroke: 'var(--soft)', 'stroke-dasharray': '5 4' }),
    triangle.path(corners, { fill: isSmall ? 'var(--cell-2)' : 'var(--bad)', 'fill-opacity': isSmall ? 1 : 0.45 }, true),
    m.edges.map(({ ratio }, k) => triangle.path([corners[(k + 1) % 3], corners[(k + 2) % 3]],
      { stroke: ratio > 1 ? 'var(--good)' : 'var(--bad)', 'stroke-width': 4 })));
  const short = m.edges.filter(({ ratio }) => ratio <= 1);
  const least = Math.min(...m.angles);
  verdict.replaceChildren(element('table', {},
    row('[L], half the shortest edge', yes(short.length === 0, 'kept', `${short.length} too short`),
      `: ${Math.min(...m.edges.map((e) => e.ratio)).toFixed(2)} of its bound`),
    row('[U], circumradius', yes(isSmall, 'kept', 'too large'), `: ${m.ratio.toFixed(2)} of its bound`),
    row('Smallest angle', `${least.toFixed(1)}°`,
      short.length === 0 && isSmall ? ` (proved: ${angleBound(Q).toFixed(1)}°)` : '')));
}

function draw() {
  drawRegion();
  drawRadii();
  drawTriangle();
}

region.handle(() => spot(state.C, state.Q), 'C and Q: arrow keys change them', ([x, y]) => {
  state.C = clamp(x * range.C[1], range.C);
  state.Q = clamp(1.4 + y * (range.Q[1] - 1.4), range.Q);
  sliders.C.set(state.C);
  sliders.Q.set(state.Q);
  draw();
}, { colour: 'var(--accent)' });
radii.handle(() => [state.r, 0], 'Radius r: left and right change it', ([x]) => {
  state.r = clamp(x, [0.05, 0.34]);
  drawRadii();
}, { colour: 'var(--accent)', step: 0.002 });
state.corners.forEach((corner, k) => triangle.handle(() => state.corners[k],
  `Corner ${k + 1}: arrow keys move it`, ([x, y]) => {
    state.corners[k] = [clamp(x, [-0.38, 0.38]), clamp(y, [-0.23, 0.23])];
    drawTriangle();
  }));
const sliders = Object.fromEntries(['C', 'Q'].map((name) => [name, slider({ label: name,
  min: range[name][0], max: range[name][1], step: 0.005, value: state[name], shown: (x) => x.toFixed(3),
  change: (x) => { state[name] = x; draw(); } })]));

document.getElementById('part').append(
  question('Make the mesh twice as fine: halve C, leave Q. What becomes of the smallest angle that [L] and [U] promise?', [
    { text: 'It doubles', reply: 'C cancels: sin A > (C/Q)/(CQ) = 1/Q².' },
    { text: 'It stays', isRight: true, reply: 'sin A > (C/Q)/(CQ) = 1/Q². Only Q counts; C gives the size.' },
    { text: 'It shrinks', reply: 'C cancels: sin A > (C/Q)/(CQ) = 1/Q². But a smaller C lets Q be smaller; try it below.' },
  ]),
  element('div', { class: 'columns' },
    element('div', {}, region.svg), element('div', {}, sliders.C, sliders.Q, promise)),
  element('h1', {}, 'Radii with which a fan keeps both conditions'),
  element('div', { class: 'columns' },
    element('div', {}, radii.svg), element('p', { class: 'soft' },
      'For each angle of a fan’s triangle: above, with ρ the same everywhere (green where r lies inside); below, with ρ ',
      'changing as fast as it may (blue). Orange: the window of the text, at C = 0.08 and Q = 1.65 from 0.107 to 0.208. It knows edges ',
      'only, so its upper end breaks [U] in wide fans. Drag r.')),
  element('h1', {}, 'One triangle'),
  element('div', { class: 'columns' },
    element('div', {}, triangle.svg),
    element('div', {}, verdict, slider({ label: 'ρ changes along x, per unit of length', min: -1, max: 1, step: 0.05, value: 0,
      change: (x) => { state.slope = x; drawTriangle(); } }),
    element('p', { class: 'soft' }, 'ρ is 1 in the middle. Drag a corner: an edge reddens where it breaks [L], the triangle where it breaks [U]. ',
      'Dashed: the largest circumcircle that [U] allows.'))));
region.draw = drawRegion;
radii.draw = drawRadii;
triangle.draw = drawTriangle;
draw();
window.part = { state, draw };
ready();

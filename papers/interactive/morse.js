// Part (e): the Morse-Smale complex of a function on the torus, to cancel pair by pair, with its persistence
// diagram; what is refused says why.

import { button, check, element, Plane, question, ready, shape } from './common.js';
import * as morse from './morse_math.js';

const scenes = {
  'Hills': morse.waves(3),
  'More hills': morse.waves(5, 3),
  'One hill': [{ m: 1, n: 0, height: 1, shift: 0.4 }, { m: 0, n: 1, height: 0.8, shift: 0.9 }],
};
const margin = 0.06, square = 1 + 2 * margin;
const kindNames = ['minimum', 'saddle', 'maximum'], colours = ['var(--low)', 'var(--accent)', 'var(--high)'];
const state = { complex: null, chosen: 0, byDistance: false, history: [], outcome: null, done: {} };
let waves, range, allPairs, picture;

const plane = new Plane('The complex on the torus', { width: square, share: 1, middle: [0.5, 0.5] });
const diagram = new Plane('Persistence diagram', { width: 1.3, share: 0.92, middle: [0.5, 0.46] });
const said = element('p', { class: 'said', 'aria-live': 'polite' });
const facts = element('p', { class: 'value' });
const task = element('ul', { class: 'tasks' });
const place = element('span', { class: 'value' });

const value = (p) => state.complex.points[p].value;
const share = (v) => (v - range[0]) / (range[1] - range[0]);
const arc = () => state.complex.arcs[state.chosen];

// The function as bands of one shade each, whose borders are level curves.
function shaded() {
  const n = 220, bands = 14, canvas = element('canvas', { width: n, height: n }), context = canvas.getContext('2d');
  const image = context.createImageData(n, n), isDark = matchMedia('(prefers-color-scheme: dark)').matches;
  for (let i = 0; i < n * n; ++i) {
    const x = ((i % n) + 0.5) / n * square - margin, y = (1 - (Math.floor(i / n) + 0.5) / n) * square - margin;
    const level = Math.floor(bands * share(morse.evaluate(waves, [x, y]).value)) / bands;
    const [low, high] = isDark ? [28, 104] : [150, 250];
    const isOutside = x < 0 || x > 1 || y < 0 || y > 1, light = low + level * (high - low);
    image.data.set([light, light, light + 4, isOutside ? 110 : 255], 4 * i);
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

// All images of a line or point of the covering plane that the window shows.
function images(points) {
  const shifts = [0, 1].map((k) => {
    const all = points.map((p) => p[k]), from = Math.ceil(-margin - Math.max(...all)), to = Math.floor(1 + margin - Math.min(...all));
    return Array.from({ length: Math.max(0, to - from + 1) }, (_, i) => from + i);
  });
  return shifts[0].flatMap((a) => shifts[1].map((b) => points.map(([x, y]) => [x + a, y + b])));
}

const drawn = (line, attributes) => images(line).map((points) => plane.path(points, attributes));

// The roles of what the chosen arc joins, as the paper's Figure 3 names them.
function names() {
  const { complex } = state, chosen = arc();
  return chosen ? new Map([[chosen.saddle, 'a'], [morse.twin(complex, chosen).end, 'c'], [chosen.end, 'b']]) : new Map();
}

function drawComplex() {
  const { complex, outcome } = state, called = names(), chosen = arc();
  const lines = complex.arcs.map((one) => {
    const isWrong = morse.isImpossible(complex, one);
    return drawn(one.line, { stroke: isWrong ? 'var(--warm)' : colours[one.kind], 'stroke-width': isWrong ? 3 : 1.8,
      'stroke-dasharray': isWrong && '7 4' });
  });
  const inner = outcome?.inner && complex.arcs.find(({ saddle, end }) => saddle === outcome.inner.saddle && end === outcome.inner.end);
  const marked = chosen ? [drawn(morse.twin(complex, chosen).line, { stroke: colours[chosen.kind], 'stroke-width': 4, 'stroke-dasharray': '10 6' }),
    drawn(chosen.line, { stroke: 'var(--text)', 'stroke-width': 7 }), drawn(chosen.line, { stroke: colours[chosen.kind], 'stroke-width': 4 }),
    inner && drawn(inner.line, { stroke: 'var(--warm)', 'stroke-width': 5 })] : [];
  const dots = complex.points.map(({ x, index }, p) => (morse.isLeft(complex, p)
    ? images([x]).map(([at]) => [plane.dot(at, called.has(p) ? 8 : 6, { fill: colours[index], stroke: 'var(--back)', 'stroke-width': 1.5 }),
      called.has(p) && label(at, called.get(p))]) : images([x]).map(([at]) => plane.dot(at, 2, { fill: 'var(--soft)' }))));
  plane.show(shape('image', { href: picture, width: plane.pixels, height: plane.height, preserveAspectRatio: 'none' }),
    plane.path([[0, 0], [1, 0], [1, 1], [0, 1]], { stroke: 'var(--soft)', 'stroke-dasharray': '4 4' }, true), lines, marked, dots);
}

function label(at, name) {
  const [x, y] = plane.at(at);
  return shape('text', { x: x + 10, y: y - 8, class: 'name' }, name);
}

function drawDiagram() {
  const corner = [[0, 0], [1, 1]];
  diagram.show(diagram.path(corner, { stroke: 'var(--soft)' }), diagram.path([[0, 1], [0, 0], [1, 0]], { stroke: 'var(--soft)' }),
    diagram.text([0.62, -0.09], 'lower value →'), diagram.text([0.03, 0.97], '↑ higher value'));
}

// The dots of the diagram stay, so that focus does; those of cancelled pairs are hollow.
function putDots() {
  diagram.handles.replaceChildren(...allPairs.map((pair) => {
    const at = [pair.saddle, pair.extremum].map((p) => share(value(p))).sort((p, q) => p - q);
    const dot = shape('g', { class: 'handle pair', tabindex: 0, role: 'button',
      'aria-label': `Pair of a saddle and a ${kindNames[pair.kind]}, persistence ${pair.persistence.toFixed(2)}` });
    dot.put = () => {
      const isGone = ![pair.saddle, pair.extremum].every((p) => morse.isLeft(state.complex, p)), isChosen = arc()?.saddle === pair.saddle && arc().end === pair.extremum;
      dot.replaceChildren(diagram.dot(at, 14, { fill: 'transparent', class: 'halo' }), diagram.dot(at, isChosen ? 7 : 5,
        { fill: isGone ? 'none' : colours[pair.kind], stroke: isChosen ? 'var(--text)' : colours[pair.kind], 'stroke-width': 2 }));
    };
    dot.addEventListener('click', () => tryPair(pair));
    dot.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      tryPair(pair);
    });
    return dot;
  }));
}

const reasons = {
  loop: ({ kind }) => ['Both lines of the saddle a end at this ', kindNames[kind], '. There is no c to which other lines could go on.'],
  elder: ({ kind }) => ['c is ', kind === 0 ? 'higher' : 'lower', ' than b. Of two puddles the ', kind === 0 ? 'higher' : 'lower',
    ' one ends: a can go with c, not with b.'],
  inner: ({ kind }) => ['Another saddle of b (orange) is ', kind === 0 ? 'lower' : 'higher', ' than a. Its line could get to c only ', kind === 0 ? 'over' : 'under', ' a. It goes first.'],
};

function tryArc(chosen) {
  const { complex } = state;
  state.chosen = complex.arcs.indexOf(chosen);
  state.outcome = morse.refusal(complex, chosen, state.byDistance);
  if (state.outcome) {
    state.done[state.outcome.why] = true;
    const words = reasons[state.outcome.why](chosen);
    said.replaceChildren(element('b', { class: 'bad' }, 'Refused. '), ...words);
  } else {
    const apart = Math.abs(value(chosen.saddle) - value(chosen.end));
    state.history.push(complex);
    state.complex = morse.cancel(complex, chosen);
    state.chosen = -1;
    state.done.least ||= morse.counts(state.complex)[1] === 2;
    said.replaceChildren(element('b', { class: 'good' }, 'Cancelled'), ` a saddle and a ${kindNames[chosen.kind]}, their values ${
      apart.toFixed(2)} apart. Its other lines go on to c.`);
  }
  draw();
}

function tryPair(pair) {
  const found = state.complex.arcs.find(({ saddle, end }) => saddle === pair.saddle && end === pair.extremum);
  if (found) return tryArc(found);
  said.replaceChildren(morse.isLeft(state.complex, pair.saddle) ? 'No line joins this pair yet: pairs between them have to go first.' : 'This pair is gone.');
  return undefined;
}

function choose(n) {
  const count = state.complex.arcs.length;
  state.chosen = (n + count) % count;
  state.outcome = null;
  const { saddle, end, kind } = arc();
  said.replaceChildren(`From saddle a at ${value(saddle).toFixed(2)} ${kind ? 'up' : 'down'} to ${kindNames[kind]} b at ${value(end).toFixed(2)}; c is at ${
    value(morse.twin(state.complex, arc()).end).toFixed(2)}.`);
  draw();
}

function put(complex) {
  state.complex = complex;
  state.chosen = -1;
  state.outcome = null;
  said.replaceChildren('Click a line, or choose one with the buttons.');
  draw();
}

const tasks = [['elder', 'c on the wrong side of b'], ['inner', 'another saddle first'], ['loop', 'both lines to one extremum']];

function draw() {
  const { complex, done } = state, [minima, saddles, maxima] = morse.counts(complex);
  const plural = (n, name, many) => `${n} ${n === 1 ? name : many}`;
  const wrong = complex.arcs.filter((one) => morse.isImpossible(complex, one)).length;
  facts.replaceChildren(`${plural(minima, 'minimum', 'minima')} − ${saddles} saddles + ${plural(maxima, 'maximum', 'maxima')} = ${minima - saddles + maxima}`,
    wrong ? element('span', { class: 'bad' }, `. ${plural(wrong, 'line passes', 'lines pass')} a saddle beyond the one they come from (orange): no function has this complex.`) : '');
  task.replaceChildren(element('li', { class: 'head' }, 'Task. Find the three reasons for a refusal; then leave as few points as possible.'),
    ...tasks.map(([why, words]) => element('li', { class: done[why] ? 'good' : 'soft' }, `${done[why] ? '✓' : '○'} refused: ${words}`)),
    element('li', { class: done.least ? 'good' : 'soft' }, `${done.least ? '✓' : '○'} as few as possible`));
  place.textContent = arc() ? `line ${state.chosen + 1} of ${complex.arcs.length}` : `${complex.arcs.length} lines`;
  cancelIt.disabled = !arc();
  least.disabled = !morse.leastPersistent(complex);
  undo.disabled = !state.history.length;
  drawComplex();
  drawDiagram();
}

// The line whose traced part comes the nearest to a click, if it comes near.
plane.svg.addEventListener('click', (event) => {
  const box = plane.svg.getBoundingClientRect();
  const x = [event.clientX - box.left - plane.pixels / 2, plane.height / 2 - (event.clientY - box.top)].map((c) => 0.5 + c / plane.scale);
  const far = ({ line, own }) => Math.min(...line.slice(0, own).map((y) =>
    Math.hypot(...y.map((c, k) => c - x[k] - Math.round(c - x[k])))));
  const [nearest] = state.complex.arcs.map((one) => ({ one, d: far(one) * plane.scale })).sort((p, q) => p.d - q.d);
  if (nearest.d < 18) tryArc(nearest.one);
});

function repaint() {
  picture = shaded();
  draw();
}

function take(name) {
  waves = scenes[name];
  const complex = morse.complexOf(waves), values = complex.points.map((p) => p.value);
  range = [Math.min(...values), Math.max(...values)];
  state.complex = complex;
  allPairs = morse.persistencePairs(complex);
  Object.assign(state, { history: [], done: {} });
  putDots();
  picture = shaded();
  put(complex);
  for (const other of picks) other.setAttribute('aria-pressed', other.textContent === name);
}

const picks = Object.keys(scenes).map((name) => button(name, () => take(name), { 'aria-pressed': 'false' }));
const cancelIt = button('cancel it', () => tryArc(arc()));
const least = button('cancel the least persistent', () => tryArc(morse.leastPersistent(state.complex)));
const undo = button('undo', () => put(state.history.pop()));

document.getElementById('part').append(
  question('Opposite sides of this square are one: it is a torus. Cancel pairs as long as any can be. What is left?', [
    { text: 'nothing', reply: 'The lowest and the highest point stay, and 1 − 0 + 1 is not 0.' },
    { text: 'a minimum and a maximum', reply: 'Then χ would be 2, as on a sphere. A cancellation takes a saddle and an extremum, so the sum stays 0.' },
    { text: '1 minimum, 2 saddles, 1 maximum', isRight: true, reply: 'The sum 1 − 2 + 1 = 0 stays. Both lines of each saddle then end at the same point, and nothing more can go.' },
  ]),
  element('div', { class: 'row' }, ...picks),
  element('div', { class: 'columns' },
    element('div', {}, plane.svg, element('p', { class: 'soft' },
      'Dark is low, light is high. Red lines fall from saddles (blue) to minima, green ones rise to maxima. Click a line to cancel its ends. ',
      'The margin shows again what lies across.'), facts, said),
    element('div', {}, task,
      element('div', { class: 'row' }, button('‹', () => choose(Math.max(state.chosen, 0) - 1), { 'aria-label': 'line before' }),
        button('›', () => choose(state.chosen + 1), { 'aria-label': 'next line' }), cancelIt, place),
      element('div', { class: 'row' }, least, undo,
        button('start again', () => put(state.history.splice(0)[0] ?? state.complex))),
      check('as printed: refuse only loops (E11)', false, (is) => { state.byDistance = is; }),
      diagram.svg, element('p', { class: 'soft' },
        'Persistence: each dot is a pair, its height over the diagonal how long it lived. Click one to cancel it; hollow ones are gone.'))));
plane.draw = drawComplex;
diagram.draw = drawDiagram;
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', repaint);
take('Hills');
window.part = { state };
ready();

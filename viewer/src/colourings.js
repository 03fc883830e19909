// What the surface can be coloured by. Each tells its legend, swatches or a scale, and how to colour:
// `values`, by vertex from 0 to 1, for the scale; or `colours`, what Surface.paint takes of triangles.

import { AtomParts, CellParts } from './corner_parts.js';
import { counted } from './dom.js';
import { inPrint, signed } from './headline.js';
import { extent } from './mesh.js';
import * as palette from './palette.js';

const lazily = (make) => {
  let made;
  return () => (made ??= make());
};

// One colour for all of a triangle.
const byTriangle = (colourOf) => (t, three) => { three.fill(colourOf(t)); };

// parts: of corners; colourOf(part). Between the corners' parts each fragment has its own.
function byPart(parts, colourOf) {
  const three = [0, 0, 0];
  return (t, colours, between) => {
    const isParted = parts.write(t, three, between);
    for (let k = 0; k < 3; ++k) colours[k] = colourOf(three[k]);
    return isParted;
  };
}

function tally(numbers, size) {
  const counts = new Array(size).fill(0);
  for (const n of numbers) ++counts[n];
  return counts;
}

const short = (x, digits = 3) => signed(Number(x.toPrecision(digits)).toString());

// The ends and the middle of a scale, true to a hundredth of it: far from 0 three digits are too few.
function ticks(low, span) {
  const power = (x) => Math.floor(Math.log10(x));
  const most = Math.max(Math.abs(low), Math.abs(low + span));
  const digits = Math.min(Math.max(3, 3 + power(most) - power(span)), 15);
  return [0, 0.5, 1].map((x) => short(low + x * span, digits));
}

// A table of colours for a scale, so that painting looks up and does not compute.
const steps = Array.from({ length: 256 }, (_, i) => palette.gradient(i / 255));
const onScale = (x) => steps[Math.min(255, Math.max(0, Math.round(255 * x)))];

// Numbers by vertex on the scale, from their least to their greatest; isOne(low, high): that they
// differ by rounding alone, which would have all colours of the scale.
function spread(numbers, isOne = () => false) {
  const { low, high } = extent(numbers), span = high - low || 1;
  const values = isOne(low, high) ? numbers.map(() => 0.5) : numbers.map((x) => (x - low) / span);
  return { low, span, values };
}

export function colourings(scene) {
  const { page } = scene;
  return [...(scene.cells ? [patchKind(scene), lengthScale(scene)] : []), quality(scene),
    component(scene), ...(scene.cells ? [nearestAtom(scene)] : []),
    ...(page.has('mesh.region') ? [region(scene)] : []),
    ...(page.about.function ? [functionValue(scene)] : []),
    ...(scene.operation ? [seam(scene), operation(scene)] : []),
    { id: 'plain', label: 'Plain', colours: () => byTriangle(() => palette.plain),
      legend: () => ({ swatches: [] }) }];
}

function patchKind(scene) {
  const { mesh, complex, cells } = scene;
  // Counted is the kind that most corners have; the first corner's if all differ.
  const kindOf = (t) => {
    const kind = (k) => complex.dimension(cells[mesh.corners[3 * t + k]]);
    const second = kind(1);
    return second === kind(2) ? second : kind(0);
  };
  const counts = lazily(() =>
    tally(Uint8Array.from({ length: mesh.triangleCount }, (_, t) => kindOf(t)), 4));
  return { id: 'kind', label: 'Patch kind',
    colours: () => byPart(new CellParts(scene), (cell) => palette.kinds[complex.dimension(cell)]),
    legend: () => ({ swatches: ['sphere, convex', 'hyperboloid, edge', 'hyperboloid, triangle',
      'sphere, hollow'].map((name, i) => ({ name, colour: palette.kinds[i], count: counts()[i] })) }),
  };
}

function lengthScale(scene) {
  const { complex, cells, mesh: { positions: p }, page: { about } } = scene;
  // Places are rounded to the grid, by half a step along each axis at most.
  const off = Math.sqrt(3) / 2 * about.mesh.grid.step;
  const scale = lazily(() => spread(Float32Array.from(cells, (cell, v) =>
    Math.log(complex.lengthScale(cell, p[3 * v], p[3 * v + 1], p[3 * v + 2]) || 1e-9)),
  (low, high) => Math.exp(high) - Math.exp(low) <= 2 * off));
  return { id: 'scale', label: 'Length scale', values: () => scale().values,
    legend: () => {
      const at = (x) => short(Math.exp(scale().low + x * scale().span));
      return { scale: [at(0), at(0.5), at(1)], unit: 'Å, logarithmic' };
    } };
}

function quality({ mesh, page: { about } }) {
  const angles = lazily(() => mesh.smallestAngles(about.min_angle_deg));
  const share = (count) => `${short(100 * count / mesh.triangleCount)} %`;
  const shares = lazily(() => [30, 35, 40].map((degrees) =>
    [degrees, share(angles().reduce((count, angle) => count + (angle < degrees), 0))]));
  const obtuse = lazily(() => share(mesh.obtuseTriangles()));
  // By whole degrees of the scale; what lies beyond its ends is in the outer two.
  const bars = lazily(() => tally(angles().map((angle) =>
    Math.min(Math.max(Math.floor(angle - 20), 0), 39)), 40));
  return { id: 'quality', label: 'Triangle quality',
    colours: () => byTriangle((t) => onScale((angles()[t] - 20) / 40)),
    legend: () => ({ scale: ['20°', '40°', '60°'], bars: bars(),
      barsInWords: 'Histogram of the smallest angles: ' + shares().map(([degrees, part]) =>
        `${part} of the triangles below ${degrees} degrees`).join(', ') +
        `; largest: ${obtuse()} above 90`,
      unit: 'smallest angle' + (Number.isFinite(about.min_angle_deg)
        ? `; least ${about.min_angle_deg.toFixed(1)}°` : ''),
      more: 'below ' + shares().map(([degrees, part]) => `${degrees}°: ${part}`).join(', ') +
        `; above 90°: ${obtuse()}` }) };
}

function component(scene) {
  return { id: 'component', label: 'Component',
    colours: () => {
      const { ofTriangle, list } = scene.components();
      const colours = list.map((_, i) => palette.categorical(i));
      return byTriangle((t) => colours[ofTriangle[t]]);
    },
    legend: () => {
      const { list } = scene.components();
      return { swatches: list.slice(0, 6).map(({ name, triangles }, i) =>
        ({ name, colour: palette.categorical(i), count: triangles })),
      more: list.length > 6 ? `and ${list.length - 6} more` : '' };
    } };
}

function nearestAtom(scene) {
  return { id: 'atom', label: 'Atom',
    colours: () => {
      const shades = scene.complex.atoms.map((_, atom) => atomShade(scene, atom));
      return byPart(new AtomParts(scene), (atom) => shades[atom]);
    },
    legend: () => ({ swatches: scene.elementsPresent().map(({ name, colour, count }) =>
      ({ name, colour, count })), more: 'of the nearest atom, each in a shade of its own' }) };
}

// The element's colour, a little lighter or darker for each atom.
function atomShade(scene, atom) {
  const colour = scene.elementColour(atom);
  const shade = 0.86 + 0.28 * ((atom * 0.618034) % 1);
  return colour.map((x) => Math.min(255, x * shade));
}

function region(scene) {
  const numbers = lazily(() => scene.mesh.addParents(scene.page.array('mesh.region')));
  return { id: 'region', label: 'Morse–Smale region',
    colours: () => {
      const colours = scene.regionColours();
      return byTriangle((t) => colours[numbers()[t]]);
    },
    legend: () => ({ swatches: [], more: `${counted(scene.regionCount(), 'pair')} of a ` +
      'minimum and a maximum, a colour each' }) };
}

function functionValue(scene) {
  const scale = lazily(() => spread(scene.functionValues()));
  const { words, unit } = scene.page.about.function;
  return { id: 'value', label: 'Morse function', values: () => scale().values,
    legend: () => {
      const { low, span } = scale();
      return { scale: ticks(low, span),
        unit: words.replace(/ along.*| from.*/, '') + ', ' + inPrint(unit) };
    } };
}

function operation(scene) {
  return { id: 'operation', label: 'Operation',
    colours: () => byTriangle((t) => palette.operations[scene.operation[t]]),
    legend: () => {
      const counts = tally(scene.operation, 5);
      return { swatches: scene.operationNames.map((name, i) =>
        ({ name, colour: palette.operations[i], count: counts[i] })), more: 'triangles each laid' };
    } };
}

function seam(scene) {
  return { id: 'seam', label: 'Seams of fronts',
    colours: () => byTriangle((t) => (scene.seam[t] ? palette.red : palette.plain)),
    legend: () => ({ swatches: [{ name: 'where two fronts met', colour: palette.red,
      count: tally(scene.seam, 2)[1] }] }) };
}

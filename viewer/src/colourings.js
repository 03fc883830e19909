// What the surface can be coloured by. Each colouring paints three corners of every triangle and
// tells its legend: swatches, or a scale.

import * as palette from './palette.js';

// Each gives a function that paints the corners of triangles in the order they lie in.
// colourOf(t, k): colour of corner k of triangle t.
const byCorner = (colourOf) => (colours, order) => {
  for (let i = 0, at = 0; i < order.length; ++i) {
    for (let k = 0; k < 3; ++k, at += 3) {
      const colour = colourOf(order[i], k);
      colours[at] = colour[0];
      colours[at + 1] = colour[1];
      colours[at + 2] = colour[2];
    }
  }
};
// colourOf(t): one colour for the triangle.
const byTriangle = (colourOf) => (colours, order) => {
  for (let i = 0, at = 0; i < order.length; ++i) {
    const colour = colourOf(order[i]);
    for (let k = 0; k < 3; ++k, at += 3) {
      colours[at] = colour[0];
      colours[at + 1] = colour[1];
      colours[at + 2] = colour[2];
    }
  }
};

function tally(numbers, size) {
  const counts = new Array(size).fill(0);
  for (const n of numbers) ++counts[n];
  return counts;
}

const short = (x) => Number(x.toPrecision(3)).toString();

// A table of colours for a scale, so that painting looks up and does not compute.
const steps = Array.from({ length: 256 }, (_, i) => palette.gradient(i / 255));
const onScale = (x) => steps[Math.min(255, Math.max(0, Math.round(255 * x)))];

export function colourings(scene) {
  const { mesh, page, complex } = scene;
  const list = [];
  const lazily = (make) => {
    let made;
    return () => (made ??= make());
  };

  if (scene.cells) {
    const kindOf = (t) => {
      // The kind that most corners have; the first corner's if all differ.
      const kind = (k) => complex.dimension(scene.cells[mesh.corners[3 * t + k]]);
      const second = kind(1);
      return second === kind(2) ? second : kind(0);
    };
    const kindsOf = lazily(() => Uint8Array.from({ length: mesh.triangleCount }, (_, t) => kindOf(t)));
    list.push({
      id: 'kind', label: 'Patch kind',
      paint: (...to) => {
        const kinds = kindsOf();
        byTriangle((t) => palette.kinds[kinds[t]])(...to);
      },
      legend: () => {
        const counts = tally(kindsOf(), 4);
        return { swatches: ['sphere, convex', 'hyperboloid, edge', 'hyperboloid, triangle',
          'sphere, hollow'].map((name, i) => ({ name, colour: palette.kinds[i], count: counts[i] })) };
      },
    });
    const scales = lazily(() => {
      const p = mesh.positions;
      const scale = Float32Array.from({ length: mesh.vertexCount }, (_, v) =>
        Math.log(complex.lengthScale(scene.cells[v], p[3 * v], p[3 * v + 1], p[3 * v + 2]) || 1e-9));
      let low = Infinity, high = -Infinity;
      for (const x of scale) {
        low = Math.min(low, x);
        high = Math.max(high, x);
      }
      return { scale, low, span: high - low || 1 };
    });
    list.push({
      id: 'scale', label: 'Length scale',
      paint: (...to) => {
        const { scale, low, span } = scales();
        byCorner((t, k) => onScale((scale[mesh.corners[3 * t + k]] - low) / span))(...to);
      },
      legend: () => {
        const { low, span } = scales();
        const at = (x) => short(Math.exp(low + x * span));
        return { scale: [at(0), at(0.5), at(1)], unit: 'Å, logarithmic' };
      },
    });
  }

  const angles = lazily(() => mesh.smallestAngles(page.about.min_angle_deg));
  const shares = lazily(() => [30, 35, 40].map((degrees) => {
    const below = angles().reduce((count, angle) => count + (angle < degrees), 0);
    return [degrees, `${short(100 * below / mesh.triangleCount)} %`];
  }));
  // By whole degrees of the scale; what lies beyond its ends is in the outer two.
  const bars = lazily(() => tally(angles().map((angle) =>
    Math.min(Math.max(Math.floor(angle - 20), 0), 39)), 40));
  list.push({
    id: 'quality', label: 'Triangle quality',
    paint: (...to) => {
      const least = angles();
      byTriangle((t) => onScale((least[t] - 20) / 40))(...to);
    },
    legend: () => ({ scale: ['20°', '40°', '60°'], bars: bars(),
      barsInWords: 'Histogram of the smallest angles: ' + shares().map(([degrees, share]) =>
        `${share} of the triangles below ${degrees} degrees`).join(', '),
      unit: 'smallest angle' + (page.about.min_angle_deg
        ? `; least ${page.about.min_angle_deg.toFixed(1)}°` : ''),
      more: 'below ' + shares().map(([degrees, share]) => `${degrees}°: ${share}`).join(', ') }),
  });

  const components = lazily(() => mesh.components());
  list.push({
    id: 'component', label: 'Component',
    paint: (...to) => {
      const number = components();
      const colours = tallyAll(number).map((_, i) => palette.categorical(i));
      byTriangle((t) => colours[number[t]])(...to);
    },
    legend: () => {
      const counts = tallyAll(components());
      return { swatches: counts.slice(0, 6).map((count, i) =>
        ({ name: `component ${i + 1}`, colour: palette.categorical(i), count })),
      more: counts.length > 6 ? `and ${counts.length - 6} more` : '' };
    },
  });

  if (scene.cells) {
    const atoms = lazily(() => {
      const p = mesh.positions;
      return Uint32Array.from({ length: mesh.triangleCount }, (_, t) => {
        const v = mesh.corners[3 * t];
        return complex.nearestAtom(scene.cells[v], p[3 * v], p[3 * v + 1], p[3 * v + 2]);
      });
    });
    list.push({
      id: 'atom', label: 'Atom',
      paint: (...to) => {
        const nearest = atoms();
        const shades = complex.atoms.map((_, atom) => atomShade(scene, atom));
        byTriangle((t) => shades[nearest[t]])(...to);
      },
      legend: () => ({ swatches: scene.elementsPresent().map(({ name, colour, count }) =>
        ({ name, colour, count })) , more: 'of the nearest atom, each in a shade of its own' }),
    });
  }

  if (page.has('mesh.region')) {
    const region = lazily(() => mesh.addParents(page.array('mesh.region')));
    list.push({
      id: 'region', label: 'Morse–Smale region',
      paint: (...to) => {
        const colours = scene.regionColours();
        const number = region();
        byTriangle((t) => colours[number[t]])(...to);
      },
      legend: () => ({ swatches: [], more: `${scene.regionCount().toLocaleString('en')} pairs of a ` +
        'minimum and a maximum, a colour each' }),
    });
  }

  if (page.about.function) {
    const values = lazily(() => scene.functionValues());
    list.push({
      id: 'value', label: 'Morse function',
      paint: (...to) => {
        const { value, low, span } = values();
        byCorner((t, k) => onScale((value[mesh.corners[3 * t + k]] - low) / span))(...to);
      },
      legend: () => {
        const { low, span } = values();
        return { scale: [short(low), short(low + span / 2), short(low + span)],
          unit: page.about.function.words.replace(/ along.*| from.*/, '') +
            ', ' + page.about.function.unit.replace('A', 'Å') };
      },
    });
  }

  if (scene.operation) {
    list.push({
      id: 'operation', label: 'Operation',
      paint: byTriangle((t) => palette.operations[scene.operation[t]]),
      legend: () => {
        const counts = tally(scene.operation, 5);
        return { swatches: scene.operationNames.map((name, i) =>
          ({ name, colour: palette.operations[i], count: counts[i] })), more: 'triangles each laid' };
      },
    });
  }

  list.push({
    id: 'plain', label: 'Plain',
    paint: byTriangle(() => palette.plain),
    legend: () => ({ swatches: [] }),
  });
  return list;
}

function tallyAll(numbers) {
  let most = -1;
  for (const n of numbers) most = Math.max(most, n);
  return tally(numbers, most + 1);
}

// The element's colour, a little lighter or darker for each atom.
function atomShade(scene, atom) {
  const colour = scene.elementColour(atom);
  const shade = 0.86 + 0.28 * ((atom * 0.618034) % 1);
  return colour.map((x) => Math.min(255, x * shade));
}

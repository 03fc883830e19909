// Triangles whose corners lie in different parts of space, cells or atoms' regions: which part a
// fragment lies in, as surface.js takes it. All functions here are linear on a triangle, so their
// values at its corners say it.

// By corner its part, between them the functions. Nothing is between corners of one part.
class CornerParts {
  constructor(scene, partOf) {
    this.scene = scene;
    this.partOf = partOf; // by vertex
  }

  // Writes the parts of a triangle's corners, and where they differ the functions: below 0 on the
  // side of the first of two corners. Says whether they differ.
  write(t, parts, between) {
    const { corners } = this.scene.mesh;
    for (let k = 0; k < 3; ++k) parts[k] = this.partOf[corners[3 * t + k]];
    if (parts[0] === parts[1] && parts[1] === parts[2]) return false;
    for (let k = 0; k < 3; ++k) {
      const to = (k + 1) % 3, values = between.subarray(3 * k, 3 * k + 3);
      if (parts[k] === parts[to]) values.fill(0);
      else this.separate(t, k, to, parts[k], parts[to], values);
    }
    return true;
  }

  place(t, k) {
    const { mesh } = this.scene, v = mesh.corners[3 * t + k];
    return mesh.positions.subarray(3 * v, 3 * v + 3);
  }
}

// Mixed cells: the wall between two. Those that share none are parted halfway.
export class CellParts extends CornerParts {
  constructor(scene) {
    super(scene, scene.cells);
  }

  separate(t, from, to, cell, other, values) {
    const wall = this.scene.complex.wallBetween(cell, other);
    for (let k = 0; k < 3; ++k) {
      const [x, y, z] = this.place(t, k);
      values[k] = wall ? wall[0] * x + wall[1] * y + wall[2] * z - wall[3]
        : Number(k === to) - Number(k === from);
    }
  }
}

// The nearest atoms, by power: where two are equal lies a plane.
export class AtomParts extends CornerParts {
  constructor(scene) {
    const { complex, cells, mesh: { positions: p } } = scene;
    super(scene, Uint32Array.from(cells, (cell, v) =>
      complex.nearestAtom(cell, p[3 * v], p[3 * v + 1], p[3 * v + 2])));
  }

  separate(t, from, to, atom, other, values) {
    const { complex } = this.scene;
    for (let k = 0; k < 3; ++k) {
      const place = this.place(t, k);
      values[k] = complex.power(atom, ...place) - complex.power(other, ...place);
    }
  }
}

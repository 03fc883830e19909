// Reads a mesh that was written as a front lays it: what each case means is told in
// app/front_code.h. Every line here has its mirror image there.

const Border = 0, New = 1, Next = 2, Previous = 3, Both = 4, Touch = 5, Old = 6;

// Front edges in flat arrays that grow: they are as many as half-edges at most.
class Edges {
  constructor(most) {
    this.origin = new Uint32Array(most);
    this.target = new Uint32Array(most);
    this.apex = new Uint32Array(most); // of the triangle on the mesh's side
    this.triangle = new Uint32Array(most); // that triangle
    this.next = new Uint32Array(most);
    this.previous = new Uint32Array(most);
    this.isOpen = new Uint8Array(most);
    this.count = 0;
  }

  add(origin, target, apex, triangle) {
    const e = this.count++;
    this.origin[e] = origin;
    this.target[e] = target;
    this.apex[e] = apex;
    this.triangle[e] = triangle;
    this.isOpen[e] = 1;
    return e;
  }

  link(e, f) {
    this.next[e] = f;
    this.previous[f] = e;
  }
}

// corners: three vertices to a triangle. parents: by triangle, the one it was laid against.
// predictors: by vertex p, q, r, whose p + q - r is near it.
export function readFrontCode(cases, references, triangleCount, vertexCount) {
  const corners = new Uint32Array(3 * triangleCount);
  const parents = new Uint32Array(triangleCount);
  const predictors = new Uint32Array(3 * vertexCount);
  const edges = new Edges(3 * triangleCount);
  let vertices = 0, triangles = 0, at = 0, reference = 0, head = 0;

  const addVertex = (p, q, r) => {
    predictors.set([p, q, r], 3 * vertices);
    return vertices++;
  };
  const addTriangle = (a, b, c, parent) => {
    corners[3 * triangles] = a;
    corners[3 * triangles + 1] = b;
    corners[3 * triangles + 2] = c;
    parents[triangles] = parent;
    return triangles++;
  };

  const start = () => {
    const corner = [0, 0, 0];
    for (let k = 0; k < 3; ++k) {
      if (cases[at++] === New) {
        const near = vertices === 0 ? 0 : vertices - 1;
        corner[k] = addVertex(near, near, near);
      } else {
        corner[k] = vertices - 1 - references[reference++];
      }
    }
    const n = addTriangle(...corner, triangles === 0 ? 0 : triangles - 1);
    const e = corner.map((v, k) => edges.add(v, corner[(k + 1) % 3], corner[(k + 2) % 3], n));
    for (let k = 0; k < 3; ++k) edges.link(e[k], e[(k + 1) % 3]);
  };

  const layWedge = (e, which) => {
    const a = edges.origin[e], b = edges.target[e];
    const next = edges.next[e], previous = edges.previous[e];
    let v, after = -1, before = -1;
    if (which === New) {
      v = addVertex(a, b, edges.apex[e]);
    } else if (which === Touch) {
      after = edges.count - 1 - references[reference++];
      before = edges.previous[after];
      v = edges.origin[after];
    } else {
      v = vertices - 1 - references[reference++];
    }
    const n = addTriangle(b, a, v, edges.triangle[e]);
    const f = edges.add(a, v, b, n);
    const g = edges.add(v, b, a, n);
    edges.link(previous, f);
    edges.link(g, next);
    if (after < 0) {
      edges.link(f, g);
    } else {
      edges.link(f, after);
      edges.link(before, g);
    }
  };

  const layBeyond = (e) => {
    const which = cases[at++];
    edges.isOpen[e] = 0;
    if (which === Border) return;
    const a = edges.origin[e], b = edges.target[e];
    const next = edges.next[e], previous = edges.previous[e];
    if (which === Both) {
      addTriangle(b, a, edges.target[next], edges.triangle[e]);
      edges.isOpen[next] = 0;
      edges.isOpen[previous] = 0;
      edges.link(edges.previous[previous], edges.next[next]);
    } else if (which === Next) {
      const v = edges.target[next];
      const n = addTriangle(b, a, v, edges.triangle[e]);
      edges.isOpen[next] = 0;
      const f = edges.add(a, v, b, n);
      edges.link(previous, f);
      edges.link(f, edges.next[next]);
    } else if (which === Previous) {
      const v = edges.origin[previous];
      const n = addTriangle(b, a, v, edges.triangle[e]);
      edges.isOpen[previous] = 0;
      const f = edges.add(v, b, a, n);
      edges.link(edges.previous[previous], f);
      edges.link(f, next);
    } else {
      layWedge(e, which);
    }
  };

  while (triangles < triangleCount) {
    start();
    for (; head < edges.count; ++head) if (edges.isOpen[head]) layBeyond(head);
  }
  return { corners, parents, predictors };
}

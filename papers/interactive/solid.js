// A small mesh drawn on a canvas, far triangles first: turned by dragging or the arrow keys.

export class Solid {
  // draw is asked for the scene at each drawing: {positions, triangles, colour(t), mark(t), bold(t), points,
  // middle, radius}; bold(t) are sides of a triangle to draw thick, side k from corner k to the next.
  constructor(label, scene, { pick, turned, share = 0.75 } = {}) {
    Object.assign(this, { scene, pick, turned, share, turn: [0.5, 0.45], zoom: 1 });
    this.canvas = document.createElement('canvas');
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'application');
    this.canvas.setAttribute('aria-label', `${label}; arrow keys turn it`);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    this.#listen();
  }

  #listen() {
    const { canvas } = this;
    let from = null, moved = 0;
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      from = [event.clientX, event.clientY];
      moved = 0;
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!from) return;
      const d = [event.clientX - from[0], event.clientY - from[1]];
      moved += Math.hypot(...d);
      from = [event.clientX, event.clientY];
      this.#turnBy(d[0] / 120, d[1] / 120);
    });
    canvas.addEventListener('pointerup', (event) => {
      if (from && moved < 6) this.#pickAt(event);
      from = null;
    });
    canvas.addEventListener('pointercancel', () => { from = null; });
    const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
    canvas.addEventListener('keydown', (event) => {
      if (!keys[event.key]) return;
      event.preventDefault();
      this.#turnBy(...keys[event.key]);
    });
  }

  #turnBy(x, y) {
    this.turn = [this.turn[0] + x, Math.max(-1.5, Math.min(1.5, this.turn[1] + y))];
    this.draw();
    this.turned?.();
  }

  // Turned so that what faces along a direction faces the eye.
  face([x, y, z]) {
    this.turn = [Math.atan2(-x, z), Math.atan2(y, Math.hypot(x, z))];
  }

  #pickAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = event.clientX - box.left, y = event.clientY - box.top;
    for (const { t, p } of [...this.drawn].reverse()) {
      const side = [0, 1, 2].map((k) => {
        const [a, b] = [p[k], p[(k + 1) % 3]];
        return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      });
      if (side.every((s) => s >= 0) || side.every((s) => s <= 0)) {
        const corner = [0, 1, 2].reduce((best, k) =>
          (Math.hypot(p[k][0] - x, p[k][1] - y) < Math.hypot(p[best][0] - x, p[best][1] - y) ? k : best), 0);
        this.pick?.(t, corner);
        return;
      }
    }
  }

  draw() {
    const { canvas } = this, width = canvas.clientWidth;
    if (width === 0) return;
    const height = Math.round(width * this.share), dots = window.devicePixelRatio || 1;
    canvas.style.height = `${height}px`;
    canvas.width = width * dots;
    canvas.height = height * dots;
    const { positions, triangles, colour, mark, bold, points = [], middle, radius } = this.scene();
    const [ca, sa, cb, sb] = [Math.cos(this.turn[0]), Math.sin(this.turn[0]), Math.cos(this.turn[1]), Math.sin(this.turn[1])];
    const scale = (this.zoom * Math.min(width, height) * 0.47) / radius;
    const seen = positions.map((q) => {
      const [x, y, z] = q.map((c, k) => c - middle[k]);
      const u = ca * x + sa * z, d = -sa * x + ca * z;
      return [width / 2 + scale * u, height / 2 - scale * (cb * y - sb * d), sb * y + cb * d];
    });
    this.drawn = triangles.map((corners, t) => {
      const p = corners.map((v) => seen[v]);
      const area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
      const long = Math.max(...[0, 1, 2].map((k) => Math.hypot(...positions[corners[k]].map((c, n) => c - positions[corners[(k + 1) % 3]][n]))));
      return { t, p, isFront: area < 0, light: Math.min(1, Math.abs(area) / (0.75 * (scale * long) ** 2 + 1e-9)),
        depth: p[0][2] + p[1][2] + p[2][2] + (mark?.(t) ? long : 0) }; // outlines over what lies beside
    }).sort((a, b) => a.depth - b.depth);
    const context = canvas.getContext('2d'), style = getComputedStyle(document.documentElement);
    context.scale(dots, dots);
    context.lineJoin = 'round';
    for (const { t, p, isFront, light } of this.drawn) {
      context.beginPath();
      p.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
      context.closePath();
      const [r, g, b] = colour(t, isFront), shade = 0.62 + 0.38 * light;
      context.fillStyle = `rgb(${[r, g, b].map((c) => Math.round(c * shade)).join()})`;
      context.fill();
      context.lineWidth = mark?.(t) ? 3 : 0.7;
      context.strokeStyle = mark?.(t) ? style.getPropertyValue('--accent') : 'rgba(20,24,30,0.75)';
      context.stroke();
      for (const k of bold?.(t) ?? []) {
        context.beginPath();
        context.moveTo(...p[k].slice(0, 2));
        context.lineTo(...p[(k + 1) % 3].slice(0, 2));
        context.lineWidth = 3;
        context.strokeStyle = style.getPropertyValue('--front');
        context.stroke();
      }
    }
    for (const { v, colour: fill } of points) {
      context.beginPath();
      context.arc(seen[v][0], seen[v][1], 5, 0, 7);
      context.fillStyle = fill;
      context.fill();
    }
  }
}

export function ballAround(positions) {
  const least = [0, 1, 2].map((k) => Math.min(...positions.map((p) => p[k])));
  const most = [0, 1, 2].map((k) => Math.max(...positions.map((p) => p[k])));
  const middle = least.map((x, k) => (x + most[k]) / 2);
  return { middle, radius: Math.max(...positions.map((p) => Math.hypot(...p.map((x, k) => x - middle[k])))) };
}

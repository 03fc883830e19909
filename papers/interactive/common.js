// What all interactive parts share: a question to predict, sliders, buttons, a plane to draw in.

import { element, shape } from '../../viewer/src/dom.js';

export { element, shape };

export const data = () => JSON.parse(document.getElementById('data').textContent);

// A question with answers to choose from; each has a reply, one of them is right.
export function question(text, answers) {
  const reply = element('p', { class: 'reply', 'aria-live': 'polite' }, 'Predict first.');
  const buttons = answers.map((answer) => element('button', { type: 'button',
    'aria-pressed': 'false', onclick: (event) => {
      for (const button of buttons) button.setAttribute('aria-pressed', button === event.target);
      reply.replaceChildren(element('b', { class: answer.isRight ? 'good' : 'bad' },
        answer.isRight ? 'Right. ' : 'Not so. '), answer.reply);
    } }, answer.text));
  return element('section', { class: 'question', 'aria-label': 'A question to predict' },
    element('p', {}, text), element('div', { class: 'row' }, ...buttons), reply);
}

export function slider({ label, min, max, step, value, shown = (x) => x.toFixed(2), change }) {
  const output = element('output', {}, shown(value));
  const input = element('input', { type: 'range', min, max, step, value, 'aria-label': label,
    oninput: () => {
      output.textContent = shown(Number(input.value));
      change(Number(input.value));
    } });
  const row = element('label', { class: 'slider' }, element('span', {}, label), output, input);
  row.set = (x) => {
    input.value = x;
    output.textContent = shown(x);
  };
  row.input = input;
  return row;
}

export function button(text, click, attributes = {}) {
  return element('button', { type: 'button', onclick: click, ...attributes }, text);
}

// A button that plays a part until `advance`, a step, says that there is no more, or isPlaying falls.
// @param begin  called first: goes back to the start where there is nothing left to play
export function player(state, pause, begin, advance) {
  let next; // what comes next; who starts again forgets it, or two would run at once
  const play = button('play', () => {
    clearTimeout(next);
    state.isPlaying = !state.isPlaying;
    begin();
    const tick = () => {
      play.textContent = state.isPlaying ? 'pause' : 'play';
      if (!state.isPlaying) return;
      state.isPlaying = advance();
      next = setTimeout(tick, pause);
    };
    tick();
  });
  return play;
}

export function check(text, isOn, change) {
  const box = element('input', { type: 'checkbox', onchange: () => change(box.checked) });
  box.checked = isOn;
  return element('label', { class: 'box' }, box, text);
}

// A drawing in the plane: a window of the world, `width` wide about `middle`, y upwards.
export class Plane {
  constructor(label, { width, share = 0.75, middle = [0, 0] }) {
    Object.assign(this, { width, share, middle });
    this.pixels = 600;
    this.layer = shape('g');
    this.handles = shape('g'); // stay in place when all else is drawn anew, or focus would be lost
    this.svg = shape('svg', { role: 'group', 'aria-label': label }, this.layer, this.handles);
    new ResizeObserver(() => this.fit()).observe(this.svg);
  }

  // Called again whenever the window's width changes; `draw` puts the drawing in place.
  fit() {
    const pixels = this.svg.clientWidth;
    if (pixels === 0 || pixels === this.pixels) return;
    this.pixels = pixels;
    this.draw?.();
  }

  get height() {
    return this.pixels * this.share;
  }

  get scale() {
    return this.pixels / this.width;
  }

  at([x, y]) {
    return [this.pixels / 2 + (x - this.middle[0]) * this.scale,
      this.height / 2 - (y - this.middle[1]) * this.scale];
  }

  show(...children) {
    this.svg.setAttribute('viewBox', `0 0 ${this.pixels} ${this.height}`);
    this.layer.replaceChildren(...children.flat(Infinity).filter((child) => child));
    for (const handle of this.handles.children) handle.put();
  }

  path(points, attributes, isClosed = false) {
    const text = points.map((p) => this.at(p).map((x) => x.toFixed(2)).join(' ')).join('L');
    return shape('path', { d: `M${text}${isClosed ? 'Z' : ''}`, fill: 'none', ...attributes });
  }

  circle(centre, radius, attributes) {
    const [cx, cy] = this.at(centre);
    return shape('circle', { cx, cy, r: radius * this.scale, fill: 'none', ...attributes });
  }

  dot(centre, r, attributes) {
    const [cx, cy] = this.at(centre);
    return shape('circle', { cx, cy, r, ...attributes });
  }

  text(at, words, attributes) {
    const [x, y] = this.at(at);
    return shape('text', { x, y, ...attributes }, words);
  }

  // Something to take hold of with a finger, a mouse or the arrow keys. `move` gets the new place.
  handle(now, label, move, { r = 7, colour = 'var(--text)', step = this.width / 120 } = {}) {
    const group = shape('g', { class: 'handle', tabindex: 0, role: 'button', 'aria-label': label });
    const put = () => group.replaceChildren(
      this.dot(now(), 20, { fill: 'transparent', class: 'halo' }), this.dot(now(), r, { fill: colour }));
    group.put = put;
    this.handles.append(group);
    put();
    const to = (event) => {
      const box = this.svg.getBoundingClientRect();
      return [this.middle[0] + (event.clientX - box.left - this.pixels / 2) / this.scale,
        this.middle[1] - (event.clientY - box.top - this.height / 2) / this.scale];
    };
    group.addEventListener('pointerdown', (event) => {
      group.setPointerCapture(event.pointerId);
      group.isHeld = true;
      group.focus();
      event.preventDefault();
    });
    group.addEventListener('pointermove', (event) => group.isHeld && move(to(event)));
    for (const end of ['pointerup', 'pointercancel']) {
      group.addEventListener(end, () => { group.isHeld = false; });
    }
    const directions = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    group.addEventListener('keydown', (event) => {
      const direction = directions[event.key];
      if (!direction) return;
      event.preventDefault();
      const length = event.shiftKey ? step / 10 : step;
      move(now().map((x, k) => x + direction[k] * length), direction);
    });
    return group;
  }
}

// Says that the page works, to the tests and to whoever embeds it.
export function ready() {
  document.documentElement.dataset.ready = Math.round(performance.now());
  const tell = () => parent !== window &&
    parent.postMessage({ interactiveHeight: document.documentElement.scrollHeight }, '*');
  new ResizeObserver(tell).observe(document.body);
}

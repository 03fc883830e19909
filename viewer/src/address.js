// The viewer's state in the page's address, after #: what differs from how the page opens, and the
// eye where it was moved. So a link opens the page as it was, and a lesson can embed it so.

import { decimals } from './headline.js';

const kept = ['style', 'colouring', 'edges', 'seeThrough', 'atoms', 'points', 'lines', 'spheres',
  'simplified', 'section', 'cut', 'axis', 'offset', 'level', 'share', 'hidden', 'panel', 'step',
  'frame'];
const pause = 250; // milliseconds without a change before the address is written

const digits = (numbers, places = 6) => numbers.map((x) => Number(x.toFixed(places))).join(',');

export class Address {
  constructor(viewer) {
    this.viewer = viewer;
    this.first = { ...viewer.state };
    this.home = this.#eye();
    this.#read();
    window.addEventListener('hashchange', () => this.#read());
    viewer.stage.onDraw.push(() => {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.write(), pause);
    });
  }

  #eye() {
    const { camera, controls, bounds: { radius } } = this.viewer.stage;
    return digits([...camera.position.toArray(), ...controls.target.toArray()],
      decimals(6, radius / 1e4));
  }

  text() {
    const { state } = this.viewer, words = new URLSearchParams();
    for (const name of kept) {
      if (state[name] === this.first[name]) continue;
      words.set(name, typeof state[name] === 'boolean' ? Number(state[name]) : state[name]);
    }
    // The eye may have moved since.
    if (state.axis === 'view') words.set('axis', digits(this.viewer.normal));
    if (this.#eye() !== this.home) words.set('eye', this.#eye());
    return words.toString().replaceAll('%2C', ',');
  }

  // A page put into another as its text, as notebooks do, has no address.
  get isThere() {
    return location.protocol !== 'about:';
  }

  write() {
    const text = this.text();
    if (!this.isThere || text === location.hash.slice(1)) return;
    history.replaceState(null, '', text ? `#${text}` : location.pathname + location.search);
  }

  // What the address does not tell is as the page opened; what makes no sense here, in an address
  // from another page, is passed over. What plays stops, or it would go on from where it was.
  #read() {
    const changes = Object.fromEntries(kept.map((name) => [name, this.first[name]]));
    Object.assign(changes, { playing: false, growing: false });
    let eye = this.home, normal;
    for (const [name, word] of new URLSearchParams(location.hash.slice(1))) {
      const was = this.first[name];
      if (name === 'eye') eye = word;
      if (!kept.includes(name)) continue;
      if (typeof was === 'boolean') {
        const isThere = name === 'panel' || this.viewer.panel.rows[name];
        if (isThere) changes[name] = word === '1';
      } else if (typeof was === 'number') {
        if (word !== '' && Number.isFinite(Number(word))) changes[name] = this.#within(name, Number(word));
      } else if (name === 'hidden') {
        if (this.#areComponents(word)) changes[name] = word;
      } else if (name === 'axis' && this.#isNormal(word)) {
        changes.axis = 'view';
        normal = word.split(',').map(Number);
      } else if (this.#choices(name).includes(word)) {
        changes[name] = word;
      }
    }
    if (eye !== this.#eye()) this.#look(eye.split(','));
    if (normal || changes.axis !== this.viewer.state.axis) this.viewer.setAxis(changes.axis, normal);
    this.viewer.set(changes);
  }

  #within(name, x) {
    if (name === 'offset') return Math.max(-1, Math.min(1, x));
    if (name === 'share') return Math.max(0, Math.min(1, x));
    const most = name === 'step' ? this.viewer.sweep?.steps : this.viewer.growth?.frames.length;
    return Math.max(0, Math.min(most ?? 0, Math.round(x)));
  }

  // Numbers of components, ascending, or nothing. Where the panel has no list of them none can be
  // shown again.
  #areComponents(word) {
    if (word === '') return true;
    if (!this.viewer.panel.components) return false;
    const count = this.viewer.scene.components().list.length;
    return word.split(',').every((part, i, all) => /^\d{1,9}$/.test(part) && part < count &&
      (i === 0 || Number(all[i - 1]) < Number(part)));
  }

  // Three numbers, of length 1 as far as an address tells.
  #isNormal(word) {
    const numbers = word.split(',').map(Number);
    return Boolean(this.viewer.section) && numbers.length === 3 &&
      Math.abs(Math.hypot(...numbers) - 1) < 1e-5;
  }

  #choices(name) {
    if (name === 'style') return ['smooth', 'flat', 'wire', 'off'];
    if (name === 'axis') return this.viewer.section ? ['x', 'y', 'z'] : [];
    return this.viewer.colourings.map(({ id }) => id);
  }

  // Not from where, nor at what, nothing of the surface is seen.
  #look(words) {
    const { camera, controls, bounds: { middle } } = this.viewer.stage;
    const numbers = words.filter((word) => word !== '').map(Number);
    const isNear = (at) => Math.hypot(...middle.map((x, k) => numbers[at + k] - x)) < camera.far;
    if (numbers.length !== 6 || !isNear(0) || !isNear(3)) return;
    camera.position.fromArray(numbers, 0);
    controls.target.fromArray(numbers, 3);
    controls.update();
  }
}

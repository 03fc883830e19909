// The viewer: the state of everything that can be switched, and what follows from a change of it.

import { Address } from './address.js';
import { colourings } from './colourings.js';
import { element, icon } from './dom.js';
import { Growth } from './growth.js';
import { atomLayer, lineLayer, pointLayer, SectionLayer, sphereLayer } from './layers.js';
import { facts, pick } from './inspector.js';
import { functionLevel } from './level.js';
import { Panel } from './panel.js';
import { playGrowth, playSweep } from './playing.js';
import { ScaleBar } from './scale_bar.js';
import { Scene } from './scene.js';
import { Stage } from './stage.js';
import { Surface } from './surface.js';
import { Sweep } from './sweep.js';

const axes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

export class Viewer {
  constructor(page, container, panelRoot) {
    this.scene = new Scene(page);
    this.stage = new Stage(container, this.scene.bounds);
    this.surface = new Surface(this.scene.mesh, this.scene.normals(), this.scene.order());
    this.stage.world.add(this.surface.group);
    this.colourings = colourings(this.scene);
    if (page.has('mesh.birth')) this.sweep = new Sweep(this.scene);
    if (page.about.growth) this.growth = new Growth(this.scene, this.surface.uniforms.plane);
    if (this.scene.complex) this.section = new SectionLayer(this.scene.complex);
    this.layers = {}; // made when they are first shown
    this.state = {
      style: 'smooth', colouring: this.colourings[0].id, edges: false, seeThrough: false,
      atoms: false, points: false, lines: false, spheres: false, simplified: false,
      section: false, cut: false, axis: 'z', offset: 0, panel: true, hidden: '',
      level: false, share: 0.5, step: this.sweep?.steps ?? 0, playing: false,
      frame: this.growth?.frames.length ?? 0, growing: false,
    };
    this.normal = axes.z;
    this.panel = new Panel(panelRoot, this);
    this.#paint();
    this.panel.update();
    this.stage.fit(); // again: on a phone the panel has just taken its share of the window
    this.#furnish(container);
    this.address = new Address(this);
  }

  // What lies over the canvas: the scale, and while the panel is folded its answer to a click and a
  // way back to it.
  #furnish(container) {
    new ScaleBar(this.stage);
    container.append(this.panel.answer, element('button', { type: 'button', id: 'unfold',
      title: 'The panel again (P)', 'aria-label': 'Show the panel',
      onclick: () => this.set({ panel: true }) }, icon('panel')));
    const canvas = this.stage.renderer.domElement;
    let from;
    // A second finger makes it no click.
    canvas.addEventListener('pointerdown', (event) => {
      from = event.isPrimary ? [event.clientX, event.clientY] : null;
    });
    canvas.addEventListener('pointerup', (event) => {
      if (event.button !== 0 || !from) return;
      if (Math.hypot(event.clientX - from[0], event.clientY - from[1]) < 4) this.inspect(event.clientX, event.clientY);
    });
  }

  // Tells of what is under a point of the window; of nothing, where the surface is not.
  inspect(clientX, clientY) {
    if (!this.surface.group.visible) return;
    const box = this.stage.container.getBoundingClientRect();
    const found = pick(this, (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height);
    this.panel.tell(found && facts(this.scene, found));
  }

  savePicture() {
    this.stage.drawNow();
    this.stage.renderer.domElement.toBlob((blob) => {
      const link = element('a', { href: URL.createObjectURL(blob),
        download: `${this.scene.page.about.title.replace(/[^\w.-]+/g, '_')}.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
  }

  // Where a page from a file may not write to the clipboard, the address bar has the link too.
  async copyLink() {
    if (!this.address.isThere) return this.panel.say('This page has no address to link to.');
    this.address.write();
    try {
      await navigator.clipboard.writeText(location.href);
      this.panel.say('The link is copied.');
    } catch {
      this.panel.say('The link is in the address bar.');
    }
  }

  has(layer) {
    const { page, points } = this.scene;
    if (layer === 'level') return Boolean(page.about.function);
    if (layer === 'atoms' || layer === 'section') return Boolean(this.scene.complex);
    if (layer === 'lines') return page.has('lines.index');
    return Boolean(points && points.length > 0);
  }

  get colouring() {
    return this.colourings.find(({ id }) => id === this.state.colouring);
  }

  // The critical points that are shown.
  shownPoints() {
    return this.scene.points.filter(({ survives }) => survives || !this.state.simplified);
  }

  // Those of them that have a protecting sphere: a cancelled one has none.
  shownSpheres() {
    return this.shownPoints().filter(({ radius }) => radius > 0);
  }

  set(changes) {
    const what = new Set(Object.keys(changes).filter((name) => this.state[name] !== changes[name]));
    if (what.size === 0) return;
    Object.assign(this.state, changes);
    const changed = (...names) => names.some((name) => what.has(name));
    this.scene.isSimplified = this.state.simplified;
    const isRegion = this.state.colouring === 'region';
    if (changed('colouring') || (changed('simplified') && isRegion)) this.#paint();
    if (changed('style', 'edges', 'seeThrough', 'cut')) this.#dress();
    if (changed('section', 'cut', 'axis', 'offset')) this.#cut();
    if (changed('atoms', 'points', 'lines', 'spheres', 'simplified', 'section')) this.#showLayers();
    if (changed('hidden')) this.#hide();
    if (changed('step', 'hidden')) this.#showStep();
    if (changed('frame')) this.#showFrame();
    if (changed('level', 'share', 'step')) this.#showLevel();
    this.panel.update(what);
    if (changed('panel')) requestAnimationFrame(() => this.stage.resize());
    this.stage.draw(changed('offset', 'share', 'step', 'frame'));
  }

  #paint() {
    this.surface.paint(this.colouring);
  }

  #dress() {
    this.surface.set(this.state);
    this.#showFrame();
  }

  // The plane's normal: x, y or z; or `view`, for which it is given or points to the eye.
  setAxis(axis, normal = axes[axis] ?? this.#towardsEye()) {
    this.normal = normal;
    // The same name again, for a new view, is a change too.
    if (axis === this.state.axis) this.state.axis = '';
    this.set({ axis });
  }

  #towardsEye() {
    const { camera, controls } = this.stage;
    return camera.position.clone().sub(controls.target).normalize().toArray();
  }

  #cut() {
    const { middle, radius } = this.scene.bounds;
    const along = this.normal.reduce((sum, n, k) => sum + n * middle[k], 0);
    const offset = along + this.state.offset * radius;
    this.surface.uniforms.plane.value.set(...this.normal, offset);
    if (this.state.section) this.section.update(this.normal, offset, middle, 1.12 * radius);
  }

  #layer(name, make) {
    if (!this.layers[name]) {
      this.layers[name] = make();
      this.stage.world.add(this.layers[name]);
    }
    return this.layers[name];
  }

  // Shows or hides a layer that has a form of its own for the simplified complex.
  #showForm(name, make) {
    for (const simplified of [false, true]) {
      const form = simplified ? `${name}, simplified` : name;
      const isShown = this.state[name] && this.state.simplified === simplified;
      if (isShown) this.#layer(form, () => make(simplified)).visible = true;
      else if (this.layers[form]) this.layers[form].visible = false;
    }
  }

  #showLayers() {
    const { scene, state, stage } = this;
    if (state.atoms) this.#layer('atoms', () => atomLayer(scene));
    if (this.layers.atoms) this.layers.atoms.visible = state.atoms;
    this.#showForm('points', () => pointLayer(this.shownPoints(), stage.finest));
    this.#showForm('lines', (simplified) =>
      lineLayer(scene.page, simplified ? 'kept_lines' : 'lines', scene.centre));
    this.#showForm('spheres', () => sphereLayer(this.shownSpheres()));
    if (this.section) {
      if (state.section) this.#layer('section', () => this.section.group);
      this.section.group.visible = state.section;
    }
  }

  hiddenComponents() {
    return new Set(this.state.hidden === '' ? [] : this.state.hidden.split(',').map(Number));
  }

  #hide() {
    const { ofTriangle } = this.scene.components(), hidden = this.hiddenComponents();
    this.scene.isHidden = hidden.size > 0 ? (t) => hidden.has(ofTriangle[t]) : () => false;
    this.surface.hide(this.scene.isHidden);
  }

  // The value of the Morse function that is shown: where the sweep is, or the one chosen.
  level() {
    const { low, high } = this.scene.functionRange();
    if (!this.sweep) return low + this.state.share * (high - low);
    if (this.state.step === this.sweep.steps) return high;
    const level = this.sweep.level(); // of no triangle none
    return Number.isNaN(level) ? low : Math.max(low, level);
  }

  #showLevel() {
    if (!this.state.level && !this.functionLevel) return;
    this.functionLevel ??= functionLevel(this.scene);
    this.#layer('level', () => this.functionLevel.group).visible = this.state.level;
    this.functionLevel.show(this.level());
  }

  goTo(step) {
    this.set({ step: Math.max(0, Math.min(this.sweep.steps, Math.round(step))), playing: false });
  }

  #showStep() {
    if (!this.sweep) return;
    this.sweep.go(this.state.step);
    if (this.sweep.front && !this.sweep.frontObject.parent) {
      this.stage.world.add(this.sweep.frontObject);
    }
    this.surface.show(this.sweep.triangles());
    this.#showFront();
  }

  // The front is the mesh's: over a frame of the growth there is none.
  #showFront() {
    if (!this.sweep?.front) return;
    this.sweep.frontObject.visible = this.isGrown() && this.sweep.frontEdges > 0;
  }

  togglePlay() {
    if (this.sweep) playSweep(this);
  }

  goToFrame(frame) {
    this.set({ frame, growing: false });
  }

  // The surface, or the frame of the growth in its place.
  #showFrame() {
    this.growth?.show(this.state.frame, this.stage.world, this.state);
    this.surface.group.visible = this.isGrown() && this.state.style !== 'off';
    this.#showFront();
  }

  // Whether the mesh itself is there, not a frame of the growth.
  isGrown() {
    return this.state.frame === (this.growth?.frames.length ?? 0);
  }

  toggleGrowth() {
    if (this.growth) playGrowth(this);
  }

  nextColouring(by) {
    const ids = this.colourings.map(({ id }) => id);
    const at = ids.indexOf(this.state.colouring);
    this.set({ colouring: ids[(at + by + ids.length) % ids.length] });
  }

  turnTheme() {
    const root = document.documentElement;
    root.dataset.theme = this.isDark() ? 'light' : 'dark';
    this.showTheme();
  }

  isDark() {
    const asked = document.documentElement.dataset.theme;
    return asked ? asked === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  }

  // The canvas takes its background from the style sheet.
  showTheme() {
    const style = getComputedStyle(document.documentElement);
    this.stage.setBackground(style.getPropertyValue('--canvas').trim());
  }

  toggleHelp() {
    const help = document.getElementById('help');
    if (help.open) return help.close();
    help.showModal();
    help.scrollTop = 0; // the button at its end has the focus, and may be out of view
  }
}

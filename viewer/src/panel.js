// The panel: what is shown, with its legend, counts and switches. It reads and changes the viewer's
// state through the functions it is given, and follows when the state changes by other ways.

import { ComponentList } from './components.js';
import { choice, counted, element, histogram, icon, number, section, showPlaying, toggle } from './dom.js';
import { certificateLine, headline, levelInWords, signed } from './headline.js';
import { inOneLine } from './inspector.js';
import { levelColour } from './level.js';
import * as palette from './palette.js';

const css = palette.hex;
const rounded = (x) => Number(x.toPrecision(4)); // as reports tell it

export class Panel {
  constructor(root, viewer) {
    this.viewer = viewer;
    this.rows = {};
    const { about } = viewer.scene.page;
    document.title = `${about.title} – morskin`;
    const body = element('div', { class: 'body' });
    this.told = section('Clicked', element('table', { class: 'told' }));
    this.told.hidden = true;
    this.told.setAttribute('aria-live', 'polite');
    this.answer = element('p', { id: 'answer', role: 'status' });
    body.append(this.told, this.#surface());
    if (viewer.scene.components().list.length > 1) {
      this.components = new ComponentList(viewer);
      body.append(this.components.root);
    }
    if (viewer.sweep) body.append(this.#sweep());
    if (viewer.growth) body.append(this.#growth());
    const layers = this.#layers();
    if (layers) body.append(layers);
    if (viewer.section) body.append(this.#plane());
    body.append(element('p', { class: 'foot' }, `morskin ${about.version}`,
      viewer.scene.page.about.C ? ` · C ${rounded(about.C)}, Q ${rounded(about.Q)}` : '',
      about.function ? ` · ${about.function.words}` : ''));
    this.fold = element('button', { type: 'button', class: 'fold', 'aria-expanded': 'true',
      title: 'Fold or unfold the panel (P)', 'aria-label': 'Fold or unfold the panel',
      onclick: () => viewer.set({ panel: !viewer.state.panel }) }, icon('fold'));
    const button = (shape, title, act) => element('button', { type: 'button', class: 'icon', title,
      'aria-label': title, onclick: act }, icon(shape));
    const header = element('header', {},
      element('div', { class: 'title' },
        element('h1', { title: about.title }, about.title),
        button('fit', 'Look at all of it (F)', () => viewer.stage.fit()),
        button('picture', 'Save the picture (PNG)', () => viewer.savePicture()),
        button('link', 'Copy a link to this view', () => viewer.copyLink()),
        button('theme', 'Dark or light (D)', () => viewer.turnTheme()),
        button('help', 'Keys and help (H)', () => viewer.toggleHelp()),
        this.fold),
      element('p', { class: 'counts' }, headline(about)), certificateLine(about) ?? '');
    root.append(header, body);
    this.root = root;
  }

  // rows: pairs of words about what was clicked, or nothing.
  tell(rows) {
    this.told.hidden = !rows;
    this.told.querySelector('table').replaceChildren(...(rows ?? []).map(([name, words]) =>
      element('tr', {}, element('th', { scope: 'row' }, name), element('td', {}, words))));
    if (rows) this.told.scrollIntoView({ block: 'nearest' });
    this.facts = rows;
    this.#showAnswer();
  }

  // While the panel is folded, a line over the surface tells in its place.
  #showAnswer() {
    this.answer.textContent = this.facts && !this.viewer.state.panel ? inOneLine(this.facts) : '';
  }

  say(words) {
    this.tell([['', words]]);
  }

  #surface() {
    const { viewer } = this;
    this.style = choice('Surface', [['smooth', 'Smooth', '1'], ['flat', 'Flat', '2'],
      ['wire', 'Wire', '3'], ['off', 'Off', '4']], viewer.state.style,
    (style) => viewer.set({ style }));
    this.colour = element('select', { id: 'colour', 'aria-label': 'Colour of the surface',
      title: 'Colour of the surface (C)',
      onchange: () => viewer.set({ colouring: this.colour.value }) },
    ...viewer.colourings.map(({ id, label }) => element('option', { value: id }, label)));
    this.legend = element('div', { class: 'legend' });
    this.rows.edges = toggle({ id: 'edges', label: 'Triangles’ sides', key: 'E',
      change: (edges) => viewer.set({ edges }) });
    this.rows.seeThrough = toggle({ id: 'seeThrough', label: 'See through', key: 'X',
      change: (seeThrough) => viewer.set({ seeThrough }) });
    return section('Surface', this.style,
      element('label', { class: 'row', for: 'colour' }, element('span', {}, 'Colour'), this.colour),
      this.legend, element('div', { class: 'pair' }, this.rows.edges, this.rows.seeThrough));
  }

  #layers() {
    const { viewer } = this, { about } = viewer.scene.page, rows = [];
    const add = (id, row) => {
      this.rows[id] = toggle({ id, ...row, change: (on) => viewer.set({ [id]: on }) });
      rows.push(this.rows[id]);
    };
    if (viewer.has('atoms')) {
      add('atoms', { label: 'Atoms', key: 'A', count: number(about.atoms),
        colours: viewer.scene.elementsPresent().slice(0, 4).map(({ colour }) => css(colour)) });
    }
    if (viewer.has('points')) {
      add('points', { label: 'Critical points', key: 'K',
        colours: [palette.red, palette.blue, palette.green].map(css),
        title: 'Minima red, saddles blue, maxima green (K)' });
    }
    if (viewer.has('lines')) {
      add('lines', { label: 'Integral lines', key: 'L',
        colours: [palette.red, palette.green].map(css),
        title: 'Saddle to minimum red, saddle to maximum green (L)' });
    }
    if (viewer.has('spheres')) {
      add('spheres', { label: 'Protecting spheres', key: 'S' });
    }
    if (viewer.has('points')) {
      add('simplified', { label: 'Simplified complex', key: 'I',
        title: 'Without what was cancelled (I)' });
      this.pointKey = element('p', { class: 'note' });
      rows.splice(rows.length - 1, 0, this.pointKey);
    }
    if (viewer.has('level')) {
      const isHeight = about.function.kind === 'height';
      add('level', { label: isHeight ? 'Direction and level' : 'Centre and level', key: 'V',
        colours: [css(levelColour)], title: `${about.function.words}; its level ` +
          (viewer.sweep ? 'where the sweep is (V)' : 'where the slider is (V)') });
      rows.push(this.#levelSlider());
    }
    if (viewer.has('section')) {
      add('section', { label: 'Mixed cells', key: 'M', colours: palette.kinds.map(css),
        title: 'Cut by a plane (M)' });
    }
    return rows.length > 0 ? section('Layers', ...rows) : null;
  }

  // Where the level is; without a sweep, which takes it along, with a slider.
  #levelSlider() {
    const { viewer } = this;
    this.levelNote = element('p', { class: 'note' });
    if (viewer.sweep) return this.levelNote;
    this.share = element('input', { type: 'range', id: 'share', min: 0, max: 1, step: 0.002,
      'aria-label': 'Level of the Morse function',
      oninput: () => viewer.set({ share: Number(this.share.value) }) });
    return element('div', {}, this.share, this.levelNote);
  }

  #plane() {
    const { viewer } = this;
    this.axis = choice('Normal of the plane', [['x', 'x'], ['y', 'y'], ['z', 'z'],
      ['view', 'view']], viewer.state.axis, (axis) => viewer.setAxis(axis));
    this.offset = element('input', { type: 'range', id: 'offset', min: -1, max: 1, step: 0.002,
      'aria-label': 'Place of the plane', title: 'Place of the plane ([ and ])',
      oninput: () => viewer.set({ offset: Number(this.offset.value) }) });
    this.rows.cut = toggle({ id: 'cut', label: 'Cut the surface too', key: 'U',
      change: (cut) => viewer.set({ cut }) });
    this.cellCounts = element('div', { class: 'legend' });
    this.plane = section('Plane', this.axis, this.offset, this.rows.cut, this.cellCounts);
    return this.plane;
  }

  #sweep() {
    const { viewer } = this;
    this.play = element('button', { type: 'button', class: 'play',
      onclick: () => viewer.togglePlay() });
    this.step = element('input', { type: 'range', id: 'step', min: 0, max: viewer.sweep.steps,
      step: 1, 'aria-label': 'Progress of the sweep', title: 'Progress of the sweep (, and .)',
      oninput: () => viewer.goTo(Number(this.step.value)) });
    this.done = element('table', { class: 'done' },
      ...viewer.scene.operationNames.map((name, i) => element('tr', {},
        element('td', {}, element('i', { class: 'dot',
          style: `background:${css(palette.operations[i])}` }), name),
        element('td', { class: 'number' }), element('td', { class: 'number all' }))));
    this.frontNote = element('p', { class: 'note' });
    return section('Sweep', element('div', { class: 'player' }, this.play, this.step),
      this.done, this.frontNote);
  }

  #growth() {
    const { viewer } = this;
    this.frame = element('input', { type: 'range', id: 'frame', min: 0,
      max: viewer.growth.frames.length, step: 1, 'aria-label': 'Frame of the growth',
      oninput: () => viewer.goToFrame(Number(this.frame.value)) });
    this.playGrowth = element('button', { type: 'button', class: 'play',
      onclick: () => viewer.toggleGrowth() });
    this.frameNote = element('p', { class: 'note' });
    return section('Growth', element('div', { class: 'player' }, this.playGrowth, this.frame),
      this.frameNote);
  }

  #showLegend() {
    const { swatches = [], scale, bars, barsInWords, unit, more } =
      this.viewer.colouring.legend();
    const parts = swatches.map(({ name, colour, count }) => element('div', { class: 'swatch' },
      element('i', { class: 'dot', style: `background:${css(colour)}` }),
      element('span', {}, name), element('span', { class: 'count' }, number(count))));
    if (scale) {
      const stops = Array.from({ length: 9 }, (_, i) => css(palette.gradient(i / 8)));
      if (bars) parts.push(histogram(bars, barsInWords));
      parts.push(element('div', { class: 'ramp', style:
        `background:linear-gradient(90deg,${stops.join(',')})` }),
      element('div', { class: 'ticks' }, ...scale.map((tick) => element('span', {}, tick))),
      element('p', { class: 'note' }, unit));
    }
    if (more) parts.push(element('p', { class: 'note' }, more));
    this.legend.replaceChildren(...parts);
  }

  // Shows the state as it is now. what: the names of what changed, or nothing for all.
  update(what) {
    const { viewer } = this, { state } = viewer;
    const changed = (...names) => !what || names.some((name) => what.has(name));
    for (const [id, row] of Object.entries(this.rows)) row.box.checked = state[id];
    if (changed('style')) this.style.show(state.style);
    if (changed('colouring', 'simplified')) {
      this.colour.value = state.colouring;
      this.#showLegend();
    }
    if (changed('simplified') && this.pointKey) this.#showPoints();
    if (this.plane && changed('axis', 'offset', 'section', 'cut')) this.#showPlane();
    if (this.step && changed('step', 'playing')) this.#showSweep();
    if (this.frame && changed('frame', 'growing')) this.#showGrowth();
    if (this.levelNote && changed('level', 'share', 'step')) this.#showLevel();
    if (this.components && changed('hidden')) this.components.update();
    if (changed('panel')) {
      this.root.classList.toggle('folded', !state.panel);
      this.fold.setAttribute('aria-expanded', String(state.panel));
      this.#showAnswer();
    }
  }

  #showPoints() {
    const { viewer } = this, { state } = viewer;
    const counts = viewer.scene.page.about.critical[state.simplified ? 'left' : 'found'];
    this.rows.points.count.textContent = number(counts.reduce((a, b) => a + b));
    this.rows.spheres.count.textContent = number(viewer.shownSpheres().length);
    if (this.rows.lines) {
      const lines = viewer.scene.page.about[state.simplified ? 'kept_lines' : 'lines'];
      this.rows.lines.count.textContent = number(lines.count);
    }
    const sum = signed(String(counts[0] - counts[1] + counts[2]));
    this.pointKey.textContent = `${number(counts[0])} min − ${counted(counts[1], 'saddle')} + ` +
      `${number(counts[2])} max = ${sum}`;
  }

  #showPlane() {
    const { viewer } = this, { state } = viewer;
    const isUsed = state.section || state.cut;
    this.plane.classList.toggle('idle', !isUsed);
    this.axis.show(state.axis);
    this.offset.value = state.offset;
    const counts = viewer.section.counts;
    this.cellCounts.replaceChildren(...(state.section ? ['vertex', 'edge', 'triangle',
      'tetrahedron'].map((name, i) => element('div', { class: 'swatch' },
      element('i', { class: 'dot', style: `background:${css(palette.kinds[i])}` }),
      element('span', {}, `cells of ${name === 'vertex' ? 'vertices' : name === 'tetrahedron'
        ? 'tetrahedra' : name + 's'}`),
      element('span', { class: 'count' }, number(counts[i])))) : []));
  }

  #showLevel() {
    const { viewer } = this;
    this.levelNote.hidden = !viewer.state.level;
    if (viewer.state.level) {
      this.levelNote.textContent = `level ${levelInWords(viewer.level(), viewer.scene)}`;
    }
    if (!this.share) return;
    this.share.hidden = !viewer.state.level;
    this.share.value = viewer.state.share;
  }

  #showSweep() {
    const { viewer } = this, { sweep, state } = viewer;
    this.step.value = state.step;
    showPlaying(this.play, state.playing, ['Run the sweep', 'Stop the sweep'], 'Space');
    sweep.counts().forEach(({ now, all }, i) => {
      const [, shown, total] = this.done.rows[i].cells;
      shown.textContent = number(now);
      total.textContent = `of ${number(all)}`;
    });
    const { about } = viewer.scene.page, level = sweep.level();
    const isWhole = state.step === sweep.steps;
    this.frontNote.textContent = `${counted(sweep.triangles(), 'triangle')}, ` + (isWhole
      ? `${about.closed ? '' : 'not '}closed`
      : `${counted(sweep.frontEdges ?? 0, 'edge')} in the front` +
        (level === level ? ` at ${levelInWords(level, viewer.scene)}` : ''));
  }

  #showGrowth() {
    const { viewer } = this, { growth, state } = viewer;
    this.frame.value = state.frame;
    showPlaying(this.playGrowth, state.growing, ['Let it grow', 'Stop growing'], 'G');
    const frame = growth.frames[state.frame];
    this.frameNote.textContent = frame ? `${frame.label}: ${counted(frame.triangles, 'triangle')}`
      : 'grown: the mesh itself';
  }
}

// The part of the panel that shows or hides each component of the surface by itself.

import { counted, element, number, section, toggle } from './dom.js';

// Volumes as the report of `mesh` tells them.
function volume(x) {
  const told = Number(x.toPrecision(4));
  return `${told < 1e-6 ? told : told.toLocaleString('en', { maximumFractionDigits: 9 })} Å³`;
}

export class ComponentList {
  constructor(viewer) {
    this.viewer = viewer;
    const { list } = viewer.scene.components();
    this.rows = list.map((component, i) => toggle({ id: `component-${i}`, label: component.name,
      count: component.volume === null ? number(component.triangles) : volume(component.volume),
      title: `${component.name}: ${counted(component.triangles, 'triangle')}` +
        (component.volume === null ? '' : `, encloses ${volume(component.volume)}`),
      change: (isOn) => this.#show([i], isOn) }));
    const voids = list.flatMap(({ name }, i) => (name.startsWith('void') ? [i] : []));
    if (voids.length > 1) {
      this.voids = voids;
      this.all = toggle({ id: 'voids', label: 'All voids', count: number(voids.length),
        title: 'Show or hide all voids', change: (isOn) => this.#show(voids, isOn) });
    }
    this.root = section('Components', ...(this.all ? [this.all] : []),
      element('div', { class: 'rows' }, ...this.rows));
  }

  #show(components, isOn) {
    const hidden = this.viewer.hiddenComponents();
    for (const i of components) {
      if (isOn) hidden.delete(i);
      else hidden.add(i);
    }
    this.viewer.set({ hidden: [...hidden].sort((a, b) => a - b).join() });
  }

  update() {
    const hidden = this.viewer.hiddenComponents();
    this.rows.forEach((row, i) => { row.box.checked = !hidden.has(i); });
    if (!this.all) return;
    const count = this.voids.filter((i) => hidden.has(i)).length;
    this.all.box.checked = count === 0;
    this.all.box.indeterminate = count > 0 && count < this.voids.length;
  }
}

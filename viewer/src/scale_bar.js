// A bar of a round length, true at the point that the eye turns about.

import { element } from './dom.js';

const widest = 110; // pixels

export class ScaleBar {
  constructor(stage) {
    this.words = element('span');
    this.bar = element('div', { id: 'scale', 'aria-hidden': 'true' }, element('i'), this.words);
    stage.container.append(this.bar);
    stage.onDraw.push(() => this.show(stage));
    this.show(stage);
  }

  show({ camera, controls, container }) {
    const distance = camera.position.distanceTo(controls.target);
    const height = 2 * distance * Math.tan((camera.fov * Math.PI) / 360); // of the window, Angstrom
    const most = (widest * height) / container.clientHeight;
    if (!(most > 0)) return;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = power * [5, 2, 1].find((n) => n * power <= most);
    this.bar.firstChild.style.width = `${(length / height) * container.clientHeight}px`;
    this.words.textContent = `${Number(length.toPrecision(1))} Å`;
  }
}

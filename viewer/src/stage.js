// The window on the scene: renderer, camera and controls. It draws only when something changed.

import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

THREE.ColorManagement.enabled = false;

// Two frames further apart than this while something moves: draw fewer pixels until it rests.
const slowFrame = 90; // milliseconds

const up = new THREE.Vector3(0, 1, 0);

function renderer() {
  try {
    return new THREE.WebGLRenderer({ antialias: true, powerPreference: 'high-performance' });
  } catch (cause) {
    throw new Error('this browser gives it no WebGL 2; turn on hardware acceleration in its ' +
      'settings, or take another browser', { cause });
  }
}

export class Stage {
  constructor(container, bounds) {
    this.container = container;
    this.bounds = bounds;
    this.onDraw = []; // called after each drawing
    this.renderer = renderer();
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // colours are given as they show
    container.append(this.renderer.domElement);
    this.renderer.domElement.tabIndex = 0;
    this.renderer.domElement.setAttribute('aria-label', 'The surface; arrow keys turn it');
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.1, 100);
    // They set touch-action to none, so that fingers neither scroll nor zoom the page.
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.zoomToCursor = true;
    this.controls.rotateSpeed = 0.8;
    this.controls.addEventListener('change', () => this.draw(true));
    this.finest = Math.min(window.devicePixelRatio || 1, 2);
    this.coarse = 1;
    this.lastFrame = 0;
    this.renderer.setPixelRatio(this.finest);
    // A graphics card that was lost comes back without the background, and nothing is drawn.
    this.renderer.domElement.addEventListener('webglcontextrestored',
      () => this.setBackground(this.background));
    new ResizeObserver(() => this.resize()).observe(container);
    this.fit();
  }

  setBackground(colour) {
    this.background = colour;
    this.renderer.setClearColor(new THREE.Color(colour), 1);
    this.draw();
  }

  resize() {
    if (this.#measure()) this.drawNow();
  }

  // Takes over the window's size; false when it has none.
  #measure() {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (width === 0 || height === 0) return false;
    this.camera.aspect = width / height;
    this.#keepInView();
    this.camera.updateProjectionMatrix();
    this.renderer.setSize(width, height, false);
    return true;
  }

  // A narrow window sees as much to the sides as a square one.
  #keepInView() {
    const half = Math.tan(14 * Math.PI / 180);
    const narrow = Math.min(1, this.camera.aspect);
    this.camera.fov = 2 * Math.atan(half / narrow) * 180 / Math.PI;
  }

  // Looks at all of it, the Morse function's default direction up, from the side where it is
  // widest, a little from the right and from above.
  fit() {
    this.#measure();
    const { middle, radius, widest, sample } = this.bounds;
    const away = new THREE.Vector3(0, 0, 1).applyAxisAngle(up, widest + 0.22);
    away.addScaledVector(up, 0.17).normalize();
    const right = up.clone().cross(away).normalize(), above = away.clone().cross(right);
    const tall = Math.tan(this.camera.fov * Math.PI / 360), wide = tall * this.camera.aspect;
    // Twice: first what is seen from far away, then from where that would have the eye.
    const target = new THREE.Vector3(...middle), off = new THREE.Vector3();
    let distance = 0;
    for (let round = 0; round < 2; ++round) {
      let [left, most, low, high, nearest] = [Infinity, -Infinity, Infinity, -Infinity, 0];
      for (let i = 0; i < sample.length; i += 3) {
        off.set(sample[i], sample[i + 1], sample[i + 2]).sub(target);
        const x = off.dot(right), y = off.dot(above), z = off.dot(away);
        left = Math.min(left, x);
        most = Math.max(most, x);
        low = Math.min(low, y);
        high = Math.max(high, y);
        nearest = Math.max(nearest, z + Math.max(Math.abs(x) / wide, Math.abs(y) / tall));
      }
      distance = 1.06 * nearest;
      if (round === 0) {
        target.addScaledVector(right, (left + most) / 2).addScaledVector(above, (low + high) / 2);
      }
    }
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(away, distance);
    this.camera.near = distance / 200;
    this.camera.far = 20 * (distance + radius);
    this.controls.minDistance = distance / 150;
    this.controls.maxDistance = distance * 6;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  // Turns what is seen to the right and up by angles, radians, as a drag does; the camera stays upright.
  turn(right, up) {
    const off = this.camera.position.clone().sub(this.controls.target);
    const place = new THREE.Spherical().setFromVector3(off);
    place.theta -= right;
    place.phi = Math.min(Math.max(place.phi + up, 0.01), Math.PI - 0.01);
    this.camera.position.copy(this.controls.target).add(off.setFromSpherical(place));
    this.controls.update();
    this.draw(true);
  }

  zoom(factor) {
    const off = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    off.clampLength(this.controls.minDistance, this.controls.maxDistance);
    this.camera.position.copy(this.controls.target).add(off);
    this.controls.update();
    this.draw(true);
  }

  // moving: more frames will follow, and may be drawn coarser if they are slow to come.
  draw(moving = false) {
    if (moving) this.#watchPace();
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => this.drawNow());
  }

  #watchPace() {
    const now = performance.now(), gap = now - this.lastFrame;
    if (gap > slowFrame && gap < 1500 && this.coarse > 0.4) this.#setCoarse(this.coarse * 0.75);
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      if (this.coarse < 1) {
        this.#setCoarse(1);
        this.draw();
      }
    }, 400);
  }

  #setCoarse(share) {
    this.coarse = share;
    this.renderer.setPixelRatio(this.finest * share);
  }

  drawNow() {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    this.renderer.render(this.world, this.camera);
    for (const act of this.onDraw) act();
    this.lastFrame = performance.now();
    this.frames = (this.frames ?? 0) + 1;
  }
}

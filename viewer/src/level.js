// The Morse function of the sweep, drawn: the direction of a height with the plane of one of its
// values, or the centre of a squared distance with the sphere of one.

import * as THREE from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

export const levelColour = [255, 112, 32]; // the front's, which lies there

const colour = new THREE.Color().setRGB(...levelColour.map((x) => x / 255));
const beyond = 1; // the radius of what is shown: half a side of the plane

const solid = () => new THREE.MeshBasicMaterial({ color: colour });
const veil = () => new THREE.MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.16,
  depthWrite: false, side: THREE.DoubleSide });

// points: corners of a polyline.
function line(points) {
  const pairs = points.slice(1).flatMap((p, i) => [...points[i].toArray(), ...p.toArray()]);
  return new LineSegments2(new LineSegmentsGeometry().setPositions(pairs),
    new LineMaterial({ color: colour, linewidth: 1.6 }));
}

class HeightLevel {
  constructor({ direction }, scene, { low, high }) {
    const { middle, radius } = scene.bounds;
    this.group = new THREE.Group();
    this.along = new THREE.Vector3(...direction);
    this.middle = new THREE.Vector3(...middle);
    this.value = scene.functionValue(...middle);
    const at = (value) => this.#at(value);
    const size = beyond * radius, foot = at(low - 0.08 * (high - low));
    const head = at(high + 0.05 * (high - low)), length = 0.1 * radius;
    const tip = new THREE.Mesh(new THREE.ConeGeometry(0.3 * length, length, 24), solid());
    tip.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), this.along);
    tip.position.copy(head).addScaledVector(this.along, length / 2);
    this.group.add(line([foot, head]), tip);
    this.plane = new THREE.Group();
    const rim = [[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]];
    this.plane.add(new THREE.Mesh(new THREE.PlaneGeometry(2 * size, 2 * size), veil()),
      line(rim.map(([x, y]) => new THREE.Vector3(size * x, size * y, 0))));
    this.plane.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), this.along);
    this.group.add(this.plane);
  }

  #at(value) {
    return this.middle.clone().addScaledVector(this.along, value - this.value);
  }

  show(value) {
    this.plane.position.copy(this.#at(value));
  }
}

class DistanceLevel {
  constructor({ origin }, scene) {
    const centre = new THREE.Vector3(...origin.map((x, k) => x - scene.centre[k]));
    this.group = new THREE.Group();
    this.group.position.copy(centre);
    this.group.add(new THREE.Mesh(new THREE.SphereGeometry(0.025 * scene.bounds.radius, 24, 16),
      solid()));
    this.sphere = new THREE.Group();
    this.sphere.add(new THREE.Mesh(new THREE.SphereGeometry(1, 64, 48), veil()));
    const turns = Array.from({ length: 97 }, (_, i) => (i * Math.PI) / 48);
    for (const [i, j] of [[0, 1], [1, 2], [2, 0]]) {
      this.sphere.add(line(turns.map((t) => new THREE.Vector3()
        .setComponent(i, Math.cos(t)).setComponent(j, Math.sin(t)))));
    }
    this.group.add(this.sphere);
  }

  show(value) {
    this.sphere.scale.setScalar(Math.sqrt(Math.max(value, 1e-12)));
  }
}

export function functionLevel(scene) {
  const told = scene.page.about.function, range = scene.functionRange();
  const level = told.kind === 'height' ? new HeightLevel(told, scene, range)
    : new DistanceLevel(told, scene);
  level.group.traverse((part) => {
    part.renderOrder = 5;
    part.frustumCulled = false;
  });
  return level;
}

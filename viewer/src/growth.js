// A skin that grows, as frames: meshes that are shown one after the other.

import { Mesh } from './mesh.js';
import { Surface } from './surface.js';

// A frame's triangles are not those of the mesh: what colours these does not fit them.
const grey = [200, 200, 200];

export class Growth {
  // plane: the uniform of the plane that cuts, which all frames share with the mesh.
  constructor(scene, plane) {
    this.scene = scene;
    this.plane = plane;
    this.frames = scene.page.about.growth.frames; // { name, label, triangles }
    this.made = new Map();
  }

  // Surfaces are made when they are first shown.
  #surface(i) {
    if (!this.made.has(i)) {
      const mesh = new Mesh(this.scene.page, this.frames[i].name, this.scene.centre);
      const surface = new Surface(mesh, mesh.vertexNormals(), null);
      surface.uniforms.plane = this.plane;
      surface.paint({ colours: () => (t, three) => { three.fill(grey); } });
      this.made.set(i, surface);
    }
    return this.made.get(i);
  }

  show(frame, world, state) {
    if (frame < this.frames.length) {
      const surface = this.#surface(frame);
      surface.set(state);
      if (!surface.group.parent) world.add(surface.group);
    }
    for (const [i, surface] of this.made) {
      surface.group.visible = i === frame && state.style !== 'off';
    }
  }
}

// The hare of the first page: a slider moves its level of detail, and the strips are maintained as they are in the
// viewer. Without WebGL 2 the picture stays.
import { load } from '../../bindings/js/restrip.mjs';
import { embedded } from '../viewer/embedded.mjs';
import { Camera } from '../viewer/camera.mjs';
import { Pane } from '../viewer/pane.mjs';
import { Pace } from '../viewer/pace.mjs';
import { Painter } from '../viewer/ribbon.mjs';
import { asNumber } from '../viewer/figures.mjs';

const by = (id) => document.getElementById(id);
const turnedBy = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };

class Hare {
  camera = new Camera();
  pace = new Pace();
  #asked = false;

  constructor(mesh) {
    this.mesh = mesh;
    this.level = Math.round(mesh.levels * 0.1);
    by('live').hidden = false;  // so that the canvas has a size
    const lost = (yes) => { by('live').hidden = !(by('still').hidden = !yes); };
    this.pane = new Pane(by('canvas'), this.camera, { changed: () => this.ask(), lost: () => lost(true), restored: () => {
      lost(false);
      this.#upload();
    } });
    by('still').hidden = true;
    this.painter = new Painter(this.pane.scene);
    this.camera.fit(mesh.points);
    this.#upload();
    by('level').max = mesh.levels;
    by('level').value = this.level;
    by('level').addEventListener('input', () => {
      this.level = +by('level').value;
      this.ask();
    });
    by('canvas').addEventListener('pointermove', ({ buttons, movementX, movementY }) => buttons && this.#turn(-0.01 * movementX, 0.01 * movementY));
    by('canvas').addEventListener('keydown', (event) => {
      if (!turnedBy[event.key]) return;
      event.preventDefault();
      this.#turn(...turnedBy[event.key]);
    });
  }
  #turn(yaw, pitch) {
    this.camera.yaw += yaw;
    this.camera.pitch = Math.max(-1.5, Math.min(1.5, this.camera.pitch + pitch));
    this.ask();
  }
  #upload() {
    this.painter.scene = this.pane.scene;
    this.painter.repaint();
    this.ask();
  }
  ask() {
    if (!this.#asked) requestAnimationFrame(() => this.#frame());
    this.#asked = true;
  }
  get settled() { return !this.#asked; }
  #frame() {
    this.#asked = false;
    const { mesh, pace, painter, pane: { scene, colors }, camera } = this;
    if (scene.lost) return;
    pace.begin();
    const { most } = pace;
    const before = performance.now();
    const done = mesh.moveTo(this.level, most);
    pace.learn(done, most, performance.now() - before);
    if (done > 0) painter.stale();
    if (done === most) this.ask();
    painter.paint(() => mesh.ribbon, mesh.points, true, true);
    scene.draw(camera, { style: 'strips', ...colors });
    const { triangles, strips } = mesh.figures;
    by('level-text').textContent = `${asNumber(triangles)} triangles in ${asNumber(strips)} strips with ${asNumber(mesh.plainIndices / triangles, 2)} indices per triangle; a list has 3.`;
  }
}

try {
  const restrip = await load(await embedded('wasm'));
  const hare = new Hare(restrip.baked(new Uint8Array(await embedded('mesh'))).begin());
  window.restripHare = hare;  // for tests
} catch {
  by('live').hidden = true;  // the picture stays
}

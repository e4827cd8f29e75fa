// The first page. Its hare is peeled into one ribbon and rolled up again, once; then a slider moves its level of detail, and
// the strips are maintained as they are in the viewer. Three thumbnails show what changes a mesh: a level of detail, a
// viewer who walks over terrain, a brush. Without WebGL 2 the picture stays.
import { load, none } from '../../bindings/js/restrip.mjs';
import { embedded } from '../viewer/embedded.mjs';
import { Camera, unit } from '../viewer/camera.mjs';
import { Pane } from '../viewer/pane.mjs';
import { Pace } from '../viewer/pace.mjs';
import { Painter } from '../viewer/ribbon.mjs';
import { asNumber } from '../viewer/figures.mjs';

const by = (id) => document.getElementById(id);
const turnedBy = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
const still = matchMedia('(prefers-reduced-motion: reduce)');
/// Milliseconds of the hare: it stands, is peeled, lies, is rolled up.
const standsFor = 900;
const peelsFor = 3200;
const liesFor = 900;

/// A canvas that a mesh fills, in strips. `step(now)`: before each frame; whether there is more to come.
class Stage {
  camera = new Camera();
  peel = 0;
  #asked = false;

  constructor(canvas, mesh, { yaw = 0.55, pitch = 0.28, step = () => false, lost = () => {} } = {}) {
    Object.assign(this.camera, { yaw, pitch });
    Object.assign(this, { canvas, step });
    this.pane = new Pane(canvas, this.camera, { changed: () => this.fill(), lost: () => lost(true), restored: () => {
      lost(false);
      this.painter.scene = this.pane.scene;
      this.painter.repaint();
      this.ask();
    } });
    this.show(mesh);
  }
  show(mesh) {
    this.mesh = mesh;
    this.painter = new Painter(this.pane.scene);
    this.fill();
  }
  fill() {
    this.camera.fill(this.mesh.points, this.pane.aspect);
    this.ask();
  }
  get settled() { return !this.#asked; }
  ask() {
    if (!this.#asked) requestAnimationFrame((now) => this.#frame(now));
    this.#asked = true;
  }
  #frame(now) {
    this.#asked = false;
    const { mesh, painter, pane: { scene, colors, aspect }, camera, peel } = this;
    if (scene.lost) return;
    if (this.step(now)) this.ask();
    painter.paint(() => this.mesh.ribbon, this.mesh.points, true, true);
    if (this.peel > 0) painter.flatten(aspect);
    scene.draw(camera, { style: 'strips', ...colors, peel: this.peel });
    if (mesh !== this.mesh || peel !== this.peel) this.ask();
  }
}

const figuresOf = (mesh) => {
  const { triangles, strips } = mesh.figures;
  return { triangles, strips, each: asNumber(mesh.plainIndices / triangles, 2) };
};
const write = (element, text) => { if (element.textContent !== text) element.textContent = text; };

class Hare {
  pace = new Pace();
  #begun = null;  // the play
  #played = still.matches;

  constructor(mesh) {
    this.mesh = mesh;
    this.level = Math.round(mesh.levels * 0.1);
    mesh.begin({ policy: this.#played ? 'quick' : 'baked' });
    by('live').hidden = false;  // so that the canvas has a size
    by('still').hidden = true;
    this.stage = new Stage(by('canvas'), mesh, { step: (now) => this.#step(now), lost: (yes) => { by('live').hidden = !(by('still').hidden = !yes); } });
    by('level').max = mesh.levels;
    by('level').value = this.level;
    by('level').addEventListener('input', () => {
      this.#end();
      this.level = +by('level').value;
      this.stage.ask();
    });
    by('level').addEventListener('change', () => { by('level-said').textContent = by('level-text').textContent; });
    by('canvas').addEventListener('pointermove', ({ buttons, movementX, movementY, pointerType }) => {
      // A finger that moves up or down scrolls the page.
      if (buttons) this.#turn(-0.01 * movementX, pointerType === 'touch' ? 0 : 0.01 * movementY);
    });
    by('canvas').addEventListener('keydown', (event) => {
      if (!turnedBy[event.key]) return;
      event.preventDefault();
      this.#turn(...turnedBy[event.key]);
    });
  }
  get settled() { return this.#played && this.stage.settled; }
  #turn(yaw, pitch) {
    this.stage.camera.turn(-yaw, pitch);
    this.stage.ask();
  }
  /// From now on the rules maintain the strips.
  #end() {
    if (this.#played) return;
    this.#played = true;
    this.stage.peel = 0;
    this.mesh.begin();
    this.stage.painter.ribbon = null;
    this.stage.painter.stale();
  }
  #step(now) {
    const { mesh, pace, stage } = this;
    pace.begin();
    const { most } = pace;
    const before = performance.now();
    const done = mesh.moveTo(this.level, most);
    pace.learn(done, most, performance.now() - before);
    if (done > 0) stage.painter.stale();
    if (done < most) this.#say();
    return done === most || (!this.#played && this.#play(now));
  }
  #play(now) {
    this.#begun ??= now;
    const at = now - this.#begun - standsFor;
    const back = at - peelsFor - liesFor;
    this.stage.peel = Math.max(0, Math.min(1, back > 0 ? 1 - back / peelsFor : at / peelsFor));
    if (back > peelsFor) this.#end();
    return true;
  }
  #say() {
    const { triangles, strips, each } = figuresOf(this.mesh);
    write(by('now'), each);
    write(by('level-text'), strips === 1 ? `${asNumber(triangles)} triangles in one strip` : `${asNumber(triangles)} triangles in ${asNumber(strips)} strips`);
  }
}

/// A thumbnail. `make()` gives its mesh; `change(mesh, time)` changes it, and says whether it is to begin again.
class Card {
  #seen = false;
  #time = 0;  // in steps

  constructor(name, view, make, change) {
    Object.assign(this, { name, make, change });
    this.stage = new Stage(by(`card-${name}`), make(), { ...view, step: () => this.#step() });
    new IntersectionObserver((entries) => {
      this.#seen = entries.at(-1).isIntersecting;
      this.stage.ask();
    }).observe(by(`card-${name}`));
  }
  #step() {
    if (!this.#seen) return false;
    // Without animation, one moment of it.
    for (const end = still.matches ? 40 : this.#time + 1; this.#time < end;) {
      if (!this.change(this.stage.mesh, this.#time++)) continue;
      this.#time = 0;
      this.stage.mesh.close();
      this.stage.show(this.make());
      break;
    }
    this.stage.painter.stale();
    const { triangles, each } = figuresOf(this.stage.mesh);
    write(by(`card-${this.name}-text`), `${asNumber(triangles)} triangles, ${each} indices each`);
    return !still.matches;
  }
}

/// A grid of heights, as levels: from squares of `step` on, all diagonals are bisected, then all sides. To bisect an edge is
/// a vertex split: its first end gives the new vertex the other end.
function terrain(side, step) {
  const height = (x, z) => 0.16 * Math.sin(3.1 * x + 1) * Math.cos(2.3 * z) + 0.07 * Math.sin(7 * x - 3 * z) + 0.03 * Math.cos(11 * x + 13 * z);
  const at = (x, z) => (x < 0 || x > side || z < 0 || z > side ? none : x * (side + 1) + z);
  const [points, base, splits] = [[], [], []];
  for (let i = 0; i <= side; ++i)
    for (let j = 0; j <= side; ++j) {
      const [x, z] = [2 * i / side - 1, 2 * j / side - 1];
      points.push(x, height(x, z), z);
    }
  /// Every other square first, so that few splits need many others.
  const each = (step, act) => {
    for (const [first, next] of [[0, 0], [step, step], [0, step], [step, 0]])
      for (let x = first; x <= side; x += 2 * step) for (let z = next; z <= side; z += 2 * step) act(x, z);
  };
  /// The record of the edge from (x, z) along (dx, dz): the vertices to its left and right are as far from its middle as its ends.
  const bisected = (x, z, dx, dz) => [at(x, z), at(x + dx / 2, z + dz / 2), at(x + (dx + dz) / 2, z + (dz - dx) / 2), at(x + (dx - dz) / 2, z + (dz + dx) / 2)];
  const bisect = (...edge) => splits.push(...bisected(...edge));
  /// The diagonal of each square: neighbours have different ones.
  const diagonals = (step, act) => each(step, (x, z) => {
    const turned = (x + z) / step % 2;
    if (x < side && z < side) act(x + turned * step, z, turned ? -step : step, step);
  });
  diagonals(step, (x, z, dx, dz) => {
    const [u, , l, r] = bisected(x, z, dx, dz);
    const v = at(x + dx, z + dz);
    base.push(u, v, l, v, u, r);
  });
  for (; step > 1; step /= 2) {
    diagonals(step, bisect);
    each(step, (x, z) => {
      if (x < side) bisect(x, z, step, 0);
      if (z < side) bisect(x, z, 0, step);
    });
  }
  return { points, base, splits };
}
/// An octahedron whose triangles were cut in four `times`, on the unit sphere.
function sphere(times) {
  let points = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]];
  let triangles = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
  for (; times > 0; --times) {
    const middles = new Map();
    const middle = (u, v) => {
      const key = u < v ? `${u} ${v}` : `${v} ${u}`;
      if (!middles.has(key)) middles.set(key, points.push(unit(points[u].map((c, n) => c + points[v][n]))) - 1);
      return middles.get(key);
    };
    triangles = triangles.flatMap(([a, b, c]) => {
      const [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
      return [[a, d, f], [d, b, e], [f, e, c], [d, e, f]];
    });
  }
  return { points: points.flat(), triangles: triangles.flat() };
}

/// Moves the level up and down.
function detail(mesh, time) {
  mesh.moveTo(Math.round(mesh.levels * (0.02 + 0.1 * (1 - Math.cos(time / 60)))));
}
/// Refines the terrain around a viewer who walks in a circle.
function walk(mesh, time) {
  mesh.places ??= mesh.splits;
  const [x, z] = [0.55 * Math.cos(time / 90), 0.55 * Math.sin(time / 90)];
  const { points, places } = mesh;
  const wanted = new Uint8Array(mesh.levels);
  for (let i = 0; i < wanted.length; ++i) {
    const v = 3 * places[4 * i + 1];
    if (Math.hypot(points[v] - x, points[v + 2] - z) < 0.42) wanted[i] = 1;
  }
  mesh.approach(wanted);
}
/// Raises what lies under a brush, and bisects edges that have become long.
function sculpt(mesh, time) {
  const brush = unit([Math.cos(time / 40), 0.5 + 0.5 * Math.sin(time / 97), 1.2 + Math.sin(time / 40)]);
  const near = (v) => {
    const p = unit([...mesh.points.subarray(3 * v, 3 * v + 3)]);
    return Math.max(0, 1 - Math.hypot(...p.map((c, n) => c - brush[n])) / 0.4);
  };
  const { points, triangles } = mesh;
  const edges = [];
  for (let i = 0; i < triangles.length; ++i) {
    const [u, v] = [triangles[i], triangles[i % 3 === 2 ? i - 2 : i + 1]];
    const long = Math.hypot(...[0, 1, 2].map((n) => points[3 * u + n] - points[3 * v + n]));
    if (u < v && long > 0.11 && near(u) > 0) edges.push([long, u, v]);
  }
  edges.sort(([a], [b]) => b - a);
  for (const [, u, v] of edges.slice(0, 8)) mesh.bisect(u, v);
  const moved = mesh.points;
  for (let v = 0; v < moved.length / 3; ++v) {
    const by = 1 + 0.02 * near(v);
    if (by > 1) mesh.setPoint(v, by * moved[3 * v], by * moved[3 * v + 1], by * moved[3 * v + 2]);
  }
  return time > 420;
}

try {
  const restrip = await load(await embedded('wasm'));
  const bytes = new Uint8Array(await embedded('mesh'));
  const hare = new Hare(restrip.baked(bytes));
  const cards = [new Card('detail', {}, () => restrip.baked(bytes).begin(), detail),
    new Card('terrain', { yaw: 0.6, pitch: 0.75 }, () => restrip.progressive(terrain(48, 8)).begin(), walk),
    new Card('sculpt', { yaw: 0.4 }, () => restrip.mesh(sphere(3)).begin(), sculpt)];
  Object.assign(window, { restripHare: hare, restripCards: cards });  // for tests
} catch (error) {
  by('live').hidden = true;  // the picture stays
  by('still').hidden = false;
  by('cards').hidden = true;
  window.restripFault = error;
}

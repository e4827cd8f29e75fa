// The page: a progressive mesh whose strips are maintained in WebAssembly, drawn from the live index buffer or as
// ribbons, and the parts that play with it.
import { load } from '../../bindings/js/restrip.mjs';
import { prepared } from './prepare.mjs';
import { embedded } from './embedded.mjs';
import { Camera } from './camera.mjs';
import { Pane } from './pane.mjs';
import { Pace } from './pace.mjs';
import { Painter } from './ribbon.mjs';
import { Cut } from './cut.mjs';
import { Turn } from './turn.mjs';
import { Race } from './race.mjs';
import { Files } from './files.mjs';
import { Link, readLink, showPart } from './link.mjs';
import { listen } from './controls.mjs';
import { indexWidth, showFigures, showLevel, showMesh, showReads } from './figures.mjs';

// The distribution of detail: the level everywhere, and in the view-dependent modes all records near the view.

/// A byte for each record, 1 if it is wanted; null: only the records of the level. `look`: a ray through the cursor.
export function wantedRecords({ mode, mesh, level, clicks, splits, normals, camera, look }) {
  const { points, levels } = mesh;
  const wanted = new Uint8Array(levels).fill(1, 0, level);
  for (const record of clicks) wanted[record] = 1;
  if (mode === 'level') return clicks.length > 0 ? wanted : null;
  if (mode === 'cursor') {
    const hit = mesh.pick(look.from, look.along);
    if (!hit) return wanted;
    const near = (0.22 * camera.size) ** 2;
    for (let i = level; i < levels; ++i) {
      const v = 3 * splits[4 * i + 1];
      if ((points[v] - hit[0]) ** 2 + (points[v + 1] - hit[1]) ** 2 + (points[v + 2] - hit[2]) ** 2 < near) wanted[i] = 1;
    }
    return wanted;
  }
  const eye = camera.eye;
  for (let i = level; i < levels; ++i) {
    const v = 3 * splits[4 * i + 1];
    const [x, y, z] = [eye[0] - points[v], eye[1] - points[v + 1], eye[2] - points[v + 2]];
    const facing = (x * normals[v] + y * normals[v + 1] + z * normals[v + 2]) / Math.hypot(x, y, z);
    if (Math.abs(facing) < 0.12) wanted[i] = 1;
  }
  return wanted;
}

// The page in a browser without WebGL 2: the parts that draw no mesh work, the others show a picture and say why.

const drawn = ['ribbon', 'cut', 'race'];

export class Plain {
  mesh = null;

  /// `reason`: a sentence.
  constructor(restrip, by, reason) {
    Object.assign(this, { restrip, by });
    by('fault-text').textContent = `${reason} Your turn and Use it work without it.`;
    by('fault-gone').hidden = true;
    this.turn = new Turn(this, by);
    addEventListener('hashchange', () => this.follow());
    this.follow();
  }
  follow() {
    const state = readLink(location.hash);
    this.part = showPart(this.by, state.part);
    this.by('fault').hidden = !drawn.includes(this.part);
    this.by('still').hidden = !drawn.includes(this.part);
    this.turn.goTo(state);
  }
  /// A frame, which nothing here needs.
  ask() {}
}

const by = (id) => document.getElementById(id);
/// The rest in another task.
const later = () => new Promise((then) => setTimeout(then));
/// Operations between two updates of the live buffer. They are counted, not timed: the buffer does not depend on the processor.
const updateEvery = 64;
const still = matchMedia('(prefers-reduced-motion: reduce)');

class Viewer {
  camera = new Camera();
  cursor = null;
  level = 0;
  clicks = [];  // records that are split beyond the level, in order
  part = 'ribbon';
  lastDone = 0;  // operations of the last frame that had any
  #since = 0;  // operations since the last update of the live buffer
  #asked = false;
  #shownOperations = -1;  // the number of operations last shown
  #moved = true;
  #done = true;
  #waiting = false;  // the requested frame is not only for the light
  #seen = undefined;  // the step of a cut that is painted
  #painting = false;  // parts of the ribbon are not painted yet
  #read = false;  // the page says what a frame reads
  peel = 0;  // how much of the ribbon lies flat
  #peeling = null;  // to which share, from when on

  constructor(restrip, wasm) {
    this.restrip = restrip;
    this.light = false;
    this.pane = new Pane(by('canvas'), this.camera, {
      changed: () => this.ask(),
      lost: () => this.lost(),
      restored: () => {
        this.painter.scene = this.scene;
        this.painter.repaint();  // the ribbon continues
        this.scene.setPoints(this.mesh.points, indexWidth(this.source));
        this.scene.upload(this.mesh.indices, []);
        this.found();
      },
    });
    this.painter = new Painter(this.scene);
    this.cut = new Cut(this, by);
    this.turn = new Turn(this, by);
    this.race = new Race(this, by);
    this.link = new Link(this, by);
    this.files = new Files(by, wasm, { show: (source) => this.show(source), fault: (message) => this.fault(message) });
    listen(this, by);
  }

  get scene() { return this.pane.scene; }
  get ribbon() { return this.painter.ribbon; }

  // ---- meshes
  /// `source`: of prepared().
  async show(source) {
    await later();  // a large mesh takes a frame for each of these
    const mesh = source.baked ? this.restrip.baked(source.baked) : this.restrip.progressive(source);
    await later();
    this.mesh?.close();
    this.mesh = mesh;
    this.source = source;
    const baked = by('policy').querySelector('[value=baked]');
    baked.disabled = baked.hidden = by('single').hidden = !mesh.hasBakedStrips;
    if (baked.disabled && by('policy').value === 'baked') by('policy').value = 'quick';
    this.found();
    this.splits = source.splits;
    this.normals = source.normals;
    this.camera.fit(mesh.points);
    this.home = this.camera.place;
    this.scene.setPoints(mesh.points, indexWidth(source));
    by('reads').parentElement.setAttribute('aria-busy', 'true');  // the bars are another mesh's
    showMesh(by, source, mesh);
    by('level').max = mesh.levels;
    this.level = Math.round(mesh.levels * 0.1);
    this.race.end();
    this.begin();
  }
  /// The base with strips from scratch; the frames that follow go up under the chosen policy. The picture then does not
  /// depend on earlier ones.
  begin() {
    this.mesh.begin({ policy: by('policy').value, cost: by('cost').value });
    this.clicks = [];
    this.cut.end();
    this.painter.ribbon = null;
    const baked = by('policy').value === 'baked';
    by('cost').closest('label').hidden = baked;  // the file was baked with one
    this.#shownOperations = -1;
    this.pace = new Pace();
    this.#upload();
    this.painter.stale();
    this.#read = false;
    this.changed();
  }

  // ---- single steps
  step(by_) {
    by('mode').value = 'level';
    this.moveTo(Math.max(0, Math.min(this.mesh.levels, this.level + by_)));
  }
  moveTo(level) {
    this.level = level;
    this.cut.end();
    // Out of order baked strips are lost; the base has them again.
    const lost = this.clicks.length > 0 && by('policy').value === 'baked';
    this.clicks = [];
    if (lost) this.begin();
    else this.changed();
  }
  /// Splits one record beyond the level, whose needs are split already.
  splitRecord(record) {
    this.arrive();
    const read = () => this.painter.read(() => this.mesh.ribbon);
    const before = read();
    this.clicks.push(record);
    this.#advance(1);
    this.marked = null;
    this.cut.begin(before, read());
  }
  canSplit(record) {
    this.arrive();
    return this.mesh.ready.includes(record);
  }
  /// The rest of the way to the level, at once.
  arrive() {
    if (this.#moved || !this.#done) this.#advance(Infinity);
  }
  /// The level without what was clicked, seen as a whole.
  afresh() {
    this.begin();
    this.camera.fly(this.home, this.moves ? 700 : 0);
  }

  // ---- frames
  /// Things may move by themselves.
  get moves() { return !still.matches; }
  /// Nothing is left to be done.
  get settled() { return !(this.#asked && this.#waiting) && (this.part === 'race' ? this.race.settled : this.resting && !this.#painting); }
  get resting() { return !this.#moved && this.#done; }
  changed() {
    this.#moved = true;
    this.ask();
  }
  ask() {
    this.#waiting = true;
    this.#askFrame();
  }
  #askFrame() {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame((now) => this.frame(now));
  }
  #upload() {
    const ranges = this.mesh.update();  // may move the indices
    this.scene.upload(this.mesh.indices, ranges);
    this.#since = 0;
  }
  /// Moves towards the wanted records, with at most `most` operations.
  #advance(most) {
    const { mesh } = this;
    const look = this.pane.ray(...(this.cursor ?? [0, 0]));
    const { level, clicks, splits, normals, camera } = this;
    const wanted = wantedRecords({ mode: by('mode').value, mesh, level, clicks, splits, normals, camera, look });
    const before = performance.now();
    let done = 0;
    let arrived = false;
    while (!arrived && done < most) {
      const part = Math.min(most - done, updateEvery - this.#since);
      const count = wanted ? mesh.approach(wanted, part) : mesh.moveTo(this.level, part);
      done += count;
      this.#since += count;
      arrived = count < part;
      if (this.#since === updateEvery) this.#upload();
    }
    this.#done = arrived || clicks.length > 0;
    if (this.#done && this.#since > 0) this.#upload();
    this.pace.learn(done, most, performance.now() - before);
    this.#moved = false;
    if (done > 0) {
      this.painter.stale();
      this.#read = false;
      this.lastDone = done;
    }
    this.figures = mesh.figures;
    this.showLast();
  }
  frame(now) {
    this.#asked = this.#waiting = false;
    if (!this.mesh) return;
    const flying = this.camera.step(now);
    const going = this.part === 'race' ? this.race.frame(now) : this.#frameAlone(now);
    this.link.write();
    if (!this.settled || flying) this.ask();
    else if (going) this.#askFrame();
  }
  /// Of the one mesh that all parts but the race show.
  #frameAlone(now) {
    this.pace.begin();
    if (!this.resting) this.#advance(this.pace.most);
    const going = this.cut.advance(now);
    const peeling = this.#peelOn(now);
    this.#painting = this.#drawn && this.draw({ now, whole: false });
    showLevel(by, this.figures.played, this.mesh.levels, this.level);
    showFigures(by, this);
    by('unpeel').textContent = (this.#peeling?.to ?? this.peel) > 0.5 ? 'Roll up' : 'Unpeel';
    by('cut-none').hidden = this.part !== 'cut' || !this.resting || this.cut.ready.length > 0;
    if (this.part === 'ribbon' && this.settled && !this.#read) {
      showReads(by, this);
      this.#read = true;
    }
    return going || peeling || this.#lit;
  }
  get #drawn() { return this.part !== 'turn' && by('canvas').checkVisibility(); }
  get #lit() { return this.light && this.#drawn && by('style').value === 'strips' && !document.hidden; }
  /// Unrolls the ribbon, or rolls it up again.
  unpeel() {
    this.#peeling = { to: (this.#peeling?.to ?? this.peel) > 0.5 ? 0 : 1, from: this.peel, start: performance.now() };
    this.ask();
  }
  peelTo(share) {
    this.peel = share;
    this.#peeling = null;
    this.ask();
  }
  #peelOn(now) {
    if (!this.#peeling) return false;
    const { to, from, start } = this.#peeling;
    const share = this.moves ? Math.max(0, Math.min(1, (now - start) / 5000)) : 1;
    this.peel = by('peel').value = from + (to - from) * share;
    if (share === 1) this.#peeling = null;
    return share < 1;
  }
  /// `list`: draws the triangles of the mesh one by one, from no strips. Unless `whole`, paints no more of the ribbon than fits into
  /// a frame; returns whether parts of it are left.
  draw({ style = by('style').value, list = false, patch = true, now = -1, whole = true } = {}) {
    const { mesh, painter, scene } = this;
    if (scene.lost) return false;
    const step = patch ? this.cut.seen(now) : null;
    let left = 0;
    if (step && !list) {
      // It differs from the ribbon of the mesh; what it shows is made when it has changed, not when the camera moves.
      if (this.#seen !== step.name) scene.paint(step.ribbon.vertices(mesh.points, step));
      painter.repaint();
      style = 'strips';
    } else if (style === 'strips' && !list) left = painter.paint(() => mesh.ribbon, mesh.points, this.resting, whole);
    this.#seen = step?.name;
    const peel = step || this.part !== 'ribbon' ? 0 : this.peel;
    if (peel > 0 && left === 0 && style === 'strips') painter.flatten(this.pane.aspect);
    scene.draw(this.camera, { style: left > 0 ? 'shaded' : style, length: mesh.indices.length, ...this.pane.colors,
      patch: patch && !this.cut.shown ? this.marked : null, dots: patch && this.part === 'cut' ? this.cut.places : null,
      list: list ? mesh.triangles : null, time: this.light && now >= 0 ? now / 1000 : -1, peel });
    return left > 0 && this.resting;
  }

  savePicture() {
    this.draw();
    this.pane.save(`restrip-${this.part}-${this.level}.png`);
  }

  // ---- text
  /// The browser has taken the graphics card, or has given it back.
  lost() {
    this.fault('The browser has taken the graphics card from this page. The picture returns when the browser restores it; otherwise load the page again.');
  }
  found() {
    by('fault').hidden = true;
    this.ask();
  }
  fault(message) {
    by('fault-text').textContent = message;
    by('fault').hidden = false;
  }
  showLast() {
    if (this.figures.operations === this.#shownOperations) return;
    this.#shownOperations = this.figures.operations;
    const last = this.figures.operations > 0 ? this.mesh.last : null;
    this.marked = null;
    if (last && this.lastDone === 1) {
      // First as it was, a moment later as it is.
      const { operations } = this.figures;
      this.marked = last.trianglesBefore;
      setTimeout(() => {
        if (this.figures.operations !== operations) return;
        this.marked = last.trianglesAfter;
        this.ask();
      }, 500);
    }
  }
}

try {
  const wasm = await embedded('wasm');
  const restrip = await load(wasm);
  let viewer = null;
  try {
    viewer = new Viewer(restrip, wasm);
  } catch (error) {
    window.restripPlain = new Plain(restrip, by, error.message);
  }
  if (viewer) {
    window.restripViewer = viewer;  // for the console, and for tests
    by('still').hidden = true;
    await viewer.show({ ...prepared(restrip, 'hare', { baked: new Uint8Array(await embedded('mesh')) }) });
    viewer.link.follow();
  }
} catch (error) {
  by('fault-text').textContent = error.message;
  by('fault').hidden = false;
  console.error(error);
}

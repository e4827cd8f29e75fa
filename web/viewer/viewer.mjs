// The page: a progressive mesh whose strips are kept in WebAssembly, drawn from the live index buffer or as ribbons, and
// the parts that play with it.
import { load } from '../js/restrip.mjs';
import { prepared } from './prepare.mjs';
import { embedded } from './embedded.mjs';
import { Camera } from './camera.mjs';
import { Pane } from './pane.mjs';
import { Pace } from './pace.mjs';
import { Ribbon } from './ribbon.mjs';
import { Cut } from './cut.mjs';
import { Turn } from './turn.mjs';
import { Race } from './race.mjs';
import { Files } from './files.mjs';
import { Link } from './link.mjs';
import { listen } from './controls.mjs';
import { showFigures, showLevel, showMesh } from './figures.mjs';
import { wantedRecords } from './detail.mjs';

const by = (id) => document.getElementById(id);
const still = matchMedia('(prefers-reduced-motion: reduce)');

class Viewer {
  camera = new Camera();
  cursor = null;
  level = 0;
  clicks = [];  // records that are split beyond the level, in order
  part = 'ribbon';
  pointed = null;  // a triangle that is pointed at
  lastDone = 0;  // operations of the last frame that had any
  #asked = false;
  #told = -1;  // the operations that the last one was told of
  #moved = true;
  #done = true;
  #waiting = false;  // the frame that was asked for is for more than the light

  constructor(restrip, wasm) {
    this.restrip = restrip;
    this.light = !still.matches;
    this.pane = new Pane(by('canvas'), this.camera, {
      changed: () => this.ask(),
      lost: () => this.lost(),
      restored: () => {
        this.scene.setPoints(this.mesh.points);
        this.scene.upload(this.mesh.indices, []);
        this.painted = null;  // the ribbon goes on
        this.found();
      },
    });
    this.cut = new Cut(this, by);
    this.turn = new Turn(this, by);
    this.race = new Race(this, by);
    this.link = new Link(this, by);
    this.files = new Files(by, wasm, { show: (source) => this.show(source), fault: (message) => this.fault(message) });
    listen(this, by);
  }

  get scene() { return this.pane.scene; }

  // ---- meshes
  /// `source`: of prepared().
  show(source) {
    const mesh = source.baked ? this.restrip.baked(source.baked) : this.restrip.progressive(source);
    this.mesh?.close();
    this.mesh = mesh;
    this.source = source;
    const baked = by('policy').querySelector('[value=baked]');
    baked.disabled = baked.hidden = !mesh.hasBakedStrips;
    if (baked.disabled && by('policy').value === 'baked') by('policy').value = 'quick';
    by('fault').hidden = true;
    this.splits = source.splits;
    this.normals = source.normals;
    this.camera.fit(mesh.points);
    this.home = this.camera.place;
    this.scene.setPoints(mesh.points);
    showMesh(by, source, mesh);
    by('level').max = mesh.levels;
    this.level = Math.round(mesh.levels * 0.1);
    this.race.end();
    this.begin();
  }
  /// The base with strips from scratch; the frames that follow go up under the chosen policy. What is seen then does not
  /// depend on what was seen before.
  begin() {
    this.mesh.begin({ policy: by('policy').value, cost: by('cost').value });
    this.clicks = [];
    this.cut.end();
    this.ribbon = null;
    by('cost').disabled = by('policy').value === 'baked';
    this.#told = -1;
    this.pace = new Pace();
    this.#upload();
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
    const before = this.#paintedRibbon();
    this.clicks.push(record);
    this.#advance(1);
    this.ribbon = new Ribbon(this.mesh.ribbon, before);
    this.stale = false;
    this.marked = null;
    this.cut.begin(before, this.ribbon);
    this.ask();
  }
  canSplit(record) {
    this.arrive();
    return this.mesh.ready.includes(record);
  }
  /// What is left of the way to the level, at once.
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
  get settled() { return !(this.#asked && this.#waiting) && (this.part === 'race' ? this.race.settled : !this.#moved && this.#done); }
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
    this.stale = true;
    this.painted = null;
  }
  /// Towards what is wanted, with at most so many operations.
  #advance(most) {
    const { mesh } = this;
    const look = this.pane.ray(...(this.cursor ?? [0, 0]));
    const { level, clicks, splits, normals, camera } = this;
    const wanted = wantedRecords({ mode: by('mode').value, mesh, level, clicks, splits, normals, camera, look });
    const before = performance.now();
    const done = wanted ? mesh.approach(wanted, most) : mesh.moveTo(this.level, most);
    const took = performance.now() - before;
    this.pace.learn(done, most, took);
    this.#moved = false;
    this.#done = done < most || this.clicks.length > 0;
    this.#upload();
    if (done > 0) this.lastDone = done;
    this.figures = mesh.figures;
    this.showLast();
  }
  frame(now) {
    this.#asked = this.#waiting = false;
    if (!this.mesh) return;
    const flying = this.camera.step(now);
    const going = this.part === 'race' ? this.race.frame(now) : this.#frameAlone(now);
    this.link.tell();
    if (!this.settled || flying) this.ask();
    else if (going) this.#askFrame();
  }
  /// Of the one mesh that all parts but the race show.
  #frameAlone(now) {
    if (this.#moved || !this.#done) this.#advance(this.pace.most);
    const going = this.cut.advance(now);
    if (this.part !== 'turn') this.draw({ now });  // which covers it
    showLevel(by, this.figures.played, this.mesh.levels, this.level);
    showFigures(by, this);
    return going || this.#lit;
  }
  get #lit() { return this.light && by('style').value === 'strips' && this.part !== 'turn' && !document.hidden; }
  /// The ribbon of the mesh as it is.
  #paintedRibbon() {
    if (this.stale || !this.ribbon) this.ribbon = new Ribbon(this.mesh.ribbon, this.ribbon);
    this.stale = false;
    return this.ribbon;
  }
  /// `list`: draws the triangles of the mesh one by one, from no strips.
  draw({ style = by('style').value, list = false, patch = true, now = -1 } = {}) {
    const { mesh } = this;
    if (this.scene.lost) return;
    const step = patch ? this.cut.seen(now) : null;
    if (step) style = 'strips';
    const marked = this.pointed ?? (patch && !this.cut.shown ? this.marked : null);
    // What a style shows beside the buffer is made when the buffer has changed, not when the camera moves.
    const what = step ? `step ${this.cut.step}` : style;
    if (!list && style !== 'shaded' && this.painted !== what) {
      if (style === 'strips') this.scene.paint((step?.ribbon ?? this.#paintedRibbon()).vertices(mesh.points, step?.moved));
      else this.scene.setLines(mesh.lines);
      this.painted = what;
    }
    this.scene.draw(this.camera, { style, length: mesh.indices.length, ...this.pane.colors, patch: marked,
      list: list ? mesh.triangles : null, time: this.light && now >= 0 ? now / 1000 : -1 });
  }

  savePicture() {
    this.draw();
    this.pane.save(`restrip-${this.part}-${this.level}.png`);
  }

  // ---- what is said
  /// The browser has taken the graphics card, or has given it back.
  lost() {
    this.fault('The browser has taken the graphics card from this page. The picture returns when it gives it back; else load the page again.');
  }
  found() {
    by('fault').hidden = true;
    this.ask();
  }
  fault(message) {
    by('fault').textContent = message;
    by('fault').hidden = false;
  }
  showLast() {
    if (this.figures.operations === this.#told) return;
    this.#told = this.figures.operations;
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
    this.cut.tell();
  }
}

try {
  const wasm = await embedded('wasm');
  const restrip = await load(wasm);
  const viewer = new Viewer(restrip, wasm);
  window.restripViewer = viewer;  // for the console, and for tests
  by('still').hidden = true;
  viewer.show({ ...prepared(restrip, 'hare', { baked: new Uint8Array(await embedded('mesh')) }).next().value });
  viewer.link.follow();
} catch (error) {
  by('fault').textContent = error.message;
  by('fault').hidden = false;
  console.error(error);
}

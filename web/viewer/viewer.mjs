// The page: a progressive mesh whose strips are kept in WebAssembly, drawn from the live index buffer or as ribbons, and
// the parts that play with it.
import { load, none } from '../js/restrip.mjs';
import { prepared } from './prepare.mjs';
import { embedded } from './embedded.mjs';
import { Camera } from './camera.mjs';
import { Scene } from './scene.mjs';
import { Ribbon } from './ribbon.mjs';
import { Cut } from './cut.mjs';
import { placeOf, placeText, readLink, writeLink } from './link.mjs';

const by = (id) => document.getElementById(id);
const parts = ['ribbon', 'cut'];
const still = matchMedia('(prefers-reduced-motion: reduce)');
/// Milliseconds that the operations of a frame may take, and how many there are at first, before their speed is known.
const frameBudget = 12;
const firstPace = 256;

class Viewer {
  camera = new Camera();
  cursor = null;
  level = 0;
  clicks = [];  // records that are split beyond the level, in order
  part = 'ribbon';
  pointed = null;  // a triangle that is pointed at
  // How many recent operations there were, and how long they took.
  timed = { operations: 0, milliseconds: 0 };
  lastFrame = { operations: 0, bytes: 0, whole: 0 };
  #asked = false;
  #told = -1;  // the operations that the last one was told of
  pace = firstPace;  // operations of the next frame, at most
  #moved = true;
  #done = true;
  #waiting = false;  // the frame that was asked for is for more than the light

  constructor(restrip, wasm) {
    this.restrip = restrip;
    this.wasm = wasm;  // its bytes, for workers
    this.scene = new Scene(by('canvas'));
    this.cut = new Cut(this, by);
    this.light = !still.matches;
    by('light').setAttribute('aria-pressed', String(this.light));
    by('light').addEventListener('click', () => {
      this.light = !this.light;
      by('light').setAttribute('aria-pressed', String(this.light));
      this.ask();
    });
    by('picture').addEventListener('click', () => this.savePicture());
    this.camera.listen(by('canvas'), () => this.#changed(), (event) => {
      if (this.part === 'cut') this.cut.click(this.#rayAt(event));
    });
    by('canvas').addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && this.part === 'cut') this.cut.click(this.#ray(0, 0));
    });
    addEventListener('hashchange', () => this.goTo(readLink(location.hash)));
    by('canvas').addEventListener('pointermove', (event) => {
      this.cursor = this.#windowPlace(event);
      if (event.buttons !== 0) return;
      if (by('mode').value === 'cursor') this.#changed();
      else if (this.part === 'cut' && this.cut.shown) this.cut.pointFrom(this.#rayAt(event));
    });
    by('level').addEventListener('input', () => this.moveTo(+by('level').value));
    by('down').addEventListener('click', () => this.step(-1));
    by('up').addEventListener('click', () => this.step(1));
    for (const id of ['policy', 'cost']) by(id).addEventListener('change', () => this.begin());
    by('mode').addEventListener('change', () => {
      // Out of order baked strips are lost; the base has them again.
      const lost = by('policy').value === 'baked' && by('mode').value === 'level' && !this.mesh.figures.baked;
      if (lost) this.begin();
      else this.#changed();
    });
    by('style').addEventListener('change', () => this.ask());
    by('compare').addEventListener('click', () => this.compare());
    by('file').addEventListener('change', () => by('file').files.length && this.open(by('file').files[0]));
    document.addEventListener('keydown', (event) => {
      if (['SELECT', 'INPUT'].includes(event.target.tagName)) return;
      if (event.key === '.') this.step(1);
      if (event.key === ',') this.step(-1);
    });
    const stage = by('stage');
    document.addEventListener('dragover', (event) => { event.preventDefault(); stage.classList.add('over'); });
    document.addEventListener('dragleave', (event) => { if (!event.relatedTarget) stage.classList.remove('over'); });
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      stage.classList.remove('over');
      if (event.dataTransfer.files.length) this.open(event.dataTransfer.files[0]);
    });
    by('canvas').addEventListener('webglcontextlost', (event) => {
      event.preventDefault();  // so that it may come back
      this.fault('The browser has taken the graphics card from this page. The picture returns when it gives it back; else load the page again.');
    });
    by('canvas').addEventListener('webglcontextrestored', () => {
      this.scene = new Scene(by('canvas'));
      this.scene.setPoints(this.mesh.points);
      this.scene.upload(this.mesh.indices, []);
      this.painted = null;  // the ribbon goes on
      by('fault').hidden = true;
      this.ask();
    });
    new ResizeObserver(() => this.#resize()).observe(stage);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.ask());
  }

  // ---- meshes
  /// Prepares a file in a worker and shows it; a file that is opened meanwhile takes its place.
  async open(file) {
    this.worker?.terminate();
    this.workerAddress ??= URL.createObjectURL(new Blob([by('worker').textContent], { type: 'text/javascript' }));
    const worker = this.worker = new Worker(this.workerAddress);
    this.working(`${file.name} …`);
    try {
      const bytes = await file.arrayBuffer();
      const mesh = await new Promise((resolve, reject) => {
        worker.onmessage = ({ data }) => {
          if (data.fault !== undefined) reject(new Error(data.fault));
          else if (data.mesh) resolve(data.mesh);
          else if (this.worker === worker) this.working(`${file.name}: ${Math.floor(100 * data.share)} % simplified`, data.share);
        };
        worker.onerror = (event) => reject(new Error(event.message ?? 'the worker of this page did not start'));
        worker.postMessage({ wasm: this.wasm, name: file.name, bytes }, [bytes]);
      });
      if (this.worker === worker) this.show(mesh);
    } catch (error) {
      if (this.worker === worker) this.fault(error.message.startsWith(file.name) ? error.message : `${file.name}: ${error.message}`);
    } finally {
      worker.terminate();
      if (this.worker === worker) this.working(null);
    }
  }
  /// What is being prepared, and the share that is done where it is known.
  working(text, share) {
    by('working').hidden = text === null;
    by('working-text').textContent = text ?? '';
    if (share === undefined) by('progress').removeAttribute('value');
    else by('progress').value = share;
  }
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
    const left = source.leftOut;
    let triangles = source.base.length / 3;
    for (let i = 0; i < this.splits.length; i += 4) triangles += this.splits[i + 2] !== none && this.splits[i + 3] !== none ? 2 : 1;
    by('mesh-text').textContent = `${source.name}: ${triangles.toLocaleString('en')} triangles, ${mesh.levels.toLocaleString('en')} levels below.` +
      (left.triangles ? ` ${left.triangles} degenerate triangles were left out.` : '') +
      (left.nonManifoldVertices ? ` The mesh is not a manifold at ${left.nonManifoldVertices} vertices, which stay as they are.` : '');
    by('level').max = mesh.levels;
    this.level = Math.round(mesh.levels * 0.1);
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
    this.timed = { operations: 0, milliseconds: 0 };
    this.#told = -1;
    this.pace = firstPace;
    this.#upload();
    this.#changed();
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
    else this.#changed();
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
  get settled() { return !(this.#asked && this.#waiting) && !this.#moved && this.#done; }
  #changed() {
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
  #resize() {
    const box = by('stage').getBoundingClientRect();
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    by('canvas').width = Math.max(1, Math.round(box.width * scale));
    by('canvas').height = Math.max(1, Math.round(box.height * scale));
    this.ask();
  }

  #windowPlace(event) {
    const box = by('canvas').getBoundingClientRect();
    return [(event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2];
  }
  #ray(x, y) { return this.camera.ray(x, y, by('canvas').width / by('canvas').height); }
  #rayAt(event) { return this.#ray(...this.#windowPlace(event)); }
  /// Which records are wanted in the view-dependent modes: the level everywhere, all of them where one looks.
  #wanted() {
    const mode = by('mode').value;
    const { points, levels } = this.mesh;
    const wanted = new Uint8Array(levels).fill(1, 0, this.level);
    for (const record of this.clicks) wanted[record] = 1;
    if (mode === 'level') return this.clicks.length > 0 ? wanted : null;
    if (mode === 'cursor') {
      const { from, along } = this.#ray(...(this.cursor ?? [0, 0]));
      const hit = this.mesh.pick(from, along);
      if (!hit) return wanted;
      const near = (0.22 * this.camera.size) ** 2;
      for (let i = this.level; i < levels; ++i) {
        const v = 3 * this.splits[4 * i + 1];
        if ((points[v] - hit[0]) ** 2 + (points[v + 1] - hit[1]) ** 2 + (points[v + 2] - hit[2]) ** 2 < near) wanted[i] = 1;
      }
      return wanted;
    }
    const eye = this.camera.eye;
    for (let i = this.level; i < levels; ++i) {
      const v = 3 * this.splits[4 * i + 1];
      const [x, y, z] = [eye[0] - points[v], eye[1] - points[v + 1], eye[2] - points[v + 2]];
      const facing = (x * this.normals[v] + y * this.normals[v + 1] + z * this.normals[v + 2]) / Math.hypot(x, y, z);
      if (Math.abs(facing) < 0.12) wanted[i] = 1;
    }
    return wanted;
  }
  #upload() {
    const ranges = this.mesh.update();  // may move the indices
    this.scene.upload(this.mesh.indices, ranges);
    this.stale = true;
    this.painted = null;
  }
  /// Towards what is wanted, with at most so many operations.
  #advance(most) {
    const { mesh, scene } = this;
    const wanted = this.#wanted();
    const before = performance.now();
    const done = wanted ? mesh.approach(wanted, most) : mesh.moveTo(this.level, most);
    const took = performance.now() - before;
    // The next frame does as many as fit into its budget, if they take as long; the clock may be a coarse one.
    if (most <= this.pace && done > 0 && (done === most || took > frameBudget))
      this.pace = Math.max(1, Math.min(4 * most, Math.floor(done * frameBudget / Math.max(took, 0.1))));
    this.timed.milliseconds += took;
    this.timed.operations += done;
    if (this.timed.operations > 20000) for (const key in this.timed) this.timed[key] /= 2;
    this.#moved = false;
    this.#done = done < most || this.clicks.length > 0;
    scene.bytesUploaded = 0;
    this.#upload();
    if (done > 0 || scene.bytesUploaded > 0)
      this.lastFrame = { operations: done, bytes: scene.bytesUploaded, whole: 4 * mesh.indices.length };
    this.figures = mesh.figures;
    this.showLast();
  }
  frame(now) {
    const started = performance.now();
    this.#asked = this.#waiting = false;
    if (!this.mesh) return;
    if (this.#moved || !this.#done) this.#advance(this.pace);
    const flying = this.camera.step(now);
    const going = this.cut.advance(now);
    this.draw({ now });
    this.showFigures(performance.now() - started);
    this.#tellLink();
    if (!this.#done || flying) this.ask();
    else if (going || this.#lit) this.#askFrame();
  }
  get #lit() { return this.light && by('style').value === 'strips' && !document.hidden; }
  colors() {
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    return dark ? { ink: [0.62, 0.66, 0.72], paper: [0.051, 0.059, 0.071] } : { ink: [0.86, 0.87, 0.88], paper: [0.914, 0.929, 0.945] };
  }
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
    this.scene.draw(this.camera, { style, length: mesh.indices.length, ...this.colors(), patch: marked,
      list: list ? mesh.triangles : null, time: this.light && now >= 0 ? now / 1000 : -1 });
  }

  // ---- the link
  /// What a link names, and what it does not name stays; false where the mesh has changed.
  goTo(state) {
    this.part = parts.includes(state.part) ? state.part : 'ribbon';
    for (const id of ['policy', 'cost', 'mode', 'style']) {
      const option = state[id] === undefined ? null : [...by(id).options].find(({ value, disabled }) => value === state[id] && !disabled);
      if (option && by(id).value !== option.value) {
        by(id).value = option.value;
        if (id === 'policy' || id === 'cost') this.begin();
      }
    }
    const level = Number(state.level ?? NaN);
    if (Number.isInteger(level) && level >= 0 && level <= this.mesh.levels && level !== this.level) this.moveTo(level);
    for (const record of (state.cut ?? '').split(',').filter(Boolean).map(Number))
      if (!this.clicks.includes(record) && this.#canSplit(record)) this.splitRecord(record);
    const place = placeOf(state.view);
    if (place) this.camera.place = place;
    this.showPart();
    this.ask();
  }
  #canSplit(record) {
    this.arrive();
    return this.mesh.ready.includes(record);
  }
  #tellLink() {
    clearTimeout(this.telling);
    if (!this.settled) return;
    this.telling = setTimeout(() => {
      const view = placeText(this.camera.place);
      const given = (id, usual) => (by(id).value === usual ? undefined : by(id).value);
      writeLink({ part: this.part, level: this.level, policy: by('policy').value, cost: given('cost', 'strips'), mode: given('mode', 'level'),
        style: given('style', 'strips'), cut: this.clicks.join(','), view: view === placeText(this.home) ? undefined : view });
    }, 250);
  }
  showPart() {
    for (const part of parts) {
      by(`part-${part}`).hidden = part !== this.part;
      const link = by('parts').querySelector(`[href="#part=${part}"]`);
      if (part === this.part) link.setAttribute('aria-current', 'page');
      else link.removeAttribute('aria-current');
    }
    by('hint').textContent = this.part === 'cut' ? 'Click the mesh to cut it. Drag to turn.' : 'Drag to turn. Drop a mesh on the page: OBJ, PLY, OFF, GLB, PM, baked.';
  }
  savePicture() {
    this.draw();
    by('canvas').toBlob((blob) => {
      const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(blob), download: `restrip-${this.part}-${this.level}.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
  }

  // ---- what is said
  fault(message) {
    by('fault').textContent = message;
    by('fault').hidden = false;
  }
  showFigures(milliseconds) {
    const f = this.figures;
    const number = (n) => n.toLocaleString('en');
    const bytes = (n) => (n < 1e6 ? `${(n / 1000).toFixed(1)} kB` : `${(n / 1e6).toFixed(2)} MB`);
    by('level').value = this.level;
    const name = this.source.name === 'hare' ? 'this hare' : 'this mesh';
    by('claim').textContent = f.strips === 1 ? `All ${number(f.triangles)} triangles of ${name} are one strip. Move the level.`
      : `${number(f.triangles)} triangles of ${name} in ${number(f.strips)} strips. Move the level.`;
    by('level-text').textContent = `${number(f.played)} of ${number(this.mesh.levels)} splits`;
    by('f-triangles').textContent = number(f.triangles);
    by('f-strips').textContent = number(f.strips);
    by('f-length').textContent = (f.triangles / f.strips).toFixed(1);
    by('f-indices').textContent = (f.bufferIndices / f.triangles).toFixed(3);
    by('f-operations').textContent = number(this.lastFrame.operations);
    by('f-bytes').textContent = bytes(this.lastFrame.bytes);
    by('f-whole').textContent = bytes(this.lastFrame.whole);
    by('f-time').textContent = this.timed.operations > 50 ? `${(1000 * this.timed.milliseconds / this.timed.operations).toFixed(1)} µs` : '–';
    by('f-frame').textContent = `${milliseconds.toFixed(1)} ms`;
    by('down').disabled = this.level === 0;
    by('up').disabled = this.level === this.mesh.levels;
  }
  showLast() {
    if (this.figures.operations === this.#told) return;
    this.#told = this.figures.operations;
    const last = this.figures.operations > 0 ? this.mesh.last : null;
    this.marked = null;
    if (last && this.lastFrame.operations === 1) {
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
  async compare() {
    by('compare').disabled = true;
    const rows = [];
    const cost = by('cost').value;
    const { source } = this;
    for (const policy of ['local', 'linked', 'quick', 'full', ...(source.baked ? ['baked'] : [])]) {
      const mesh = (policy === 'baked' ? this.restrip.baked(source.baked) : this.restrip.progressive(source)).begin({ policy, cost });
      let took = 0;
      for (let most = firstPace;;) {  // in parts, so that the page goes on
        by('compared').textContent = `${policy}: ${Math.floor(100 * mesh.figures.played / mesh.levels)} %`;
        await new Promise((rested) => setTimeout(rested, 0));
        const before = performance.now();
        const done = mesh.moveTo(mesh.levels, most);
        const part = performance.now() - before;
        took += part;
        if (done < most) break;
        most = Math.max(1, Math.min(4 * most, Math.floor(done * 50 / Math.max(part, 0.1))));
      }
      const each = took * 1000 / mesh.levels;
      const { triangles, strips, addingStrip } = mesh.figures;
      rows.push([policy, strips, (mesh.plainIndices / triangles).toFixed(3), `${(100 * addingStrip / mesh.levels).toFixed(1)} %`, each.toFixed(1)]);
      if (policy === 'full') this.bound = mesh.indexBound / triangles;
      mesh.close();
    }
    by('compared').innerHTML = '<table><thead><tr><th>policy<th>strips<th>indices per triangle<th>splits that add a strip<th>µs a split</tr></thead><tbody>' +
      rows.map((row) => `<tr>${row.map((cell) => `<td>${typeof cell === 'number' ? cell.toLocaleString('en') : cell}`).join('')}</tr>`).join('') +
      `</tbody></table><p>At the finest level. No index buffer of this mesh has fewer than ${this.bound.toFixed(3)} indices per triangle; a triangle list has 3.</p>`;
    by('compare').disabled = false;
    this.ask();
  }
}

try {
  const wasm = await embedded('wasm');
  const restrip = await load(wasm);
  const viewer = new Viewer(restrip, wasm);
  window.restripViewer = viewer;  // for the console, and for tests
  by('still').hidden = true;
  viewer.show({ ...prepared(restrip, 'hare.baked', await embedded('mesh')).next().value, name: 'hare' });
  viewer.goTo(readLink(location.hash));
} catch (error) {
  by('fault').textContent = error.message;
  by('fault').hidden = false;
  console.error(error);
}

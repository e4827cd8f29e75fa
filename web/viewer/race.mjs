// The race: four index buffers take the same steps of the level. The score is the sum of the bytes that changes write
// and the bytes that drawn frames read. Two of the buffers are drawn next to each other; the triangles that a step has
// written are highlighted.
import { Pane } from './pane.mjs';
import { Pace } from './pace.mjs';
import { Painter } from './ribbon.mjs';
import { asBytes, asNumber, asRatio, barRow, fineTriangles, indexWidth, showLevel } from './figures.mjs';
import { restartIndex } from '../../bindings/js/restrip.mjs';

// Ways to maintain an index buffer while the level of a mesh changes, each with a separate mesh: the bytes that a
// change writes, and the bytes that each drawn frame reads.

/// Their names on the page.
export const ways = { kept: 'Maintained strips', scratch: 'Strips from scratch', whole: 'List written whole', slots: 'List with slots' };

export class Lane {
  #scratch = null;  // the last index buffer from scratch

  /// `source`: of prepared(). Policy and cost are for strips; a list does not maintain strips. `width`: bytes of an
  /// index.
  constructor(restrip, way, source, { policy, cost, width }) {
    Object.assign(this, { way, cost, width });
    this.mesh = restrip.progressive(source).begin({ policy: way === 'kept' ? policy : 'bare', cost, form: this.isList ? 'list' : 'restart' });
    this.#follow();
    this.startHere();
  }
  /// Steps count from here on.
  startHere() { this.total = { steps: 0, operations: 0, written: 0, drawn: 0 }; }
  /// A step ends after that many operations, in any number of frames: the index buffer follows it once. Uploading is
  /// the caller's.
  endStep(operations) {
    this.#follow();
    this.total.steps += 1;
    this.total.operations += operations;
    this.total.written += this.width * this.ranges.reduce((sum, { count }) => sum + count, 0);
    this.total.drawn += this.width * this.length;
  }
  #follow() {
    if (this.way === 'scratch') {
      this.#scratch = this.mesh.fromScratch({ cost: this.cost });
      this.ranges = [{ first: 0, count: this.#scratch.length }];
    } else this.ranges = this.mesh.update();
    this.length = this.indices.length;
    if (this.way === 'whole') this.ranges = [{ first: 0, count: this.length }];
  }
  /// The indices to draw: a view, valid until the next call of any mesh.
  get indices() { return this.#scratch ?? this.mesh.indices; }
  get isList() { return this.way === 'whole' || this.way === 'slots'; }
  get ribbon() { return this.way === 'scratch' ? this.mesh.scratchRibbon : this.mesh.ribbon; }
  /// The triangles that the written indices draw, three corners each.
  get written() {
    const { indices } = this;
    const out = [];
    const add = (i) => {  // the triangle whose last index this is
      const [a, b, c] = [indices[i - 2], indices[i - 1], indices[i]];
      if (a !== b && b !== c && c !== a && Math.max(a, b, c) !== restartIndex) out.push(a, b, c);
    };
    // A triangle of a list ends at every third index, one of a strip at every index; each has the two before as well.
    const apart = this.isList ? 3 : 1;
    let next = 2;
    for (const { first, count } of this.ranges) {
      for (next = Math.max(next, first - first % apart + apart - 1); next < Math.min(first + count + 2, indices.length); next += apart) add(next);
    }
    return new Uint32Array(out);
  }
  close() { this.mesh.close(); }
}

/// Milliseconds of the highlight, if animation is allowed.
const litFor = 900;
/// Steps of a run to its turning point; the same number leads back.
const runSteps = 100;

/// One of the two pictures: a lane, drawn from a copy of its index buffer on the card or as ribbons.
class Track {
  constructor(canvas, viewer, restored) {
    this.pane = new Pane(canvas, viewer.camera, { changed: () => viewer.ask(), lost: () => viewer.lost(), restored });
    viewer.camera.listen(canvas, () => viewer.ask(), () => {});
  }
  /// `room`: indices for which there is to be storage.
  take(lane, room) {
    const { scene } = this.pane;
    Object.assign(this, { lane, painter: new Painter(scene) });
    scene.setPoints(lane.mesh.points, lane.width);
    scene.reserve(room);
    scene.upload(lane.indices, [{ first: 0, count: lane.length }]);
    this.written = [];
  }
  follow() {
    this.pane.scene.upload(this.lane.indices, this.lane.ranges);
    this.written = this.lane.written;
    this.painter.stale();
  }
  /// Whether there is more to paint. `resting`: the mesh does not move.
  draw(strength, resting) {
    const { lane, painter, pane: { scene, camera, colors } } = this;
    if (scene.lost) return false;
    const left = lane.isList ? 0 : painter.paint(() => lane.ribbon, lane.mesh.points, resting);
    scene.draw(camera, { style: lane.isList ? 'list' : left === 0 ? 'strips' : 'shaded', length: lane.length, ...colors, glow: { triangles: this.written, strength } });
    return left > 0 && resting;
  }
}

export class Race {
  lanes = null;  // by their ways
  at = 0;  // the level of all of them
  tracks = null;  // the other lane's track, and the track of maintained strips
  #work = null;  // the work left, in pieces
  #pace = null;
  #resting = false;  // none is left
  #counts = false;  // the lanes have arrived at the level from which on steps count
  #stepped = -Infinity;  // when the last step was
  #ahead = null;  // levels of a run that lie ahead

  constructor(viewer, by) {
    this.viewer = viewer;
    this.by = by;
    for (const id of ['race-policy', 'race-cost']) by(id).addEventListener('change', () => this.end());
    by('rival').addEventListener('change', () => {
      if (this.tracks) this.#take();
      viewer.ask();
    });
    by('frames').addEventListener('input', () => this.#describe());
    by('run').addEventListener('click', () => (this.#ahead ? this.#stop() : this.run()));
    for (const [id, event] of [['level', 'input'], ['up', 'click'], ['down', 'click']]) by(id).addEventListener(event, () => this.#stop());
  }

  #take() {
    if (Object.keys(this.lanes ?? {}).length < Object.keys(ways).length) return;
    [this.by('rival').value, 'kept'].forEach((way, n) => this.tracks[n].take(this.lanes[way], 3 * fineTriangles(this.viewer.source)));
  }
  /// Another mesh or another policy starts a new race.
  end() {
    for (const lane of Object.values(this.lanes ?? {})) lane.close();
    this.lanes = this.#work = null;
    this.#resting = false;
    this.#stop();
    this.viewer.ask();
  }
  /// From the level of the page to where there is more room, and back.
  run() {
    const { by, viewer } = this;
    const { level, mesh: { levels } } = viewer;
    const stride = Math.max(1, Math.floor(by('stride').value * levels));
    const [way, room] = 2 * level <= levels ? [stride, levels - level] : [-stride, level];
    const there = Array.from({ length: Math.min(runSteps, Math.floor(room / stride)) }, (_, n) => level + (n + 1) * way);
    this.#ahead = [...there, ...there.slice(0, -1).reverse(), level];
    this.#counts = this.#resting = false;
    by('run').textContent = 'Stop';
    viewer.ask();
  }
  #stop() {
    this.#ahead = null;
    this.by('run').textContent = 'Run';
  }

  /// Nothing is left to be done.
  get settled() { return this.#resting && this.at === this.viewer.level && this.#ahead === null; }

  /// Everything that the race does, in pieces that fit into a frame: the lanes one after the other. Says after which of them a step
  /// is to be seen, and when nothing is left.
  *#pieces() {
    const { viewer, by } = this;
    const { source, restrip } = viewer;
    const given = { policy: by('race-policy').value, cost: by('race-cost').value, width: indexWidth(source) };
    this.lanes = {};
    this.at = 0;
    this.#counts = false;
    for (const way of Object.keys(ways)) {
      this.lanes[way] = new Lane(restrip, way, source, given);
      yield 'more';
    }
    this.tracks ??= ['rival', 'kept'].map((name) => new Track(by(`${name}-canvas`), viewer, () => {
      if (this.lanes) this.#take();
      viewer.found();
    }));
    this.#take();
    for (;;) {
      let operations = 0;
      while (this.at !== viewer.level) {
        const [to, most] = [viewer.level, this.#pace.most];
        let [done, took] = [0, 0];
        for (const { mesh } of Object.values(this.lanes)) {
          const start = performance.now();
          done = mesh.moveTo(to, most);
          took = Math.max(took, performance.now() - start);
          yield 'more';
        }
        this.#pace.learn(done, most, took);
        this.at += to > this.at ? done : -done;
        operations += done;
      }
      if (operations > 0) {
        for (const lane of Object.values(this.lanes)) {
          lane.endStep(operations);
          yield 'more';
        }
        for (const track of this.tracks) track.follow();
      }
      if (!this.#counts) for (const lane of Object.values(this.lanes)) lane.startHere();
      this.#counts = true;
      if (this.#ahead?.length > 0) viewer.moveTo(this.#ahead.shift());
      else if (this.#ahead) this.#stop();
      yield this.at === viewer.level ? 'rest' : 'step';
    }
  }
  /// Works, and draws; whether there is more to come.
  frame(now) {
    const { viewer } = this;
    if (!this.#work) {
      this.#work = this.#pieces();
      this.#pace = new Pace();
    }
    // Without animation a run shows only its end.
    const ends = viewer.moves ? ['step', 'rest'] : ['rest'];
    this.#pace.begin();
    const until = performance.now() + this.#pace.budget;
    const before = this.lanes?.kept?.total.steps;
    let piece;
    do piece = this.#work.next().value; while (performance.now() < until && !ends.includes(piece));
    this.#resting = piece === 'rest';
    if (!this.tracks) return true;
    const { total } = this.lanes.kept;
    if (total.steps !== before) this.#stepped = now;
    const strength = total.steps === 0 ? 0 : viewer.moves ? Math.max(0, 1 - (now - this.#stepped) / litFor) : 1;
    let painting = false;
    if (this.#resting || (viewer.moves && piece === 'step')) for (const track of this.tracks) painting = track.draw(strength, this.#resting) || painting;
    showLevel(this.by, this.at, viewer.mesh.levels, viewer.level);
    if (ends.includes(piece)) this.#describe();
    if (painting) this.#resting = false;
    return !this.settled || (viewer.moves && strength > 0);
  }

  // ---- text
  /// The cost of a change with that many drawn frames: the bytes written and read, for each way.
  costs(frames) {
    return Object.fromEntries(Object.entries(this.lanes).map(([way, { total: { steps, written, drawn } }]) => {
      const [write, read] = [written / Math.max(1, steps), drawn / Math.max(1, steps)];
      return [way, { write, read, all: write + frames * read }];
    }));
  }
  #describe() {
    const { by, viewer, lanes } = this;
    if (!this.tracks || Object.keys(lanes ?? {}).length < 4) return;
    this.tracks.forEach(({ lane }, n) => { by(`${n === 0 ? 'rival' : 'kept'}-text`).textContent = ways[lane.way]; });
    const { steps, operations } = lanes.kept.total;
    by('sums').hidden = steps === 0;
    if (steps === 0) {
      by('race-text').textContent = 'Move the level, or press Run. The triangles that a step writes are highlighted.';
      return;
    }
    const frames = 10 ** by('frames').value;
    by('frames-text').textContent = frames >= 1 ? `${asRatio(frames)} per change` : `1 for ${asRatio(1 / frames)} changes`;
    const costs = this.costs(frames);
    const most = Math.max(...Object.values(costs).map(({ all }) => all));
    const least = Object.keys(costs).reduce((one, other) => (costs[other].all < costs[one].all ? other : one));
    by('lanes').innerHTML = Object.entries(costs).map(([way, { write, read, all }]) =>
      barRow(ways[way], [asBytes(write), asBytes(read), asBytes(all)], write / most, all / most, way === least)).join('');
    const { kept, slots } = costs;
    const [even, rebuilt] = [slots, costs.scratch].map(({ write, read }, n) => {  // frames drawn per change
      const frames = (kept.write - write) / (read - kept.read);
      const place = (Math.log10(frames) - by('frames').min) / (by('frames').max - by('frames').min);
      const mark = by('frames-row').getElementsByTagName('i')[n];
      mark.hidden = !(place > 0 && place < 1);
      mark.className = place > 0.5 ? 'late' : '';
      mark.style.left = `calc(9px + ${place} * (100% - 18px))`;
      return frames;
    });
    const share = (part, all) => `${asRatio(100 * part / all)} %`;
    by('race-text').textContent = least === 'kept'
      ? `Maintained strips move the fewest bytes: ${share(kept.all, slots.all)} of the list with slots, ${share(kept.all, costs.scratch.all)} of strips from scratch.`
      : `Here the ${ways[least].toLowerCase()} move${least === 'scratch' ? '' : 's'} the fewest bytes: ${share(costs[least].all, kept.all)} of maintained strips.`;
    const limit = operations / steps / even;  // operations per drawn frame
    by('even-text').textContent = even > 0
      ? `Maintained strips beat the list with slots while fewer than ${asNumber(limit)} operations, ${share(limit, slots.read / 3 / lanes.slots.width)} of the triangles, happen per drawn frame.`
      : 'Maintained strips write no more than the list with slots, and read less.';
    if (rebuilt > 0) by('even-text').textContent += ` From ${asRatio(rebuilt)} drawn frames per change on, strips from scratch win.`;
  }
}

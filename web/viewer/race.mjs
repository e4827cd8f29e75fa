// The race: a mesh whose strips are kept, and the same mesh with another index buffer, under one slider. What a step has
// written is lit.
import { Pane } from './pane.mjs';
import { Pace } from './pace.mjs';
import { Ribbon } from './ribbon.mjs';
import { Lane, ways } from './lanes.mjs';
import { asKilobytes, asNumber, fineTriangles, showLevel } from './figures.mjs';

/// Milliseconds for which what was written is lit, where things may move.
const litFor = 900;
/// Steps of a run to its end, and as many back.
const runSteps = 100;

/// One of the two pictures: a lane, drawn from a copy of its index buffer on the card or as ribbons beside it.
class Track {
  #stale = true;

  constructor(canvas, viewer, restored) {
    this.pane = new Pane(canvas, viewer.camera, { changed: () => viewer.ask(), lost: () => viewer.lost(), restored });
    viewer.camera.listen(canvas, () => viewer.ask(), () => {});
  }
  /// `room`: indices for which there is to be storage.
  take(lane, room) {
    const { scene } = this.pane;
    Object.assign(this, { lane, ribbon: null });
    scene.setPoints(lane.mesh.points);
    scene.reserve(room);
    scene.upload(lane.indices, [{ first: 0, count: lane.indices.length }]);
    this.#changed();
  }
  follow() {
    this.pane.scene.upload(this.lane.indices, this.lane.ranges);
    this.#changed();
  }
  #changed() {
    this.#stale = true;
    this.written = this.lane.written;
  }
  draw(strength) {
    const { lane, pane: { scene, camera, colors } } = this;
    if (scene.lost) return;
    if (this.#stale && !lane.isList) {
      this.ribbon = new Ribbon(lane.ribbon, this.ribbon);
      scene.paint(this.ribbon.vertices(lane.mesh.points));
    }
    this.#stale = false;
    scene.draw(camera, { style: lane.isList ? 'list' : 'strips', length: lane.indices.length, ...colors, glow: { triangles: this.written, strength } });
  }
}

export class Race {
  lanes = null;  // by their ways
  at = 0;  // the level of all of them
  tracks = null;  // the other's, and that of strips kept
  #counts = false;  // the lanes have come to the level from which on steps count
  #stepped = -Infinity;  // when the last step was
  #ahead = null;  // levels of a run that lie ahead

  constructor(viewer, by) {
    this.viewer = viewer;
    this.by = by;
    for (const id of ['race-policy', 'race-cost']) by(id).addEventListener('change', () => this.end());
    by('rival').addEventListener('change', () => {
      if (this.lanes) this.#take();
      viewer.ask();
    });
    by('run').addEventListener('click', () => (this.#ahead ? this.#stop() : this.run()));
    for (const [id, event] of [['level', 'input'], ['up', 'click'], ['down', 'click']]) by(id).addEventListener(event, () => this.#stop());
  }

  /// Makes the lanes; they go to the level of the page, and count from there.
  #begin() {
    const { viewer, by } = this;
    const { source, restrip } = viewer;
    const given = { policy: by('race-policy').value, cost: by('race-cost').value };
    this.lanes = Object.fromEntries(Object.keys(ways).map((way) => [way, new Lane(restrip, way, source, given)]));
    this.at = 0;
    this.pace = new Pace();
    this.#counts = false;
    this.tracks ??= ['rival', 'kept'].map((name) => new Track(by(`${name}-canvas`), viewer, () => {
      if (this.lanes) this.#take();
      viewer.found();
    }));
    this.#take();
  }
  #take() {
    [this.by('rival').value, 'kept'].forEach((way, n) => this.tracks[n].take(this.lanes[way], 3 * fineTriangles(this.viewer.source)));
  }
  /// Another mesh or another policy starts a new race.
  end() {
    for (const lane of Object.values(this.lanes ?? {})) lane.close();
    this.lanes = null;
    this.#stop();
    this.viewer.ask();
  }
  /// Up and back from the level of the page, or from as far below the finest one as the steps lead.
  run() {
    const { by, viewer } = this;
    const { levels } = viewer.mesh;
    const stride = Math.max(1, Math.floor(by('stride').value * levels));
    const from = Math.max(0, Math.min(viewer.level, levels - runSteps * stride));
    const up = [];
    while (up.length < runSteps && from + (up.length + 1) * stride <= levels) up.push(from + (up.length + 1) * stride);
    this.#ahead = [...up, ...up.slice(0, -1).reverse(), from];
    this.#counts = false;
    by('run').textContent = 'Stop';
    viewer.moveTo(from);
  }
  #stop() {
    this.#ahead = null;
    this.by('run').textContent = 'Run';
  }

  /// Nothing is left to be done.
  get settled() { return this.lanes !== null && this.at === this.viewer.level && this.#ahead === null; }
  /// One step of every lane, by at most so many operations.
  step(level, most = Infinity) {
    let [done, moving] = [0, 0];
    for (const lane of Object.values(this.lanes)) {
      done = lane.step(level, most);
      moving += lane.last.moving;
    }
    this.pace.learn(done, most, moving);
    this.at += level > this.at ? done : -done;
    for (const track of this.tracks) track.follow();
  }
  #goOn() {
    const { viewer } = this;
    if (this.at !== viewer.level) this.step(viewer.level, this.pace.most);
    if (this.at !== viewer.level) return;
    if (!this.#counts) for (const lane of Object.values(this.lanes)) lane.startHere();
    this.#counts = true;
    if (!this.#ahead) return;
    if (this.#ahead.length === 0) this.#stop();
    else viewer.moveTo(this.#ahead.shift());
  }
  /// Steps and draws; whether there is more to come.
  frame(now) {
    const { viewer } = this;
    if (!this.lanes) this.#begin();
    const before = this.at;
    // Where nothing may move by itself, a run is seen at its end.
    const until = performance.now() + (viewer.moves ? 0 : 40);
    do this.#goOn(); while (this.#ahead && performance.now() < until);
    if (this.at !== before) this.#stepped = now;
    const strength = this.lanes.kept.total.steps === 0 ? 0 : viewer.moves ? Math.max(0, 1 - (now - this.#stepped) / litFor) : 1;
    if (viewer.moves || !this.#ahead) for (const track of this.tracks) track.draw(strength);
    this.#tell();
    return !this.settled || (viewer.moves && strength > 0);
  }

  // ---- what is said
  #tell() {
    const { by, viewer, lanes } = this;
    showLevel(by, this.at, viewer.mesh.levels, viewer.level);
    const rows = Object.values(lanes).map(({ way, last, total, strips, indices }) => ({ name: ways[way], cells: [
      [last.bytes, asKilobytes(last.bytes)], [total.bytes, asKilobytes(total.bytes)],
      // The clock of a page may tick every tenth of a millisecond.
      total.steps >= 10 ? [total.milliseconds, asNumber(Math.round(1000 * total.milliseconds / total.steps))] : [Infinity, '–'],
      strips > 0 ? [strips, asNumber(strips)] : [Infinity, '–'], [indices.length, asNumber(indices.length)]] }));
    const least = rows[0].cells.map((_, c) => Math.min(...rows.map(({ cells }) => cells[c][0])));
    by('lanes').innerHTML = rows.map(({ name, cells }) =>
      `<tr><th scope="row">${name}</th>${cells.map(([n, text], c) => `<td${n === least[c] && n > 0 && n < Infinity ? ' class="least"' : ''}>${text}</td>`).join('')}</tr>`).join('');
    for (const [n, name] of ['rival', 'kept'].entries()) {
      const { way, total } = this.tracks[n].lane;
      by(`${name}-text`).textContent = `${ways[way]}: ${asKilobytes(total.bytes)} kB`;
    }
    const share = (part, all) => `${Math.round(100 * part / all)} %`;
    const { kept, scratch, whole, slots } = lanes;
    by('race-text').textContent = kept.total.steps === 0 ? 'Move the level, or let it run. What a step writes is lit.'
      : `Strips kept have written ${share(kept.total.bytes, scratch.total.bytes)} of the bytes of strips from scratch, and draw ` +
        `${share(kept.indices.length, whole.indices.length)} of the indices of a list.`;
    by('slots-text').textContent = kept.total.steps === 0 ? '' :
      `The list with slots has written ${share(slots.total.bytes, kept.total.bytes)} of the bytes of strips kept.`;
  }
}

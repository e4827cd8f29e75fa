// One vertex split, shown in steps: the patch before, the patch with its two new triangles and the strips that they cut,
// and the patch as repaired by the rule; on the mesh and as adjacent drawings, in the same colours.
import { none } from '../../bindings/js/restrip.mjs';
import { cross, unit } from './camera.mjs';
import { bitsIn } from './judge.mjs';
import { largestPuzzle } from './puzzles.mjs';
import { fanPicture, listed, representative, ringPicture, ruleName } from './patch.mjs';

/// Milliseconds from the click on, at which the new triangles begin to open, are open, and the rule has been applied.
const opensAt = 700;
const openAt = 1700;
const mendedAt = 3200;

const minus = (a, b) => a.map((c, n) => c - b[n]);

export const cornersOf = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.subarray(3 * i, 3 * i + 3)]);

/// The triangles of a split's patch in the order of its drawing: t_0 to t_{k-1}, then A and D. Null where the patch is not a closed
/// fan. With them the vertex that was split and the new one.
export function facesOf({ kind, closed, k, a, trianglesBefore, trianglesAfter }) {
  if (kind !== 'split' || !closed) return null;
  const [before, after] = [cornersOf(trianglesBefore), cornersOf(trianglesAfter)];
  const vS = before[0].find((v) => before.every((corners) => corners.includes(v)) && after.some((corners) => corners.includes(v)));
  const old = new Set(before.flat());
  const vT = after.flat().find((v) => !old.has(v));
  // In a triangle's order the centre is followed by the rim, from its right to its left.
  const rim = before.map((corners) => corners[(corners.indexOf(vS) + 1) % 3]);
  const next = (i) => rim[(i + 1) % k];
  const find = (...wanted) => after.find((corners) => wanted.every((v) => corners.includes(v)));
  const faces = rim.map((v, i) => find(v, next(i)));
  return { vS, vT, before, after: [...faces, find(vS, vT, rim[0]), find(vS, vT, rim[a])] };
}

/// From where a camera sees triangles, the last two of them above all: the place, and how many of all it sees.
export function placeToSee(mesh, camera, faces, aspect) {
  const point = (v) => [...mesh.points.subarray(3 * v, 3 * v + 3)];
  const centers = faces.map((corners) => corners.map(point).reduce((sum, p) => sum.map((c, n) => c + p[n] / 3), [0, 0, 0]));
  const fresh = centers.slice(-2);
  const target = fresh[0].map((c, n) => (c + fresh[1][n]) / 2);
  const radius = Math.max(...faces.flat().map((v) => Math.hypot(...minus(point(v), target))));
  const normal = unit(faces.map((corners) => {
    const [p, q, r] = corners.map(point);
    return unit(cross(minus(q, p), minus(r, p)));
  }).reduce((sum, each) => sum.map((c, n) => c + each[n]), [0, 0, 0]));
  const side = unit(cross(normal, Math.abs(normal[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
  const up = cross(side, normal);
  let best = { seen: -1 };
  const until = performance.now() + 60;  // on a large mesh each look takes milliseconds
  for (const near of [1, 0.6, 0.35]) {
    const distance = Math.max(0.06 * camera.size, near * 2.4 * radius / Math.sin(camera.fov / 2) / Math.min(1, aspect));
    for (const [tilt, turns] of [[0, 1], [0.5, 6], [1, 6]]) {
      for (let turn = 0; turn < turns; ++turn) {
        const angle = turn * Math.PI / 3;
        const along = unit(normal.map((c, n) => c + tilt * (Math.cos(angle) * side[n] + Math.sin(angle) * up[n])));
        const pitch = Math.asin(Math.max(-1, Math.min(1, along[1])));
        if (Math.abs(pitch) > 1.45) continue;
        const eye = target.map((c, n) => c + distance * along[n]);
        const visible = (center) => {
          const hit = mesh.pick(eye, minus(center, eye));
          return hit !== null && Math.hypot(...minus(hit, center)) < 1e-3 * camera.size;
        };
        const seen = 100 * fresh.filter(visible).length + centers.filter(visible).length;
        if (seen > best.seen) best = { seen, place: { yaw: Math.atan2(along[0], along[2]), pitch, distance, target } };
        if (seen === 200 + centers.length || performance.now() > until) return best;
      }
    }
    if (best.seen >= 200) return best;
  }
  return best;
}

const plural = (n, what) => `${n} ${what}${n === 1 ? '' : 's'}`;
const names = { before: '1 Before', cut: '2 Cut', mended: '3 Mended' };

export class Cut {
  step = 'mended';
  shown = null;  // what is shown: by step its ribbon, the colours of its drawing and the triangles of the patch
  #started = null;
  #found = {};  // the records that can be split, after how many operations of which mesh

  constructor(viewer, by) {
    this.viewer = viewer;
    this.by = by;
    by('steps').addEventListener('click', ({ target }) => target.closest('button') && this.show(target.closest('button').value));
    by('anywhere').addEventListener('click', () => this.anywhere());
    by('whole').addEventListener('click', () => this.viewer.afresh());
  }

  // ---- where
  /// Splits the vertex that is nearest to what a ray meets, among those that can be split. False: it meets nothing.
  click({ from, along }) {
    const { mesh, splits } = this.viewer;
    const hit = this.viewer.resting ? mesh.pick(from, along) : null;
    if (!hit) return false;
    const { points } = mesh;
    let [best, least] = [null, Infinity];
    for (const record of this.ready) {
      const v = 3 * splits[4 * record];
      const far = Math.hypot(points[v] - hit[0], points[v + 1] - hit[1], points[v + 2] - hit[2]);
      if (far < least) [best, least] = [record, far];
    }
    if (best === null) return false;
    this.viewer.splitRecord(best);
    return true;
  }
  /// The records that can be split and drawn: boundary splits have no drawing.
  get ready() {
    const { mesh, splits, figures: { operations } } = this.viewer;
    if (this.#found.mesh !== mesh || this.#found.operations !== operations) {
      const records = [...mesh.ready].filter((record) => splits[4 * record + 2] !== none && splits[4 * record + 3] !== none);
      this.#found = { mesh, operations, records, places: Uint32Array.from(records, (record) => splits[4 * record]) };
    }
    return this.#found.records;
  }
  /// The vertices that can be split, while they are to be seen.
  get places() {
    return this.viewer.resting && (!this.shown || this.step === 'mended') && this.ready.length > 0 ? this.#found.places : null;
  }
  /// At a place that turns with each call.
  anywhere() {
    if (this.viewer.resting && this.ready.length > 0) this.viewer.splitRecord(this.ready[this.viewer.clicks.length * 7919 % this.ready.length]);
  }

  // ---- drawing
  /// After a split; ribbons before and after it.
  begin(before, after) {
    const faces = facesOf(this.viewer.mesh.last);
    this.shown = null;
    if (!faces) return;
    const shown = (ribbon, each) => {
      const places = each.map((corners) => ribbon.find(corners));
      return { ribbon, fills: places.map((i) => ribbon.fill(i)), only: new Set(places.map((i) => ribbon.triangle(i))) };
    };
    this.shown = { vS: faces.vS, vT: faces.vT, before: shown(before, faces.before), cut: shown(after.cutOf(before), faces.after), mended: shown(after, faces.after) };
    const canvas = this.by('canvas');
    const { place } = placeToSee(this.viewer.mesh, this.viewer.camera, faces.after, canvas.width / canvas.height);
    const still = !this.viewer.moves;
    this.#started = performance.now();
    if (place) this.viewer.camera.fly(place, still ? 0 : opensAt, this.#started);
    this.describe();
    this.#go(still ? 'cut' : 'before');
  }
  end() {
    this.shown = null;
    this.#started = null;
    this.step = 'mended';
    this.describe();
  }
  show(step) {
    this.#started = null;
    this.#go(step);
  }
  #go(step) {
    this.step = step;
    for (const button of this.by('steps').querySelectorAll('button')) button.setAttribute('aria-pressed', String(button.value === step));
    this.viewer.ask();
  }
  /// Whether the steps continue by themselves after this.
  advance(now) {
    if (this.#started === null) return false;
    const passed = now - this.#started;
    const step = passed < opensAt && this.viewer.moves ? 'before' : passed < mendedAt ? 'cut' : 'mended';
    if (step !== this.step) this.#go(step);
    if (step === 'mended') this.#started = null;
    return this.#started !== null;
  }
  /// The ribbon to paint and its patch, and where its points are, other than in the mesh.
  seen(now) {
    if (!this.shown) return null;
    const { ribbon, only } = this.shown[this.step];
    if (this.step !== 'cut') return { name: this.step, ribbon, only };
    const { vS, vT } = this.shown;
    const { points } = this.viewer.mesh;
    const share = this.#started === null || !this.viewer.moves ? 1 : Math.max(0, Math.min(1, (now - this.#started - opensAt) / (openAt - opensAt)));
    const [from, to] = [vS, vT].map((v) => points.subarray(3 * v, 3 * v + 3));
    return { name: `cut ${share}`, ribbon, only, moved: new Map([[vT, [0, 1, 2].map((n) => from[n] + (to[n] - from[n]) * share)]]) };
  }

  // ---- text
  /// Describes the split that is shown, if any.
  describe() {
    const { by, viewer, shown } = this;
    const last = shown ? viewer.mesh.last : null;
    by('take').disabled = !(last?.k <= largestPuzzle);
    by('last-text').textContent = '';
    by('steps').replaceChildren();
    if (!last) return;
    const { k, a, ports } = last;
    const colors = { before: last.before, cut: cutColors(k, a, last.before), mended: last.after };
    by('steps').innerHTML = Object.entries(colors).map(([step, edges]) => {
      const draw = step === 'before' ? fanPicture : ringPicture;
      const strips = (step === 'before' ? k : k + 2) - bitsIn(edges);
      const picture = draw(k, a, edges, step === 'mended' ? last.portsAfter : ports, step, { fills: shown[step].fills });
      return `<button value="${step}" aria-pressed="false">${picture}<span>${names[step]}</span><span>${plural(strips, 'strip')}</span></button>`;
    }).join('');
    const rule = viewer.restrip.rule({ family: 'split', k, a, edges: last.before, ports }).colors;
    by('last-text').innerHTML = `A vertex with k = ${k} triangles. ` + (rule === last.after ? `Repaired by its rule${nameOf(last)}.`
      : `Its rule${nameOf(last)} leaves ${plural(k + 2 - bitsIn(rule), 'strip')} in the patch; the policy then searched further.`);
  }
}

/// The inner edges after a split that leaves all others as they were: the new triangles join nothing.
export function cutColors(k, a, loop) {
  let inner = 0n;
  const solid = BigInt(loop);
  for (let i = 0; i < k; ++i) {
    if (i === a - 1 || i === k - 1 || (solid >> BigInt(i) & 1n) === 0n) continue;
    inner |= 1n << BigInt(i < a ? i + 1 : i + 2);
  }
  return inner;
}

/// A link to the rule of a split that the atlas has.
function nameOf({ kind, k, a, before, ports }) {
  if (kind !== 'split' || k > 8) return '';
  const seen = listed(k, a, before, ports);
  const key = representative(k, seen.a, seen.loop, seen.ports);
  const id = ruleName(k, seen.a, key);
  return ` <a href="atlas/split-${k}-${seen.a}.html#${id}">${id}</a>`;
}

// One vertex split, shown in steps: the patch before, the patch with its two new triangles and the strips that they cut,
// and the patch as the rule mended it; on the mesh and as drawings that point at each other.
import { none } from '../js/restrip.mjs';
import { cross, unit } from './camera.mjs';
import { largestPuzzle } from './puzzles.mjs';
import { fanPicture, listed, representative, ringPicture, ruleName } from './patch.mjs';

/// Milliseconds from the click on, at which the new triangles begin to open, are open, and the rule has mended.
const opensAt = 700;
const openAt = 1700;
const mendedAt = 3200;

const minus = (a, b) => a.map((c, n) => c - b[n]);

export const cornersOf = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.subarray(3 * i, 3 * i + 3)]);

/// The triangles of a split's patch in the order of its drawing: t_0 to t_{k-1}, then A and D. Null where the patch is no closed
/// fan. With them the vertex that was split and the new one.
export function facesOf({ kind, closed, k, a, trianglesBefore, trianglesAfter }) {
  if (kind !== 'split' || !closed) return null;
  const [before, after] = [cornersOf(trianglesBefore), cornersOf(trianglesAfter)];
  const vS = before[0].find((v) => before.every((corners) => corners.includes(v)) && after.some((corners) => corners.includes(v)));
  const old = new Set(before.flat());
  const vT = after.flat().find((v) => !old.has(v));
  // Behind the centre in a triangle's order comes the rim, from its right to its left.
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
        if (seen === 200 + centers.length) return best;
      }
    }
    if (best.seen >= 200) return best;
  }
  return best;
}

const plural = (n, what) => `${n} ${what}${n === 1 ? '' : 's'}`;

export class Cut {
  step = 'mended';
  shown = null;  // what is shown: ribbons before, cut and after; the faces of the drawing
  #started = null;

  constructor(viewer, by) {
    this.viewer = viewer;
    this.by = by;
    for (const button of by('steps').querySelectorAll('button')) button.addEventListener('click', () => this.show(button.value));
    by('anywhere').addEventListener('click', () => this.anywhere());
    by('whole').addEventListener('click', () => this.viewer.afresh());
    const point = (event) => this.#pointAt(event.target.dataset?.face ?? null);
    for (const name of ['pointerover', 'focusin']) by('last-pictures').addEventListener(name, point);
    for (const name of ['pointerleave', 'focusout']) by('last-pictures').addEventListener(name, () => this.#pointAt(null));
  }

  // ---- where
  /// Splits the vertex that is nearest to what a ray meets, among those that can be split. False: it meets nothing.
  click({ from, along }) {
    const { mesh } = this.viewer;
    this.viewer.arrive();
    const hit = mesh.pick(from, along);
    if (!hit) return false;
    const { points } = mesh;
    const { splits } = this.viewer;
    let [best, least] = [null, Infinity];
    for (const record of this.#ready()) {
      const v = 3 * splits[4 * record];
      const far = Math.hypot(points[v] - hit[0], points[v + 1] - hit[1], points[v + 2] - hit[2]);
      if (far < least) [best, least] = [record, far];
    }
    if (best === null) return false;
    this.viewer.splitRecord(best);
    return true;
  }
  /// The records that can be split and drawn: those at the boundary have no drawing.
  #ready() {
    const { mesh, splits } = this.viewer;
    return [...mesh.ready].filter((record) => splits[4 * record + 2] !== none && splits[4 * record + 3] !== none);
  }
  /// At a place that turns with each call.
  anywhere() {
    this.viewer.arrive();
    const ready = this.#ready();
    if (ready.length > 0) this.viewer.splitRecord(ready[this.viewer.clicks.length * 7919 % ready.length]);
  }

  // ---- what is seen
  /// After a split; `before`: the ribbon before it.
  begin(before, after) {
    const faces = facesOf(this.viewer.mesh.last);
    this.shown = faces && { before, after, cut: after.cutOf(before), faces };
    if (!faces) return;
    const canvas = this.by('canvas');
    const { place } = placeToSee(this.viewer.mesh, this.viewer.camera, faces.after, canvas.width / canvas.height);
    const still = !this.viewer.moves;
    this.#started = performance.now();
    if (place) this.viewer.camera.fly(place, still ? 0 : opensAt, this.#started);
    this.#go(still ? 'cut' : 'before');
  }
  end() {
    this.shown = null;
    this.#started = null;
    this.step = 'mended';
  }
  show(step) {
    this.#started = null;
    this.#go(step);
  }
  #go(step) {
    this.step = step;
    this.viewer.painted = null;
    this.#mark();
    this.viewer.ask();
  }
  #mark() {
    for (const button of this.by('steps').querySelectorAll('button')) {
      button.disabled = !this.shown;
      button.setAttribute('aria-pressed', String(Boolean(this.shown) && button.value === this.step));
    }
  }
  /// Whether the steps go on by themselves after this.
  advance(now) {
    if (this.#started === null) return false;
    const passed = now - this.#started;
    const step = passed < opensAt && this.viewer.moves ? 'before' : passed < mendedAt ? 'cut' : 'mended';
    if (step !== this.step) this.#go(step);
    if (step === 'cut' && passed < openAt + 100 && this.viewer.moves) this.viewer.painted = null;
    if (step === 'mended') this.#started = null;
    return this.#started !== null;
  }
  /// The ribbon to paint, and where its points are, other than in the mesh.
  seen(now) {
    if (!this.shown || this.step === 'mended') return null;
    if (this.step === 'before') return { ribbon: this.shown.before, moved: new Map() };
    const { vS, vT } = this.shown.faces;
    const { points } = this.viewer.mesh;
    const share = this.#started === null || !this.viewer.moves ? 1 : Math.max(0, Math.min(1, (now - this.#started - opensAt) / (openAt - opensAt)));
    const [from, to] = [vS, vT].map((v) => points.subarray(3 * v, 3 * v + 3));
    return { ribbon: this.shown.cut, moved: new Map([[vT, [0, 1, 2].map((n) => from[n] + (to[n] - from[n]) * share)]]) };
  }

  // ---- drawings that point at the mesh, and back
  #pointAt(face) {
    const faces = this.shown?.faces;
    const step = this.step === 'before' ? faces?.before : faces?.after;
    this.point(face === null || !step?.[face] ? null : +face, step);
  }
  point(face, step) {
    this.viewer.pointed = face === null ? null : new Uint32Array(step[face]);
    for (const element of this.by('last-pictures').querySelectorAll('[data-face]')) element.classList.toggle('lit', +element.dataset.face === face);
    this.viewer.ask();
  }
  /// The face of the drawing over which a ray meets the mesh.
  pointFrom({ from, along }) {
    const faces = this.shown?.faces;
    if (!faces) return;
    const { mesh } = this.viewer;
    const hit = mesh.pick(from, along);
    const step = this.step === 'before' ? faces.before : faces.after;
    const within = ([a, b, c]) => {
      const [p, q, r] = [a, b, c].map((v) => mesh.points.subarray(3 * v, 3 * v + 3)).map((place) => minus([...place], hit));
      const all = Math.hypot(...cross(minus(q, p), minus(r, p)));
      const parts = [[p, q], [q, r], [r, p]].reduce((sum, [u, v]) => sum + Math.hypot(...cross(u, v)), 0);
      return parts < 1.001 * all;
    };
    const face = hit ? step.findIndex(within) : -1;
    this.point(face < 0 ? null : face, step);
  }

  // ---- what is said
  /// Of the last operation, which was `one` or the last of several.
  tell() {
    const { by, viewer } = this;
    const last = viewer.figures.operations > 0 ? viewer.mesh.last : null;
    this.#mark();
    by('take').disabled = !(last?.kind === 'split' && last.closed && last.k <= largestPuzzle);
    if (!last) {
      by('last-text').textContent = 'None yet.';
      by('last-pictures').replaceChildren();
      return;
    }
    const change = last.strips === 0 ? 'the number of strips is the same' :
      `${plural(Math.abs(last.strips), 'strip')} ${last.strips > 0 ? 'more' : 'fewer'}`;
    const what = { split: 'Vertex split', collapse: 'Edge collapse', flip: 'Edge flip' }[last.kind];
    if (!last.closed) {
      by('last-text').textContent = `${what} at the boundary of the mesh: ${change}.`;
      by('last-pictures').replaceChildren();
      return;
    }
    const { k, a, ports } = last;
    const place = `${what}, a vertex of ${k} triangles (k = ${k}, a = ${a}): ${change}.`;
    // A split leads from a fan to a ring with chord, a collapse back.
    const splits = last.kind === 'split';
    const [from, to] = splits ? [fanPicture, ringPicture] : [ringPicture, fanPicture];
    const pictures = [[from(k, a, last.before, ports, 'before', { faces: splits }), 'before']];
    const { colors } = viewer.restrip.rule({ family: last.kind, k, a, edges: last.before, ports });
    const asRule = colors === last.after && last.portsAfter === ports;
    if (splits) pictures.push([ringPicture(k, a, cutColors(k, a, last.before), ports, 'cut', { faces: true }), 'cut']);
    if (viewer.figures.baked) {
      by('last-text').textContent = `${place} No rule was looked up: restrip bake decided these strips beforehand, with long searches.`;
    } else if (by('cost').value === 'indices' && by('policy').value !== 'baked') {
      by('last-text').textContent = `${place} To keep indices low no rule is looked up: the new triangles continue the strips ` +
        'on which they land, and small changes follow as long as they save indices.';
    } else {
      const rule = `rule${nameOf(last)}`;
      by('last-text').innerHTML = asRule ? `${place} That is its ${rule}.`
        : `${place} Its ${rule} keeps the ports; the policy then changed colours further.`;
      if (!asRule) pictures.push([to(k, a, colors, ports, 'after the rule', { faces: splits }), 'the rule']);
    }
    pictures.push([to(k, a, last.after, last.portsAfter, 'after', { faces: splits }), splits ? 'mended' : 'after']);
    by('last-pictures').innerHTML = pictures.map(([svg, caption]) => `<figure>${svg}<figcaption>${caption}</figcaption></figure>`).join('');
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

// A mesh as ribbons: which strip each triangle is part of, how far along it lies, and where neighbours do not join. A
// strip keeps its colour while it changes: it inherits the name of the strip with which it shares most triangles.
import { none } from '../../bindings/js/restrip.mjs';

const perTriangle = 9;  // numbers of a triangle in StripMesh.ribbon
/// All hues but the ones near the colour of new triangles; the first is blue.
const hueOf = (name) => (0.17 + 0.9 * ((0.456 + name * 0.618033988749895) % 1)) % 1;
const apart = (g, h) => Math.min(Math.abs(g - h), 1 - Math.abs(g - h));

/// A colour by hue, saturation and lightness, as the bytes of an integer.
function colorOf(hue, saturation, lightness) {
  const strength = saturation * Math.min(lightness, 1 - lightness);
  const channel = (n) => {
    const k = (n + hue * 12) % 12;
    return Math.round(255 * (lightness - strength * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return channel(4) << 16 | channel(8) << 8 | channel(0);
}
/// Whether a corner is at an end of a side.
const isEnd = (corner, side) => side >= 0 && (corner === side || corner === (side + 1) % 3);
const fresh = colorOf(0.12, 1, 0.56);  // new triangles, which are not part of a strip yet

export class Ribbon {
  /// `data`: StripMesh.ribbon. `before`: the ribbon whose colours continue.
  constructor(data, before = null) {
    this.data = data;
    this.count = data.length / perTriangle;
    this.strips = [];  // { first, count, name }
    let bound = 0;
    for (let i = 0; i < data.length; i += perTriangle) bound = Math.max(bound, data[i] + 1);
    this.place = new Int32Array(bound).fill(-1);  // by triangle: where it is in the data
    this.names = new Int32Array(bound).fill(-1);  // by triangle: the name of its strip
    for (let i = 0; i < this.count; ++i) {
      this.place[data[perTriangle * i]] = i;
      const strip = data[perTriangle * i + 8];
      if (this.strips.at(-1)?.strip !== strip) this.strips.push({ strip, first: i, count: 0, name: -1 });
      ++this.strips.at(-1).count;
    }
    this.next = before?.next ?? 0;
    if (before) this.#inherit(before);
    for (const strip of this.strips) {
      if (strip.name < 0) strip.name = this.#newName(strip);
      for (let i = strip.first; i < strip.first + strip.count; ++i) this.names[data[perTriangle * i]] = strip.name;
    }
  }
  triangle(i) { return this.data[perTriangle * i]; }
  corners(i) { return this.data.subarray(perTriangle * i + 1, perTriangle * i + 4); }
  /// Where a triangle with these corners is in the data; -1: nowhere.
  find(corners) {
    for (let i = 0; i < this.count; ++i) if (this.corners(i).every((v) => corners.includes(v))) return i;
    return -1;
  }
  beyond(i, side) { return this.data[perTriangle * i + 4 + side]; }
  joined(i, side) { return (this.data[perTriangle * i + 7] >> side & 1) === 1; }

  #inherit(before) {
    const shared = [];
    for (const strip of this.strips) {
      const counts = new Map();
      for (let i = strip.first; i < strip.first + strip.count; ++i) {
        const name = before.names[this.triangle(i)] ?? -1;
        if (name >= 0) counts.set(name, (counts.get(name) ?? 0) + 1);
      }
      for (const [name, count] of counts) shared.push({ strip, name, count });
    }
    shared.sort((a, b) => b.count - a.count || a.strip.first - b.strip.first);
    const taken = new Set();
    for (const { strip, name } of shared) {
      if (strip.name >= 0 || taken.has(name)) continue;
      strip.name = name;
      taken.add(name);
    }
  }
  /// Of the next few names, the one whose colour differs most from the neighbours' colours.
  #newName(strip) {
    const near = new Set();
    for (let i = strip.first; i < strip.first + strip.count; ++i)
      for (let side = 0; side < 3; ++side) {
        const other = this.beyond(i, side);
        if (other === none) continue;
        const name = this.names[other] >= 0 ? this.names[other] : this.#stripAt(this.place[other]).name;
        if (name >= 0) near.add(name);
      }
    let best = this.next;
    let most = -1;
    for (let name = this.next; near.size > 0 && name < this.next + 8; ++name) {
      const least = Math.min(...[...near].map((other) => apart(hueOf(name), hueOf(other))));
      if (least > most) [best, most] = [name, least];
    }
    this.next = best + 1;
    return best;
  }
  #stripAt(i) {
    let [low, high] = [0, this.strips.length];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.strips[middle].first <= i) low = middle;
      else high = middle;
    }
    return this.strips[low];
  }

  /// A triangle's colour: the hue of its strip, which grows lighter along it. A strip over much of the mesh takes more of
  /// the range from dark to light, so that its passes differ where they lie side by side.
  color(strip, i) {
    if (strip.name < 0) return fresh;
    const along = strip.count > 1 ? (i - strip.first) / (strip.count - 1) : 0.5;
    const share = strip.count / this.count;
    const dark = 0.45 - 0.17 * share;
    return colorOf(hueOf(strip.name), 0.62 + 0.13 * share, dark + (0.3 + 0.2 * share) * along);
  }
  /// The same of the triangle at i, as a drawing has it.
  fill(i) {
    const color = this.color(this.#stripAt(i), i);
    return `rgb(${color & 255} ${color >> 8 & 255} ${color >> 16})`;
  }
  /// Corners for the graphics card, six numbers each: a point; red, green and blue, with a bit for each side that is a wall and one
  /// for each side at the rim of `only`; how far along its strip it lies, and how long that is. `moved`: points that are elsewhere;
  /// `only`: triangles to be distinguished from all others.
  vertices(points, { moved = null, only = null } = {}) {
    const { data } = this;
    const out = new Float32Array(18 * this.count);
    const words = new Uint32Array(out.buffer);
    for (const strip of this.strips) {
      const end = strip.first + strip.count;
      for (let i = strip.first; i < end; ++i) {
        const at = perTriangle * i;
        let word = this.color(strip, i) | (~data[at + 7] & 7) << 24;
        if (only && !only.has(data[at])) word = (word & 0xfcfcfc) / 4 + 0x949494 | word & 0xff000000;
        else for (let side = 0; only && side < 3; ++side) if (!only.has(data[at + 4 + side])) word |= 8 << 24 + side;
        const [enters, leaves] = [i > strip.first ? this.#sideTo(i, i - 1) : -1, i + 1 < end ? this.#sideTo(i, i + 1) : -1];
        for (let corner = 0; corner < 3; ++corner) {
          const v = data[at + 1 + corner];
          const to = 18 * i + 6 * corner;
          const place = moved?.get(v);
          for (let n = 0; n < 3; ++n) out[to + n] = place ? place[n] : points[3 * v + n];
          words[to + 3] = word;
          // Behind at the side where the strip comes in, ahead at the one where it continues.
          out[to + 4] = i - strip.first + (isEnd(corner, leaves) ? 0.5 : 0) - (isEnd(corner, enters) ? 0.5 : 0);
          out[to + 5] = strip.count;
        }
      }
    }
    return out;
  }
  /// The side by which triangle i joins the one at `other`; -1: none.
  #sideTo(i, other) {
    const { data } = this;
    const wanted = data[perTriangle * other];
    for (let side = 0; side < 3; ++side)
      if (data[perTriangle * i + 4 + side] === wanted && (data[perTriangle * i + 7] >> side & 1) === 1) return side;
    return -1;
  }

  /// The strips as flat bands, one after the other, broken into rows that fill a window: for each corner its place, both from -1 to 1,
  /// and how much of all lies before it, from 0 to 1. A triangle that turns left has its new corner below, one that turns right above.
  flat(aspect) {
    const { data } = this;
    const out = new Float32Array(9 * this.count);
    const all = this.strips.reduce((sum, { count }) => sum + count / 2 + 1.5, 0);
    const rows = Math.max(1, Math.round(Math.sqrt(all / (1.3 * aspect))));
    const wide = all / rows + 1;
    const unit = 1.7 / Math.max(wide, 1.3 * rows * aspect);  // of the window's width
    let begin = 0;
    for (const { first, count } of this.strips) {
      let places = new Map();  // of the corners of the last triangle
      for (let i = first; i < first + count; ++i) {
        const enters = i > first ? this.#sideTo(i, i - 1) : -1;
        const leaves = i + 1 < first + count ? this.#sideTo(i, i + 1) : -1;
        const corners = data.subarray(perTriangle * i + 1, perTriangle * i + 4);
        const x = begin + (i - first) / 2;
        const now = new Map();
        if (enters < 0) {
          const apex = leaves < 0 ? 0 : (leaves + 2) % 3;
          [[0, 0], [1, 0], [0.5, 1]].forEach(([dx, y], n) => now.set(corners[(apex + n) % 3], [x + dx, y]));
        } else {
          const [u, v, next] = [0, 1, 2].map((n) => corners[(enters + n) % 3]);
          const keeps = leaves < 0 || isEnd((enters + 1) % 3, leaves) ? v : u;  // of the side where it comes in
          now.set(u, places.get(u)).set(v, places.get(v)).set(next, [x + 1, 1 - places.get(keeps)[1]]);
        }
        const row = Math.min(rows - 1, Math.floor(x / (wide - 1)));
        for (let corner = 0; corner < 3; ++corner) {
          const [px, py] = now.get(corners[corner]);
          const across = (px - row * (wide - 1) - wide / 2) * unit;
          const down = (1.3 * (row - rows / 2) + 0.65 - (py - 0.5) * 0.87) * unit * aspect;
          out.set([across, -down, px / all], 9 * i + 3 * corner);
        }
        places = now;
      }
      begin += count / 2 + 1.5;
    }
    return out;
  }

  /// The triangles of this ribbon, joined as they were in `before`: the state after a split, before the rule.
  cutOf(before) {
    const data = this.data.slice();
    for (let i = 0; i < this.count; ++i) {
      const was = before.place[this.triangle(i)] ?? -1;
      let joined = 0;
      for (let side = 0; side < 3 && was >= 0; ++side)
        for (let old = 0; old < 3; ++old)
          if (before.beyond(was, old) === this.beyond(i, side) && before.joined(was, old)) joined |= 1 << side;
      data[perTriangle * i + 7] = joined;
      data[perTriangle * i + 8] = i;
    }
    const cut = new Ribbon(data);
    // Each triangle by itself, in the colour that it had.
    cut.color = (_, i) => {
      const was = before.place[this.triangle(i)] ?? -1;
      return was < 0 ? fresh : before.color(before.#stripAt(was), was);
    };
    return cut;
  }
}

/// More triangles are not painted in one frame, and not at all while the mesh moves.
const atOnce = 16000;

/// The ribbon of a mesh on a scene.
export class Painter {
  ribbon = null;
  painted = false;  // the scene has it
  #fresh = false;  // it is of the mesh as it is
  #vertices = null;
  #flat = null;  // the shape of the window for which the scene has the flat bands

  constructor(scene) { this.scene = scene; }
  /// The mesh has changed.
  stale() {
    this.#fresh = false;
    this.repaint();
  }
  /// The scene has another picture.
  repaint() {
    this.painted = false;
    this.#vertices = this.#flat = null;
  }
  /// `data`: gives StripMesh.ribbon.
  read(data) {
    if (!this.#fresh) this.ribbon = new Ribbon(data(), this.ribbon);
    this.#fresh = true;
    return this.ribbon;
  }
  /// Paints as much as fits into a frame; returns how many parts are left. `resting`: the mesh does not move; `whole`: all at once.
  paint(data, points, resting, whole = false) {
    for (let left = this.painted ? 0 : this.#vertices ? 1 : this.#fresh ? 2 : 3; ; --left) {
      if (left === 0) return 0;
      const many = (this.ribbon?.count ?? 0) > atOnce;
      if (left === 3 && many && !resting && !whole) return left;
      if (left === 3) this.read(data);
      else if (left === 2) this.#vertices = this.ribbon.vertices(points);
      else {
        this.scene.paint(this.#vertices);
        this.#vertices = null;
        this.painted = true;
      }
      if (!whole && this.ribbon.count > atOnce) return left - 1;
    }
  }
  /// The flat bands for a window, painted as well.
  flatten(aspect) {
    if (this.#flat === aspect) return;
    this.#flat = aspect;
    this.scene.flatten(this.ribbon.flat(aspect));
  }
}

// A mesh as ribbons: which strip each triangle is part of, how far along it lies, and where neighbours do not join. A
// strip keeps its colour while it changes: it inherits the name of the strip with which it shares most triangles.
import { none } from '../js/restrip.mjs';

const perTriangle = 9;  // numbers of a triangle in StripMesh.ribbon
const hueOf = (name) => name * 0.618033988749895 % 1;
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
const fresh = colorOf(0.12, 1, 0.56);  // triangles that have just come, and are of no strip yet

export class Ribbon {
  /// `data`: StripMesh.ribbon. `before`: the ribbon whose colours go on.
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
  /// One whose colour differs most from those of the neighbours, among the next few.
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

  /// A triangle's colour, by the strip and the share of it that lies before. One strip over the whole mesh goes through
  /// the hues; short ones have one hue each, and grow lighter.
  color(strip, i) {
    if (strip.name < 0) return fresh;
    const along = strip.count > 1 ? (i - strip.first) / (strip.count - 1) : 0.5;
    const share = strip.count / this.count;
    const hue = (hueOf(strip.name) + 0.75 * share * along) % 1;
    return colorOf(hue, 0.62, share > 0.3 ? 0.6 : 0.45 + 0.3 * along);
  }
  /// Corners for the graphics card, six numbers each: a point; red, green and blue, and a bit for each side that is a wall;
  /// how far along its strip it lies, and how long that is. `moved`: points that are elsewhere.
  vertices(points, moved = new Map()) {
    const out = new Float32Array(18 * this.count);
    const words = new Uint32Array(out.buffer);
    for (const strip of this.strips) {
      for (let i = strip.first; i < strip.first + strip.count; ++i) {
        const { data } = this;
        const word = (this.color(strip, i) | (~data[perTriangle * i + 7] & 7) << 24) >>> 0;
        const order = i - strip.first;
        const sides = [i - 1, i + 1].map((other) => this.#sideTo(i, other));
        for (let corner = 0; corner < 3; ++corner) {
          const v = data[perTriangle * i + 1 + corner];
          const at = 18 * i + 6 * corner;
          const place = moved.get(v);
          for (let n = 0; n < 3; ++n) out[at + n] = place ? place[n] : points[3 * v + n];
          words[at + 3] = word;
          // Behind at the side where the strip comes in, ahead at the one where it goes on.
          const [enters, leaves] = sides.map((side) => side >= 0 && (corner === side || corner === (side + 1) % 3));
          out[at + 4] = order + (leaves ? 0.5 : 0) - (enters ? 0.5 : 0);
          out[at + 5] = strip.count;
        }
      }
    }
    return out;
  }
  /// The side by which triangle i joins the one at `other`; -1: none.
  #sideTo(i, other) {
    if (other < 0 || other >= this.count) return -1;
    for (let side = 0; side < 3; ++side) if (this.joined(i, side) && this.beyond(i, side) === this.triangle(other)) return side;
    return -1;
  }

  /// The triangles of this ribbon, joined as they were in `before`: what a split leaves before anything is mended.
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

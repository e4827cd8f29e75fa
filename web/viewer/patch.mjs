// Patches of splits as pictures, and their keys; docs/reference/notation.md numbers their edges. The drawing is the
// same as in scripts/pictures.py.

export const middle = (...places) => [0, 1].map((n) => places.reduce((sum, p) => sum + p[n], 0) / places.length);
export const has = (mask, bit) => (BigInt(mask) >> BigInt(bit) & 1n) === 1n;

export function rimOf(k, a) {
  const step = 2 * Math.PI / k;
  const start = Math.PI / 2 + step * a / 2;
  const places = Array.from({ length: k }, (_, i) => [200 + 150 * Math.cos(start - step * i), 200 + 150 * Math.sin(start - step * i)]);
  return [...places, places[0]];
}

const written = (places, between = ' ') => places.map((p) => p.map((c) => c.toFixed(1)).join(',')).join(between);
/// From one place through another to a third, without a kink.
const curve = (from, through, to) => `M${written([from])}Q${written([through.map((c, n) => 2 * c - (from[n] + to[n]) / 2), to])}`;
const outline = (corners) => `M${written(corners, 'L')}z`;

export class Patch {
  faces = { old: '', new: '' };
  fills = '';
  strokes = { outside: '', dashed: '', solid: '', 'solid marked': '' };
  nodes = [];
  extra = '';
  add(a, b, c, style = 'old') {
    this.faces[style] += outline([a, b, c]);
    this.nodes.push(middle(a, b, c));
    return this.nodes.length - 1;
  }
  stroke(from, to, style) { this.strokes[style] += `M${written([from, to], 'L')}`; }
  join(i, j, across, style) {
    this.strokes[style] += curve(this.nodes[i], across, this.nodes[j]);
  }
  port(i, a, b, style) {
    const door = middle(a, b);
    const outside = door.map((d, n) => d + (d - this.nodes[i][n]) * 0.7);
    this.stroke(this.nodes[i], outside, style);
    return outside;
  }
  /// Two ports that are connected outside: an arc around the patch, the shorter way.
  outside(from, to) {
    const [[x, y], [u, v]] = [from, to].map((end) => end.map((c) => c - 200));
    const beyond = [[x, y], [u, v]].map((end) => end.map((c) => 200 + c * 190 / Math.hypot(...end)));
    this.strokes.outside += `M${written([from, beyond[0]], 'L')}A190,190 0 0 ${x * v - y * u < 0 ? 0 : 1} ${written([beyond[1], to], 'L')}`;
  }
  /// An edge that can be clicked, and names itself.
  hit(edge, label, solid, points) {
    this.extra += `<polyline class="hit" tabindex="0" role="button" aria-pressed="${solid}" aria-label="${label}" data-edge="${edge}" points="${written(points)}"/>`;
  }
  /// A coloured triangle.
  fill(color, corners) { this.fills += `<path class="old" style="fill:${color}" d="${outline(corners)}"/>`; }
  /// The names of a triangle and of a port, as in verify/explain/commands.cpp.
  name([x, y], text, radius) {
    this.extra += `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${radius}"/><text x="${x.toFixed(1)}" y="${y.toFixed(1)}" style="font-size:${radius}px">${text}</text>`;
  }
  number([x, y], text) {
    const away = Math.hypot(x - 200, y - 200);
    const [u, v] = [(x - 200) / away, (y - 200) / away];
    this.extra += `<text class="port" x="${(x + 5 * u - 13 * v).toFixed(1)}" y="${(y + 5 * v + 13 * u).toFixed(1)}">${text}</text>`;
  }
  svg(description) {
    const dots = this.nodes.map(([x, y]) => `M${x.toFixed(1)},${y.toFixed(1)}h0`).join('');
    const drawn = (paths) => Object.entries(paths).filter(([, d]) => d).map(([style, d]) => `<path class="${style}" d="${d}"/>`).join('');
    // A picture that has buttons in it is a group.
    return `<svg class="patch" viewBox="5 5 390 390" role="${this.extra.includes('role="button"') ? 'group' : 'img'}" aria-label="${description}">` +
      drawn(this.faces) + this.fills + drawn({ ...this.strokes, node: dots }) + this.extra + '</svg>';
  }
}

const strokeOf = (solid, marked = false) => (!solid ? 'dashed' : marked ? 'solid marked' : 'solid');

/// The closed fan before a split. `click`: edges can be clicked; `fills`: colours of the triangles; `world`: ports that
/// are connected outside.
export function fanPicture(k, a, loop, ports, description, { click = false, fills = [], world = [] } = {}) {
  const rim = rimOf(k, a);
  const center = [200, 200];
  const patch = new Patch();
  for (let i = 0; i < k; ++i) patch.add(center, rim[i], rim[i + 1]);
  const ends = patch.nodes.map((_, i) => {
    const across = middle(center, rim[i + 1]);
    patch.join(i, (i + 1) % k, across, strokeOf(has(loop, i)));
    const outside = patch.port(i, rim[i], rim[i + 1], strokeOf(has(ports, i)));
    if (fills[i]) patch.fill(fills[i], [center, rim[i], rim[i + 1]]);
    if (click) {
      patch.hit(`loop ${i}`, `loop edge ${i}`, has(loop, i), [patch.nodes[i], across, patch.nodes[(i + 1) % k]]);
      patch.hit(`port ${i}`, `port ${i}`, has(ports, i), [patch.nodes[i], outside]);
    }
    return outside;
  });
  if (world.length > 0) patch.outside(...world.map((port) => ends[port]));
  return patch.svg(description);
}

/// The ring with chord after it, in the same way; its ports cannot be clicked. `named`: triangles and ports have their
/// names on them; `fault`: of these colours, marked, with its world (judge.mjs).
export function ringPicture(k, a, inner, ports, description, { click = false, fills = [], named = false, fault = null } = {}) {
  const rim = rimOf(k, a);
  const patch = new Patch();
  const toward = (first, last) => middle(...rim.slice(first, last + 1)).map((c) => 200 + (c - 200) * 0.45);
  const vS = toward(0, a);
  const vT = toward(a, k);
  const corners = [...Array.from({ length: k }, (_, i) => [i < a ? vS : vT, rim[i], rim[i + 1]]), [vS, vT, rim[0]], [vT, vS, rim[a]]];
  corners.forEach((places, i) => {
    patch.add(...places, i < k ? 'old' : 'new');
    if (fills[i]) patch.fill(fills[i], places);
  });
  const names = [...Array.from({ length: k }, (_, i) => `t${i}`), 'A', 'D'];
  ringEdges(k, a).forEach(([i, j], edge) => {
    const across = edge === k + 2 ? middle(vS, vT) : middle(edge <= a ? vS : vT, rim[edge <= a ? edge : edge - 1]);
    patch.join(i, j, across, strokeOf(has(inner, edge), fault && has(fault.inner, edge)));
    if (click) patch.hit(`inner ${edge}`, `edge between ${names[i]} and ${names[j]}`, has(inner, edge), [patch.nodes[i], across, patch.nodes[j]]);
  });
  const ends = rim.slice(1).map((end, i) => patch.port(i, rim[i], end, strokeOf(has(ports, i), fault && has(fault.ports, i))));
  if (fault?.world.length > 0) patch.outside(...fault.world.map((port) => ends[port]));
  if (named) {
    names.forEach((name, i) => patch.name(patch.nodes[i], name, Math.min(15, Math.floor(230 / k))));
    ends.forEach((end, port) => patch.number(end, port));
  }
  return patch.svg(description);
}

/// The triangles that each inner edge of the ring with chord joins: 0 to k - 1 are t_i, then come A and D.
export function ringEdges(k, a) {
  const ring = [k, ...Array.from({ length: a }, (_, i) => i), k + 1, ...Array.from({ length: k - a }, (_, i) => a + i)];
  return [...ring.map((node, j) => [node, ring[(j + 1) % (k + 2)]]), [k, k + 1]];
}

/// Pairs of consecutive solid ports that are joined in a closed fan, each as [port, the one that precedes it].
export function joinedPairs(k, loop, ports) {
  const solid = [];
  for (let i = 0; i < k; ++i) if (has(ports, i)) solid.push(i);
  const pairs = [];
  if (solid.length < 2) return pairs;
  solid.forEach((port, n) => {
    const before = solid[(n + solid.length - 1) % solid.length];
    let joined = true;
    for (let i = before; i !== port; i = (i + 1) % k) joined &&= has(loop, i);
    if (joined) pairs.push([port, before]);
  });
  return pairs;
}

/// Bit j (j - 1) / 2 + i is the pair of ports i < j.
export const pairsMask = (pairs) => pairs.reduce((mask, [p, q]) => {
  const [i, j] = p < q ? [p, q] : [q, p];
  return mask | 1n << BigInt(j * (j - 1) / 2 + i);
}, 0n);

/// The smallest key (ports, joined pairs; docs/reference/certificate.md) in the orbit of a closed fan that is split at (k, a), which has
/// a row in the atlas, with the map of triangles that leads there; or the key of the fan itself.
export function representative(k, a, loop, ports, itself = false) {
  const pairs = joinedPairs(k, loop, ports);
  const maps = itself ? [(i) => i] : [(i) => i, (i) => (((a - 1 - i) % k) + k) % k];
  if (2 * a === k && !itself) maps.push((i) => (i + a) % k, (i) => (((2 * a - 1 - i) % k) + k) % k);
  let best = null;
  for (const map of maps) {
    let moved = 0n;
    for (let i = 0; i < k; ++i) if (has(ports, i)) moved |= 1n << BigInt(map(i));
    const joined = pairsMask(pairs.map(([p, q]) => [map(p), map(q)]));
    if (!best || moved < best.ports || (moved === best.ports && joined < best.joined)) best = { ports: moved, joined, map };
  }
  return best;
}

/// How the atlas names the rule of a key.
export const ruleName = (k, a, { ports, joined }) => `split-${k}-${a}-${ports.toString(16)}-${joined.toString(16)}`;

/// A split at (k, a) with a > k / 2, seen from its other new triangle: (k, k - a).
export function listed(k, a, loop, ports) {
  if (2 * a <= k) return { a, loop, ports };
  const turn = (mask) => {
    let out = 0n;
    for (let i = 0; i < k; ++i) if (has(mask, (i + a) % k)) out |= 1n << BigInt(i);
    return out;
  };
  return { a: k - a, loop: turn(BigInt(loop)), ports: turn(BigInt(ports)) };
}

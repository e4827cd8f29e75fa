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

const outline = (corners) => `M${corners.map((p) => p.map((c) => c.toFixed(1)).join(',')).join('L')}z`;

export class Patch {
  faces = { old: '', new: '' };
  fills = '';
  strokes = { dashed: '', solid: '' };
  nodes = [];
  extra = '';
  add(a, b, c, style = 'old') {
    this.faces[style] += outline([a, b, c]);
    this.nodes.push(middle(a, b, c));
    return this.nodes.length - 1;
  }
  stroke(from, to, solid) {
    this.strokes[solid ? 'solid' : 'dashed'] += `M${from[0].toFixed(1)},${from[1].toFixed(1)}L${to[0].toFixed(1)},${to[1].toFixed(1)}`;
  }
  join(i, j, across, solid) {
    this.stroke(this.nodes[i], across, solid);
    this.stroke(across, this.nodes[j], solid);
  }
  port(i, a, b, solid) {
    const door = middle(a, b);
    const outside = door.map((d, n) => d + (d - this.nodes[i][n]) * 0.7);
    this.stroke(this.nodes[i], outside, solid);
    return outside;
  }
  /// An edge that can be clicked, and names itself.
  hit(edge, label, solid, points) {
    const line = points.map((p) => p.map((c) => c.toFixed(1)).join(',')).join(' ');
    this.extra += `<polyline class="hit" tabindex="0" role="button" aria-pressed="${solid}" aria-label="${label}" data-edge="${edge}" points="${line}"/>`;
  }
  /// A coloured triangle, and one that can be marked.
  fill(color, corners) { this.fills += `<path class="old" style="fill:${color}" d="${outline(corners)}"/>`; }
  face(i, corners) { this.extra += `<path class="face" data-face="${i}" d="${outline(corners)}"/>`; }
  /// The name of a triangle, next to its node: at a distance and an angle from the direction of something else.
  name(node, toward, away, turn, text) {
    const [x, y] = toward.map((c, n) => (c - node[n]) * away / Math.hypot(toward[0] - node[0], toward[1] - node[1]));
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    this.extra += `<text x="${(node[0] + cos * x - sin * y).toFixed(1)}" y="${(node[1] + sin * x + cos * y).toFixed(1)}">${text}</text>`;
  }
  svg(description) {
    const dots = this.nodes.map(([x, y]) => `M${x.toFixed(1)},${y.toFixed(1)}h0`).join('');
    const drawn = (paths) => Object.entries(paths).filter(([, d]) => d).map(([style, d]) => `<path class="${style}" d="${d}"/>`).join('');
    // A picture that has buttons in it is a group.
    return `<svg class="patch" viewBox="5 5 390 390" role="${this.extra.includes('role="button"') ? 'group' : 'img'}" aria-label="${description}">` +
      drawn(this.faces) + this.fills + drawn({ ...this.strokes, node: dots }) + this.extra + '</svg>';
  }
}

/// The closed fan before a split. `click`: edges can be clicked; `fills`: colours of the triangles.
export function fanPicture(k, a, loop, ports, description, { click = false, fills = [] } = {}) {
  const rim = rimOf(k, a);
  const center = [200, 200];
  const patch = new Patch();
  for (let i = 0; i < k; ++i) patch.add(center, rim[i], rim[i + 1]);
  for (let i = 0; i < k; ++i) {
    const across = middle(center, rim[i + 1]);
    patch.join(i, (i + 1) % k, across, has(loop, i));
    const outside = patch.port(i, rim[i], rim[i + 1], has(ports, i));
    if (fills[i]) patch.fill(fills[i], [center, rim[i], rim[i + 1]]);
    if (!click) continue;
    patch.hit(`loop ${i}`, `loop edge ${i}`, has(loop, i), [patch.nodes[i], across, patch.nodes[(i + 1) % k]]);
    patch.hit(`port ${i}`, `port ${i}`, has(ports, i), [patch.nodes[i], outside]);
  }
  return patch.svg(description);
}

/// The ring with chord after it, in the same way; its ports cannot be clicked. `faces`: triangles can be marked; `marked`: inner edges to point at;
/// `named`: each triangle has its name on it.
export function ringPicture(k, a, inner, ports, description, { click = false, faces = false, fills = [], named = false, marked = 0n } = {}) {
  const rim = rimOf(k, a);
  const patch = new Patch();
  const toward = (first, last) => middle(...rim.slice(first, last + 1)).map((c) => 200 + (c - 200) * 0.45);
  const vS = toward(0, a);
  const vT = toward(a, k);
  const corners = [...Array.from({ length: k }, (_, i) => [i < a ? vS : vT, rim[i], rim[i + 1]]), [vS, vT, rim[0]], [vT, vS, rim[a]]];
  corners.forEach((places, i) => {
    patch.add(...places, i < k ? 'old' : 'new');
    if (fills[i]) patch.fill(fills[i], places);
    if (faces) patch.face(i, places);
  });
  const names = [...Array.from({ length: k }, (_, i) => `t${i}`), 'A', 'D'];
  ringEdges(k, a).forEach(([i, j], edge) => {
    const across = edge === k + 2 ? middle(vS, vT) : middle(edge <= a ? vS : vT, rim[edge <= a ? edge : edge - 1]);
    patch.join(i, j, across, has(inner, edge));
    const line = [patch.nodes[i], across, patch.nodes[j]];
    if (has(marked, edge)) patch.extra += `<polyline class="marked" points="${line.map((p) => p.map((c) => c.toFixed(1)).join(',')).join(' ')}"/>`;
    if (click) patch.hit(`inner ${edge}`, `edge between ${names[i]} and ${names[j]}`, has(inner, edge), line);
  });
  for (let i = 0; i < k; ++i) patch.port(i, rim[i], rim[i + 1], has(ports, i));
  if (named) {
    // Between the port and an edge; nothing lies beyond the new triangles.
    for (let i = 0; i < k; ++i) patch.name(patch.nodes[i], middle(rim[i], rim[i + 1]), 26, 0.9, names[i]);
    [rim[0], rim[a]].forEach((place, n) => patch.name(patch.nodes[k + n], place, 44, 0, names[k + n]));
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

// Patches that the viewer does not draw: open fans and flips.
import { Patch, has, middle, rimOf } from '../viewer/patch.mjs';

/// The rim of an open fan: k + 1 places, from the right end of the boundary to the left one, seen from inside the mesh.
function openRim(k) {
  const width = Math.PI * Math.min(1.5, 0.55 + 0.12 * k);
  return Array.from({ length: k + 1 }, (_, i) => {
    const angle = Math.PI / 2 + width / 2 - width * i / k;
    return [200 - 165 * Math.cos(angle), 235 - 165 * Math.sin(angle)];
  });
}
const hub = [200, 235];

/// A fan, closed or open, with its loop edges.
export function anyFan({ closed, k, a = 1 }, loop, ports, description) {
  const rim = closed ? rimOf(k, a) : openRim(k);
  const center = closed ? [200, 200] : hub;
  const patch = new Patch();
  for (let i = 0; i < k; ++i) patch.add(center, rim[i], rim[i + 1]);
  for (let i = 0; i < k; ++i) {
    if (closed || i + 1 < k) patch.join(i, (i + 1) % k, middle(center, rim[i + 1]), has(loop, i));
    patch.port(i, rim[i], rim[i + 1], has(ports, i));
  }
  return patch.svg(description);
}

/// After a split at the boundary: two triangles in the gaps i < j, or one in gap i.
export function openSplitPicture(k, [i, j], inner, ports, description) {
  const rim = openRim(k);
  const patch = new Patch();
  const order = [];
  if (j === undefined) {
    // The two ends of the new edge, which lies on the boundary.
    const right = [hub[0] + (rim[0][0] - 200) * 0.3, hub[1] + 12];
    const left = [hub[0] + (rim[k][0] - 200) * 0.3, hub[1] + 12];
    const corner = (t) => (t < i ? right : left);
    for (let t = 0; t < k; ++t) patch.add(corner(t), rim[t], rim[t + 1]);
    const a = patch.add(right, left, rim[i], 'new');
    order.push(...Array.from({ length: k }, (_, t) => t));
    order.splice(i, 0, a);
    for (let m = 0; m < k; ++m) patch.join(order[m], order[m + 1], middle(m < i ? right : left, rim[m < i ? m + 1 : m]), has(inner, m));
  } else {
    const inside = middle(...rim.slice(i, j + 1)).map((c, n) => hub[n] + (c - hub[n]) * 0.5);
    const outside = [hub[0], hub[1] + 10];
    const corner = (t) => (t < i || t >= j ? outside : inside);
    for (let t = 0; t < k; ++t) patch.add(corner(t), rim[t], rim[t + 1]);
    const a = patch.add(outside, inside, rim[i], 'new');
    const d = patch.add(inside, outside, rim[j], 'new');
    order.push(...Array.from({ length: k }, (_, t) => t));
    order.splice(j, 0, d);
    order.splice(i, 0, a);
    for (let m = 0; m <= k; ++m) {
      const place = m < i ? m + 1 : m <= j ? m : m - 1;
      patch.join(order[m], order[m + 1], middle(m < i || m > j ? outside : inside, rim[place]), has(inner, m));
    }
    patch.join(a, d, middle(inside, outside), has(inner, k + 1));
  }
  for (let t = 0; t < k; ++t) patch.port(t, rim[t], rim[t + 1], has(ports, t));
  return patch.svg(description);
}

/// Two triangles and the ports p_0 … p_3 around them; p_0 and p_1 belong to one before, p_1 and p_2 after.
export function flipPicture(turned, inner, ports, description) {
  const corner = [[200, 350], [350, 200], [200, 50], [50, 200]];  // side i from corner i to corner i + 1
  const patch = new Patch();
  const owner = turned ? [1, 0, 0, 1] : [0, 0, 1, 1];
  if (turned) {
    patch.add(corner[1], corner[2], corner[3], 'new');
    patch.add(corner[3], corner[0], corner[1], 'new');
  } else {
    patch.add(corner[0], corner[1], corner[2]);
    patch.add(corner[2], corner[3], corner[0]);
  }
  patch.join(0, 1, [200, 200], inner);
  for (let i = 0; i < 4; ++i) patch.port(owner[i], corner[i], corner[(i + 1) % 4], has(ports, i));
  return patch.svg(description);
}

// Try it: a sheet of triangles in strips. Each click looks up the rule of the patch in the table that was generated, changes
// the triangles and recolours the patch by the rule. The rest of the sheet is not read.
import { edgesOf, portsAfter } from './surface.mjs';

const [columns, rows, unit] = [13, 8, 60];
const most = { strips: 2, matching: 1 };  // solid edges of a triangle
const edgeKey = (u, v) => (u < v ? `${u} ${v}` : `${v} ${u}`);
const turning = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
const sidesOf = ([a, b, c]) => [[a, b, c], [b, c, a], [c, a, b]];

/// Triangles of names in an order in which each shares a side with one before it.
function connected(triangles) {
  const order = [triangles[0]];
  for (const rest = triangles.slice(1); rest.length > 0;) {
    const sides = new Set(order.flatMap(sidesOf).map(([u, v]) => edgeKey(u, v)));
    order.push(...rest.splice(Math.max(0, rest.findIndex((t) => sidesOf(t).some(([u, v]) => sides.has(edgeKey(u, v))))), 1));
  }
  return order;
}

/// Triangles { corners, hue } at points, with a set of solid edges: triangles with one in common are in one strip.
class Sheet {
  points = [];
  triangles = [];
  solid = new Set();

  /// Squares of which each is cut along one of its diagonals; in some triangles lies a vertex.
  static made(constraint, random) {
    const sheet = new Sheet();
    const { points, triangles } = sheet;
    const at = (i, j) => j * (columns + 1) + i;
    for (let j = 0; j <= rows; ++j)
      for (let i = 0; i <= columns; ++i) {
        const free = i > 0 && i < columns && j > 0 && j < rows ? 0.36 : 0;
        points.push([unit * (i + 0.3 + free * (random() - 0.5)), unit * (j + 0.3 + free * (random() - 0.5))]);
      }
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        const [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        for (const [u, v, w] of random() < 0.5 ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]]) {
          const m = points.length;
          if (random() > 0.08) triangles.push({ corners: [u, v, w] });
          else triangles.push(...[[u, v, m], [v, w, m], [w, u, m]].map((corners) => ({ corners }))), points.push([0, 1].map((n) => (points[u][n] + points[v][n] + points[w][n]) / 3));
        }
      }
    const { both } = sheet;
    const free = triangles.map(() => most[constraint]);
    const root = triangles.map((_, t) => t);
    for (const [edge, [s, t]] of both) {
      if (free[s] === 0 || free[t] === 0 || root[s] === root[t]) continue;
      sheet.solid.add(edge);
      --free[s];
      --free[t];
      const from = root[s];
      root.forEach((one, n) => { if (one === from) root[n] = root[t]; });
    }
    return sheet;
  }
  copy() {
    const { points, triangles, solid } = this;
    return Object.assign(new Sheet(), { points: [...points], triangles: triangles.map((one) => ({ ...one })), solid: new Set(solid) });
  }
  /// The triangles at each edge that has two.
  get both() {
    const at = new Map();
    this.triangles.forEach(({ corners }, t) => sidesOf(corners).forEach(([u, v]) => at.set(edgeKey(u, v), [...at.get(edgeKey(u, v)) ?? [], t])));
    return new Map([...at].filter(([, ends]) => ends.length === 2));
  }
  /// Lists of the triangles of each strip; null if a triangle has too many solid edges, or a cycle is solid.
  strips(constraint) {
    const { both } = this;
    const root = this.triangles.map((_, t) => t);
    const degree = root.map(() => 0);
    const find = (t) => { while (root[t] !== t) t = root[t]; return t; };
    for (const edge of this.solid) {
      const ends = both.get(edge);
      if (!ends || ends.some((t) => ++degree[t] > most[constraint]) || find(ends[0]) === find(ends[1])) return null;
      root[find(ends[0])] = find(ends[1]);
    }
    const lists = new Map();
    root.forEach((_, t) => lists.set(find(t), [...lists.get(find(t)) ?? [], t]));
    return [...lists.values()].sort((one, other) => other.length - one.length);
  }
  /// Strips keep the colour of most of their triangles.
  paint(strips) {
    const taken = new Set();
    for (const strip of strips) {
      const counts = new Map();
      for (const t of strip) counts.set(this.triangles[t].hue, (counts.get(this.triangles[t].hue) ?? 0) + 1);
      let [hue] = [...counts].filter(([one]) => one !== undefined && !taken.has(one)).sort(([, m], [, n]) => n - m)[0] ?? [0];
      while (taken.has(hue)) hue = (hue + 222.5) % 360;
      taken.add(hue);
      for (const t of strip) this.triangles[t].hue = hue;
    }
  }
}

export class Trial {
  #past = [];
  near = -1;  // the place that is marked

  /// `element` receives the sheet, `said` a sentence.
  constructor(element, said) {
    Object.assign(this, { element, said });
    const point = (event) => {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(element.querySelector('svg').getScreenCTM().inverse());
      return [x, y];
    };
    element.addEventListener('pointermove', (event) => event.pointerType === 'mouse' && this.#mark(this.#nearest(point(event))));
    element.addEventListener('click', (event) => {
      this.#mark(this.#nearest(point(event)));
      this.apply();
    });
    element.addEventListener('keydown', (event) => {
      const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (by) this.#mark((this.near + by + this.places.length) % this.places.length);
      else if (event.key === 'Enter' || event.key === ' ') this.apply();
      else return;
      event.preventDefault();
    });
  }
  /// A new sheet. `rule`: from a configuration { inner, ports } to its recolouring.
  begin(drawing, rule) {
    const { before, after, boundary, constraint = 'strips' } = drawing.operation;
    Object.assign(this, { drawing, rule, constraint, order: connected(before), old: edgesOf(before, boundary), next: { inner: edgesOf(after, boundary).inner, ports: portsAfter(drawing.operation) } });
    let seed = 7;
    this.sheet = Sheet.made(constraint, () => (seed = seed * 48271 % 2147483647) / 2147483647);
    this.#past = [];
    this.near = -1;
    this.#show();
    this.said(this.places.length === 0 ? 'The triangles before the operation are nowhere in this sheet.' : 'Click on the sheet. With the keyboard: arrow keys choose a place, Enter applies the operation there.');
  }
  get strips() { return this.sheet.strips(this.constraint)?.length ?? null; }
  undo() {
    if (this.#past.length === 0) return;
    this.sheet = this.#past.pop();
    this.#show();
    this.said(`Undone: ${this.strips} strips.`);
  }
  apply() {
    const place = this.places[this.near];
    if (!place) return this.said('The triangles before the operation do not lie here. Try another place.');
    const { sheet, old, next, strips } = this;
    const key = ([, , a, b]) => edgeKey(place.of.get(a), place.of.get(b));
    const door = ([, a, b]) => edgeKey(place.of.get(a), place.of.get(b));
    const known = new Set(old.inner.map(key));
    const mask = (edges) => edges.reduce((bits, edge, n) => bits | (sheet.solid.has(edge) ? 1 << n : 0), 0);
    const rule = this.rule({ inner: mask(old.inner.map(key)), ports: mask(old.ports.map(door)) });
    this.#past.push(sheet.copy());
    place.fresh.forEach(([name, at]) => place.of.set(name, sheet.points.push(at) - 1));
    for (const edge of known) sheet.solid.delete(edge);
    const gone = new Set(place.triangles);
    sheet.triangles = [...sheet.triangles.filter((_, t) => !gone.has(t)), ...this.drawing.operation.after.map((names) => ({ corners: names.map((name) => place.of.get(name)) }))];
    next.inner.forEach((edge, n) => { if (rule.inner >> n & 1) sheet.solid.add(key(edge)); });
    old.ports.forEach((port, n) => { if (!(rule.ports >> n & 1)) sheet.solid.delete(door(port)); });
    this.#show();
    return this.said(`Applied: ${strips} → ${this.strips} strips over ${sheet.triangles.length} triangles.`);
  }

  /// Where the triangles before the operation lie in the sheet, and where new vertices go, as the drawing has them.
  #find() {
    const { before, after, boundary = [] } = this.drawing.operation;
    const { points, triangles } = this.sheet;
    const key = (u, v) => u * 65536 + v;
    const at = new Map(triangles.flatMap(({ corners }, t) => sidesOf(corners).map(([u, v, w]) => [key(u, v), { apex: w, t }])));
    const known = [...new Set(before.flat())];
    const fresh = [...new Set(after.flat())].filter((name) => !known.includes(name));
    const found = [];
    for (const [side, { apex }] of at) {
      const of = new Map([[before[0][0], Math.floor(side / 65536)], [before[0][1], side % 65536], [before[0][2], apex]]);
      const fits = this.order.every((triangle) => {
        for (const [u, v, w] of sidesOf(triangle)) {
          if (!of.has(u) || !of.has(v)) continue;
          const there = at.get(key(of.get(u), of.get(v)));
          if (!there) return false;
          if (!of.has(w)) of.set(w, there.apex);
          if (of.get(w) !== there.apex) return false;
        }
        return triangle.every((name) => of.has(name));
      });
      if (!fits || new Set(of.values()).size < of.size || boundary.some(([a, b]) => at.has(key(of.get(b), of.get(a))))) continue;
      const inside = new Set(this.old.inner.map(([, , a, b]) => edgeKey(of.get(a), of.get(b))));
      // The mesh must not have an edge twice.
      if (this.next.inner.some(([, , a, b]) => of.has(a) && of.has(b) && (at.has(key(of.get(a), of.get(b))) || at.has(key(of.get(b), of.get(a)))) && !inside.has(edgeKey(of.get(a), of.get(b))))) continue;
      const where = new Map([...of].map(([name, v]) => [name, points[v]]));
      for (const name of fresh) {
        const weights = known.map((other) => 1 / (1 + Math.hypot(...[0, 1].map((n) => this.drawing.places[name][n] - this.drawing.places[other][n]))) ** 2);
        const sum = weights.reduce((all, w) => all + w, 0);
        where.set(name, [0, 1].map((n) => weights.reduce((all, w, i) => all + w * where.get(known[i])[n], 0) / sum));
      }
      // The sheet stays flat; y points down.
      if (after.some((triangle) => turning(...triangle.map((name) => where.get(name))) > -20)) continue;
      const patch = before.map((triangle) => triangle.map((name) => where.get(name)));
      found.push({ of, patch, fresh: fresh.map((name) => [name, where.get(name)]), triangles: before.map(([a, b]) => at.get(key(of.get(a), of.get(b))).t),
        center: [0, 1].map((n) => patch.flat().reduce((all, p) => all + p[n], 0) / (3 * patch.length)) });
    }
    return found.sort((one, other) => one.center[1] - other.center[1] || one.center[0] - other.center[0]);
  }
  #nearest([x, y]) {
    let [best, least] = [-1, 1.2 * unit];
    this.places.forEach(({ center }, n) => {
      const away = Math.hypot(center[0] - x, center[1] - y);
      if (away < least) [best, least] = [n, away];
    });
    return best;
  }
  #mark(n) {
    this.near = n;
    this.element.querySelector('.chosen').setAttribute('d', (this.places[n]?.patch ?? []).map((corners) => `M${corners.map((p) => p.map((c) => c.toFixed(1)).join(',')).join('L')}z`).join(''));
  }
  #show() {
    const { sheet } = this;
    const strips = sheet.strips(this.constraint);
    sheet.paint(strips);
    const place = (v) => sheet.points[v].map((c) => c.toFixed(1)).join(',');
    const faces = sheet.triangles.map(({ corners, hue }) => `<path style="fill:hsl(${hue.toFixed(0)} 55% 62%)" d="M${corners.map(place).join('L')}z"/>`).join('');
    const walls = [...sheet.both.keys()].filter((edge) => !sheet.solid.has(edge)).map((edge) => `M${edge.split(' ').map(place).join('L')}`).join('');
    const focused = this.element.contains(document.activeElement);
    this.element.innerHTML = `<svg viewBox="0 0 ${[columns, rows].map((n) => (n + 0.6) * unit).join(' ')}" tabindex="0" role="application" aria-label="A sheet of triangles in strips. Arrow keys choose a place, Enter applies the operation.">` +
      `${faces}<path class="walls" d="${walls}"/><path class="chosen" d=""/></svg>`;
    if (focused) this.element.querySelector('svg').focus();
    this.places = this.#find();
    this.#mark(this.places.length > 0 ? Math.max(0, Math.min(this.near, this.places.length - 1)) : -1);
  }
}

// Try it: a sheet of triangles whose strips the library maintains, as it does for programs that use the npm package. A click
// applies the table that was generated to the triangles there.
import { Ribbon } from '../viewer/ribbon.mjs';
import { edgesOf } from './surface.mjs';

const [columns, rows, unit] = [13, 8, 60];
const turning = ([ax, ay], [bx, by], [cx, cy]) => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
const sidesOf = ([a, b, c]) => [[a, b, c], [b, c, a], [c, a, b]];
const mean = (points) => [0, 1].map((n) => points.reduce((sum, p) => sum + p[n], 0) / points.length);

/// Triangles of names in an order in which each shares a side with one before it.
function connected(triangles) {
  const order = [triangles[0]];
  for (const rest = triangles.slice(1); rest.length > 0;) {
    const known = new Set(order.flatMap(sidesOf).map(([u, v]) => `${v} ${u}`));
    order.push(...rest.splice(Math.max(0, rest.findIndex((t) => sidesOf(t).some(([u, v]) => known.has(`${u} ${v}`)))), 1));
  }
  return order;
}

/// Squares of which each is cut along one of its diagonals; in some triangles lies a vertex. y points down.
function sheetOf(random) {
  const places = [];
  const triangles = [];
  for (let j = 0; j <= rows; ++j)
    for (let i = 0; i <= columns; ++i) {
      const free = i > 0 && i < columns && j > 0 && j < rows ? 0.36 : 0;
      places.push([unit * (i + 0.3 + free * (random() - 0.5)), unit * (j + 0.3 + free * (random() - 0.5))]);
    }
  for (let j = 0; j < rows; ++j)
    for (let i = 0; i < columns; ++i) {
      const a = j * (columns + 1) + i;
      const [b, c, d] = [a + columns + 1, a + columns + 2, a + 1];
      for (const t of random() < 0.5 ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]]) {
        if (random() > 0.08) triangles.push(t);
        else triangles.push(...sidesOf(t).map(([u, v]) => [u, v, places.length])), places.push(mean(t.map((v) => places[v])));
      }
    }
  return { points: places.flatMap(([x, y]) => [x, y, 0]), triangles: triangles.flat() };
}

export class Trial {
  mesh = null;
  near = -1;  // the place that is marked

  /// `element` receives the sheet, `said` a sentence.
  constructor(restrip, element, said) {
    Object.assign(this, { restrip, element, said });
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
  /// A new sheet. `table`: of the operation that is drawn, as restrip-generate writes it.
  begin(drawing, table) {
    Object.assign(this, { drawing, table, order: connected(drawing.operation.before), near: -1, ribbon: null });
    let seed = 7;
    this.mesh?.close();
    this.mesh = this.restrip.mesh(sheetOf(() => (seed = seed * 48271 % 2147483647) / 2147483647)).begin({ policy: 'rules', history: 1e6 });
    this.#show();
    this.said(this.places.length === 0 ? 'The triangles before the operation are nowhere in this sheet.' : 'Click on the sheet. With the keyboard: arrow keys choose a place, Enter applies the operation there.');
  }
  get strips() { return this.mesh.figures.strips; }
  undo() {
    if (!this.mesh.undo()) return;
    this.#show();
    this.said(`Undone: ${this.strips} strips.`);
  }
  apply() {
    const place = this.places[this.near];
    if (!place) return this.said('The triangles before the operation do not lie here. Try another place.');
    const { mesh, strips } = this;
    const { ok, reason, vertices } = mesh.apply(this.table, ...this.drawing.operation.before[0].slice(0, 2).map((name) => place.of.get(name)));
    if (!ok) return this.said(`The mesh refuses: ${reason}.`);
    vertices.forEach((v, n) => mesh.setPoint(v, ...place.fresh[n], 0));
    this.#show();
    return this.said(`Applied: ${strips} → ${this.strips} strips over ${mesh.figures.triangles} triangles.`);
  }

  /// Where the triangles before the operation lie in the sheet, and where new vertices go, as the drawing has them.
  #find() {
    const { places, operation: { before, after, boundary } } = this.drawing;
    const { outline, ports } = edgesOf(before, boundary);
    const open = outline.filter((side) => !ports.includes(side));
    const { points } = this.mesh;
    const key = (u, v) => u * 65536 + v;
    const at = new Map();
    for (let i = 0; i < this.ribbon.count; ++i) for (const [u, v, w] of sidesOf([...this.ribbon.corners(i)])) at.set(key(u, v), w);
    const known = [...new Set(before.flat())];
    const fresh = [...new Set(after.flat())].filter((name) => !known.includes(name));
    const found = [];
    for (const [side, apex] of at) {
      const of = new Map([[before[0][0], Math.floor(side / 65536)], [before[0][1], side % 65536], [before[0][2], apex]]);
      const fits = this.order.every((triangle) => {
        for (const [u, v, w] of sidesOf(triangle)) {
          if (!of.has(u) || !of.has(v)) continue;
          const there = at.get(key(of.get(u), of.get(v)));
          if (there === undefined || (of.get(w) ?? there) !== there) return false;
          of.set(w, there);
        }
        return triangle.every((name) => of.has(name));
      });
      if (!fits || new Set(of.values()).size < of.size || open.some(([, a, b]) => at.has(key(of.get(b), of.get(a))))) continue;
      const where = new Map([...of].map(([name, v]) => [name, [...points.subarray(3 * v, 3 * v + 2)]]));
      for (const name of fresh) {
        const weights = known.map((other) => 1 / (1 + Math.hypot(...[0, 1].map((n) => places[name][n] - places[other][n]))) ** 2);
        const sum = weights.reduce((all, w) => all + w, 0);
        where.set(name, [0, 1].map((n) => weights.reduce((all, w, i) => all + w * where.get(known[i])[n], 0) / sum));
      }
      // The sheet stays flat.
      if (after.some((triangle) => turning(...triangle.map((name) => where.get(name))) > -20)) continue;
      const patch = before.map((triangle) => triangle.map((name) => where.get(name)));
      found.push({ of, patch, fresh: fresh.map((name) => where.get(name)), center: mean(patch.flat()) });
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
    const { mesh } = this;
    mesh.update();  // a step of undo
    this.ribbon = new Ribbon(mesh.ribbon, this.ribbon);
    const { ribbon } = this;
    const path = (...corners) => `M${corners.map((v) => [...mesh.points.subarray(3 * v, 3 * v + 2)].map((c) => c.toFixed(1)).join(',')).join('L')}`;
    let [faces, walls] = ['', ''];
    for (let i = 0; i < ribbon.count; ++i) {
      faces += `<path style="fill:${ribbon.fill(i)}" d="${path(...ribbon.corners(i))}z"/>`;
      sidesOf([...ribbon.corners(i)]).forEach(([u, v], side) => { if (!ribbon.joined(i, side) && ribbon.beyond(i, side) > ribbon.triangle(i)) walls += path(u, v); });
    }
    const focused = this.element.contains(document.activeElement);
    this.element.innerHTML = `<svg viewBox="0 0 ${[columns, rows].map((n) => (n + 0.6) * unit).join(' ')}" tabindex="0" role="application" aria-label="A sheet of triangles in strips. Arrow keys choose a place, Enter applies the operation.">` +
      `${faces}<path class="walls" d="${walls}"/><path class="chosen" d=""/></svg>`;
    if (focused) this.element.querySelector('svg').focus();
    this.places = this.#find();
    this.#mark(this.places.length > 0 ? Math.max(0, Math.min(this.near, this.places.length - 1)) : -1);
  }
}

// An operation as triangles of named vertices (docs/reference/operation-file.md, "Triangles"), and how it is drawn and
// changed. Numbers of inner edges and ports are as that page says.

export const sides = ['before', 'after'];
/// Of a picture.
export const size = [400, 370];
const key = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);
const around = ([a, b, c]) => [[a, b], [b, c], [c, a]];
const center = (...points) => [0, 1].map((n) => points.reduce((sum, p) => sum + p[n], 0) / points.length);
/// Twice the area; positive if a, b, c are counter-clockwise as seen (y points down).
const area = ([ax, ay], [bx, by], [cx, cy]) => (cx - ax) * (by - ay) - (bx - ax) * (cy - ay);

/// The inner edges of a side in order ([triangle, triangle, vertex, vertex]) and its ports ([triangle, vertex, vertex]).
export function edgesOf(triangles, boundary = []) {
  const seen = new Map();
  const inner = [];
  triangles.forEach((triangle, t) => around(triangle).forEach(([a, b]) => {
    const other = seen.get(key(a, b));
    if (other === undefined) seen.set(key(a, b), t);
    else inner.push([other, t, a, b]);
  }));
  const both = new Set(inner.map(([, , a, b]) => key(a, b)));
  const rim = new Map(triangles.flatMap((triangle, t) => around(triangle).filter(([a, b]) => !both.has(key(a, b))).map(([a, b]) => [a, [t, a, b]])));
  const mesh = new Set();  // from these vertices a side leads along the boundary of the mesh
  for (const [from, to] of boundary) for (let at = from; at !== to && rim.has(at) && !mesh.has(at); at = rim.get(at)[2]) mesh.add(at);
  const outline = [];
  const first = triangles.flatMap(around).find(([a, b]) => rim.get(a)?.[2] === b && !mesh.has(a))?.[0];
  for (let at = first; rim.has(at) && outline.length < rim.size;) {
    outline.push(rim.get(at));
    at = rim.get(at)[2];
  }
  return { inner, outline, ports: outline.filter(([, a]) => !mesh.has(a)) };
}

/// The ports of the side after, in the order of the ports before.
function portsAfter(operation) {
  const after = new Map(edgesOf(operation.after, operation.boundary).ports.map((port) => [key(port[1], port[2]), port]));
  return edgesOf(operation.before, operation.boundary).ports.map(([, a, b]) => after.get(key(a, b)));
}

export class Drawing {
  places = {};
  constructor(operation, places = {}) {
    this.operation = operation;
    this.places = { ...places };
    this.#placeAll();
  }
  /// An outline of `corners` vertices, each side cut from its first one.
  static outline(corners) {
    const names = Array.from({ length: corners }, (_, i) => 'abcdefgh'[i]);
    const fan = () => names.slice(2).map((name, i) => [names[0], names[i + 1], name]);
    return new Drawing({ restrip_operation: 1, name: 'my-operation', constraint: 'strips', before: fan(), after: fan() });
  }
  copy() { return new Drawing(structuredClone(this.operation), structuredClone(this.places)); }
  vertices(side) { return [...new Set(this.operation[side].flat())]; }
  isInner(side, vertex) { return !edgesOf(this.operation[side]).outline.some(([, a]) => a === vertex); }

  /// Places for vertices that have none: the outline on a circle, the others between their neighbours.
  #placeAll() {
    const rim = edgesOf(this.operation.before).outline.map(([, a]) => a);
    const circle = rim.map((_, i) => Math.PI * (0.5 + (1 - 2 * i) / rim.length)).map((turn) => [Math.cos(turn), Math.sin(turn)]);
    const [least, most] = [Math.min, Math.max].map((end) => [0, 1].map((n) => end(...circle.map((p) => p[n]))));
    const scale = Math.min(...[0, 1].map((n) => (size[n] - 100) / (most[n] - least[n])));
    rim.forEach((name, i) => { this.places[name] ??= circle[i].map((c, n) => size[n] / 2 + (c - (least[n] + most[n]) / 2) * scale); });
    for (const side of sides) {
      const free = this.vertices(side).filter((name) => !this.places[name]);
      for (const name of free) this.places[name] = size.map((c) => c / 2);
      for (let step = 0; step < 60; ++step)
        for (const name of free) {
          const near = [...new Set(this.operation[side].filter((t) => t.includes(name)).flat())].filter((other) => other !== name);
          this.places[name] = center(...near.map((other) => this.places[other]));
        }
    }
  }
  /// Whether no triangle of a side is upside down.
  isFlat(side) { return this.operation[side].every((t) => area(...t.map((name) => this.places[name])) > 60); }

  /// Each changes the operation, or returns a sentence that says why not.
  flip(side, edge) {
    const triangles = this.operation[side];
    const [first, second, a, b] = edgesOf(triangles).inner[edge];
    const apex = (t) => triangles[t].find((name) => name !== a && name !== b);
    const [c, d] = [apex(first), apex(second)];
    if (triangles.some((t) => t.includes(c) && t.includes(d))) return `${c} and ${d} are joined already`;
    const turned = [[c, d, a], [d, c, b]].map((t) => (area(...t.map((name) => this.places[name])) > 0 ? t : [t[1], t[0], t[2]]));
    const whole = (list) => list.reduce((sum, t) => sum + Math.abs(area(...t.map((name) => this.places[name]))), 0);
    if (whole(turned) > whole([triangles[first], triangles[second]]) + 1 || turned.some((t) => area(...t.map((name) => this.places[name])) < 60))
      return `the two triangles at ${a} ${b} have an inward corner; drag a vertex first`;
    [triangles[first], triangles[second]] = turned;
    return '';
  }
  /// A vertex in a triangle: the one that only the other side has, if it lies there; otherwise a new one.
  add(side, triangle, at) {
    const [a, b, c] = this.operation[side][triangle];
    const other = this.vertices(side === 'before' ? 'after' : 'before');
    const mine = this.vertices(side);
    const inside = (p) => around([a, b, c]).every(([u, v]) => area(this.places[u], this.places[v], p) > 60);
    const known = other.find((name) => !mine.includes(name) && inside(this.places[name]));
    if (mine.length >= 20) return 'a side has at most 16 triangles';
    const name = known ?? [...'mvwxyznopqrstu'].find((letter) => !mine.includes(letter) && !other.includes(letter));
    if (!name) return 'no more names';
    if (!known) this.places[name] = at && inside(at) ? at : center(...[a, b, c].map((one) => this.places[one]));
    this.operation[side].splice(triangle, 1, [a, b, name], [b, c, name], [c, a, name]);
    return '';
  }
  /// Takes an inner vertex away; its star is cut by ears.
  remove(side, vertex) {
    if (!this.isInner(side, vertex)) return `${vertex} is on the outline, which both sides share`;
    const star = this.operation[side].filter((t) => t.includes(vertex));
    const next = new Map(star.map((t) => [t[(t.indexOf(vertex) + 1) % 3], t[(t.indexOf(vertex) + 2) % 3]]));
    let ring = [next.keys().next().value];
    while (ring.length < next.size) ring.push(next.get(ring.at(-1)));
    const rest = this.operation[side].filter((t) => !t.includes(vertex));
    const made = [];
    const at = (name) => this.places[name];
    while (ring.length > 3) {
      const ear = ring.findIndex((name, i) => {
        const [u, v] = [ring.at(i - 1), ring[(i + 1) % ring.length]];
        return area(at(u), at(name), at(v)) > 60 && ![...rest, ...made].some((t) => t.includes(u) && t.includes(v)) &&
          !ring.some((p) => ![u, name, v].includes(p) && [[u, name], [name, v], [v, u]].every(([x, y]) => area(at(x), at(y), at(p)) >= 0));
      });
      if (ear < 0) return `the hole that ${vertex} would leave cannot be filled with these vertices`;
      made.push([ring.at(ear - 1), ring[ear], ring[(ear + 1) % ring.length]]);
      ring = ring.filter((_, i) => i !== ear);
    }
    this.operation[side] = [...rest, ...made, ring];
    return '';
  }
  move(vertex, place) {
    const old = this.places[vertex];
    this.places[vertex] = place.map((c, n) => Math.max(15, Math.min(size[n] - 15, c)));
    const wrong = sides.some((side) => this.vertices(side).includes(vertex) && !this.isFlat(side));
    if (wrong) this.places[vertex] = old;
    return wrong ? 'a triangle would be upside down' : '';
  }
  /// The operation file.
  text() {
    const { before, after, ...rest } = this.operation;
    const line = (list) => `[${list.map((t) => JSON.stringify(t).replaceAll(',', ', ')).join(', ')}]`;
    const members = Object.entries(rest).map(([name, value]) => `  "${name}": ${JSON.stringify(value)}`);
    return `{\n${[...members, `  "before": ${line(before)}`, `  "after": ${line(after)}`].join(',\n')}\n}\n`;
  }
  /// What is missing, if the rest of the text is an operation that can be drawn; null otherwise.
  static of(text, places = {}) {
    const operation = JSON.parse(text);
    const list = (side) => Array.isArray(side) && side.length > 0 && side.every((t) => Array.isArray(t) && t.length === 3 && t.every((name) => /^\w{1,20}$/.test(name)));
    if (operation.numbers || !sides.every((side) => list(operation[side]))) return null;
    if (sides.some((side) => edgesOf(operation[side]).outline.length < 3)) return null;
    const drawing = new Drawing(operation, places);
    return sides.every((side) => drawing.isFlat(side)) ? drawing : new Drawing(operation);
  }
}

/// A family at a position, `values` by name, as a single operation; null if its file gives no triangles.
/// Words as in docs/reference/operation-file.md: "u[i+1]", "i[0,k-1)", "2 a + 1".
export function operationAt({ numbers, where, ...family }, values) {
  if (!sides.every((side) => Array.isArray(family[side]))) return null;
  const sum = (text, known) => text.match(/[+-]?[^+-]+/g).reduce((all, term) => all +
    term.match(/\w+/g).reduce((product, word) => product * (known[word] ?? Number(word)), term.startsWith('-') ? -1 : 1), 0);
  const vertex = (word, known = values) => word.replace(/\[(.*)\]$/, (_, index) => sum(index, known));
  const list = (triangles) => triangles.flatMap(([a, b, c, index = 'i[0,1)']) => {
    const [, name, from, to] = /^(\w+)\[(.*),(.*)\)$/.exec(index);
    const first = sum(from, values);
    return Array.from({ length: sum(to, values) - first }, (_, i) => [a, b, c].map((word) => vertex(word, { ...values, [name]: first + i })));
  });
  return { ...family, before: list(family.before), after: list(family.after),
    ...(family.boundary ? { boundary: family.boundary.map((stretch) => stretch.map((word) => vertex(word))) } : {}) };
}

/// A side as SVG. `colors`: { inner, ports } as masks to draw the dual graph, or null. `marked`: the same, in another
/// colour. `world`: lists of ports that are connected outside. `press`: a function of (kind, number) for what can be
/// pressed, as attributes; `old`: the triangles of the other side, which have another colour here when they are new.
export function picture(drawing, side, label, { colors = null, marked = { inner: 0, ports: 0 }, world = [], edit = false, paint = '' } = {}) {
  const { operation, places } = drawing;
  const triangles = operation[side];
  const { inner } = edgesOf(triangles, operation.boundary);
  const ports = side === 'before' ? edgesOf(triangles, operation.boundary).ports : portsAfter(operation);
  const at = (name) => places[name];
  const path = (...points) => `M${points.map((p) => p.map((c) => c.toFixed(1)).join(',')).join('L')}`;
  const other = new Set(operation[side === 'before' ? 'after' : 'before'].map((t) => [...t].sort().join(' ')));
  const hub = triangles.map((t) => center(...t.map(at)));
  const middle = size.map((c) => c / 2);
  const button = (kind, n, name, rest) => `<path class="press" tabindex="0" role="button" data-${kind}="${n}" aria-label="${name}" ${rest}/>`;
  let svg = '';
  triangles.forEach((t, n) => {
    const fresh = side === 'after' && !other.has([...t].sort().join(' '));
    svg += `<path class="${fresh ? 'new' : 'old'}" d="${path(...t.map(at))}z"/>`;
    if (edit) svg += button('triangle', n, `add a vertex in triangle ${t.join(' ')}`, `d="${path(...t.map((name) => center(at(name), hub[n], hub[n])))}z"`);
  });
  const ends = ports.map((port) => {
    if (!port) return null;
    const door = center(at(port[1]), at(port[2]));
    const out = door.map((c, n) => c - hub[port[0]][n]);
    return [door, door.map((c, n) => c + out[n] * Math.min(0.6, 34 / Math.hypot(...out)))];
  });
  if (colors) {
    const style = (solid, mark) => (mark ? 'solid marked' : solid ? 'solid' : 'dashed');
    const bit = (mask, n) => (mask >> n & 1) === 1;
    const from = (p) => p.map((c, n) => c - middle[n]);
    const [long, turn] = [(p) => Math.hypot(...from(p)), (p, q) => from(p)[0] * from(q)[1] - from(p)[1] * from(q)[0]];
    for (const block of world)
      block.slice(1).forEach((port, n) => {
        const [start, end] = [ends[block[n]][1], ends[port][1]];
        const radius = Math.max(long(start), long(end)) + 30;
        const out = (p) => from(p).map((c, i) => (middle[i] + c * radius / long(p)).toFixed(1));
        svg += `<path class="outside" d="${path(start)}L${out(start)}A${radius.toFixed(1)} ${radius.toFixed(1)} 0 0 ${turn(start, end) > 0 ? 1 : 0} ${out(end)}L${end}"/>`;
      });
    inner.forEach(([s, t, a, b], n) => {
      svg += `<path class="${style(bit(colors.inner, n), bit(marked.inner, n))}" d="${path(hub[s], center(at(a), at(b)), hub[t])}"/>`;
    });
    ends.forEach((end, n) => { if (end) svg += `<path class="${style(bit(colors.ports, n), bit(marked.ports, n))}" d="${path(hub[ports[n][0]], ...end)}"/>`; });
    svg += `<path class="node" d="${hub.map((p) => `${path(p)}h0`).join('')}"/>`;
    const number = (n, [x, y]) => { svg += `<text class="number" x="${x.toFixed(1)}" y="${y.toFixed(1)}">${n}</text>`; };
    hub.forEach(([x, y], n) => number(n, [x + 17, y + 17]));
    ends.forEach((end, n) => { if (end) number(n, end[1].map((c, i) => c + 14 * (c - end[0][i]) / Math.hypot(end[1][0] - end[0][0], end[1][1] - end[0][1]))); });
    if (paint.includes('inner'))
      inner.forEach(([s, t, a, b], n) => { svg += button('inner', n, `edge between triangles ${s} and ${t}`, `aria-pressed="${bit(colors.inner, n)}" d="${path(hub[s], center(at(a), at(b)), hub[t])}"`).replace('press', 'press line'); });
    if (paint.includes('ports'))
      ends.forEach((end, n) => { svg += button('port', n, `port ${n}`, `aria-pressed="${bit(colors.ports, n)}" d="${path(hub[ports[n][0]], end[1])}"`).replace('press', 'press line'); });
  }
  if (edit) {
    inner.forEach(([, , a, b], n) => { svg += button('flip', n, `flip the edge ${a} ${b}`, `d="${path(center(at(a), at(a), at(b)), center(at(a), at(b), at(b)))}"`).replace('press', 'press line'); });
    for (const name of drawing.vertices(side)) {
      const free = drawing.isInner(side, name);
      svg += `<g class="vertex" tabindex="0" role="button" data-vertex="${name}" aria-label="vertex ${name}${free ? ', press Delete to remove it' : ''}; arrow keys move it"><circle cx="${at(name)[0].toFixed(1)}" cy="${at(name)[1].toFixed(1)}" r="13"/><text x="${at(name)[0].toFixed(1)}" y="${at(name)[1].toFixed(1)}">${name}</text></g>`;
    }
  }
  return `<svg class="patch" viewBox="0 0 ${size.join(' ')}" role="${edit || paint ? 'group' : 'img'}" aria-label="${label}">${svg}</svg>`;
}

/// The rule of a configuration in a table as JSON at one of its positions, or null if the configuration is not valid.
export function ruleOf({ entries, none, first, matching, ports: count }, { inner, ports }) {
  const entry = entries[first + (matching ? ports : inner << count | ports)];
  return entry === none ? null : { inner: entry >> count, ports: entry & (1 << count) - 1 };
}
/// The number of strips that a rule adds.
export function addedBy({ before, after }, { inner, ports }, rule) {
  const bits = (mask) => mask.toString(2).replaceAll('0', '').length;
  return after.triangles - before.triangles - bits(rule.inner) - bits(rule.ports) + bits(inner) + bits(ports);
}

// The page "Make a rule".
import { embedded } from '../viewer/embedded.mjs';
import { changed, rowsOf } from './certificate.mjs';
import { Drawing, edgesOf, operationAt, picture, sides, size } from './surface.mjs';

const field = (id) => document.getElementById(id);
const base = { restrip_operation: 1, constraint: 'strips' };
const star = ['a', 'b', 'c', 'd', 'e', 'f'].map((name, i, all) => [name, all[(i + 1) % 6], 'm']);
const quad = [['a', 'b', 'c'], ['b', 'a', 'd']];
const examples = {
  'Face split': { ...base, name: 'my-face-split', before: [['a', 'b', 'c']], after: [['a', 'b', 'm'], ['b', 'c', 'm'], ['m', 'c', 'a']] },
  Bisection: { ...base, name: 'my-bisection', before: quad, after: [['b', 'c', 'm'], ['c', 'a', 'm'], ['a', 'd', 'm'], ['m', 'd', 'b']] },
  'Hexagon fan': { ...base, name: 'my-hexagon-fan', before: star, after: [['a', 'b', 'c'], ['a', 'c', 'd'], ['a', 'd', 'e'], ['a', 'e', 'f']], give_up: 'all' },
  'Edge flip': { ...base, name: 'my-edge-flip', before: quad, after: [['c', 'd', 'b'], ['d', 'c', 'a']], give_up: 'all' },
  'Vertex removal': { ...base, name: 'my-vertex-removal', before: [['a', 'b', 'm'], ['b', 'c', 'm'], ['c', 'd', 'm'], ['d', 'a', 'm']], after: [['a', 'b', 'c'], ['c', 'd', 'a']], give_up: 'all' },
};
const family = `{
  "restrip_operation": 1,
  "name": "my-vertex-removal",
  "about": "A vertex of k triangles goes, and its hole becomes a fan around one of its neighbours.",
  "numbers": ["k"],
  "where": "k >= 3",
  "before": [["v", "u[i]", "u[i+1]", "i[0,k-1)"], ["v", "u[k-1]", "u[0]"]],
  "after": [["u[0]", "u[i]", "u[i+1]", "i[1,k-1)"]],
  "give_up": "all"
}
`;
const costs = { cuts: [[{ count: 'given_up' }], [{ count: 'strips' }], [{ count: 'isolated' }]] };
const languages = ['c++', 'c', 'glsl', 'json', 'wgsl'];
const kinds = { cert: 'certificate', hpp: 'C++', h: 'C', glsl: 'GLSL', wgsl: 'WGSL', json: 'table as JSON', bin: 'table, binary' };
const hex = (mask) => mask.toString(16);
const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/// The programs in their worker. A new question of a kind makes older ones of it void; `stop` ends them all.
class Programs {
  #id = 0;
  #waiting = new Map();
  constructor(compiled) {
    this.compiled = compiled;
    this.address = URL.createObjectURL(new Blob([field('worker').textContent], { type: 'text/javascript' }));
    this.#start();
  }
  #start() {
    this.worker = new Worker(this.address);
    this.worker.onmessage = ({ data: { id, heard, answer } }) => {
      const one = this.#waiting.get(id);
      if (heard) return one?.heard(heard);
      this.#waiting.delete(id);
      one?.resolve(answer);
    };
    this.worker.postMessage({ compiled: this.compiled });
  }
  ask(question, heard = () => {}) {
    return new Promise((resolve) => {
      this.#waiting.set(++this.#id, { resolve, heard });
      this.worker.postMessage({ id: this.#id, ...question });
    });
  }
  stop() {
    this.worker.terminate();
    for (const { resolve } of this.#waiting.values()) resolve({ stopped: true });
    this.#waiting.clear();
    this.#start();
  }
}

class Page {
  past = [];
  made = null;
  mine = null;  // the recolouring that the visitor tries, or null
  run = 0;

  constructor(programs) {
    this.programs = programs;
    field('example').innerHTML = `<option value="">–</option>${Object.keys(examples).map((name) => `<option>${name}</option>`).join('')}<option value="family">A family: vertex removal for every valence</option>`;
    field('example').onchange = () => {
      const { value } = field('example');
      if (examples[value]) return this.show(new Drawing(structuredClone(examples[value])));
      if (value !== 'family') return undefined;
      field('text').value = family;
      return this.typed();
    };
    field('claims-of').open = innerWidth > 1000;
    field('corners').onchange = () => field('corners').value && this.show(Drawing.outline(+field('corners').value));
    field('undo').onclick = () => this.show(this.past.pop(), false);
    for (const form of document.forms) form.onsubmit = (event) => event.preventDefault();
    for (const id of ['name', 'constraint', 'give_up', 'cost']) field(id).onchange = () => this.choose(id, field(id).value);
    field('text').oninput = () => this.typed();
    field('stop').onclick = () => this.programs.stop();
    for (const side of sides) this.#listen(side);
    field('previous').onclick = () => this.step(-1);
    field('next').onclick = () => this.step(1);
    field('costing').onchange = () => this.step(0);
    field('position').onchange = () => this.place(+field('position').value);
    const paint = (event) => {
      const { inner, port } = event.target.dataset ?? {};
      if ((inner ?? port) === undefined || (event.key && event.key !== 'Enter' && event.key !== ' ')) return;
      event.preventDefault();
      const before = event.currentTarget.id === 'case-before';
      const to = before ? this.case : (this.mine ??= this.rule());
      if (inner !== undefined) to.inner ^= 1 << inner;
      else to.ports ^= 1 << port;
      if (before) this.mine = null;
      this.look();
      field(before ? 'case-before' : 'case-after').querySelector(inner !== undefined ? `[data-inner="${inner}"]` : `[data-port="${port}"]`)?.focus();
    };
    for (const id of ['case-before', 'case-after']) for (const kind of ['click', 'keydown']) field(id).addEventListener(kind, paint);
    field('judge').onclick = () => this.judge();
    field('repair').onclick = () => { this.mine = null; this.look(); };
    field('copy').onclick = async () => {
      const address = await this.link();
      history.replaceState(null, '', address);
      field('copied').textContent = await navigator.clipboard?.writeText(address).then(() => 'copied', () => 'it is in the address bar') ?? 'it is in the address bar';
    };
  }

  // ---- drawing
  #listen(side) {
    const element = field(`draw-${side}`);
    const edit = (change) => {
      const next = this.drawing.copy();
      const refused = change(next);
      if (refused) field('drawn').textContent = refused;
      else this.show(next);
      return !refused;
    };
    const point = (event) => {
      const box = element.querySelector('svg').getBoundingClientRect();
      return [(event.clientX - box.left) * size[0] / box.width, (event.clientY - box.top) * size[1] / box.height];
    };
    const press = (target, at) => {
      const { triangle, flip } = target.dataset;
      if (triangle !== undefined) edit((next) => next.add(side, +triangle, at));
      else if (flip !== undefined) edit((next) => next.flip(side, +flip));
    };
    let drag = null;
    element.addEventListener('pointerdown', (event) => {
      const vertex = event.target.closest('[data-vertex]')?.dataset.vertex;
      if (!vertex) return;
      event.preventDefault();
      drag = { vertex, from: point(event), moved: false, was: this.drawing.copy() };
      element.setPointerCapture(event.pointerId);
    });
    element.addEventListener('pointermove', (event) => {
      if (!drag || Math.hypot(...point(event).map((c, n) => c - drag.from[n])) < 5 && !drag.moved) return;
      drag.moved = true;
      this.drawing.move(drag.vertex, point(event));
      this.draw();
    });
    element.addEventListener('pointerup', () => {
      if (!drag) return;
      const { vertex, moved, was } = drag;
      drag = null;
      if (moved) this.past.push(was), field('undo').disabled = false;
      else if (this.drawing.isInner(side, vertex)) edit((next) => next.remove(side, vertex));
    });
    element.addEventListener('click', (event) => press(event.target, point(event)));
    element.addEventListener('keydown', (event) => {
      const vertex = event.target.dataset.vertex;
      const way = { ArrowLeft: [-8, 0], ArrowRight: [8, 0], ArrowUp: [0, -8], ArrowDown: [0, 8] }[event.key];
      if (vertex && way) {
        this.drawing.move(vertex, this.drawing.places[vertex].map((c, n) => c + way[n]));
        this.draw();
        element.querySelector(`[data-vertex="${vertex}"]`).focus();
      } else if (vertex && (event.key === 'Delete' || event.key === 'Backspace')) edit((next) => next.remove(side, vertex));
      else if (event.key === 'Enter' || event.key === ' ') press(event.target);
      else return;
      event.preventDefault();
    });
  }
  draw() {
    for (const side of sides) field(`draw-${side}`).innerHTML = picture(this.drawing, side, `the patch ${side} the operation`, { edit: true });
  }
  show(drawing, remember = true) {
    if (remember && this.drawing) this.past.push(this.drawing);
    this.drawing = drawing;
    field('undo').disabled = this.past.length === 0;
    this.#drawable(true);
    this.draw();
    field('text').value = drawing.text();
    this.settle();
  }
  /// Sets the choices as the operation has them, and starts the programs.
  settle() {
    const { name = '', constraint = 'strips', give_up: cut = 'none', cost } = this.drawing.operation;
    field('name').value = name;
    field('constraint').value = constraint;
    field('give_up').value = cut === 'all' || cut === 'none' ? cut : 'all';
    field('cost').value = cost === undefined ? '' : JSON.stringify(cost) === JSON.stringify(costs.cuts) ? 'cuts' : 'own';
    this.make();
  }
  choose(id, value) {
    const next = this.drawing.copy();
    if (id === 'cost' && value === '') delete next.operation.cost;
    else if (id !== 'cost' || costs[value]) next.operation[id] = id === 'cost' ? costs[value] : value;
    this.show(next);
  }
  typed() {
    const text = field('text').value;
    let drawing = null;
    try { drawing = Drawing.of(text, this.drawing.places); } catch { /* the generator says what is wrong, and where */ }
    const isWhole = (() => { try { return !!JSON.parse(text); } catch { return false; } })();
    if (!field('drawing').hidden) this.past.push(this.drawing);
    field('undo').disabled = this.past.length === 0;
    this.#drawable(!isWhole || drawing !== null);
    if (!drawing) return this.make(text);
    this.drawing = drawing;
    this.draw();
    return this.settle();
  }
  #drawable(is) {
    field('drawing').hidden = !is;
    field('drawn').textContent = is ? '' : 'Families and graphs are not drawn here; change the file below. Undo goes back to the drawing.';
    if (!is) field('file').open = true;
  }

  // ---- the programs
  /// Generates and proves the text, by default the drawing's.
  async make(text = field('text').value) {
    const run = ++this.run;
    if (this.working) this.programs.stop();
    this.working = true;
    this.made = null;
    this.mine = null;
    const name = `${/"name":\s*"([\w-]+)"/.exec(text)?.[1] ?? 'operation'}.json`;
    field('fault').hidden = true;
    for (const id of ['look', 'take']) field(id).hidden = true;
    field('state').className = '';
    field('state').textContent = 'Generating …';
    field('claims').tBodies[0].innerHTML = '';
    field('claims-head').textContent = 'Claims of the verifier';
    field('stop').hidden = false;
    const begun = performance.now();
    const answer = await this.programs.ask({ what: 'make', name, text, options: { languages } }, ({ label, done, total, claim }) => {
      if (run !== this.run) return;
      field('progress').hidden = false;
      if (label) {
        field('progress').value = done / total;
        return void (field('state').textContent = `Generating: ${label} …`);
      }
      field('state').textContent = 'Proving …';
      field('claims').tBodies[0].insertAdjacentHTML('beforeend', `<tr><td>${claim.holds ? '✓' : '✗'} ${escaped(claim.claim)} <small>${escaped(claim.method)}</small></td><td>${claim.cases.toLocaleString('en')}</td></tr>`);
    });
    if (run !== this.run) return;
    this.working = false;
    field('progress').hidden = true;
    field('stop').hidden = true;
    if (answer.stopped) return void (field('state').textContent = 'Stopped. Change the operation to start again.');
    const error = answer.error ?? answer.verdict.error;
    if (error) {
      field('state').textContent = 'Not an operation that has a table:';
      field('fault').hidden = false;
      const [, line, column] = /:(\d+):(\d+): /.exec(error) ?? [];
      field('fault').innerHTML = `${escaped(error)}${line ? ' <button type="button">Show the place</button>' : ''}`;
      if (line) field('fault').querySelector('button').onclick = () => this.showPlace(+line, +column);
      return;
    }
    const { report: [figures], verdict } = answer;
    this.name = name;
    this.text = text;
    this.made = answer;
    const most = (n, what) => `${n} ${what}${n === 1 ? '' : 's'}`;
    const ok = verdict.failed === 0;
    const twice = verdict.claims.some(({ claim }) => claim === 'the orbits, counted again');
    field('state').className = 'verified';
    field('state').innerHTML = `${ok ? '✓ verified' : '✗ NOT verified'} in ${((performance.now() - begun) / 1000).toFixed(2)} s: ${most(figures.valid, 'case')}, ${most(figures.keys, 'rule')}, `
      + `${figures.worst_strips > 0 ? `at worst ${most(figures.worst_strips, 'strip')} more than before` : 'never more strips than before'}. ${twice ? '' : 'Orbits were not counted twice: this page was built without the source of nauty.'}`;
    field('claims-head').textContent = `${most(verdict.claims.length, 'claim')} of the verifier: ${ok ? 'all hold' : `${verdict.failed} fail`}`;
    if (!ok) {
      field('fault').hidden = false;
      field('fault').textContent = verdict.claims.find(({ holds }) => !holds).counterexample;
    }
    this.take();
    field('take').hidden = false;
    this.tables = JSON.parse(Object.entries(answer.files).find(([file]) => file.endsWith('.json'))[1]);
    const { positions, numbers } = this.tables;
    field('positions').hidden = positions.length === 1;
    field('judge').hidden = positions.length > 1;
    field('position').innerHTML = positions.map((one, n) => `<option value="${n}">${numbers.map((number, i) => `${number} = ${one.numbers[i]}`).join(', ')}</option>`).join('');
    return this.place(0);
  }
  /// Shows the cases of a position.
  place(n) {
    const position = this.tables.positions[n];
    const values = Object.fromEntries(this.tables.numbers.map((number, i) => [number, position.numbers[i]]));
    const at = operationAt(JSON.parse(this.text), values);
    this.shown = at && Drawing.of(JSON.stringify(at), this.tables.numbers.length === 0 ? this.drawing.places : {});
    field('look').hidden = !this.shown;
    const id = this.name.replace('.json', '').replaceAll('-', '_');
    const table = this.tables.numbers.length === 0 ? `restrip::tables::${id}_rules` : `position_of(restrip::tables::${id}_rules, {${position.numbers.join(', ')}})`;
    const [a, b] = this.shown?.operation.before[0] ?? ['from', 'to'];
    field('use').textContent = `#include <cstdio>\n#include <restrip/restrip.hpp>\n#include "${id}.hpp"\n\nrestrip::LiveMesh live(triangles, vertices);\n`
      + `// The side from ${a} to ${b} of the first triangle before the operation.\nconst auto result = live.apply(${table}, live.edge(${a}, ${b}));\n`
      + 'if (!result) std::puts(restrip::describe(result.refusal));\nfor (const auto& range : live.update()) upload(range);\n';
    if (!this.shown) return undefined;
    this.table = { ...this.tables, ...position };
    const { edges } = position.before;
    const { inner } = edgesOf(this.shown.operation.before, this.shown.operation.boundary);
    // The entries of a matching serve all inner edges.
    const isMatching = (one) => Array.from({ length: position.before.triangles }, (_, t) => inner.filter((ends, e) => (one >> e & 1) && ends.slice(0, 2).includes(t)).length).every((solid) => solid < 2);
    this.cases = [];
    for (let one = 0; one < 1 << edges; ++one)
      if (!this.table.matching || isMatching(one))
        for (let ports = 0; ports < 1 << position.ports; ++ports) if (this.rule({ inner: one, ports })) this.cases.push({ inner: one, ports });
    this.case = this.cases[Math.min(1, this.cases.length - 1)];
    this.mine = null;
    return this.look();
  }
  showPlace(line, column) {
    field('file').open = true;
    const lines = field('text').value.split('\n');
    const at = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0) + column - 1;
    field('text').focus();
    field('text').setSelectionRange(at, Math.min(at + 1, field('text').value.length));
  }

  // ---- configurations
  /// The rule of a configuration, or null if it is not valid.
  rule({ inner, ports } = this.case) {
    const { entries, none, first, matching, ports: count } = this.table;
    const entry = entries[first + (matching ? ports : inner << count | ports)];
    return entry === none ? null : { inner: entry >> count, ports: entry & (1 << count) - 1 };
  }
  added({ inner, ports }, rule) {
    const bits = (mask) => hex(mask).split('').reduce((sum, digit) => sum + [0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4][parseInt(digit, 16)], 0);
    return this.table.after.triangles - this.table.before.triangles - bits(rule.inner) - bits(rule.ports) + bits(inner) + bits(ports);
  }
  step(by) {
    const { cases } = this;
    const from = this.number();
    for (let n = by ? 1 : 0; n <= cases.length; ++n) {
      const one = cases[(from + n * (by || 1) + n * cases.length) % cases.length];
      if (field('costing').checked && this.added(one, this.rule(one)) <= 0) continue;
      this.case = one;
      this.mine = null;
      return this.look();
    }
    field('which').textContent = 'no case costs a strip';
    return undefined;
  }
  number() { return Math.max(0, this.cases.findIndex(({ inner, ports }) => inner === this.case.inner && ports === this.case.ports)); }
  async look() {
    const { case: one, shown: drawing } = this;
    const rule = this.rule();
    const colors = this.mine ?? rule;
    field('case-before').innerHTML = picture(drawing, 'before', 'the case before', { colors: one, paint: 'inner ports' });
    field('case-after').innerHTML = picture(drawing, 'after', 'after', { colors: colors ?? { inner: 0, ports: one.ports }, paint: colors ? 'inner' : '' });
    field('which').textContent = rule ? `case ${(this.number() + 1).toLocaleString('en')} of ${this.cases.length.toLocaleString('en')}` : 'not a case';
    field('repair').disabled = !this.mine;
    field('judge').disabled = !this.mine;
    field('broken').textContent = '';
    const request = { before: hex(one.inner), ports: hex(one.ports), numbers: this.table.numbers, ...(colors ? { after: hex(colors.inner), ports_after: hex(colors.ports) } : {}) };
    const run = this.run;
    const told = await this.programs.ask({ what: 'explain', name: this.name, text: this.text, request });
    if (run !== this.run || one !== this.case || told.stopped) return;
    const say = (text) => { field('case').textContent = text; };
    field('why').innerHTML = '';
    if (told.error) return say(told.error);
    if (told.invalid) return say(`Strips cannot look like this: ${told.invalid}.`);
    const added = this.added(one, colors);
    const strips = added === 0 ? 'as many strips as before' : `${Math.abs(added)} strip${Math.abs(added) === 1 ? '' : 's'} ${added > 0 ? 'more' : 'fewer'}`;
    if (this.mine && told.verdict !== 'best') {
      say(`Your rule is ${told.verdict}: ${told.because}.`);
      if (told.obstacle) this.drawSets([told.obstacle], 'The edges that show it, and what is connected outside:');
      return undefined;
    }
    say(`This rule leaves ${strips}. ${told.equally_good > 1 ? `${told.equally_good - 1} other rule${told.equally_good > 2 ? 's are' : ' is'} as good.` : 'Every other rule is unsound or costs more.'}`);
    if (told.sets.length > 0) this.drawSets(told.sets, `${told.cheaper} recolouring${told.cheaper === 1 ? '' : 's'} would cost less; each has all edges of one of these sets, which cannot be:`);
    return undefined;
  }
  drawSets(sets, words) {
    const mask = (text) => parseInt(text, 16);
    field('why').innerHTML = `<p>${words}</p><div class="pictures">${sets.slice(0, 8).map((set) => {
      const edges = { inner: mask(set.inner), ports: mask(set.ports) };
      return `<figure>${picture(this.shown, 'after', escaped(set.why), { colors: edges, marked: edges, world: set.world })}<figcaption>${escaped(set.why)}</figcaption></figure>`;
    }).join('')}</div>${sets.length > 8 ? `<p>And ${sets.length - 8} more.</p>` : ''}`;
  }
  /// The row of the certificate whose key the case has: of the rows with its ports, the one with most of its joined pairs.
  row() {
    const { inner, ports } = this.case;
    const edges = edgesOf(this.drawing.operation.before, this.drawing.operation.boundary);
    const parent = Array.from({ length: this.table.before.triangles }, (_, t) => t);
    const root = (t) => (parent[t] === t ? t : root(parent[t]));
    edges.inner.forEach(([s, t], n) => { if (inner >> n & 1) parent[root(s)] = root(t); });
    let joined = 0n;
    for (let j = 1; j < edges.ports.length; ++j)
      for (let i = 0; i < j; ++i) if ((ports >> i & 1) && (ports >> j & 1) && root(edges.ports[i][0]) === root(edges.ports[j][0])) joined |= 1n << BigInt(j * (j - 1) / 2 + i);
    const within = (row) => (row.joined & ~joined) === 0n;
    const size = (row) => row.joined.toString(2).replaceAll('0', '').length;
    return rowsOf(this.made.certificate).filter((row) => row.ports === ports && within(row)).sort((a, b) => size(b) - size(a))[0];
  }
  async judge() {
    const row = this.row();
    const certificate = changed(this.made.certificate, row.line, this.mine.inner);
    field('broken').textContent = 'Proving …';
    const verdict = await this.programs.ask({ what: 'judge', name: this.name, text: this.text, options: { certificate } });
    field('broken').textContent = verdict.error ?? (verdict.failed === 0 ? verdict.last
      : `${verdict.last.trim()}\n\n${verdict.claims.filter(({ holds }) => !holds).map(({ claim, counterexample }) => `✗ ${claim}\n${counterexample}`).join('\n')}`);
  }

  // ---- results
  take() {
    const { files, bytes } = this.made;
    const looked = Object.entries(files).filter(([path]) => !path.includes('restrip_check_of_'));  // programs that a build runs
    const all = [[this.name, this.text], ...looked, ...Object.entries(bytes).map(([name, list]) => [name, new Uint8Array(list)])];
    for (const link of field('downloads').querySelectorAll('a')) URL.revokeObjectURL(link.href);
    field('downloads').innerHTML = all.map(([path, content], n) => {
      const file = escaped(path.split('/').at(-1));
      return `<a class="button" download="${file}" href="${URL.createObjectURL(new Blob([content]))}">${n === 0 ? 'operation file' : kinds[file.split('.').at(-1)]} <small>${file}</small></a>`;
    }).join(' ');
  }
  async link() {
    const state = JSON.stringify({ text: this.text ?? field('text').value, places: this.drawing.places }, (_, value) => (typeof value === 'number' ? Math.round(value) : value));
    const packed = await new Response(new Blob([state]).stream().pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer();
    return `${location.href.replace(/#.*/, '')}#operation=${btoa(String.fromCharCode(...new Uint8Array(packed))).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
  }
  static async linked() {
    const packed = /^#operation=([\w-]+)$/.exec(location.hash)?.[1];
    if (!packed) return null;
    const bytes = Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    return JSON.parse(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text());
  }
}

const [compiled, linked] = await Promise.all([embedded('wasm').then(WebAssembly.compile), Page.linked().catch(() => null)]);
const page = new Page(new Programs(compiled));
window.restripMaker = page;
const first = linked && (() => { try { return Drawing.of(linked.text, linked.places); } catch { return null; } })();
if (!linked) field('example').value = 'Face split';
page.show(first ?? new Drawing(structuredClone(examples['Face split'])));
if (linked && !first) field('text').value = linked.text, page.typed();

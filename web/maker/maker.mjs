// The page "Make a rule".
import { load } from '../../bindings/js/restrip.mjs';
import { embedded } from '../viewer/embedded.mjs';
import { Drawing, addedBy, edgesOf, operationAt, picture, ruleOf, sides, size } from './surface.mjs';
import { Trial } from './trial.mjs';

const field = (id) => document.getElementById(id);
const base = { restrip_operation: 1, constraint: 'strips' };
const star = (k) => [...'abcdef'.slice(0, k)].map((name, i, all) => [name, all[(i + 1) % k], 'm']);
const quad = [['a', 'b', 'c'], ['b', 'a', 'd']];
/// Those that say `give_up` have cases in which no repair keeps all strips.
const examples = {
  'Edge flip': { ...base, name: 'my-edge-flip', before: quad, after: [['c', 'd', 'b'], ['d', 'c', 'a']], give_up: 'all' },
  'Face split': { ...base, name: 'my-face-split', before: [['a', 'b', 'c']], after: [['a', 'b', 'm'], ['b', 'c', 'm'], ['m', 'c', 'a']] },
  Bisection: { ...base, name: 'my-bisection', before: quad, after: [['b', 'c', 'm'], ['c', 'a', 'm'], ['a', 'd', 'm'], ['m', 'd', 'b']] },
  '4 to 2': { ...base, name: 'my-4-to-2', before: star(4), after: [['a', 'b', 'c'], ['c', 'd', 'a']], give_up: 'all' },
  'Vertex removal': { ...base, name: 'my-vertex-removal', before: star(5), after: [['a', 'b', 'c'], ['a', 'c', 'd'], ['a', 'd', 'e']], give_up: 'all' },
  'Hexagon fan': { ...base, name: 'my-hexagon-fan', before: star(6), after: [['a', 'b', 'c'], ['a', 'c', 'd'], ['a', 'd', 'e'], ['a', 'e', 'f']], give_up: 'all' },
};
const family = `{
  "restrip_operation": 1,
  "name": "my-vertex-removals",
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
const counted = (n, what) => `${n.toLocaleString('en')} ${what}${n === 1 ? '' : 's'}`;
const parsed = (text) => { try { return JSON.parse(text); } catch { return null; } };

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
  states = [];  // { text, places, step }: what can be undone and redone
  at = -1;
  drawing = null;  // of the text, or null if it is not drawn
  made = null;
  mine = null;  // the recolouring that the visitor tries, or null
  run = 0;

  constructor(programs, restrip) {
    this.programs = programs;
    this.#fillGallery();
    field('undo').onclick = () => this.travel(-1);
    field('redo').onclick = () => this.travel(1);
    addEventListener('keydown', (event) => {
      const key = event.key.toLowerCase();
      if (!(event.ctrlKey || event.metaKey) || event.altKey || !['z', 'y'].includes(key) || event.target.id === 'name') return;
      event.preventDefault();
      this.travel(key === 'y' || event.shiftKey ? 1 : -1);
    });
    addEventListener('hashchange', () => this.follow());
    for (const form of document.forms) form.onsubmit = (event) => event.preventDefault();
    for (const id of ['name', 'constraint', 'give_up', 'cost']) field(id).onchange = () => this.choose(id, field(id).value);
    field('allow').onclick = () => {
      this.choose('give_up', 'all');
      field('proof').querySelector('summary').focus();
    };
    field('text').oninput = () => this.set({ text: field('text').value, step: 'typed' });
    field('stop').onclick = () => this.programs.stop();
    for (const side of sides) this.#listen(side);
    field('previous').onclick = () => this.step(-1);
    field('next').onclick = () => this.step(1);
    field('costing').onchange = () => this.step(0);
    field('position').onchange = () => this.place(+field('position').value);
    for (const side of ['before', 'after', 'mine']) for (const kind of ['click', 'keydown']) field(`case-${side}`).addEventListener(kind, (event) => this.#paint(side, event));
    this.trial = new Trial(restrip, field('sheet'), (text) => { field('tried').textContent = text; });
    field('back').onclick = () => this.trial.undo();
    field('repair').onclick = () => { this.mine = null; this.look(); };
    field('copy').onclick = async () => {
      await this.address();
      field('copied').textContent = await navigator.clipboard?.writeText(location.href).then(() => 'copied', () => 'it is in the address bar') ?? 'it is in the address bar';
    };
  }
  #fillGallery() {
    const small = (operation) => sides.map((side) => picture(new Drawing(structuredClone(operation)), side, '')).join('<b aria-hidden="true">→</b>');
    const button = (name, pictures, note = '') => `<button type="button" value="${name}"><span class="two">${pictures}</span>${name}${note && `<small>${note}</small>`}</button>`;
    field('gallery').innerHTML = Object.entries(examples).map(([name, one]) => button(name, small(one), one.give_up && 'strips may be cut')).join('') +
      button('Family', '<b>k → k − 2</b>', 'for every k') +
      `<select id="corners" aria-label="Begin with an empty outline"><option value="">Empty outline</option>${[3, 4, 5, 6, 7, 8].map((n) => `<option value="${n}">${n} corners</option>`).join('')}</select>`;
    for (const svg of field('gallery').querySelectorAll('svg')) svg.setAttribute('aria-hidden', 'true');
    field('gallery').onclick = ({ target }) => {
      const name = target.closest('button')?.value;
      if (name) this.set(name === 'Family' ? { text: family } : Page.drawn(new Drawing(structuredClone(examples[name]))));
    };
    field('corners').onchange = () => {
      if (field('corners').value) this.set(Page.drawn(Drawing.outline(+field('corners').value)));
      field('corners').value = '';
    };
  }

  // ---- states
  static drawn(drawing, step = '') { return { text: drawing.text(), places: drawing.places, step }; }
  /// Continues with a state, which can be undone. One that follows a state of the same step takes its place.
  set({ text, places = this.drawing?.places ?? {}, step = '' }, focus = null) {
    const merges = step !== '' && this.states[this.at]?.step === step;
    this.states.splice(merges ? this.at : this.at + 1, Infinity, { text, places: { ...places }, step });
    this.at = this.states.length - 1;
    this.#show(focus);
  }
  travel(by) {
    if (!this.states[this.at + by]) return;
    this.at += by;
    this.#show();
    this.states[this.at].step = '';  // what follows is a step of its own
  }
  #show(focus = null) {
    const { text, places } = this.states[this.at];
    const operation = parsed(text);
    try { this.drawing = operation && Drawing.of(text, places); } catch { this.drawing = null; /* the generator says what is wrong, and where */ }
    field('undo').disabled = this.at === 0;
    field('redo').disabled = this.at + 1 === this.states.length;
    field('drawing').hidden = operation && !this.drawing;
    field('drawn').textContent = operation && !this.drawing ? 'Families are not drawn here. Change the operation file below.' : '';
    if (!this.drawing) field('file').open = true;
    if (field('text').value !== text) field('text').value = text;
    if (operation) {
      const { name = '', constraint = 'strips', give_up: cut = 'none', cost } = operation;
      field('name').value = name;
      field('constraint').value = constraint;
      field('give_up').value = cut === 'none' ? cut : 'all';
      field('cost').value = cost === undefined ? '' : JSON.stringify(cost) === JSON.stringify(costs.cuts) ? 'cuts' : 'own';
    }
    this.draw(focus);
    this.address();
    if (text !== this.asked) this.make(text);
    else if (this.shown && this.drawing) {  // vertices were moved
      this.shown = this.drawing;
      this.try();
      this.look();
    }
  }
  choose(id, value) {
    const operation = parsed(field('text').value);
    if (!operation || (id === 'cost' && value === 'own')) return;
    if (id === 'cost' && value === '') delete operation.cost;
    else operation[id] = id === 'cost' ? costs[value] : value;
    this.set(this.drawing ? Page.drawn(new Drawing(operation, this.drawing.places)) : { text: `${JSON.stringify(operation, null, 2)}\n` });
  }
  /// The address of what is on the page, which a reload and a copied link show again.
  async address() {
    const { text, places } = this.states[this.at];
    const state = JSON.stringify({ text, places }, (_, value) => (typeof value === 'number' ? Math.round(value) : value));
    const packed = await new Response(new Blob([state]).stream().pipeThrough(new CompressionStream('deflate-raw'))).arrayBuffer();
    if (this.states[this.at].text !== text) return;
    history.replaceState(null, '', `#operation=${btoa(String.fromCharCode(...new Uint8Array(packed))).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`);
  }
  /// Shows what the address says. False: nothing, or it is damaged.
  async follow() {
    const packed = /^#operation=(.+)$/.exec(location.hash)?.[1];
    if (!packed) return false;
    try {
      const bytes = Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
      this.set(JSON.parse(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text()));
      return true;
    } catch {
      field('drawn').textContent = 'The link is damaged: it does not contain a whole operation.';
      return false;
    }
  }

  // ---- drawing
  #listen(side) {
    const element = field(`draw-${side}`);
    /// `focus`: a selector of what has the focus afterwards.
    const edit = (change, focus) => {
      const next = this.drawing.copy();
      const refused = change(next);
      if (refused) field('drawn').textContent = refused;
      else this.set(Page.drawn(next), focus && `#draw-${side} ${focus(next)}`);
    };
    const point = (event) => {
      const box = element.querySelector('svg').getBoundingClientRect();
      return [(event.clientX - box.left) * size[0] / box.width, (event.clientY - box.top) * size[1] / box.height];
    };
    const press = (target, at) => {
      const { triangle, flip } = target.dataset;
      const known = this.drawing.vertices(side);
      if (triangle !== undefined) edit((next) => next.add(side, +triangle, at), (next) => `[data-vertex="${next.vertices(side).find((name) => !known.includes(name))}"]`);
      else if (flip !== undefined) edit((next) => next.flip(side, +flip), (next) => {
        const was = new Set(edgesOf(this.drawing.operation[side]).inner.map(([, , ...ends]) => ends.sort().join()));
        return `[data-flip="${edgesOf(next.operation[side]).inner.findIndex(([, , ...ends]) => !was.has(ends.sort().join()))}"]`;
      });
    };
    let drag = null;
    element.addEventListener('pointerdown', (event) => {
      const vertex = event.target.closest('[data-vertex]')?.dataset.vertex;
      if (!vertex) return;
      event.preventDefault();
      drag = { vertex, from: point(event), moved: false };
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
      const { vertex, moved } = drag;
      drag = null;
      if (moved) this.set(Page.drawn(this.drawing));
      else if (this.drawing.isInner(side, vertex)) edit((next) => next.remove(side, vertex));
    });
    element.addEventListener('click', (event) => press(event.target, point(event)));
    element.addEventListener('keydown', (event) => {
      const vertex = event.target.dataset.vertex;
      const way = { ArrowLeft: [-8, 0], ArrowRight: [8, 0], ArrowUp: [0, -8], ArrowDown: [0, 8] }[event.key];
      if (vertex && way) {
        const refused = this.drawing.move(vertex, this.drawing.places[vertex].map((c, n) => c + way[n]));
        if (refused) field('drawn').textContent = refused;
        else this.set(Page.drawn(this.drawing, `${side} ${vertex}`));
      } else if (vertex && (event.key === 'Delete' || event.key === 'Backspace')) edit((next) => next.remove(side, vertex));
      else if (event.key === 'Enter' || event.key === ' ') press(event.target);
      else return;
      event.preventDefault();
    });
  }
  /// What has the focus keeps it, or its side of the drawing.
  draw(focus = null) {
    const { activeElement: active } = document;
    const side = sides.find((one) => field(`draw-${one}`).contains(active));
    const [name, value] = Object.entries(active?.dataset ?? {})[0] ?? [];
    for (const one of sides) field(`draw-${one}`).innerHTML = this.drawing ? picture(this.drawing, one, `the patch ${one} the operation`, { edit: true }) : '';
    if (side) (document.querySelector(focus ?? `#draw-${side} [data-${name}="${value}"]`) ?? field(`draw-${side}`).querySelector('[tabindex]') ?? field('undo')).focus();
  }
  #paint(side, event) {
    const { inner, port } = event.target.dataset ?? {};
    if ((inner ?? port) === undefined || (event.key && event.key !== 'Enter' && event.key !== ' ')) return;
    event.preventDefault();
    this.mine = side === 'before' ? null : { ...(side === 'mine' ? this.mine : this.rule()) };
    const to = this.mine ?? (this.case = { ...this.case });
    if (inner !== undefined) to.inner ^= 1 << inner;
    else to.ports ^= 1 << port;
    this.look();
    field(side === 'before' ? 'case-before' : 'case-mine').querySelector(inner !== undefined ? `[data-inner="${inner}"]` : `[data-port="${port}"]`)?.focus();
  }

  // ---- the programs
  /// Generates and proves the text.
  async make(text) {
    const run = ++this.run;
    if (this.working) this.programs.stop();
    this.working = true;
    this.asked = text;
    this.made = this.shown = this.mine = null;
    const name = `${/"name":\s*"([\w-]+)"/.exec(text)?.[1] ?? 'operation'}.json`;
    for (const id of ['fault', 'look', 'try', 'take', 'impossible']) field(id).hidden = true;
    field('state').className = '';
    field('state').textContent = 'Generating …';
    for (const id of ['counted', 'case', 'verdict', 'why']) field(id).textContent = '';
    field('claims').tBodies[0].innerHTML = '';
    field('stop').hidden = false;
    const begun = performance.now();
    const answer = await this.programs.ask({ what: 'make', name, text, options: { languages } }, ({ label, done, total, claim }) => {
      if (run !== this.run) return;
      field('progress').hidden = false;
      if (label) {
        field('progress').value = done / total;
        return void (field('state').textContent = `Working: ${label} …`);
      }
      field('state').textContent = 'Proving …';
      field('claims').tBodies[0].insertAdjacentHTML('beforeend', `<tr><td>${claim.holds ? '✓' : '✗'} ${escaped(claim.claim)}</td><td>${escaped(claim.method)}</td><td>${claim.cases.toLocaleString('en')}</td></tr>`);
    });
    if (run !== this.run) return;
    this.working = false;
    field('progress').hidden = true;
    field('stop').hidden = true;
    if (answer.stopped) return void (field('state').textContent = 'Stopped. Change the operation to start again.');
    this.name = name;
    this.text = text;
    const error = answer.error ?? answer.verdict.error;
    if (error) return this.#refused(error);
    const { report: [figures], verdict } = answer;
    this.made = answer;
    const ok = verdict.failed === 0;
    field('state').className = 'verified';
    field('state').textContent = `${ok ? '✓ proved' : '✗ NOT proved'}, ${counted(figures.valid, 'case')}, in ${((performance.now() - begun) / 1000).toFixed(2)} s: `
      + `${figures.worst_strips > 0 ? `at worst ${counted(figures.worst_strips, 'strip')} more than before` : 'never more strips than before'}`;
    field('counted').textContent = `${counted(figures.keys, 'rule')}; ${counted(verdict.claims.length, 'claim')} of the verifier, of which ${ok ? 'all hold' : `${verdict.failed} fail`}.`;
    if (!ok) {
      field('fault').hidden = false;
      field('fault').textContent = verdict.claims.find(({ holds }) => !holds).counterexample;
    }
    this.take();
    field('take').hidden = false;
    this.tables = JSON.parse(Object.entries(answer.files).find(([file]) => file.endsWith('.json'))[1]);
    const { positions, numbers } = this.tables;
    field('positions').hidden = positions.length === 1;
    field('position').innerHTML = positions.map((one, n) => `<option value="${n}">${numbers.map((number, i) => `${number} = ${one.numbers[i]}`).join(', ')}</option>`).join('');
    return this.place(0);
  }
  /// The generator's sentence; if a case has no rule, the case as well, and what stands in its way.
  async #refused(error) {
    const [, inner, ports] = /the configuration ([0-9a-f]+) ([0-9a-f]+) .*has no sound recolouring/.exec(error) ?? [];
    if (!inner) {
      field('state').textContent = 'Not an operation that has a table:';
      field('fault').hidden = false;
      const [, line, column] = /:(\d+):(\d+): /.exec(error) ?? [];
      field('fault').innerHTML = `${escaped(error)}${line ? ' <button type="button">Show the place</button>' : ''}`;
      if (line) field('fault').querySelector('button').onclick = () => this.showPlace(+line, +column);
      return;
    }
    field('state').textContent = 'No rule: in some case no repair keeps every strip that enters the patch.';
    field('impossible').hidden = false;
    field('hindrance').innerHTML = '';
    if (!this.drawing) return;
    const { run } = this;
    const { sets = [] } = await this.programs.ask({ what: 'explain', name: this.name, text: this.text, request: { before: inner, ports, numbers: [] } });
    if (run !== this.run) return;
    const colors = { inner: parseInt(inner, 16), ports: parseInt(ports, 16) };
    field('hindrance').innerHTML = `<div class="pictures draw"><figure>${picture(this.drawing, 'before', 'the case that has no rule', { colors })}<figcaption>The case: all its ports stay solid.</figcaption></figure></div>
      <p>After the operation, every choice of solid edges has one of these faults:</p>${this.sets(sets, this.drawing)}`;
  }
  /// Shows the cases of a position.
  place(n) {
    const position = this.position = this.tables.positions[n];
    const values = Object.fromEntries(this.tables.numbers.map((number, i) => [number, position.numbers[i]]));
    const at = operationAt(JSON.parse(this.text), values);
    this.shown = at && Drawing.of(JSON.stringify(at), this.tables.numbers.length === 0 ? this.drawing?.places : {});
    field('look').hidden = !this.shown;
    field('try').hidden = !this.shown || this.tables.matching;  // a mesh of the library has strips
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
    this.try();
    this.case = { ...this.cases[Math.min(1, this.cases.length - 1)] };
    this.mine = null;
    return this.look();
  }
  try() {
    if (!this.tables.matching) this.trial.begin(this.shown, { ...this.tables, positions: [this.position] });
  }
  showPlace(line, column) {
    field('file').open = true;
    const lines = field('text').value.split('\n');
    const at = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0) + column - 1;
    field('text').focus();
    field('text').setSelectionRange(at, Math.min(at + 1, field('text').value.length));
  }

  // ---- configurations
  rule(configuration = this.case) { return ruleOf(this.table, configuration); }
  step(by) {
    const { cases } = this;
    const from = this.number();
    for (let n = by ? 1 : 0; n <= cases.length; ++n) {
      const one = cases[(from + n * (by || 1) + n * cases.length) % cases.length];
      if (field('costing').checked && addedBy(this.table, one, this.rule(one)) <= 0) continue;
      this.case = { ...one };
      this.mine = null;
      return this.look();
    }
    field('which').textContent = 'no case costs a strip';
    return undefined;
  }
  number() { return Math.max(0, this.cases.findIndex(({ inner, ports }) => inner === this.case.inner && ports === this.case.ports)); }
  async look() {
    const { case: one, shown: drawing, mine } = this;
    const rule = this.rule();
    field('case-before').innerHTML = picture(drawing, 'before', 'the case before', { colors: one, paint: 'inner ports' });
    field('case-after').innerHTML = picture(drawing, 'after', 'after, by the best rule', { colors: rule ?? { inner: 0, ports: one.ports }, paint: rule ? 'inner' : '' });
    field('mine').hidden = field('repair').hidden = !mine;
    if (mine) field('case-mine').innerHTML = picture(drawing, 'after', 'after, by your rule', { colors: mine, paint: 'inner' });
    field('which').textContent = rule ? `case ${(this.number() + 1).toLocaleString('en')} of ${this.cases.length.toLocaleString('en')}` : 'not a case';
    const request = (colors) => ({ before: hex(one.inner), ports: hex(one.ports), numbers: this.table.numbers, ...(colors ? { after: hex(colors.inner), ports_after: hex(colors.ports) } : {}) });
    const run = this.run;
    const explained = await this.programs.ask({ what: 'explain', name: this.name, text: this.text, request: request(mine ?? rule) });
    if (run !== this.run || one !== this.case || mine !== this.mine || explained.stopped) return;
    const say = (text, verdict = '') => {
      field('case').textContent = text;
      field('verdict').textContent = verdict;
    };
    field('why').innerHTML = '';
    if (explained.error) return say(explained.error);
    if (explained.invalid) return say(`Strips cannot look like this: ${explained.invalid}.`);
    const strips = (colors) => {
      const added = addedBy(this.table, one, colors);
      return added === 0 ? 'as many strips as before' : `${counted(Math.abs(added), 'strip')} ${added > 0 ? 'more' : 'fewer'}`;
    };
    const best = `The best rule leaves ${strips(rule)}.`;
    const { sets, cheaper, equally_good: good, verdict, because, obstacle } = explained;
    if (!mine) {
      say(`${best} ${good > 1 ? `${good - 1} other rule${good > 2 ? 's are' : ' is'} as good.` : 'Every other rule is unsound or costs more.'}`);
      if (sets.length > 0) field('why').innerHTML = `<p>${counted(cheaper, 'recolouring')} would cost less; each has all edges of one of these sets, which cannot be:</p>${this.sets(sets)}`;
      return undefined;
    }
    say(best, verdict === 'best' || verdict === 'equally good' ? `Your rule leaves ${strips(mine)}, and is as good.` : `Your rule is ${verdict}: ${because}.`);
    if (obstacle) field('why').innerHTML = `<p>The edges that show it, and what is connected outside:</p>${this.sets([obstacle])}`;
    return undefined;
  }
  /// Pictures of edges that cannot all be solid, each in its world.
  sets(sets, drawing = this.shown) {
    const mask = (text) => parseInt(text, 16);
    return `<div class="pictures sets">${sets.slice(0, 8).map((set) => {
      const edges = { inner: mask(set.inner), ports: mask(set.ports) };
      return `<figure>${picture(drawing, 'after', escaped(set.why), { colors: edges, marked: edges, world: set.world })}<figcaption>${escaped(set.why)}</figcaption></figure>`;
    }).join('')}</div>${sets.length > 8 ? `<p>And ${sets.length - 8} more.</p>` : ''}`;
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
}

const page = new Page(new Programs(await WebAssembly.compile(await embedded('programs'))), await load(await embedded('library')));
window.restripMaker = page;
if (!await page.follow()) {
  const damaged = field('drawn').textContent;
  page.set(Page.drawn(new Drawing(structuredClone(examples['Edge flip']))));
  if (damaged) field('drawn').textContent = `${damaged} This is an example.`;
}

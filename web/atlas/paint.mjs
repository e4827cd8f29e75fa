// Painting a configuration of any family: its rule, or why strips cannot have it. The address names it.
import { load } from '../../bindings/js/restrip.mjs';
import { embedded } from '../viewer/embedded.mjs';
import { Patch, fanPicture, has, middle, representative, ringPicture, ruleName } from '../viewer/patch.mjs';

const field = (id) => document.getElementById(id);
const largestSplit = 24;

/// A side as drawn by scripts/surfaces.py; `click`: its edges and ports can be clicked.
function sidePicture({ corners, triangles, edges, ports }, inner, solid, description, click = false) {
  const patch = new Patch();
  for (const [a, b, c, style] of triangles) patch.add(corners[a], corners[b], corners[c], style);
  edges.forEach(([u, v, a, b], n) => {
    const across = middle(corners[a], corners[b]);
    patch.join(u, v, across, has(inner, n) ? 'solid' : 'dashed');
    if (click) patch.hit(`loop ${n}`, `inner edge ${n}`, has(inner, n), [patch.nodes[u], across, patch.nodes[v]]);
  });
  ports.forEach(([u, a, b], n) => {
    const outside = patch.port(u, corners[a], corners[b], has(solid, n) ? 'solid' : 'dashed');
    if (click) patch.hit(`port ${n}`, `port ${n}`, has(solid, n), [patch.nodes[u], outside]);
  });
  return patch.svg(description);
}
/// The closed fan of a split, of which only the neighbours are needed.
const fanOf = (k) => ({ triangles: Array.from({ length: k }), edges: Array.from({ length: k }, (_, i) => [i, (i + 1) % k]), ports: Array.from({ length: k }, (_, i) => [i]) });

/// A sentence for colours that strips cannot have, or null.
function whyInvalid({ triangles, edges, ports }, inner, solid) {
  const degree = triangles.map((_, t) => ports.filter(([owner], n) => owner === t && has(solid, n)).length);
  const root = triangles.map((_, t) => t);
  let cycle = false;
  edges.forEach(([u, v], n) => {
    if (!has(inner, n)) return;
    ++degree[u];
    ++degree[v];
    const [from, to] = [root[u], root[v]];
    cycle ||= from === to;
    root.forEach((one, t) => { if (one === from) root[t] = to; });
  });
  const branching = degree.findIndex((solids) => solids > 2);
  if (branching >= 0) return `triangle ${branching} has three solid lines; a strip enters a triangle once and leaves it once`;
  return cycle ? 'the strip closes a cycle, and has no end' : null;
}

class Painter {
  edges = 0n;
  ports = 0n;

  constructor(restrip, drawn) {
    Object.assign(this, { restrip, drawn });
    field('family').innerHTML = Object.keys(drawn).map((name) => `<option value="${name}">${name.replace('-', ' ')}</option>`).join('');
    field('family').addEventListener('change', () => this.begin());
    field('position').addEventListener('change', () => this.set(0n, 0n));
    for (const id of ['k', 'a']) field(id).addEventListener('input', () => this.set(this.edges, this.ports));
    field('clear').addEventListener('click', () => this.set(0n, 0n));
    field('random').addEventListener('click', () => this.another());
    const press = (event) => {
      const edge = event.target.dataset?.edge;
      if (!edge || (event.key && event.key !== 'Enter' && event.key !== ' ')) return;
      event.preventDefault();
      const [what, i] = edge.split(' ');
      const bit = 1n << BigInt(i);
      if (what === 'loop') this.set(this.edges ^ bit, this.ports);
      else this.set(this.edges, this.ports ^ bit);
      field('before').querySelector(`[data-edge="${edge}"]`).focus();
    };
    field('before').addEventListener('click', press);
    field('before').addEventListener('keydown', press);
    addEventListener('hashchange', () => this.follow());
    if (!this.follow()) this.set(0b010111n, 0b001000n);
  }
  get family() { return field('family').value; }
  get k() { return Math.max(3, Math.min(largestSplit, +field('k').value || 3)); }
  get a() { return Math.max(1, Math.min(Math.floor(this.k / 2), +field('a').value || 1)); }
  /// The position: its numbers, its sides.
  get place() {
    if (this.family === 'split') return { k: this.k, a: this.a, before: fanOf(this.k) };
    const [text, before, after] = this.drawn[this.family][+field('position').value || 0];
    const [k, first, second] = text.match(/\d+/g)?.map(Number) ?? [];
    return { k, a: first, i: first, j: second, before, after };
  }
  begin() {
    const { family } = this;
    field('split').hidden = family !== 'split';
    field('position').closest('label').hidden = family === 'split' || this.drawn[family].length === 1;
    field('position').innerHTML = this.drawn[family].map(([text], n) => `<option value="${n}">${text}</option>`).join('');
    this.set(0n, 0n);
  }
  set(edges, ports) {
    const { before } = this.place;
    const within = (mask, { length }) => mask & (1n << BigInt(length)) - 1n;
    this.edges = within(edges, before.edges);
    this.ports = within(ports, before.ports);
    field('a').max = Math.floor(this.k / 2);
    this.show();
    const numbers = this.family === 'split' ? { k: this.k, a: this.a } : { at: this.drawn[this.family][+field('position').value || 0][0].replaceAll(' ', '-') };
    history.replaceState(null, '', `#${new URLSearchParams({ family: this.family, ...numbers, edges: this.edges.toString(16), ports: this.ports.toString(16) })}`);
  }
  /// Whether the address names a configuration, which is shown then.
  follow() {
    const { family, k, a, at, edges, ports } = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    if (!Object.hasOwn(this.drawn, family ?? '') || ![edges, ports].every((mask) => /^[0-9a-f]{1,15}$/.test(mask ?? ''))) return false;
    field('family').value = family;
    field('k').value = k ?? 6;
    field('a').value = a ?? 3;
    this.begin();
    field('position').value = Math.max(0, this.drawn[family].findIndex(([text]) => text.replaceAll(' ', '-') === at));
    this.set(BigInt(`0x${edges}`), BigInt(`0x${ports}`));
    return true;
  }
  another() {
    const { before } = this.place;
    const random = ({ length }, share) => Array.from({ length }).reduce((mask, _, i) => (Math.random() < share ? mask | 1n << BigInt(i) : mask), 0n);
    let [edges, ports] = [0n, 0n];
    do [edges, ports] = [random(before.edges, 0.45), random(before.ports, 0.4)]; while (whyInvalid(before, edges, ports));
    this.set(edges, ports);
  }
  show() {
    const { family, edges, ports, place } = this;
    const { k, a, i, j, before, after } = place;
    const isSplit = family === 'split';
    const what = family.replace('-', ' ');
    field('before').innerHTML = isSplit ? fanPicture(k, a, edges, ports, `before the ${what}`, { click: true }) : sidePicture(before, edges, ports, `before the ${what}`, true);
    const rule = this.restrip.rule({ family, k, a, i, j, edges, ports });
    const why = whyInvalid(before, edges, ports);
    if (rule.valid !== (why === null)) throw new Error('page and library disagree on what is valid');
    field('after-what').textContent = `after the ${what}`;
    if (why) {
      field('after').innerHTML = '';
      field('verdict').textContent = `No strips have these colours: ${why}.`;
      return;
    }
    field('after').innerHTML = isSplit ? ringPicture(k, a, rule.colors, ports, `after the ${what}`) : sidePicture(after, rule.colors, rule.ports, `after the ${what}`);
    const change = rule.strips === 0 ? 'The number of strips stays the same' :
      rule.strips > 0 ? `The ${what} costs ${rule.strips} strip: no colouring of this patch is safe and keeps all of them` :
        `There ${rule.strips === -1 ? 'is 1 strip' : `are ${-rule.strips} strips`} fewer`;
    field('verdict').innerHTML = `${change}. ${isSplit ? this.#named(k, a) : { collapse: `<a href="collapse-${k}.html">The rules of these collapses</a>`, flip: '<a href="flip.html">The rules of flips</a>' }[family] ?? 'The automaton computed this rule.'}`;
  }
  /// A link to the rule of a split.
  #named(k, a) {
    if (k > 8) return 'Tables end at smaller vertices: the automaton computed this rule, and it is equally exact.';
    const key = representative(k, a, this.edges, this.ports);
    const name = ruleName(k, a, key);
    const itself = key.ports === this.ports && representative(k, a, this.edges, this.ports, true).joined === key.joined;
    return `Rule <a href="split-${k}-${a}.html#${name}">${name}</a>${itself ? '' : ', seen in a mirror or turned'}.`;
  }
}

try {
  const [restrip, drawn] = await Promise.all([embedded('wasm').then(load), embedded('drawn').then((bytes) => JSON.parse(new TextDecoder().decode(bytes)))]);
  window.restripPainter = new Painter(restrip, drawn);
} catch (error) {
  field('verdict').textContent = error.message;
  console.error(error);
}

// Painting a configuration: its rule, or why strips cannot have it.
import { load } from '../../bindings/js/restrip.mjs';
import { embedded } from '../viewer/embedded.mjs';
import { fanPicture, has, listed, representative, ringPicture, ruleName } from '../viewer/patch.mjs';

const field = (id) => document.getElementById(id);

/// A sentence for colours that strips cannot have, or null.
function whyInvalid(k, loop, ports) {
  for (let i = 0; i < k; ++i)
    if (has(loop, i) && has(loop, (i + k - 1) % k) && has(ports, i))
      return `triangle ${i} has three solid lines; a strip enters a triangle once and leaves it once`;
  return loop === (1n << BigInt(k)) - 1n ? 'the strip around the vertex closes a cycle, and has no end' : null;
}

class Painter {
  loop = 0n;
  ports = 0n;

  constructor(restrip) {
    this.restrip = restrip;
    for (const id of ['k', 'a']) field(id).addEventListener('input', () => this.resize());
    field('clear').addEventListener('click', () => this.set(0n, 0n));
    field('random').addEventListener('click', () => this.another());
    const press = (event) => {
      const edge = event.target.dataset?.edge;
      if (!edge || (event.key && event.key !== 'Enter' && event.key !== ' ')) return;
      event.preventDefault();
      const [what, i] = edge.split(' ');
      if (what === 'loop') this.loop ^= 1n << BigInt(i);
      else this.ports ^= 1n << BigInt(i);
      this.show();
      field('before').querySelector(`[data-edge="${edge}"]`).focus();
    };
    field('before').addEventListener('click', press);
    field('before').addEventListener('keydown', press);
    this.set(0b010111n, 0b001000n);
  }
  get k() { return Math.max(3, Math.min(24, +field('k').value || 3)); }
  get a() { return Math.max(1, Math.min(Math.floor(this.k / 2), +field('a').value || 1)); }
  set(loop, ports) {
    this.loop = loop;
    this.ports = ports;
    this.show();
  }
  resize() {
    field('a').max = Math.floor(this.k / 2);
    const all = (1n << BigInt(this.k)) - 1n;
    this.set(this.loop & all, this.ports & all);
  }
  another() {
    const { k } = this;
    do {
      this.loop = this.ports = 0n;
      for (let i = 0; i < k; ++i) {
        if (Math.random() < 0.6) this.loop |= 1n << BigInt(i);
        if (Math.random() < 0.4) this.ports |= 1n << BigInt(i);
      }
      for (let i = 0; i < k; ++i)
        if (has(this.loop, i) && has(this.loop, (i + k - 1) % k)) this.ports &= ~(1n << BigInt(i));
    } while (whyInvalid(k, this.loop, this.ports));
    this.show();
  }
  show() {
    const { k, a, loop, ports } = this;
    field('before').innerHTML = fanPicture(k, a, loop, ports, 'before the split', { click: true });
    const rule = this.restrip.rule({ family: 'split', k, a, edges: loop, ports });
    const why = whyInvalid(k, loop, ports);
    if (rule.valid !== (why === null)) throw new Error('page and library disagree on what is valid');
    if (why) {
      field('after').innerHTML = '';
      field('verdict').textContent = `No strips have these colours: ${why}.`;
      return;
    }
    field('after').innerHTML = ringPicture(k, a, rule.colors, ports, 'after the split');
    const change = rule.strips === 0 ? 'The number of strips stays the same' :
      rule.strips > 0 ? `The split costs ${rule.strips} strip: no colouring of this patch is safe and keeps all of them` :
        `There ${rule.strips === -1 ? 'is 1 strip' : `are ${-rule.strips} strips`} fewer`;
    const key = representative(k, a, loop, ports);
    const name = ruleName(k, a, key);
    field('verdict').innerHTML = `${change}. ` + (k <= 8
      ? `Rule <a href="split-${k}-${a}.html#${name}">${name}</a>${this.#isItself(key) ? '' : ', seen in a mirror or turned'}.`
      : 'Tables end at smaller vertices: the automaton computed this rule, and it is equally exact.');
  }
  #isItself(key) {
    if (key.ports !== this.ports) return false;
    const { k, a, loop, ports } = this;
    return representative(k, a, loop, ports, true).joined === key.joined;
  }
}

try {
  window.restripPainter = new Painter(await load(await embedded('wasm')));
} catch (error) {
  field('verdict').textContent = error.message;
  console.error(error);
}

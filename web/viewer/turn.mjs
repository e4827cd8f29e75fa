// Your turn: a visitor colours a patch after its split; the page judges it in the words and drawings of `restrip-verify
// explain`, and shows from the certificate why no colouring is better.
import { embedded } from './embedded.mjs';
import { fanPicture, ringPicture } from './patch.mjs';
import { bitsIn, bitsOf } from './judge.mjs';
import { Puzzles, shown } from './puzzles.mjs';
import { cutColors } from './cut.mjs';

const counted = (n, what) => `${n.toLocaleString('en')} ${what}${n === 1 ? '' : 's'}`;
const together = (words) => (words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`);
/// The numbers of the puzzles that were solved, in the storage of the browser if it has one; the argument replaces them.
function remembered(numbers) {
  try {
    if (numbers) localStorage.setItem('restrip-solved', numbers);
    return (localStorage.getItem('restrip-solved') ?? '').split(',').filter(Boolean).map(Number);
  } catch {
    return [];
  }
}
export class Turn {
  puzzle = null;
  inner = 0n;  // solid inner edges
  seen = null;  // inner edges of the reason that are shown instead of the visitor's colours
  #loading = null;

  constructor(viewer, by) {
    this.viewer = viewer;
    this.by = by;
    by('take').addEventListener('click', () => this.take());
    for (const [id, colors, clicks] of [['turn-again', 'first', 0], ['turn-rule', 'best', -Infinity]])  // solutions by the rule do not count
      by(id).addEventListener('click', () => {
        this.clicks = clicks;
        this.#paint(this[colors]);
      });
    by('turn-back').addEventListener('click', () => this.go(this.number - 1));
    for (const id of ['turn-next', 'turn-on']) by(id).addEventListener('click', () => this.go(this.#unsolved(this.number + 1)));
    by('turn-daily').addEventListener('click', () => this.go(this.puzzles.daily(this.day)));
    by('turn-copy').addEventListener('click', () => navigator.clipboard.writeText(this.by('turn-result').textContent));
    by('turn-number').addEventListener('change', () => this.go(Math.round(+by('turn-number').value) - 1));
    const board = by('turn-after');
    board.addEventListener('click', (event) => this.#press(event.detail === 0 ? event.target : this.#nearest(event)));
    board.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      this.#press(event.target);
    });
    board.addEventListener('pointermove', (event) => this.#near(event.pointerType === 'mouse' ? this.#nearest(event) : null));
    board.addEventListener('pointerleave', () => this.#near(null));
    by('turn-reason').addEventListener('click', ({ target }) => target.dataset.set && this.#see(target));
  }

  // ---- which puzzle
  #load() {
    return this.#loading ??= embedded('puzzles').then((bytes) => {
      this.puzzles = new Puzzles(new TextDecoder().decode(bytes));
      this.by('turn-number').max = this.puzzles.count;
      this.solved = new Set(remembered());
    });
  }
  get day() { return Math.floor(Date.now() / 86400000); }
  /// The first puzzle from a number on that was not solved yet.
  #unsolved(number) {
    while (this.solved.has(number)) ++number;
    return number;
  }
  /// The puzzle and the colours of a link; without them the present ones, at first the easiest puzzle that was not
  /// solved yet.
  async goTo({ puzzle, mine }) {
    if (this.viewer.part !== 'turn' && puzzle === undefined) return;
    await this.#load();
    const named = this.puzzles.named(puzzle, this.viewer.restrip);
    if (named && named.name !== this.puzzle?.name) this.#begin(named);
    else if (!this.puzzle) this.go(this.#unsolved(0));
    if (!/^[0-9a-f]{1,8}$/.test(mine ?? '')) return;
    const inner = BigInt(`0x${mine}`);
    if (inner < 1n << BigInt(this.puzzle.edges.length) && inner !== this.inner) this.#paint(inner);
  }
  /// Its part of a link.
  get state() {
    if (!this.puzzle || this.viewer.part !== 'turn') return {};
    return { puzzle: this.puzzle.name, mine: this.inner === this.first ? undefined : this.inner.toString(16) };
  }
  go(number) {
    this.#begin(this.puzzles.at(Math.max(0, Math.min(this.puzzles.count - 1, number || 0))));
  }
  /// The split that was seen last.
  async take() {
    const { k, a, before, ports } = this.viewer.mesh.last;
    await this.#load();
    this.#begin(this.puzzles.of({ k, a, loop: before, ports }), true);
    location.hash = '#part=turn';
  }
  #begin(puzzle, own = false) {
    const { k, a, loop, ports } = this.puzzle = puzzle;
    this.best = this.viewer.restrip.rule({ family: 'split', k, a, edges: loop, ports }).colors;
    this.first = cutColors(k, a, loop);
    const found = this.puzzles.find(puzzle);
    this.number = found ? found.index : -1;
    this.clicks = 0;
    this.by('turn-number').value = found ? found.index + 1 : '';
    this.#describePatch(found, own);
    this.#describeReason(found);
    this.#paint(this.first);
  }

  // ---- input
  /// The line that is nearest to a pointer, if one is near.
  #nearest({ clientX, clientY }) {
    const lines = [...this.by('turn-after').querySelectorAll('.hit')];
    if (lines.length === 0) return null;
    const place = new DOMPoint(clientX, clientY).matrixTransform(lines[0].getScreenCTM().inverse());
    const away = ({ points }) => Math.min(...[1, 2].map((n) => {
      const [from, to] = [points[n - 1], points[n]];
      const [x, y] = [to.x - from.x, to.y - from.y];
      const along = Math.max(0, Math.min(1, ((place.x - from.x) * x + (place.y - from.y) * y) / (x * x + y * y)));
      return Math.hypot(from.x + along * x - place.x, from.y + along * y - place.y);
    }));
    const best = lines.reduce((one, other) => (away(other) < away(one) ? other : one));
    return away(best) < 32 ? best : null;
  }
  #near(line) {
    for (const each of this.by('turn-after').querySelectorAll('.hit')) each.classList.toggle('near', each === line);
  }
  #press(line) {
    const { edge } = line?.dataset ?? {};
    if (edge === undefined) return;
    ++this.clicks;
    this.#paint(this.inner ^ 1n << BigInt(edge.replace('inner ', '')));
    this.by('turn-after').querySelector(`[data-edge="${edge}"]`).focus({ preventScroll: true });
  }

  // ---- drawing
  #paint(inner) {
    this.inner = inner;
    this.#see(null);
    this.viewer.ask();  // so that the link follows
  }
  /// Shows the set of a button of the reason, or the visitor's colours; a button that is pressed again ends it.
  #see(button) {
    const same = button?.getAttribute('aria-pressed') === 'true';
    for (const each of this.by('turn-reason').querySelectorAll('[data-set]')) each.setAttribute('aria-pressed', String(each === button && !same));
    const of = button && !same ? this.lists[button.dataset.list] : null;
    this.seen = of && (of.why[button.dataset.set].set | of.solid);
    this.#draw();
  }
  #draw() {
    const { k, a, loop, ports } = this.puzzle;
    const shown = this.seen ?? this.inner;
    const judged = this.puzzle.judged(shown, this.best);
    this.by('turn-before').innerHTML = fanPicture(k, a, loop, ports, 'the patch before the split', { world: judged.fault?.world });
    this.by('turn-after').innerHTML = ringPicture(k, a, shown, ports, 'the patch after the split', { click: this.seen === null, named: true, fault: judged.fault });
    this.#describeVerdict(judged);
  }

  // ---- text
  #describeVerdict({ verdict, because, fault }) {
    const { puzzle, inner, best, clicks } = this;
    const begins = clicks === 0 && this.seen === null && inner === this.first;
    const solved = verdict === 'best' || verdict === 'equally good';
    const changes = fault ? '' : ` Yours: ${puzzle.change(inner)}.${solved ? ' No recolouring is better.' : ` The rule: ${puzzle.change(best)}.`}`;
    this.by('turn-verdict').className = begins ? '' : fault ? 'unsafe' : solved ? 'solved' : '';
    this.by('turn-on').hidden = !solved || clicks <= 0 || this.seen !== null;
    this.by('turn-text').innerHTML = begins ? 'Click an edge: a solid one joins two triangles into a strip. Leave as few strips as you can.' : `<span>${this.seen === null ? '' : 'Not your colours. '}<b>${verdict}</b>${because && `: ${because}`}.${changes}${solved && clicks > 0 ? ` Solved in ${counted(clicks, 'click')}!` : ''}</span>`;
    if (solved && clicks > 0) this.#remember();
    this.#count();
  }
  /// A puzzle that the visitor solved; the one of the day has a result to copy.
  #remember() {
    const { by, puzzles, number, solved, day, clicks, puzzle } = this;
    if (number >= 0) remembered([...solved.add(number)]);
    if (number !== puzzles.daily(day)) return;
    by('turn-result').textContent = `restrip, ${new Date().toISOString().slice(0, 10)}: ${puzzle.k} triangles, ${counted(puzzle.after(this.inner), 'strip')}, ` +
      `solved in ${counted(clicks, 'click')}. ${location.href.replace(/#.*/, '')}#part=turn&puzzle=${puzzle.name}`;
    by('turn-share').hidden = false;
  }
  #count() { this.by('turn-count').textContent = `of ${this.puzzles.count.toLocaleString('en')}, ${this.solved.size.toLocaleString('en')} solved`; }
  #describePatch(found, own) {
    const { k, a } = this.puzzle;
    this.by('turn-share').hidden = true;
    const where = this.by('turn-where');
    where.textContent = `${own ? 'The patch that you cut: a' : 'A'} vertex of ${k} triangles, ${a} of which go to one end of the new edge. `;
    if (!found) return;
    const met = this.puzzles.met(found.index);
    const share = 10000 * met / this.puzzles.counted;
    const often = `Of 10,000 splits in real meshes ${share < 0.01 ? 'under 0.01' : share.toFixed(2)} use its rule, `;
    where.append(met === 0 ? 'Splits in four real meshes did not use its rule, ' : often,
      Object.assign(document.createElement('a'), { href: `atlas/split-${k}-${a}.html#${found.rule}`, textContent: found.rule }), '.');
  }
  #describeReason(found) {
    const { puzzle, best } = this;
    const edges = puzzle.edges.length;
    const said = `Fewer strips means fewer dashed edges. The rule leaves ${edges - bitsIn(best)} of the ${edges} edges inside dashed.`;
    this.lists = found ? shown(puzzle, found.reason, best) : [];
    this.by('turn-reason').innerHTML = found
      ? `<p>${said} Fewer are impossible. Press a set of edges to see why they cannot all be solid.</p>` +
        this.lists.map((list, n) => listText(puzzle, best, list, n)).join('')
      : `<p>${said} Certificates with such reasons end at vertices of 8 triangles. A proof for vertices of any number of triangles says that fewer are impossible.</p>`;
  }
}

/// One list of a reason on the page: its case, its sets as buttons, and what they show.
function listText(puzzle, best, { solid, dashed, why, least, left }, list) {
  const given = [[solid, 'solid'], [dashed, 'dashed']].flatMap(([mask, color]) => bitsOf(mask).map((edge) => `${puzzle.edgeNames(1n << BigInt(edge), '-')} is ${color}`));
  const parts = given.length > 0 ? [`<h3>If ${together(given)}</h3>`] : [];
  const quantity = { 1: '', 2: 'both ' };
  const sets = why.map(({ set, fault }, n) => `<li>
    <button data-list="${list}" data-set="${n}" aria-pressed="false">${puzzle.edgeNames(set)}</button>
    ${quantity[bitsIn(set)] ?? 'all '}solid: ${puzzle.effect(fault)}</li>`);
  if (why.length > 0) parts.push(`<ol class="sets">${sets.join('')}</ol>`);
  const own = why.length > 1 ? `No two sets share an edge, so each has a different dashed edge: ${why.length}`
    : why.length === 1 ? 'One edge is dashed' : 'No other edge need be dashed';
  const settled = bitsIn(dashed);
  const all = settled > 0 ? `, with ${settled === 1 ? 'the edge' : `the ${settled} edges`} of this case ${least}` : '';
  const ours = puzzle.edges.length - bitsIn(best);
  const its = puzzle.isolated(best).length;
  const isolated = least === ours && its > 0
    ? ` With no more dashed edges than that, ${together(left.map((node) => puzzle.names[node]))} ${left.length === 1 ? 'is' : 'are'} isolated, ${left.length > its ? 'more than' : 'the same number as'} under the rule.` : '';
  parts.push(`<p>${own}${all}. The rule leaves ${least > ours ? 'fewer' : 'the same number'}.${isolated}</p>`);
  return parts.join('');
}

// A complete reader of restrip_automaton.json: best recolourings of fans of any valence, by their keys (restrip's
// docs/reference/notation.md, "Key"). It follows tables/include/restrip/tables/automaton_format.hpp. Masks are BigInts of any size.

export class Automaton {
  /// `json`: what JSON.parse makes of the file.
  constructor(json) {
    if (json.format !== 'restrip-automaton' || json.version !== 2) throw new Error('no automaton of restrip, version 2');
    this.json = json;
  }

  /// The letters of a fan. With exactly two solid ports in a closed fan either bit of `joined` stands for the pair; in an
  /// open fan nothing lies before the first solid port.
  #letters(k, closed, { ports, joined = 0n }) {
    const bits = (mask) => Array.from(BigInt.asUintN(k, mask).toString(2).padStart(k, '0'), Number).reverse();
    const [solid, pair] = [ports, joined & ports].map(bits);
    const first = solid.indexOf(1);
    if (!closed && first >= 0) pair[first] = 0;
    const two = closed && solid.reduce((sum, bit) => sum + bit, 0) === 2 && pair.includes(1);
    return solid.map((bit, i) => (bit === 0 ? 0 : two || pair[i] === 1 ? 2 : 1));
  }

  /// An arc of these letters: its class, and the entries on the way.
  #arc(letters) {
    let arcClass = 0;
    const entries = letters.map((letter) => {
      const entry = 4 * arcClass + letter;
      arcClass = this.json.next[entry];
      return entry;
    });
    return { arcClass, entries };
  }

  /// The links of an arc, from left to right, from the case of the whole arc.
  #links({ entries }, end) {
    const links = [(end & 3) !== 0];
    for (let m = entries.length; m > 0; --m) {
      end = this.json.before[2 * entries[m - 1] + (end >> 3)] >>> 4 * (end & 7) & 15;
      links.push((end & 3) !== 0);
    }
    return links.reverse();
  }

  /// The edges of two arcs that meet in A and D.
  #meeting(one, other) {
    const { first, second, meet, meetings, seconds } = this.json;
    const meeting = meetings[meet[seconds * first[one.arcClass] + second[other.arcClass]]];
    return [this.#links(one, meeting & 15), meeting >> 4 & 15, (meeting >> 8) !== 0];
  }

  /// The inner edges after an operation as a BigInt; null if the position does not exist. `name` and `position`: split
  /// [k, a], collapse [k], open_split [k, i, j], boundary_split [k, i], fan_collapse [k]. `key`: { ports, joined }.
  /// Bit i of `joined` is set when port i is joined, before the operation, to the solid port before it.
  best(name, [k, p, q], key) {
    const closed = name === 'split' || name === 'collapse';
    if (k < (closed ? 3 : 1)) return null;
    const letters = this.#letters(k, closed, key);
    const whole = () => this.#arc(letters);
    const edges = {
      split: () => {
        if (!(p >= 1 && p < k)) return null;
        const other = this.#arc(letters.slice(p));
        const [links, end, chord] = this.#meeting(this.#arc(letters.slice(0, p)), other);
        return [...links, ...this.#links(other, end), chord];
      },
      collapse: () => this.#links(whole(), this.json.closed[whole().arcClass]).slice(1),
      open_split: () => {
        if (!(p >= 0 && p < q && q <= k)) return null;
        const other = this.#arc([...letters.slice(q), 3, ...letters.slice(0, p)]);
        const [links, end, chord] = this.#meeting(this.#arc(letters.slice(p, q)), other);
        const around = this.#links(other, end);  // the boundary has no edges
        return [...around.slice(k - q + 2), ...links, ...around.slice(0, k - q), chord];
      },
      boundary_split: () => {
        if (!(p >= 0 && p <= k)) return null;
        return this.#links(this.#arc([...letters.slice(0, p), 0, ...letters.slice(p)]), 0).slice(1, -1);
      },
      fan_collapse: () => this.#links(whole(), 0).slice(1, -1),
    }[name]();
    return edges && BigInt('0b0' + edges.reverse().map(Number).join(''));
  }
}

/// Which records of a progressive mesh are split. Two records whose fans share a triangle keep their order, all others
/// commute. So a set of records can be played, in any such order, exactly if it contains all records that its members need,
/// and a record can be undone if no played record needs it. Records need earlier ones only.
export class Records {
  #first;  // of record i: #needs[#first[i]] up to #needs[#first[i + 1]]
  #needs;
  #dependents;  // by record: the number of played records that need it
  #played;
  /// The number of played ones.
  count;

  /// Splits each record once, in their order, by split(i). `around`: gives the triangles around vertices.
  constructor(splits, { around, split } = {}) {
    const [first, needs, last] = [[0], [], new Map()];  // by triangle: the last record it was part of
    for (let i = 0; i < splits.length / 4; ++i) {
      const [vS, vT] = splits.subarray(4 * i, 4 * i + 2);
      const own = new Set(around(vS).map((t) => last.get(t)).filter((record) => record !== undefined));
      needs.push(...own);
      first.push(needs.length);
      split(i);
      for (const t of around(vS, vT)) last.set(t, i);
    }
    this.#first = Uint32Array.from(first);
    this.#needs = Uint32Array.from(needs);
    this.reset();
  }
  /// `played`: a byte for each record.
  reset(played = new Uint8Array(this.#first.length - 1)) {
    this.#played = played;
    this.#dependents = new Uint32Array(played.length);
    this.count = 0;
    played.forEach((split, i) => split && this.#add(i, 1));
  }
  #needsOf(i) { return this.#needs.subarray(this.#first[i], this.#first[i + 1]); }
  isSplit(i) { return this.#played[i] === 1; }
  #add(i, more) {
    this.count += more;
    for (const need of this.#needsOf(i)) this.#dependents[need] += more;
  }
  #toggle(i, plan) {
    this.#played[i] ^= 1;
    this.#add(i, this.#played[i] ? 1 : -1);
    plan.push(i);
  }

  /// The operations, at most `most`, to the level at which the first `level` records are played: each splits its record, or
  /// undoes it if it is split. Later records are undone, the last one first, then missing ones are played in order.
  toLevel(level, most) {
    const plan = [];
    if (this.inOrder) {  // as almost always: only those between here and there
      while (this.count > level && plan.length < most) this.#toggle(this.count - 1, plan);
      while (this.count < level && plan.length < most) this.#toggle(this.count, plan);
      return plan;
    }
    for (let i = this.#played.length; i-- > level && plan.length < most;) if (this.#played[i]) this.#toggle(i, plan);
    for (let i = 0; i < level && plan.length < most; ++i) if (!this.#played[i]) this.#toggle(i, plan);
    return plan;
  }
  /// The same to the records marked in `marks` and those that they need. Calls with a small `most` arrive as well, because
  /// no record of the set is undone.
  towards(marks, most) {
    const wanted = Uint8Array.from(marks);
    for (let i = wanted.length; i-- > 0;) if (wanted[i]) for (const need of this.#needsOf(i)) wanted[need] = 1;
    const plan = [];
    for (let i = wanted.length; i-- > 0 && plan.length < most;)
      if (this.#played[i] && !wanted[i] && this.#dependents[i] === 0) this.#toggle(i, plan);
    for (let i = 0; i < wanted.length && plan.length < most; ++i) if (!this.#played[i] && wanted[i]) this.#toggle(i, plan);
    return plan;
  }
  /// Those that can be split now: not split yet, and needing no other.
  get ready() {
    const ready = [];
    this.#played.forEach((split, i) => { if (!split && this.#needsOf(i).every((need) => this.#played[need])) ready.push(i); });
    return Uint32Array.from(ready);
  }
  /// Whether the first `count` are played.
  get inOrder() { return this.#played.lastIndexOf(1) + 1 === this.count; }
}

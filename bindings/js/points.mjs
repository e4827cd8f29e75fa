/// What a mesh has besides the library's state: its points, three coordinates a vertex, and whether single operations have
/// left the records. They have one history, in step with the frames of the library: what belongs to frame n is what was
/// there at the last update() of that number.
export class Points {
  #store;  // and room for more
  #ofRecords;  // the number of vertices of records
  #overwritten = new Map();  // of those, the points of vertices whose numbers an operation used again
  #frame = null;  // the present number; null without a history
  #writes = [];  // since the last update()
  #frames = new Map();  // by number: the writes that lead there from the frame before
  /// A view; replaced when the number of vertices changes.
  all;
  left = false;

  constructor(places, ofRecords) {
    this.all = this.#store = places;
    this.#ofRecords = ofRecords;
  }
  /// Begins the history again, with the points of the records. `frame`: its number; null without a history.
  begin(frame) {
    for (const [v, place] of this.#overwritten) this.all.set(place, 3 * v);
    this.left = false;
    [this.#overwritten, this.#writes, this.#frames, this.#frame] = [new Map(), [], new Map(), frame];
  }
  get count() { return this.all.length / 3; }
  get(v) { return this.all.slice(3 * v, 3 * v + 3); }
  /// `v` may be one more than there are.
  put(v, place) { this.#write({ v, place: [...place], appended: v === this.count }); }
  /// The point of a new vertex of an operation, which leaves the records.
  make(v, place) {
    if (v < this.#ofRecords && !this.#overwritten.has(v)) this.#write({ overwritten: v, place: this.get(v) });
    this.put(v, place);
  }
  leave() { if (!this.left) this.#write({ left: true }); }

  /// After the library ended a frame, or looked for one. `undoable`: the frames before it.
  end(frame, undoable) {
    if (this.#frame === null) return;
    if (frame !== this.#frame) {
      for (const later of [...this.#frames.keys()]) if (later >= frame) this.#frames.delete(later);
      this.#frames.set(frame, this.#writes);
    } else {
      // The mesh has not changed: these writes belong to the present frame. The next one, if it was undone, is without them.
      this.#frames.get(frame)?.push(...this.#writes);
      this.#frames.get(frame + 1)?.unshift(...this.#writes.map(({ write, back }) => ({ write, back: !back })).reverse());
    }
    this.#writes = [];
    this.#frame = frame;
    for (const old of [...this.#frames.keys()]) if (old <= frame - undoable) this.#frames.delete(old);
  }
  /// After the library went to this frame from the next one, or from the one before.
  step(frame, forward) {
    this.end(forward ? frame - 1 : frame + 1, Infinity);
    const writes = this.#frames.get(forward ? frame : frame + 1) ?? [];
    for (const { write, back } of forward ? writes : [...writes].reverse()) this.#exchange(write, forward !== back);
    this.#frame = frame;
  }

  #write(write) {
    this.#exchange(write, true);
    if (this.#frame !== null) this.#writes.push({ write, back: false });
  }
  /// A write holds the values that are not there.
  #exchange(write, forward) {
    if ('left' in write) return void ([this.left, write.left] = [write.left, this.left]);
    const { v, place, appended, overwritten } = write;
    if (overwritten !== undefined) return void (forward ? this.#overwritten.set(overwritten, place) : this.#overwritten.delete(overwritten));
    if (appended && forward) this.#resize(this.all.length + 3);
    for (let x = 0; x < 3; ++x) [this.all[3 * v + x], place[x]] = [place[x], this.all[3 * v + x]];
    if (appended && !forward) this.#resize(this.all.length - 3);
  }
  #resize(length) {
    if (length > this.#store.length) {
      this.#store = new Float32Array(2 * length);
      this.#store.set(this.all);
    }
    this.all = this.#store.subarray(0, length);
  }
}

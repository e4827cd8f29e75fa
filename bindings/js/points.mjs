/// The points of a mesh, three coordinates a vertex. Undo restores those that operations appended or overwrote: each is
/// noted with the number of the frame of its operation.
export class Points {
  #store;  // and room for more
  #notes = [];
  #applied = 0;  // those that are not undone
  /// A view; replaced when the number of vertices changes.
  all;

  constructor(places) { this.all = this.#store = places; }

  set(v, place) { this.all.set(place, 3 * v); }
  /// The point of a new vertex, which may take a number that is in use. `frame`: null for no undo.
  put(v, place, frame) {
    const note = { frame, v, appended: 3 * v === this.all.length, place: [...place] };
    this.#exchange(note, true);
    if (frame === null) return;
    this.#notes.length = this.#applied;  // what was undone is no longer redone
    this.#applied = this.#notes.push(note);
  }
  /// After the mesh was undone to the beginning of this frame, or redone.
  step(frame, forward) {
    const notes = this.#notes;
    if (forward) while (this.#applied < notes.length && notes[this.#applied].frame < frame) this.#exchange(notes[this.#applied++], true);
    else while (this.#applied > 0 && notes[this.#applied - 1].frame >= frame) this.#exchange(notes[--this.#applied], false);
  }
  /// Frames before this one cannot be undone.
  forget(frame) {
    let old = 0;
    while (old < this.#applied && this.#notes[old].frame < frame) ++old;
    this.#notes.splice(0, old);
    this.#applied -= old;
  }

  #exchange({ v, appended, place }, forward) {
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

// The number of operations for a frame: the most that fit into its time.
const firstPace = 256;  // operations, before their speed is known

export class Pace {
  most = firstPace;
  budget = 12;  // milliseconds
  #begun = performance.now();
  #took = 0;

  /// A frame begins. If drawing takes long, operations get a quarter of that time.
  begin() {
    const now = performance.now();
    this.budget = Math.max(12, Math.min(50, (now - this.#begun - this.#took) / 4));
    this.#begun = now;
    this.#took = 0;
  }
  /// After `done` of at most `most` operations, in `milliseconds`; the clock may be coarse.
  learn(done, most, took) {
    this.#took += took;
    if (most <= this.most && done > 0 && (done === most || took > this.budget))
      this.most = Math.max(1, Math.min(4 * most, Math.floor(done * this.budget / Math.max(took, 0.1))));
  }
}

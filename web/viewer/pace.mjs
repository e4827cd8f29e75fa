// How many operations a frame may have: as many as fit into its time.
export const frameBudget = 12;  // milliseconds
const firstPace = 256;  // operations, before their speed is known

export class Pace {
  most = firstPace;

  /// After `done` of at most `most` operations, in so many milliseconds; the clock may be a coarse one.
  learn(done, most, took) {
    if (most <= this.most && done > 0 && (done === most || took > frameBudget))
      this.most = Math.max(1, Math.min(4 * most, Math.floor(done * frameBudget / Math.max(took, 0.1))));
  }
}

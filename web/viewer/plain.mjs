// The page in a browser without WebGL 2: the parts that draw no mesh work, the others show a picture and say why.
import { readLink, showPart } from './link.mjs';
import { Turn } from './turn.mjs';

const drawn = ['ribbon', 'cut', 'race'];

export class Plain {
  mesh = null;

  /// `reason`: a sentence.
  constructor(restrip, by, reason) {
    Object.assign(this, { restrip, by });
    by('fault-text').textContent = `${reason} Your turn and Use it work without it.`;
    by('fault-gone').hidden = true;
    this.turn = new Turn(this, by);
    addEventListener('hashchange', () => this.follow());
    this.follow();
  }
  follow() {
    const state = readLink(location.hash);
    this.part = showPart(this.by, state.part);
    this.by('fault').hidden = !drawn.includes(this.part);
    this.by('still').hidden = !drawn.includes(this.part);
    this.turn.goTo(state);
  }
  /// A frame, which nothing here needs.
  ask() {}
}

// An orbit camera: drag or one finger turns, wheel or two fingers go nearer, arrow keys and + - do the same.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a) => { const length = Math.hypot(...a) || 1; return a.map((c) => c / length); };

export class Camera {
  yaw = 0.55;
  pitch = 0.28;
  distance = 3;
  target = [0, 0, 0];
  size = 1;
  fov = 0.62;

  /// Looks at the whole of some points.
  fit(points) {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    points.forEach((c, i) => {
      low[i % 3] = Math.min(low[i % 3], c);
      high[i % 3] = Math.max(high[i % 3], c);
    });
    this.target = low.map((l, i) => (l + high[i]) / 2);
    this.size = Math.hypot(...low.map((l, i) => high[i] - l)) / 2 || 1;
    this.distance = this.size / Math.sin(this.fov / 2) * 0.95;
  }
  /// Moves, without turning, so that points fill `share` of a window.
  fill(points, aspect, share = 0.92) {
    this.fit(points);
    const f = 1 / Math.tan(this.fov / 2) * Math.min(1, aspect);
    for (let step = 0; step < 4; ++step) {  // nearer points need more room
      const { eye } = this;
      const axes = this.axes();
      const ends = [Infinity, -Infinity, Infinity, -Infinity];
      for (let i = 0; i < points.length; i += 3) {
        const p = [0, 1, 2].map((n) => points[i + n] - eye[n]);
        const deep = -dot(p, axes.back);
        const [x, y] = [dot(p, axes.right) / deep * f / aspect, dot(p, axes.up) / deep * f];
        ends[0] = Math.min(ends[0], x);
        ends[1] = Math.max(ends[1], x);
        ends[2] = Math.min(ends[2], y);
        ends[3] = Math.max(ends[3], y);
      }
      const [across, upwards] = [(ends[0] + ends[1]) / 2 * aspect, (ends[2] + ends[3]) / 2].map((c) => c * this.distance / f);
      this.target = this.target.map((c, n) => c + across * axes.right[n] + upwards * axes.up[n]);
      this.distance *= Math.max(ends[1] - ends[0], ends[3] - ends[2]) / 2 / share;
    }
  }
  get eye() {
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return [this.target[0] + this.distance * cp * sy, this.target[1] + this.distance * sp, this.target[2] + this.distance * cp * cy];
  }
  axes() {
    const back = unit(this.eye.map((c, i) => c - this.target[i]));
    const right = unit(cross([0, 1, 0], back));
    return { right, up: cross(back, right), back };
  }
  view() {
    const { right, up, back } = this.axes();
    const eye = this.eye;
    return new Float32Array([right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
      -dot(right, eye), -dot(up, eye), -dot(back, eye), 1]);
  }
  projection(aspect) {
    const near = Math.max(this.distance - 1.5 * this.size, this.distance / 100);
    const far = this.distance + 1.5 * this.size;
    // The whole is seen in a window of any shape.
    const f = 1 / Math.tan(this.fov / 2) * Math.min(1, aspect);
    return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]);
  }
  /// The ray through a place of the window, both from -1 to 1.
  ray(x, y, aspect) {
    const { right, up, back } = this.axes();
    const f = Math.tan(this.fov / 2) / Math.min(1, aspect);
    return { from: this.eye, along: unit([0, 1, 2].map((i) => right[i] * x * f * aspect + up[i] * y * f - back[i])) };
  }
  turn(dx, dy) {
    this.yaw -= dx;
    this.pitch = Math.max(-1.5, Math.min(1.5, this.pitch + dy));
  }
  nearer(factor) {
    this.distance = Math.max(0.05 * this.size, Math.min(20 * this.size, this.distance * factor));
  }

  // ---- flights
  get place() { return { yaw: this.yaw, pitch: this.pitch, distance: this.distance, target: [...this.target] }; }
  set place({ yaw, pitch, distance, target }) {
    Object.assign(this, { yaw, pitch, distance, target: [...target] });
    this.#flight = null;
  }
  /// Flies to a place in a number of milliseconds; step() continues.
  fly(to, milliseconds, now = performance.now()) {
    if (milliseconds <= 0) {
      this.place = to;
      return;
    }
    const from = this.place;
    const turn = to.yaw - from.yaw;
    from.yaw = to.yaw - (turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI)));  // the shorter way round
    this.#flight = { from, to, start: now, milliseconds };
  }
  /// Whether the flight continues after this.
  step(now) {
    if (!this.#flight) return false;
    const { from, to, start, milliseconds } = this.#flight;
    const flight = this.#flight;
    const share = Math.max(0, Math.min(1, (now - start) / milliseconds));
    const s = share * share * (3 - 2 * share);
    const between = (a, b) => a + (b - a) * s;
    this.place = { yaw: between(from.yaw, to.yaw), pitch: between(from.pitch, to.pitch),
      distance: from.distance * (to.distance / from.distance) ** s, target: from.target.map((c, i) => between(c, to.target[i])) };
    if (share < 1) this.#flight = flight;
    return share < 1;
  }
  #flight = null;

  /// Follows the pointers on an element; changed() after each change, clicked(event) if a pointer goes up where it came
  /// down.
  listen(element, changed, clicked) {
    const pointers = new Map();
    let moved = 0;
    const spread = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    element.addEventListener('pointerdown', (event) => {
      element.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (pointers.size === 1) moved = 0;
    });
    element.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const apart = pointers.size === 2 ? spread() : 0;
      moved += Math.hypot(event.clientX - before.x, event.clientY - before.y) + (pointers.size > 1 ? 100 : 0);
      if (moved < 5) return;
      this.#flight = null;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (pointers.size === 1) this.turn((event.clientX - before.x) * 0.008, (event.clientY - before.y) * 0.008);
      else if (pointers.size === 2) this.nearer(apart / Math.max(spread(), 1));
      changed();
    });
    for (const name of ['pointerup', 'pointercancel'])
      element.addEventListener(name, (event) => {
        if (pointers.delete(event.pointerId) && name === 'pointerup' && moved < 5) clicked(event);
      });
    element.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.nearer(Math.exp(event.deltaY * 0.001));
      changed();
    }, { passive: false });
    element.addEventListener('keydown', (event) => {
      const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
      if (event.key in turns) this.turn(...turns[event.key]);
      else if (event.key === '+' || event.key === '=') this.nearer(0.9);
      else if (event.key === '-') this.nearer(1 / 0.9);
      else return;
      event.preventDefault();
      changed();
    });
  }
}

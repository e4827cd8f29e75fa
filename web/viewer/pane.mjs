// A canvas and what WebGL draws on it: its size, its colours, the rays of a camera through its pixels, and the graphics
// context, which the browser may take away and restore.
import { Scene } from './scene.mjs';

const atNight = matchMedia('(prefers-color-scheme: dark)');

export class Pane {
  /// `changed`: it is to be drawn again. `lost` and `restored`: the card was taken away; the scene is empty again.
  constructor(canvas, camera, { changed, lost, restored }) {
    this.canvas = canvas;
    this.camera = camera;
    this.scene = new Scene(canvas);
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();  // so that it may come back
      lost();
    });
    canvas.addEventListener('webglcontextrestored', () => {
      this.scene = new Scene(canvas);
      restored();
    });
    new ResizeObserver(() => {
      this.#resize();
      changed();
    }).observe(canvas);
    atNight.addEventListener('change', changed);
  }
  #resize() {
    const box = this.canvas.getBoundingClientRect();
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    this.canvas.width = Math.max(1, Math.round(box.width * scale));
    this.canvas.height = Math.max(1, Math.round(box.height * scale));
  }
  get aspect() { return this.canvas.width / this.canvas.height; }
  /// The colours of the surface and of the background.
  get colors() {
    return atNight.matches ? { ink: [0.62, 0.66, 0.72], paper: [0.051, 0.059, 0.071] } : { ink: [0.86, 0.87, 0.88], paper: [0.914, 0.929, 0.945] };
  }
  /// Where a pointer is, both from -1 to 1.
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width * 2 - 1, 1 - (event.clientY - box.top) / box.height * 2];
  }
  ray(x, y) { return this.camera.ray(x, y, this.aspect); }
  rayAt(event) { return this.ray(...this.placeOf(event)); }
  save(name) {
    this.canvas.toBlob((blob) => {
      const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(blob), download: name });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    });
  }
}

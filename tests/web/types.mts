// What TypeScript makes of the package's types; package_test.mjs compiles this.
import { Restrip, load, none, restartIndex, type Figures, type Outcome, type StripMesh } from 'restrip-wasm';
import { loadReaders } from 'restrip-wasm/formats';
import address from 'restrip-wasm/restrip.wasm';
import readers from 'restrip-wasm/restrip-readers.wasm';

const addresses: string[] = [address, readers];
const restrip = await load(new URL(address, 'https://restrip.example/'));
const { readMesh, simplified, simplifying } = await loadReaders(addresses[1]);
await load(fetch(address));
await readMesh('mesh.obj', new Blob(['v 0 0 0']));
// @ts-expect-error
new Restrip();
const read = await readMesh('mesh.obj', new Uint8Array(3));
if (read.triangles) {
  for await (const share of simplifying(read)) void (share < 0.5);
  // @ts-expect-error
  await simplified(read.points);
  using mesh: StripMesh = restrip.progressive(await simplified(read, 0.5)).begin({ policy: 'quick', cost: { restart: 1, swap: 0 } });
  const done: number = mesh.moveTo(mesh.levels, 5);
  const figures: Figures = mesh.figures;
  // @ts-expect-error
  const size: number = figures.bufferIndices;
  const outcome: Outcome = mesh.split(0, 1, 2, none);
  const refusal: string = outcome.ok ? '' : outcome.reason;
  const halved = mesh.bisect(0, 1);
  if (halved.ok) mesh.setPoint(halved.vertex, 0, 0, 0);
  // @ts-expect-error
  void halved.vertex;
  for (const { first, count } of mesh.update()) mesh.indices.subarray(first, first + count).includes(restartIndex);
  mesh.begin({ history: 100, layout: { cache: 16 } }).keep({ policy: 'full', cost: 'strips' });
  const undone: boolean = mesh.undo() && mesh.redo() && mesh.history.undoable > mesh.recolor({ effort: 'best' });
  const download: Blob = new Blob([mesh.save(), mesh.indices]);
  const resumed: StripMesh = restrip.saved(mesh.save(), { points: mesh.points, history: 5 });
  // @ts-expect-error
  mesh.keep({ policy: 'baked' });
  // @ts-expect-error
  restrip.saved(mesh.save());
  // @ts-expect-error
  mesh.moveTo('1');
  // @ts-expect-error
  mesh.begin({ policy: 'quickly' });
  // @ts-expect-error
  mesh.indices = new Uint32Array(1);
  void [done, figures.strips, refusal, size, undone, resumed, download];
} else if (read.base) {
  restrip.progressive(read).close();
} else {
  restrip.baked(read.baked).close();
}

/// <reference lib="esnext.disposable" />
// Triangle strips, maintained while a mesh changes. A mesh is a progressive mesh: a base and vertex splits, the *records*,
// that lead from it to the fine mesh. Proven rules maintain the strips, and the policy improves them further. README.md has
// a whole example.
//
// Misuse throws an Error whose message is a sentence: an argument out of its range, a number that is NaN, a call before
// begin() or after close(). An operation that the mesh refuses is not misuse.

/** URL and WebAssembly.Module, in programs whose types declare them: neither the library of a browser nor Node's types are
 *  needed. */
type Url = typeof globalThis extends { URL: { prototype: infer T } } ? T : { readonly href: string };
type Module = typeof globalThis extends { WebAssembly: { Module: { prototype: infer T } } } ? T : object;
/** Of a Blob or a Response. */
interface Arriving { arrayBuffer(): Promise<ArrayBuffer> }
/** Of any realm, shared or not. */
export type Bytes = ArrayBufferLike | ArrayBufferView;
/** A WebAssembly module: where to fetch it from, its bytes, compiled, or a promise of one of them. It is compiled while it
 *  arrives if the server gives it the type application/wasm. A page that was opened as a file can only give bytes. */
export type Source = Awaitable<string | Url | Bytes | Arriving | Module>;
/** The content of a file. */
export type Content = Awaitable<string | Bytes | Arriving>;
type Awaitable<T> = T | PromiseLike<T>;
// Arrays that are not shared: Uint8Array<ArrayBuffer> for TypeScript from 5.7 on, Uint8Array before.
export type OwnBytes = ReturnType<Uint8Array['slice']>;
export type OwnFloats = ReturnType<Float32Array['slice']>;
export type OwnNumbers = ReturnType<Uint32Array['slice']>;
export type OwnNarrow = ReturnType<Uint16Array['slice']>;

/** What became of an operation: done, or refused for a reason, one sentence that names its vertices. */
export type Outcome<Made = {}> = ({ ok: true } & Made) | { ok: false; reason: string };
/** The effort of an operation to keep strips good. 'baked': plays the strips that `restrip bake` precomputed for each
 *  level; for meshes opened by Restrip.baked. */
export type Policy = 'bare' | 'rules' | 'local' | 'quick' | 'full' | 'baked';
/** The cost to minimise: a weight for each strip, each swap (a repeated index), each isolated triangle; 0 to 1000. */
export type Cost = 'strips' | 'indices' | { restart: number; swap: number; isolated?: number };
export type Family = 'split' | 'collapse' | 'open-split' | 'open-collapse' | 'boundary-split' | 'boundary-collapse' | 'flip';

/** Forms of the index buffer: one strip restarted by the index with all bits set; one strip without restart, stitched by
 * repeated indices; runs to be drawn one by one (`draws`); a triangle list. */
export type Form = 'restart' | 'stitched' | 'lengths' | 'list';

/** The effort for strips from scratch: one pass; then long searches; then up to ten times as long. */
export type Effort = 'fast' | 'full' | 'best';
/** How strips in the buffer stay short and in order. `cache`: vertices of the cache that strips are ordered for, up to 64; 0: no
 *  order (32). `waste`: what cuts and gaps may add, per mille of the indices needed (95). `work`: indices that an update may move for
 *  each index that it rewrites, up to 100 (5). */
export interface Layout { cache?: number; waste?: number; work?: number }

/** Between two strips of an index buffer of 32 bits (0xffff of 16); WebGL 2 and WebGPU restart there. */
export const restartIndex: 0xffffffff;
/** No vertex. */
export const none: 0xffffffff;

/** Without argument: restrip.wasm next to this module, in browsers and in Node. */
export function load(source?: Source): Promise<Restrip>;

/** Made by load(). */
export class Restrip {
  private constructor();
  /** A progressive mesh. `points`: 3 finite numbers a vertex; `base`: 3 a triangle; `splits`: 4 a record: v_s, the new v_t,
   * v_l, v_r (one of the last two is `none` on the boundary). Every vertex needs a point. Throws when a record cannot be
   * played. */
  progressive(source: { points: ArrayLike<number>; base: ArrayLike<number>; splits: ArrayLike<number> }): StripMesh;
  /** A mesh without records. */
  mesh(source: { points: ArrayLike<number>; triangles: ArrayLike<number> }): StripMesh;
  /** A baked mesh, from the bytes of the file that `restrip bake` wrote. Throws when they are truncated, altered, or not a
   *  mesh. */
  baked(bytes: Bytes): StripMesh;
  /** A mesh from the bytes of StripMesh.save(), or of LiveMesh::save() in C++, with the points of its vertices. It has begun, with the
   *  policy, cost and form that it had; it has no records. `history`: see begin().
   *  Throws when the bytes are truncated, altered, of another version, or not a mesh. */
  saved(bytes: Bytes, options: { points: ArrayLike<number>; history?: number }): StripMesh;
  /** The rule of a configuration, numbered as in docs/reference/notation.md: `edges` are the loop or inner edges before. Any k
   * up to 61. `valid` is false for positions out of range and colours that no valid colouring has. */
  rule(configuration: { family: Family; k?: number; a?: number; i?: number; j?: number;
    edges: number | bigint; ports: number | bigint }): Rule;
}

export interface Rule {
  valid: boolean;
  /** Change in the number of strips. */
  strips: number;
  /** The loop or inner edges after the operation. */
  colors: bigint;
  /** The ports that stay solid: all, except for flips. */
  ports: bigint;
}

/** The table of a custom operation (docs/how-to/other-languages.md); a TypeScript program reads it with JSON.parse(). */
export interface OperationTable {
  format: string;
  name: string;
  matching: boolean;
  none: number;
  entries: number[];
  positions: { numbers: number[]; before: { triangles: number; edges: number }; after: { triangles: number; edges: number }; ports: number; first: number;
    vertices?: number; triangles_before?: number[][]; triangles_after?: number[][] }[];
}

/** Some consecutive indices. */
export interface Range { first: number; count: number }

/** Since begin(), undone operations included. */
export interface Figures {
  triangles: number;
  strips: number;
  /** Records that are split now; when `inOrder`, the first ones. */
  played: number;
  inOrder: boolean;
  /** To be drawn, gaps included. Null between an operation and update(): the buffer is then not the one of this mesh. */
  bufferIndices: number | null;
  operations: number;
  /** Operations that added strips; that added an isolated triangle (not counted while `baked`). */
  addingStrip: number;
  isolating: number;
  /** By all updates but the first. */
  indicesWritten: number;
  updates: number;
  /** The strips are the baked strips of this level. Under policy 'baked' that ends with the first operation out of order;
   *  from then on the rules maintain the strips, until begin() or until it is undone. */
  baked: boolean;
}

export interface LastOperation {
  kind: 'split' | 'collapse' | 'flip';
  /** The fan is closed and has 61 triangles or fewer; only then are k, a and the colours meaningful. */
  closed: boolean;
  k: number;
  a: number;
  before: bigint;
  ports: bigint;
  after: bigint;
  portsAfter: bigint;
  strips: number;
  isolated: number;
  trianglesBefore: OwnNumbers;
  trianglesAfter: OwnNumbers;
}

/** Call begin() first. Before it only `points`, `levels`, `splits`, `hasBakedStrips`, `leftOut`, addPoint(), setPoint()
 * and close() do not throw. A view of memory (`indices`) is valid until the next call of any method of any
 * mesh, and while its mesh can be reached. */
export class StripMesh implements Disposable {
  /** Replaced when addPoint(), bisect() or splitFace() makes it longer, in constant time on average, or undo() shorter:
   * read it again. bisect() and splitFace() may reuse the number of a removed vertex; then it keeps its length. begin() gives
   * vertices of records their points again. */
  readonly points: OwnFloats;
  /** Number of records. */
  readonly levels: number;
  /** A copy, 4 numbers a record. */
  readonly splits: OwnNumbers;
  /** May be begun with policy 'baked'. */
  readonly hasBakedStrips: boolean;
  readonly leftOut: { triangles: number; nonManifoldVertices: number; boundaryEdges: number };

  /** Goes to the base, makes its strips from scratch, and maintains them with these options. A mesh with records loses
   *  single operations; a mesh without records keeps them: its base is the present mesh. Policy 'baked' begins with the
   *  baked strips instead and ignores the cost. `bits` of an index: 32, 16, or 'auto': 16 until a vertex number is 65,535
   *  or above. With 16, operations that need such a vertex are refused. `history`: the budget of undo(),
   *  in changed triangles of all frames together, some 100 bytes each; beyond it the oldest frames are dropped, but never the last one.
   *  Defaults: 'quick', 'indices', 'restart', 32, no history. */
  begin(options?: { policy?: Policy; cost?: Cost; form?: Form; bits?: 16 | 32 | 'auto'; history?: number; layout?: Layout }): this;
  /** Another policy and cost for all later operations; not 'baked'. Undo does not restore them. Linear time. Defaults: 'quick',
   *  'indices'. */
  keep(options?: { policy?: Exclude<Policy, 'baked'>; cost?: Cost }): void;
  /** Strips from scratch for the present mesh, which stay; returns their number. The next update() writes the whole buffer. Can be
   *  undone. Defaults: 'fast', 'indices'. */
  recolor(options?: { effort?: Effort; cost?: Cost }): number;
  /** For idle time: searches on, by about `budget` steps of a few hundred nanoseconds, and returns the cost saved. */
  improve(budget: number): number;
  /** Splits and collapses until the first `level` records are played, a whole number up to `levels`; at most `most`
   * operations. Returns their number; fewer than `most`: done. Throws after a single operation, until begin() or
   * until it is undone, because records no longer fit the mesh. */
  moveTo(level: number, most?: number): number;
  /** The same towards the records marked 1 in `wanted`, a byte each, and the records that they need: a view-dependent
   *  mesh. */
  approach(wanted: Uint8Array, most?: number): number;
  /** The neighbours of a vertex, counter-clockwise; at a non-manifold vertex only some of them. Empty when the
   *  mesh does not have the vertex. A copy. */
  around(v: number): OwnNumbers;
  /** The records that can be split now, because all records that they need are split. Linear time. */
  readonly ready: OwnNumbers;
  /** A new vertex for split(). Returns its number. bisect() and splitFace() may take it if they come first. */
  addPoint(x: number, y: number, z: number): number;
  /** Moves a vertex; strips do not depend on positions. */
  setPoint(v: number, x: number, y: number, z: number): void;
  /** Single operations by vertices; vT needs a point. The mesh refuses what would damage it, and is then unchanged. */
  split(vS: number, vT: number, vL: number, vR: number): Outcome;
  collapse(vS: number, vT: number): Outcome;
  flip(u: number, v: number): Outcome;
  /** A custom operation, by its table as data: the JSON file that the page *Make a rule* exports, or `restrip-generate
   * rules --language json` writes, as JSON.parse() reads it. The side from u to v is the first side of the first
   * triangle under `before` of its file; of a family, the first position that fits is done. `vertices`: the new
   * vertices, in the order in which the file names them; their points are in the middle of that first triangle,
   * until setPoint() moves them. The table is checked once: a rule that could spoil a mesh throws. Keep the object, so that
   * it is not read again. */
  apply(table: OperationTable, u: number, v: number): Outcome<{ vertices: number[] }>;
  /** A new vertex at the middle of an edge, or of the triangle with these corners, counter-clockwise from any of them. */
  bisect(u: number, v: number): Outcome<{ vertex: number }>;
  splitFace(a: number, b: number, c: number): Outcome<{ vertex: number }>;
  /** Any change of a few triangles: removes some and adds others, each by three vertices, counter-clockwise, in one list;
   *  either list may be empty. Vertices that the mesh does not have need a point; those left without triangles go. The
   *  mesh must stay a manifold with boundary. */
  replace(removed: ArrayLike<number>, inserted: ArrayLike<number>): Outcome;

  /** Brings the index buffer in step; returns the ranges to upload. Ranges at most `join` indices apart (2) become one;
   * they begin and end at multiples of `align` bytes, 2 or a multiple of 4 (4, as WebGPU's writeBuffer needs). `outgrown`:
   * the buffer has become longer than `room`, or its indices wider; make a new one of `room` indices on the device. The
   * only range is then the whole buffer. Time linear in the changes. */
  update(options?: { join?: number; align?: number }): Range[] & { outgrown: boolean };
  /** The number of indices that the buffer on the device should have room for; for a mesh with records 2 a triangle of the
   * finest level, or more. */
  readonly room: number;
  /** The ranges to draw: the runs of the form 'lengths', else the whole buffer; of a list, in which an operation writes only the slots
   *  of the triangles that it changed, 3 indices a triangle. */
  readonly draws: Range[];
  /** Undoes or redoes a frame; update() ends a frame, and changes since then count as one. Triangles, strips, the level and
   *  all points are what they were at the last update() of the frame that is returned to. An update() without a change of
   *  the mesh ends no frame: points that addPoint() and setPoint() wrote then belong to the frame before. Call update()
   *  next. False when there is no such frame. Time linear in the frame, and in the records. */
  undo(): boolean;
  redo(): boolean;
  /** Frames that can be undone and redone. */
  readonly history: { undoable: number; redoable: number };
  /** The mesh, its strips, policy, cost and form as bytes for Restrip.saved(): not points, records or history. Linear time. */
  save(): OwnBytes;
  /** A copy of the index buffer of strips made from scratch, by the fastest way, for the present mesh. The maintained
   *  strips do not change. With `cacheSize` they are cut, joined and ordered for a first-in-first-out vertex cache of that
   *  many vertices (16 for most hardware), in which a miss is worth `cacheWeight` indices (0: default). Linear time. */
  fromScratch(options?: { cost?: Cost; cacheSize?: number; cacheWeight?: number }): OwnNumbers;
  /** The index buffer in the form that begin() was given. A 16-bit list of an odd number of triangles ends with one more
   * index, which is not drawn. A view, not a copy. */
  readonly indices: OwnNumbers | OwnNarrow;
  /** A copy of the triangles, 3 numbers each. */
  readonly triangles: OwnNumbers;

  readonly figures: Figures;
  /** Indices of a buffer written from scratch, without gaps. Linear time. */
  readonly plainIndices: number;
  /** Checks the colouring from its definition. Linear time. */
  readonly valid: boolean;

  /** The triangles, strip by strip and in the order of their strips, 9 numbers each: the triangle, its three corners, the
   * triangles beyond its three sides (`none` at the boundary), a mask of the sides where its strip continues, and the strip,
   * named by its lowest triangle. Side 0 is from the first corner to the second. Linear time. */
  readonly ribbon: OwnNumbers;
  /** The same for the strips that fromScratch() made last; empty before. */
  readonly scratchRibbon: OwnNumbers;
  /** The first point where a ray meets the mesh, or null. Linear time. */
  pick(from: ArrayLike<number>, along: ArrayLike<number>): [number, number, number] | null;
  readonly last: LastOperation | null;
  /** Releases the memory. Once is enough; `using mesh = …` does it at the end of the block. Without it the memory is
   *  released some time after the program can no longer reach the mesh. */
  close(): void;
  [Symbol.dispose](): void;
}

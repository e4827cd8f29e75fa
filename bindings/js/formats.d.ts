import type { Content, OwnBytes, OwnFloats, OwnNumbers, Source } from 'restrip-wasm';

/** Compiles the readers and the simplifier of the program `restrip`: their bytes, or where to fetch them from; by default the file
 * restrip-readers.wasm of this package. Throws an Error if that fails. */
export function loadReaders(source?: Source): Promise<Readers>;

/** Made by loadReaders(). Functions, which need no `this`. */
export interface Readers {
  /** Reads a mesh file of any format that the program `restrip` reads (docs/reference/file-formats.md); the
   * extension of `name` decides. Strips and polygons become triangles; vertices of glTF at one place become one. Throws an
   * Error with the program's message. A .gltf with buffers in separate files cannot be read. */
  readMesh(name: string, content: Content): Promise<Mesh | ProgressiveMesh | BakedMesh>;
  /** Simplifies a mesh to `share` of its triangles (0.02), from 0 to 1, for Restrip.progressive(): by quadric errors; boundary
   * vertices move along the boundary. When no further edge may collapse, more triangles are left. `points`: 3 finite numbers
   * a vertex; `triangles`: 3 vertices each. Takes seconds for a million triangles. */
  simplified(mesh: Triangles, share?: number): Promise<Levels>;
  /** The same in steps of some milliseconds: a generator of the share that is done, from 0 to 1, which returns the levels. */
  simplifying(mesh: Triangles, share?: number): AsyncGenerator<number, Levels, void>;
}
/** Three numbers a vertex, three vertices a triangle. */
export interface Triangles { points: ArrayLike<number>; triangles: ArrayLike<number> }
/** See Restrip.progressive. */
export interface Levels { points: OwnFloats; base: OwnNumbers; splits: OwnNumbers }

interface Read {
  /** What the file holds besides positions and triangles, in words: "normals, lines"; empty if nothing. */
  leftOut: string;
}
/** Three numbers a vertex, three a triangle. */
export interface Mesh extends Read { points: OwnFloats; triangles: OwnNumbers; base?: undefined; baked?: undefined }
/** See Restrip.progressive. */
export interface ProgressiveMesh extends Read, Levels { triangles?: undefined; baked?: undefined }
/** See Restrip.baked. */
export interface BakedMesh extends Read { baked: OwnBytes; triangles?: undefined; base?: undefined }

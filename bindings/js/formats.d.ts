import type { Content, OwnBytes, OwnFloats, OwnNumbers, Source } from 'restrip-wasm';

/** Compiles the readers of the program `restrip`: their bytes, or where to fetch them from; by default the file
 * restrip-readers.wasm of this package. Throws an Error if that fails. */
export function loadReaders(source?: Source): Promise<ReadMesh>;

/** Reads a mesh file of any format that the program `restrip` reads (docs/reference/file-formats.md); the
 * extension of `name` decides. Strips and polygons become triangles; vertices of glTF at one place become one. Throws an
 * Error with the program's message. A .gltf with buffers in separate files cannot be read. */
export type ReadMesh = (name: string, content: Content) => Promise<Mesh | ProgressiveMesh | BakedMesh>;

interface Read {
  /** What the file holds besides positions and triangles, in words: "normals, lines"; empty if nothing. */
  leftOut: string;
}
/** Three numbers a vertex, three a triangle. */
export interface Mesh extends Read { points: OwnFloats; triangles: OwnNumbers; base?: undefined; baked?: undefined }
/** See Restrip.progressive. */
export interface ProgressiveMesh extends Read { points: OwnFloats; base: OwnNumbers; splits: OwnNumbers; triangles?: undefined; baked?: undefined }
/** See Restrip.baked. */
export interface BakedMesh extends Read { baked: OwnBytes; triangles?: undefined; base?: undefined }

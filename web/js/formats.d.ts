/** Reads OBJ, OFF, PLY, GLB, or an OpenMesh progressive mesh (PM); the extension of `name` decides. Polygons are cut into
 * triangles. A baked mesh is given as its bytes. Throws an Error that says what is wrong. */
export function readMesh(name: string, content: ArrayBuffer | Uint8Array): Mesh | ProgressiveMesh | BakedMesh;

/** Three numbers a vertex, three a triangle. */
export interface Mesh { points: number[]; triangles: number[]; base?: undefined; baked?: undefined }
/** See Restrip.progressive. */
export interface ProgressiveMesh { points: number[]; base: number[]; splits: number[]; triangles?: undefined; baked?: undefined }
/** See Restrip.baked. */
export interface BakedMesh { baked: Uint8Array; triangles?: undefined; base?: undefined }

// Mesh files that a visitor may drop on the page: OBJ, OFF, PLY, GLB (as a mesh), and OpenMesh's progressive meshes
// (PM). Each reader returns { points, triangles } or { points, base, splits }, or throws an Error that says what is wrong.
// Baked meshes are read by the library (Restrip.baked); here they are { baked }, their bytes.

/// `name` decides by its extension.
export function readMesh(name, buffer) {
  const extension = name.toLowerCase().replace(/.*\./, '');
  if (extension === 'baked') return { baked: new Uint8Array(buffer.buffer ?? buffer, buffer.byteOffset ?? 0, buffer.byteLength) };
  const readers = { obj: readObj, off: readOff, ply: readPly, glb: readGlb, pm: readPm };
  if (!(extension in readers))
    throw new Error(`${name}: is none of the formats ${[...Object.keys(readers), 'baked'].join(', ').toUpperCase()}`);
  let mesh;
  try {
    mesh = readers[extension](buffer, name);
  } catch (error) {  // one of our sentences, or what the language says of a place that is not there
    throw error.message.startsWith(name) ? error : new Error(`${name}: is damaged or cut off (${error.message})`);
  }
  if ((mesh.triangles ?? mesh.base).length === 0) throw new Error(`${name}: has no triangles`);
  const vertices = mesh.points.length / 3;
  for (const corner of mesh.triangles ?? mesh.base)
    if (!(corner >= 0 && corner < vertices)) throw new Error(`${name}: a triangle refers to vertex ${corner} of ${vertices}`);
  for (const coordinate of mesh.points)
    if (!Number.isFinite(coordinate)) throw new Error(`${name}: a coordinate is infinite or not a number`);
  return mesh;
}

const text = (buffer) => new TextDecoder().decode(buffer);

function addPolygon(triangles, corners) {
  for (let i = 2; i < corners.length; ++i) triangles.push(corners[0], corners[i - 1], corners[i]);
}

function readObj(buffer) {
  const points = [];
  const triangles = [];
  for (const line of text(buffer).split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') points.push(+words[1], +words[2], +words[3]);
    if (words[0] !== 'f') continue;
    addPolygon(triangles, words.slice(1).map((word) => {
      const n = parseInt(word, 10);
      return n < 0 ? points.length / 3 + n : n - 1;
    }));
  }
  return { points, triangles };
}

function readOff(buffer, name) {
  const words = text(buffer).replace(/#.*/g, '').split(/\s+/).filter((word) => word !== '');
  if (words[0] !== 'OFF') throw new Error(`${name}: does not begin with OFF`);
  let at = 4;
  const next = () => {
    if (at >= words.length) throw new Error(`${name}: ends too early; is it complete?`);
    return +words[at++];
  };
  const points = Array.from({ length: 3 * words[1] }, next);
  const triangles = [];
  for (let face = 0; face < +words[2]; ++face) addPolygon(triangles, Array.from({ length: next() }, next));
  return { points, triangles };
}

const plyTypes = { char: ['Int8', 1], int8: ['Int8', 1], uchar: ['Uint8', 1], uint8: ['Uint8', 1], short: ['Int16', 2],
  int16: ['Int16', 2], ushort: ['Uint16', 2], uint16: ['Uint16', 2], int: ['Int32', 4], int32: ['Int32', 4],
  uint: ['Uint32', 4], uint32: ['Uint32', 4], float: ['Float32', 4], float32: ['Float32', 4], double: ['Float64', 8],
  float64: ['Float64', 8] };

function readPly(buffer, name) {
  const bytes = new Uint8Array(buffer);
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 65536));
  const end = /end_header\r?\n/.exec(head);
  if (!head.startsWith('ply') || !end) throw new Error(`${name}: has no PLY header`);
  let format = '';
  const elements = [];
  for (const line of head.slice(0, end.index).split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'format') format = words[1];
    if (words[0] === 'element') elements.push({ name: words[1], count: +words[2], properties: [] });
    if (words[0] === 'property') {
      const list = words[1] === 'list';
      const types = list ? [words[2], words[3]] : [words[1]];
      for (const type of types) if (!(type in plyTypes)) throw new Error(`${name}: has a property of type ${type}`);
      elements.at(-1).properties.push({ name: words.at(-1), list, types });
    }
  }
  const body = end.index + end[0].length;
  let read;
  if (format === 'ascii') {
    const words = text(bytes.subarray(body)).split(/\s+/).filter((word) => word !== '');
    let at = 0;
    read = () => {
      if (at >= words.length) throw new Error(`${name}: ends too early; is it complete?`);
      return +words[at++];
    };
  } else {
    const view = new DataView(bytes.buffer, bytes.byteOffset + body);
    const little = format === 'binary_little_endian';
    let at = 0;
    read = (type) => {
      const [getter, size] = plyTypes[type];
      if (at + size > view.byteLength) throw new Error(`${name}: ends too early; is it complete?`);
      at += size;
      return view[`get${getter}`](at - size, little);
    };
  }
  const points = [];
  const triangles = [];
  for (const element of elements) {
    for (let n = 0; n < element.count; ++n) {
      const at = {};
      for (const property of element.properties) {
        if (!property.list) at[property.name] = read(property.types[0]);
        else at[property.name] = Array.from({ length: read(property.types[0]) }, () => read(property.types[1]));
      }
      if (element.name === 'vertex') points.push(at.x, at.y, at.z);
      const corners = at.vertex_indices ?? at.vertex_index ?? [];
      if (element.name === 'face') addPolygon(triangles, corners);
      // -1 begins the next strip, as the type of the list is signed.
      if (element.name === 'tristrips') for (const corner of asTriangles(corners, 5, -1)) triangles.push(corner);
    }
  }
  return { points, triangles };
}

/// Vertices at the same place become one: glTF repeats them where normals or textures differ.
function welded(points, triangles) {
  const places = new Map();
  const out = [];
  const number = [];
  for (let v = 0; v < points.length; v += 3) {
    const key = `${points[v]} ${points[v + 1]} ${points[v + 2]}`;
    if (!places.has(key)) {
      places.set(key, out.length / 3);
      out.push(points[v], points[v + 1], points[v + 2]);
    }
    number.push(places.get(key));
  }
  return { points: out, triangles: triangles.map((v) => number[v]) };
}

/// The corners of the triangles of a list (mode 4), of strips (5) or fans (6); index `restart` begins anew.
function asTriangles(corners, mode, restart) {
  if (mode === 4) return corners;
  const out = [];
  let first = 0;
  corners.forEach((c, n) => {
    if (c === restart) first = n + 1;
    if (n < first + 2) return;
    const [a, b] = mode === 6 ? [corners[first], corners[n - 1]] : (n - first) % 2 === 0 ? [corners[n - 2], corners[n - 1]] : [corners[n - 1], corners[n - 2]];
    if (a !== b && b !== c && c !== a) out.push(a, b, c);
  });
  return out;
}

/// What a node does to points: the images of the three axes and of the origin.
function mapOf({ matrix, translation = [0, 0, 0], rotation: [x, y, z, w] = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  if (matrix) return [0, 4, 8, 12].map((at) => matrix.slice(at, at + 3));
  const turned = [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]];
  return [...turned.map((axis, n) => axis.map((c) => c * scale[n])), translation];
}
const moved = ([x, y, z, origin], p, isPoint) => [0, 1, 2].map((n) => x[n] * p[0] + y[n] * p[1] + z[n] * p[2] + (isPoint ? origin[n] : 0));
const product = (outer, inner) => inner.map((p, n) => moved(outer, p, n === 3));
const mirrors = ([x, y, z]) => x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]) < 0;

/// The meshes of the scene, each as often as a node has it, with the map of that node.
function placedMeshes(json, name) {
  const nodes = json.nodes ?? [];
  const identity = mapOf({});
  if (nodes.length === 0) return (json.meshes ?? []).map((mesh) => [mesh, identity]);
  const children = new Set(nodes.flatMap((node) => node.children ?? []));
  const tops = json.scenes?.length ? json.scenes[json.scene ?? 0].nodes ?? [] : nodes.map((_, n) => n).filter((n) => !children.has(n));
  const seen = new Set();
  const placed = [];
  const open = tops.map((n) => [n, identity]).reverse();
  while (open.length > 0) {
    const [n, outer] = open.pop();
    if (seen.has(n)) throw new Error(`${name}: node ${n} is in the scene twice; nodes must form trees`);
    seen.add(n);
    const map = product(outer, mapOf(nodes[n]));
    if (nodes[n].mesh !== undefined) placed.push([json.meshes[nodes[n].mesh], map]);
    for (const child of [...nodes[n].children ?? []].reverse()) open.push([child, map]);
  }
  return placed;
}

const gltfTypes = { 5120: ['Int8', 1, 127], 5121: ['Uint8', 1, 255], 5122: ['Int16', 2, 32767], 5123: ['Uint16', 2, 65535], 5125: ['Uint32', 4],
  5126: ['Float32', 4] };

function readGlb(buffer, name) {
  const view = new DataView(buffer.buffer ?? buffer, buffer.byteOffset ?? 0, buffer.byteLength);
  if (view.byteLength < 20 || view.getUint32(0, true) !== 0x46546c67) throw new Error(`${name}: is no binary glTF`);
  const jsonBytes = view.getUint32(12, true);
  const json = JSON.parse(text(new Uint8Array(view.buffer, view.byteOffset + 20, jsonBytes)));
  const binary = view.byteOffset + 20 + jsonBytes + 8;
  const read = (accessorNumber) => {
    const accessor = json.accessors[accessorNumber];
    const part = json.bufferViews[accessor.bufferView];
    if (!part || accessor.sparse || part.extensions) throw new Error(`${name}: is compressed or sparse, which is not read`);
    const [getter, size, most] = gltfTypes[accessor.componentType];
    const width = { SCALAR: 1, VEC3: 3 }[accessor.type];
    const stride = part.byteStride ?? size * width;
    const first = binary + (part.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    const data = new DataView(view.buffer, first, view.byteOffset + view.byteLength - first);
    const value = (n) => data[`get${getter}`](Math.floor(n / width) * stride + (n % width) * size, true);
    // KHR_mesh_quantization: whole numbers, as they are or as shares of the largest.
    return Array.from({ length: accessor.count * width }, (_, n) => (accessor.normalized ? Math.max(value(n) / most, -1) : value(n)));
  };
  const points = [];
  const triangles = [];
  for (const [mesh, map] of placedMeshes(json, name)) {
    for (const primitive of mesh.primitives) {
      const mode = primitive.mode ?? 4;
      if (mode < 4) continue;  // points and lines
      const first = points.length / 3;
      const own = read(primitive.attributes.POSITION);
      for (let v = 0; v < own.length; v += 3) points.push(...moved(map, own.slice(v, v + 3), true));
      const corners = primitive.indices === undefined ? Array.from({ length: own.length / 3 }, (_, n) => n) : read(primitive.indices);
      const restart = { 5121: 0xff, 5123: 0xffff, 5125: 0xffffffff }[json.accessors[primitive.indices]?.componentType];
      const list = asTriangles(corners, mode, restart);
      const turn = mirrors(map);
      for (let i = 0; i < list.length; i += 3) {
        const [a, b, c] = [list[i], list[i + 1], list[i + 2]].map((corner) => first + corner);
        triangles.push(a, ...(turn ? [c, b] : [b, c]));
      }
    }
  }
  return welded(points, triangles);
}

/// OpenMesh names a split v_t -> v_s with v_l to its left, so its v_l is our v_r.
function readPm(buffer, name) {
  const view = new DataView(buffer.buffer ?? buffer, buffer.byteOffset ?? 0, buffer.byteLength);
  if (view.byteLength < 20 || text(new Uint8Array(view.buffer, view.byteOffset, 8)) !== 'ProgMesh')
    throw new Error(`${name}: is no progressive mesh of OpenMesh`);
  let at = 8;
  const u32 = () => view.getUint32((at += 4) - 4, true);
  const f32 = () => view.getFloat32((at += 4) - 4, true);
  const [vertices, faces, count] = [u32(), u32(), u32()];
  if (view.byteLength !== 20 + 12 * vertices + 12 * faces + 24 * count)
    throw new Error(`${name}: has not the length that its header promises; is it complete?`);
  const points = Array.from({ length: 3 * vertices }, f32);
  const base = Array.from({ length: 3 * faces }, u32);
  const splits = [];
  for (let i = 0; i < count; ++i) {
    points.push(f32(), f32(), f32());
    const [vS, vR, vL] = [u32(), u32(), u32()];
    splits.push(vS, vertices + i, vL, vR);
  }
  return { points, base, splits };
}

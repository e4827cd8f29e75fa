// The code that the viewer prints under "Use it" runs as printed. WebGL and WebGPU draw the same picture from strips and
// from the triangle list, at several levels, also after the buffer has outgrown its storage. After three.js has uploaded
// the ranges its copy of the list, or of the strips, equals the mesh's, and only the draw call of the object with strips
// has their mode; with the package in the folder RESTRIP_THREE its renderer draws both. The triangles that a stroke
// reports as removed and added turn one list into the next. (tests/runtime/live_mesh_test.cpp compiles the C++ code.)
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/// For Browser.start: WebGPU on the software device.
export const gpuFlags = ['--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', '--enable-features=Vulkan'];
const three = process.env.RESTRIP_THREE;
/// The classes of three.js that the lines use, as its manual describes them.
export const standIn = `export class BufferAttribute {
    updateRanges = []; version = 0;
    constructor(array, itemSize) { Object.assign(this, { array, itemSize }); }
    addUpdateRange(start, count) { this.updateRanges.push({ start, count }); }
    clearUpdateRanges() { this.updateRanges.length = 0; }
    set needsUpdate(value) { if (value === true) ++this.version; }
  }
  export class BufferGeometry {
    attributes = {}; drawRange = { start: 0, count: Infinity };
    setAttribute(name, attribute) { this.attributes[name] = attribute; return this; }
    getAttribute(name) { return this.attributes[name]; }
    setIndex(index) { this.index = index; return this; }
    setDrawRange(start, count) { this.drawRange = { start, count }; }
  }`;

/// The files that a server adds to the package, as [address, [type, content]]; with the names that scripts import.
export function printed(folder) {
  const page = readFileSync(join(folder, 'viewer.html'), 'utf8');
  const part = page.slice(page.indexOf('id="part-use"'), page.indexOf('</section>', page.indexOf('id="part-use"')));
  const blocks = [...part.matchAll(/<pre tabindex="0"><code>([^]*?)<\/code><\/pre>/g)]
    .map(([, text]) => text.replace(/<[^>]*>/g, '').replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&'));
  assert.equal(blocks.length, 6);
  const [live, ...scripts] = blocks;
  const compiled = readFileSync(fileURLToPath(new URL('../../web/viewer/use/live.inc', import.meta.url)), 'utf8');
  assert.equal(`${live}\n`, compiled, 'the lines for C++ are not those that are compiled');
  const script = (content) => ['text/javascript', content];
  const files = ['begin', 'webgl', 'webgpu', 'three', 'sculpt'].map((name, n) => [`/use/${name}.mjs`, script(scripts[n])]);
  const ours = three ? ['three.module.js', 'three.core.js'].map((name) => [`/three/${name}`, script(readFileSync(join(three, 'build', name)))])
    : [['/three/three.module.js', script(standIn)]];
  return { files: [...files, ...ours], imports: { three: '/three/three.module.js' } };
}

/// Runs in a page that has the package; returns its observations.
async function run(size, real) {
  const { readMesh } = await (await import('restrip-wasm/formats')).loadReaders();
  const { begin } = await import('/use/begin.mjs');
  const { points, triangles } = await readMesh('hare.obj', await (await fetch('/hare.obj')).arrayBuffer());
  const { differ, picture, useFlatProgram } = await import('/pictures.mjs');
  /// The pictures at several levels, of strips and of the list; each as pixels that differ.
  const compare = async (mesh, strips, list, empty) => {
    const found = [];
    for (const share of [0, 1, 0.9, 0.95]) {
      mesh.moveTo(Math.round(share * mesh.levels));
      const other = await list(mesh.triangles);
      found.push({ different: differ(await strips(), other), shown: differ(other, await empty()) });
    }
    return found;
  };

  const webgl = async () => {
    const { draw } = await import('/use/webgl.mjs');
    const mesh = await begin(points, triangles);
    const gl = Object.assign(document.createElement('canvas'), { width: size, height: size }).getContext('webgl2', { antialias: false });
    useFlatProgram(gl);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, mesh.points, gl.STATIC_DRAW);
    const [own, other] = [0, 1].map(() => {
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      return array;
    });
    const seen = (array, drawing) => picture(gl, () => {
      gl.bindVertexArray(array);
      drawing();
    });
    const found = await compare(mesh, () => seen(own, () => draw(gl, mesh)), (list) => seen(other, () => {
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STREAM_DRAW);
      gl.drawElements(gl.TRIANGLES, list.length, gl.UNSIGNED_INT, 0);
    }), () => seen(null, () => {}));
    return { found, error: gl.getError() };
  };

  const webgpu = async () => {
    const { draw, primitive } = await import('/use/webgpu.mjs');
    const mesh = await begin(points, triangles);
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) throw new Error('this Chromium has no WebGPU adapter');
    const device = await adapter.requestDevice();
    const errors = [];
    device.onuncapturederror = ({ error }) => errors.push(error.message);
    const module = device.createShaderModule({ code: `struct Seen { @builtin(position) at: vec4f, @location(0) place: vec3f }
      @vertex fn vertex(@location(0) place: vec3f) -> Seen { return Seen(vec4f(0.5 * place.xy, 0.5 + 0.3 * place.z, 1.0), place); }
      @fragment fn fragment(seen: Seen) -> @location(0) vec4f {
        return vec4f(0.5 + 0.5 * normalize(cross(dpdx(seen.place), dpdy(seen.place))), 1.0); }` });
    const pipeline = (form) => device.createRenderPipeline({ layout: 'auto', primitive: form,
      vertex: { module, buffers: [{ arrayStride: 12, attributes: [{ shaderLocation: 0, offset: 0, format: 'float32x3' }] }] },
      fragment: { module, targets: [{ format: 'rgba8unorm' }] }, depthStencil: { format: 'depth32float', depthWriteEnabled: true, depthCompare: 'less' } });
    const [strips, list] = [primitive, { topology: 'triangle-list' }].map(pipeline);
    const filled = (data, usage) => {
      const buffer = device.createBuffer({ size: data.byteLength, usage: usage | GPUBufferUsage.COPY_DST });
      device.queue.writeBuffer(buffer, 0, data);
      return buffer;
    };
    const vertices = filled(mesh.points, GPUBufferUsage.VERTEX);
    const target = (format, usage) => device.createTexture({ size: [size, size], format, usage: GPUTextureUsage.RENDER_ATTACHMENT | usage });
    const [color, depth] = [target('rgba8unorm', GPUTextureUsage.COPY_SRC), target('depth32float', 0)];
    const read = device.createBuffer({ size: 4 * size * size, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const seen = async (kind, drawing) => {
      const encoder = device.createCommandEncoder();
      const pass = encoder.beginRenderPass({ colorAttachments: [{ view: color.createView(), loadOp: 'clear', storeOp: 'store' }],
        depthStencilAttachment: { view: depth.createView(), depthLoadOp: 'clear', depthStoreOp: 'discard', depthClearValue: 1 } });
      pass.setPipeline(kind);
      pass.setVertexBuffer(0, vertices);
      drawing(pass);
      pass.end();
      encoder.copyTextureToBuffer({ texture: color }, { buffer: read, bytesPerRow: 4 * size }, [size, size]);
      device.queue.submit([encoder.finish()]);
      await read.mapAsync(GPUMapMode.READ);
      const pixels = new Uint8Array(read.getMappedRange()).slice();
      read.unmap();
      return pixels;
    };
    const found = await compare(mesh, () => seen(strips, (pass) => draw(device, pass, mesh)), (indices) => seen(list, (pass) => {
      pass.setIndexBuffer(filled(indices, GPUBufferUsage.INDEX), 'uint32');
      pass.drawIndexed(indices.length);
    }), () => seen(list, () => {}));
    return { found, error: errors.join('; ') };
  };

  const threejs = async (strips) => {
    const THREE = await import('three');
    const { geometryOf, follow, drawAsStrips } = await import('/use/three.mjs');
    const mesh = await (strips ? begin(points, triangles) : begin(points, triangles, { policy: 'bare', form: 'list' }));
    const geometry = geometryOf(mesh);
    const { index } = geometry;
    // The renderer: what it uploads when, and its copy. The real one clears the ranges itself.
    const card = { version: -1, copy: new Uint32Array(index.array.length), uploaded: 0 };
    const upload = () => {
      card.uploaded = 0;
      if (index.version === card.version) return;
      const ranges = card.version < 0 || index.updateRanges.length === 0 ? [{ start: 0, count: index.array.length }] : index.updateRanges;
      for (const { start, count } of ranges) {
        card.copy.set(index.array.subarray(start, start + count), start);
        card.uploaded += count;
      }
      card.version = index.version;
      if (!renderer) index.clearUpdateRanges();
    };
    let renderer = null;
    let found = [];
    const reported = [];
    const followed = () => {
      follow(mesh, geometry);
      upload();
      const list = mesh.indices;
      const { start, count } = geometry.drawRange;
      reported.push({ same: start === 0 && count === list.length && list.every((v, n) => v === card.copy[n]), uploaded: card.uploaded, all: list.length });
    };
    if (real) {
      renderer = new THREE.WebGLRenderer({ antialias: false });
      renderer.setSize(size, size);
      const camera = new THREE.OrthographicCamera(-2, 2, 2, -2, -4, 4);
      const gl = renderer.getContext();
      const material = new THREE.MeshNormalMaterial({ flatShading: true, side: THREE.DoubleSide });
      const seen = (...shapes) => {
        const scene = new THREE.Scene();
        for (const shape of shapes) {
          const object = Object.assign(new THREE.Mesh(shape, material), { frustumCulled: false });
          if (strips && shape === geometry) drawAsStrips(renderer, object);
          scene.add(object);
        }
        return picture(gl, () => renderer.render(scene, camera));
      };
      found = await compare(mesh, () => { followed(); return seen(geometry); }, (list) => seen(new THREE.BufferGeometry()
        .setAttribute('position', new THREE.BufferAttribute(mesh.points, 3)).setIndex(new THREE.BufferAttribute(list, 1))), () => seen());
    } else {
      for (const share of [0, 1, 0.9, 0.95]) {
        mesh.moveTo(Math.round(share * mesh.levels));
        followed();
      }
    }
    for (const step of [1, -1, 3]) {
      mesh.moveTo(mesh.figures.played + step);
      followed();
      index.clearUpdateRanges();
    }
    followed();  // nothing has changed
    if (!strips) return { found, reported, error: 0 };
    // Another object is drawn before, between and after.
    const modes = [];
    const [gl, object] = [{ TRIANGLES: 4, TRIANGLE_STRIP: 5, drawElements(mode, count) { modes.push([mode, count, this === gl]); } }, {}];
    drawAsStrips({ getContext: () => gl }, object);
    for (const own of [false, true, false]) {
      if (own) object.onBeforeRender();
      gl.drawElements(gl.TRIANGLES, 9);
      if (own) object.onAfterRender();
    }
    return { found, reported, error: JSON.stringify(modes) === '[[4,9,true],[5,9,true],[4,9,true]]' ? 0 : JSON.stringify(modes) };
  };

  const sculpt = async () => {
    const { stroke } = await import('/use/sculpt.mjs');
    const mesh = await begin(points, triangles, { policy: 'bare', form: 'list' });
    const wanted = new Uint8Array(mesh.levels);
    mesh.update();
    let seen = mesh.indices.slice();
    const slots = Array.from({ length: seen.length / 3 }, (_, slot) => `${seen.subarray(3 * slot, 3 * slot + 3)}`);
    const strokes = [];
    for (const radius of [0.2, 0.3, 0.1, 0]) {
      const at = 3 * (strokes.length * 1000);
      if (radius === 0) wanted.fill(0);  // everything that the brush refined is coarsened again
      const before = seen.length / 3;
      const { removed, added, seen: now } = stroke(mesh, { center: [...mesh.points.subarray(at, at + 3)], radius }, wanted, seen);
      for (const { slot, corners } of removed) {
        if (slots[slot] !== `${corners}`) throw new Error(`slot ${slot} did not have ${corners}`);
        delete slots[slot];
      }
      for (const { slot, corners } of added) slots[slot] = `${corners}`;
      seen = now;
      // The mesh's own triangles, which may begin with another corner.
      const name = ([a, b, c]) => `${a < b && a < c ? [a, b, c] : b < c ? [b, c, a] : [c, a, b]}`;
      const names = (list) => list.map(name).sort().join(' ');
      const own = mesh.triangles;
      const followed = slots.flatMap((text) => [text.split(',').map(Number)]);
      strokes.push({ before, removed: removed.length, added: added.length, triangles: mesh.figures.triangles,
        same: names(followed) === names(Array.from({ length: own.length / 3 }, (_, t) => [...own.subarray(3 * t, 3 * t + 3)])) });
    }
    return strokes;
  };
  return { webgl: await webgl(), webgpu: await webgpu(), three: await threejs(false), threeStrips: await threejs(true), strokes: await sculpt() };
}

export async function checkUse(page) {
  const size = 256;
  const { strokes, ...drawn } = await page.run(run, size, Boolean(three));
  for (const [name, { found, error }] of Object.entries(drawn)) {
    assert.ok(!error, `${name}: ${error}`);
    assert.equal(found.length, name.startsWith('three') && !three ? 0 : 4);
    // Colours that are interpolated from another corner of a triangle may round differently.
    for (const { different, shown } of found) assert.ok(shown > 3000 && different <= shown / 1000, `${name}: ${JSON.stringify(found)}`);
  }
  for (const { reported } of [drawn.three, drawn.threeStrips]) {
    assert.ok(reported.length === 8 && reported.every(({ same }) => same), JSON.stringify(reported));
    for (const { uploaded, all } of reported.slice(4, 7)) assert.ok(uploaded > 0 && uploaded < all / 20, `${uploaded} of ${all}`);
    assert.equal(reported.at(-1).uploaded, 0);
  }
  for (const { before, removed, added, triangles, same } of strokes) {
    assert.ok(same, JSON.stringify(strokes));
    assert.ok(removed > 0 && removed <= before && triangles === before - removed + added, JSON.stringify(strokes));
  }
  assert.ok(strokes[0].added > strokes[0].removed && strokes.at(-1).added < strokes.at(-1).removed, JSON.stringify(strokes));
  if (!three) console.log('left out: the renderer of three.js; RESTRIP_THREE names no folder of the package');
}

// What WebGL draws. The index buffer on the card is a copy of the live one, kept in step by its changed ranges alone,
// and is drawn as one triangle strip with primitive restart.
import { multiply } from './camera.mjs';

const surfaceVertex = `#version 300 es
uniform mat4 view, projection;
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 tint;
out vec3 seen;
out vec4 own;
void main() { vec4 at = view * vec4(place, 1.0); seen = at.xyz; own = tint; gl_Position = projection * at; }`;
const surfaceFragment = `#version 300 es
precision highp float;
uniform vec4 paint;
uniform float flatness;
in vec3 seen;
in vec4 own;
out vec4 pixel;
void main() {
  vec4 color = paint * own;
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.42 + 0.5 * max(dot(normal, normalize(vec3(0.3, 0.5, 0.8))), 0.0) + 0.16 * max(dot(normal, vec3(-0.7, 0.2, 0.3)), 0.0);
  pixel = vec4(mix(color.rgb * light, color.rgb, flatness) * color.a, color.a);
}`;
// Each segment is a quad of some width on the screen; one that ends a strip is an arrow head.
const lineVertex = `#version 300 es
uniform mat4 all;
uniform vec2 size;
uniform float width;
in vec4 start;
in vec4 end;
flat out float strip;
void main() {
  vec4 a = all * vec4(start.xyz, 1.0), b = all * vec4(end.xyz - 0.0, 1.0);
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1) - 0.5);
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  along = length(along) > 0.0001 ? normalize(along) : vec2(1.0, 0.0);
  vec4 at = corner.x < 0.5 ? a : b;
  float broad = end.w > 0.5 ? (corner.x < 0.5 ? 3.6 : 0.0) : 1.0;
  at.xy += vec2(-along.y, along.x) * corner.y * broad * width / size * at.w * 2.0;
  at.z -= 0.0004 * at.w;  // over the surface
  strip = start.w;
  gl_Position = at;
}`;
const lineFragment = `#version 300 es
precision highp float;
flat in float strip;
out vec4 pixel;
vec3 hue(float h) { return clamp(abs(mod(h * 6.0 + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0); }
void main() { pixel = vec4(mix(vec3(0.5), hue(fract(strip * 0.6180339887)), 0.62) * 0.8, 1.0); }`;

/// A colour for each strip: hues by the golden ratio.
export function stripColor(strip) {
  const hue = strip * 0.618033988749895 % 1;
  const light = 0.60 + 0.09 * (strip % 3);
  const channel = (n) => {
    const k = (n + hue * 12) % 12;
    return light - 0.62 * Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1));
  };
  return [channel(0), channel(8), channel(4), 1];
}

export class Scene {
  bytesUploaded = 0;  // of the index buffer, since it was asked last
  wholeUploads = 0;
  #gl;
  #programs = {};
  #room = 0;

  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('This browser offers no WebGL 2, so the mesh cannot be shown. The picture is a still one.');
    this.#gl = gl;
    this.canvas = canvas;
    for (const [name, vertex, fragment] of [['surface', surfaceVertex, surfaceFragment], ['line', lineVertex, lineFragment]])
      this.#programs[name] = this.#program(vertex, fragment);
    this.points = gl.createBuffer();
    this.live = gl.createBuffer();
    this.other = gl.createBuffer();
    this.segments = gl.createBuffer();
    this.corners = gl.createBuffer();
    // Places alone, and all of one colour; or places with a colour each.
    gl.vertexAttrib4f(1, 1, 1, 1, 1);
    [this.surface, this.coloured] = [[this.points, 0], [this.corners, 16]].map(([buffer, stride]) => {
      const array = gl.createVertexArray();
      gl.bindVertexArray(array);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, stride, 0);
      if (stride === 0) return array;
      gl.enableVertexAttribArray(1);
      gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, stride, 12);
      return array;
    });
    this.lines = gl.createVertexArray();
    gl.bindVertexArray(this.lines);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.segments);
    for (const [name, offset] of [['start', 0], ['end', 16]]) {
      const at = gl.getAttribLocation(this.#programs.line.program, name);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 4, gl.FLOAT, false, 32, offset);
      gl.vertexAttribDivisor(at, 1);
    }
  }
  #program(vertex, fragment) {
    const gl = this.#gl;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return { program, at: (name) => gl.getUniformLocation(program, name) };
  }

  get lost() { return this.#gl.isContextLost(); }
  setPoints(points) {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.points);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.STATIC_DRAW);
    this.#room = 0;
  }
  /// Copies the ranges that changed; everything only where the buffer has outgrown its room.
  upload(indices, ranges) {
    const gl = this.#gl;
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
    if (indices.length > this.#room) {
      this.#room = Math.ceil(indices.length * 1.3);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, 4 * this.#room, gl.DYNAMIC_DRAW);
      ranges = [{ first: 0, count: indices.length }];
      ++this.wholeUploads;
    }
    for (const { first, count } of ranges) {
      if (count === 0) continue;
      gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 4 * first, indices, first, count);
      this.bytesUploaded += 4 * count;
    }
  }

  /// The strips in colours of their own, for one draw call: vertices are shared among strips, so that each triangle has
  /// three corners of its own here, read from the runs of the live buffer.
  paint(points, indices, runs) {
    const gl = this.#gl;
    const places = new Float32Array(4 * 3 * indices.length);
    const colors = new Uint32Array(places.buffer);
    let end = 0;
    for (let r = 0; r < runs.length; r += 3) {
      const [red, green, blue] = stripColor(runs[r + 2]).map((channel) => Math.round(255 * channel));
      const color = (0xff000000 | blue << 16 | green << 8 | red) >>> 0;
      for (let i = runs[r] + 2; i < runs[r] + runs[r + 1]; ++i) {
        const [a, b, c] = [indices[i - 2], indices[i - 1], indices[i]];
        if (a === b || b === c || c === a) continue;
        for (const v of [a, b, c]) {
          for (let n = 0; n < 3; ++n) places[end + n] = points[3 * v + n];
          colors[end + 3] = color;
          end += 4;
        }
      }
    }
    this.painted = end / 4;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    gl.bufferData(gl.ARRAY_BUFFER, places.subarray(0, end), gl.DYNAMIC_DRAW);
  }
  /// The strips as lines: start with the strip as its fourth number, end with the mark of a strip's end.
  setLines(lines) {
    const gl = this.#gl;
    for (let i = 0; i < lines.length; i += 8) lines.set([lines[i + 6], lines[i + 3], lines[i + 4], lines[i + 5]], i + 3);
    this.drawnLines = lines.length / 8;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.segments);
    gl.bufferData(gl.ARRAY_BUFFER, lines, gl.DYNAMIC_DRAW);
  }

  /// `style`: shaded, strips (as they were painted), lines (over the surface). `patch`: triangles to be marked. `list`:
  /// draws these triangles instead of the live buffer, to compare with it.
  draw(camera, { style, length, patch, list, ink, paper }) {
    const gl = this.#gl;
    const { width, height } = this.canvas;
    const view = camera.view();
    const projection = camera.projection(width / height);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    const surface = this.#programs.surface;
    gl.useProgram(surface.program);
    gl.bindVertexArray(this.surface);
    gl.uniformMatrix4fv(surface.at('view'), false, view);
    gl.uniformMatrix4fv(surface.at('projection'), false, projection);
    gl.uniform1f(surface.at('flatness'), 0);
    const color = surface.at('paint');
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    if (list) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STREAM_DRAW);
      gl.uniform4f(color, ...ink, 1);
      gl.drawElements(gl.TRIANGLES, list.length, gl.UNSIGNED_INT, 0);
    } else {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
      if (style === 'strips') {
        gl.bindVertexArray(this.coloured);
        gl.uniform4f(color, 1, 1, 1, 1);
        gl.drawArrays(gl.TRIANGLES, 0, this.painted);
        gl.bindVertexArray(this.surface);
      } else {
        gl.uniform4f(color, ...ink, 1);
        gl.drawElements(gl.TRIANGLE_STRIP, length, gl.UNSIGNED_INT, 0);
      }
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (patch && patch.length > 0) this.#drawPatch(patch, camera, surface, color);
    if (style === 'lines' && !list) this.#drawLines(multiply(projection, view), 1.5 * (window.devicePixelRatio || 1));
  }
  #drawPatch(patch, camera, surface, color) {
    const gl = this.#gl;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthFunc(gl.LEQUAL);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
    gl.uniform1f(surface.at('flatness'), 1);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, patch, gl.STREAM_DRAW);
    gl.uniform4f(color, 1, 0.72, 0.1, 0.55);
    gl.drawElements(gl.TRIANGLES, patch.length, gl.UNSIGNED_INT, 0);
    const edges = [];
    for (let i = 0; i < patch.length; i += 3) edges.push(patch[i], patch[i + 1], patch[i + 1], patch[i + 2], patch[i + 2], patch[i]);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(edges), gl.STREAM_DRAW);
    gl.uniform4f(color, 0.25, 0.1, 0, 1);
    gl.drawElements(gl.LINES, edges.length, gl.UNSIGNED_INT, 0);
    gl.depthFunc(gl.LESS);
    gl.disable(gl.BLEND);
  }
  #drawLines(all, width) {
    const gl = this.#gl;
    const line = this.#programs.line;
    gl.useProgram(line.program);
    gl.bindVertexArray(this.lines);
    gl.uniformMatrix4fv(line.at('all'), false, all);
    gl.uniform2f(line.at('size'), this.canvas.width, this.canvas.height);
    gl.uniform1f(line.at('width'), width);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.drawnLines);
  }
  /// What the card has of the live buffer.
  copyOnCard(length) {
    const gl = this.#gl;
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
    const out = new Uint32Array(length);
    gl.getBufferSubData(gl.ELEMENT_ARRAY_BUFFER, 0, out);
    return out;
  }
  pixels() {
    const gl = this.#gl;
    const out = new Uint8Array(4 * this.canvas.width * this.canvas.height);
    gl.readPixels(0, 0, this.canvas.width, this.canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, out);
    return out;
  }
}

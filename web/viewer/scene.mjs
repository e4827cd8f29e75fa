// What WebGL draws. The index buffer on the card is a copy of the live one, kept in step by its changed ranges alone,
// and is drawn as one triangle strip with primitive restart.
import { multiply } from './camera.mjs';

const surfaceVertex = `#version 300 es
uniform mat4 view, projection;
in vec3 place;
out vec3 seen;
void main() { vec4 at = view * vec4(place, 1.0); seen = at.xyz; gl_Position = projection * at; }`;
const surfaceFragment = `#version 300 es
precision highp float;
uniform vec4 color;
uniform float flatness;
in vec3 seen;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.42 + 0.5 * max(dot(normal, normalize(vec3(0.3, 0.5, 0.8))), 0.0) + 0.16 * max(dot(normal, vec3(-0.7, 0.2, 0.3)), 0.0);
  pixel = vec4(mix(color.rgb * light, color.rgb, flatness) * color.a, color.a);
}`;
// Each segment is a quad of some width on the screen; one that ends a strip is an arrow head.
const lineVertex = `#version 300 es
uniform mat4 all;
uniform vec2 size;
uniform float width, lift;
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
  at.z -= lift * at.w;
  strip = start.w;
  gl_Position = at;
}`;
const lineFragment = `#version 300 es
precision highp float;
uniform vec4 color;
uniform float own;
flat in float strip;
out vec4 pixel;
vec3 hue(float h) { return clamp(abs(mod(h * 6.0 + vec3(0.0, 4.0, 2.0), 6.0) - 3.0) - 1.0, 0.0, 1.0); }
void main() { pixel = own > 0.5 ? vec4(mix(vec3(0.5), hue(fract(strip * 0.6180339887)), 0.62) * 0.8, 1.0) : color; }`;

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
    if (!gl) throw new Error('This browser offers no WebGL 2, which the picture needs.');
    this.#gl = gl;
    this.canvas = canvas;
    for (const [name, vertex, fragment] of [['surface', surfaceVertex, surfaceFragment], ['line', lineVertex, lineFragment]])
      this.#programs[name] = this.#program(vertex, fragment);
    this.points = gl.createBuffer();
    this.live = gl.createBuffer();
    this.other = gl.createBuffer();
    this.segments = gl.createBuffer();
    this.surface = gl.createVertexArray();
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.points);
    const place = gl.getAttribLocation(this.#programs.surface.program, 'place');
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
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

  /// `style`: shaded, strips (`runs` in colours of their own), lines (`segments` over the surface). `patch`: triangles
  /// to be marked. `list`: draws these triangles instead of the live buffer, to compare with it.
  draw(camera, { style, length, runs, segments, patch, list, ink, paper }) {
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
    const color = surface.at('color');
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    if (list) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STREAM_DRAW);
      gl.uniform4f(color, ...ink, 1);
      gl.drawElements(gl.TRIANGLES, list.length, gl.UNSIGNED_INT, 0);
    } else {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
      if (style === 'strips' && runs) {
        for (let i = 0; i < runs.length; i += 3) {
          gl.uniform4f(color, ...stripColor(runs[i + 2]));
          gl.drawElements(gl.TRIANGLE_STRIP, runs[i + 1], gl.UNSIGNED_INT, 4 * runs[i]);
        }
      } else {
        gl.uniform4f(color, ...ink, 1);
        gl.drawElements(gl.TRIANGLE_STRIP, length, gl.UNSIGNED_INT, 0);
      }
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (patch && patch.length > 0) this.#drawPatch(patch, camera, surface, color);
    if (segments && style === 'lines') this.#drawSegments(segments, multiply(projection, view), 1.5 * (window.devicePixelRatio || 1), 0.0004, true);
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
  #drawSegments(segments, all, width, lift, own) {
    const gl = this.#gl;
    const line = this.#programs.line;
    // Three numbers of the end, then the mark: start has the strip as its fourth.
    const packed = new Float32Array(segments.length);
    for (let i = 0; i < segments.length; i += 8) {
      packed.set([segments[i], segments[i + 1], segments[i + 2], segments[i + 6], segments[i + 3], segments[i + 4], segments[i + 5], segments[i + 7]], i);
    }
    gl.useProgram(line.program);
    gl.bindVertexArray(this.lines);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.segments);
    gl.bufferData(gl.ARRAY_BUFFER, packed, gl.STREAM_DRAW);
    gl.uniformMatrix4fv(line.at('all'), false, all);
    gl.uniform2f(line.at('size'), this.canvas.width, this.canvas.height);
    gl.uniform1f(line.at('width'), width);
    gl.uniform1f(line.at('lift'), lift);
    gl.uniform1f(line.at('own'), own ? 1 : 0);
    gl.uniform4f(line.at('color'), 0, 0, 0, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, packed.length / 8);
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

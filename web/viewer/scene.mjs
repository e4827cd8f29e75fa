// What WebGL draws. The index buffer on the card is a copy of the live one, kept in step by its changed ranges alone,
// and is drawn as one triangle strip with primitive restart.
import { multiply } from './camera.mjs';

const surfaceVertex = `#version 300 es
uniform mat4 view, projection;
layout(location = 0) in vec3 place;
out vec3 seen;
void main() { vec4 at = view * vec4(place, 1.0); seen = at.xyz; gl_Position = projection * at; }`;
const shade = `
float shade(vec3 seen) {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  return 0.46 + 0.5 * max(dot(normal, normalize(vec3(0.3, 0.5, 0.8))), 0.0) + 0.16 * max(dot(normal, vec3(-0.7, 0.2, 0.3)), 0.0);
}`;
const surfaceFragment = `#version 300 es
precision highp float;
uniform vec4 paint;
uniform float flatness;
in vec3 seen;
out vec4 pixel;
${shade}
void main() { pixel = vec4(mix(paint.rgb * shade(seen), paint.rgb, flatness) * paint.a, paint.a); }`;
// Ribbons: dark walls at the sides where a strip does not go on, thin edges within it, and a light that runs along it.
const ribbonVertex = `#version 300 es
uniform mat4 view, projection;
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 tint;
layout(location = 2) in vec2 way;
out vec3 seen, inside;
out vec2 along;
out vec3 own;
flat out vec3 wall;
void main() {
  vec4 at = view * vec4(place, 1.0);
  seen = at.xyz;
  own = tint.rgb;
  along = way;
  int corner = gl_VertexID % 3, walls = int(tint.a * 255.0 + 0.5);
  inside = vec3(corner == 0, corner == 1, corner == 2);
  wall = vec3(walls >> 1 & 1, walls >> 2 & 1, walls & 1);  // by the corner that lies opposite
  gl_Position = projection * at;
}`;
const ribbonFragment = `#version 300 es
precision highp float;
uniform float time, density;
in vec3 seen, inside, own;
in vec2 along;
flat in vec3 wall;
out vec4 pixel;
${shade}
void main() {
  vec3 color = own * shade(seen);
  if (time >= 0.0 && along.y > 2.5) {
    float tail = clamp(along.y * 0.05, 2.0, 60.0), lasts = clamp(along.y / 150.0, 2.0, 12.0);
    float behind = fract(time / lasts) * (along.y + 3.0 * tail) - along.x;
    color = mix(color, vec3(1.0, 0.99, 0.92), behind > -0.6 ? 0.85 * exp(-max(behind, 0.0) / tail) : 0.0);
  }
  vec3 step = fwidth(inside) * density;
  vec3 thick = (1.0 - smoothstep(vec3(0.6), vec3(1.7), inside / step)) * wall;
  vec3 thin = 1.0 - smoothstep(vec3(0.0), vec3(0.9), inside / step);
  // Lines fade where triangles are hardly larger than they.
  vec3 room = smoothstep(vec3(2.0), vec3(9.0), 1.0 / step);
  color *= 1.0 - 0.22 * max(max(thin.x * room.x, thin.y * room.y), thin.z * room.z);
  thick *= 0.35 + 0.55 * room;
  pixel = vec4(mix(color, vec3(0.05, 0.06, 0.09), max(max(thick.x, thick.y), thick.z)), 1.0);
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

export class Scene {
  bytesUploaded = 0;  // of the index buffer, since it was asked last
  #gl;
  #programs = {};
  #room = 0;

  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('This browser offers no WebGL 2, so the mesh cannot be shown. The picture is a still one.');
    this.#gl = gl;
    this.canvas = canvas;
    for (const [name, vertex, fragment] of [['surface', surfaceVertex, surfaceFragment], ['ribbon', ribbonVertex, ribbonFragment], ['line', lineVertex, lineFragment]])
      this.#programs[name] = this.#program(vertex, fragment);
    this.points = gl.createBuffer();
    this.live = gl.createBuffer();
    this.other = gl.createBuffer();
    this.segments = gl.createBuffer();
    this.surface = this.#array(this.points, 0, [[0, 3, gl.FLOAT, false, 0]]);
    const corners = gl.createBuffer();
    this.ribbon = { buffer: corners, array: this.#array(corners, 24, [[0, 3, gl.FLOAT, false, 0], [1, 4, gl.UNSIGNED_BYTE, true, 12], [2, 2, gl.FLOAT, false, 16]]), size: 0 };
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
  #array(buffer, stride, attributes) {
    const gl = this.#gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    for (const [at, size, type, normalized, offset] of attributes) {
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, size, type, normalized, stride, offset);
    }
    return array;
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
  /// Storage for so many indices, so that none need be made while they grow.
  reserve(length) {
    const gl = this.#gl;
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, 4 * length, gl.DYNAMIC_DRAW);
    this.#room = length;
  }
  /// Copies the ranges that changed; everything only where the buffer has outgrown its room.
  upload(indices, ranges) {
    const gl = this.#gl;
    if (indices.length > this.#room) {
      this.reserve(Math.ceil(indices.length * 1.3));
      ranges = [{ first: 0, count: indices.length }];
    }
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
    for (const { first, count } of ranges) {
      if (count === 0) continue;
      gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 4 * first, indices, first, count);
      this.bytesUploaded += 4 * count;
    }
  }

  /// Vertices of a Ribbon, for one draw call: vertices of the mesh are shared among strips, so that each triangle has three
  /// corners of its own here.
  paint(vertices) {
    const gl = this.#gl;
    this.ribbon.size = vertices.length / 6;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ribbon.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.DYNAMIC_DRAW);
  }
  /// The strips as lines: start with the strip as its fourth number, end with the mark of a strip's end.
  setLines(lines) {
    const gl = this.#gl;
    for (let i = 0; i < lines.length; i += 8) lines.set([lines[i + 6], lines[i + 3], lines[i + 4], lines[i + 5]], i + 3);
    this.drawnLines = lines.length / 8;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.segments);
    gl.bufferData(gl.ARRAY_BUFFER, lines, gl.DYNAMIC_DRAW);
  }

  /// `style`: shaded, list (the same from a buffer that is a triangle list), strips (the ribbon as it was painted), lines
  /// (over the surface). `patch`: triangles to be marked. `glow`: triangles that are lit, and how much, from 0 to 1. `list`: draws these triangles instead of the live buffer, to compare with it. `time`: of the light that runs
  /// along strips, in seconds; less than 0: none.
  draw(camera, { style, length, patch, glow, list, ink, paper, time = -1 }) {
    const gl = this.#gl;
    this.#clear(paper);
    const view = camera.view();
    const projection = camera.projection(this.canvas.width / this.canvas.height);
    if (style === 'strips' && !list) {
      this.#drawRibbon(view, projection, time);
    } else {
      const color = this.#surfaceProgram(view, projection, 0);
      gl.uniform4f(color, ...ink, 1);
      if (list) {
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STREAM_DRAW);
        gl.drawElements(gl.TRIANGLES, list.length, gl.UNSIGNED_INT, 0);
      } else {
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
        gl.drawElements(style === 'list' ? gl.TRIANGLES : gl.TRIANGLE_STRIP, length, gl.UNSIGNED_INT, 0);
      }
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (glow?.strength > 0) this.#drawOver(glow.triangles, this.#surfaceProgram(view, projection, 1), 0.4 * glow.strength);
    if (patch?.length > 0) this.#drawPatch(patch, this.#surfaceProgram(view, projection, 1));
    if (style === 'lines' && !list) this.#drawLines(multiply(projection, view), 1.5 * (window.devicePixelRatio || 1));
  }
  #clear(paper) {
    const gl = this.#gl;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(...paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
  }
  #drawRibbon(view, projection, time) {
    const gl = this.#gl;
    const { array, size } = this.ribbon;
    const { program, at } = this.#programs.ribbon;
    gl.useProgram(program);
    gl.bindVertexArray(array);
    gl.uniformMatrix4fv(at('view'), false, view);
    gl.uniformMatrix4fv(at('projection'), false, projection);
    gl.uniform1f(at('time'), time);
    gl.uniform1f(at('density'), Math.min(window.devicePixelRatio || 1, 2));
    gl.drawArrays(gl.TRIANGLES, 0, size);
  }
  /// Where its colour goes.
  #surfaceProgram(view, projection, flatness) {
    const gl = this.#gl;
    const { program, at } = this.#programs.surface;
    gl.useProgram(program);
    gl.bindVertexArray(this.surface);
    gl.uniformMatrix4fv(at('view'), false, view);
    gl.uniformMatrix4fv(at('projection'), false, projection);
    gl.uniform1f(at('flatness'), flatness);
    return at('paint');
  }
  #drawOver(triangles, color, opacity, edges = []) {
    const gl = this.#gl;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthFunc(gl.LEQUAL);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STREAM_DRAW);
    gl.uniform4f(color, 1, 0.72, 0.1, opacity);
    gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0);
    if (edges.length > 0) {
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(edges), gl.STREAM_DRAW);
      gl.uniform4f(color, 0.25, 0.1, 0, 1);
      gl.drawElements(gl.LINES, edges.length, gl.UNSIGNED_INT, 0);
    }
    gl.depthFunc(gl.LESS);
    gl.disable(gl.BLEND);
  }
  #drawPatch(patch, color) {
    const edges = [];
    for (let i = 0; i < patch.length; i += 3) edges.push(patch[i], patch[i + 1], patch[i + 1], patch[i + 2], patch[i + 2], patch[i]);
    this.#drawOver(patch, color, 0.55, edges);
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

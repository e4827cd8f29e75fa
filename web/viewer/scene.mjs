// What WebGL draws. The index buffer on the card is a copy of the live one, kept in step by its changed ranges alone,
// and is drawn as one triangle strip with primitive restart.

const surfaceVertex = `#version 300 es
uniform mat4 view, projection;
uniform float size;
layout(location = 0) in vec3 place;
out vec3 seen;
void main() { vec4 at = view * vec4(place, 1.0); seen = at.xyz; gl_Position = projection * at; gl_PointSize = size; }`;
const shade = `
float shade(vec3 seen) {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  return 0.46 + 0.5 * max(dot(normal, normalize(vec3(0.3, 0.5, 0.8))), 0.0) + 0.16 * max(dot(normal, vec3(-0.7, 0.2, 0.3)), 0.0);
}`;
const surfaceFragment = `#version 300 es
precision highp float;
uniform vec4 paint;
uniform float flatness, size;
in vec3 seen;
out vec4 pixel;
${shade}
void main() {
  float apart = size > 0.0 ? distance(gl_PointCoord, vec2(0.5)) : 0.0;
  if (apart > 0.5) discard;
  pixel = vec4(mix(paint.rgb * shade(seen), paint.rgb, flatness) * paint.a, paint.a);
  if (apart > 0.3) pixel.rgb = vec3(0.05, 0.06, 0.09);
}`;
// Ribbons: dark walls at the sides where a strip does not continue, thin edges within it, bright ones around a patch, and a light that
// runs along it. Peeled, they leave the mesh one after the other and lie flat in the window.
const ribbonVertex = `#version 300 es
uniform mat4 view, projection;
uniform float peel, away;
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 tint;
layout(location = 2) in vec2 way;
layout(location = 3) in vec3 band;
out vec3 seen, inside;
out vec2 along;
out vec3 own;
flat out vec3 wall, rim;
void main() {
  vec4 at = view * vec4(place, 1.0);
  float share = smoothstep(0.0, 1.0, clamp((1.12 * peel - band.z) / 0.12, 0.0, 1.0));
  vec3 flatly = vec3(band.xy * away / vec2(projection[0][0], projection[1][1]), -away);
  at.xyz = mix(at.xyz, flatly, share) + vec3(0.0, 0.0, 0.2 * away * share * (1.0 - share));
  seen = at.xyz;
  own = tint.rgb;
  along = way;
  int corner = gl_VertexID % 3, walls = int(tint.a * 255.0 + 0.5);
  inside = vec3(corner == 0, corner == 1, corner == 2);
  wall = vec3(walls >> 1 & 1, walls >> 2 & 1, walls & 1);  // by the corner that lies opposite
  rim = vec3(walls >> 4 & 1, walls >> 5 & 1, walls >> 3 & 1);
  gl_Position = projection * at;
}`;
const ribbonFragment = `#version 300 es
precision highp float;
uniform float time, density;
in vec3 seen, inside, own;
in vec2 along;
flat in vec3 wall, rim;
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
  color = mix(color, vec3(0.05, 0.06, 0.09), max(max(thick.x, thick.y), thick.z));
  vec3 bright = (1.0 - smoothstep(vec3(2.4), vec3(3.4), inside / step)) * rim;
  pixel = vec4(mix(color, vec3(1.0), max(max(bright.x, bright.y), bright.z)), 1.0);
}`;
export class Scene {
  bytesUploaded = 0;  // of the index buffer, since the last query
  #gl;
  #programs = {};
  #room = 0;

  constructor(canvas) {
    const gl = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('This browser does not offer WebGL 2, so the mesh cannot be shown. The picture is a still image.');
    this.#gl = gl;
    this.canvas = canvas;
    for (const [name, vertex, fragment] of [['surface', surfaceVertex, surfaceFragment], ['ribbon', ribbonVertex, ribbonFragment]])
      this.#programs[name] = this.#program(vertex, fragment);
    this.points = gl.createBuffer();
    this.live = gl.createBuffer();
    this.other = gl.createBuffer();
    this.surface = this.#array(this.points, 0, [[0, 3, gl.FLOAT, false, 0]]);
    const corners = gl.createBuffer();
    this.ribbon = { buffer: corners, array: this.#array(corners, 24, [[0, 3, gl.FLOAT, false, 0], [1, 4, gl.UNSIGNED_BYTE, true, 12], [2, 2, gl.FLOAT, false, 16]]), size: 0 };
    this.bands = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.bands);
    gl.vertexAttribPointer(3, 3, gl.FLOAT, false, 0, 0);
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
  /// `width`: bytes of an index on the card.
  setPoints(points, width) {
    const gl = this.#gl;
    this.indices = width === 2 ? { width, type: gl.UNSIGNED_SHORT, List: Uint16Array } : { width, type: gl.UNSIGNED_INT, List: Uint32Array };
    gl.bindBuffer(gl.ARRAY_BUFFER, this.points);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.STATIC_DRAW);
    this.#room = 0;
  }
  /// Makes storage for `count` indices, so that growth does not need new storage.
  reserve(length) {
    const gl = this.#gl;
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, this.indices.width * length, gl.DYNAMIC_DRAW);
    this.#room = length;
  }
  /// Copies the ranges that changed; everything only if the buffer has outgrown its room.
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
      const { width, List } = this.indices;
      gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, width * first, new List(indices.subarray(first, first + count)));  // restarts are all ones
      this.bytesUploaded += width * count;
    }
  }

  /// Vertices of a Ribbon, for one draw call: vertices of the mesh are shared among strips, so each triangle has three
  /// separate corners here.
  paint(vertices) {
    const gl = this.#gl;
    this.ribbon.size = vertices.length / 6;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ribbon.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.DYNAMIC_DRAW);
  }
  /// Where they lie flat, from Ribbon.flat.
  flatten(bands) {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.bands);
    gl.bufferData(gl.ARRAY_BUFFER, bands, gl.DYNAMIC_DRAW);
  }

  /// `style`: shaded, list (the same from a buffer that is a triangle list), strips (the ribbon as it was painted). `patch`: triangles
  /// to be marked; `dots`: vertices. `glow`: highlighted triangles, and the strength, from 0 to 1. `list`: draws these
  /// triangles instead of the live buffer, to compare with it. `time`: of the light that runs along strips, in seconds;
  /// less than 0: none. `peel`: how much of the ribbon lies flat, from 0 to 1.
  draw(camera, { style, length, patch, dots, glow, list, ink, paper, time = -1, peel = 0 }) {
    const gl = this.#gl;
    this.#clear(paper);
    const view = camera.view();
    const projection = camera.projection(this.canvas.width / this.canvas.height);
    if (style === 'strips' && !list) {
      this.#drawRibbon(view, projection, time, peel, 0.6 * camera.distance);
    } else {
      const color = this.#surfaceProgram(view, projection, 0);
      gl.uniform4f(color, ...ink, 1);
      if (list) {
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list, gl.STREAM_DRAW);
        gl.drawElements(gl.TRIANGLES, list.length, gl.UNSIGNED_INT, 0);
      } else {
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
        gl.drawElements(style === 'list' ? gl.TRIANGLES : gl.TRIANGLE_STRIP, length, this.indices.type, 0);
      }
    }
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (glow?.strength > 0) this.#drawOver(glow.triangles, this.#surfaceProgram(view, projection, 1), 0.4 * glow.strength);
    if (patch?.length > 0) this.#drawPatch(patch, this.#surfaceProgram(view, projection, 1));
    if (dots?.length > 0) this.#drawDots(dots, this.#surfaceProgram(view, projection, 1, 9 * Math.min(window.devicePixelRatio || 1, 2)));
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
  #drawRibbon(view, projection, time, peel, away) {
    const gl = this.#gl;
    const { array, size } = this.ribbon;
    const { program, at } = this.#programs.ribbon;
    gl.useProgram(program);
    gl.bindVertexArray(array);
    gl.uniformMatrix4fv(at('view'), false, view);
    gl.uniformMatrix4fv(at('projection'), false, projection);
    gl[peel > 0 ? 'enableVertexAttribArray' : 'disableVertexAttribArray'](3);
    gl.uniform1f(at('peel'), peel);
    gl.uniform1f(at('away'), away);
    gl.uniform1f(at('time'), time);
    gl.uniform1f(at('density'), Math.min(window.devicePixelRatio || 1, 2));
    gl.drawArrays(gl.TRIANGLES, 0, size);
  }
  /// Where its colour goes. `size`: of dots.
  #surfaceProgram(view, projection, flatness, size = 0) {
    const gl = this.#gl;
    const { program, at } = this.#programs.surface;
    gl.useProgram(program);
    gl.bindVertexArray(this.surface);
    gl.uniformMatrix4fv(at('view'), false, view);
    gl.uniformMatrix4fv(at('projection'), false, projection);
    gl.uniform1f(at('flatness'), flatness);
    gl.uniform1f(at('size'), size);
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
  #drawDots(dots, color) {
    const gl = this.#gl;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.other);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, dots, gl.STREAM_DRAW);
    gl.depthFunc(gl.LEQUAL);
    gl.uniform4f(color, 1, 1, 1, 1);
    gl.drawElements(gl.POINTS, dots.length, gl.UNSIGNED_INT, 0);
    gl.depthFunc(gl.LESS);
  }
  /// What the card has of the live buffer.
  copyOnCard(length) {
    const gl = this.#gl;
    gl.bindVertexArray(this.surface);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.live);
    const out = new this.indices.List(length);
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

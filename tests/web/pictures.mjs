// In a page: pictures of a mesh drawn by WebGL, each triangle in the colour of its normal, and how they differ.

/// A program in use whose attribute 0 is the position.
export function useFlatProgram(gl) {
  const program = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, `in vec3 place; out vec3 seen;
    void main() { seen = place; gl_Position = vec4(0.5 * place.xy, 0.3 * place.z, 1.0); }`],
  [gl.FRAGMENT_SHADER, `precision highp float; in vec3 seen; out vec4 pixel;
    void main() { pixel = vec4(0.5 + 0.5 * normalize(cross(dFdx(seen), dFdy(seen))), 1.0); }`]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, `#version 300 es\n${source}`);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, 0, 'place');
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
}

/// The pixels of the whole canvas after `draw`.
export function picture(gl, draw) {
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  draw();
  const { width, height } = gl.canvas;
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

/// How many pixels differ.
export function differ(one, other) {
  let count = 0;
  for (let i = 0; i < one.length; i += 4) count += one[i] !== other[i] || one[i + 1] !== other[i + 1] || one[i + 2] !== other[i + 2];
  return count;
}

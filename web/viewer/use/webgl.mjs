// After mesh.moveTo(level), with a buffer of indices bound. WebGL 2 restarts at 0xffffffff.
let room = 0;
export function draw(gl, mesh) {
  let ranges = mesh.update();
  const { indices } = mesh;
  if (indices.length > room) {  // the buffer has outgrown its storage
    room = 2 * indices.length;
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, 4 * room, gl.DYNAMIC_DRAW);
    ranges = [{ first: 0, count: indices.length }];
  }
  for (const { first, count } of ranges)
    gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 4 * first, indices, first, count);
  gl.drawElements(gl.TRIANGLE_STRIP, indices.length, gl.UNSIGNED_INT, 0);
}

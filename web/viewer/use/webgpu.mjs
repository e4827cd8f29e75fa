// For the pipeline. With an index format, strips restart at 0xffffffff.
export const primitive = { topology: 'triangle-strip', stripIndexFormat: 'uint32' };

// After mesh.moveTo(level).
let buffer = null;
export function draw(device, pass, mesh) {
  let ranges = mesh.update();
  const { indices } = mesh;
  if (!buffer || indices.byteLength > buffer.size) {  // the buffer has outgrown its storage
    const usage = GPUBufferUsage.INDEX | GPUBufferUsage.COPY_DST;
    buffer = device.createBuffer({ size: 2 * indices.byteLength, usage });
    ranges = [{ first: 0, count: indices.length }];
  }
  for (const { first, count } of ranges)
    device.queue.writeBuffer(buffer, 4 * first, indices, first, count);
  pass.setIndexBuffer(buffer, 'uint32');
  pass.drawIndexed(indices.length);
}

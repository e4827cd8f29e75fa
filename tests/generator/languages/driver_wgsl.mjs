// Runs a compute shader on the software device of headless Chromium, with tables in binding 0, an output in binding 1 and
// positions in binding 2, and prints its output. Arguments and output are as for driver_vulkan.cpp:
//   driver_wgsl.mjs CHROMIUM SCRATCH SHADER.wgsl LINES TABLES.bin…
//   driver_wgsl.mjs CHROMIUM SCRATCH SHADER.wgsl words N TABLES.bin
// but further shaders, each with a number and a file, may follow `words N TABLES.bin`.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from '../../web/browser.mjs';

const [chromium, scratch, shader, ...rest] = process.argv.slice(2);

/// For the lines of digests, plus one for the count of rules outside the tables in the last line.
const positionsOf = (file) => [...readFileSync(file, 'utf8').matchAll(/^(\d+) (\d+) (\d+) (\d+) /gm)].map((line) => line.slice(1).map(Number))
  .concat([[7, 0, 0, 0]]);

/// In the page: the output of each job, { data, positions, results, groups }.
async function compute(code, jobs) {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) throw new Error('this Chromium has no WebGPU adapter');
  const device = await adapter.requestDevice();
  const errors = [];
  device.onuncapturederror = ({ error }) => errors.push(error.message);
  const module = device.createShaderModule({ code });
  const { messages } = await module.getCompilationInfo();
  if (messages.length > 0) throw new Error(messages.map((m) => `${m.lineNum}: ${m.message}`).join('\n'));
  const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module, entryPoint: 'main' } });
  const buffer = (bytes, usage = 0) => {
    const made = device.createBuffer({ size: bytes.byteLength, usage: usage | GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST });
    device.queue.writeBuffer(made, 0, bytes);
    return made;
  };
  const outputs = [];
  for (const { data, positions, results, groups } of jobs) {
    const output = buffer(new Uint32Array(results), GPUBufferUsage.COPY_SRC);
    const buffers = [buffer(Uint8Array.from(atob(data), (c) => c.charCodeAt(0))), output];
    if (positions) buffers.push(buffer(new Uint32Array(positions.flat())));
    const read = device.createBuffer({ size: 4 * results, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0),
      entries: buffers.map((made, binding) => ({ binding, resource: { buffer: made } })) }));
    pass.dispatchWorkgroups(...groups);
    pass.end();
    encoder.copyBufferToBuffer(output, 0, read, 0, 4 * results);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    outputs.push([...new Uint32Array(read.getMappedRange())]);
  }
  if (errors.length > 0) throw new Error(errors.join('\n'));
  return outputs;
}

const data = (file) => readFileSync(file).toString('base64');
/// Shaders, each with its input and the form of its output.
const runs = [];
if (rest[0] === 'words') {
  for (let i = -1; i + 1 < rest.length; i += 3) {
    const [code, results, file] = i < 0 ? [shader, ...rest.slice(1)] : rest.slice(i + 1);
    runs.push({ code, jobs: [{ data: data(file), results: Number(results), groups: [1] }], print: (words) => words.join('\n') });
  }
} else {
  const jobs = [];
  for (let i = 0; i + 1 < rest.length; i += 2) {
    const positions = positionsOf(rest[i]);
    jobs.push({ file: rest[i + 1], data: data(rest[i + 1]), positions, results: positions.length, groups: [16, positions.length] });
  }
  const print = (output, i) => [...(i > 0 ? [`== ${jobs[i].file}`] : []), ...jobs[i].positions.map((position, at) =>
    position[0] === 7 ? `rules outside the tables: ${output[at]}` : `${position.join(' ')} ${output[at].toString(16).padStart(8, '0')}`)].join('\n');
  runs.push({ code: shader, jobs, print });
}
const page = join(scratch, 'page.html');
writeFileSync(page, '<!doctype html><title>restrip</title>');
const browser = await Browser.start(chromium, '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', '--enable-features=Vulkan');
try {
  const tab = await browser.page(100, 100);
  await tab.open(`file://${page}`);
  for (const { code, jobs, print } of runs) {
    const outputs = await tab.run(compute, readFileSync(code, 'utf8'), jobs);
    if (tab.faults.length > 0) throw new Error(tab.faults.join('\n'));
    outputs.forEach((output, i) => console.log(print(output, i)));
  }
} finally {
  await browser.stop();
}

// Runs a compute shader on the software device of headless Chromium, with tables in binding 0, an output in binding 1 and
// positions in binding 2, and prints what it puts out. Arguments and output are those of driver_vulkan.cpp:
//   driver_wgsl.mjs CHROMIUM SCRATCH SHADER.wgsl K|automaton K|words N TABLES.bin…
// but that more shaders, each with a number and a file, may follow behind `words N TABLES.bin`.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Browser } from '../../web/browser.mjs';

const [chromium, scratch, shader, upTo, ...rest] = process.argv.slice(2);

/// All that digests are printed of, and one that counts rules outside the tables. Of collapses beyond k = 6 only the first, unless
/// RESTRIP_EVERY_POSITION is set.
function positionsUpTo(maxK) {
  const every = 'RESTRIP_EVERY_POSITION' in process.env;
  const all = [];
  for (let operation = 0; operation < 6; ++operation)
    for (let k = operation < 2 ? 3 : 1; k <= maxK; ++k) {
      const ofK = [];
      for (let p = operation < 2 ? 1 : 0; p <= (operation < 2 ? k - 1 : k); ++p)
        if (operation === 2 || operation === 3) for (let q = p + 1; q <= k; ++q) ofK.push([operation, k, p, q]);
        else ofK.push([operation, k, p, 0]);
      all.push(...(operation % 2 === 1 && k > 6 && !every ? ofK.slice(0, 1) : ofK));
    }
  return [...all, [6, 0, 0, 0], [7, 0, 0, 0]];
}

/// The same for automata, whose answers after a collapse depend on k alone.
function positionsOfAutomaton(maxK) {
  const all = [];
  for (let operation = 0; operation < 5; ++operation)
    for (let k = operation < 2 ? 3 : 1; k <= maxK; ++k)
      for (let p = operation === 0 ? 1 : 0; p <= [k - 1, 0, k - 1, 0, k][operation]; ++p)
        if (operation === 2) for (let q = p + 1; q <= k; ++q) all.push([operation, k, p, q]);
        else all.push([operation, k, p, 0]);
  return [...all, [7, 0, 0, 0]];
}

/// In the page: what each job, { data, positions, results, groups }, puts out.
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
/// Shaders, each with what it is run on and how its output is printed.
const runs = [];
if (upTo === 'words') {
  for (let i = -1; i + 1 < rest.length; i += 3) {
    const [code, results, file] = i < 0 ? [shader, ...rest] : rest.slice(i);
    runs.push({ code, jobs: [{ data: data(file), results: Number(results), groups: [1] }], print: (words) => words.join('\n') });
  }
} else {
  const automaton = upTo === 'automaton';
  const maxK = Number(automaton ? rest.shift() : upTo);
  const jobs = rest.map((file, i) => {
    const positions = (automaton ? positionsOfAutomaton : positionsUpTo)(i === 0 ? maxK : Math.min(maxK, 4));
    return { data: data(file), positions, results: positions.length, groups: [16, positions.length] };
  });
  const print = (output, i) => [...(i > 0 ? [`== ${rest[i]}`] : []), ...jobs[i].positions.map((position, at) =>
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

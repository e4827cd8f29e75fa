// The worker of the page: the two programs, asked by messages { id, what, … } and answering with { id, answer }.
import { made, program } from './programs.mjs';

let programs = null;
let asking = 0;
onmessage = async ({ data }) => {
  if (data.compiled) {
    const heard = (one) => postMessage({ id: asking, heard: one });
    programs = Promise.all(['generate', 'judge'].map((command) => program(data.compiled, command, heard))).then(([generate, judge]) => ({ generate, judge }));
    return;
  }
  const { id, what, name, text, options, request } = data;
  const { generate, judge } = await programs;
  asking = id;
  const answers = {
    make: () => made({ generate, judge }, name, text, options),
    explain: () => judge({ files: { [name]: text }, operation: name, ...request }),
  };
  postMessage({ id, answer: await answers[what]() });
};

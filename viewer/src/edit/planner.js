// The planner of the page: three workers that run the same module. One plans, one checks positions, one divides the workspace.

import { decode } from '../base85.js';

const NEEDED = [
  ['WebAssembly', 'WebAssembly'],
  ['Worker', 'web workers'],
  ['DecompressionStream', 'decompression of streams'],
];

/** What this browser lacks to plan, in one sentence; null if it has everything. */
export function missing(scope = window) {
  const lacking = NEEDED.filter(([key]) => typeof scope[key] === 'undefined').map(([, name]) => name);
  if (lacking.length === 0) return null;
  return `Editing is not available: this browser, or this private window, lacks ${lacking.join(' and ')}.`;
}

const textOf = (id) => document.getElementById(id)?.textContent ?? '';

async function bytesOf(text) {
  const stream = new Blob([decode(text.trim())]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Response(stream).arrayBuffer();
}

const compile = async () => WebAssembly.compile(await bytesOf(textOf('cdpr-module')));

const workerUrl = () => URL.createObjectURL(new Blob([textOf('cdpr-worker')], { type: 'text/javascript' }));

/**
 * A worker with at most one request on its way and one waiting. A newer request takes the place of the one that waits,
 * which is answered with null.
 */
export function createLane(start) {
  let worker = null;
  let running = null;
  let waiting = null;
  let count = 0;

  function settle(job, answer) {
    if (answer?.error) job.reject(Object.assign(new Error(answer.error.message), { key: answer.error.key }));
    else job.resolve(answer);
  }

  function next() {
    running = waiting;
    waiting = null;
    if (running) worker.postMessage({ id: running.id, request: running.request });
  }

  function hear({ data }) {
    if (!running || data.id !== running.id) return;
    if (data.improved) {
      running.onImproved?.(data.improved);
      return;
    }
    const job = running;
    // A planner that has failed cannot go on; the next request starts another one.
    if (data.answer?.error?.fatal) restart();
    else next();
    settle(job, data.answer);
  }

  function fail(message) {
    const job = running;
    stop();
    job?.reject(new Error(message || 'the planner has stopped'));
  }

  function restart() {
    worker.terminate();
    worker = null;
    if (!waiting) running = null;
    else {
      begin();
      next();
    }
  }

  function begin() {
    worker = start();
    worker.addEventListener('message', hear);
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      fail(event.message);
    });
  }

  function stop() {
    worker?.terminate();
    worker = null;
    waiting?.resolve(null);
    running = null;
    waiting = null;
  }

  /** Ends what runs and what waits; both are answered with null. */
  function cancel() {
    if (!running) return;
    const job = running;
    stop();
    job.resolve(null);
  }

  /** Asks when what runs is done, in place of what waits; `onImproved` hears of better paths meanwhile. */
  function ask(request, onImproved) {
    return new Promise((resolve, reject) => {
      count += 1;
      waiting?.resolve(null);
      waiting = { id: count, request, onImproved, resolve, reject };
      if (!worker) begin();
      if (!running) next();
    });
  }

  return { ask, cancel, busy: () => running !== null };
}

/** The workers; `plan`, `place` and `divide` are lanes once `ready` is fulfilled. */
export function createPlanner() {
  let url = null;
  let lanes = null;

  async function begin() {
    const lack = missing();
    if (lack) throw new Error(lack);
    const module = await compile();
    url = workerUrl();
    const start = () => {
      const worker = new Worker(url);
      worker.postMessage({ module });
      return worker;
    };
    return { plan: createLane(start), place: createLane(start), divide: createLane(start) };
  }

  return {
    /** The lanes; the module is compiled when they are asked for first. */
    ready: () => {
      lanes ??= begin();
      return lanes;
    },
  };
}

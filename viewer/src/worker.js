// The worker of a live page: answers its requests with the planner, one at a time and in order.

import { initSync, Planner } from '../planner/planner.js';

let planner = null;
let current = null;

// Called by the planner for each better path.
globalThis.improved = (text) => postMessage({ id: current, improved: JSON.parse(text) });

// A planner that has failed once cannot be used again; the page starts another worker.
function answered(request) {
  try {
    return JSON.parse(planner.answer(JSON.stringify(request)));
  } catch (error) {
    return { error: { message: `The planner has failed: ${error.message}`, key: null, fatal: true } };
  }
}

globalThis.onmessage = ({ data: { module, id, request } }) => {
  if (module) {
    initSync({ module });
    planner = new Planner();
  } else {
    current = id;
    postMessage({ id, answer: answered(request) });
  }
};

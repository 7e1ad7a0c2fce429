// Undo and redo.

const MOST_STEPS = 200;

/** The states of something; `present` is the one that holds. */
export function createHistory(first) {
  let past = [];
  let present = first;
  let future = [];

  function move(from, to) {
    if (from.length === 0) return false;
    to.push(present);
    present = from.pop();
    return true;
  }

  return {
    get present() { return present; },
    get canUndo() { return past.length > 0; },
    get canRedo() { return future.length > 0; },
    /** Adds a step. */
    push: (state) => {
      past = [...past, present].slice(-MOST_STEPS);
      present = state;
      future = [];
    },
    /** Changes the present one within its step. */
    replace: (state) => {
      present = state;
    },
    /** One step back; false if there is none. */
    undo: () => move(past, future),
    /** One step forward; false if there is none. */
    redo: () => move(future, past),
  };
}

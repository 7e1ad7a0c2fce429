// Where the platform can be, proved while the scene changes: quickly while something is dragged, more closely afterwards.

import { readProved } from '../data.js';

// How long a proof may take, ms: during a drag, longer where too little is decided in that time; and afterwards, one after the other
// until nearly everything is decided.
const QUICK = [120, 960];
const TOO_LITTLE = 0.85;
const CLOSER = [1000, 4000, 10000];
const ENOUGH = 0.999;
const UNKNOWN = { revision: -1, proved: null, rough: true, error: null };

const withoutEnds = ({ query: { start, goal, ...query } = {}, ...scene }) => ({ ...scene, orientation: query.orientation });

// Start and goal do not change where the platform can be.
function isSameHall(a, b) {
  const [one, other] = [withoutEnds(a), withoutEnds(b)];
  return [...new Set([...Object.keys(one), ...Object.keys(other)])].every((key) => one[key] === other[key]);
}

/**
 * Proofs for a scene and its changes. `draw(proved)` shows what is proved, or for null nothing; `tell(state)` hears
 * `{ proved, before, busy, error }`, of which `before` is the volume before the last change.
 */
export function createProving({ planner, scene: first, draw, tell }) {
  let scene = first;
  let active = false;
  let revision = 0;
  // How long a proof may take during a drag, ms.
  let [quick, longest] = QUICK;
  // Whether the proof on its way belongs to a drag.
  let isQuick = false;
  // What is known, of which revision that is, whether it was proved during a drag, and why nothing can be proved.
  let known = UNKNOWN;
  let before = null;

  // How many proofs are on their way or due.
  let pending = 0;

  const isCurrent = () => known.revision === revision;

  const say = () => tell({ proved: known.proved, before, busy: pending > 0, error: known.error });

  // One proof, in a drag if no time limit is given; null if another one has overtaken it.
  async function prove(budget) {
    const [asked, of] = [revision, scene];
    const { divide } = await planner.ready();
    const rough = budget === undefined;
    isQuick = rough;
    const answer = await divide.ask({ ask: 'workspace', scene: of, budget_ms: budget ?? quick });
    if (!answer || !active || asked < known.revision) return null;
    if (rough && answer.decided < TOO_LITTLE) quick = Math.min(2 * quick, longest);
    known = { revision: asked, proved: readProved(answer.proved), rough, error: null };
    draw(known.proved);
    say();
    return asked === revision ? answer : null;
  }

  async function update(budgets) {
    pending += 1;
    say();
    const asked = revision;
    try {
      for (const budget of budgets) {
        const answer = await prove(budget);
        if (!answer || answer.decided >= ENOUGH) break;
      }
    } catch (error) {
      if (asked === revision && active) {
        draw(null);
        known = { ...UNKNOWN, revision, error: error.message };
      }
    }
    pending -= 1;
    say();
  }

  // A long proof of a scene that has changed is of no use.
  async function cancel() {
    const { divide } = await planner.ready();
    if (!isQuick && divide.busy()) divide.cancel();
  }

  /** Goes on with a changed scene. */
  function change(next, { dragging = false } = {}) {
    const isSame = isSameHall(scene, next);
    scene = next;
    if (!active || (isSame && (dragging || (isCurrent() && !known.rough)))) return;
    if (!isSame) {
      // A drag is one change.
      if (isCurrent() && !known.rough) before = known.proved.volume;
      revision += 1;
      cancel();
    }
    update(dragging ? [undefined] : CLOSER);
  }

  function setActive(value) {
    if (active === value) return;
    active = value;
    if (active) {
      [known, before] = [UNKNOWN, null];
      update(CLOSER);
      return;
    }
    draw(null);
    cancel();
  }

  /** One proof of the scene as it is within a time, ms, for scripts; null if another one has overtaken it. */
  async function once(budget) {
    const { divide } = await planner.ready();
    const answer = await divide.ask({ ask: 'workspace', scene, budget_ms: budget });
    // It may have taken the place of a proof that the reader waits for.
    if (active && pending === 0 && (!isCurrent() || known.rough)) update(CLOSER);
    return answer;
  }

  return { change, setActive, once, get isActive() { return active; } };
}

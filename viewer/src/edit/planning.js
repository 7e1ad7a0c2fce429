// Plans while the scene changes: quickly while something is dragged, fully afterwards. Only the newest scene counts.

import { ENDS, missingEnds, orientationNames, pageOf, placeOf, thingsOf } from './document.js';

const NOTHING = { cost: null, waypoints: [], milliseconds: 0 };
/** The result of a request that a later change has overtaken. */
export const SUPERSEDED = { status: 'superseded', ...NOTHING };
// The result for a scene without a start or a goal.
const UNASKED = { status: 'unasked', ...NOTHING };

const SKETCH = { planner: 'rrt-connect', budget_ms: 40, proof: false };

// A picture that takes longer to build than this, ms, waits until the thing is let go; so do those of so many obstacles.
const LONGEST = 60;
const MANY = 200;
// So many answers are kept; each may hold a search tree of a megabyte.
const MOST_ANSWERS = 24;

const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

/** What of a page's path is a path file. */
function pathFile(path) {
  if (!path) return null;
  const { tree, turn_weight: weight, ...file } = path;
  return file;
}

// What is known about a path at first.
function firstAnswer({ path, ...rest }) {
  if (!path) return null;
  const { cost = null, waypoints = [] } = path;
  const violations = (rest.violations ?? []).length;
  // A file may call a path solved that is not valid in this scene.
  const isGiven = path.status === undefined || path.status === null || (waypoints.length > 0 && violations > 0);
  const status = isGiven ? 'given' : path.status;
  const bound = rest.result?.lower_bound ?? null;
  return { status, cost, waypoints, bound, violations, milliseconds: 0, path: pathFile(path), page: { ...rest, path } };
}

/**
 * Plans for a scene and its changes. `draw(page, scene, fresh)` shows a page that belongs to a scene, `tell(state)`
 * hears how it stands.
 */
export function createPlanning({ planner, scene: first, page, options, draw, tell }) {
  let scene = first;
  let revision = 0;
  let shownRevision = 0;
  // What is drawn: a page and the scene that it belongs to.
  let shown = { scene: first, page };
  let answers = new Map();
  let checked = -1;
  let checking = false;
  let refining = null;
  let own = { ...options };
  // How long the last picture took to build, ms.
  let building = (page.obstacles ?? []).length > MANY ? Infinity : 0;
  const initial = firstAnswer(page);
  const state = { invalid: [], busy: false, dragging: false, answer: initial, best: null, error: null, stopped: false };
  if (initial) answers.set(first, initial);

  function say(news) {
    Object.assign(state, news, { missing: missingEnds(scene) });
    // A path is the better witness.
    tell(['solved', 'given'].includes(state.answer?.status) ? { ...state, invalid: [] } : state);
  }

  // The oldest are forgotten, except the page's own.
  function remember(of, answer) {
    answers.delete(of);
    answers.set(of, answer);
    const oldest = [...answers.keys()].find((one) => one !== first);
    if (answers.size > MOST_ANSWERS) answers.delete(oldest);
  }

  function put(newPage, of, fresh) {
    shown = { scene: of, page: newPage };
    const begin = performance.now();
    draw(newPage, of, fresh);
    building = performance.now() - begin;
  }

  // The straight line, which says nothing about lengths that count turns.
  const straight = () => !scene.turning && ENDS.every((end) => scene.query?.[end]) ? distance(scene.query.start, scene.query.goal) : 0;

  async function check() {
    if (checking) return;
    checking = true;
    try {
      while (checked !== revision) await checkOnce();
    } catch {
      // A scene that cannot be read: the plan's answer says why.
      checked = revision;
      say({ invalid: [] });
    } finally {
      checking = false;
    }
  }

  async function checkOnce() {
    const [asked, of] = [revision, scene];
    const { place } = await planner.ready();
    const found = [];
    // Where the planner chooses among orientations, only it knows.
    const open = orientationNames(of).length > 1 && !of.query?.orientation;
    for (const end of open ? [] : ENDS) {
      const at = of.query?.[end];
      const orientation = page[`${end}_orientation`];
      const answer = at && (await place.ask({ ask: 'place', scene: of, at, orientation }));
      if (answer === null) return;
      if (answer?.violation) found.push({ end, ...answer });
    }
    checked = asked;
    if (!state.answer || asked === revision) say({ invalid: found });
  }

  function present(answer) {
    shownRevision = revision;
    put(answer.page, scene, true);
    say({ answer, busy: false, best: null, error: null, stopped: false });
  }

  async function sketch() {
    const [asked, of] = [revision, scene];
    const { plan } = await planner.ready();
    if (refining) return;
    // Between the same ends, what is still valid of the path on show is kept.
    const before = pathFile(shown.page.path);
    const path = before?.waypoints.length > 1 ? before : undefined;
    const quick = { ...own, gap: undefined, post: undefined, settings: undefined, ...SKETCH };
    const request = { ask: 'plan', scene: of, options: quick, path, page: true, extras: false };
    let answer = null;
    try {
      answer = await plan.ask(request);
    } catch (error) {
      if (asked === revision) say({ error: error.message });
    }
    if (!answer || asked <= shownRevision) return;
    if (answer.waypoints.length === 0) {
      // The length on show belongs to a place before this one.
      if (asked === revision) say({ best: null });
      return;
    }
    shownRevision = asked;
    if (building <= LONGEST) put(answer.page, of, asked === revision);
    const bound = answer.page.result?.lower_bound ?? null;
    say({ best: { cost: answer.cost, bound, straight: straight(), of }, error: null });
  }

  // A better path while it is refined, drawn without what takes longer.
  function improve({ cost, waypoints }) {
    const known = state.best?.cost ?? Infinity;
    if (!(cost < known)) return;
    say({ best: { cost, straight: straight(), waypoints, of: scene } });
    if (building > LONGEST) return;
    const { path: before, motion } = shown.page;
    const path = { ...before, status: 'solved', orientations: undefined, waypoints, raw_waypoints: [], cost, raw_cost: null, tree: null };
    put({ ...pageOf(scene, shown.page, shown.scene), path, motion }, scene, 'path');
  }

  async function cancel() {
    if (!refining) return;
    refining = null;
    (await planner.ready()).plan.cancel();
  }

  async function ask(asked, of, budget) {
    const { plan } = await planner.ready();
    if (asked !== revision) return null;
    const token = {};
    refining = token;
    const limits = budget === undefined ? {} : { budget_ms: budget };
    const request = { ask: 'plan', scene: of, options: { ...own, ...limits }, page: true, extras: true };
    try {
      return await plan.ask(request, (better) => asked === revision && improve(better));
    } finally {
      if (refining === token) refining = null;
    }
  }

  async function refine(budget) {
    const [asked, of] = [revision, scene];
    say({ busy: true, stopped: false });
    try {
      const answer = await ask(asked, of, budget);
      if (answer) remember(of, answer);
      if (!answer || asked !== revision) return SUPERSEDED;
      present(answer);
      return answer;
    } catch (error) {
      if (asked === revision) say({ busy: false, error: error.message });
      throw error;
    }
  }

  // Draws things that have come or gone, with the path before.
  function redraw() {
    const { path, motion } = shown.page;
    put({ ...pageOf(scene, shown.page, shown.scene), path, motion }, scene, false);
  }

  const count = (of) => thingsOf(of, []).length;

  /**
   * Goes on with a changed scene; while dragging it is planned quickly. Returns a promise of the answer. `again` plans
   * anew what is known.
   */
  async function change(next, { dragging = false, budget, again = false } = {}) {
    const resized = String(next.obstacles?.map(({ box }) => box)) !== String(shown.scene.obstacles?.map(({ box }) => box));
    // While dragging the last length stands until the next one is there.
    const best = dragging || state.best?.of === next ? state.best : null;
    revision += 1;
    scene = next;
    cancel();
    const known = again ? null : answers.get(scene);
    say({ dragging, answer: known ?? null, busy: false, stopped: false, error: null, best });
    if (known) {
      check();
      present(known);
      return known;
    }
    if (missingEnds(scene).length > 0) {
      // No path will follow the one before.
      if (!dragging || shown.page.path) put(pageOf(scene, shown.page, shown.scene), scene, true);
      check();
      return UNASKED;
    }
    if (resized || count(scene) !== count(shown.scene)) redraw();
    check();
    if (!dragging) return refine(budget);
    sketch();
    return SUPERSEDED;
  }

  /** Ends planning; the best path so far stays. */
  async function stop() {
    const { best } = state;
    revision += 1;
    checked = revision;
    await cancel();
    say({ busy: false, stopped: true });
    if (!best?.waypoints) return;
    const asked = revision;
    const path = { version: 1, status: 'solved', planner: own.planner, waypoints: best.waypoints, cost: best.cost };
    const { place } = await planner.ready();
    const answer = await place.ask({ ask: 'page', scene, path, extras: true });
    if (answer && asked === revision) {
      present({ status: 'solved', cost: best.cost, waypoints: best.waypoints, milliseconds: 0, path, page: answer.page });
      say({ stopped: true });
    }
  }

  async function toml() {
    const { place } = await planner.ready();
    try {
      const answer = await place.ask({ ask: 'toml', scene });
      return answer?.toml ?? toml();
    } catch (error) {
      say({ error: `not saved: ${error.message}` });
      return null;
    }
  }

  return {
    get scene() { return scene; },
    get shownScene() { return shown.scene; },
    get options() { return own; },
    /** Whether the scene has been planned only quickly. */
    get isSketched() { return !state.answer && !state.busy; },
    /** The answer for the scene as it is, or null while there is none. */
    get answer() { return state.answer; },
    change,
    stop,
    /** Plans with other options from now on. */
    setOptions: (news) => {
      own = { ...own, ...news };
      answers = new Map();
    },
    /** The scene as a TOML file; null if it is none that the program reads, which is then said. */
    toml,
    /** Reports the state, then checks start and goal once the planner is ready. */
    check: () => {
      checked = -1;
      say({});
      check();
    },
    /** Whether a thing has moved since the picture was made. */
    hasMoved: (thing) => {
      const [now, then] = [scene, shown.scene].map((one) => placeOf(one, thing));
      return now !== then && String(now) !== String(then);
    },
  };
}

// Editing: things are moved in the picture or by typing, and the path follows.

import { readModel } from '../data.js';
import * as edited from './document.js';
import { createHandles } from './handles.js';
import { createHistory } from './history.js';
import { foldCharts, hasCharts } from '../panel.js';
import { markOutdated, moveDrawn } from './picture.js';
import { createPlanner, missing } from './planner.js';
import { createPlanning, SUPERSEDED } from './planning.js';
import { createProving } from './proving.js';
import { saveFile } from './save.js';
import { createToolbar, MOST, showMissing } from './toolbar.js';
import { createChangingVolume } from '../volume.js';

const STEP = 0.01;
// How long a script waits for a proof of the workspace unless it says so, ms.
const SCRIPTED = 4000;
// A new box, as a share of the workspace.
const NEW_BOX = 0.12;

const isTyping = (target) => target instanceof Element && target.closest('input, select, textarea') !== null;

// The scene as the page shows it: a path may have other ends than the scene's own.
function shownScene({ scene, options }, page) {
  const ends = Object.fromEntries(edited.ENDS.filter((end) => page[end]).map((end) => [end, page[end]]));
  return { scene: { ...scene, query: { ...scene.query, ...ends } }, options };
}

const round = (x) => Math.round(x * 100) / 100;

// Steps of the keys that move a thing: axis and sign.
function stepOf({ key, shiftKey }) {
  if (shiftKey) return { ArrowUp: [2, 1], ArrowDown: [2, -1] }[key];
  const flat = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [1, 1], ArrowDown: [1, -1] };
  return { ...flat, PageUp: [2, 1], PageDown: [2, -1] }[key];
}

const briefly = ({ status, cost, waypoints, milliseconds }) => ({ status, cost, waypoints, milliseconds });

/** Makes the page editable; `app` has `show(model)` and `current()`, `page` is its data without `live`. */
export function createEdit(app, live, page, fill) {
  const lack = missing();
  if (lack) {
    showMissing(lack);
    publishLack(lack);
    return;
  }
  const { scene: first, options } = shownScene(live, page);
  const { setting } = app.current();
  const history = createHistory(first);
  let active = false;
  let drag = null;
  let frame = 0;
  // What a key that is held has moved, and the scene that came of it.
  let held = null;

  const planner = createPlanner();
  const planning = createPlanning({ planner, scene: first, page, options, draw, tell });
  const showVolume = setting.stage ? createChangingVolume(setting, app.current().view.frame) : () => {};
  const proving = createProving({ planner, scene: first, draw: showVolume, tell: (state) => toolbar.showVolume(state) });
  const cables = page.cables ?? [];
  const things = () => edited.thingsOf(planning.scene, cables);
  const size = () => page.workspace.max.map((high, i) => high - page.workspace.min[i]);

  const toolbar = createToolbar({
    toggle: () => setActive(!active),
    undo,
    redo,
    addEnd,
    addBox,
    remove: removeSelected,
    setPlanner: (planner) => {
      // Other settings belong to the planner before.
      planning.setOptions({ planner, gap: undefined, post: undefined, settings: undefined });
      quietly(apply(planning.scene, { again: true }));
    },
    setOrientation: (name) => commit(edited.setOrientation(planning.scene, name)),
    setClearance: (value) => commit(edited.setClearance(planning.scene, value)),
    toggleVolume: () => setProving(!proving.isActive),
    setCoordinate,
    setSide,
    moveToNearest,
    planAnew: () => quietly(apply(planning.scene, { again: true })),
    stop: planning.stop,
    save,
  }, { planner: options.planner ?? 'anytime', orientations: edited.orientationNames(first), isDrawn: Boolean(setting.stage) });

  const source = {
    things,
    placeOf: (thing) => edited.placeOf(planning.scene, thing) ?? edited.placeOf(planning.shownScene, thing) ?? [0, 0, 0],
    shownAt: (thing) => edited.placeOf(planning.shownScene, thing) ?? edited.placeOf(planning.scene, thing),
    model: () => app.current().model,
    frame: () => app.current().view.frame,
    limits,
    isVisible,
  };
  const handles = setting.stage ? createHandles(setting, source, { select: showAll, drag: onDrag }) : null;

  // Twice as far as the workspace reaches.
  function limits() {
    const { min, max } = page.workspace;
    return { min: min.map((low, i) => low - size()[i] / 2), max: max.map((high, i) => high + size()[i] / 2) };
  }

  function isVisible({ kind, id }) {
    const { layers } = app.current().view;
    if (kind === 'end') return layers.startGoal.visible;
    if (kind === 'outlet') return layers.outlets.visible;
    return layers.obstacles.visible && (layers.obstacles.parts?.[id]?.visible ?? true);
  }

  // Shows a page that belongs to a scene; `fresh` if that is the scene as it is, "path" if only its path is.
  function draw(newPage, scene, fresh) {
    const { path } = newPage;
    const hadCharts = hasCharts();
    app.show(readModel(newPage));
    if (hasCharts() !== hadCharts) {
      // A view that the reader has turned stays as it is, and nothing covers it.
      if (!hadCharts && setting.stage?.isTouched()) foldCharts();
      setting.stage?.resize();
    }
    mark({ outdated: fresh !== true, dimmed: !fresh && Boolean(path) });
    adjust();
    handles?.refresh();
  }

  const mark = (how) => {
    markOutdated(app.current().view.drawn, how);
    setting.stage?.invalidate();
  };

  // Moves what is drawn to where it is now.
  function adjust() {
    const { view, playback } = app.current();
    if (!view.drawn) return;
    for (const thing of things().filter(planning.hasMoved)) {
      const from = edited.placeOf(planning.shownScene, thing);
      const to = edited.placeOf(planning.scene, thing);
      if (from && to) moveDrawn({ ...view, model: app.current().model }, thing, from, to);
    }
    playback.setDistance(playback.distance());
  }

  // What is in the way at start and goal.
  function badThings({ invalid }) {
    const names = new Set(invalid.flatMap(({ end, violation }) => [end, ...violation.culprits]));
    return things().filter(({ kind, name }) => kind !== 'outlet' && names.has(name));
  }

  function tell(state) {
    toolbar.showState(state);
    if (active || state.invalid.length === 0) handles?.setBad(badThings(state));
    showAll();
  }

  function showAll() {
    const { scene } = planning ?? {};
    if (!scene) return;
    const thing = handles?.selected ?? null;
    const place = thing && edited.placeOf(scene, thing);
    const isObstacle = thing?.kind === 'obstacle' && place !== null;
    toolbar.showThing(active && place ? thing : null, place, isObstacle ? edited.boxSize(scene, thing.id) : null);
    const { clearance = 0, query } = scene;
    const canSave = Boolean(planning.answer?.path);
    const canSavePath = planning.answer?.path?.waypoints.length > 0;
    const tools = { canUndo: history.canUndo, canRedo: history.canRedo, canRemove: isObstacle, canSave, canSavePath };
    toolbar.showTools({ ...tools, clearance, orientation: query?.orientation, missing: edited.missingEnds(scene) });
  }

  // Goes on with a scene; a promise of the plan's answer.
  function apply(scene, how) {
    const answer = planning.change(scene, how);
    proving.change(scene, how);
    if (!planning.answer) mark({ outdated: true, dimmed: true });
    adjust();
    handles?.place();
    showAll();
    return answer;
  }

  const quietly = (promise) => promise.catch(() => {});

  // One step of the history.
  function commit(scene, how) {
    history.push(scene);
    return quietly(apply(scene, how));
  }

  function undo() {
    if (handles?.cancel() || !history.undo()) return;
    quietly(apply(history.present));
  }

  function redo() {
    if (drag || !history.redo()) return;
    quietly(apply(history.present));
  }

  // At most once for each picture.
  function onDrag(thing, to, phase) {
    if (phase === 'begin') {
      drag = { thing, to };
      setting.stage.setMoving(true);
    }
    if (phase === 'move') {
      drag.to = to;
      frame ||= requestAnimationFrame(() => {
        frame = 0;
        if (drag) quietly(apply(edited.moveThing(planning.scene, thing, drag.to), { dragging: true }));
      });
    }
    if (phase === 'end' || phase === 'cancel') endDrag(thing, phase === 'end');
  }

  function endDrag(thing, keep) {
    const { to } = drag;
    cancelAnimationFrame(frame);
    frame = 0;
    drag = null;
    setting.stage.setMoving(false);
    const isThere = String(edited.placeOf(planning.scene, thing)) === String(to);
    if (keep) commit(isThere ? planning.scene : edited.moveThing(planning.scene, thing, to));
    else quietly(apply(history.present));
  }

  function setCoordinate(axis, value) {
    const thing = handles?.selected;
    const to = thing && edited.placeOf(planning.scene, thing).map((x, i) => (i === axis ? value : x));
    if (to) commit(edited.moveThing(planning.scene, thing, to));
  }

  function setSide(side, value) {
    const { id } = handles?.selected ?? {};
    const sides = edited.boxSize(planning.scene, id).map((x, i) => (i === side ? value : x));
    commit(edited.resizeBox(planning.scene, id, sides));
  }

  function addBox() {
    const middle = page.workspace.min.map((low, i) => round(low + size()[i] / 2));
    const sides = size().map((x) => Math.max(0.001, round(NEW_BOX * x)));
    const { scene, name } = edited.addBox(planning.scene, sides, middle);
    commit(scene);
    handles?.select({ kind: 'obstacle', id: name, name });
  }

  // The first end goes to the middle of the workspace, the other one opposite to it, or beside it if that is the middle.
  function addEnd(end) {
    const other = planning.scene.query?.[end === 'start' ? 'goal' : 'start'];
    const middle = page.workspace.min.map((low, i) => round(low + size()[i] / 2));
    const at = other ? [...[0, 1].map((i) => round(2 * middle[i] - other[i])), other[2]] : middle;
    if (other && String(at) === String(other.map(round))) at[0] = round(at[0] + size()[0] / 10);
    commit(edited.moveEnd(planning.scene, end, at));
    handles?.select({ kind: 'end', id: end, name: end });
  }

  function removeSelected() {
    const thing = handles?.selected;
    if (thing?.kind !== 'obstacle') return;
    handles.cancel();
    handles.select(null);
    commit(edited.removeObstacle(planning.scene, thing.id));
  }

  // Ends go where they are valid.
  function moveToNearest(invalid) {
    const ends = invalid.filter(({ nearest }) => nearest);
    commit(ends.reduce((scene, { end, nearest }) => edited.moveEnd(scene, end, nearest), planning.scene));
  }

  async function save(what) {
    const { title = 'scene' } = page;
    if (what === 'scene') {
      const text = await planning.toml();
      if (text !== null) saveFile(text, title, '.toml', 'application/toml');
    }
    const { answer } = planning;
    if (what === 'path') saveFile(`${JSON.stringify(answer.path, null, 2)}\n`, title, '.path.json', 'application/json');
    if (what === 'page') {
      const data = { ...answer.page, live: { ...live, scene: planning.scene, options: planning.options } };
      saveFile(fill(data), title, '.html', 'text/html');
    }
  }

  function setProving(value) {
    toolbar.setProving(value);
    proving.setActive(value);
  }

  function setActive(value) {
    active = value;
    toolbar.setActive(active);
    handles?.setActive(active);
    if (!active) setProving(false);
    // Makes room for the bar, if the reader has not turned the view.
    setting.stage?.resize();
    showAll();
    if (!active) {
      handles?.setBad([]);
      return;
    }
    planning.check();
    if (!planning.answer && edited.missingEnds(planning.scene).length === 0) quietly(apply(planning.scene));
  }

  // Moves the selected thing by a centimetre; while the key is held it is one step of the history.
  function nudge(event) {
    const thing = handles?.selected;
    const step = stepOf(event);
    if (!thing || !step || drag) return false;
    const [axis, sign] = step;
    const to = edited.placeOf(planning.scene, thing).map((x, i) => (i === axis ? x + sign * STEP : x));
    const scene = edited.moveThing(planning.scene, thing, to);
    const goesOn = event.repeat && held?.scene === history.present && edited.isSame(held.thing, thing);
    if (goesOn) history.replace(scene);
    else history.push(scene);
    held = { thing, scene };
    quietly(apply(scene, { dragging: event.repeat }));
    return true;
  }

  // The key is up: what was planned quickly is planned fully.
  function release() {
    const isDue = held?.scene === planning.scene && active && !drag && planning.isSketched;
    held = null;
    if (isDue) quietly(apply(planning.scene));
  }

  // Selects the next thing, or the one before.
  function selectNext({ shiftKey }) {
    if (!handles || drag) return false;
    const known = things().filter(isVisible);
    if (known.length === 0) return false;
    const now = known.findIndex((one) => edited.isSame(one, handles.selected));
    const next = shiftKey ? (now < 0 ? -1 : now - 1) : now + 1;
    handles.select(known.at(next % known.length));
    return true;
  }

  function onShortcut({ key, shiftKey }) {
    const name = key.toLowerCase();
    if (name === 'z') (shiftKey ? redo : undo)();
    else if (name === 'y') redo();
    else return false;
    return true;
  }

  function escape() {
    if (handles?.cancel()) return true;
    if (!handles?.selected) return false;
    handles.select(null);
    return true;
  }

  function onKey(event) {
    const { key, target } = event;
    const isWaiting = (event.ctrlKey || event.metaKey) && toolbar.isComplete(target);
    if (isTyping(target) && !(target.type === 'range' || target.type === 'checkbox' || isWaiting)) return false;
    if (event.ctrlKey || event.metaKey) return active && !event.altKey && onShortcut(event);
    if (event.altKey) return false;
    if (key.toLowerCase() === 'e' && !event.repeat) {
      setActive(!active);
      return true;
    }
    if (!active || target.type === 'range') return false;
    if (key === 'Escape') return escape();
    if (key.toLowerCase() === 'n') return selectNext(event);
    if ((key === 'Delete' || key === 'Backspace') && handles?.selected?.kind === 'obstacle') {
      removeSelected();
      return true;
    }
    return nudge(event);
  }

  window.addEventListener('keydown', (event) => {
    if (!onKey(event)) return;
    event.preventDefault();
    event.stopPropagation();
  }, { capture: true });
  window.addEventListener('keyup', (event) => stepOf({ key: event.key }) && release());
  window.addEventListener('blur', release);

  const where = (name) => {
    const thing = things().find((one) => one.name === name);
    return (thing && handles?.where(thing)) ?? null;
  };
  publish({ planning, proving, history, apply, where });
  showAll();
}

// Three numbers that a scene can have as a position.
function readPosition(what, value) {
  const given = Array.isArray(value) || ArrayBuffer.isView(value) ? Array.from(value) : [];
  const isGood = given.length === 3 && given.every((x) => Number.isFinite(x) && Math.abs(x) <= MOST);
  if (!isGood) throw new Error(`${what}: expected three numbers [x, y, z] of at most ${MOST} m`);
  return given;
}

function checkNumber(what, value, isGood, expected) {
  if (value !== undefined && !(typeof value === 'number' && isGood(value))) throw new Error(`${what}: expected ${expected}`);
}

const checkBudget = (budget) => checkNumber('budgetMs', budget, (x) => x > 0 && x <= 1e12, 'a positive number of at most 1e12');

// For scripts: plans with other ends, moves obstacles, proves the workspace, and tells where things are on the page, px.
function publish({ planning, proving, history, apply, where }) {
  const step = async (scene, how) => {
    if (scene !== history.present) history.push(scene);
    const answer = await apply(scene, how);
    return answer === SUPERSEDED ? { ...SUPERSEDED } : briefly(answer);
  };
  // Nothing changes unless all of them are right.
  const plan = async (request) => {
    const { start, goal, seed, budgetMs } = request ?? {};
    const ends = Object.entries({ start, goal }).filter(([, at]) => at !== undefined && at !== null).map(([end, at]) => [end, readPosition(end, at)]);
    checkNumber('seed', seed, (x) => Number.isSafeInteger(x) && x >= 0, 'a whole number that is not negative');
    checkBudget(budgetMs);
    if (seed !== undefined) planning.setOptions({ seed });
    const scene = ends.reduce((before, [end, at]) => edited.moveEnd(before, end, at), planning.scene);
    return step(scene, { budget: budgetMs, again: true });
  };
  const move = async (obstacle, position) => {
    const { scene } = planning;
    if (!edited.hasObstacle(scene, obstacle)) {
      const known = edited.obstacleNames(scene).map((name) => `"${name}"`).join(', ');
      throw new Error(`there is no obstacle "${obstacle}"; there ${known ? `are ${known}` : 'are none'}`);
    }
    return step(edited.moveThing(scene, { kind: 'obstacle', id: obstacle }, readPosition('position', position)));
  };
  const workspace = async (request) => {
    const { budgetMs = SCRIPTED } = request ?? {};
    checkBudget(budgetMs);
    const answer = await proving.once(budgetMs);
    if (!answer) return null;
    const { proved: { volume, total }, decided, milliseconds } = answer;
    return { volume, total, decided, milliseconds };
  };
  window.cdpr = { plan, move, workspace, where };
}

// Why a page without the planner cannot be edited.
function reasonNotToEdit({ trajectory, regions }) {
  if (trajectory) return 'The page of a timed motion only shows it. For editing, make the page of its path: cdpr view SCENE PATH -o view.html';
  if (regions?.shown) return 'The page of forbidden regions only shows them. For editing, make the page of the scene: cdpr view SCENE -o view.html';
  return 'This page was written without the planner (--static, live=False), so it only shows its scene.';
}

/** Says on key E why a page without the planner cannot be edited. */
export function explainNoEditing(model) {
  const why = reasonNotToEdit(model);
  const onKey = ({ key, target, ctrlKey, metaKey, altKey }) => {
    if (key.toLowerCase() !== 'e' || ctrlKey || metaKey || altKey || isTyping(target)) return;
    if (!document.getElementById('edit-missing')) showMissing(why);
  };
  window.addEventListener('keydown', onKey);
}

function publishLack(sentence) {
  const lacking = async () => {
    throw new Error(sentence);
  };
  window.cdpr = { plan: lacking, move: lacking, workspace: lacking };
}

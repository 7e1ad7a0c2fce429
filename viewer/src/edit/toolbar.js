// The bar above the picture: the Edit button and, while editing, its tools, the selected thing and the state.

import { ENDS, isSame } from './document.js';
import { describeChanged, describeCulprits, describeInvalid, describeProved, describeQuality, describeViolations, formatLength } from '../wording.js';

/** Lengths beyond this, m, are typing errors. */
export const MOST = 1e6;

const PLANNERS = ['anytime', 'two-trees', 'rrt-connect', 'modified-rrt', 'rrt', 'rrt-star'];
const SVG = 'http://www.w3.org/2000/svg';
const UNDO = 'M5 3 2 6l3 3M2.5 6H10a3.5 3.5 0 0 1 0 7H7';
const REDO = 'M11 3l3 3-3 3M13.5 6H6a3.5 3.5 0 0 0 0 7h3';

const KEYS = [
  ['drag', 'move in the floor plane'],
  ['Shift + drag', 'move vertically'],
  ['arrows at the selected thing', 'move along one axis'],
  ['Alt', 'without the grid of 1 cm'],
  ['N, Shift + N', 'select the next thing, the one before'],
  ['← → ↑ ↓', '1 cm along x and y'],
  ['Page Up, Page Down, Shift + ↑ ↓', '1 cm vertically'],
  ['Ctrl + Z, Ctrl + Y', 'undo, redo'],
  ['Delete', 'remove the obstacle'],
  ['Esc', 'cancel the drag, or select nothing'],
  ['touch', 'tap to select, then drag'],
];

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const button = (text, title, onClick) => {
  const element = make('button', { type: 'button', title }, text);
  element.addEventListener('click', onClick);
  return element;
};

function iconButton(path, label, onClick) {
  const element = button('', label, onClick);
  const icon = document.createElementNS(SVG, 'svg');
  const line = document.createElementNS(SVG, 'path');
  icon.setAttribute('viewBox', '0 0 16 16');
  icon.setAttribute('aria-hidden', 'true');
  line.setAttribute('d', path);
  icon.append(line);
  element.append(icon);
  element.setAttribute('aria-label', label);
  element.classList.add('icon');
  return element;
}

function choice(label, options, onChange) {
  const select = make('select', { title: label }, ...options.map(([value, text]) => make('option', { value }, text)));
  select.setAttribute('aria-label', label);
  select.addEventListener('change', () => onChange(select.value));
  return select;
}

const shownNumber = (x) => String(Math.round(x * 1e4) / 1e4);

// What each number field shows: the scene's number, and whether the reader is typing another one.
const typed = new WeakMap();

function showNumber(input, text) {
  input.value = text;
  input.removeAttribute('aria-invalid');
}

// A comma would be dropped, which makes 15 of 1,5.
function typeCommaAsPoint(event) {
  if (!event.data?.includes(',')) return;
  event.preventDefault();
  document.execCommand('insertText', false, event.data.replaceAll(',', '.'));
}

// A number that is heard once it is complete.
function numberField(label, { step, min = -MOST }, onChange) {
  const input = make('input', { type: 'number', step, min, max: MOST, inputMode: 'decimal' });
  const field = { typing: false, text: '' };
  typed.set(input, field);
  input.setAttribute('aria-label', label);
  input.addEventListener('beforeinput', typeCommaAsPoint);
  input.addEventListener('input', () => {
    field.typing = true;
  });
  input.addEventListener('change', () => {
    const { rangeUnderflow, rangeOverflow } = input.validity;
    const good = Number.isFinite(input.valueAsNumber) && !rangeUnderflow && !rangeOverflow;
    input.setAttribute('aria-invalid', String(!good));
    field.typing = !good;
    if (good) onChange(input.valueAsNumber);
  });
  input.addEventListener('blur', () => {
    if (field.typing) showNumber(input, field.text);
    field.typing = false;
  });
  return input;
}

// Leaves it alone while it shows the same number, and while another one is being typed.
function setNumber(input, value) {
  const field = typed.get(input);
  field.text = shownNumber(value);
  if (!field.typing && Number(field.text) !== input.valueAsNumber) showNumber(input, field.text);
}

function menu(text, title, items) {
  const fold = make('details', { className: 'edit-menu' });
  const box = make('div', { className: 'edit-menu-items' }, ...items);
  fold.append(make('summary', { title }, text), box);
  const close = (event) => {
    if (!fold.contains(event.target) || box.contains(event.target)) fold.open = false;
  };
  document.addEventListener('click', close);
  return fold;
}

const keyList = () => make('dl', { className: 'edit-keys' }, ...KEYS.flatMap(([key, text]) => [make('dt', {}, key), make('dd', {}, text)]));

function saveMenu(on) {
  const scene = button('scene (TOML)', 'the scene as a file for cdpr', () => on.save('scene'));
  const path = button('path (JSON)', 'the path as a file for cdpr', () => on.save('path'));
  const page = button('this page (HTML)', 'the changed page as one file', () => on.save('page'));
  return { fold: menu('save', 'save scene, path or page', [scene, path, page]), path, page };
}

// Which planner is chosen; that of the page may be another one.
const plannersWith = (own) => (PLANNERS.includes(own) ? PLANNERS : [own, ...PLANNERS]);

function createTools(on, { planner, orientations }) {
  const undo = iconButton(UNDO, 'undo (Ctrl+Z)', on.undo);
  const redo = iconButton(REDO, 'redo (Ctrl+Shift+Z)', on.redo);
  const ends = ENDS.map((end) => button(`+ ${end}`, `add a ${end}`, () => on.addEnd(end)));
  const add = button('+ box', 'add a box', on.addBox);
  const remove = button('remove', 'remove the selected obstacle (Delete)', on.remove);
  const planners = choice('planner', plannersWith(planner).map((name) => [name, name]), on.setPlanner);
  planners.value = planner;
  const named = orientations.map((name) => [`=${name}`, name]);
  const turned = choice('orientation', [['', 'best orientation'], ...named], (value) => on.setOrientation(value === '' ? null : value.slice(1)));
  turned.hidden = orientations.length < 2;
  const clearance = numberField('clearance, m', { step: '0.005', min: '0' }, on.setClearance);
  const label = make('label', { className: 'edit-field', title: 'least distance between bodies' }, 'clearance', clearance, 'm');
  const volume = button('workspace', 'prove where the platform can be, and again after every change', on.toggleVolume);
  volume.setAttribute('aria-pressed', 'false');
  const save = saveMenu(on);
  const help = menu('?', 'keys', [keyList()]);
  help.firstChild.setAttribute('aria-label', 'keys of the editor');
  const group = (...items) => make('div', { className: 'edit-group' }, ...items);
  const box = make('div', { className: 'edit-tools' }, group(undo, redo), group(...ends, add, remove), group(planners, turned), group(label, volume), group(save.fold, help));
  return { box, undo, redo, ends, remove, planners, turned, clearance, volume, save };
}

const NOTHING = 'nothing selected: press start, goal, an obstacle or an outlet';
const UNSEEN = 'nothing can be selected without the 3D view; scripts move things with cdpr.move and cdpr.plan';

function createThing(on, { isDrawn }) {
  const name = make('strong', { className: 'edit-name' });
  const fields = ['x', 'y', 'z'].map((axis, i) => numberField(`${axis}, m`, { step: '0.01' }, (value) => on.setCoordinate(i, value)));
  const labels = fields.map((field, i) => make('label', { className: 'edit-field' }, 'xyz'[i], field));
  const sides = ['width', 'depth', 'height'].map((side, i) => numberField(`${side}, m`, { step: '0.01', min: '0.001' }, (value) => on.setSide(i, value)));
  const size = make('span', { className: 'edit-size' }, 'size', ...sides, 'm');
  const box = make('div', { className: 'edit-thing' }, name, ...labels, make('span', { className: 'edit-unit' }, 'm'), size);
  let shown = null;
  const show = (thing, place, sizes) => {
    // What is typed is meant for the thing before.
    if (!isSame(thing, shown)) for (const field of [...fields, ...sides]) typed.get(field).typing = false;
    shown = thing;
    box.classList.toggle('none', !thing);
    if (!thing) {
      name.textContent = isDrawn ? NOTHING : UNSEEN;
      name.title = '';
      return;
    }
    name.textContent = thing.name;
    name.title = thing.name;
    fields.forEach((field, i) => setNumber(field, place[i]));
    size.hidden = !sizes;
    if (sizes) sides.forEach((field, i) => setNumber(field, sizes[i]));
  };
  return { box, show };
}

const lengthWith = (cost, known) => [formatLength(cost), describeQuality(cost, known)].filter(Boolean).join(' · ');

function describeNoPath({ page }) {
  const culprits = page?.no_path?.culprits ?? [];
  const who = culprits.slice(0, 4).map((names) => describeCulprits(names.map(String))).join('; ');
  return who ? `no path (proved): closed by ${who}` : 'no path (proved)';
}

// A path that came with the page, and that no planner of the page has found.
function describeGiven({ waypoints, violations }) {
  if (waypoints.length === 0) return 'no path';
  const state = violations > 0 ? `this path is not valid (${describeViolations(violations, violations)}); it` : 'this path';
  return `${state} stays until something changes`;
}

const OUTCOMES = {
  given: describeGiven,
  solved: ({ cost, bound, path, waypoints }) =>
    lengthWith(cost, { bound: bound ?? path?.lower_bound, straight: path?.orientations ? 0 : distanceOf(waypoints) }),
  no_path: describeNoPath,
  budget_spent: () => 'no path found in time; this is no proof that there is none',
  start_invalid: () => 'the start is not valid',
  goal_invalid: () => 'the goal is not valid',
};

function distanceOf(waypoints) {
  const [a, b] = [waypoints[0], waypoints.at(-1)];
  return a && b ? Math.hypot(...a.map((x, i) => x - b[i])) : 0;
}

/** The state in one line, with a kind for its colour: "good", "bad", "busy" or "". */
export function describeState({ missing, invalid, busy, dragging, answer, best, error, stopped }) {
  if (error) return { kind: 'bad', text: error };
  if (invalid.length > 0) {
    return { kind: 'bad', text: invalid.map(({ end, violation }) => `${end} not valid: ${describeInvalid(violation)}`).join('; ') };
  }
  if (answer) {
    const text = OUTCOMES[answer.status]?.(answer) ?? answer.status;
    const kind = { solved: 'good', given: answer.violations > 0 ? 'bad' : '' }[answer.status] ?? 'bad';
    return { kind, text: stopped ? `${text} (stopped)` : text };
  }
  if (missing.length > 0) return { kind: '', text: `add a ${missing.join(' and a ')} to plan a path` };
  const length = best ? lengthWith(best.cost, best) : '';
  if (stopped) return { kind: '', text: 'stopped before a path was found' };
  if (busy) return { kind: 'busy', text: length ? `shorter? ${length}` : 'planning' };
  return { kind: dragging ? 'busy' : '', text: length };
}

function createStatus(on) {
  const text = make('span', { className: 'edit-text' });
  text.setAttribute('role', 'status');
  let invalid = [];
  const nearest = button('move to the nearest valid place', '', () => on.moveToNearest(invalid));
  const plan = button('plan a new path', 'from start to goal, with the planner chosen above', on.planAnew);
  // Until the ends are checked, neither would do anything.
  nearest.hidden = true;
  plan.hidden = true;
  const stop = button('stop', 'stop planning; the best path so far stays', on.stop);
  const bar = make('div', { className: 'edit-bar' });
  bar.setAttribute('aria-hidden', 'true');
  stop.classList.add('edit-stop');
  const box = make('div', { className: 'edit-status' }, text, nearest, plan, stop, bar);
  const show = (state) => {
    const { kind, text: line } = describeState(state);
    invalid = state.invalid;
    box.dataset.kind = kind;
    text.textContent = line;
    nearest.hidden = state.dragging || !state.invalid.some((one) => one.nearest);
    plan.hidden = state.answer?.status !== 'given' || state.missing.length > 0;
    box.classList.toggle('busy', state.busy);
  };
  return { box, show };
}

// Where the platform can be, while that is proved.
function createVolumeLine() {
  const text = make('span', { className: 'edit-proved' });
  text.setAttribute('role', 'status');
  const box = make('div', { className: 'edit-volume' }, text);
  box.hidden = true;
  const show = ({ proved, before, busy, error }) => {
    const line = proved ? describeChanged(proved, before) : 'proving where the platform can be';
    text.textContent = error ?? line;
    box.title = proved ? describeProved(proved).join('\n') : '';
    box.dataset.kind = error ? 'bad' : '';
    box.classList.toggle('busy', busy);
  };
  return { box, show };
}

/** The bar; `on` hears what the reader does. */
export function createToolbar(on, setup) {
  const toggle = button('Edit', 'edit the scene (key E)', on.toggle);
  toggle.id = 'edit-toggle';
  const bar = document.getElementById('tools');
  if (!setup.isDrawn) {
    // Of the tools above the picture only this one is left.
    for (const group of bar.children) group.hidden = true;
    bar.hidden = false;
  }
  bar.prepend(make('div', { className: 'tool-group' }, toggle));
  const done = button('Done', 'stop editing (key E)', on.toggle);
  done.className = 'edit-done';
  const tools = createTools(on, setup);
  const thing = createThing(on, setup);
  const volume = createVolumeLine();
  const status = createStatus(on);
  const head = make('div', { className: 'edit-head' }, done, tools.box);
  const section = make('section', { id: 'edit' }, head, thing.box, volume.box, status.box);
  section.setAttribute('aria-label', 'edit');
  bar.after(section);

  function setActive(active) {
    section.hidden = !active;
    document.documentElement.classList.toggle('editing', active);
    toggle.setAttribute('aria-pressed', String(active));
    toggle.textContent = active ? 'Done' : 'Edit';
  }

  setActive(false);
  return {
    setActive,
    showThing: thing.show,
    showState: status.show,
    showVolume: volume.show,
    /** Whether the workspace is proved. */
    setProving: (proving) => {
      volume.box.hidden = !proving;
      tools.volume.setAttribute('aria-pressed', String(proving));
    },
    /** Whether an element is a number field in which nothing is being typed. */
    isComplete: (element) => typed.get(element)?.typing === false,
    /** What can be done now, and the scene's own settings. */
    showTools: ({ canUndo, canRedo, canRemove, canSave, canSavePath, clearance, orientation, missing }) => {
      tools.ends.forEach((end, i) => {
        end.hidden = !missing.includes(ENDS[i]);
      });
      tools.undo.disabled = !canUndo;
      tools.redo.disabled = !canRedo;
      tools.remove.disabled = !canRemove;
      tools.save.path.disabled = !canSavePath;
      tools.save.page.disabled = !canSave;
      setNumber(tools.clearance, clearance);
      tools.turned.value = typeof orientation === 'string' ? `=${orientation}` : '';
    },
  };
}

/** Says what is missing where editing is not possible. */
export function showMissing(sentence) {
  const note = make('p', { id: 'edit-missing', className: 'more' }, sentence);
  document.getElementById('status').after(note);
}

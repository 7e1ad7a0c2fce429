// The panel: title, outcome, legend and list of violations; and the bar with the slider.

import { wallRole } from './theme.js';
import { describeCulprits, describeDetour, describeProof, describeReached } from './wording.js';
import { describeOutcome, describeRegions, describeViolation, formatPosition } from './wording.js';

const LISTED_VIOLATIONS = 100;
const LISTED_CULPRITS = 8;
const NARROW = '(max-width: 560px)';

const byId = (id) => document.getElementById(id);

function element(tag, className, text) {
  const result = document.createElement(tag);
  if (className) result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
}

/** Writes title and outcome. */
export function showSummary(model, length) {
  byId('title').textContent = model.title;
  byId('title').title = model.title;
  const outcome = describeOutcome(model.path, length, model.violations.length, model.trajectory);
  byId('status').textContent = model.regions?.shown && !model.path ? describeRegions(model.regions) : outcome;
  byId('status').classList.toggle('none', Boolean(model.noPath));
  byId('planner').textContent = model.path?.planner ? `planner: ${model.path.planner}` : '';
}

// Those who close the way, in the colours of their walls.
function culpritItems(culprits) {
  const items = culprits.slice(0, LISTED_CULPRITS).map((names, i) => {
    const item = element('li');
    item.append(element('span', `swatch solid of-${wallRole(i)}`), element('span', '', describeCulprits(names)));
    return item;
  });
  const rest = culprits.length - items.length;
  return rest > 0 ? [...items, element('li', 'more', `and ${rest} more`)] : items;
}

/** Says why there is no path; `onPick` hears the name of the obstacle to be left out, or null. */
export function showNoPath(noPath, onPick) {
  byId('no-path').hidden = !noPath;
  if (!noPath) return;
  byId('closed-by').replaceChildren(...culpritItems(noPath.culprits));
  byId('reached').textContent = describeReached(noPath);
  byId('proved').textContent = describeProof(noPath);
  const buttons = noPath.without.map((detour) => {
    const button = element('button', '', describeDetour(detour));
    button.type = 'button';
    button.disabled = detour.cost === null;
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('click', () => pick(button, detour.obstacle));
    return button;
  });
  const pick = (button, name) => {
    const pressed = button.getAttribute('aria-pressed') !== 'true';
    for (const other of buttons) other.setAttribute('aria-pressed', String(pressed && other === button));
    onPick(pressed ? name : null);
  };
  const none = element('p', '', 'No obstacle has a part in it: leaving one out does not help.');
  byId('remedies').replaceChildren(...(buttons.length > 0 ? buttons : [none]));
}

/** Folds what would cover a narrow page. A frame in a notebook may get its width only after the page has started. */
export function foldWhereNarrow() {
  const query = window.matchMedia(NARROW);
  const fold = () => {
    for (const id of ['details', 'plots']) byId(id).open = !query.matches;
  };
  query.addEventListener('change', fold);
  fold();
}

/** Empties the legend, and returns a function that unfolds and scrolls what comes next as it was. */
export function clearLegend() {
  const folds = () => [...byId('legend').querySelectorAll('details')];
  const titleOf = (fold) => fold.querySelector('summary').textContent;
  const open = new Map(folds().map((fold) => [titleOf(fold), fold.open]));
  const scrolled = byId('panel').scrollTop;
  byId('legend').replaceChildren();
  return () => {
    for (const fold of folds()) fold.open = open.get(titleOf(fold)) ?? fold.open;
    byId('panel').scrollTop = scrolled;
  };
}

/** Adds a fold below a row of the legend, for rows of parts of that layer. */
export function addLegendFold(title, open, row) {
  const fold = element('details', 'fold');
  fold.open = open;
  fold.append(element('summary', '', title));
  row.after(fold);
  return fold;
}

/** Adds a remark below a row of the legend. */
export function addLegendNote(text, row) {
  row.after(element('p', 'more fold', text));
}

/** Adds buttons to a fold that show or hide all of its parts. */
export function addAllOrNone(fold, parts) {
  const row = element('div', 'row');
  for (const [text, visible] of [['all', true], ['none', false]]) {
    const button = element('button', '', text);
    button.type = 'button';
    button.addEventListener('click', () => {
      for (const part of parts) part.visible = visible;
    });
    row.append(button);
  }
  fold.querySelector('summary').after(row);
}

/** Adds a row with a checkbox to the legend, or to a fold of it, and returns it with a function that ticks it. */
export function addLegendRow(name, swatch, layer, parent = byId('legend')) {
  const row = element('label', 'legend-row');
  const box = element('input');
  box.type = 'checkbox';
  box.checked = layer.visible;
  box.addEventListener('change', () => {
    layer.visible = box.checked;
  });
  row.append(box, element('span', `swatch ${swatch}`), element('span', 'legend-name', name));
  parent.append(row);
  const tick = (visible) => {
    box.checked = visible;
  };
  return { element: row, tick };
}

function violationItem(violation, place, onPick) {
  const item = element('li');
  const button = element('button', 'violation', describeViolation(violation, place));
  button.type = 'button';
  button.addEventListener('click', () => onPick(place));
  item.append(button);
  return item;
}

/** Lists violations; `placeOf` tells where one begins, `onPick` hears the place of the one that is clicked. */
export function showViolations(violations, placeOf, onPick) {
  byId('violations').hidden = violations.length === 0;
  const shown = violations.slice(0, LISTED_VIOLATIONS).map((v) => violationItem(v, placeOf(v), onPick));
  byId('violation-list').replaceChildren(...shown);
  byId('violation-count').textContent = `${violations.length} violation${violations.length === 1 ? '' : 's'}`;
  const rest = violations.length - shown.length;
  if (rest > 0) byId('violation-list').append(element('li', 'more', `and ${rest} more`));
}

/** How much of the window panel and bar cover at each side, px. */
export function coveredMargins() {
  const panel = byId('panel').getBoundingClientRect();
  const bar = byId('bar').getBoundingClientRect();
  const bottom = bar.height > 0 ? window.innerHeight - bar.top : 0;
  const narrow = window.matchMedia(NARROW).matches;
  if (narrow) return { left: 0, right: 0, top: panel.bottom, bottom };
  const plots = byId('plots').getBoundingClientRect();
  const right = byId('plots').open && plots.width > 0 ? window.innerWidth - plots.left : 0;
  return { left: panel.right, right, top: 0, bottom };
}

/** Puts a plain message in place of the 3D view. */
export function showMessage(text) {
  byId('message').textContent = text;
  byId('message').hidden = false;
}

const KEY_STEPS = {
  ArrowRight: 0.01,
  ArrowUp: 0.01,
  ArrowLeft: -0.01,
  ArrowDown: -0.01,
  PageUp: 0.1,
  PageDown: -0.1,
  Home: -1,
  End: 1,
};

function moveBy(step, playback, event) {
  event.preventDefault();
  playback.pause();
  playback.setDistance(playback.distance() + step * playback.length());
}

function connectSlider(slider, playback, options) {
  slider.addEventListener('input', () => {
    playback.pause();
    playback.setDistance(Number(slider.value));
  }, options);
  slider.addEventListener('keydown', (event) => {
    const step = KEY_STEPS[event.key];
    if (step !== undefined) moveBy(step, playback, event);
  }, options);
}

/** Connects slider and play button to the playback, of a trajectory if `timed`, until the signal. */
export function connectTransport(playback, timed, signal) {
  const setSpeed = () => playback.setSpeed(Number(byId('speed').value));
  connectSlider(byId('slider'), playback, { signal });
  byId('play').addEventListener('click', playback.toggle, { signal });
  byId('speed').addEventListener('change', setSpeed, { signal });
  setSpeed();
  if (timed) {
    byId('slider').setAttribute('aria-label', 'time, s');
    byId('speed').title = 'speed of the playback; 1× is real time';
  }
  showTransport(playback.length());
}

/** Shows slider and play button for a path of a length, m, or a trajectory of a duration, s. */
export function showTransport(length) {
  byId('slider').max = String(length);
  byId('transport').hidden = length === 0;
}

/** Shows a distance or time on the slider, and in words. */
export function showDistance(distance, length, text) {
  if (length === 0) return;
  byId('slider').value = String(distance);
  byId('slider').setAttribute('aria-valuetext', text);
  byId('distance').textContent = text;
}

/** Shows where the platform is, in a unit that suits a scene of this size. */
export function showPosition(position, size) {
  byId('position').textContent = `platform at ${formatPosition(position, size)}`;
}

/** Shows whether the platform runs. */
export function showPlaying(playing) {
  byId('play').setAttribute('aria-label', playing ? 'pause' : 'play');
  byId('play').dataset.playing = String(playing);
}

const SECTIONS = ['', 'x', 'y', 'z'];

/** Connects the buttons that change the view. */
export function connectTools({ look, cut, save, toggleLook, resize }) {
  for (const axis of ['x', 'y', 'z']) byId(`view-${axis}`).addEventListener('click', () => look(axis));
  byId('reset').addEventListener('click', () => look());
  byId('save').addEventListener('click', save);
  byId('look').addEventListener('click', toggleLook);
  byId('plots').addEventListener('toggle', resize);
  const section = () => {
    byId('section-at').disabled = byId('section').value === '';
    cut(byId('section').value, Number(byId('section-at').value));
  };
  byId('section').addEventListener('change', section);
  byId('section-at').addEventListener('input', section);
  byId('tools').hidden = false;
}

function nextSection() {
  const next = (SECTIONS.indexOf(byId('section').value) + 1) % SECTIONS.length;
  byId('section').value = SECTIONS[next];
  byId('section').dispatchEvent(new Event('change'));
}

const isWithin = (target, selector) => target instanceof Element && target.closest(selector) !== null;

// Those who take the space bar or the arrow keys themselves.
const isOperable = (target) => isWithin(target, 'button, summary, select, input[type=checkbox]');
const takesArrows = (target) => isWithin(target, 'canvas, select, input[type=range]');

const VIEW_KEYS = {
  1: ({ look }) => look('x'),
  2: ({ look }) => look('y'),
  3: ({ look }) => look('z'),
  r: ({ look }) => look(),
  s: nextSection,
  d: ({ toggleLook }) => toggleLook(),
  p: ({ save }) => save(),
};

/** Keys for playing, for moving along the path and, where there is a view, for what its buttons do; until the signal. */
export function connectKeys(playback, view, signal) {
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (KEY_STEPS[event.key] !== undefined && !takesArrows(event.target)) moveBy(KEY_STEPS[event.key], playback, event);
    if (event.repeat) return;
    if (view.look && !isWithin(event.target, 'select')) VIEW_KEYS[event.key.toLowerCase()]?.(view);
    if (event.key !== ' ' || isOperable(event.target)) return;
    event.preventDefault();
    playback.toggle();
  }, { signal });
}

// The panel: title, outcome, legend and list of violations; and the bar with the slider.

import { wallRole } from './theme.js';
import { describeCulprits, describeDetour, describeProof, describeReached } from './wording.js';
import { describeReason, describeViolation, describeViolations, formatPosition, lengthAxis } from './wording.js';

const LISTED_VIOLATIONS = 100;
const LISTED_CULPRITS = 8;
// Panel and charts share one sheet at the bottom.
const NARROW = '(max-width: 899px)';

const byId = (id) => document.getElementById(id);

function element(tag, className, text) {
  const result = document.createElement(tag);
  if (className) result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
}

/** Writes the title. */
export function showSummary(model) {
  byId('title').textContent = model.title;
  byId('title').title = model.title;
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

const tabs = () => [...byId('tabs').querySelectorAll('button')];

// Shows one part in the sheet; an empty name folds it.
function showTab(name) {
  document.body.dataset.tab = name;
  for (const tab of tabs()) tab.setAttribute('aria-pressed', String(tab.dataset.tab === name));
  byId('sheet').dispatchEvent(new Event('fold'));
}

/** Connects the tabs of narrow pages, where folds are open. A notebook's frame may get its width only later. */
export function foldWhereNarrow() {
  const query = window.matchMedia(NARROW);
  const unfold = () => {
    for (const id of ['details', 'plots']) byId(id).open = true;
  };
  for (const tab of tabs()) {
    const { tab: name } = tab.dataset;
    tab.addEventListener('click', () => showTab(document.body.dataset.tab === name ? '' : name));
  }
  showTab('result');
  query.addEventListener('change', unfold);
  unfold();
}

/** Whether there are charts. */
export const hasCharts = () => !byId('plots').hidden;

/** Folds the charts, where they lie beside the picture. */
export function foldCharts() {
  if (!window.matchMedia(NARROW).matches) byId('plots').open = false;
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
    if (scrolled > 0) byId('panel').scrollTop = scrolled;
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

/** Adds a place for rows below a row of the legend. */
export function addLegendPlace(row) {
  const place = element('div', 'fold');
  row.after(place);
  return place;
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

/** The part of the legend for a group of layers, made when it is first asked for. */
export function legendGroup(title) {
  const found = [...byId('legend').children].find((group) => group.dataset.title === title);
  if (found) return found;
  const group = element('section', 'legend-group');
  group.dataset.title = title;
  group.append(element('h3', '', title));
  byId('legend').append(group);
  return group;
}

/** Adds a row with a checkbox to a part of the legend, and returns it with a function that ticks it. */
export function addLegendRow(name, swatch, layer, parent) {
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

// Violations that begin at the same place, as one item: the first one, and a fold with the others.
function violationItem({ place, members }, onPick) {
  const item = element('li');
  const button = element('button', 'violation', describeViolation(members[0], place));
  button.type = 'button';
  button.addEventListener('click', () => onPick(place));
  item.append(button);
  if (members.length === 1) return item;
  const fold = element('details', 'same-place');
  const list = element('ul');
  const others = members.slice(1, LISTED_VIOLATIONS);
  list.append(...others.map((violation) => element('li', '', describeReason(violation))));
  if (others.length < members.length - 1) list.append(element('li', 'more', `and ${members.length - 1 - others.length} more`));
  fold.append(element('summary', '', `and ${members.length - 1} more at this place`), list);
  item.append(fold);
  return item;
}

// Violations nearer to each other than this share of the path are at one place.
const ONE_PLACE = 1e-4;

// Those of one place together; the list is sorted along the path.
function byPlace(violations, placeOf, length) {
  const groups = [];
  for (const violation of violations) {
    const place = placeOf(violation);
    const last = groups.at(-1);
    if (last && Math.abs(place - last.place) <= ONE_PLACE * length) last.members.push(violation);
    else groups.push({ place, members: [violation] });
  }
  return groups;
}

/** Lists violations; `route` tells where one begins, `onPick` hears the place of the one that is clicked. */
export function showViolations(violations, { placeOf, length }, onPick) {
  byId('violations').hidden = violations.length === 0;
  const groups = byPlace(violations, placeOf, length);
  const shown = groups.slice(0, LISTED_VIOLATIONS).map((group) => violationItem(group, onPick));
  byId('violation-list').replaceChildren(...shown);
  byId('violation-count').textContent = describeViolations(violations.length, groups.length);
  const rest = groups.length - shown.length;
  if (rest > 0) byId('violation-list').append(element('li', 'more', `and ${rest} more`));
}

/** How much of the window panel and bar cover at each side, px. */
export function coveredMargins() {
  const topOf = (id) => (byId(id).getBoundingClientRect().height > 0 ? byId(id).getBoundingClientRect().top : window.innerHeight);
  const tools = Math.max(...['tools', 'edit'].map((id) => byId(id)?.getBoundingClientRect().bottom ?? 0));
  if (window.matchMedia(NARROW).matches) {
    const top = Math.min(...['bar', 'tabs'].map(topOf));
    return { left: 0, right: 0, top: tools, bottom: window.innerHeight - top };
  }
  const panel = byId('panel').getBoundingClientRect();
  const plots = byId('plots').getBoundingClientRect();
  const right = byId('plots').open && plots.width > 0 ? window.innerWidth - plots.left : 0;
  return { left: panel.right, right, top: tools, bottom: window.innerHeight - topOf('bar') };
}

/** Says how far the lines of the grid are from each other, m; null: there is no grid. */
export function showGridStep(step) {
  byId('corner').hidden = false;
  byId('grid-step').textContent = step === null ? '' : `grid ${lengthAxis(step).brief(step)}`;
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

/** Marks places on the slider: the waypoints. */
export function showStops(places, length) {
  const marks = places.filter((place) => place > 0 && place < length).map((place) => {
    const mark = element('span', 'stop');
    mark.style.setProperty('--at', String(place / length));
    return mark;
  });
  byId('stops').replaceChildren(...marks);
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

// The keys; pressed again, they go.
function showHelp() {
  const help = byId('help');
  if (help.open) help.close();
  else help.showModal();
}

const SECTIONS = ['', 'x', 'y', 'z'];

/** Connects the buttons that change the view. */
export function connectTools({ look, cut, save, toggleLook, resize }) {
  for (const axis of ['x', 'y', 'z']) byId(`view-${axis}`).addEventListener('click', () => look(axis));
  byId('reset').addEventListener('click', () => look());
  byId('save').addEventListener('click', save);
  byId('look').addEventListener('click', toggleLook);
  for (const [id, event] of [['plots', 'toggle'], ['sheet', 'fold']]) byId(id).addEventListener(event, resize);
  byId('keys').addEventListener('click', showHelp);
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
  '?': showHelp,
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

// The panel: title, outcome, legend and list of violations; and the bar with the slider.

import { describeOutcome, describeRegions, describeViolation, formatProgress } from './wording.js';

const LISTED_VIOLATIONS = 100;
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
  const outcome = describeOutcome(model.path, length, model.violations.length);
  byId('status').textContent = model.regions && !model.path ? describeRegions(model.regions) : outcome;
  if (model.path?.planner) byId('planner').textContent = `planner: ${model.path.planner}`;
  byId('details').open = !window.matchMedia(NARROW).matches;
}

/** Adds a row with a checkbox to the legend and returns a function that ticks it. */
export function addLegendRow(name, swatch, layer) {
  const row = element('label', 'legend-row');
  const box = element('input');
  box.type = 'checkbox';
  box.checked = layer.visible;
  box.addEventListener('change', () => {
    layer.visible = box.checked;
  });
  row.append(box, element('span', `swatch ${swatch}`), element('span', 'legend-name', name));
  byId('legend').append(row);
  return (visible) => {
    box.checked = visible;
  };
}

function violationItem(violation, onPick) {
  const item = element('li');
  const button = element('button', 'violation', describeViolation(violation));
  button.type = 'button';
  button.addEventListener('click', () => onPick(violation));
  item.append(button);
  return item;
}

/** Lists violations; `onPick` hears which one is clicked. */
export function showViolations(violations, onPick) {
  if (violations.length === 0) return;
  const shown = violations.slice(0, LISTED_VIOLATIONS).map((v) => violationItem(v, onPick));
  byId('violation-list').replaceChildren(...shown);
  byId('violation-count').textContent = `${violations.length} violation${violations.length === 1 ? '' : 's'}`;
  const rest = violations.length - shown.length;
  if (rest > 0) byId('violation-list').append(element('li', 'more', `and ${rest} more`));
  byId('violations').hidden = false;
}

/** How much of the window panel and bar cover at each side, px. */
export function coveredMargins() {
  const panel = byId('panel').getBoundingClientRect();
  const bar = byId('bar').getBoundingClientRect();
  const bottom = bar.height > 0 ? window.innerHeight - bar.top : 0;
  const narrow = window.matchMedia(NARROW).matches;
  return narrow ? { left: 0, top: panel.bottom, bottom } : { left: panel.right, top: 0, bottom };
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

function connectSlider(slider, playback) {
  slider.max = String(playback.length);
  slider.addEventListener('input', () => {
    playback.pause();
    playback.setDistance(Number(slider.value));
  });
  slider.addEventListener('keydown', (event) => {
    const step = KEY_STEPS[event.key];
    if (step === undefined) return;
    event.preventDefault();
    playback.pause();
    playback.setDistance(playback.distance() + step * playback.length);
  });
}

/** Connects slider and play button to the playback. */
export function connectTransport(playback) {
  if (playback.length === 0) return;
  connectSlider(byId('slider'), playback);
  byId('play').addEventListener('click', playback.toggle);
  byId('transport').hidden = false;
}

/** Shows a distance on the slider. */
export function showDistance(distance, length) {
  if (length === 0) return;
  const text = formatProgress(distance, length);
  byId('slider').value = String(distance);
  byId('slider').setAttribute('aria-valuetext', text);
  byId('distance').textContent = text;
}

/** Shows whether the platform runs. */
export function showPlaying(playing) {
  byId('play').setAttribute('aria-label', playing ? 'pause' : 'play');
  byId('play').dataset.playing = String(playing);
}

const isOperable = (target) => target instanceof Element && target.closest('button, summary, input[type=checkbox]') !== null;

/** Space plays and pauses, R resets the view. */
export function connectKeys(playback, resetView) {
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return;
    if (event.key === 'r' || event.key === 'R') resetView();
    if (event.key !== ' ' || isOperable(event.target)) return;
    event.preventDefault();
    playback.toggle();
  });
}

/** Connects the button that resets the view. */
export function connectReset(resetView) {
  byId('reset').addEventListener('click', resetView);
  byId('reset').hidden = false;
}

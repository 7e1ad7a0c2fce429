// Charts over the distance along the path or over time, with a cursor that follows the platform.

import { pointsAtCable, spotlight, watchSpotlight } from './spotlight.js';
import { REGION_COLORS } from './theme.js';

const SVG = 'http://www.w3.org/2000/svg';
const WIDTH = 300;
const HEIGHT = 80;
// The height of the strokes at waypoints.
const WAYPOINT = 7;

/** Limits further away than this many heights of the curves are not drawn: they would press them flat. */
export const FAR = 1;

/** The colour of a cable. */
export const colorOf = (index) => `var(--region${index % REGION_COLORS})`;

// Where there are more cables than colours, these tell them apart: border styles and dashes of curves.
const STYLES = [['solid', 'none'], ['dashed', '7 3'], ['dotted', '2 3']];

const styleOf = (index) => STYLES[Math.floor(index / REGION_COLORS) % STYLES.length];

/** An element with a class and a text. */
export function html(tag, className, text) {
  const result = document.createElement(tag);
  result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
}

function svg(tag, attributes) {
  const result = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  return result;
}

/** A swatch in the colour and style of a cable. */
export function cableSwatch(index) {
  const swatch = html('span', 'swatch line');
  swatch.style.setProperty('--swatch', colorOf(index));
  [swatch.style.borderTopStyle] = styleOf(index);
  return swatch;
}

const isFar = (limit, low, high, far) => {
  const height = high - low || Math.abs(high) || 1;
  return limit > high + far * height || limit < low - far * height;
};

// What the vertical axis covers: all values, and limits that are near.
function rangeOf(values, limits, far) {
  let low = values.reduce((least, value) => Math.min(least, value));
  let high = values.reduce((most, value) => Math.max(most, value));
  const near = limits.filter((limit) => !isFar(limit, low, high, far));
  low = Math.min(low, ...near);
  high = Math.max(high, ...near);
  const rim = (high - low || Math.abs(high) || 1) * 0.04;
  return { low: low - rim, high: high + rim };
}

// Where a curve has gaps it is drawn in pieces.
function curve(values, x, y) {
  let pen = 'M';
  return values
    .map((value, i) => {
      if (!Number.isFinite(value)) {
        pen = 'M';
        return '';
      }
      const step = `${pen}${x[i].toFixed(1)} ${y(value).toFixed(1)}`;
      pen = 'L';
      return step;
    })
    .join('');
}

const level = (className, y) => svg('line', { class: className, x1: 0, x2: WIDTH, y1: y, y2: y });

const upright = (className, x) => svg('line', { class: className, x1: x, x2: x, y1: 0, y2: HEIGHT });

// What the values must not fall below, and the area there.
function floorOf(floor, x, y) {
  const edge = curve(floor, x, y);
  const end = x.at(-1).toFixed(1);
  const area = svg('path', { class: 'forbidden', d: `${edge}L${end} ${HEIGHT}L${x[0].toFixed(1)} ${HEIGHT}Z` });
  return [area, svg('path', { class: 'limit', d: edge })];
}

// The waypoints: short strokes on the axis.
const stroke = (x) => svg('line', { class: 'waypoint', x1: x, x2: x, y1: HEIGHT - WAYPOINT, y2: HEIGHT });

function drawing({ name, series, limits, floor }, { length, whole, marks, ticks, corners }, { low, high }) {
  const y = (value) => HEIGHT * (1 - (value - low) / (high - low));
  const across = (at) => (WIDTH * at) / length;
  const size = { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none' };
  const picture = svg('svg', { ...size, role: 'img', 'aria-label': name });
  for (const tick of ticks) picture.append(upright('tick', (WIDTH * tick) / whole));
  if (floor) picture.append(...floorOf(floor, series[0].at.map(across), y));
  for (const mark of marks) picture.append(upright('fault', across(mark)));
  for (const limit of limits) if (limit >= low && limit <= high) picture.append(level('limit', y(limit)));
  series.forEach(({ at, values }, i) => {
    const path = svg('path', { class: 'curve', d: curve(values, at.map(across), y) });
    path.style.stroke = series.length > 1 ? colorOf(i) : 'var(--text)';
    [, path.style.strokeDasharray] = styleOf(i);
    picture.append(path);
  });
  picture.append(...corners.map((corner) => stroke(across(corner))));
  return picture;
}

// Labels nearer to each other than this share of the height would overlap.
const LABEL_SPACE = 0.15;

// The greatest and the least value, each at its height.
function extremes({ axis, say }, values, { low, high }) {
  const most = values.reduce((a, b) => Math.max(a, b));
  const least = values.reduce((a, b) => Math.min(a, b));
  const labels = [];
  for (const value of new Set([least, most])) {
    const top = (high - value) / (high - low);
    if (labels.some((label) => Math.abs(label.top - top) < LABEL_SPACE)) continue;
    labels.push({ top, text: (say ?? axis.format)(value), kind: 'scale', value });
  }
  return labels;
}

// More limits than these, of cables that differ, are drawn but not all labelled.
const LABELLED_LIMITS = 4;

// What is required at least, and limits, with their values and units; those beyond the chart have an arrow.
function bounds({ limits, axis, floor }, { low, high }) {
  const sorted = [...limits].sort((a, b) => b - a);
  const told = sorted.length > LABELLED_LIMITS ? [sorted[0], sorted.at(-1)] : sorted;
  const required = [...new Set(floor ?? [])].filter((value) => value > 0);
  const all = [...told.map((value) => ({ value, word: 'limit' })), ...required.map((value) => ({ value, word: 'min' }))];
  return all.map(({ value, word }) => {
    const arrow = { [value > high]: '↑ ', [value < low]: '↓ ' }[true] ?? '';
    const top = Math.min(1, Math.max(0, (high - value) / (high - low)));
    return { top, text: `${arrow}${word} ${axis.brief(value)}`, kind: 'bound' };
  });
}

// Labels at their heights, moved apart where they would overlap.
function spread(labels) {
  labels.sort((a, b) => a.top - b.top);
  const space = Math.min(LABEL_SPACE, 1 / labels.length);
  labels.forEach((label, i) => {
    label.top = Math.max(label.top, i > 0 ? labels[i - 1].top + space : 0);
  });
  for (let i = labels.length - 1; i >= 0; i -= 1) {
    labels[i].top = Math.min(labels[i].top, i + 1 < labels.length ? labels[i + 1].top - space : 1);
  }
  return labels;
}

// Values are rounded to this share of a limit.
const ROUNDING = 1e-4;

// Whether a value is not between the limits; one limit alone is a maximum.
function isBeyond(limits, value) {
  if (limits.length === 0) return false;
  const most = Math.max(...limits);
  const least = limits.length > 1 ? Math.min(...limits) : -Infinity;
  return value > most + ROUNDING * Math.abs(most) || value < least - ROUNDING * Math.abs(least);
}

// What stands beside a chart.
function scale(plot, values, range) {
  const ends = extremes(plot, values, range);
  const limits = bounds(plot, range);
  const free = ends.flatMap((end) => {
    if (isBeyond(plot.limits, end.value)) return [{ ...end, kind: 'scale bad' }];
    // A value at its limit needs no label of its own.
    return limits.some((limit) => Math.abs(limit.top - end.top) < LABEL_SPACE / 2) ? [] : [end];
  });
  return spread([...limits, ...free]);
}

function labelsOf(plot, values, range) {
  return scale(plot, values, range).map(({ top, text, kind }) => {
    const label = html('span', kind, text);
    label.style.top = `${(100 * top).toFixed(1)}%`;
    return label;
  });
}

/** The horizontal axis with its ticks. */
export function ground({ whole, ticks, title, unit }) {
  const box = html('div', 'ground ticks');
  for (const tick of ticks) {
    const label = html('span', 'at', String(tick));
    label.style.left = `${(100 * tick) / whole}%`;
    box.append(label);
  }
  box.append(html('span', 'axis', `${title}, ${unit}`));
  return box;
}

/** An area in which the reader points at a place between 0 and a length, with a cursor. */
export function createArea(className, length, pick) {
  const area = html('div', `area ${className}`);
  const cursor = html('div', 'cursor');
  const follow = (event) => {
    const { left, width } = area.getBoundingClientRect();
    pick(length * Math.min(1, Math.max(0, (event.clientX - left) / width)));
  };
  area.addEventListener('pointerdown', (event) => {
    area.setPointerCapture(event.pointerId);
    follow(event);
  });
  area.addEventListener('pointermove', (event) => {
    if (event.buttons === 1) follow(event);
  });
  const show = (at) => {
    cursor.style.left = `${(100 * at) / length}%`;
  };
  return { area, cursor, show };
}

// The number at the cursor, of plots that say it.
function createReading(plot, caption) {
  if (!plot.reading) return () => {};
  const reading = html('output', 'reading');
  caption.append(reading);
  const say = plot.sayFully ?? ((value) => `${plot.axis.format(value)}\u00a0${plot.axis.unit}`);
  return (at) => {
    reading.textContent = say(valueAt(plot.series[0], at));
  };
}

// A curve this near to the pointer is meant, as a share of the height.
const CURVE_NEAR = 0.12;

// Curves of cables are brought out while the reader points at one of them, or at that cable elsewhere.
function connectCurves(plot, area, length, { low, high }) {
  if (plot.series.length < 2) return;
  const curves = [...area.querySelectorAll('.curve')];
  area.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0) return;
    const { left, top, width, height } = area.getBoundingClientRect();
    const at = (length * (event.clientX - left)) / width;
    const value = high - ((event.clientY - top) / height) * (high - low);
    const aside = plot.series.map((one) => Math.abs(valueAt(one, at) - value) / (high - low));
    const best = aside.reduce((least, one, i) => (one < aside[least] ? i : least), 0);
    spotlight(aside[best] < CURVE_NEAR ? best : null);
  });
  area.addEventListener('pointerleave', () => spotlight(null));
  watchSpotlight(`chart of ${plot.name}`, (lit) => {
    curves.forEach((one, i) => {
      one.classList.toggle('lit', i === lit);
      one.classList.toggle('faded', lit !== null && i !== lit);
    });
  });
}

/** Makes a row of the table stand for a cable. */
export function connectRow(row, index) {
  row.tabIndex = 0;
  pointsAtCable(row, index);
  watchSpotlight(`row ${index}`, (lit) => row.classList.toggle('lit', lit === index));
}

/** A chart of curves; `show` moves its cursor. */
export function createChart(plot, horizontal, pick) {
  const box = html('figure', 'plot');
  const values = plot.series.flatMap((one) => one.values).filter(Number.isFinite);
  const caption = html('figcaption', '', `${plot.name}, ${plot.axis.unit}`);
  box.append(caption);
  if (values.length === 0) {
    box.append(html('p', 'more', plot.none ?? 'none'));
    return { box, show: () => {} };
  }
  const read = createReading(plot, caption);
  const range = rangeOf([...values, ...(plot.floor ?? []), ...(plot.from ?? [])], plot.limits, plot.far ?? FAR);
  const { area, cursor, show } = createArea('', horizontal.length, pick);
  area.append(drawing(plot, horizontal, range), ...labelsOf(plot, values, range), cursor);
  connectCurves(plot, area, horizontal.length, range);
  box.append(area, ground(horizontal));
  return {
    box,
    show: (at) => {
      show(at);
      read(at);
    },
  };
}

/** Indices of the steps on both sides of a place, the nearer one first. */
export function stepsAt(steps, place) {
  let low = 0;
  let high = steps.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (steps[middle] <= place) low = middle;
    else high = middle;
  }
  return place - steps[low] < steps[high] - place ? [low, high] : [high, low];
}

/** The value of a curve at a place, between steps on the straight line. */
export function valueAt({ at, values }, place) {
  const [near, other] = stepsAt(at, place);
  const share = (place - at[near]) / (at[other] - at[near]);
  const between = values[near] + (values[other] - values[near]) * Math.min(1, Math.max(0, share));
  return Number.isFinite(between) && Number.isFinite(values[other]) ? between : values[near];
}

/** The largest absolute value. */
export const largest = (values) =>
  values.reduce((most, value) => (Number.isFinite(value) ? Math.max(most, Math.abs(value)) : most), 0);

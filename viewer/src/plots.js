// The side panel: lengths, clearance and tensions along the path, with a cursor that follows the platform.

import { describeTightest, describeWrench, forceAxis, lengthAxis, numberAxis } from './wording.js';
import { REGION_COLORS } from './theme.js';

const SVG = 'http://www.w3.org/2000/svg';
const WIDTH = 300;
const HEIGHT = 80;
// Limits further away than this many heights of the curves are not drawn: they would press them flat.
const FAR = 1;

const byId = (id) => document.getElementById(id);

const colorOf = (index) => `var(--region${index % REGION_COLORS})`;

// Where there are more cables than colours, these tell them apart: border styles and dashes of curves.
const STYLES = [['solid', 'none'], ['dashed', '7 3'], ['dotted', '2 3']];

const styleOf = (index) => STYLES[Math.floor(index / REGION_COLORS) % STYLES.length];

function html(tag, className, text) {
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

// What the vertical axis covers: all values, and limits that are near.
function rangeOf(values, limits) {
  let low = Math.min(...values);
  let high = Math.max(...values);
  const height = high - low || Math.abs(high) || 1;
  for (const limit of limits) {
    if (limit > high + FAR * height || limit < low - FAR * height) continue;
    low = Math.min(low, limit);
    high = Math.max(high, limit);
  }
  const rim = (high - low || height) * 0.04;
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

function line(className, y) {
  return svg('line', { class: className, x1: 0, x2: WIDTH, y1: y, y2: y });
}

// What the values must not fall below, and the area there.
function floorOf(floor, x, y) {
  const edge = curve(floor, x, y);
  const end = x.at(-1).toFixed(1);
  const area = svg('path', { class: 'forbidden', d: `${edge}L${end} ${HEIGHT}L${x[0].toFixed(1)} ${HEIGHT}Z` });
  return [area, svg('path', { class: 'limit', d: edge })];
}

function drawing({ name, series, limits, floor }, x, marks, { low, high }) {
  const y = (value) => HEIGHT * (1 - (value - low) / (high - low));
  const size = { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none' };
  const picture = svg('svg', { ...size, role: 'img', 'aria-label': name });
  if (floor) picture.append(...floorOf(floor, x, y));
  for (const at of marks) picture.append(svg('line', { class: 'fault', x1: at, x2: at, y1: 0, y2: HEIGHT }));
  for (const limit of limits) if (limit >= low && limit <= high) picture.append(line('limit', y(limit)));
  series.forEach((values, i) => {
    const path = svg('path', { class: 'curve', d: curve(values, x, y) });
    path.style.stroke = series.length > 1 ? colorOf(i) : 'var(--text)';
    [, path.style.strokeDasharray] = styleOf(i);
    picture.append(path);
  });
  return picture;
}

// Labels nearer to each other than this share of the height would overlap.
const LABEL_SPACE = 0.15;

// The greatest and the least value and what is required, each written beside its height.
function scale({ floor, axis }, values, { low, high }) {
  const required = [...new Set(floor ?? [])].sort((a, b) => b - a);
  const heights = new Set([Math.max(...values), Math.min(...values), ...required]);
  const labels = [];
  for (const value of heights) {
    const top = (high - value) / (high - low);
    if (labels.some((label) => Math.abs(label.top - top) < LABEL_SPACE)) continue;
    labels.push({ top, text: axis.format(value) });
  }
  return labels.map(({ top, text }) => {
    const label = html('span', 'scale', text);
    label.style.top = `${(100 * top).toFixed(1)}%`;
    return label;
  });
}

// The horizontal axis.
function ground(length) {
  const { unit, format } = lengthAxis(length);
  const box = html('div', 'ground');
  for (const text of ['0', `distance along the path, ${unit}`, format(length)]) box.append(html('span', '', text));
  return box;
}

function chart(plot, x, marks, length, pick) {
  const box = html('figure', 'plot');
  const values = plot.series.flat().filter(Number.isFinite);
  box.append(html('figcaption', '', `${plot.name}, ${plot.axis.unit}`));
  if (values.length === 0) {
    box.append(html('p', 'more', 'none: the cables cannot balance the platform anywhere on this path'));
    return { box, cursor: null };
  }
  const range = rangeOf([...values, ...(plot.floor ?? [])], plot.limits);
  const area = html('div', 'area');
  const cursor = html('div', 'cursor');
  area.append(drawing(plot, x, marks, range), ...scale(plot, values, range), cursor);
  const follow = (event) => {
    const { left, width } = area.getBoundingClientRect();
    pick(Math.min(1, Math.max(0, (event.clientX - left) / width)));
  };
  area.addEventListener('pointerdown', (event) => {
    area.setPointerCapture(event.pointerId);
    follow(event);
  });
  area.addEventListener('pointermove', (event) => {
    if (event.buttons === 1) follow(event);
  });
  box.append(area, ground(length));
  return { box, cursor };
}

const largest = (values) => values.reduce((most, value) => (Number.isFinite(value) ? Math.max(most, Math.abs(value)) : most), 0);

function plotsOf({ lengths, clearance, required, tensions, tensionLimits, margins }) {
  const plots = [{ name: 'cable lengths', series: lengths, limits: [], axis: lengthAxis(largest(lengths.flat())) }];
  if (clearance.length > 0) {
    const axis = lengthAxis(largest([...clearance, ...required]));
    plots.push({ name: 'clearance (required: dashed)', series: [clearance], limits: [], floor: required, axis });
  }
  if (tensions.length > 0) {
    const limits = [...new Set(tensionLimits.flat())];
    plots.push({ name: 'cable tensions (limits: dashed)', series: tensions, limits, axis: forceAxis(largest(tensions.flat())) });
  }
  for (const { measure, unit, values } of margins) {
    const short = values.some((value) => value < 0);
    const floor = short ? values.map(() => 0) : null;
    const name = `${measure} margin beyond the demand`;
    plots.push({ name, series: [values], limits: [0], floor, axis: numberAxis(largest(values), unit) });
  }
  return plots;
}

function showMargins(margins, step) {
  byId('wrench').textContent = margins.map((margin) => describeWrench(margin, margin.values[step])).join('; ');
  byId('wrench').classList.toggle('bad', margins.some(({ values }) => !(values[step] >= 0)));
}

// The numbers of each cable at the cursor; the swatches are the key to the curves.
function cableTable(cables, columns) {
  const table = byId('cable-table');
  const head = html('tr', '');
  head.append(html('th', '', 'cable'), ...columns.map(({ name, axis }) => html('th', '', `${name}, ${axis.unit}`)));
  table.append(head);
  const rows = cables.map(({ name }, i) => {
    const row = html('tr', '');
    const title = html('td', 'cable-name');
    const swatch = html('span', 'swatch line');
    swatch.style.setProperty('--swatch', colorOf(i));
    [swatch.style.borderTopStyle] = styleOf(i);
    title.append(swatch, html('span', '', name));
    const cells = columns.map(() => html('td', 'number'));
    row.append(title, ...cells);
    table.append(row);
    return cells;
  });
  return (step) => {
    rows.forEach((cells, i) => {
      cells.forEach((cell, k) => {
        cell.textContent = columns[k].axis.format(columns[k].series[i][step]);
      });
    });
  };
}

// Indices of the steps on both sides of a distance, the nearer one first.
function stepsAt(s, distance) {
  let low = 0;
  let high = s.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (s[middle] <= distance) low = middle;
    else high = middle;
  }
  return distance - s[low] < s[high] - distance ? [low, high] : [high, low];
}

/**
 * Fills the side panel. `pick` hears the distance that the reader points at; the function returned shows a distance and
 * says who comes nearest there.
 */
export function createPlots(model, route, pick) {
  const { motion } = model;
  if (!motion) return () => null;
  byId('plots').hidden = false;
  const x = motion.s.map((s) => (WIDTH * s) / route.length);
  const marks = model.violations.map(({ segment, at }) => (WIDTH * route.distanceAt(segment, at)) / route.length);
  const plots = plotsOf(motion);
  const pickAt = (fraction) => pick(fraction * route.length);
  const charts = plots.map((plot) => chart(plot, x, marks, route.length, pickAt));
  byId('plot-list').replaceChildren(...charts.map(({ box }) => box));
  const columns = [{ ...plots[0], name: 'length' }];
  if (motion.tensions.length > 0) columns.push({ ...plots.find(({ series }) => series === motion.tensions), name: 'tension' });
  const showCables = cableTable(model.cables, columns);
  const cursors = charts.map(({ cursor }) => cursor).filter(Boolean);
  const tooNear = (step) => motion.clearance[step] < motion.required[step];

  return (distance) => {
    const [step, other] = stepsAt(motion.s, distance);
    for (const cursor of cursors) cursor.style.left = `${(100 * distance) / route.length}%`;
    showCables(step);
    showMargins(motion.margins, step);
    if (motion.clearance.length === 0) return null;
    // Where a collision begins between two steps, it is shown.
    const shown = !tooNear(step) && tooNear(other) ? other : step;
    const culprits = motion.pairs[motion.tightest[shown]];
    const tightest = { culprits, gap: motion.clearance[shown], required: motion.required[shown] };
    byId('nearest').textContent = describeTightest(tightest);
    byId('nearest').classList.toggle('bad', tooNear(shown));
    return { ...tightest, bad: tooNear(shown) };
  };
}

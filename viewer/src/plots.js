// The side panel: lengths, clearance and tensions along the path, or a trajectory over time.

import { cableSwatch, connectRow, createChart, html, largest, stepsAt, valueAt } from './charts.js';
import { createLimiting, tensionsName, trajectoryPlots } from './trajectory.js';
import { describeLeastRoom, describeWrench, forceAxis, formatApproach, lengthAxis, numberAxis, TOUCHING } from './wording.js';

const byId = (id) => document.getElementById(id);

const NO_TENSIONS = 'none: the cables cannot balance the platform anywhere on this path';

const CLEARANCES = { obstacles: 'clearance to obstacles', robot: 'clearance within the robot' };

// The gap of a group of pairs along the path, with what is required.
function clearancePlot({ of, gap, required }, s) {
  const axis = lengthAxis(largest([...gap, ...required]));
  const demanded = required.some((value) => value > 0);
  const short = gap.some((value, i) => value < required[i]);
  // Where a gap is only to be kept above zero, the axis says so itself.
  const floor = demanded || short ? required.map((value) => Math.max(0, value)) : null;
  const say = (value) => (Math.abs(value) < TOUCHING ? 'touching' : axis.format(value));
  return {
    name: CLEARANCES[of] ?? of,
    series: [{ at: s, values: gap }],
    limits: [],
    floor,
    axis,
    from: [0],
    reading: true,
    say,
    sayFully: formatApproach,
  };
}

function plotsOf({ s, lengths, approaches, tensions, tensionLimits, distribution, margins }) {
  const curves = (columns) => columns.map((values) => ({ at: s, values }));
  const lengthUnit = lengthAxis(largest(lengths.flat()));
  const plots = approaches.map((approach) => clearancePlot(approach, s));
  plots.push({ name: 'cable lengths', series: curves(lengths), limits: [], axis: lengthUnit, column: 'length' });
  if (tensions.length > 0) {
    const limits = [...new Set(tensionLimits.flat())];
    const axis = forceAxis(largest(tensions.flat()));
    const name = tensionsName(distribution);
    plots.push({ name, series: curves(tensions), limits, axis, column: 'tension', none: NO_TENSIONS });
  }
  for (const { measure, unit, values } of margins) {
    const short = values.some((value) => value < 0);
    const floor = short ? values.map(() => 0) : null;
    const name = `${measure} margin beyond the demand`;
    const axis = numberAxis(largest(values), unit);
    plots.push({ name, series: curves([values]), limits: [], from: [0], floor, axis, reading: true });
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
  head.append(html('th', '', 'cable'), ...columns.map(({ column, axis }) => html('th', '', `${column}, ${axis.unit}`)));
  table.replaceChildren(head);
  const rows = cables.map(({ name }, i) => {
    const row = html('tr', '');
    const title = html('td', 'cable-name');
    title.append(cableSwatch(i), html('span', '', name));
    connectRow(row, i);
    const cells = columns.map(() => html('td', 'number'));
    row.append(title, ...cells);
    table.append(row);
    return cells;
  });
  return (at) => {
    rows.forEach((cells, i) => {
      cells.forEach((cell, k) => {
        cell.textContent = columns[k].axis.format(valueAt(columns[k].series[i], at));
      });
    });
  };
}

const pointsOf = ({ points }, step) => {
  const six = points.slice(6 * step, 6 * step + 6);
  return six.length === 6 && six.every(Number.isFinite) ? [six.slice(0, 3), six.slice(3)] : null;
};

const mixed = (a, b, t) => a.map((end, k) => end.map((x, axis) => x + (b[k][axis] - x) * t));

// The gap of a group of pairs at a place: nearest points move along between two steps with the same pair.
function gapAt(approach, s, [step, other], at) {
  const { gap, required, tightest, pairs } = approach;
  const [here, there] = [pointsOf(approach, step), pointsOf(approach, other)];
  const same = step !== other && tightest[step] === tightest[other] && here && there;
  const ends = same ? mixed(here, there, (at - s[step]) / (s[other] - s[step])) : here;
  const value = same ? valueAt({ at: s, values: gap }, at) : gap[step];
  return { gap: value, required: required[step], culprits: pairs[tightest[step]], ends };
}

// Says who comes nearest at a place along the path, and the gap of each group of pairs.
function createNearest(motion) {
  const tooNear = (step) => motion.clearance[step] < motion.required[step];
  const isTightest = (approach, step) => approach.gap[step] - approach.required[step] <= motion.clearance[step] - motion.required[step];
  return (at) => {
    const [step, other] = stepsAt(motion.s, at);
    showMargins(motion.margins, step);
    if (motion.approaches.length === 0) return null;
    // Where a collision begins between two steps, it is shown.
    const shown = !tooNear(step) && tooNear(other) ? other : step;
    const bad = tooNear(shown);
    const steps = shown === step ? [step, other] : [other, other];
    const gaps = motion.approaches.map((approach) => {
      const tight = approach.of === 'obstacles' || isTightest(approach, shown);
      return { ...gapAt(approach, motion.s, steps, at), tight };
    });
    const tightest = gaps.find(({ culprits }) => culprits === motion.culprits[shown]);
    byId('nearest').textContent = describeLeastRoom(tightest);
    byId('nearest').classList.toggle('bad', bad);
    return { ...tightest, bad, gaps };
  };
}

const NO_CHARTS = { motion: null, trajectory: null };

const boxes = (charts) => charts.map(({ box }) => box);

/**
 * Fills the side panel. `pick` hears the distance or time that the reader points at; the function returned shows one
 * and says who comes nearest there.
 */
export function createPlots(model, route, pick) {
  // A path without length has no axis for charts.
  const { motion, trajectory } = route.length > 0 ? model : NO_CHARTS;
  byId('plots').hidden = !motion && !trajectory;
  if (!motion && !trajectory) return () => null;
  const { axis, length, corners } = route;
  const horizontal = { ...axis, length, corners, marks: model.violations.map(route.placeOf) };
  const chart = (plot) => createChart(plot, horizontal, pick);
  const alongPath = motion ? plotsOf(motion) : [];
  const overTime = trajectory ? trajectoryPlots(trajectory) : [];
  const charts = [...overTime, ...alongPath].map(chart);
  const above = trajectory ? overTime.length : charts.length;
  const strip = trajectory ? [createLimiting(trajectory, horizontal, pick)] : [];
  byId('plot-list').replaceChildren(...boxes(charts.slice(0, above)), ...boxes(strip));
  byId('more-plots').replaceChildren(...boxes(charts.slice(above)));
  const showCables = cableTable(model.cables, [...alongPath, ...overTime].filter(({ column }) => column));
  const showNearest = motion ? createNearest(motion) : () => null;
  if (trajectory) byId('plots-title').textContent = 'over time';
  byId('plots').classList.toggle('timed', Boolean(trajectory));

  return (at) => {
    for (const { show } of [...charts, ...strip]) show(at);
    showCables(at);
    return showNearest(at);
  };
}

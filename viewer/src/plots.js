// The side panel: lengths, clearance and tensions along the path, or a trajectory over time.

import { cableSwatch, createChart, html, largest, stepsAt, valueAt } from './charts.js';
import { createLimiting, trajectoryPlots } from './trajectory.js';
import { describeTightest, describeWrench, forceAxis, lengthAxis, numberAxis } from './wording.js';

const byId = (id) => document.getElementById(id);

const NO_TENSIONS = 'none: the cables cannot balance the platform anywhere on this path';

function plotsOf({ s, lengths, clearance, required, tensions, tensionLimits, margins }) {
  const curves = (columns) => columns.map((values) => ({ at: s, values }));
  const lengthUnit = lengthAxis(largest(lengths.flat()));
  const plots = [{ name: 'cable lengths', series: curves(lengths), limits: [], axis: lengthUnit, column: 'length' }];
  if (clearance.length > 0) {
    const axis = lengthAxis(largest([...clearance, ...required]));
    plots.push({ name: 'clearance (required: dashed)', series: curves([clearance]), limits: [], floor: required, axis });
  }
  if (tensions.length > 0) {
    const limits = [...new Set(tensionLimits.flat())];
    const axis = forceAxis(largest(tensions.flat()));
    const name = 'cable tensions (limits: dashed)';
    plots.push({ name, series: curves(tensions), limits, axis, column: 'tension', none: NO_TENSIONS });
  }
  for (const { measure, unit, values } of margins) {
    const short = values.some((value) => value < 0);
    const floor = short ? values.map(() => 0) : null;
    const name = `${measure} margin beyond the demand`;
    plots.push({ name, series: curves([values]), limits: [0], floor, axis: numberAxis(largest(values), unit) });
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

// Says who comes nearest at a place along the path.
function createNearest(motion) {
  const tooNear = (step) => motion.clearance[step] < motion.required[step];
  return (at) => {
    const [step, other] = stepsAt(motion.s, at);
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

const boxes = (charts) => charts.map(({ box }) => box);

/**
 * Fills the side panel. `pick` hears the distance or time that the reader points at; the function returned shows one
 * and says who comes nearest there.
 */
export function createPlots(model, route, pick) {
  const { motion, trajectory } = model;
  byId('plots').hidden = !motion && !trajectory;
  if (!motion && !trajectory) return () => null;
  const horizontal = { ...route.axis, length: route.length, marks: model.violations.map(route.placeOf) };
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

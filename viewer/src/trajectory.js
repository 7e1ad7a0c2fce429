// A timed trajectory: where the platform is at each instant, the curves over time, and what limits them when.

import { cableSwatch, colorOf, createArea, ground, html, largest } from './charts.js';
import { accelerationAxis, describeCorner, describeCorners, describeLimit, describeOtherLimits, describePiece } from './wording.js';
import { forceAxis, formatShare, formatTimeProgress, speedAxis, timeAxis, turnSpeedAxis, roundTicks } from './wording.js';
import { slerp } from './route.js';

// Limits of a trajectory are drawn even where the curves stay well away from them.
const FAR = 3;
const LISTED_CABLES = 4;

const mix = (a, b, t) => [0, 1, 2].map((i) => a[i] + (b[i] - a[i]) * t);

// Index of the sample at or before a time, other than the last.
function sampleAt(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return low;
}

/** The positions of a trajectory as a function of time, s, and the orientations of a platform that turns. */
export function createTimedRoute({ times, positions, orientations, duration, corners }) {
  function between(time) {
    const i = sampleAt(times, time);
    const share = (time - times[i]) / (times[i + 1] - times[i]);
    return [i, Math.min(1, Math.max(0, share))];
  }

  function positionAt(time) {
    const [i, share] = between(time);
    return mix(positions[i], positions[i + 1], share);
  }

  // Null if the platform keeps its orientation.
  function orientationAt(time) {
    if (!orientations) return null;
    const [i, share] = between(time);
    return slerp(orientations[i], orientations[i + 1], share);
  }

  return {
    timed: true,
    length: duration,
    corners: corners.map(({ time }) => time),
    axis: { title: 'time', unit: timeAxis.unit, ticks: roundTicks(duration), whole: duration },
    positionAt,
    orientationAt,
    placeOf: ({ time }) => time,
    describe: (time) => formatTimeProgress(time, duration),
  };
}

const valuesOf = (curves) => curves.flatMap(({ values }) => values);

const given = (limits) => [...new Set(limits)].filter(Number.isFinite);

/** The name of the plot of tensions: with their choice, unless it is the usual one. */
export const tensionsName = (distribution) => (distribution ? `cable tensions (${distribution})` : 'cable tensions');

/** The curves of a trajectory over time, with their limits. */
export function trajectoryPlots(trajectory) {
  const { limits, tensionLimits, distribution, speed, acceleration, turnSpeed, cableSpeeds, tensions } = trajectory;
  const plot = (name, series, axisFor, bounds, more) => {
    const axis = axisFor(largest(valuesOf(series)));
    return { name, series, axis, limits: given(bounds), labelled: true, far: FAR, ...more };
  };
  const positive = { from: [0], reading: true };
  const both = limits.cableSpeed === null ? [] : [limits.cableSpeed, -limits.cableSpeed];
  const plots = [
    plot('speed', [speed], speedAxis, [limits.speed], positive),
    plot('acceleration', [acceleration], accelerationAxis, [limits.acceleration], positive),
    ...(turnSpeed ? [plot('angular speed', [turnSpeed], turnSpeedAxis, [limits.turnSpeed], positive)] : []),
    plot('cable speeds', cableSpeeds, speedAxis, both, { column: 'speed' }),
  ];
  if (tensions.length === 0) return plots;
  return [...plots, plot(tensionsName(distribution), tensions, forceAxis, tensionLimits.flat(), { column: 'tension' })];
}

// A piece of the strip: the colour of the limit, with the colour of its cable below.
function pieceOf(entry, cables, length) {
  const piece = html('div', `piece of-limit-${entry.kind}`);
  piece.style.left = `${(100 * entry.from) / length}%`;
  piece.style.width = `${(100 * (entry.to - entry.from)) / length}%`;
  piece.title = describePiece(entry);
  const cable = cables.indexOf(entry.cable);
  if (cable < 0) return piece;
  const mark = html('div', 'piece-cable');
  mark.style.background = colorOf(cable);
  piece.append(mark);
  return piece;
}

function cornerMark(corner, length) {
  const mark = html('div', 'corner');
  mark.style.left = `${(100 * corner.time) / length}%`;
  mark.title = describeCorner(corner);
  return mark;
}

// Each limit that binds, with its share of the time and its cables.
function keyOf(limiting, cables, duration) {
  const kinds = new Map();
  for (const entry of limiting) {
    const found = kinds.get(entry.kind) ?? { name: describeLimit({ ...entry, cable: null }), time: 0, cables: new Set() };
    found.time += entry.to - entry.from;
    if (cables.includes(entry.cable)) found.cables.add(entry.cable);
    kinds.set(entry.kind, found);
  }
  return [...kinds].map(([kind, { name, time, cables: its }]) => {
    const item = html('li', '');
    item.append(html('span', `swatch solid of-limit-${kind}`), html('span', '', `${name} ${formatShare(time / duration)}`));
    const listed = cables.filter((cable) => its.has(cable)).slice(0, LISTED_CABLES);
    for (const cable of listed) {
      const one = html('span', 'key-cable');
      one.append(cableSwatch(cables.indexOf(cable)), html('span', '', cable));
      item.append(one);
    }
    if (its.size > listed.length) item.append(html('span', 'more', `and ${its.size - listed.length} more`));
    return item;
  });
}

const entryAt = (limiting, time) =>
  limiting.find(({ from, to }) => time >= from && time < to) ?? limiting.find(({ to }) => time === to);

/** The strip that shows what limits the motion when; `show` moves its cursor and says what limits it then. */
export function createLimiting({ limiting, corners, cables, duration, limits }, horizontal, pick) {
  const box = html('figure', 'plot limiting');
  const caption = html('figcaption', '', 'what limits the motion');
  const reading = html('output', 'reading');
  caption.append(reading);
  const { area, cursor, show } = createArea('strip', duration, pick);
  area.setAttribute('role', 'img');
  area.setAttribute('aria-label', limiting.map(describePiece).join('; ') || 'nothing');
  const pieces = limiting.map((entry) => pieceOf(entry, cables, duration));
  area.append(...pieces, ...corners.map((corner) => cornerMark(corner, duration)), cursor);
  const key = html('ul', 'key');
  if (limiting.length > 0) key.append(html('li', 'more', 'share of the time:'));
  key.append(...keyOf(limiting, cables, duration));
  const notes = [describeCorners(corners), describeOtherLimits(limits)].filter(Boolean);
  box.append(caption, area, ground(horizontal), key, ...notes.map((note) => html('p', 'more', note)));
  return {
    box,
    show: (time) => {
      show(time);
      const entry = entryAt(limiting, time);
      reading.textContent = entry ? describeLimit(entry) : 'nothing';
    },
  };
}

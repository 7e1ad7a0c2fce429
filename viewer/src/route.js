// A path as a curve over its length; where the platform turns, its length counts the turns.

import { formatProgress, lengthAxis, roundTicks } from './wording.js';

const distanceBetween = (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);

const mix = (a, b, t) => [0, 1, 2].map((i) => a[i] + (b[i] - a[i]) * t);

// Quaternions of neighbouring waypoints have the signs between which the platform turns the shorter way.
const halfAngleBetween = (a, b) => Math.acos(Math.min(1, Math.max(-1, a.reduce((sum, x, i) => sum + x * b[i], 0))));

/** The orientation a share of the way from one to another. */
export function slerp(a, b, t) {
  const half = halfAngleBetween(a, b);
  if (half < 1e-6) return a;
  const [u, v] = [Math.sin((1 - t) * half) / Math.sin(half), Math.sin(t * half) / Math.sin(half)];
  return a.map((x, i) => u * x + v * b[i]);
}

function lengthsAlong(waypoints, turns) {
  const lengths = [0];
  for (let i = 1; i < waypoints.length; i += 1) {
    const turn = turns ? 2 * turns.weight * halfAngleBetween(turns.orientations[i - 1], turns.orientations[i]) : 0;
    lengths.push(lengths[i - 1] + distanceBetween(waypoints[i - 1], waypoints[i]) + turn);
  }
  return lengths;
}

// Largest turn between two poses of a drawing, rad.
const DRAWN_TURN = 0.06;

/** The poses of a path, so close to each other that straight lines between them show its turns. */
export function posesOf({ waypoints, turns }, orientation) {
  if (!turns) return waypoints.map((position) => ({ position, orientation }));
  const { orientations } = turns;
  const between = waypoints.slice(1).flatMap((to, i) => {
    const steps = Math.ceil((2 * halfAngleBetween(orientations[i], orientations[i + 1])) / DRAWN_TURN) || 1;
    return Array.from({ length: steps }, (_, k) => {
      const t = (k + 1) / steps;
      return { position: mix(waypoints[i], to, t), orientation: slerp(orientations[i], orientations[i + 1], t) };
    });
  });
  return [{ position: waypoints[0], orientation: orientations[0] }, ...between];
}

// Index of the segment that holds a distance.
function segmentAt(lengths, distance) {
  let low = 0;
  let high = lengths.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (lengths[middle] <= distance) low = middle;
    else high = middle;
  }
  return low;
}

// The horizontal axis of charts, with ticks at round numbers of its unit.
function createAxis(length, title) {
  const { unit, inUnit } = lengthAxis(length);
  return { title, unit, ticks: length > 0 ? roundTicks(inUnit(length)) : [], whole: inUnit(length) };
}

/**
 * The polyline of at least one waypoint as a function of the distance travelled; `turns` has the orientation at each
 * waypoint and the weight of turns, m/rad, or is null if the platform keeps its orientation.
 */
export function createRoute(waypoints, turns = null) {
  const lengths = lengthsAlong(waypoints, turns);
  const last = waypoints.length - 1;
  const length = lengths[last];

  function positionAt(distance) {
    if (distance <= 0 || last === 0) return waypoints[0];
    if (distance >= length) return waypoints[last];
    const i = segmentAt(lengths, distance);
    return mix(waypoints[i], waypoints[i + 1], (distance - lengths[i]) / (lengths[i + 1] - lengths[i]));
  }

  // Null if the platform keeps its orientation.
  function orientationAt(distance) {
    if (!turns) return null;
    if (distance <= 0 || last === 0) return turns.orientations[0];
    if (distance >= length) return turns.orientations[last];
    const i = segmentAt(lengths, distance);
    const t = (distance - lengths[i]) / (lengths[i + 1] - lengths[i]);
    return slerp(turns.orientations[i], turns.orientations[i + 1], t);
  }

  function placeOf({ segment, at }) {
    if (segment >= last) return length;
    return lengths[segment] + (lengths[segment + 1] - lengths[segment]) * at;
  }

  return {
    timed: false,
    length,
    axis: createAxis(length, turns ? 'distance and turns' : 'distance'),
    // The waypoints between both ends.
    corners: lengths.slice(1, -1),
    positionAt,
    orientationAt,
    placeOf,
    describe: (distance) => formatProgress(distance, length),
  };
}

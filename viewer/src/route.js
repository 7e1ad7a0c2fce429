// A path as a curve over its length.

import { formatProgress, lengthAxis } from './wording.js';

const distanceBetween = (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);

const mix = (a, b, t) => [0, 1, 2].map((i) => a[i] + (b[i] - a[i]) * t);

function lengthsAlong(waypoints) {
  const lengths = [0];
  for (let i = 1; i < waypoints.length; i += 1) {
    lengths.push(lengths[i - 1] + distanceBetween(waypoints[i - 1], waypoints[i]));
  }
  return lengths;
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

/** The polyline of at least one waypoint as a function of the distance travelled. */
export function createRoute(waypoints) {
  const lengths = lengthsAlong(waypoints);
  const last = waypoints.length - 1;
  const length = lengths[last];

  function positionAt(distance) {
    if (distance <= 0 || last === 0) return waypoints[0];
    if (distance >= length) return waypoints[last];
    const i = segmentAt(lengths, distance);
    return mix(waypoints[i], waypoints[i + 1], (distance - lengths[i]) / (lengths[i + 1] - lengths[i]));
  }

  function placeOf({ segment, at }) {
    if (segment >= last) return length;
    return lengths[segment] + (lengths[segment + 1] - lengths[segment]) * at;
  }

  return {
    timed: false,
    length,
    axis: { title: 'distance along the path', ...lengthAxis(length) },
    positionAt,
    placeOf,
    describe: (distance) => formatProgress(distance, length),
  };
}

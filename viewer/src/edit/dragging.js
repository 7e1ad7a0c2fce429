// Where a thing goes while the pointer drags it: in the floor plane, vertically, or along an axis.

import { Plane, Vector3 } from 'three';
import { axisVector } from './markers.js';

// Flatter views than this drag along the picture instead of the floor.
const FLATTEST = 0.12;
const UP = new Vector3(0, 0, 1);
const SNAP = 0.01;

// The place on a line through a point that is nearest to a ray, or null if they are parallel.
function nearestOnLine(origin, direction, { ray }) {
  const across = origin.clone().sub(ray.origin);
  const cosine = direction.dot(ray.direction);
  const sine = 1 - cosine * cosine;
  if (sine < 1e-4) return null;
  return (cosine * across.dot(ray.direction) - across.dot(direction)) / sine;
}

// How far the pointer has moved in a horizontal plane through the grabbed place.
function floorShift(grabbed, { ray }, camera) {
  const view = camera.getWorldDirection(new Vector3());
  const flat = Math.abs(ray.direction.z) < FLATTEST;
  const normal = flat ? view.setZ(0).normalize() : UP;
  const hit = ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(normal, grabbed), new Vector3());
  return hit ? hit.sub(grabbed).setZ(0) : null;
}

function alongShift(direction, grabbed, ray) {
  const along = nearestOnLine(grabbed, direction, ray);
  return along === null ? null : direction.clone().multiplyScalar(along);
}

const shiftOf = (mode, grabbed, ray, camera) =>
  mode === 'floor' ? floorShift(grabbed, ray, camera) : alongShift(axisVector(mode), grabbed, ray);

/** A coordinate on the grid of 1 cm. */
export const snapped = (x) => Math.round(Math.round(x / SNAP) * SNAP * 1e9) / 1e9;

/**
 * A drag of a thing from a place (m), grabbed at a point of the drawing frame. `axis` is that of the arrow that is
 * dragged, or null.
 */
export function createDrag({ from, grabbed, axis, frame, limits }) {
  let mode = null;
  let base = from;
  let grip = grabbed.clone();
  let exact = from;

  const modeFor = (vertical) => axis ?? (vertical ? 2 : 'floor');

  // Goes on from here in another direction.
  function turn(next) {
    grip.add(frame.vector(exact.map((x, i) => x - base[i])));
    base = exact;
    mode = next;
  }

  /** Where the thing is when the pointer is on a ray; `free` without the grid. */
  function to(ray, camera, { vertical, free }) {
    const next = modeFor(vertical);
    if (next !== mode) turn(next);
    const shift = shiftOf(mode, grip, ray, camera);
    if (!shift) return exact;
    const by = shift.toArray().map((x) => x / frame.scale);
    exact = base.map((x, i) => Math.min(limits.max[i], Math.max(limits.min[i], x + by[i])));
    const moved = (i) => (mode === 'floor' ? i < 2 : i === mode);
    return exact.map((x, i) => (moved(i) && !free ? snapped(x) : x));
  }

  return { from, to };
}

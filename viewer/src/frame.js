// The drawing frame: scene coordinates (m) shifted to the centre of the scene and scaled to a size of about one,
// so that millimetres and kilometres are drawn with the same precision, camera and marker sizes.

import { Box3, Vector3 } from 'three';

function boundsOf(points) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const p of points) {
    for (let i = 0; i < 3; i += 1) {
      min[i] = Math.min(min[i], p[i]);
      max[i] = Math.max(max[i], p[i]);
    }
  }
  return min[0] <= max[0] ? { min, max } : null;
}

function* fixedPoints(model) {
  if (model.workspace) yield* [model.workspace.min, model.workspace.max];
  for (const cable of model.cables) yield cable.outlet;
  for (const obstacle of model.obstacles) {
    for (const part of obstacle.parts) yield* part.vertices;
  }
  yield* [model.start, model.goal].filter(Boolean);
  if (model.path) yield* model.path.waypoints;
  if (model.path) yield* model.path.rawWaypoints;
}

function* platformPoints(model) {
  for (const part of model.platform) yield* part.vertices;
}

function usefulBounds(model) {
  const isWide = (box) => box && box.max.some((high, i) => high > box.min[i]);
  const fixed = boundsOf(fixedPoints(model));
  if (isWide(fixed)) return fixed;
  const [x, y, z] = fixed ? fixed.min : [0, 0, 0];
  const around = [...platformPoints(model)].map((p) => [p[0] + x, p[1] + y, p[2] + z]);
  const platform = boundsOf(around);
  return isWide(platform) ? platform : { min: [x - 1, y - 1, z - 1], max: [x + 1, y + 1, z + 1] };
}

function fit({ min, max }) {
  const centre = min.map((low, i) => low + (max[i] - low) / 2);
  const half = min.map((low, i) => (max[i] - low) / 2);
  return { centre, scale: 1 / Math.hypot(...half) };
}

/** The drawing frame of a model; that of a changed one has the same origin and scale as before, so that nothing jumps. */
export function createFrame(model, before = null) {
  const bounds = usefulBounds(model);
  const { centre, scale } = before ?? fit(bounds);
  const point = (p, target = new Vector3()) =>
    target.set((p[0] - centre[0]) * scale, (p[1] - centre[1]) * scale, (p[2] - centre[2]) * scale);
  return {
    centre,
    scale,
    /** A point of the scene in the drawing frame. */
    point,
    /** A vector of the scene in the drawing frame. */
    vector: (v, target = new Vector3()) => target.set(v[0], v[1], v[2]).multiplyScalar(scale),
    /** What the camera should show. */
    box: new Box3(point(bounds.min), point(bounds.max)),
  };
}

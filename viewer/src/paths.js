// Search tree, raw path, final path and the violations along it.

import { LineBasicMaterial, Vector3 } from 'three';
import { chain, crosses, dots, hairlines, wideLines } from './marks.js';

/** The edges of the planner's tree, however many, as one object. */
export function createSearchTree(path, frame, theme) {
  if (!path?.tree) return [];
  const { ends } = path.tree;
  const places = Array.from({ length: ends.length / 3 }, (_, i) => frame.point(ends.slice(3 * i, 3 * i + 3), new Vector3()));
  const lines = hairlines(places, new LineBasicMaterial({ transparent: true, opacity: 0.75, depthWrite: false }));
  theme.paint(lines.material, 'tree');
  // After the obstacles, which would otherwise paint over it.
  lines.renderOrder = 4;
  return [lines];
}

const SAME_PLACE = 1e-6;

function distanceToSegment(p, a, b) {
  const along = b.map((x, i) => x - a[i]);
  const square = along.reduce((sum, x) => sum + x * x, 0);
  const t = square > 0 ? Math.min(1, Math.max(0, along.reduce((sum, x, i) => sum + x * (p[i] - a[i]), 0) / square)) : 0;
  return Math.hypot(...p.map((x, i) => x - a[i] - t * along[i]));
}

// Whether each corner of a path lies on another one.
function liesOn(points, other, tolerance) {
  const near = (p) => other.slice(1).some((b, i) => distanceToSegment(p, other[i], b) <= tolerance);
  return points.every(near);
}

// Whether two paths lead the same way, even if one of them has more waypoints on it.
function sameWay(a, b) {
  const size = Math.max(...a.flatMap((p) => p.map((x, i) => Math.abs(x - a[0][i]))));
  return b.length > 1 && liesOn(a, b, SAME_PLACE * size) && liesOn(b, a, SAME_PLACE * size);
}

/** The path as the planner found it, if that is another one: thin and dashed, below the final one. */
export function createRawPath(path, frame, theme) {
  if (!path || path.rawWaypoints.length < 2 || sameWay(path.rawWaypoints, path.waypoints)) return [];
  const points = path.rawWaypoints.map((p) => frame.point(p));
  const behind = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 24 };
  const line = wideLines(chain(points), { linewidth: 2, dashed: true, dashSize: 0.025, gapSize: 0.018, ...behind });
  theme.paint(line.material, 'rawPath');
  return [line];
}

const DOT = 10;
// Little wider than the path.
const SMALL_DOT = 6.5;
// Large dots nearer to each other than this share of the picture would be one lump.
const APART = 0.025;

// Which of the places get a large dot: the ends, and those between that are apart.
function apart(places, size) {
  const [end] = places.slice(-1);
  let last = places[0];
  return places.map((place, i) => {
    if (i === 0 || i === places.length - 1) return true;
    const free = Math.min(place.distanceTo(last), place.distanceTo(end)) >= APART * size;
    if (free) last = place;
    return free;
  });
}

/** The path after post-processing: thick, with a dot at each waypoint, or at the places in `marked`; small ones in a crowd. */
export function createFinalPath(path, frame, theme, marked = path?.waypoints) {
  if (!path || path.waypoints.length === 0) return [];
  const points = path.waypoints.map((p) => frame.point(p));
  const line = wideLines(chain(points), { linewidth: 5, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 8 });
  const places = marked.map((p) => frame.point(p));
  const isLarge = apart(places, frame.box.getSize(new Vector3()).length());
  const marks = dots(places.filter((_, i) => isLarge[i]), DOT);
  const crowd = isLarge.every(Boolean) ? [] : [dots(places.filter((_, i) => !isLarge[i]), SMALL_DOT)];
  theme.paint(line.material, 'finalPath');
  for (const { material } of [marks, ...crowd]) theme.paint(material, 'waypoint');
  return [line, marks, ...crowd];
}

// Pieces of the path where something comes too near or a wrench margin is missing.
function badPieces({ clearance, required, margins, s }, route, frame) {
  const isBad = (i) => clearance[i] < required[i] || margins.some(({ values }) => values[i] < 0);
  const places = s.map((distance) => frame.point(route.positionAt(distance)));
  return s.slice(1).flatMap((_, i) => (isBad(i) && isBad(i + 1) ? [places[i], places[i + 1]] : []));
}

/** A cross with a white rim where each violation begins, and what of the path is not valid. */
export function createViolations({ violations, motion }, route, frame, theme) {
  if (violations.length === 0) return [];
  const pieces = wideLines(motion ? badPieces(motion, route, frame) : [], { linewidth: 6 });
  theme.paint(pieces.material, 'violation');
  const points = violations.map((v) => frame.point(route.positionAt(route.placeOf(v))));
  const rim = crosses(points, 22, 0.7, 10);
  const core = crosses(points, 22, 0.4, 11);
  theme.paint(core.material, 'violation');
  return [pieces, rim, core];
}

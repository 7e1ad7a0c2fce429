// Raw path, final path and the violations along it.

import { chain, crosses, dots, wideLines } from './marks.js';

/** The path as the planner found it: thin and dashed. */
export function createRawPath(path, frame, theme) {
  if (!path || path.rawWaypoints.length < 2) return [];
  const points = path.rawWaypoints.map((p) => frame.point(p));
  const line = wideLines(chain(points), { linewidth: 2, dashed: true, dashSize: 0.025, gapSize: 0.018 });
  theme.paint(line.material, 'rawPath');
  return [line];
}

/** The path after post-processing: thick, with a dot at each waypoint. */
export function createFinalPath(path, frame, theme) {
  if (!path || path.waypoints.length === 0) return [];
  const points = path.waypoints.map((p) => frame.point(p));
  const line = wideLines(chain(points), { linewidth: 5, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 8 });
  const marks = dots(points, 10);
  theme.paint(line.material, 'finalPath');
  theme.paint(marks.material, 'waypoint');
  return [line, marks];
}

/** A cross with a white rim where each violation begins. */
export function createViolations(violations, route, frame, theme) {
  if (violations.length === 0) return [];
  const points = violations.map((v) => frame.point(route.positionAt(route.distanceAt(v.segment, v.at))));
  const rim = crosses(points, 22, 0.7, 10);
  const core = crosses(points, 22, 0.4, 11);
  theme.paint(core.material, 'violation');
  return [rim, core];
}

// What stands still around the robot: workspace and obstacles.

import { Box3, DoubleSide, Group, LineBasicMaterial, Mesh, MeshBasicMaterial } from 'three';
import { MeshLambertMaterial, PlaneGeometry, Vector3 } from 'three';
import { dots, hairlines, pointGeometry, wideGeometry, wideLines } from './marks.js';
import { buildShapes, mergeShapes, solidGeometry } from './shapes.js';

const OBSTACLE_OPACITY = 0.78;
// Neighbours differ in lightness.
const SHADES = [1, 0.8, 0.92, 0.7];

// Corners of a box in the order of three bits x, y, z.
function boxCorners({ min, max }) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z),
  );
}

/** The twelve edges of a box as pairs of points. */
export function boxEdges(box) {
  const corners = boxCorners(box);
  const edges = [];
  corners.forEach((corner, i) => {
    for (const bit of [1, 2, 4]) if (!(i & bit)) edges.push(corner, corners[i | bit]);
  });
  return edges;
}

function floorOf(box, theme) {
  const size = box.getSize(new Vector3());
  const material = new MeshBasicMaterial({ transparent: true, opacity: 0.14, side: 2, depthWrite: false });
  const floor = new Mesh(new PlaneGeometry(size.x, size.y), theme.paint(material, 'floor'));
  box.getCenter(floor.position).setZ(box.min.z);
  floor.renderOrder = -1;
  return floor;
}

/** The workspace box with its floor. */
export function createWorkspace(model, frame, theme) {
  if (!model.workspace) return [];
  const box = new Box3(frame.point(model.workspace.min), frame.point(model.workspace.max));
  const edges = hairlines(boxEdges(box));
  theme.paint(edges.material, 'workspace');
  return [edges, floorOf(box, theme)];
}

function obstacleMaterial(theme, options) {
  const material = new MeshLambertMaterial({
    transparent: true,
    opacity: OBSTACLE_OPACITY,
    vertexColors: true,
    // Seen from inside where the section plane cuts it.
    side: DoubleSide,
    forceSinglePass: true,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    ...options,
  });
  return theme.paint(material, 'obstacle');
}

// Drawn twice, depth first, so that only the nearest surface shows and looks the same from every side.
function translucentSolid(theme) {
  const depth = new Mesh(undefined, obstacleMaterial(theme, { colorWrite: false }));
  const color = new Mesh(undefined, obstacleMaterial(theme, { depthWrite: false }));
  depth.renderOrder = 1;
  color.renderOrder = 2;
  return [depth, color];
}

function replaceGeometry(geometry, ...objects) {
  objects[0].geometry.dispose();
  for (const object of objects) object.geometry = geometry;
}

/**
 * All obstacles as a handful of merged objects, however many; `show` draws those whose index is not in a set, `move`
 * shifts one from where it was drawn.
 */
export function createObstacles(model, frame, theme) {
  const all = model.obstacles.map(({ parts }, i) => ({ ...buildShapes(parts, (v) => frame.point(v)), shade: SHADES[i % SHADES.length] }));
  const [depth, color] = translucentSolid(theme);
  const edges = hairlines([], new LineBasicMaterial({ transparent: true }));
  const bars = wideLines([], { linewidth: 3 });
  const marks = dots([], 8);
  edges.renderOrder = 3;
  theme.paint(edges.material, 'obstacleEdge');
  theme.paint(bars.material, 'obstacle');
  theme.paint(marks.material, 'obstacle');

  function show(hidden) {
    const shapes = mergeShapes(all.filter((_, i) => !hidden.has(i)));
    replaceGeometry(solidGeometry(shapes), depth, color);
    replaceGeometry(pointGeometry(shapes.edges), edges);
    replaceGeometry(wideGeometry(shapes.segments), bars);
    replaceGeometry(pointGeometry(shapes.dots), marks);
    bars.visible = shapes.segments.length > 0;
    marks.visible = shapes.dots.length > 0;
  }

  const merged = [depth, color, edges, bars, marks];
  const apart = new Group();
  const lifted = new Map();
  let hiddenNow = new Set();

  // The objects of one obstacle, which moves by itself.
  function lift(index) {
    const shapes = all[index];
    const solid = solidGeometry(mergeShapes([shapes]));
    const group = new Group();
    const pieces = [solid, solid, pointGeometry(shapes.edges), wideGeometry(shapes.segments), pointGeometry(shapes.dots)];
    merged.forEach((object, i) => {
      const piece = object.clone();
      piece.geometry = pieces[i];
      piece.visible = i < 3 || [shapes.segments, shapes.dots][i - 3].length > 0;
      group.add(piece);
    });
    lifted.set(index, group);
    apart.add(group);
    showAll(hiddenNow);
  }

  function showAll(hidden) {
    hiddenNow = hidden;
    show(new Set([...hidden, ...lifted.keys()]));
    for (const [index, group] of lifted) group.visible = !hidden.has(index);
  }

  function move(index, by) {
    if (!lifted.has(index)) lift(index);
    lifted.get(index).position.copy(by);
  }

  show(new Set());
  return { objects: all.length > 0 ? [...merged, apart] : [], show: showAll, move };
}

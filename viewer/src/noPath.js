// Why there is no path: what can be reached, the wall around it, who closes the way, and paths without an obstacle.

import { Group, LineBasicMaterial, Mesh, MeshLambertMaterial } from 'three';
import { layCable } from './cables.js';
import { gridOf, surface } from './cubes.js';
import { chain, hairlines, moveWideLines, wideLines } from './marks.js';
import { createFinalPath } from './paths.js';
import { createGhost } from './robot.js';
import { buildShapes, solidGeometry } from './shapes.js';
import { wallRole } from './theme.js';
import { describeCulprits, formatLength } from './wording.js';

// The wall after what can be reached, which shines through it.
const REACHABLE = { opacity: 0.24, edges: 0.5, order: 4, solid: false };
const WALL = { opacity: 0.66, edges: 0.9, order: 6, solid: true };
const CULPRIT_WIDTH = 3.5;
const CABLE_WIDTH = 3;

const grouped = (objects, name) => {
  const group = new Group();
  group.name = name;
  if (objects.length > 0) group.add(...objects);
  return group;
};

// A cable of the platform at a place; `hang` draws it as it hangs or straight.
function createString(cable, frame, { position, quaternion }) {
  const laid = layCable(cable, frame);
  laid.end.copy(laid.arm).applyQuaternion(quaternion).add(position);
  const pairs = chain(laid.points);
  laid.lay(true);
  const line = wideLines(pairs, { linewidth: CABLE_WIDTH });
  const hang = (wanted) => {
    laid.lay(wanted);
    moveWideLines(line, pairs);
  };
  return { line, hang };
}

// Where the platform gets nearest to the goal, the cables that keep it there, and how far it is.
function nearestReachable(model, frame, shapes, theme) {
  const { nearest, culprits } = model.noPath;
  const ghost = createGhost(shapes, model.orientation, theme, 'reachableEdge');
  frame.point(nearest, ghost.position);
  const gap = [ghost.position.clone(), frame.point(model.goal ?? nearest)];
  const line = wideLines(gap, { linewidth: 2.5, dashed: true, dashSize: 0.025, gapSize: 0.018 });
  theme.paint(line.material, 'text');
  const strings = model.cables.flatMap((cable) => {
    const index = culprits.findIndex((names) => names.includes(cable.name));
    if (index < 0) return [];
    const string = createString(cable, frame, ghost);
    theme.paint(string.line.material, wallRole(index));
    return [string];
  });
  const hang = (wanted) => strings.forEach((string) => string.hang(wanted));
  const objects = [ghost, line, ...strings.map((string) => string.line)];
  return { objects, hang, place: ghost.position, middle: gap[0].clone().lerp(gap[1], 0.5) };
}

// An obstacle that closes the way: outlined in the colour of its wall; faded while it is left out.
function culprit(obstacle, role, frame, theme) {
  const shapes = buildShapes(obstacle.parts, (v) => frame.point(v));
  const outline = wideLines([...shapes.edges, ...shapes.segments], { linewidth: CULPRIT_WIDTH });
  theme.paint(outline.material, role);
  const material = new MeshLambertMaterial({ transparent: true, opacity: 0.12, depthWrite: false });
  const fill = new Mesh(solidGeometry(shapes), theme.paint(material, 'obstacle'));
  const edges = hairlines(shapes.edges, new LineBasicMaterial({ transparent: true, opacity: 0.6 }));
  theme.paint(edges.material, 'obstacleEdge');
  // After the obstacles, which would otherwise paint over it.
  fill.renderOrder = 4;
  return { outline, faded: grouped([fill, edges], obstacle.name) };
}

// A group for each wall, and within it one that is hidden while an obstacle of the wall is left out.
function createWalls(noPath, tools) {
  return noPath.culprits.map((names, i) => {
    const role = wallRole(i);
    const inner = grouped(surface(noPath.walls[i], role, WALL, tools), 'faces');
    return { names, role, inner, group: grouped([inner], describeCulprits(names)) };
  });
}

// The obstacles that close the way, by name.
function createCulprits({ noPath, obstacles }, frame, theme) {
  const wallOf = (name) => Math.max(0, noPath.culprits.findIndex((names) => names.includes(name)));
  const blocking = obstacles.filter(({ name }) => noPath.blocking.includes(name));
  return new Map(blocking.map((own) => [own.name, culprit(own, wallRole(wallOf(own.name)), frame, theme)]));
}

// The paths without an obstacle, by its name.
function createDetours({ without }, frame, theme) {
  const path = (detour) => grouped(createFinalPath(detour, frame, theme), detour.obstacle);
  return new Map(without.map((detour) => [detour.obstacle, path(detour)]));
}

/**
 * What is drawn of a proof: objects for layers, a group for each wall, labels, `hang`, which draws cables as they hang or
 * straight, and `leaveOut`, which shows the path without an obstacle; null shows the proof again.
 */
export function createNoPath(model, frame, shapes, theme) {
  const { noPath } = model;
  if (!noPath) return null;
  const tools = { ...gridOf(noPath, frame), theme };
  const walls = createWalls(noPath, tools);
  const nearest = nearestReachable(model, frame, shapes, theme);
  const marker = grouped(nearest.objects, 'nearest');
  const culprits = createCulprits(model, frame, theme);
  const detours = createDetours(noPath, frame, theme);

  function leaveOut(name) {
    for (const { inner, names } of walls) inner.visible = !names.includes(name);
    for (const [own, { outline, faded }] of culprits) [outline.visible, faded.visible] = [own !== name, own === name];
    for (const [own, path] of detours) path.visible = own === name;
    marker.visible = name === null;
  }

  leaveOut(null);
  return {
    walls,
    hang: nearest.hang,
    leaveOut,
    contents: {
      reachable: surface(noPath.reachable, 'reachable', REACHABLE, tools),
      walls: walls.map(({ group }) => group),
      nearestReachable: [marker],
      culprits: [...culprits.values()].flatMap(({ outline, faded }) => [outline, faded]),
      detours: [...detours.values()],
    },
    labels: [
      { text: 'nearest reachable', anchor: nearest.place, of: marker },
      { text: `${formatLength(noPath.toGoal)} to the goal`, anchor: nearest.middle, of: marker },
    ],
  };
}

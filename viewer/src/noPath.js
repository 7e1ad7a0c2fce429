// Why there is no path: what can be reached, the wall around it, who closes the way, and paths without an obstacle.

import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial } from 'three';
import { Mesh, MeshLambertMaterial, Vector3 } from 'three';
import { layCable } from './cables.js';
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

// The corners of a face, counter-clockwise seen from outside, in cubes.
function cornersOf([direction, at, u0, u1, v0, v1]) {
  const axis = direction >> 1;
  const corner = (u, v) => {
    const place = [0, 0, 0];
    place[axis] = at;
    place[(axis + 1) % 3] = u;
    place[(axis + 2) % 3] = v;
    return place;
  };
  const corners = [corner(u0, v0), corner(u1, v0), corner(u1, v1), corner(u0, v1)];
  return direction % 2 === 1 ? corners : corners.reverse();
}

function surfaceGeometry(faces, place) {
  const positions = [];
  const normals = [];
  for (const face of faces) {
    const normal = [0, 0, 0];
    normal[face[0] >> 1] = face[0] % 2 === 1 ? 1 : -1;
    const [a, b, c, d] = cornersOf(face).map((corner) => place(corner).toArray());
    for (const corner of [a, b, c, a, c, d]) {
      positions.push(...corner);
      normals.push(...normal);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  return geometry;
}

// Pieces of the rim of a face, each as long as a cube: a corner and an axis.
function* rimOf([direction, at, u0, u1, v0, v1]) {
  const axis = direction >> 1;
  const [along, across] = [(axis + 1) % 3, (axis + 2) % 3];
  const piece = (u, v, edge) => {
    const place = [0, 0, 0];
    [place[axis], place[along], place[across]] = [at, u, v];
    return { place, edge };
  };
  for (let u = u0; u < u1; u += 1) for (const v of [v0, v1]) yield piece(u, v, along);
  for (let v = v0; v < v1; v += 1) for (const u of [u0, u1]) yield piece(u, v, across);
}

// Where faces of different directions meet; the faces of a plane are divided in places that mean nothing.
function creases(faces, count, place) {
  const found = new Map();
  for (const face of faces) {
    for (const { place: at, edge } of rimOf(face)) {
      const key = at.reduce((sum, k) => sum * (count + 1) + k, edge);
      const known = found.get(key);
      if (known) known.directions.push(face[0]);
      else found.set(key, { at, edge, directions: [face[0]] });
    }
  }
  return [...found.values()].filter(({ directions }) => directions.length === 1 || new Set(directions).size > 1)
    .flatMap(({ at, edge }) => [place(at), place(at.map((k, axis) => k + (axis === edge ? 1 : 0)))]);
}

// A solid one is drawn twice, depth first, so that only its nearest face shows.
function surface(faces, role, look, { count, place, theme }) {
  if (faces.length === 0) return [];
  const geometry = surfaceGeometry(faces, place);
  const material = (options) => theme.paint(new MeshLambertMaterial({
    transparent: true,
    opacity: look.opacity,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
    ...options,
  }), role);
  const passes = look.solid ? [{ colorWrite: false }, { depthWrite: false }] : [{ depthWrite: false }];
  const meshes = passes.map((options) => new Mesh(geometry, material(options)));
  const pencil = new LineBasicMaterial({ transparent: true, opacity: look.edges });
  const lines = hairlines(creases(faces, count, place), pencil);
  theme.paint(lines.material, `${role}Edge`);
  [...meshes, lines].forEach((object, i) => {
    object.renderOrder = look.order + (i > 0 ? 1 : 0);
  });
  return [...meshes, lines];
}

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
  const { min, max, count } = noPath;
  const place = (cube) => frame.point(cube.map((k, axis) => min[axis] + ((max[axis] - min[axis]) * k) / count));
  const tools = { count, place, theme };
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

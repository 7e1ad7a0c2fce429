// The edited scene: plain data in the format of scene files, and functions that return a changed one.

import { Euler, Quaternion, Vector3 } from 'three';
import { rotationOf } from '../robot.js';

const TIDY = 1e9;

// Without the last digits of sums such as 0.1 + 0.2.
const tidy = (p) => p.map((x) => Math.round(x * TIDY) / TIDY);

const plus = (p, q) => tidy(p.map((x, i) => x + q[i]));

const minus = (p, q) => p.map((x, i) => x - q[i]);

const ORIGIN = Object.freeze([0, 0, 0]);

/** Both ends of a path. */
export const ENDS = ['start', 'goal'];

const positionOf = (body) => body.position ?? ORIGIN;

const obstaclesOf = (scene) => scene.obstacles ?? [];

/** The name of an obstacle's entry; one without a name counts from 0. */
export const nameOf = (body, index) => body.name ?? `obstacle ${index}`;

// The entries of each obstacle by name, for every list of obstacles that is in use.
const known = new WeakMap();

function entriesByName({ obstacles }) {
  if (!obstacles) return new Map();
  if (!known.has(obstacles)) {
    const found = new Map();
    obstacles.forEach((body, i) => {
      const name = nameOf(body, i);
      if (found.has(name)) found.get(name).push(body);
      else found.set(name, [body]);
    });
    known.set(obstacles, found);
  }
  return known.get(obstacles);
}

const entriesOf = (scene, name) => entriesByName(scene).get(name) ?? [];

/** The names of the obstacles, each once. */
export const obstacleNames = (scene) => [...entriesByName(scene).keys()];

/** Whether an obstacle has this name. */
export const hasObstacle = (scene, name) => entriesOf(scene, name).length > 0;

/** Where an obstacle is: the position of its first part, m. */
export const obstaclePosition = (scene, name) => positionOf(entriesOf(scene, name)[0]);

/** Moves an obstacle with all its parts. */
export function moveObstacle(scene, name, by) {
  const moved = (body, i) => (nameOf(body, i) === name ? { ...body, position: plus(positionOf(body), by) } : body);
  return { ...scene, obstacles: obstaclesOf(scene).map(moved) };
}

/** Moves the start or the goal to a position. */
export const moveEnd = (scene, which, to) => ({ ...scene, query: { ...scene.query, [which]: tidy(to) } });

/** Moves the outlet of a cable to a position. */
export function moveOutlet(scene, index, to) {
  const cables = scene.robot.cables.map((cable, i) => (i === index ? { ...cable, outlet: tidy(to) } : cable));
  return { ...scene, robot: { ...scene.robot, cables } };
}

// The first of "box 1", "box 2" and so on that is free.
function freeName(scene) {
  const taken = new Set(obstacleNames(scene));
  for (let i = 1; ; i += 1) if (!taken.has(`box ${i}`)) return `box ${i}`;
}

/** Adds a box with its centre at a position; returns the scene and the name of the box. */
export function addBox(scene, size, position) {
  const name = freeName(scene);
  const box = { name, box: tidy(size), position: tidy(position) };
  return { scene: { ...scene, obstacles: [...obstaclesOf(scene), box] }, name };
}

const without = (pairs, name) => pairs?.filter((pair) => !pair.includes(name));

/** Removes an obstacle, and the rules for pairs that name it. */
export function removeObstacle(scene, name) {
  const { ignore, touch, clearances } = scene;
  const pairs = clearances?.pairs?.filter(({ between }) => !between.includes(name));
  // The others keep their names, which count from 0.
  const named = obstaclesOf(scene).map((body, i) => ({ ...body, name: nameOf(body, i) }));
  return {
    ...scene,
    obstacles: named.filter((body) => body.name !== name),
    ...(ignore && { ignore: without(ignore, name) }),
    ...(touch && { touch: without(touch, name) }),
    ...(pairs && { clearances: { ...clearances, pairs } }),
  };
}

/** Sets the least distance between bodies, m. */
export const setClearance = (scene, clearance) => ({ ...scene, clearance });

/** The names of the orientations that the scene lists. */
export const orientationNames = (scene) => (scene.orientations ?? []).map(({ name }) => name);

/** Selects an orientation by its name; null leaves the choice to the planner. */
export function setOrientation(scene, name) {
  const { orientation, ...query } = scene.query ?? {};
  return { ...scene, query: name === null ? query : { ...query, orientation: name } };
}

/** The side lengths of an obstacle that is one box, or null. */
export function boxSize(scene, name) {
  const entries = entriesOf(scene, name);
  return entries.length === 1 && entries[0].box ? entries[0].box : null;
}

/** Changes the side lengths of an obstacle that is one box. */
export function resizeBox(scene, name, size) {
  const resized = (body, i) => (nameOf(body, i) === name ? { ...body, box: tidy(size) } : body);
  return { ...scene, obstacles: obstaclesOf(scene).map(resized) };
}

/** The ends of a path that the scene does not have yet. */
export const missingEnds = (scene) => ENDS.filter((end) => !scene.query?.[end]);

/** What can be moved, each with `kind`, `id` (which end, a name or an index) and `name` for the reader. */
export function thingsOf(scene, cables) {
  const ends = ENDS.filter((which) => scene.query?.[which]);
  return [
    ...ends.map((which) => ({ kind: 'end', id: which, name: which })),
    ...obstacleNames(scene).map((name) => ({ kind: 'obstacle', id: name, name })),
    ...scene.robot.cables.map((cable, i) => ({ kind: 'outlet', id: i, name: `outlet of ${cables[i]?.name ?? `cable ${i}`}` })),
  ];
}

/** Whether two are the same thing. */
export const isSame = (a, b) => a === b || (Boolean(a && b) && a.kind === b.kind && a.id === b.id);

/** Where a thing is; null if the scene has it no more. */
export function placeOf(scene, { kind, id }) {
  if (kind === 'end') return scene.query?.[id] ?? null;
  if (kind === 'outlet') return scene.robot.cables[id]?.outlet ?? null;
  return hasObstacle(scene, id) ? obstaclePosition(scene, id) : null;
}

/** Moves a thing to a position. */
export function moveThing(scene, { kind, id }, to) {
  if (kind === 'end') return moveEnd(scene, id, to);
  if (kind === 'outlet') return moveOutlet(scene, id, to);
  return moveObstacle(scene, id, minus(to, obstaclePosition(scene, id)));
}

const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7];
const FACES = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

// The rotation that the keys of a body give; `rpy` turns about x, then y, then z, all fixed axes.
function turnOf({ rpy, rpy_degrees: degrees, quaternion }) {
  if (quaternion) return rotationOf(quaternion);
  const [roll, pitch, yaw] = rpy ?? (degrees ?? ORIGIN).map((angle) => (angle * Math.PI) / 180);
  return new Quaternion().setFromEuler(new Euler(roll, pitch, yaw, 'ZYX'));
}

// A box as drawn until the planner's answer replaces it.
function boxPart(body) {
  const [turn, position] = [turnOf(body), positionOf(body)];
  const corner = (i) => new Vector3(...body.box.map((side, k) => (i & (1 << k) ? 0.5 : -0.5) * side));
  const vertices = CORNERS.map((i) => plus(position, corner(i).applyQuaternion(turn).toArray()));
  return { vertices, faces: FACES };
}

const shifted = (part, by) => ({ ...part, vertices: part.vertices.map((v) => v.map((x, i) => x + by[i])) });

// How an obstacle looks: as in the page it was last drawn in, moved by as much as since then.
function shownObstacle(scene, name, { shown, drawn }) {
  const [own] = entriesOf(scene, name);
  const [before] = entriesOf(shown, name);
  const look = drawn.get(name);
  if (!look || !before) return { name, parts: own.box ? [boxPart(own)] : [] };
  if (String(before.box) !== String(own.box)) return { name, parts: [boxPart(own)] };
  const by = minus(positionOf(own), positionOf(before));
  return by.every((x) => x === 0) ? look : { name, parts: look.parts.map((part) => shifted(part, by)) };
}

/**
 * The data of a page with the things of a scene where they are now, and nothing that belongs to another one. `shown` is
 * the scene that the page belongs to.
 */
export function pageOf(scene, page, shown) {
  const before = { shown, drawn: new Map((page.obstacles ?? []).map((obstacle) => [obstacle.name, obstacle])) };
  const cables = (page.cables ?? []).map((cable, i) => ({ ...cable, outlet: scene.robot.cables[i]?.outlet ?? cable.outlet }));
  return {
    ...page,
    cables,
    obstacles: obstacleNames(scene).map((name) => shownObstacle(scene, name, before)),
    start: scene.query?.start ?? null,
    goal: scene.query?.goal ?? null,
    path: null,
    no_path: null,
    motion: null,
    regions: null,
    feasible: null,
    violations: [],
  };
}

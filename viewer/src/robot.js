// The platform, its cables and the ghosts that mark start and goal.

import { Box3, Color, CylinderGeometry, DoubleSide, Group, InstancedMesh } from 'three';
import { Matrix4, Mesh, MeshLambertMaterial, Quaternion, Vector3 } from 'three';
import { boxEdges } from './surroundings.js';
import { dots, hairlines, moveWideLines, wideLines } from './marks.js';
import { buildShapes, solidGeometry } from './shapes.js';
import { cableRole } from './theme.js';

const UP = new Vector3(0, 1, 0);

/** A quaternion (w, x, y, z) as three.js has it. */
export const rotationOf = ([w, x, y, z]) => new Quaternion(x, y, z, w).normalize();

/** The shapes of the platform around its own origin. */
export const platformShapes = (model, frame) => buildShapes(model.platform, (v) => frame.vector(v));

function solidPlatform(shapes, theme) {
  const material = new MeshLambertMaterial({
    // Seen from inside where the section plane cuts it.
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  return new Mesh(solidGeometry(shapes), theme.paint(material, 'platform'));
}

/** The platform; its group has its position and its quaternion. */
export function createPlatform(shapes, theme) {
  const group = new Group();
  const edges = hairlines(shapes.edges);
  theme.paint(edges.material, 'platformEdge');
  const bars = wideLines(shapes.segments, { linewidth: 4 });
  theme.paint(bars.material, 'platform');
  // The dot at the origin shows where a platform is that is too small to see.
  const marks = dots([...shapes.dots, new Vector3()], 8);
  theme.paint(marks.material, 'platform');
  group.add(solidPlatform(shapes, theme), edges, bars, marks);
  return group;
}

function ghostFill() {
  return new MeshLambertMaterial({
    transparent: true,
    opacity: 0.3,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
}

/** A see-through platform. */
export function createGhost(shapes, orientation, theme, role = 'ghost') {
  const group = new Group();
  group.quaternion.copy(rotationOf(orientation));
  const edges = wideLines([...shapes.edges, ...shapes.segments], { linewidth: 1.5 });
  const marks = dots([...shapes.dots, new Vector3()], 9);
  const fill = new Mesh(solidGeometry(shapes), ghostFill());
  // After the obstacles, which would otherwise paint over it.
  fill.renderOrder = 4;
  for (const part of [edges, marks, fill]) theme.paint(part.material, role);
  group.add(fill, edges, marks);
  return group;
}

function createTubes(cables) {
  const geometry = new CylinderGeometry(1, 1, 1, 12, 1, true);
  const tubes = new InstancedMesh(geometry, new MeshLambertMaterial(), cables.length);
  tubes.frustumCulled = false;
  return tubes;
}

// The matrix that stretches a unit cylinder between two points.
function tubeMatrix(from, to, radius, matrix) {
  const axis = to.clone().sub(from);
  const length = axis.length();
  const turn = new Quaternion().setFromUnitVectors(UP, axis.divideScalar(length || 1));
  return matrix.compose(from.clone().add(to).multiplyScalar(0.5), turn, new Vector3(radius, length, radius));
}

function layCables(model, frame) {
  return model.cables.map((cable) => ({
    outlet: frame.point(cable.outlet),
    arm: frame.vector(cable.attachment),
    end: new Vector3(),
    radius: (cable.diameter / 2) * frame.scale,
  }));
}

/** The outlets, and the box around them that stands for the frame. */
export function createOutlets(model, frame, theme) {
  if (model.cables.length === 0) return [];
  const places = model.cables.map((cable) => frame.point(cable.outlet));
  const marks = dots(places, 8);
  // Wider than those of the workspace, which is often the same box.
  const edges = wideLines(boxEdges(new Box3().setFromPoints(places)), { linewidth: 2 });
  theme.paint(marks.material, 'outlet');
  theme.paint(edges.material, 'frame');
  return [marks, edges];
}

// Those that the reader does not point at fade into the background by this share.
const FADED = 0.75;

// The colour of each cable, and faded while another one is brought out.
function createColors(count, theme) {
  const own = Array.from({ length: count }, () => new Color());
  const background = new Color();
  own.forEach((color, i) => theme.bind(color, cableRole(i)));
  theme.bind(background, 'background');
  return (lit) => own.map((color, i) => (lit === null || lit === i ? color : color.clone().lerp(background, FADED)));
}

/**
 * The cables, each in its colour; `move` brings the platform end of the cables to a position and rotation of the
 * platform, `light` brings out the one with an index (null: none), `ends` has outlet and platform end of each.
 * `moveOutlet` brings an outlet to a place; its cable is drawn there with the next `move`.
 */
export function createCables(model, frame, theme) {
  const cables = layCables(model, frame);
  const thick = cables.filter((cable) => cable.radius > 0);
  const ends = cables.flatMap((cable) => [cable.outlet, cable.end]);
  const lines = wideLines(ends, { linewidth: 1.75, vertexColors: true });
  const lit = wideLines([new Vector3(), new Vector3()], { linewidth: 4.5 });
  const tubes = createTubes(thick);
  const colorsFor = createColors(cables.length, theme);
  const matrix = new Matrix4();
  let index = null;
  lit.visible = false;
  lit.renderOrder = 5;

  function paint() {
    const colors = colorsFor(index);
    lines.geometry.setColors(colors.flatMap((color) => [...color.toArray(), ...color.toArray()]));
    thick.forEach((cable, i) => tubes.setColorAt(i, colors[cables.indexOf(cable)]));
    if (tubes.instanceColor) tubes.instanceColor.needsUpdate = true;
    if (index !== null) lit.material.color.copy(colors[index]);
  }

  function showLit() {
    lit.visible = index !== null;
    if (index !== null) moveWideLines(lit, ends.slice(2 * index, 2 * index + 2));
  }

  function light(wanted) {
    index = wanted !== null && wanted < cables.length ? wanted : null;
    paint();
    showLit();
  }

  function move(position, rotation) {
    for (const cable of cables) cable.end.copy(cable.arm).applyQuaternion(rotation).add(position);
    moveWideLines(lines, ends);
    thick.forEach((cable, i) => tubes.setMatrixAt(i, tubeMatrix(cable.outlet, cable.end, cable.radius, matrix)));
    tubes.instanceMatrix.needsUpdate = true;
    showLit();
  }

  if (cables.length > 0) paint();
  theme.watch(paint);
  const moveOutlet = (index, place) => cables[index].outlet.copy(place);
  return { parts: cables.length > 0 ? [lines, tubes, lit] : [], ends, light, move, moveOutlet };
}

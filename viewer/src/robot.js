// The platform, the outlets and the ghosts that mark start and goal.

import { Box3, DoubleSide, Group, Mesh, MeshLambertMaterial, Quaternion, Vector3 } from 'three';
import { boxEdges } from './surroundings.js';
import { dots, hairlines, wideLines } from './marks.js';
import { buildShapes, solidGeometry } from './shapes.js';

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

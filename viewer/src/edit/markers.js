// What the editor draws: outlines of things, arrows along the axes, and how far each is from a place on the screen.

import { ConeGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Quaternion, Raycaster, Vector2, Vector3 } from 'three';
import { dots, wideLines } from '../marks.js';
import { rotationOf } from '../robot.js';
import { buildShapes, disposeAll, solidGeometry } from '../shapes.js';

const ARROW = 78;
const GAP = 16;
const WIDTHS = { hover: 2.5, selected: 3.5, bad: 3.5 };
const ROLES = { hover: 'focus', selected: 'focus', bad: 'violation' };
const OUTLET_DOT = { hover: 13, selected: 15, bad: 15 };
// Okabe–Ito: red for x, green for y, blue for z.
const COLORS = ['#d55e00', '#009e73', '#2b8fd0'];
const AXES = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/** The unit vector of an axis 0, 1 or 2. */
export const axisVector = (axis) => AXES[axis];

function onTop(object, order) {
  object.renderOrder = order;
  object.material.depthTest = false;
  object.material.transparent = true;
  return object;
}

function arrow(axis) {
  const group = new Group();
  const line = wideLines([AXES[axis].clone().multiplyScalar(GAP / ARROW), AXES[axis].clone().multiplyScalar(0.8)], { linewidth: 3 });
  const head = new Mesh(new ConeGeometry(0.07, 0.2, 16), new MeshBasicMaterial());
  head.position.copy(AXES[axis]).multiplyScalar(0.9);
  head.quaternion.copy(new Quaternion().setFromUnitVectors(AXES[1], AXES[axis]));
  for (const part of [line, head]) part.material.color.set(COLORS[axis]);
  group.add(onTop(line, 30), onTop(head, 31));
  return group;
}

/** The size of one pixel at a place of the drawing frame. */
export function pixelAt(place, camera, height) {
  if (camera.isOrthographicCamera) return (camera.top - camera.bottom) / camera.zoom / height;
  const depth = place.clone().sub(camera.position).dot(camera.getWorldDirection(new Vector3()));
  return (2 * Math.max(depth, 1e-6) * Math.tan((camera.fov * Math.PI) / 360)) / height;
}

/** Three arrows that keep their size on the screen. */
export function createArrows() {
  const group = new Group();
  group.add(...AXES.map((_, axis) => arrow(axis)));
  group.visible = false;
  return {
    group,
    /** Puts the arrows at a place. */
    fit: (place, camera, height) => {
      group.position.copy(place);
      group.scale.setScalar(ARROW * pixelAt(place, camera, height));
    },
    /** Shows all of them, or only the one that is dragged. */
    only: (axis) => group.children.forEach((child, i) => {
      child.visible = axis === null || axis === i;
    }),
    /** Both ends of each arrow in the drawing frame. */
    ends: () => AXES.map((v) => [GAP / ARROW, 1].map((at) => v.clone().multiplyScalar(at * group.scale.x).add(group.position))),
  };
}

/** The shapes of a thing around its own place; an outlet has none. */
export function shapesOf({ kind, id }, { model, frame, place }) {
  if (kind === 'outlet') return null;
  if (kind === 'end') {
    const turn = rotationOf(id === 'start' ? model.startOrientation : model.goalOrientation);
    return buildShapes(model.platform, (v) => frame.vector(v).applyQuaternion(turn));
  }
  const obstacle = model.obstacles.find(({ name }) => name === id);
  const origin = frame.point(place);
  return obstacle ? buildShapes(obstacle.parts, (v) => frame.point(v).sub(origin)) : null;
}

/** The outline of a thing around its own place, of a style `hover`, `selected` or `bad`. */
export function createOutline(thing, shapes, style, theme) {
  const painter = theme.createPainter();
  const group = new Group();
  const pairs = shapes ? [...shapes.edges, ...shapes.segments] : [];
  if (pairs.length > 0) {
    const lines = wideLines(pairs, { linewidth: WIDTHS[style] });
    painter.paint(lines.material, ROLES[style]);
    lines.renderOrder = 8;
    group.add(lines);
  } else {
    const dot = onTop(dots([new Vector3()], OUTLET_DOT[style]), 9);
    painter.paint(dot.material, ROLES[style]);
    group.add(dot);
  }
  const remove = () => {
    painter.release();
    disposeAll(group);
  };
  return { thing, group, remove };
}

const ray = new Raycaster();
const proxyMaterial = new MeshBasicMaterial({ side: DoubleSide });

/** A solid that is not drawn, to find out what is under the pointer. */
export function createProxy(shapes) {
  return new Mesh(solidGeometry(shapes), proxyMaterial);
}

/** The ray through a place of the canvas, in pixels from its corner. */
export function rayAt({ x, y }, camera, { clientWidth, clientHeight }) {
  ray.setFromCamera(new Vector2((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight), camera);
  return ray;
}

/** Where a place of the drawing frame is on the canvas, px; null behind the camera. */
export function onScreen(place, camera, { clientWidth, clientHeight }) {
  const v = place.clone().project(camera);
  if (Math.abs(v.z) > 1) return null;
  return { x: ((v.x + 1) / 2) * clientWidth, y: ((1 - v.y) / 2) * clientHeight };
}

/** The distance of a place on the screen from a segment, px. */
export function segmentDistance(p, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const t = Math.min(1, Math.max(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

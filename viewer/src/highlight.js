// Marks the two with the least room between them where the platform is.

import { Group, Vector3 } from 'three';
import { moveWideLines, wideLines } from './marks.js';
import { rotationOf } from './robot.js';
import { buildShapes } from './shapes.js';

const WIDTH = 4.5;

function obstacleMark(obstacle, frame, material) {
  const { edges, segments } = buildShapes(obstacle.parts, (v) => frame.point(v));
  const mark = wideLines([...edges, ...segments], { linewidth: WIDTH });
  mark.material = material;
  return mark;
}

/** Two materials, one for enough room and one for too little. */
function materials(theme) {
  const of = (role) => theme.paint(wideLines([new Vector3(), new Vector3()], { linewidth: WIDTH }).material, role);
  return { gap: of('highlight'), overlap: of('violation') };
}

/** `objects` belong to a layer; `show` marks a pair (none: nobody), `move` follows the platform. */
export function createHighlight(model, frame, shapes, theme) {
  if (!model.motion || model.motion.clearance.length === 0) return { objects: [], show: () => {}, move: () => {} };
  const { gap, overlap } = materials(theme);
  const all = new Group();
  const rotation = rotationOf(model.orientation);
  const platform = wideLines([...shapes.edges, ...shapes.segments], { linewidth: WIDTH });
  platform.quaternion.copy(rotation);
  const cables = model.cables.map((cable) => {
    const ends = [frame.point(cable.outlet), new Vector3()];
    const arm = frame.vector(cable.attachment).applyQuaternion(rotation);
    return { mark: wideLines(ends, { linewidth: WIDTH }), ends, arm };
  });
  const obstacles = new Map();
  all.add(platform, ...cables.map(({ mark }) => mark));
  for (const mark of all.children) mark.renderOrder = 6;

  function markOf(name) {
    const cable = model.cables.findIndex((c) => c.name === name);
    if (cable >= 0) return cables[cable].mark;
    const obstacle = model.obstacles.find((o) => o.name === name);
    if (!obstacle) return platform;
    if (!obstacles.has(name)) {
      obstacles.set(name, obstacleMark(obstacle, frame, gap));
      obstacles.get(name).renderOrder = 6;
      all.add(obstacles.get(name));
    }
    return obstacles.get(name);
  }

  function show(nearest) {
    for (const mark of all.children) mark.visible = false;
    for (const mark of (nearest?.culprits ?? []).map(markOf)) {
      mark.visible = true;
      mark.material = nearest.bad ? overlap : gap;
    }
  }

  function move(position) {
    platform.position.copy(position);
    for (const { mark, ends, arm } of cables) {
      ends[1].copy(position).add(arm);
      moveWideLines(mark, ends);
    }
  }

  show(null);
  return { objects: [all], show, move };
}

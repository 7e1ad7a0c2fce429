// Marks the two with the least room between them where the platform is.

import { Group, Vector3 } from 'three';
import { moveWideLines, wideLines } from './marks.js';
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
  const platform = wideLines([...shapes.edges, ...shapes.segments], { linewidth: WIDTH });
  const cables = model.cables.map((cable) => {
    const ends = [frame.point(cable.outlet), new Vector3()];
    return { mark: wideLines(ends, { linewidth: WIDTH }), ends, attachment: frame.vector(cable.attachment) };
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

  function move(position, rotation) {
    platform.position.copy(position);
    platform.quaternion.copy(rotation);
    for (const { mark, ends, attachment } of cables) {
      ends[1].copy(attachment).applyQuaternion(rotation).add(position);
      moveWideLines(mark, ends);
    }
  }

  show(null);
  return { objects: [all], show, move };
}

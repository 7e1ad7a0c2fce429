// The triangles that the cables sweep along the segments of the final path.

import { BufferGeometry, DoubleSide, Float32BufferAttribute, Mesh, MeshBasicMaterial } from 'three';
import { rotationOf } from './robot.js';
import { posesOf } from './route.js';
import { REGION_COLORS } from './theme.js';

/** A translucent fan for each cable. */
export function createSwept(model, frame, theme) {
  const waypoints = model.path?.waypoints ?? [];
  if (waypoints.length < 2) return [];
  const poses = posesOf(model.path, model.orientation);
  const places = poses.map(({ position, orientation }) => ({ at: frame.point(position), turn: rotationOf(orientation) }));
  return model.cables.map((cable, index) => {
    const outlet = frame.point(cable.outlet);
    const ends = places.map(({ at, turn }) => frame.vector(cable.attachment).applyQuaternion(turn).add(at));
    const corners = ends.slice(1).flatMap((end, i) => [outlet, ends[i], end]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(corners.flatMap((p) => p.toArray()), 3));
    const options = { transparent: true, opacity: 0.22, depthWrite: false, side: DoubleSide };
    const fan = new Mesh(geometry, theme.paint(new MeshBasicMaterial(options), `region${index % REGION_COLORS}`));
    fan.renderOrder = 4;
    return fan;
  });
}

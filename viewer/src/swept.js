// The triangles that the cables sweep along the segments of the final path.

import { BufferGeometry, DoubleSide, Float32BufferAttribute, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { rotationOf } from './robot.js';
import { REGION_COLORS } from './theme.js';

/** A translucent fan for each cable. */
export function createSwept(model, frame, theme) {
  const waypoints = model.path?.waypoints ?? [];
  if (waypoints.length < 2) return [];
  const rotation = rotationOf(model.orientation);
  const places = waypoints.map((p) => frame.point(p));
  return model.cables.map((cable, index) => {
    const outlet = frame.point(cable.outlet);
    const arm = frame.vector(cable.attachment).applyQuaternion(rotation);
    const ends = places.map((place) => new Vector3().addVectors(place, arm));
    const corners = ends.slice(1).flatMap((end, i) => [outlet, ends[i], end]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new Float32BufferAttribute(corners.flatMap((p) => p.toArray()), 3));
    const options = { transparent: true, opacity: 0.22, depthWrite: false, side: DoubleSide };
    const fan = new Mesh(geometry, theme.paint(new MeshBasicMaterial(options), `region${index % REGION_COLORS}`));
    fan.renderOrder = 4;
    return fan;
  });
}

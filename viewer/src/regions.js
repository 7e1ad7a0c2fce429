// Forbidden regions: translucent, in the colour of the cable that they concern.

import { Group, Mesh, MeshLambertMaterial } from 'three';
import { dots, wideLines } from './marks.js';
import { buildShapes, solidGeometry } from './shapes.js';
import { REGION_COLORS } from './theme.js';

const OPACITY = 0.24;

function fill(shapes, role, theme) {
  const material = new MeshLambertMaterial({
    transparent: true,
    opacity: OPACITY,
    depthWrite: false,
    // Behind the faces of obstacles, on which shadows start.
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 4,
  });
  const mesh = new Mesh(solidGeometry(shapes), theme.paint(material, role));
  // After the obstacles, which would otherwise paint over it.
  mesh.renderOrder = 4;
  return mesh;
}

function rim(shapes, role, theme) {
  const lines = wideLines(shapes.edges, { linewidth: 1.5 });
  theme.paint(lines.material, role);
  return lines;
}

// Shadows start at an outlet; elsewhere than in the space of attachments they are moved away from it.
function source(cable, role, frame, theme) {
  const mark = dots([frame.point(cable.outlet)], 14);
  theme.paint(mark.material, role);
  // After the outlet's own dot.
  mark.renderOrder = 5;
  return mark;
}

// A cable has the same colour on every page of a scene.
function roleOf(cable, model) {
  return cable ? `region${model.cables.indexOf(cable) % REGION_COLORS}` : 'platform';
}

/** A group for each owner, the first of those whom a region keeps apart, with the role of its colour. */
export function createRegions(model, frame, theme) {
  if (!model.regions) return [];
  const { space, meshes } = model.regions;
  if (meshes.length === 0) return [];
  const named = new Set(meshes.map((region) => region.owner));
  const inOrder = model.cables.map(({ name }) => name).filter((name) => named.has(name));
  return [...new Set([...inOrder, ...named])].map((owner) => {
    const cable = model.cables.find(({ name }) => name === owner);
    const role = roleOf(cable, model);
    const group = new Group();
    group.name = owner;
    const shapes = buildShapes(meshes.filter((region) => region.owner === owner), (v) => frame.point(v));
    group.add(fill(shapes, role, theme), rim(shapes, role, theme));
    if (cable && space === 'attachment') group.add(source(cable, role, frame, theme));
    return { group, role };
  });
}

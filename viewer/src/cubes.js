// Surfaces of unions of cubes of a grid.

import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, Mesh, MeshLambertMaterial } from 'three';
import { hairlines } from './marks.js';

/** A box divided into equally many cubes along each axis: their number, and the place of a corner of cubes in the drawing frame. */
export function gridOf({ min, max, count }, frame) {
  const place = (cube) => frame.point(cube.map((k, axis) => min[axis] + ((max[axis] - min[axis]) * k) / count));
  return { count, place };
}

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

/** The surface that faces of cubes make up; a solid one is drawn twice, depth first, so that only its nearest face shows. */
export function surface(faces, role, look, { count, place, theme }) {
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

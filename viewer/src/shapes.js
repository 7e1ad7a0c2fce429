// Convex parts as triangles, edges, segments and dots.

import { BufferGeometry, Float32BufferAttribute, Vector3 } from 'three';

// Edges between faces that are closer to coplanar than this are not drawn.
const FLAT_COSINE = Math.cos((8 * Math.PI) / 180);

function faceNormal(corners) {
  const normal = new Vector3();
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % corners.length];
    normal.x += (a.y - b.y) * (a.z + b.z - 2 * corners[0].z);
    normal.y += (a.z - b.z) * (a.x + b.x - 2 * corners[0].x);
    normal.z += (a.x - b.x) * (a.y + b.y - 2 * corners[0].y);
  });
  return normal.normalize();
}

function addFace(corners, normal, out) {
  for (let i = 1; i + 1 < corners.length; i += 1) {
    for (const corner of [corners[0], corners[i], corners[i + 1]]) {
      out.positions.push(corner.x, corner.y, corner.z);
      out.normals.push(normal.x, normal.y, normal.z);
    }
  }
}

function collectEdges(face, normal, edges) {
  face.forEach((i, k) => {
    const j = face[(k + 1) % face.length];
    const key = i < j ? `${i} ${j}` : `${j} ${i}`;
    if (!edges.has(key)) edges.set(key, { i, j, normals: [] });
    edges.get(key).normals.push(normal);
  });
}

const isSharp = ({ normals }) => normals.length !== 2 || normals[0].dot(normals[1]) < FLAT_COSINE;

function addSolid(part, vertices, out) {
  const edges = new Map();
  for (const face of part.faces) {
    const corners = face.map((i) => vertices[i]);
    const normal = faceNormal(corners);
    addFace(corners, normal, out);
    if (part.faces.length === 1) addFace(corners.slice().reverse(), normal.clone().negate(), out);
    collectEdges(face, normal, edges);
  }
  for (const edge of edges.values()) {
    if (isSharp(edge)) out.edges.push(vertices[edge.i], vertices[edge.j]);
  }
}

function addThin(vertices, out) {
  if (vertices.length === 1) out.dots.push(vertices[0]);
  for (let i = 1; i < vertices.length; i += 1) out.segments.push(vertices[i - 1], vertices[i]);
}

/** All parts as drawable pieces; `place` brings a vertex into the drawing frame. */
export function buildShapes(parts, place) {
  const out = { positions: [], normals: [], edges: [], segments: [], dots: [] };
  for (const part of parts) {
    const vertices = part.vertices.map((v) => place(v));
    if (part.faces.length > 0) addSolid(part, vertices, out);
    else addThin(vertices, out);
  }
  return out;
}

/** Several shapes as one, each in its shade of the colour: a factor. */
export function mergeShapes(all) {
  const merged = (key) => all.flatMap((shapes) => shapes[key]);
  const [positions, normals, edges] = ['positions', 'normals', 'edges'].map(merged);
  const shades = all.flatMap(({ positions: own, shade = 1 }) => own.map(() => shade));
  return { positions, normals, edges, shades, segments: merged('segments'), dots: merged('dots') };
}

/** Triangles of shapes as one geometry. */
export function solidGeometry(shapes) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(shapes.positions, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(shapes.normals, 3));
  if (shapes.shades) geometry.setAttribute('color', new Float32BufferAttribute(shapes.shades, 3));
  return geometry;
}

/** Takes something out of the picture and frees what it holds. */
export function disposeAll(group) {
  group.removeFromParent();
  group.traverse((object) => {
    object.geometry?.dispose();
    object.material?.dispose();
    if (object.isInstancedMesh) object.dispose();
  });
}

// Lines and dots that keep their width on the screen.

import { BufferGeometry, CanvasTexture, LineBasicMaterial, LineSegments, Points, PointsMaterial, SRGBColorSpace } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const TEXTURE_SIZE = 64;

const flatten = (points) => points.flatMap((p) => [p.x, p.y, p.z]);

/** Consecutive points as pairs of segment ends. */
export function chain(points) {
  return points.slice(1).flatMap((point, i) => [points[i], point]);
}

/** The geometry of hairlines, and of dots. */
export const pointGeometry = (points) => new BufferGeometry().setFromPoints(points);

/** Lines one pixel wide between pairs of points. */
export function hairlines(pairs, material = new LineBasicMaterial()) {
  return new LineSegments(pointGeometry(pairs), material);
}

/** The geometry of wide lines. */
export const wideGeometry = (pairs) => new LineSegmentsGeometry().setPositions(flatten(pairs));

/** Lines of a width in pixels between pairs of points. */
export function wideLines(pairs, options) {
  const lines = new LineSegments2(wideGeometry(pairs), new LineMaterial(options));
  if (options.dashed) lines.computeLineDistances();
  lines.frustumCulled = false;
  return lines;
}

/** Lines that cover others in the same place, piece by piece. */
export function covering(lines) {
  Object.assign(lines.material, { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -8 });
  return lines;
}

/** Moves the ends of wide lines. */
export function moveWideLines(lines, pairs) {
  const buffer = lines.geometry.attributes.instanceStart.data;
  pairs.forEach((point, i) => point.toArray(buffer.array, 3 * i));
  buffer.needsUpdate = true;
}

function texture(draw) {
  const canvas = document.createElement('canvas');
  canvas.width = TEXTURE_SIZE;
  canvas.height = TEXTURE_SIZE;
  const context = canvas.getContext('2d');
  context.translate(TEXTURE_SIZE / 2, TEXTURE_SIZE / 2);
  draw(context, TEXTURE_SIZE / 2);
  const result = new CanvasTexture(canvas);
  result.colorSpace = SRGBColorSpace;
  return result;
}

function drawDisc(context, radius) {
  context.fillStyle = '#fff';
  context.arc(0, 0, radius - 2, 0, 2 * Math.PI);
  context.fill();
}

function drawCross(context, radius, thickness) {
  const arm = radius * 0.62;
  context.strokeStyle = '#fff';
  context.lineCap = 'round';
  context.lineWidth = radius * thickness;
  context.moveTo(-arm, -arm);
  context.lineTo(arm, arm);
  context.moveTo(-arm, arm);
  context.lineTo(arm, -arm);
  context.stroke();
}

function sprites(points, size, map) {
  const material = new PointsMaterial({ size, map, sizeAttenuation: false, transparent: true, alphaTest: 0.5 });
  const marks = new Points(pointGeometry(points), material);
  marks.frustumCulled = false;
  return marks;
}

// Drawn once: pages replace their contents.
const textures = new Map();

function textureOf(key, draw) {
  if (!textures.has(key)) textures.set(key, texture(draw));
  return textures.get(key);
}

/** Round dots with a diameter in pixels. */
export const dots = (points, size) => sprites(points, size, textureOf('disc', drawDisc));

/** Crosses with a width in pixels that nothing hides. */
export function crosses(points, size, thickness, order) {
  const draw = (context, radius) => drawCross(context, radius, thickness);
  const marks = sprites(points, size, textureOf(thickness, draw));
  marks.material.depthTest = false;
  marks.material.alphaTest = 0;
  marks.renderOrder = order;
  return marks;
}

// What tells where things are in space: a grid on the floor, and below the platform a line and a shadow.

import { CanvasTexture, Group, LineBasicMaterial, Mesh, MeshBasicMaterial, PlaneGeometry, Vector3 } from 'three';
import { hairlines, moveWideLines, wideLines } from './marks.js';

const GRID_OPACITY = 0.38;
const LEAST_CELLS = 4;
const MOST_CELLS = 24;
const STEPS = [1, 2, 5];

/** The distance of the grid's lines, m: a metre where that makes neither few nor many, else a round number. */
export function gridStep({ workspace }) {
  if (!workspace) return null;
  const longest = Math.max(workspace.max[0] - workspace.min[0], workspace.max[1] - workspace.min[1]);
  if (!(longest > 0) || !Number.isFinite(longest)) return null;
  if (longest >= LEAST_CELLS && longest <= MOST_CELLS) return 1;
  const decade = 10 ** Math.floor(Math.log10(longest / LEAST_CELLS));
  return decade * STEPS.filter((step) => step * decade <= longest / LEAST_CELLS).at(-1);
}

// The multiples of a step between two numbers.
function multiples(low, high, step) {
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => (first + i) * step);
}

/** The grid on the floor of the workspace. */
export function createGrid(model, frame, theme) {
  const step = gridStep(model);
  if (step === null) return [];
  const { min, max } = model.workspace;
  const point = (x, y) => frame.point([x, y, min[2]], new Vector3());
  const across = multiples(min[0], max[0], step).flatMap((x) => [point(x, min[1]), point(x, max[1])]);
  const along = multiples(min[1], max[1], step).flatMap((y) => [point(min[0], y), point(max[0], y)]);
  const lines = hairlines([...across, ...along], new LineBasicMaterial({ transparent: true, opacity: GRID_OPACITY, depthWrite: false }));
  theme.paint(lines.material, 'floor');
  return [lines];
}

function softDisc() {
  const canvas = document.createElement('canvas');
  canvas.width = 64;
  canvas.height = 64;
  const context = canvas.getContext('2d');
  const fade = context.createRadialGradient(32, 32, 4, 32, 32, 32);
  fade.addColorStop(0, 'rgb(255 255 255 / 100%)');
  fade.addColorStop(1, 'rgb(255 255 255 / 0%)');
  context.fillStyle = fade;
  context.fillRect(0, 0, 64, 64);
  return new CanvasTexture(canvas);
}

let disc = null;

function createShadow(theme) {
  disc ??= softDisc();
  const material = new MeshBasicMaterial({ map: disc, transparent: true, opacity: 0.5, depthWrite: false });
  const shadow = new Mesh(new PlaneGeometry(1, 1), theme.paint(material, 'shadow'));
  shadow.renderOrder = -0.5;
  return shadow;
}

// The width of the platform along x and y; a platform without extent still has a shadow.
function footprint({ platform }, frame) {
  const points = platform.flatMap(({ vertices }) => vertices);
  const width = (axis) => {
    const values = points.map((p) => p[axis]);
    return values.length > 0 ? Math.max(...values) - Math.min(...values) : 0;
  };
  const least = 0.05;
  return [0, 1].map((axis) => Math.max(least, 1.6 * width(axis) * frame.scale));
}

/** The line from the platform to the floor and its shadow there; `move` follows the platform. */
export function createDrop(model, frame, theme) {
  if (!model.workspace) return { objects: [], move: () => {} };
  const ends = [new Vector3(), new Vector3()];
  const line = wideLines(ends, { linewidth: 1.25, dashed: true, dashSize: 0.012, gapSize: 0.012 });
  theme.paint(line.material, 'muted');
  const shadow = createShadow(theme);
  const [x, y] = footprint(model, frame);
  shadow.scale.set(x, y, 1);
  const floor = frame.point(model.workspace.min).z;
  const group = new Group();
  group.add(line, shadow);
  const ahead = new Vector3();
  const move = (position, rotation) => {
    ends[0].copy(position);
    ends[1].copy(position).setZ(floor);
    moveWideLines(line, ends);
    line.computeLineDistances();
    shadow.position.copy(ends[1]);
    ahead.set(1, 0, 0).applyQuaternion(rotation);
    shadow.rotation.z = Math.atan2(ahead.y, ahead.x);
  };
  return { objects: [group], move };
}

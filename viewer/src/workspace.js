// The wrench-feasible workspace as a grid of small cubes, coloured by the margin beyond what is demanded.

import { BoxGeometry, Color, InstancedMesh, Matrix4, MeshLambertMaterial, Vector3 } from 'three';

// The palette "cividis", which reads the same with every kind of colour vision.
const RAMP = ['#00224e', '#35456c', '#666970', '#948e77', '#c8b866', '#fee838'].map((color) => new Color(color));
const SIZE = 0.32;

function rampColor(share, target) {
  const place = Math.min(1, Math.max(0, share)) * (RAMP.length - 1);
  const index = Math.min(RAMP.length - 2, Math.floor(place));
  return target.copy(RAMP[index]).lerp(RAMP[index + 1], place - index);
}

/** One cube for each feasible node of the grid. */
export function createFeasible({ feasible }, frame) {
  if (!feasible) return [];
  const { origin, step, counts, margins, greatest } = feasible;
  const [, ny, nz] = counts;
  const nodes = [...margins.keys()].filter((n) => margins[n] !== null);
  if (nodes.length === 0) return [];
  const side = SIZE * step * frame.scale;
  const cubes = new InstancedMesh(new BoxGeometry(side, side, side), new MeshLambertMaterial(), nodes.length);
  const matrix = new Matrix4();
  const color = new Color();
  const place = new Vector3();
  nodes.forEach((n, i) => {
    const node = [Math.floor(n / nz / ny), Math.floor(n / nz) % ny, n % nz];
    frame.point(node.map((k, axis) => origin[axis] + k * step), place);
    cubes.setMatrixAt(i, matrix.makeTranslation(place.x, place.y, place.z));
    cubes.setColorAt(i, rampColor(margins[n] / greatest, color));
  });
  return [cubes];
}

// The cables: straight lines from their outlets, or with pulleys and weight as they run and hang.

import { Color, CylinderGeometry, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, Vector3 } from 'three';
import { bends, courseOf } from './hanging.js';
import { chain, covering, moveWideLines, wideLines } from './marks.js';
import { cableRole } from './theme.js';

const UP = new Vector3(0, 1, 0);

// Radius and width of a wheel as shares of the radius at which its cable runs, so that the cable is seen on it.
const WHEEL = { radius: 0.92, width: 0.25 };

const createInstances = (geometry, count) => {
  const instances = new InstancedMesh(geometry, new MeshLambertMaterial(), count);
  instances.frustumCulled = false;
  return instances;
};

const createTubes = (count) => createInstances(new CylinderGeometry(1, 1, 1, 12, 1, true), count);

// Pieces of a cable that bends are longer by this share of its radius, so that there are no gaps between them.
const OVERLAP = 0.2;

// The matrix that stretches a unit cylinder between two points and a little beyond.
function tubeMatrix(from, to, radius, beyond, matrix) {
  const axis = to.clone().sub(from);
  const length = axis.length();
  const turn = new Quaternion().setFromUnitVectors(UP, axis.divideScalar(length || 1));
  return matrix.compose(from.clone().add(to).multiplyScalar(0.5), turn, new Vector3(radius, length + beyond, radius));
}

const pulleyIn = (frame, { radius, axis }) => ({ radius: radius * frame.scale, axis });
const sagIn = (frame, { up, curvature }) => ({ up, curvature: curvature / frame.scale });

/**
 * A cable in the drawing frame; `points` has outlet and platform end and, if it bends, the points between, which `lay` brings
 * to where they are: on the course of the cable if it `hangs`, otherwise on the straight line.
 */
export function layCable(cable, frame) {
  const laid = {
    outlet: frame.point(cable.outlet),
    arm: frame.vector(cable.attachment),
    end: new Vector3(),
    radius: (cable.diameter / 2) * frame.scale,
    pulley: cable.pulley && pulleyIn(frame, cable.pulley),
    sag: cable.sag && sagIn(frame, cable.sag),
    wheel: null,
  };
  if (!bends(laid)) return { ...laid, points: [laid.outlet, laid.end], lay: () => {} };
  const { outlet, end, pulley, sag } = laid;
  const course = () => courseOf({ outlet: outlet.toArray(), pulley, sag }, end.toArray());
  const points = [outlet, ...course().points.slice(1, -1).map(() => new Vector3()), end];
  const lay = (hangs) => {
    const { points: places, wheel } = course();
    points.slice(1, -1).forEach((point, i) => {
      if (hangs) point.fromArray(places[i + 1]);
      else point.copy(outlet).lerp(end, (i + 1) / (points.length - 1));
    });
    own.wheel = wheel;
  };
  const own = { ...laid, points, lay };
  return own;
}

// The wheels of the pulleys, as discs that swivel with their cables.
function createWheels(cables, theme) {
  const rolling = cables.filter(({ pulley }) => pulley);
  const wheels = createInstances(new CylinderGeometry(1, 1, 1, 40), rolling.length);
  theme.paint(wheels.material, 'frame');
  const matrix = new Matrix4();
  const turn = new Quaternion();
  const lay = () => {
    rolling.forEach(({ pulley, wheel }, i) => {
      const radius = WHEEL.radius * pulley.radius;
      turn.setFromUnitVectors(UP, new Vector3(...wheel.axle));
      matrix.compose(new Vector3(...wheel.centre), turn, new Vector3(radius, WHEEL.width * pulley.radius, radius));
      wheels.setMatrixAt(i, matrix);
    });
    wheels.instanceMatrix.needsUpdate = true;
  };
  return { objects: rolling.length > 0 ? [wheels] : [], lay };
}

// Those that the reader does not point at fade into the background by this share.
const FADED = 0.75;

// The colour of each cable, and faded while another one is brought out.
function createColors(count, theme) {
  const own = Array.from({ length: count }, () => new Color());
  const background = new Color();
  own.forEach((color, i) => theme.bind(color, cableRole(i)));
  theme.bind(background, 'background');
  return (lit) => own.map((color, i) => (lit === null || lit === i ? color : color.clone().lerp(background, FADED)));
}

/**
 * The cables, each in its colour; `move` brings the platform end of the cables to a position and rotation of the
 * platform, `light` brings out the one with an index (null: none), `strands` has the points of each from outlet to platform.
 * `moveOutlet` brings an outlet to a place; its cable is drawn there with the next `move`. If cables bend, `hang` shows them
 * as they hang, which they do at first, or straight; `wheels` are drawn while they hang.
 */
export function createCables(model, frame, theme) {
  const cables = model.cables.map((cable) => layCable(cable, frame));
  const strands = cables.map(({ points }) => points);
  const pairs = strands.flatMap(chain);
  const thick = cables.filter(({ radius }) => radius > 0);
  const pieces = thick.flatMap((cable) => cable.points.slice(1).map((to, i) => ({ from: cable.points[i], to, cable })));
  const lines = wideLines(pairs, { linewidth: 1.75, vertexColors: true });
  const most = Math.max(2, ...strands.map(({ length }) => length));
  const lit = wideLines(chain(Array(most).fill(new Vector3())), { linewidth: 4.5 });
  const tubes = createTubes(pieces.length);
  const wheels = createWheels(cables, theme);
  const colorsFor = createColors(cables.length, theme);
  const matrix = new Matrix4();
  let index = null;
  let hangs = true;
  lit.visible = false;
  lit.renderOrder = 5;
  if (most > 2) covering(lit);

  function paint() {
    const colors = colorsFor(index);
    lines.geometry.setColors(colors.flatMap((color, i) => chain(strands[i]).flatMap(() => color.toArray())));
    pieces.forEach(({ cable }, i) => tubes.setColorAt(i, colors[cables.indexOf(cable)]));
    if (tubes.instanceColor) tubes.instanceColor.needsUpdate = true;
    if (index !== null) lit.material.color.copy(colors[index]);
  }

  function showLit() {
    lit.visible = index !== null;
    if (index === null) return;
    lit.geometry.instanceCount = strands[index].length - 1;
    moveWideLines(lit, chain(strands[index]));
  }

  function light(wanted) {
    index = wanted !== null && wanted < cables.length ? wanted : null;
    paint();
    showLit();
  }

  function draw() {
    for (const cable of cables) cable.lay(hangs);
    moveWideLines(lines, pairs);
    pieces.forEach(({ from, to, cable }, i) => {
      const beyond = cable.points.length > 2 ? OVERLAP * cable.radius : 0;
      tubes.setMatrixAt(i, tubeMatrix(from, to, cable.radius, beyond, matrix));
    });
    tubes.instanceMatrix.needsUpdate = true;
    wheels.lay();
    showLit();
  }

  function move(position, rotation) {
    for (const cable of cables) cable.end.copy(cable.arm).applyQuaternion(rotation).add(position);
    draw();
  }

  function hang(wanted) {
    hangs = wanted;
    for (const wheel of wheels.objects) wheel.visible = hangs;
    draw();
  }

  if (cables.length > 0) paint();
  theme.watch(paint);
  const moveOutlet = (index, place) => cables[index].outlet.copy(place);
  const parts = cables.length > 0 ? [lines, tubes, lit] : [];
  return { parts, strands, wheels: wheels.objects, light, move, moveOutlet, hang };
}

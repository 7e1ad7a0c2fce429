// The gap of the tightest pairs where the platform is, as a segment between their nearest points; and an outline of who
// is too near.

import { Group, Vector3 } from 'three';
import { chain, covering, dots, moveWideLines, wideLines } from './marks.js';
import { rotationOf } from './robot.js';
import { buildShapes } from './shapes.js';
import { formatApproach } from './wording.js';

const OUTLINE_WIDTH = 3.5;
const GAP_WIDTH = 3;
const GAP_DOT = 7;
const ORDER = 8;

// Visible while all of the conditions hold, which are asked for each picture.
function showWhile(object, ...conditions) {
  Object.defineProperty(object, 'visible', { get: () => conditions.every((holds) => holds()), set: () => {} });
  return object;
}

function overAll(object) {
  object.material.depthTest = false;
  object.material.transparent = true;
  object.renderOrder = ORDER;
  return object;
}

// The segment of one group of pairs: `show` moves it, `middle` is where its label is.
function createGap(frame, theme, isSeen) {
  const ends = [new Vector3(), new Vector3()];
  const line = overAll(wideLines(ends, { linewidth: GAP_WIDTH }));
  const marks = overAll(dots(ends, GAP_DOT));
  for (const part of [line, marks]) theme.paint(part.material, 'highlight');
  let shown = null;
  const group = showWhile(new Group(), () => shown !== null && shown.culprits.every(isSeen));
  group.add(line, marks);
  const middle = new Vector3();
  const show = (gap) => {
    shown = gap?.ends ? gap : null;
    if (!shown) return;
    shown.ends.forEach((end, i) => frame.point(end, ends[i]));
    moveWideLines(line, ends);
    const places = marks.geometry.attributes.position;
    ends.forEach((end, i) => places.setXYZ(i, end.x, end.y, end.z));
    places.needsUpdate = true;
    middle.copy(ends[0]).lerp(ends[1], 0.5);
  };
  return { group, middle, show, text: () => (shown ? formatApproach(shown.gap) : '') };
}

// Outlines of platform, cables and obstacles, made when they are first asked for.
function createOutlines(model, frame, { shapes, strands }, theme, isSeen) {
  const all = new Group();
  const outlines = new Map();
  let shown = [];
  const place = { position: new Vector3(), rotation: rotationOf(model.orientation) };

  function cableOutline(strand) {
    const pairs = chain(strand);
    const mark = wideLines(pairs, { linewidth: OUTLINE_WIDTH });
    if (strand.length > 2) covering(mark);
    return { mark, move: () => moveWideLines(mark, pairs) };
  }

  function platformOutline() {
    const mark = wideLines([...shapes.edges, ...shapes.segments], { linewidth: OUTLINE_WIDTH });
    const move = () => {
      mark.position.copy(place.position);
      mark.quaternion.copy(place.rotation);
    };
    return { mark, move };
  }

  function obstacleOutline(obstacle) {
    const { edges, segments } = buildShapes(obstacle.parts, (v) => frame.point(v));
    return { mark: wideLines([...edges, ...segments], { linewidth: OUTLINE_WIDTH }), move: () => {} };
  }

  function create(name) {
    const cable = model.cables.findIndex((one) => one.name === name);
    const obstacle = model.obstacles.find((one) => one.name === name);
    if (cable >= 0) return cableOutline(strands[cable]);
    return obstacle ? obstacleOutline(obstacle) : platformOutline();
  }

  function outlineOf(name) {
    if (outlines.has(name)) return outlines.get(name);
    const outline = create(name);
    theme.paint(outline.mark.material, 'violation');
    outline.mark.renderOrder = 6;
    showWhile(outline.mark, () => shown.includes(name), () => isSeen(name));
    outlines.set(name, outline);
    all.add(outline.mark);
    return outline;
  }

  function refresh() {
    for (const name of shown) outlineOf(name).move();
  }

  return {
    all,
    show: (names) => {
      shown = names;
      refresh();
    },
    move: (position, rotation) => {
      place.position.copy(position);
      place.rotation.copy(rotation);
      refresh();
    },
  };
}

// Groups without an object would have no row in the legend.
const isUseful = ({ motion, result }) => motion?.approaches.length > 0 || Boolean(result?.reason);

/**
 * `robot` has the shapes of the platform and the strands of the cables, which others move. `objects` belong to a layer.
 * `show` shows the gaps at a place along the path and outlines who is too near, `move` follows the platform, `see` sets what
 * tells whether an obstacle with a name is seen; `gaps` have texts for labels.
 */
export function createHighlight(model, frame, robot, theme) {
  if (!isUseful(model)) return { objects: [], gaps: [], show: () => {}, move: () => {}, see: () => {} };
  let sees = () => true;
  const isSeen = (name) => sees(name);
  const outlines = createOutlines(model, frame, robot, theme, isSeen);
  const gaps = (model.motion?.approaches ?? []).map(() => createGap(frame, theme, isSeen));
  const always = model.motion ? [] : [...new Set(model.result.reasons.flatMap(({ culprits }) => culprits))];

  function show(nearest) {
    gaps.forEach((gap, i) => gap.show(nearest?.gaps[i]?.tight ? nearest.gaps[i] : null));
    outlines.show(nearest?.bad ? nearest.culprits : always);
  }

  show(null);
  return {
    objects: [outlines.all, ...gaps.map(({ group }) => group)],
    gaps,
    show,
    move: outlines.move,
    see: (value) => {
      sees = value;
    },
  };
}

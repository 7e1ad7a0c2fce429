// The course of a cable with a pulley or weight: round the wheel, then hanging below the straight line to its end.
//
// The core has the mathematics, in `geometry/pulley.rs` and `model/envelope.rs`. Points are arrays, in any unit of length.

// Pieces of the arc on the wheel, and of the hanging part.
const ARC_PIECES = 16;
const HANGING_PIECES = 24;

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const moved = (p, by, along) => [p[0] + by * along[0], p[1] + by * along[1], p[2] + by * along[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (v) => Math.hypot(v[0], v[1], v[2]);
const unit = (v) => moved([0, 0, 0], 1 / length(v), v);

// Any unit vector across an axis.
function acrossOf(axis) {
  const size = axis.map(Math.abs);
  return unit(cross(axis, [0, 1, 2].map((i) => (i === size.indexOf(Math.min(...size)) ? 1 : 0))));
}

// The point of the wheel after an angle from the outlet on.
const onWheel = (outlet, { radius, axis }, side, angle) =>
  moved(moved(outlet, radius * (1 - Math.cos(angle)), side), radius * Math.sin(angle), axis);

/**
 * How the taut cable to `end` leaves its pulley: the angle that it touches the wheel, the unit vector from the swivel axis to
 * the side on which the wheel is, and the exit. Where it cannot leave the wheel, it begins at the outlet.
 */
export function departure(outlet, pulley, end) {
  const line = minus(end, outlet);
  const height = dot(pulley.axis, line);
  const across = moved(line, -height, pulley.axis);
  const distance = length(across);
  const side = distance > 0 ? unit(across) : acrossOf(pulley.axis);
  const beyond = distance - 2 * pulley.radius;
  const square = distance * beyond + height * height;
  if (!(square > 0) || (height < 0 && beyond < 0)) return { wrap: 0, side, exit: outlet };
  const free = Math.sqrt(square);
  const wrap = 2 * (height >= 0 ? Math.atan2(distance, height + free) : Math.atan2(free - height, beyond));
  return { wrap, side, exit: onWheel(outlet, pulley, side, wrap) };
}

// A cable that hangs leaves its wheel in the direction in which it begins: to a point below its end. It is found in two steps, as
// the chord hardly changes.
function start({ outlet, pulley, sag }, end) {
  if (!pulley) return { exit: outlet };
  let from = departure(outlet, pulley, end);
  for (let step = 0; sag && step < 2; step += 1) {
    const chord = length(minus(end, from.exit));
    from = departure(outlet, pulley, moved(end, -sag.curvature * chord * chord, sag.up));
  }
  return from;
}

// Points of the parabola from `from` to `end`, which is curvature · a · b below the chord at the distances a and b from its ends.
function hanging({ up, curvature }, from, end) {
  const line = minus(end, from);
  const depth = curvature * dot(line, line);
  return Array.from({ length: HANGING_PIECES }, (_, i) => {
    const share = (i + 1) / HANGING_PIECES;
    return share === 1 ? end : moved(moved(from, share, line), -depth * share * (1 - share), up);
  });
}

/** Whether a cable is anything but a straight line from its outlet. */
export const bends = ({ pulley, sag }) => Boolean(pulley || sag);

/**
 * The points of a cable from its outlet to its end, always equally many; `pulley` has the radius and the axis, `sag` the
 * curvature and the direction `up`. And its wheel, if it has one: the centre and the direction of the axle.
 */
export function courseOf(cable, end) {
  const { outlet, pulley, sag } = cable;
  const { exit, wrap, side } = start(cable, end);
  const arc = (_, i) => onWheel(outlet, pulley, side, (wrap * (i + 1)) / ARC_PIECES);
  const onArc = pulley ? Array.from({ length: ARC_PIECES }, arc) : [];
  const wheel = pulley ? { centre: moved(outlet, pulley.radius, side), axle: cross(pulley.axis, side) } : null;
  return { points: [outlet, ...onArc, ...(sag ? hanging(sag, exit, end) : [end])], wheel };
}

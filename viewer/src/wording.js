// Sentences and numbers as the reader sees them.

const UNITS = [
  { from: 1000, factor: 1e-3, digits: 3, name: 'km' },
  { from: 0.1, factor: 1, digits: 3, name: 'm' },
  { from: 1e-3, factor: 1e3, digits: 2, name: 'mm' },
  { from: 0, factor: 1e6, digits: 1, name: 'µm' },
];

const FORCES = [
  { from: 1e4, factor: 1e-3, digits: 2, name: 'kN' },
  { from: 100, factor: 1, digits: 0, name: 'N' },
  { from: 0, factor: 1, digits: 1, name: 'N' },
];

const unitFor = (units, size) => units.find((unit) => Math.abs(size) >= unit.from);

// Without the sign of a zero.
const rounded = (value, digits) => value.toFixed(digits).replace(/^-(?=[0.]*$)/, '');

const axisOf = ({ factor, digits, name }) => ({
  unit: name,
  /** A number in this unit. */
  inUnit: (value) => value * factor,
  /** A number in this unit, without the unit; a dash where there is none. */
  format: (value) => (Number.isFinite(value) ? rounded(value * factor, digits) : '–'),
  /** A number in this unit, with the unit and without needless digits: "1.5 m/s". */
  brief: (value) => `${Number((value * factor).toPrecision(4))}\u00a0${name}`,
});

/** The unit of lengths up to this one, m. */
export const lengthAxis = (largest) => axisOf(unitFor(UNITS, largest));

const per = (time) => (greatest) => {
  const unit = unitFor(UNITS, greatest);
  return axisOf({ ...unit, name: `${unit.name}/${time}` });
};

/** The unit of speeds up to this one, m/s. */
export const speedAxis = per('s');

/** The unit of accelerations up to this one, m/s². */
export const accelerationAxis = per('s²');

/** The unit of angular speeds, rad/s. */
export const turnSpeedAxis = () => axisOf({ factor: 1, digits: 2, name: 'rad/s' });

/** The unit of times, s. */
export const timeAxis = axisOf({ factor: 1, digits: 2, name: 's' });

const MOST_TICKS = 6;

/** Round numbers from 0 to a length or a duration. */
export function roundTicks(whole) {
  const least = whole / MOST_TICKS;
  const decade = 10 ** Math.floor(Math.log10(least));
  const step = decade * [1, 2, 5, 10].find((factor) => factor * decade >= least);
  return Array.from({ length: Math.floor(whole / step) + 1 }, (_, i) => Number((i * step).toPrecision(6)));
}

/** A time of a whole: "0.50 of 4.35 s". */
export const formatTimeProgress = (time, whole) => `${timeAxis.format(time)} of ${timeAxis.format(whole)}\u00a0s`;

/** A share of a whole: "38 %". */
export const formatShare = (share) => `${share < 0.01 ? '<\u00a01' : Math.round(100 * share)}\u00a0%`;

const LIMIT_NAMES = {
  turn_speed: 'angular speed',
  turn_acceleration: 'angular acceleration',
  cable_speed: 'cable speed',
  cable_acceleration: 'cable acceleration',
};

/** A limit in words: "tension of cable 3", "speed of cable 3", "acceleration". */
export function describeLimit({ kind, cable }) {
  const name = LIMIT_NAMES[kind] ?? kind;
  return cable ? `${name.replace(/^cable /, '')} of ${cable}` : name;
}

/** What limits the motion for a while: "tension of cable 3, 0.50 to 0.90 s". */
export const describePiece = (entry) =>
  `${describeLimit(entry)}, ${timeAxis.format(entry.from)} to ${timeAxis.format(entry.to)}\u00a0s`;

const CORNERS = { stop: 'stop', rounded: 'rounded', outward: 'rounded outward' };

/** How a waypoint is passed: "waypoint 1 at 1.20 s: rounded, 12 mm off the path". */
export function describeCorner({ waypoint, kind, deviation, time }) {
  const off = deviation > 0 ? `, ${formatGap(deviation)} off the path` : '';
  return `waypoint ${waypoint} at ${timeAxis.format(time)}\u00a0s: ${CORNERS[kind] ?? kind}${off}`;
}

/** How the waypoints are passed: "corners: 2 rounded (at most 12 mm off the path), 1 stop". */
export function describeCorners(corners) {
  const of = (kind) => corners.filter((corner) => corner.kind === kind);
  const parts = Object.keys(CORNERS).filter((kind) => of(kind).length > 0).map((kind) => {
    const most = Math.max(...of(kind).map(({ deviation }) => deviation));
    const off = most > 0 ? ` (at most ${formatGap(most)} off the path)` : '';
    const name = kind === 'stop' && of(kind).length > 1 ? 'stops' : CORNERS[kind];
    return `${of(kind).length} ${name}${off}`;
  });
  return parts.length > 0 ? `corners: ${parts.join(', ')}` : '';
}

const OTHER_LIMITS = { jerk: ['jerk', 'm/s³'], cableAcceleration: ['cable acceleration', 'm/s²'], wrenchMargin: ['wrench margin', 'N'] };

/** The limits that are not in a chart: "other limits: jerk 40 m/s³". */
export function describeOtherLimits(limits) {
  const known = Object.entries(OTHER_LIMITS).filter(([key]) => limits[key] !== null);
  const parts = known.map(([key, [name, unit]]) => `${name} ${formatNumber(limits[key], unit)}`);
  return parts.length > 0 ? `other limits: ${parts.join(', ')}` : '';
}

/** The unit of forces up to this one, N. */
export const forceAxis = (largest) => axisOf(unitFor(FORCES, largest));

/** A unit for numbers up to this one, with four digits. */
export function numberAxis(largest, name) {
  const digits = Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(largest || 1))));
  return axisOf({ factor: 1, digits, name });
}

/** A length with three decimals or so: "2.621 m". */
export function formatLength(metres) {
  if (metres === 0) return '0 m';
  const { unit, format } = lengthAxis(metres);
  return `${format(metres)}\u00a0${unit}`;
}

/** A volume with four digits: "1.797 m³". */
export const formatVolume = (cubicMetres) => `${Number(cubicMetres.toPrecision(4))}\u00a0m³`;

/** A distance in the unit of a whole: "0.050 of 2.621 m". */
export function formatProgress(distance, whole) {
  const { unit, format } = lengthAxis(whole);
  return `${format(distance)} of ${format(whole)}\u00a0${unit}`;
}

/** A position in a unit that suits the whole scene: "(0.300, 1.000, 0.300) m". */
export function formatPosition(position, size) {
  const { unit, format } = lengthAxis(size);
  return `(${position.map(format).join(', ')})\u00a0${unit}`;
}

/** A small gap without needless digits: "12 mm". */
export function formatGap(metres) {
  if (metres >= 1) return `${Number(metres.toPrecision(3))}\u00a0m`;
  const millimetres = metres * 1e3;
  if (millimetres >= 0.1) return `${Number(millimetres.toPrecision(3))}\u00a0mm`;
  return `${Number((metres * 1e6).toPrecision(3))}\u00a0µm`;
}

/** Gaps up to this are only touching, m: they are smaller than anything that can be built. */
export const TOUCHING = 1e-6;

/** A gap as a label: "62 mm", "touching", "75 mm deep". */
export function formatApproach(gap) {
  if (Math.abs(gap) < TOUCHING) return 'touching';
  return gap < 0 ? `${formatGap(-gap)} deep` : formatGap(gap);
}

/** Who has the least room where the platform is: "least room here: cable 3 and pillar, 62 mm apart, 50 mm required". */
export function describeLeastRoom({ culprits, gap, required }) {
  const who = culprits.join(' and ');
  if (gap < 0 && gap < required) return `in collision here: ${who}, ${formatGap(-gap)} deep`;
  if (required <= 0) return gap < TOUCHING ? `nearest here: ${who} touch` : `nearest here: ${who}, ${formatGap(gap)} apart`;
  const which = gap < required ? 'too near' : 'least room';
  return `${which} here: ${who}, ${formatGap(gap)} apart, ${formatGap(required)} required`;
}

/** A wrench margin or another number with its unit: "12.34 N". */
export const formatNumber = (value, unit) => (Number.isFinite(value) ? `${Number(value.toPrecision(4))}\u00a0${unit}` : '–');

/** A wrench margin in words: "capacity margin: 12.34 N beyond the demand". */
export function describeWrench({ measure, unit }, value) {
  if (!Number.isFinite(value)) return `${measure} margin: none here, a cable has no direction`;
  const side = value < 0 ? 'short of' : 'beyond';
  return `${measure} margin: ${formatNumber(Math.abs(value), unit)} ${side} the demand`;
}

/** What is drawn of a search tree: all of it, or some of its edges. */
export function describeTree({ count, every }) {
  const edges = `${count.toLocaleString('en')} edges`;
  return every > 1 ? `search tree (${edges}, 1 in ${every} drawn)` : `search tree (${edges})`;
}

/** What the colours of the wrench-feasible workspace mean. */
export function describeFeasible({ measure, unit, greatest }) {
  return `${measure} margin beyond the demand, 0 to ${Number(greatest.toPrecision(3))} ${unit}; forces only: obstacles do not count`;
}

/** Bounds of a volume: "1.797 to 1.805 m³". */
export function describeVolume([min, max]) {
  const least = formatVolume(min);
  return least === formatVolume(max) ? least : `${least.replace('\u00a0m³', '')} to ${formatVolume(max)}`;
}

const percent = (share) => `${(100 * share).toFixed(1)}\u00a0%`;

const TAKES = { workspace: 'leaving the workspace', wrench: 'wrenches that the cables cannot provide', 'cable-length': 'lengths of cables' };

// What a kind of condition takes: "cable-obstacle takes 67.9 %, cable 3 / pillar most of it (21.0 %)".
function describeTaken({ condition, share, names, most, pairs }) {
  const name = TAKES[condition] ?? condition.replace('-', ' and ');
  const worst = pairs > 1 ? `, ${names} most of it (${percent(most)})` : '';
  return `${name}: ${percent(share)}${pairs === 1 ? `, ${names}` : worst}`;
}

// At which of several orientations positions are valid.
function describeValidAt(validAt, orientations) {
  if (validAt === 'turns') return `during the turns through ${orientations} orientations`;
  return `at ${validAt === 'any' ? 'any' : 'every one'} of ${orientations} orientations`;
}

// Bounds of a volume as shares of the whole: "26.8 to 26.9 %".
function describeShare({ volume, total }) {
  const [least, most] = volume.map((part) => percent(part / total));
  return least === most ? least : `${least.replace('\u00a0%', '')} to ${most}`;
}

/** What is proved of a workspace, in a few sentences. */
export function describeProved({ parts, apart, taken, orientations, validAt, ...proved }) {
  const share = `${describeShare(proved)} of where the platform is inside the workspace of the scene`;
  const whole = parts === 1 ? 'in one part' : `in ${parts} parts${apart ? ', start and goal in different ones' : ''}`;
  const lost = taken.length > 0 ? ['What takes the rest away:', ...taken.map(describeTaken)] : [];
  const at = orientations > 1 ? `, valid ${describeValidAt(validAt, orientations)}` : '';
  return [`${share}, ${whole}${at}`, ...lost];
}

/** The proved workspace of a scene that has changed, in one line, with the volume before. */
export function describeChanged(proved, before) {
  const was = before ? ` · before: ${describeVolume(before)}` : '';
  const lost = proved.taken.length > 0 ? ` · lost to ${describeTaken(proved.taken[0])}` : '';
  const at = proved.orientations > 1 ? ` ${describeValidAt(proved.validAt, proved.orientations)}` : '';
  return `valid${at}: ${describeVolume(proved.volume)} (${describeShare(proved)})${was}${lost}`;
}

/** Those who close the way together: "cable 1 and south". */
export const describeCulprits = (names) => names.join(' and ');

/** How far the platform gets. */
export function describeReached({ volume, ofVolume, toGoal }) {
  const share = ofVolume > 0 ? Math.floor((100 * volume) / ofVolume) : 0;
  const part = share >= 1 ? `at least ${share} % of its workspace` : 'less than 1 % of its workspace';
  return `The platform reaches ${part} (${formatVolume(volume)}) and comes within ${formatLength(toGoal)} of the goal.`;
}

/** A path without an obstacle: "without south: 2.065 m". */
export function describeDetour({ obstacle, cost }) {
  return cost === null ? `without ${obstacle}: still no path found` : `without ${obstacle}: ${formatLength(cost)}`;
}

/** What is proved, and what the picture shows of it. */
export const describeProof = ({ margin }) =>
  `Proved: no path keeps a gap of more than ${formatGap(margin)}. What can be reached is drawn as far as it is certain.`;

const NO_PATH = {
  no_path: { verdict: 'no path', tone: 'bad', headline: 'proved: there is none' },
  budget_spent: { verdict: 'none found', tone: 'warn', headline: 'no path within the budget' },
  start_invalid: { verdict: 'start not valid', tone: 'bad', headline: '' },
  goal_invalid: { verdict: 'goal not valid', tone: 'bad', headline: '' },
};

function verdictOf(status, violations) {
  if (violations > 0) return { verdict: 'not valid', tone: 'bad' };
  return { verdict: status === 'solved' ? 'solved' : 'valid', tone: 'good' };
}

// Lengths that differ by less than this share are the same.
const SAME_LENGTH = 1e-6;

/** The length that the file of a path states, m. */
export const statedLength = ({ path, result }) => result?.cost ?? path.cost;

/** Whether a path has been changed since it was written: its length is not what its file states. */
export function isEdited(model, length) {
  const stated = statedLength(model);
  return stated !== null && Math.abs(stated - length) > SAME_LENGTH * length;
}

/**
 * The outcome of planning or checking: the verdict, whether it is `good`, `bad`, or a warning, and the number that
 * matters most.
 */
export function describeOutcome(model, length) {
  const { path, trajectory, regions, violations, proved } = model;
  if (regions?.shown && !path) return { verdict: 'regions', tone: 'plain', headline: describeRegions(regions) };
  if (proved) return { verdict: 'workspace', tone: 'plain', headline: describeVolume(proved.volume) };
  if (!path) return { verdict: 'scene', tone: 'plain', headline: 'no path' };
  if (path.waypoints.length === 0) return NO_PATH[path.status] ?? { verdict: 'no path', tone: 'plain', headline: '' };
  const edited = !trajectory && isEdited(model, length);
  const { verdict, tone } = verdictOf(edited ? null : path.status, violations.length);
  const whole = `${formatLength(trajectory?.length ?? length)}`;
  return { verdict, tone, headline: trajectory ? `${whole} in ${timeAxis.format(trajectory.duration)}\u00a0s` : whole };
}

/** What is known about a shorter path, perhaps with `via` points: "at most 0.1 % above the shortest". */
export function describeBound(cost, bound, via = 0) {
  const through = via > 0 ? ` through the via point${via === 1 ? '' : 's'}` : '';
  const share = cost / bound - 1;
  if (share < 1e-6) return `the shortest path${through}`;
  return `at most ${formatPercent(share)} above the shortest${through}`;
}

// Rounded up, as it is a promise.
function formatPercent(share) {
  const percent = 100 * share;
  const unit = 10 ** (Math.floor(Math.log10(percent)) - 1);
  return `${Number((Math.ceil(percent / unit - 1e-9) * unit).toPrecision(2))}\u00a0%`;
}

/** How much longer a path is than the straight line: "23 % longer than the straight line". */
export function describeDirectness(cost, straight) {
  const share = cost / straight - 1;
  if (share < 1e-6) return 'the straight line, so the shortest path';
  return `${formatPercent(share)} longer than the straight line`;
}

/** The largest rates of a trajectory: "at most 1 m/s and 2 m/s², cables 0.9713 m/s and 1.983 m/s²". */
export function describePeaks({ speed, acceleration, cableSpeed, cableAcceleration, turnSpeed, turnAcceleration, tensions }) {
  const rates = (v, a) => `${speedAxis(v).brief(v)} and ${accelerationAxis(a).brief(a)}`;
  const parts = [`at most ${rates(speed, acceleration)}`, `cables ${rates(cableSpeed, cableAcceleration)}`];
  if (turnSpeed !== null) parts.push(`turns ${turnSpeedAxis().brief(turnSpeed)} and ${brief(turnAcceleration)}\u00a0rad/s²`);
  if (tensions) parts.push(`tensions ${tensions.map((force) => forceAxis(force).brief(force)).join(' to ')}`);
  return parts.join(', ');
}

const brief = (value) => `${Number(value.toPrecision(4))}`;

/** A time that planning took: "27 ms". */
export function formatSeconds(seconds) {
  if (seconds >= 1) return `${Number(seconds.toPrecision(3))}\u00a0s`;
  const milliseconds = 1e3 * seconds;
  return milliseconds < 1 ? '<\u00a01\u00a0ms' : `${Number(milliseconds.toPrecision(2))}\u00a0ms`;
}

/** Why a pose is not valid: "platform meets pillar, 225 mm deep". */
export const describeReason = (violation) => `${describeEvent(violation)}${describeGap(violation)}`;

const SPACES = {
  attachment: 'where the end of that cable cannot be',
  position: "where the platform's origin cannot be",
};

/** What the regions of a page are. */
export function describeRegions({ space, meshes }) {
  const shadows = meshes.every(({ kind }) => kind === 'cable-obstacle');
  const things = `${shadows ? 'shadow' : 'forbidden region'}${meshes.length === 1 ? '' : 's'}`;
  return `${meshes.length} ${things} in the space of ${space}s: ${SPACES[space] ?? space}`;
}

const SENTENCES = {
  workspace: (who) => `${who[0] ?? 'platform'} leaves the workspace`,
  'cable-length': (who) => `${who[0] ?? 'a cable'} is too short or too long`,
  wrench: () => 'the cables cannot balance the platform',
  tilt: () => 'the platform tilts further than the scene allows',
  'turning-axis': () => 'the platform turns about another axis than the scene allows',
};

function describeEvent({ kind, culprits, gap }) {
  if (SENTENCES[kind]) return SENTENCES[kind](culprits);
  const verb = gap > 0 ? 'comes too near' : 'meets';
  if (culprits.length >= 2) return `${culprits[0]} ${verb} ${culprits.slice(1).join(' and ')}`;
  return [...culprits, kind].join(': ');
}

function describeGap({ kind, gap, required }) {
  if (gap === null) return '';
  if (kind === 'workspace') return gap < 0 ? `, ${formatGap(-gap)} outside` : '';
  if (kind === 'cable-length') return gap < 0 ? `, by ${formatGap(-gap)}` : '';
  if (gap < 0) return Math.abs(gap) < TOUCHING ? '' : `, ${formatGap(-gap)} deep`;
  return gap > 0 ? `, only ${formatGap(gap)} apart, ${formatGap(required)} required` : '';
}

/** How many violations there are: "18 violations at 2 places". */
export function describeViolations(count, places) {
  const found = `${count} violation${count === 1 ? '' : 's'}`;
  return places < count ? `${found} at ${places} place${places === 1 ? '' : 's'}` : found;
}

/** A violation that begins at a distance along the path, or at a time, in one sentence. */
export function describeViolation(violation, distance) {
  const place = `after ${formatLength(distance)} (segment ${violation.segment})`;
  const where = violation.time === null ? place : `at ${timeAxis.format(violation.time)}\u00a0s`;
  return `${describeEvent(violation)} ${where}${describeGap(violation)}`;
}

/** What is wrong with a position, in one sentence: "platform meets pillar, 225 mm deep". */
export const describeInvalid = (violation) => `${describeEvent(violation)}${describeGap(violation)}`;

/**
 * What is known about how short a path is: from a lower bound on the length of every path or, without one, from the straight
 * line between its ends; empty where neither says anything.
 */
export function describeQuality(cost, { bound = null, straight = 0, via = 0 }) {
  if (bound > 0) return describeBound(cost, bound, via);
  return straight > 0 ? describeDirectness(cost, straight) : '';
}

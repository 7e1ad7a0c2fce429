// Reads the scene data of the page and fills in what is missing, so that the other modules need no checks.

const list = (value) => (Array.isArray(value) ? value : []);

const text = (value, fallback) => (typeof value === 'string' && value !== '' ? value : fallback);

const isPoint = (p) => Array.isArray(p) && p.length >= 3 && p.slice(0, 3).every(Number.isFinite);

const pointOrNull = (p) => (isPoint(p) ? p : null);

const numberOrNull = (x) => (Number.isFinite(x) ? x : null);

function readPart(part) {
  const vertices = list(part?.vertices);
  if (!vertices.every(isPoint)) return { vertices: vertices.filter(isPoint), faces: [] };
  const usable = (face) => Array.isArray(face) && face.length >= 3 && face.every((i) => vertices[i]);
  return { vertices, faces: list(part?.faces).filter(usable) };
}

const readParts = (parts) => list(parts).map(readPart).filter((part) => part.vertices.length > 0);

// Unit vectors come from the program.
function readPulley(pulley) {
  return pulley?.radius > 0 && isPoint(pulley.axis) ? { radius: pulley.radius, axis: pulley.axis } : null;
}

// The parabola: how far below its chord a cable hangs, per distance from either end, 1/m.
function readSag(sag) {
  if (!sag || !isPoint(sag.up)) return null;
  const curvature = (0.5 * sag.weight * sag.factor) / sag.tension;
  return Number.isFinite(curvature) && curvature > 0 ? { up: sag.up, curvature } : null;
}

function readCable(cable, index) {
  return {
    name: text(cable?.name, `cable ${index}`),
    outlet: pointOrNull(cable?.outlet),
    attachment: pointOrNull(cable?.attachment),
    diameter: Math.max(0, numberOrNull(cable?.diameter) ?? 0),
    pulley: readPulley(cable?.pulley),
    sag: readSag(cable?.sag),
  };
}

function readObstacle(obstacle, index) {
  return { name: text(obstacle?.name, `obstacle ${index}`), parts: readParts(obstacle?.parts) };
}

// Edges as x, y, z of both ends, one after the other.
function readTree(tree) {
  const ends = list(tree?.ends);
  if (ends.length < 6 || ends.length % 6 !== 0 || !ends.every(Number.isFinite)) return null;
  return { ends, count: numberOrNull(tree.count) ?? ends.length / 6, every: numberOrNull(tree.every) ?? 1 };
}

const isOrientation = (q) =>
  Array.isArray(q) && q.length === 4 && q.every(Number.isFinite) && Math.hypot(...q) > 0;

// The orientation at each waypoint and the weight of turns, m/rad; null if the platform keeps its orientation.
function readTurns({ orientations, waypoints, turn_weight: weight }) {
  const count = list(orientations).length;
  if (count === 0 || count !== list(waypoints).length) return null;
  if (!orientations.every(isOrientation) || !waypoints.every(isPoint)) return null;
  return { orientations, weight: Math.max(0, numberOrNull(weight) ?? 0) };
}

function readPath(path) {
  if (!path) return null;
  return {
    status: text(path.status, 'unknown'),
    planner: text(path.planner, null),
    waypoints: list(path.waypoints).filter(isPoint),
    turns: readTurns(path),
    rawWaypoints: list(path.raw_waypoints).filter(isPoint),
    cost: numberOrNull(path.cost),
    rawCost: numberOrNull(path.raw_cost),
    tree: readTree(path.tree),
  };
}

function readRegion(region, index) {
  const vertices = list(region?.vertices).filter(isPoint);
  const usable = (face) => Array.isArray(face) && face.length === 3 && face.every((i) => vertices[i]);
  const name = text(region?.name, `region ${index}`);
  const [owner = name] = list(region?.culprits).map(String);
  return { name, owner, kind: text(region?.kind, 'unknown'), vertices, faces: list(region?.triangles).filter(usable) };
}

function readRegions(regions) {
  if (!regions) return null;
  const meshes = list(regions.meshes).map(readRegion);
  return { space: text(regions.space, 'attachment'), shown: regions.shown !== false, meshes };
}

function readMargins({ measure, unit, values }) {
  return { measure: text(measure, 'wrench'), unit: text(unit, ''), values: list(values) };
}

// The tightest pair of a group of pairs at each place, with the nearest points of its members.
function readApproach(approach) {
  return {
    of: text(approach?.of, 'obstacles'),
    gap: list(approach?.gap),
    required: list(approach?.required),
    tightest: list(approach?.tightest),
    pairs: list(approach?.pairs).map((pair) => list(pair).map(String)),
    points: list(approach?.points),
  };
}

// For each place the group with the least room.
function tightestOf(approaches) {
  const room = ({ gap, required }, i) => gap[i] - required[i];
  const count = approaches[0]?.gap.length ?? 0;
  return Array.from({ length: count }, (_, i) =>
    approaches.reduce((best, one) => (room(one, i) < room(best, i) ? one : best)),
  );
}

// Numbers along the path; they come from the program, one column for each plot.
function readMotion(motion) {
  if (!motion || list(motion.s).length < 2) return null;
  const approaches = list(motion.approaches).map(readApproach).filter(({ gap }) => gap.length === motion.s.length);
  const tightest = tightestOf(approaches);
  return {
    s: motion.s,
    lengths: list(motion.lengths),
    approaches,
    // The tightest pair of all groups.
    clearance: tightest.map(({ gap }, i) => gap[i]),
    required: tightest.map(({ required }, i) => required[i]),
    culprits: tightest.map(({ pairs, tightest: of }, i) => pairs[of[i]]),
    tensions: list(motion.tensions),
    tensionLimits: list(motion.tension_limits),
    distribution: textOrNull(motion.distribution),
    margins: list(motion.margins).map(readMargins),
  };
}

const textOrNull = (value) => (typeof value === 'string' ? value : null);

const readNumbers = (record, keys) =>
  Object.fromEntries(Object.entries(keys).map(([name, key]) => [name, numberOrNull(record?.[key])]));

const LIMITS = {
  speed: 'speed',
  acceleration: 'acceleration',
  turnSpeed: 'turn_speed',
  turnAcceleration: 'turn_acceleration',
  jerk: 'jerk',
  cableSpeed: 'cable_speed',
  cableAcceleration: 'cable_acceleration',
  blend: 'blend',
  wrenchMargin: 'wrench_margin',
};

const LARGEST = {
  speed: 'speed',
  acceleration: 'acceleration',
  cableSpeed: 'cable_speed',
  cableAcceleration: 'cable_acceleration',
  turnSpeed: 'turn_speed',
  turnAcceleration: 'turn_acceleration',
};

// The largest rates of a trajectory, and its range of tensions, if they are known.
const readLargest = (largest) => ({
  ...readNumbers(largest, LARGEST),
  tensions: list(largest.tensions).length === 2 ? largest.tensions.map(numberOrNull) : null,
});

// An orientation for each time; null if the platform keeps its orientation.
function readOrientations(orientations, count) {
  const found = list(orientations);
  return found.length === count && found.every(isOrientation) ? found : null;
}

// Times and positions; the curves have the same times or their own.
function readTrajectory(trajectory) {
  const times = list(trajectory?.times);
  if (times.length < 2 || list(trajectory.positions).length !== times.length) return null;
  const curve = (raw) => ({ at: list(raw?.times ?? times), values: list(raw?.values) });
  return {
    duration: times.at(-1),
    length: numberOrNull(trajectory.length) ?? 0,
    limits: readNumbers(trajectory.limits, LIMITS),
    tensionLimits: list(trajectory.tension_limits),
    distribution: textOrNull(trajectory.distribution),
    limiting: list(trajectory.limiting).map(({ from, to, limit, cable }) => ({ from, to, kind: String(limit), cable })),
    corners: list(trajectory.corners),
    largest: trajectory.largest ? readLargest(trajectory.largest) : null,
    cables: list(trajectory.cables).map(String),
    times,
    positions: trajectory.positions,
    orientations: readOrientations(trajectory.orientations, times.length),
    turnSpeed: trajectory.turn_speed ? curve(trajectory.turn_speed) : null,
    speed: curve(trajectory.speed),
    acceleration: curve(trajectory.acceleration),
    cableSpeeds: list(trajectory.cable_speeds).map(curve),
    tensions: list(trajectory.tensions).map(curve),
  };
}

function readFeasible(feasible) {
  if (!feasible || !isPoint(feasible.origin) || !isPoint(feasible.counts)) return null;
  const margins = list(feasible.margins);
  const greatest = margins.reduce((most, margin) => Math.max(most, margin ?? 0), 0);
  const { origin, step, counts } = feasible;
  const measure = text(feasible.measure, 'margin');
  return { origin, step, counts, margins, greatest, measure, unit: text(feasible.unit, '') };
}

function readDetour(detour) {
  return {
    obstacle: text(detour?.obstacle, 'obstacle'),
    cost: numberOrNull(detour?.cost),
    waypoints: list(detour?.waypoints).filter(isPoint),
  };
}

// Faces of cubes; they come from the program.
const readFaces = (faces) => list(faces).filter((face) => Array.isArray(face) && face.length === 6);

function readNoPath(noPath) {
  if (!noPath || !list(noPath.bounds).every(isPoint) || !isPoint(noPath.nearest)) return null;
  const [min, max] = noPath.bounds;
  const culprits = list(noPath.culprits).map((names) => list(names).map(String));
  return {
    min,
    max,
    count: numberOrNull(noPath.count) ?? 1,
    culprits,
    blocking: list(noPath.blocking).map(String),
    volume: numberOrNull(noPath.volume) ?? 0,
    ofVolume: numberOrNull(noPath.of_volume) ?? 0,
    nearest: noPath.nearest,
    toGoal: numberOrNull(noPath.to_goal) ?? 0,
    margin: numberOrNull(noPath.margin) ?? 0,
    reachable: readFaces(noPath.reachable),
    walls: culprits.map((_, i) => readFaces(list(noPath.walls)[i])),
    without: list(noPath.without).map(readDetour),
  };
}

function readTaken({ condition, share, worst, pairs }) {
  const [names = null, most = null] = list(worst);
  return { condition: String(condition), share: numberOrNull(share) ?? 0, names, most, pairs: numberOrNull(pairs) ?? 0 };
}

/** Where the platform can be, as proved. */
export function readProved(proved) {
  if (!proved || !list(proved.bounds).every(isPoint)) return null;
  const [min, max] = proved.bounds;
  return {
    min,
    max,
    count: numberOrNull(proved.count) ?? 1,
    inside: readFaces(proved.inside),
    volume: [numberOrNull(proved.volume?.min) ?? 0, numberOrNull(proved.volume?.max) ?? 0],
    total: numberOrNull(proved.total) ?? 0,
    parts: numberOrNull(proved.parts) ?? 1,
    apart: Boolean(proved.apart),
    taken: list(proved.taken).map(readTaken),
    orientations: numberOrNull(proved.orientations) ?? 1,
    validAt: text(proved.valid_at, 'every'),
  };
}

function readViolation(violation) {
  return {
    segment: Math.max(0, Math.trunc(numberOrNull(violation?.segment) ?? 0)),
    at: Math.min(1, Math.max(0, numberOrNull(violation?.at) ?? 0)),
    time: numberOrNull(violation?.time),
    kind: text(violation?.kind, 'unknown'),
    culprits: list(violation?.culprits).map(String),
    gap: numberOrNull(violation?.gap),
    required: numberOrNull(violation?.required) ?? 0,
  };
}

// How planning went; null for paths that are not fresh from a planner.
function readResult(result) {
  if (!result) return null;
  return {
    reason: result.reason ? readViolation(result.reason) : null,
    // Everything that is wrong with the start or goal, worst first.
    reasons: list(result.reasons ?? [result.reason].filter(Boolean)).map(readViolation),
    nearestValid: isPoint(result.nearest_valid) ? result.nearest_valid : null,
    openingBelow: numberOrNull(result.opening_below),
    seed: numberOrNull(result.seed),
    seconds: numberOrNull(result.seconds),
    lowerBound: numberOrNull(result.lower_bound),
    // The waypoints at which the path passes its via points.
    via: list(result.route?.via).filter(Number.isInteger),
    // The length that the path's file states.
    cost: numberOrNull(result.cost),
  };
}

function readWorkspace(workspace) {
  const { min, max } = workspace ?? {};
  return isPoint(min) && isPoint(max) ? { min, max } : null;
}

const readOrientation = (q, fallback = [1, 0, 0, 0]) => (isOrientation(q) ? q : fallback);

/** The model of a page from its raw data. */
export function readModel(raw) {
  const cables = list(raw?.cables).map(readCable);
  const orientation = readOrientation(raw?.orientation);
  return {
    title: text(raw?.title, 'untitled scene'),
    workspace: readWorkspace(raw?.workspace),
    orientation,
    platform: readParts(raw?.platform),
    cables: cables.filter((cable) => cable.outlet && cable.attachment),
    obstacles: list(raw?.obstacles).map(readObstacle),
    start: pointOrNull(raw?.start),
    goal: pointOrNull(raw?.goal),
    startOrientation: readOrientation(raw?.start_orientation, orientation),
    goalOrientation: readOrientation(raw?.goal_orientation, orientation),
    path: readPath(raw?.path),
    result: readResult(raw?.result),
    regions: readRegions(raw?.regions),
    motion: readMotion(raw?.motion),
    trajectory: readTrajectory(raw?.trajectory),
    feasible: readFeasible(raw?.feasible),
    noPath: readNoPath(raw?.no_path),
    proved: readProved(raw?.proved_workspace),
    violations: list(raw?.violations).map(readViolation),
  };
}

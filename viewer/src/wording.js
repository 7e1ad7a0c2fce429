// Sentences and numbers as the reader sees them.

const UNITS = [
  { from: 1000, factor: 1e-3, digits: 3, name: 'km' },
  { from: 0.1, factor: 1, digits: 3, name: 'm' },
  { from: 1e-3, factor: 1e3, digits: 2, name: 'mm' },
  { from: 0, factor: 1e6, digits: 1, name: 'µm' },
];

function withUnit(metres, unit, digits) {
  return `${(metres * unit.factor).toFixed(digits)}\u00a0${unit.name}`;
}

const unitFor = (metres) => UNITS.find((unit) => Math.abs(metres) >= unit.from);

/** A length with three decimals or so: "2.621 m". */
export function formatLength(metres) {
  if (metres === 0) return '0 m';
  const unit = unitFor(metres);
  return withUnit(metres, unit, unit.digits);
}

/** A distance in the unit of a whole: "0.050 of 2.621 m". */
export function formatProgress(distance, whole) {
  const unit = unitFor(whole);
  return `${(distance * unit.factor).toFixed(unit.digits)} of ${withUnit(whole, unit, unit.digits)}`;
}

/** A small gap without needless digits: "12 mm". */
export function formatGap(metres) {
  if (metres >= 1) return `${Number(metres.toPrecision(3))}\u00a0m`;
  const millimetres = metres * 1e3;
  if (millimetres >= 0.1) return `${Number(millimetres.toPrecision(3))}\u00a0mm`;
  return `${Number((metres * 1e6).toPrecision(3))}\u00a0µm`;
}

/** A tension: "412.3 N", or a dash where there is none. */
export function formatForce(newtons) {
  if (!Number.isFinite(newtons)) return '–';
  if (Math.abs(newtons) >= 1e4) return `${(newtons / 1e3).toFixed(2)} kN`;
  return `${newtons.toFixed(Math.abs(newtons) >= 100 ? 0 : 1)} N`;
}

/** Who comes nearest to whom: "cable 3 and pillar, 12 mm apart". */
export function describeNearest({ culprits, gap }) {
  const who = culprits.join(' and ');
  if (gap < 0) return `in collision: ${who}, ${formatGap(-gap)} deep`;
  return gap === 0 ? `in collision: ${who} touch` : `nearest: ${who}, ${formatGap(gap)} apart`;
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
  return `${measure} margin beyond the demand, 0 to ${Number(greatest.toPrecision(3))} ${unit}`;
}

const NO_PATH = {
  budget_spent: 'no path found within the budget',
  start_invalid: 'no path: the start is not valid',
  goal_invalid: 'no path: the goal is not valid',
};

function verdict(status, violations) {
  if (violations > 0) return 'not valid';
  return status === 'solved' ? 'solved' : 'valid';
}

/** The outcome of planning or checking in one line. */
export function describeOutcome(path, length, violations) {
  if (!path) return 'no path';
  if (path.waypoints.length === 0) return NO_PATH[path.status] ?? 'no path';
  const said = verdict(path.status, violations);
  const cost = formatLength(path.cost ?? length);
  const raw = path.rawCost === null ? cost : formatLength(path.rawCost);
  return raw === cost ? `${said}: ${cost}` : `${said}: ${cost}, ${raw} before it was made shorter`;
}

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
};

function describeEvent({ kind, culprits, margin }) {
  if (SENTENCES[kind]) return SENTENCES[kind](culprits);
  const verb = margin > 0 ? 'comes too near' : 'meets';
  if (culprits.length >= 2) return `${culprits[0]} ${verb} ${culprits.slice(1).join(' and ')}`;
  return [...culprits, kind].join(': ');
}

function describeMargin({ kind, margin }) {
  if (margin === null) return '';
  const gap = formatGap(Math.abs(margin));
  if (kind === 'workspace') return margin < 0 ? `, ${gap} outside` : '';
  if (kind === 'cable-length') return margin < 0 ? `, by ${gap}` : '';
  if (margin < 0) return `, ${gap} deep`;
  return margin > 0 ? `, only ${gap} apart` : '';
}

/** A violation that begins at a distance along the path in one sentence. */
export function describeViolation(violation, distance) {
  const where = `after ${formatLength(distance)} (segment ${violation.segment})`;
  return `${describeEvent(violation)} ${where}${describeMargin(violation)}`;
}

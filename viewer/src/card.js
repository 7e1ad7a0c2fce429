// The result card: the verdict, how good the path is, where it is tightest, and how it was found.

import { html } from './charts.js';
import { describeOutcome, describePeaks, describeProved, describeQuality, describeReason } from './wording.js';
import { formatApproach, formatGap, formatLength, formatSeconds, isEdited, statedLength } from './wording.js';

// Reasons beyond these would fill the card.
const MOST_REASONS = 6;

const formatPosition = (point) => `(${point.map((x) => Number(x.toFixed(3))).join(', ')})`;

const byId = (id) => document.getElementById(id);

const GROUPS = { obstacles: 'nearest obstacle', robot: 'within the robot' };

const distance = (a, b) => Math.hypot(...a.slice(0, 3).map((x, i) => x - b[i]));

function showVerdict({ verdict, tone, headline }) {
  byId('status').replaceChildren(html('span', `chip ${tone}`, verdict));
  if (headline) byId('status').append(html('span', tone === 'plain' ? '' : 'headline', headline));
}

// What is known about how short the path is.
function quality({ path, result, trajectory }, length) {
  if (!path || path.waypoints.length < 2 || trajectory) return '';
  const straight = path.turns ? 0 : distance(path.waypoints[0], path.waypoints.at(-1));
  return describeQuality(length, { bound: result?.lowerBound, straight, via: result?.via.length });
}

function remarks(model, length) {
  const { path, result, trajectory, proved } = model;
  if (proved) return describeProved(proved);
  if (result?.reason) {
    const place = result.nearestValid ? [`a valid position near it: ${formatPosition(result.nearestValid)}`] : [];
    return [...result.reasons.slice(0, MOST_REASONS).map(describeReason), ...place];
  }
  if (result?.openingBelow > 0) return [`every path passes an opening narrower than ${formatGap(result.openingBelow)}`];
  if (trajectory) return trajectory.largest ? [describePeaks(trajectory.largest)] : [];
  if (!path || path.waypoints.length < 2) return [];
  if (isEdited(model, length)) return [`changed since it was planned: its file states ${formatLength(statedLength(model))}`];
  // How short a path is that cannot be followed says nothing.
  if (model.violations.length > 0) return [];
  const found = [quality(model, length)];
  const raw = path.rawCost === null ? '' : formatLength(path.rawCost);
  if (raw !== '' && raw !== formatLength(length)) found.push(`${raw} before it was made shorter`);
  return found.filter(Boolean);
}

// The place at which a group of pairs has the least room.
function tightestPlace({ gap, required }) {
  return gap.reduce((best, value, i) => (value - required[i] < gap[best] - required[best] ? i : best), 0);
}

function tightestButton(approach, s, jump) {
  const i = tightestPlace(approach);
  const [gap, required] = [approach.gap[i], approach.required[i]];
  const button = html('button', 'tightest');
  button.type = 'button';
  button.title = 'show this place';
  const demand = required > 0 ? `${formatGap(required)} required` : '';
  const value = html('span', gap < required ? 'value bad' : 'value', formatApproach(gap));
  button.append(
    html('span', 'what', GROUPS[approach.of] ?? approach.of),
    value,
    html('span', 'who', approach.pairs[approach.tightest[i]].join(' and ')),
    html('span', 'what', demand),
  );
  button.addEventListener('click', () => jump(s[i]));
  return button;
}

// How the path was found: "anytime, seed 0, 27 ms".
function provenance(model, length) {
  const { path, result, trajectory } = model;
  if (!path || (!trajectory && path.waypoints.length > 0 && isEdited(model, length))) return '';
  const parts = [path.planner];
  if (result?.seed !== null && result?.seed !== undefined) parts.push(`seed ${result.seed}`);
  if (result?.seconds > 0) parts.push(formatSeconds(result.seconds));
  return parts.filter(Boolean).join(' · ');
}

/** Fills the card; `jump` hears the place of the tightest pair that the reader chooses. */
export function showCard(model, length, jump) {
  showVerdict(describeOutcome(model, length));
  byId('remarks').replaceChildren(...remarks(model, length).map((text) => html('p', '', text)));
  const { motion } = model;
  const buttons = (motion?.approaches ?? []).map((approach) => tightestButton(approach, motion.s, jump));
  const title = html('p', 'more', `tightest on the whole ${model.trajectory ? 'motion' : 'path'}`);
  byId('tightest').replaceChildren(...(buttons.length > 0 ? [title, ...buttons] : []));
  byId('planner').textContent = provenance(model, length);
}

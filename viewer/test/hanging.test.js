// The course of cables, by hand.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { courseOf, departure } from '../src/hanging.js';

const near = (found, expected, within = 1e-12) =>
  found.forEach((x, i) => assert.ok(Math.abs(x - expected[i]) < within, `${found} is not ${expected}`));

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

// 1 N/m at 100 N on 10 m: 0.125 m, enlarged by 1 + q/4 = 1.025.
const SAG = { up: [0, 0, 1], curvature: 1.025 / 200 };
const DEEPEST = 0.125 * 1.025;
const UPRIGHT = { radius: 1, axis: [0, 0, 1] };

test('a cable hangs deepest in the middle, and its ends stay', () => {
  const { points, wheel } = courseOf({ outlet: [1, 2, 3], sag: SAG }, [1, 12, 3]);
  near(points[0], [1, 2, 3]);
  near(points.at(-1), [1, 12, 3]);
  near(points[(points.length - 1) / 2], [1, 7, 3 - DEEPEST]);
  assert.ok(points.every(([, , z]) => z >= 3 - DEEPEST - 1e-12));
  assert.equal(wheel, null);
});

test('a steep cable hangs as far below its chord, along gravity', () => {
  for (const up of [[0, 0, 1], [0, 1, 0], [-0.6, 0, 0.8]]) {
    const { points } = courseOf({ outlet: [0, 0, 8], sag: { ...SAG, up } }, [6, 0, 0]);
    near(points[(points.length - 1) / 2], minus([3, 0, 4], up.map((x) => DEEPEST * x)));
  }
});

test('half the chord has a quarter of the sag', () => {
  const { points } = courseOf({ outlet: [0, 0, 0], sag: SAG }, [5, 0, 0]);
  near(points[(points.length - 1) / 2], [2.5, 0, -DEEPEST / 4]);
});

test('a cable leaves its wheel at the tangent: a 3-4-5 triangle', () => {
  const { exit, wrap, side } = departure([0, 0, 0], UPRIGHT, [0, 2, 2]);
  near(exit, [0, 0.4, 0.8]);
  near(side, [0, 1, 0]);
  near([wrap], [2 * Math.atan(0.5)]);
});

test('below the outlet a cable goes over the wheel', () => {
  const { exit, wrap } = departure([0, 0, 0], UPRIGHT, [2, 0, -5]);
  near(exit, [2, 0, 0]);
  near([wrap], [Math.PI]);
});

test('without weight the course is an arc and a straight line, of the same number of points everywhere', () => {
  const cable = { outlet: [5, 0, 0], pulley: UPRIGHT };
  const { points, wheel } = courseOf(cable, [5, 2, 2]);
  near(points[0], [5, 0, 0]);
  near(points.at(-2), [5, 0.4, 0.8]);
  near(points.at(-1), [5, 2, 2]);
  near(wheel.centre, [5, 1, 0]);
  near(wheel.axle, [-1, 0, 0]);
  for (const point of points.slice(0, -1)) near([Math.hypot(...minus(point, wheel.centre))], [1]);
  for (const end of [[5, 0, 3], [5, 1, 0], [9, -3, -2]]) assert.equal(courseOf(cable, end).points.length, points.length);
});

test('on the axis and within the wheel a cable begins at its outlet', () => {
  for (const end of [[0, 0, 3], [0, 1, 0], [0, 1, -3]]) near(departure([0, 0, 0], UPRIGHT, end).exit, [0, 0, 0]);
});

test('a cable that hangs leaves its wheel without a kink', () => {
  const cable = { outlet: [0, 0, 0], pulley: UPRIGHT, sag: SAG };
  const { points, wheel } = courseOf(cable, [6, 5, -4]);
  const exit = points.find((_, i) => Math.hypot(...minus(points[i + 1], wheel.centre)) > 1 + 1e-9);
  const chord = minus([6, 5, -4], exit);
  const begins = minus(chord, SAG.up.map((x) => x * SAG.curvature * dot(chord, chord)));
  const radial = minus(exit, wheel.centre);
  near([Math.hypot(...radial)], [1]);
  near([dot(begins, radial) / Math.hypot(...begins), dot(begins, wheel.axle)], [0, 0], 2e-3);
});

// Where the platform can be: the surface of what is proved inside.

import { gridOf, surface } from './cubes.js';

const INSIDE = { opacity: 0.24, edges: 0.5, order: 4, solid: false };

/** The surface of the proved workspace of a model, if it has one. */
export function createVolume({ proved }, frame, theme) {
  return proved ? surface(proved.inside, 'reachable', INSIDE, { ...gridOf(proved, frame), theme }) : [];
}

// Where the platform can be: the surface of what is proved inside.

import { Group } from 'three';
import { gridOf, surface } from './cubes.js';
import { disposeAll } from './shapes.js';

const INSIDE = { opacity: 0.24, edges: 0.5, order: 4, solid: false };

/** The surface of the proved workspace of a model, if it has one. */
export function createVolume({ proved }, frame, theme) {
  return proved ? surface(proved.inside, 'reachable', INSIDE, { ...gridOf(proved, frame), theme }) : [];
}

/** Shows one surface after the other while the scene changes; null shows none. */
export function createChangingVolume({ stage, theme }, frame) {
  const group = new Group();
  group.name = 'proved';
  stage.scene.add(group);
  let painter = null;

  function clear() {
    painter?.release();
    for (const object of [...group.children]) disposeAll(object);
  }

  return (proved) => {
    clear();
    painter = theme.createPainter();
    const objects = createVolume({ proved }, frame, painter);
    if (objects.length > 0) group.add(...objects);
    stage.invalidate();
  };
}

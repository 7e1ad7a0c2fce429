// Groups of the scene that the reader can show and hide.

import { Group, Object3D } from 'three';
import { addLegendFold, addLegendNote, addLegendPlace, addLegendRow, legendGroup } from './panel.js';

// In the order of the legend, which has three groups.
const NAMES = {
  platform: { name: 'platform', swatch: 'solid', group: 'scene' },
  cables: { name: 'cables', swatch: 'rainbow', group: 'scene' },
  cableNames: { name: 'names of cables', swatch: 'letter', group: 'scene' },
  outlets: { name: 'outlets and frame', swatch: 'outline', group: 'scene' },
  obstacles: { name: 'obstacles', swatch: 'solid', group: 'scene' },
  obstacleNames: { name: 'names of obstacles', swatch: 'letter', group: 'scene' },
  workspace: { name: 'workspace', swatch: 'outline', group: 'scene' },
  startGoal: { name: 'start and goal', swatch: 'ghost', group: 'path' },
  finalPath: { name: 'final path', swatch: 'thick', group: 'path' },
  rawPath: { name: 'raw path', swatch: 'dashed', group: 'path' },
  detours: { name: 'path without an obstacle', swatch: 'thick', group: 'path' },
  searchTree: { name: 'search tree', swatch: 'hair', group: 'path' },
  nearest: { name: 'least room here', swatch: 'gap', group: 'analysis' },
  violations: { name: 'violations', swatch: 'cross', group: 'analysis' },
  reachable: { name: 'can be reached from the start', swatch: 'ghost', group: 'analysis' },
  walls: { name: 'wall that closes the way', swatch: 'solid', group: 'analysis' },
  culprits: { name: 'obstacles that close the way', swatch: 'outline', group: 'analysis' },
  nearestReachable: { name: 'nearest reachable position', swatch: 'ghost', group: 'analysis' },
  swept: { name: 'swept by cables', swatch: 'ghost', group: 'analysis' },
  proved: { name: 'proved workspace', swatch: 'ghost', group: 'analysis' },
  feasible: { name: 'wrench-feasible workspace', swatch: 'ramp', group: 'analysis' },
  regions: { name: 'forbidden regions', swatch: 'ghost', group: 'analysis' },
};

/** Something to put into layers whose content is not drawn in 3D. */
export const placeholder = () => new Object3D();

/** Something to show and hide, `shown` at first, with a legend row; `apply` hears of changes. */
export function createSwitch({ name, swatch, shown, apply, parent }) {
  let visible = shown;
  const layer = {
    get visible() {
      return visible;
    },
    set visible(value) {
      visible = Boolean(value);
      row.tick(visible);
      apply(visible);
    },
  };
  const row = addLegendRow(name, swatch, layer, parent ?? legendGroup('scene'));
  return Object.assign(layer, {
    fold: (title, open) => addLegendFold(title, open, row.element),
    below: () => addLegendPlace(row.element),
    note: (text) => addLegendNote(text, row.element),
  });
}

/** A layer for a group; an empty one has no legend row. */
export function createLayer(group, name, swatch, invalidate, shown = true, parent = undefined) {
  group.visible = shown;
  if (group.children.length === 0) return group;
  const apply = (visible) => {
    group.visible = visible;
    invalidate();
  };
  return createSwitch({ name, swatch, shown, apply, parent });
}

/**
 * A layer for each known name; `contents` maps names to objects, and layers without objects have no legend row.
 * `hidden` lists those that are off at first, `names` has other names for some.
 */
export function createLayers(contents, hidden, names, scene, invalidate) {
  const layers = {};
  for (const key of Object.keys(NAMES)) {
    const group = new Group();
    group.name = key;
    for (const object of contents[key] ?? []) group.add(object);
    scene.add(group);
    const { name, swatch, group: title } = NAMES[key];
    const shown = !hidden.includes(key);
    const parent = group.children.length > 0 ? legendGroup(title) : undefined;
    layers[key] = createLayer(group, names[key] ?? name, `${swatch} of-${key}`, invalidate, shown, parent);
  }
  return layers;
}

// Groups of the scene that the reader can show and hide.

import { Group } from 'three';
import { addLegendRow } from './panel.js';

const NAMES = {
  platform: { name: 'platform', swatch: 'solid' },
  obstacles: { name: 'obstacles', swatch: 'solid' },
  cables: { name: 'cables', swatch: 'line' },
  rawPath: { name: 'raw path', swatch: 'dashed' },
  finalPath: { name: 'final path', swatch: 'thick' },
  violations: { name: 'violations', swatch: 'cross' },
  startGoal: { name: 'start and goal', swatch: 'ghost' },
  workspace: { name: 'workspace', swatch: 'outline' },
  regions: { name: 'forbidden regions', swatch: 'ghost' },
};

/** A layer for a group; an empty one has no legend row. */
export function createLayer(group, name, swatch, invalidate) {
  const layer = {
    get visible() {
      return group.visible;
    },
    set visible(value) {
      group.visible = Boolean(value);
      tick(group.visible);
      invalidate();
    },
  };
  const isEmpty = group.children.length === 0;
  const tick = isEmpty ? () => {} : addLegendRow(name, swatch, layer);
  return layer;
}

/** A layer for each known name; `contents` maps names to objects, and layers without objects have no legend row. */
export function createLayers(contents, scene, invalidate) {
  const layers = {};
  for (const key of Object.keys(NAMES)) {
    const group = new Group();
    group.name = key;
    for (const object of contents[key] ?? []) group.add(object);
    scene.add(group);
    const { name, swatch } = NAMES[key];
    layers[key] = createLayer(group, name, `${swatch} of-${key}`, invalidate);
  }
  return layers;
}

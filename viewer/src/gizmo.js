// The three axes in a corner of the view; pressing one looks along it.

import { Vector3 } from 'three';

const SVG = 'http://www.w3.org/2000/svg';
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const REACH = 24;
const CENTRE = 36;

function svg(tag, attributes, parent) {
  const result = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  parent.append(result);
  return result;
}

function createAxis(name, parent, look) {
  const group = svg('g', { class: `axis axis-${name}` }, parent);
  const line = svg('line', { x1: CENTRE, y1: CENTRE }, group);
  const disc = svg('circle', { r: 8 }, group);
  const letter = svg('text', { 'text-anchor': 'middle', 'dominant-baseline': 'central' }, group);
  letter.textContent = name;
  group.addEventListener('click', () => look(name));
  const place = (x, y) => {
    for (const [key, value] of [['x2', x], ['y2', y]]) line.setAttribute(key, value.toFixed(1));
    for (const [key, value] of [['cx', x], ['cy', y]]) disc.setAttribute(key, value.toFixed(1));
    for (const [key, value] of [['x', x], ['y', y]]) letter.setAttribute(key, value.toFixed(1));
  };
  return { group, place };
}

/** The axes, drawn into an element; the function returned turns them as a camera sees them. */
export function createGizmo(container, look) {
  const picture = svg('svg', { viewBox: '0 0 72 72', width: 72, height: 72, 'aria-hidden': 'true' }, container);
  const axes = Object.entries(AXES).map(([name, direction]) => ({ ...createAxis(name, picture, look), direction }));
  const seen = new Vector3();
  let turned = null;
  return (camera) => {
    if (turned?.equals(camera.quaternion)) return;
    turned = camera.quaternion.clone();
    const back = camera.quaternion.clone().invert();
    const depths = axes.map(({ direction, place }) => {
      seen.set(...direction).applyQuaternion(back);
      place(CENTRE + REACH * seen.x, CENTRE - REACH * seen.y);
      return seen.z;
    });
    // Those that point to the reader are drawn last.
    const order = axes.map(({ group }, i) => ({ group, depth: depths[i] })).sort((a, b) => a.depth - b.depth);
    if (order.some(({ group }, i) => picture.children[i] !== group)) picture.append(...order.map(({ group }) => group));
  };
}

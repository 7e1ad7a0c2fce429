// Which cable the reader points at, in space, in a chart or in the table: it is brought out in all of them.

import { Vector3 } from 'three';

// Listeners by name, so that those of a new model replace those of the one before.
const listeners = new Map();
let lit = null;

/** Brings out the cable with an index; null brings out none. */
export function spotlight(index) {
  if (index === lit) return;
  lit = index;
  for (const listener of listeners.values()) listener(lit);
}

/** Hears which cable is brought out, in place of an earlier listener of the same name. */
export function watchSpotlight(name, listener) {
  listeners.set(name, listener);
  listener(lit);
}

/** Makes an element of the page stand for a cable while the pointer or the focus is on it. */
export function pointsAtCable(element, index) {
  for (const event of ['pointerenter', 'focusin']) element.addEventListener(event, () => spotlight(index));
  for (const event of ['pointerleave', 'focusout']) element.addEventListener(event, () => spotlight(null));
}

// As near as this to a cable the pointer is on it, px.
const NEAR = 7;

function distanceTo(x, y, a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const t = Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy || 1)));
  return Math.hypot(x - a.x - t * dx, y - a.y - t * dy);
}

/** Brings out the cable in space that the mouse is on; `strands` are the points of each cable. */
export function watchPointer(stage, strands, isSeen, signal) {
  const { canvas } = stage;
  const onScreen = (point) => {
    const { x, y } = new Vector3().copy(point).project(stage.camera);
    return { x: ((x + 1) / 2) * canvas.clientWidth, y: ((1 - y) / 2) * canvas.clientHeight };
  };
  const follow = ({ pointerType, buttons, offsetX, offsetY }) => {
    if (pointerType !== 'mouse' || buttons !== 0) return;
    let best = { index: null, distance: NEAR };
    for (let index = 0; isSeen() && index < strands.length; index += 1) {
      const points = strands[index].map(onScreen);
      for (let i = 1; i < points.length; i += 1) {
        const distance = distanceTo(offsetX, offsetY, points[i - 1], points[i]);
        if (distance < best.distance) best = { index, distance };
      }
    }
    spotlight(best.index);
  };
  canvas.addEventListener('pointermove', follow, { signal });
  canvas.addEventListener('pointerleave', () => spotlight(null), { signal });
}

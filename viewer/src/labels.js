// Short texts that follow points of the 3D view.

import { Vector3 } from 'three';

/** Labels over the view; `place` is called after each picture. */
export function createLabels(container) {
  const labels = [];
  const projected = new Vector3();

  function add(text, anchor, layer) {
    const element = document.createElement('span');
    element.className = 'label';
    element.textContent = text;
    container.append(element);
    labels.push({ element, anchor, layer });
  }

  function placeOne({ element, anchor, layer }, camera, { clientWidth, clientHeight }) {
    projected.copy(anchor).project(camera);
    const hidden = !layer.visible || Math.abs(projected.z) > 1;
    element.hidden = hidden;
    const x = ((projected.x + 1) / 2) * clientWidth;
    const y = ((1 - projected.y) / 2) * clientHeight;
    if (!hidden) element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  function place(camera, view) {
    for (const label of labels) placeOne(label, camera, view);
  }

  return { add, place };
}

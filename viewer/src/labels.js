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
    labels.push({ element, anchor, layer, x: 0, y: 0 });
  }

  function placeOne(label, camera, { clientWidth, clientHeight }) {
    const { element, anchor, layer } = label;
    projected.copy(anchor).project(camera);
    const hidden = !layer.visible || Math.abs(projected.z) > 1;
    element.hidden = hidden;
    label.x = ((projected.x + 1) / 2) * clientWidth;
    label.y = ((1 - projected.y) / 2) * clientHeight;
    if (!hidden) element.style.transform = `translate(${label.x.toFixed(1)}px, ${label.y.toFixed(1)}px)`;
  }

  function place(camera, view) {
    for (const label of labels) placeOne(label, camera, view);
  }

  /** A picture with the labels that are seen written into it. */
  function written(canvas, { clientWidth }) {
    const ratio = canvas.width / clientWidth;
    const context = canvas.getContext('2d');
    context.font = `${12 * ratio}px system-ui, sans-serif`;
    context.textBaseline = 'top';
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--text');
    for (const { element, x, y } of labels) {
      if (!element.hidden) context.fillText(element.textContent, (x + 13) * ratio, (y + 8) * ratio);
    }
    return canvas;
  }

  return { add, place, written };
}

// Short texts that follow points of the 3D view.

import { Vector3 } from 'three';

// More labels than this are left where they are, one over the other.
const MOST_NUDGED = 40;

const overlap = (a, b) =>
  Math.abs(a.x - b.x) < (a.x < b.x ? a : b).width && Math.abs(a.y - b.y) < (a.y < b.y ? a : b).height;

// Moves labels down until none lies over an earlier one.
function nudge(labels) {
  const placed = [];
  for (const label of labels) {
    const covered = () => placed.find((other) => overlap(label, other));
    for (let other = covered(); other; other = covered()) label.y = other.y + other.height + 1;
    placed.push(label);
  }
}

// How far right of its point and below it a label is, px; numbers of cables are level with their outlets.
const ASIDE = { x: 8, y: 6 };
const LEVEL = { x: 7, y: -9 };

/** Labels over the view; `place` is called after each picture, with the camera and the size of the view, px. */
export function createLabels(container) {
  let labels = [];
  const projected = new Vector3();

  /** Adds a label; one with a function for its text says at each picture what that returns, an empty text hides it. */
  function add(text, anchor, layer, className = '') {
    const element = document.createElement('span');
    element.className = `label ${className}`;
    container.append(element);
    const says = typeof text === 'function' ? text : () => text;
    const aside = className.startsWith('cable') ? LEVEL : ASIDE;
    labels.push({ element, says, anchor, layer, aside, x: 0, y: 0, width: 0, height: 0 });
  }

  function write(label) {
    const text = label.says();
    if (text === label.element.textContent) return;
    label.element.textContent = text;
    label.width = 0;
  }

  function project(label, camera, { width, height }) {
    const { element, anchor, layer } = label;
    write(label);
    projected.copy(anchor).project(camera);
    const hidden = !layer.visible || element.textContent === '' || Math.abs(projected.z) > 1;
    element.hidden = hidden;
    label.x = ((projected.x + 1) / 2) * width + label.aside.x;
    label.y = ((1 - projected.y) / 2) * height + label.aside.y;
  }

  // After all of them are written: each size that is asked for between two changes lays out the page anew.
  function measure(label) {
    if (label.width === 0) ({ offsetWidth: label.width, offsetHeight: label.height } = label.element);
  }

  function place(camera, view) {
    for (const label of labels) project(label, camera, view);
    const seen = labels.filter(({ element }) => !element.hidden);
    seen.forEach(measure);
    if (seen.length <= MOST_NUDGED) nudge(seen);
    for (const { element, x, y } of seen) element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  /** A picture with the labels that are seen written into it. */
  function written(canvas, { clientWidth }) {
    const ratio = canvas.width / clientWidth;
    const context = canvas.getContext('2d');
    context.font = `${12 * ratio}px system-ui, sans-serif`;
    context.textBaseline = 'top';
    context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--text');
    for (const { element, x, y } of labels) {
      if (!element.hidden) context.fillText(element.textContent, (x + 5) * ratio, (y + 2) * ratio);
    }
    return canvas;
  }

  function clear() {
    labels = [];
    container.replaceChildren();
  }

  return { add, clear, place, written };
}

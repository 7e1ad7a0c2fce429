// Picking and dragging things in the 3D view, with mouse, pen or finger.

import { Box3, Vector3 } from 'three';
import { createDrag } from './dragging.js';
import { isSame } from './document.js';
import { createArrows, createOutline, createProxy, onScreen, rayAt, segmentDistance, shapesOf } from './markers.js';

const EVERYWHERE = new Box3(new Vector3().setScalar(-Infinity), new Vector3().setScalar(Infinity));
// How near the pointer must come, px.
const REACH = { mouse: { arrow: 8, dot: 11 }, touch: { arrow: 20, dot: 24 } };
const STILL = 4;

const reachOf = (event) => (event.pointerType === 'touch' ? REACH.touch : REACH.mouse);

/**
 * Handles for the things of a scene. `source` tells what is shown: `things()`, `placeOf(thing)` now and `shownAt(thing)`
 * in the picture (m), `isVisible(thing)`, `model()`, `frame()`, `limits()`; `on` hears `select(thing)` and
 * `drag(thing, place, phase)` with the phases `begin`, `move`, `end` and `cancel`.
 */
export function createHandles({ stage, theme }, source, on) {
  const { canvas, controls } = stage;
  const container = canvas.parentElement;
  const arrows = createArrows();
  const outlines = { hover: [], selected: [], bad: [] };
  const proxies = new Map();
  const boxes = new Map();
  let active = false;
  let selected = null;
  let drag = null;
  let pressed = null;
  // Of the canvas, px: to ask for it while the page changes would lay it out anew.
  let height = canvas.clientHeight;
  stage.scene.add(arrows.group);

  const keyOf = ({ kind, id }) => `${kind} ${id}`;

  const placeOf = (thing) => source.frame().point(source.placeOf(thing));

  const shapes = (thing) => shapesOf(thing, { model: source.model(), frame: source.frame(), place: source.shownAt(thing) });

  // The solid of a thing, at its place.
  function proxyOf(thing) {
    const key = keyOf(thing);
    if (!proxies.has(key)) {
      const own = shapes(thing);
      proxies.set(key, own && own.positions.length > 0 ? createProxy(own) : null);
    }
    const proxy = proxies.get(key);
    proxy?.position.copy(placeOf(thing));
    proxy?.updateMatrixWorld();
    return proxy;
  }

  // The box around an obstacle where it was drawn, by name.
  function boxesOf() {
    if (boxes.size === 0) {
      for (const { name, parts } of source.model().obstacles) {
        boxes.set(name, new Box3().setFromPoints(parts.flatMap(({ vertices }) => vertices.map((v) => source.frame().point(v)))));
      }
    }
    return boxes;
  }

  // Whether a ray may meet a thing, found out quickly.
  const mayMeet = (thing, { ray }) => thing.kind !== 'obstacle' || ray.intersectsBox(boxesOf().get(thing.id) ?? EVERYWHERE);

  const pointOf = (event) => {
    const { left, top } = canvas.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  };

  // The arrow of the selected thing under the pointer.
  function arrowAt(point, { arrow: reach }) {
    if (!arrows.group.visible) return null;
    const found = arrows.ends().flatMap(([from, to], axis) => {
      const [a, b] = [from, to].map((end) => onScreen(end, stage.camera, canvas));
      const distance = a && b ? segmentDistance(point, a, b) : Infinity;
      return distance <= reach ? [{ axis, distance }] : [];
    });
    found.sort((a, b) => a.distance - b.distance);
    return found.length > 0 ? { thing: selected, axis: found[0].axis, at: placeOf(selected) } : null;
  }

  function solidAt(things, point) {
    const ray = rayAt(point, stage.camera, canvas);
    const hits = things.filter((thing) => mayMeet(thing, ray)).flatMap((thing) => {
      const [hit] = [proxyOf(thing)].filter(Boolean).flatMap((proxy) => ray.intersectObject(proxy));
      return hit ? [{ thing, axis: null, at: hit.point, distance: hit.distance }] : [];
    });
    return hits.sort((a, b) => a.distance - b.distance)[0] ?? null;
  }

  // Small things have some room around them.
  function dotAt(things, point, { dot: reach }) {
    const near = things.filter(({ kind }) => kind !== 'obstacle').flatMap((thing) => {
      const at = placeOf(thing);
      const seen = onScreen(at, stage.camera, canvas);
      const distance = seen ? Math.hypot(seen.x - point.x, seen.y - point.y) : Infinity;
      return distance <= reach ? [{ thing, axis: null, at, distance }] : [];
    });
    return near.sort((a, b) => a.distance - b.distance)[0] ?? null;
  }

  function pick(event) {
    const point = pointOf(event);
    const reach = reachOf(event);
    const things = source.things().filter(source.isVisible);
    return arrowAt(point, reach) ?? dotAt(things, point, reach) ?? solidAt(things, point);
  }

  function outline(style, things) {
    if (outlines[style].length === 0 && things.length === 0) return;
    for (const old of outlines[style]) old.remove();
    outlines[style] = things.map((thing) => {
      const made = createOutline(thing, shapes(thing), style, theme);
      stage.scene.add(made.group);
      return made;
    });
    place();
  }

  // Brings everything to where the things are.
  function place() {
    for (const { thing, group } of Object.values(outlines).flat()) group.position.copy(placeOf(thing));
    fitArrows();
    stage.invalidate();
  }

  function fitArrows() {
    arrows.group.visible = active && selected !== null;
    if (!arrows.group.visible) return;
    stage.camera.updateMatrixWorld();
    arrows.fit(placeOf(selected), stage.camera, height);
  }

  function hover(thing) {
    if (isSame(outlines.hover[0]?.thing, thing)) return;
    outline('hover', thing ? [thing] : []);
  }

  function select(thing) {
    if (isSame(selected, thing)) return;
    selected = thing;
    outline('selected', thing ? [thing] : []);
    hover(null);
    on.select(thing);
  }

  function begin(event, { thing, axis, at }) {
    const from = source.placeOf(thing);
    const own = createDrag({ from, grabbed: at.clone(), axis, frame: source.frame(), limits: source.limits() });
    drag = { ...own, id: event.pointerId, thing, axis, start: pointOf(event), moving: false };
    controls.enabled = false;
    canvas.setPointerCapture(event.pointerId);
    canvas.style.cursor = 'grabbing';
    // What the pointer has brought out is no longer pointed at.
    canvas.dispatchEvent(new PointerEvent('pointerleave'));
    if (axis !== null) arrows.only(axis);
    stage.invalidate();
  }

  function finish() {
    const { id } = drag;
    drag = null;
    controls.enabled = true;
    if (canvas.hasPointerCapture(id)) canvas.releasePointerCapture(id);
    canvas.style.cursor = '';
    arrows.only(null);
    stage.invalidate();
  }

  function down(event) {
    if (!active) return;
    if (drag) event.stopPropagation();
    if (drag || event.button !== 0) return;
    const hit = pick(event);
    pressed = { id: event.pointerId, at: pointOf(event), hit };
    // A finger selects first: what it does not hold turns the view.
    const holds = hit && (event.pointerType !== 'touch' || hit.axis !== null || isSame(hit.thing, selected));
    if (!holds) return;
    event.stopPropagation();
    event.preventDefault();
    canvas.focus({ preventScroll: true, focusVisible: false });
    select(hit.thing);
    begin(event, hit);
  }

  function follow(event) {
    const point = pointOf(event);
    if (!drag.moving && Math.hypot(point.x - drag.start.x, point.y - drag.start.y) < STILL) return;
    if (!drag.moving) on.drag(drag.thing, drag.from, 'begin');
    drag.moving = true;
    const ray = rayAt(point, stage.camera, canvas);
    on.drag(drag.thing, drag.to(ray, stage.camera, { vertical: event.shiftKey, free: event.altKey }), 'move');
  }

  function move(event) {
    if (!active) return;
    if (drag) event.stopPropagation();
    if (drag?.id === event.pointerId) follow(event);
    else if (!drag && event.pointerType !== 'touch' && event.buttons === 0) {
      const hit = pick(event);
      hover(hit && hit.axis === null && !isSame(hit.thing, selected) ? hit.thing : null);
      canvas.style.cursor = hit ? 'grab' : '';
    }
  }

  function up(event) {
    if (drag?.id === event.pointerId) {
      const { thing, moving } = drag;
      finish();
      if (moving) on.drag(thing, null, 'end');
    } else if (active && pressed?.id === event.pointerId) {
      const { x, y } = pointOf(event);
      if (Math.hypot(x - pressed.at.x, y - pressed.at.y) < 2 * STILL) select(pressed.hit?.thing ?? null);
    }
    pressed = null;
  }

  /** Ends a drag and puts the thing back; false if there is none. */
  function cancel() {
    if (!drag) return false;
    const { thing, moving, from } = drag;
    finish();
    if (moving) on.drag(thing, from, 'cancel');
    return true;
  }

  container.addEventListener('pointerdown', down, { capture: true });
  container.addEventListener('pointermove', move, { capture: true });
  container.addEventListener('pointerup', up, { capture: true });
  container.addEventListener('pointercancel', cancel, { capture: true });
  container.addEventListener('pointerleave', () => hover(null));
  controls.addEventListener('change', fitArrows);
  new ResizeObserver(() => {
    height = canvas.clientHeight;
    fitArrows();
  }).observe(canvas);

  return {
    get selected() { return selected; },
    get dragging() { return drag !== null && drag.moving; },
    select,
    cancel,
    place,
    /** Turns the handles on and off. */
    setActive: (value) => {
      active = value;
      if (!value) {
        cancel();
        select(null);
        hover(null);
      }
      canvas.style.cursor = '';
      fitArrows();
      stage.invalidate();
    },
    /** Outlines what is not valid. */
    setBad: (things) => outline('bad', things),
    /** Outlines anew what another picture shows. */
    refresh: () => {
      for (const proxy of proxies.values()) proxy?.geometry.dispose();
      proxies.clear();
      boxes.clear();
      const known = source.things();
      const still = (thing) => known.some((other) => isSame(other, thing));
      for (const style of Object.keys(outlines)) outline(style, outlines[style].map(({ thing }) => thing).filter(still));
      if (selected && !still(selected)) select(null);
    },
    /** Where a thing is on the page, px. */
    where: (thing) => {
      const seen = onScreen(placeOf(thing), stage.camera, canvas);
      const { left, top } = canvas.getBoundingClientRect();
      return seen && { x: seen.x + left, y: seen.y + top };
    },
  };
}

// Renderer, camera, lights and mouse control. Draws only when something has changed.

import { AmbientLight, Color, DirectionalLight, Group, OrthographicCamera } from 'three';
import { PerspectiveCamera, Plane, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

const FIRST_VIEW = new Vector3(0.45, -1, 0.42).normalize();
const FILL = 0.9;
const TIMED_PICTURES = 10;
const PARALLEL_DISTANCE = 4;
// Not straight from above, where up has no meaning.
const VIEWS = { x: [1, 0, 0], y: [0, -1, 0], z: [0, -1e-4, 1] };
// What the section plane keeps: the part that is away from the first view.
const KEPT = { x: [-1, 0, 0], y: [0, 1, 0], z: [0, 0, -1] };

/** Whether the browser can draw in 3D. */
export function hasWebGL() {
  try {
    const context = document.createElement('canvas').getContext('webgl2');
    context?.getExtension('WEBGL_lose_context')?.loseContext();
    return context !== null;
  } catch {
    return false;
  }
}

// Pixels of the picture for each of the page.
const sharpness = () => Math.min(window.devicePixelRatio, 2);
// The same while something moves and there is no graphics card: a quarter of the pixels.
const MOVING_SHARPNESS = 0.5;
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

// Only where the browser hides the name behind its own is there an extension to ask.
function isSoftware(context) {
  const name = context.getParameter(context.RENDERER);
  const info = /webkit/i.test(name) ? context.getExtension('WEBGL_debug_renderer_info') : null;
  return SOFTWARE.test(info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : name);
}

function createRenderer(container) {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.setPixelRatio(sharpness());
  renderer.localClippingEnabled = true;
  renderer.domElement.tabIndex = 0;
  renderer.domElement.setAttribute('role', 'img');
  renderer.domElement.setAttribute('aria-label', '3D view; drag to turn, right-drag to pan, wheel to zoom, arrow keys to pan, with Shift to turn');
  container.append(renderer.domElement);
  return renderer;
}

// A camera that sees in perspective and one of parallel projection, which look the same way.
function createCameras() {
  const cameras = { perspective: new PerspectiveCamera(30, 1, 0.01, 20), parallel: new OrthographicCamera() };
  for (const camera of Object.values(cameras)) camera.up.set(0, 0, 1);
  return cameras;
}

// The light that goes with the camera.
function createLamp(scene) {
  const carrier = new Group();
  const lamp = new DirectionalLight(0xffffff, 1.9);
  lamp.position.set(-0.6, 0.9, 1);
  lamp.target.position.set(0, 0, -1);
  carrier.add(lamp, lamp.target);
  scene.add(carrier, new AmbientLight(0xffffff, 1.5));
  return carrier;
}

function createControls(camera, canvas) {
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = !window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  controls.dampingFactor = 0.15;
  controls.zoomToCursor = true;
  controls.minDistance = 1e-3;
  controls.maxDistance = 50;
  controls.listenToKeyEvents(canvas);
  return controls;
}

function cornersOf({ min, max }) {
  const corners = [];
  for (const x of [min.x, max.x]) {
    for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) corners.push(new Vector3(x, y, z));
  }
  return corners;
}

// Shifts the picture into the part of the canvas that no panel covers, and returns how much of it is left.
function avoidMargins(camera, { clientWidth: width, clientHeight: height }, { left, right, top, bottom }) {
  camera.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
  return { x: Math.max(0.3, 1 - (left + right) / width), y: Math.max(0.3, 1 - (top + bottom) / height) };
}

/**
 * Where the camera has to look, and from how far, so that the corners of a box, as they are seen, fill the free part of the
 * picture; `slopes` are half its width and height at a distance of one, 0 for parallel projection.
 */
function fit(box, up, direction, slopes) {
  const centre = box.getCenter(new Vector3());
  const right = new Vector3().crossVectors(up, direction).normalize();
  const top = new Vector3().crossVectors(direction, right);
  const corners = cornersOf(box).map((corner) => corner.sub(centre));
  const along = (axis, slope) => {
    const high = Math.max(...corners.map((v) => v.dot(axis) + v.dot(direction) * slope));
    const low = Math.min(...corners.map((v) => v.dot(axis) - v.dot(direction) * slope));
    return { middle: (high + low) / 2, half: (high - low) / 2 };
  };
  const across = along(right, slopes.x);
  const upwards = along(top, slopes.y);
  const target = centre.addScaledVector(right, across.middle).addScaledVector(top, upwards.middle);
  return { target, width: across.half, height: upwards.half };
}

// What the section plane cuts; paths, marks and labels stay whole.
const CUT = new Set(['platform', 'obstacles', 'cables', 'outlets', 'workspace', 'swept', 'feasible', 'proved', 'regions', 'reachable', 'walls', 'culprits']);
// The plane is this much aside of round places, where faces lie in it.
const ASIDE = 2e-4;

function setClipping(object, planes) {
  if (object.material) object.material.clippingPlanes = planes;
  for (const child of object.children) setClipping(child, planes);
}

function cutLayers(object, planes) {
  for (const child of object.children) {
    if (CUT.has(child.name)) setClipping(child, planes);
    else if (child.isGroup && child.name === '') cutLayers(child, planes);
  }
}

/**
 * The 3D part of the page. `firstBox` is what the first view shows, `margins` tells how much of the page is covered at each
 * side, `onDraw` runs after each picture.
 */
export function createStage(container, firstBox, { margins, onDraw }) {
  const box = firstBox.clone();
  const scene = new Scene();
  scene.background = new Color();
  const renderer = createRenderer(container);
  const isSlow = isSoftware(renderer.getContext());
  const cameras = createCameras();
  const lamp = createLamp(scene);
  let camera = cameras.perspective;
  const controls = createControls(camera, renderer.domElement);
  let planes = [];
  // Of the container, px: to ask for it while the page changes would lay it out anew.
  let size = { width: 0, height: 0 };
  let pending = false;
  let touched = false;
  const jobs = new Set();
  // When it was drawn, ms after the page was asked for.
  let firstPicture = null;
  let direction = FIRST_VIEW;
  let section = { axis: '', fraction: 0.5 };
  const afterwards = new Set();

  function draw() {
    pending = false;
    for (const job of jobs) job();
    jobs.clear();
    controls.update();
    const distance = camera.position.distanceTo(controls.target);
    camera.near = Math.max(1e-5, distance * 0.02);
    camera.far = camera.position.length() + 10;
    if (camera.isOrthographicCamera) camera.near = -10;
    camera.updateProjectionMatrix();
    lamp.position.copy(camera.position);
    lamp.quaternion.copy(camera.quaternion);
    cutLayers(scene, planes);
    renderer.render(scene, camera);
    onDraw(camera, size);
    for (const job of afterwards) job();
    afterwards.clear();
    firstPicture ??= performance.now();
  }

  function invalidate() {
    if (!pending) requestAnimationFrame(draw);
    pending = true;
  }

  /** While something moves, software draws coarser pictures; those at rest are sharp. */
  function setMoving(moving) {
    const wanted = sharpness() * (moving && isSlow ? MOVING_SHARPNESS : 1);
    if (renderer.getPixelRatio() === wanted) return;
    renderer.setPixelRatio(wanted);
    invalidate();
  }

  /** Runs a job before the next picture, once, however often it is asked for. */
  function beforeNext(job) {
    jobs.add(job);
    invalidate();
  }

  /** Runs a job after the next picture. */
  function afterNext(job) {
    afterwards.add(job);
    invalidate();
  }

  /** Replaces what the views show and the section cuts; the camera stays where it is. */
  function setBox(value) {
    box.copy(value);
    cut(section.axis, section.fraction);
  }

  // Ends a turn that is still running out.
  function stop() {
    const damped = controls.enableDamping;
    controls.enableDamping = false;
    controls.update();
    controls.enableDamping = damped;
  }

  /** Looks from an axis in parallel projection, or as at first; everything is in the picture. */
  function look(axis) {
    direction = VIEWS[axis] ? new Vector3(...VIEWS[axis]).normalize() : FIRST_VIEW;
    camera = VIEWS[axis] ? cameras.parallel : cameras.perspective;
    controls.object = camera;
    frameAll();
  }

  function frameAll() {
    touched = false;
    stop();
    const free = avoidMargins(camera, container, margins());
    const aspect = container.clientWidth / container.clientHeight;
    const slope = Math.tan((cameras.perspective.fov * Math.PI) / 360) * FILL;
    const seen = { x: aspect * free.x, y: free.y };
    const parallel = camera.isOrthographicCamera;
    const slopes = { x: parallel ? 0 : slope * seen.x, y: parallel ? 0 : slope * seen.y };
    const { target, width, height } = fit(box, camera.up, direction, slopes);
    controls.target.copy(target);
    // The half height of the picture at the target.
    const half = Math.max(width / seen.x, height / seen.y) / FILL;
    if (parallel) widen(half, aspect);
    camera.position.copy(target).addScaledVector(direction, parallel ? PARALLEL_DISTANCE : half / (slope / FILL));
    controls.update();
    invalidate();
  }

  // Parallel projection shows this half height.
  function widen(half, aspect) {
    Object.assign(camera, { top: half, bottom: -half, right: half * aspect, left: -half * aspect, zoom: 1 });
  }

  function keepView() {
    avoidMargins(camera, container, margins());
    if (camera.isOrthographicCamera) {
      camera.right = (camera.top * container.clientWidth) / container.clientHeight;
      camera.left = -camera.right;
    }
    invalidate();
  }

  function resize() {
    const { clientWidth: width, clientHeight: height } = container;
    if (width === 0 || height === 0) return;
    size = { width, height };
    renderer.setSize(width, height);
    if (touched) keepView();
    else frameAll();
  }

  /** Cuts away what lies beyond a plane across an axis, at a fraction of the box; no axis, no cut. */
  function cut(axis, fraction) {
    section = { axis, fraction };
    planes = [];
    if (KEPT[axis]) {
      const at = box.min[axis] + (box.max[axis] - box.min[axis]) * fraction;
      const normal = new Vector3(...KEPT[axis]);
      planes = [new Plane(normal, ASIDE - at * normal[axis])];
    }
    invalidate();
  }

  /** The picture as it is now, on a canvas of its own. */
  function picture() {
    draw();
    const { domElement: source } = renderer;
    const copy = document.createElement('canvas');
    copy.width = source.width;
    copy.height = source.height;
    // In the same turn as the drawing: afterwards the browser may clear it.
    copy.getContext('2d').drawImage(source, 0, 0);
    return copy;
  }

  /** What a picture takes: draw calls, triangles, lines, and the time of one in ms. */
  function statistics() {
    const context = renderer.getContext();
    const begin = performance.now();
    for (let i = 0; i < TIMED_PICTURES; i += 1) draw();
    // Waits for the graphics card, which is otherwise still drawing.
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
    const { calls, triangles, lines } = renderer.info.render;
    return { calls, triangles, lines, frame: (performance.now() - begin) / TIMED_PICTURES, firstPicture };
  }

  controls.addEventListener('start', () => {
    touched = true;
  });
  controls.addEventListener('change', invalidate);
  renderer.domElement.addEventListener('webglcontextrestored', invalidate);
  new ResizeObserver(resize).observe(container);
  resize();
  const canvas = renderer.domElement;
  const isCut = (point) => planes.some((plane) => plane.distanceToPoint(point) < 0);
  const isTouched = () => touched;
  const own = { scene, controls, canvas, invalidate, setMoving, beforeNext, afterNext, setBox, look, cut, isCut, isTouched, picture, resize, statistics };
  // Which camera it is depends on the view.
  return Object.defineProperty(own, 'camera', { get: () => camera });
}

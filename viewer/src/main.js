// Entry point: reads the data of the page and puts the viewer together.

import { Box3, Group, Vector3 } from 'three';
import { readModel } from './data.js';
import { createCables } from './cables.js';
import { showCard } from './card.js';
import { createEdit, explainNoEditing } from './edit/edit.js';
import { rememberPage } from './edit/save.js';
import { createFrame } from './frame.js';
import { createGizmo } from './gizmo.js';
import { createDrop, createGrid, gridStep } from './ground.js';
import { bends } from './hanging.js';
import { createLabels } from './labels.js';
import { createHighlight } from './highlight.js';
import { connectPrinting } from './print.js';
import { watchPointer, watchSpotlight } from './spotlight.js';
import { createLayer, createLayers, createSwitch, placeholder } from './layers.js';
import { createNoPath } from './noPath.js';
import * as panel from './panel.js';
import { createFinalPath, createRawPath, createSearchTree, createViolations } from './paths.js';
import { createPlayback } from './playback.js';
import { createPlots } from './plots.js';
import { createRegions } from './regions.js';
import { createGhost, createOutlets, createPlatform, platformShapes, rotationOf } from './robot.js';
import { createRoute } from './route.js';
import { disposeAll } from './shapes.js';
import { createStage, hasWebGL } from './stage.js';
import { createObstacles, createWorkspace } from './surroundings.js';
import { createSwept } from './swept.js';
import { cableRole, createTheme } from './theme.js';
import { createTimedRoute } from './trajectory.js';
import { describeFeasible, describeTree } from './wording.js';
import { createVolume } from './volume.js';
import { createFeasible } from './workspace.js';

function restingPosition({ start, goal, path, workspace }) {
  if (path?.status === 'goal_invalid' && goal) return goal;
  if (start) return start;
  return workspace ? workspace.min.map((low, i) => (low + workspace.max[i]) / 2) : [0, 0, 0];
}

function routeOf(model) {
  if (model.trajectory) return createTimedRoute(model.trajectory);
  const waypoints = model.path?.waypoints ?? [];
  return waypoints.length > 0 ? createRoute(waypoints, model.path.turns) : createRoute([restingPosition(model)]);
}

function createGhosts(model, frame, shapes, theme) {
  const { start, goal, startOrientation, goalOrientation } = model;
  const stops = [['start', start, startOrientation], ['goal', goal, goalOrientation]].filter(([, point]) => point);
  return stops.map(([name, point, orientation]) => {
    const ghost = createGhost(shapes, orientation, theme);
    ghost.name = name;
    ghost.position.copy(frame.point(point));
    return ghost;
  });
}

// Where the path has dots: at its waypoints, or where a trajectory passes them.
function markedPlaces({ path, trajectory }, route) {
  if (!trajectory) return path?.waypoints;
  return [0, ...trajectory.corners.map(({ time }) => time), route.length].map(route.positionAt);
}

// Names of more obstacles than this would hide the picture; they can be switched on.
const MOST_NAMES = 12;
// So many obstacles or walls have their switches in sight at first.
const FEW = 3;

// A ghost right where the platform is would only flicker on it.
const SAME_PLACE = 1e-3;

// Everything drawn, and a function that moves the robot.
function fillScene(model, route, frame, stage, theme) {
  const shapes = platformShapes(model, frame);
  const platform = createPlatform(shapes, theme);
  const cables = createCables(model, frame, theme);
  const ghosts = createGhosts(model, frame, shapes, theme);
  const obstacles = createObstacles(model, frame, theme);
  const regions = createRegions(model, frame, theme);
  const highlight = createHighlight(model, frame, { shapes, strands: cables.strands }, theme);
  const noPath = createNoPath(model, frame, shapes, theme);
  const drop = createDrop(model, frame, theme);
  const contents = {
    ...noPath?.contents,
    platform: [platform, ...drop.objects],
    obstacles: obstacles.objects,
    obstacleNames: model.obstacles.length > 0 ? [placeholder()] : [],
    cables: cables.parts,
    cableNames: model.cables.length > 0 ? [placeholder()] : [],
    outlets: [...createOutlets(model, frame, theme), ...cables.wheels],
    searchTree: createSearchTree(model.path, frame, theme),
    rawPath: createRawPath(model.path, frame, theme),
    finalPath: createFinalPath(model.path, frame, theme, markedPlaces(model, route)),
    nearest: highlight.objects,
    violations: createViolations(model, route, frame, theme),
    startGoal: ghosts,
    workspace: [...createWorkspace(model, frame, theme), ...createGrid(model, frame, theme)],
    swept: createSwept(model, frame, theme),
    feasible: createFeasible(model, frame),
    proved: createVolume(model, frame, theme),
    regions: regions.map(({ group }) => group),
  };
  const isAt = (ghost) =>
    ghost.position.distanceTo(platform.position) <= SAME_PLACE && ghost.quaternion.angleTo(platform.quaternion) <= SAME_PLACE;
  const move = (position, orientation, nearest) => {
    frame.point(position, platform.position);
    platform.quaternion.copy(rotationOf(orientation));
    cables.move(platform.position, platform.quaternion);
    drop.move(platform.position, platform.quaternion);
    highlight.move(platform.position, platform.quaternion);
    highlight.show(nearest);
    for (const ghost of ghosts) ghost.visible = !isAt(ghost);
    stage.invalidate();
  };
  const hang = (wanted) => {
    cables.hang(wanted);
    noPath?.hang(wanted);
    highlight.move(platform.position, platform.quaternion);
    stage.invalidate();
  };
  return { contents, obstacles, ghosts, cables, highlight, regions, noPath, move, hang };
}

// Longer names of cables, or more of them, would hide the picture.
const SHORT_NAME = 4;

// The number alone where names are "cable 3".
const shortName = (name) => name.replace(/^cable\s+(?=\d+$)/i, '');

const hasShortNames = (cables) => cables.length <= MOST_NAMES && cables.every(({ name }) => shortName(name).length <= SHORT_NAME);

const isUnchanged = (path) => Boolean(path) && Math.abs(path.rawCost - path.cost) <= 1e-6 * path.cost;

const hiddenAtFirst = ({ cables, obstacles, regions, path }) => [
  ...(isUnchanged(path) ? ['rawPath'] : []),
  ...(hasShortNames(cables) ? [] : ['cableNames']),
  'searchTree',
  'swept',
  'feasible',
  ...(regions?.shown ? [] : ['regions']),
  ...(obstacles.length > MOST_NAMES ? ['obstacleNames'] : []),
];

function otherNames({ regions, path, trajectory }) {
  const onlyShadows = regions?.meshes.every(({ kind }) => kind === 'cable-obstacle');
  return {
    ...(onlyShadows && { regions: 'shadows of obstacles' }),
    ...(trajectory && { rawPath: 'path that it follows', finalPath: 'trajectory' }),
    ...(path?.tree && { searchTree: describeTree(path.tree) }),
  };
}

// Names at their places, which are returned by kind and name.
function addNames(model, frame, labels, layers, isCut) {
  const anchors = new Map();
  const add = (key, name, at, ...how) => {
    anchors.set(key, { at, first: at.clone() });
    labels.add(name, at, ...how);
  };
  for (const { name, parts } of model.obstacles) {
    const box = new Box3().setFromPoints(parts.flatMap(({ vertices }) => vertices.map((v) => frame.point(v))));
    const centre = box.getCenter(new Vector3());
    const part = layers.obstacles.parts[name];
    const seen = { get visible() { return layers.obstacleNames.visible && part.visible && !isCut(centre); } };
    add(`obstacle ${name}`, name, centre, seen);
  }
  let lit = null;
  watchSpotlight('names', (index) => { lit = index; });
  model.cables.forEach(({ name, outlet }, i) => {
    const place = frame.point(outlet);
    const seen = { get visible() { return (layers.cableNames.visible && !isCut(place)) || lit === i; } };
    add(`cable ${name}`, shortName(name), place, seen, `cable of-${cableRole(i)}`);
  });
  return anchors;
}

// The lengths of the gaps, and whether the reader sees the obstacles at them.
function addGaps(drawn, labels, layers) {
  const { gaps, see } = drawn.highlight;
  see((name) => layers.obstacles.parts?.[name] === undefined || (layers.obstacles.visible && layers.obstacles.parts[name].visible));
  for (const { group, middle, text } of gaps) {
    labels.add(text, middle, { get visible() { return !drawn.outdated && layers.nearest.visible && group.visible; } }, 'gap');
  }
}

// A switch between cables as they are and straight ones, if that differs.
function addHanging({ cables }, drawn, layers) {
  if (!cables.some(bends)) return;
  const name = cables.some(({ sag }) => sag) ? 'as low as they can hang' : 'round their pulleys';
  layers.hanging = createSwitch({ name, swatch: 'part hanging of-cables', shown: true, apply: drawn.hang, parent: layers.cables.below() });
}

// A switch for each obstacle.
function addObstacleParts(model, obstacles, layers, stage) {
  if (model.obstacles.length === 0) return;
  const hidden = new Set();
  const few = model.obstacles.length <= FEW;
  const parent = layers.obstacles.fold(few ? 'by name' : `by name (${model.obstacles.length})`, few);
  const showObstacles = () => obstacles.show(hidden);
  const part = ({ name }, i) => {
    const apply = (visible) => {
      if (visible) hidden.delete(i);
      else hidden.add(i);
      stage.beforeNext(showObstacles);
    };
    return createSwitch({ name, swatch: 'part solid of-obstacles', shown: true, apply, parent });
  };
  layers.obstacles.parts = Object.fromEntries(model.obstacles.map((obstacle, i) => [obstacle.name, part(obstacle, i)]));
  if (!few) panel.addAllOrNone(parent, Object.values(layers.obstacles.parts));
}

// A switch for each cable whose regions are drawn.
function addRegionParts(regions, layers, shown, invalidate) {
  if (regions.length === 0) return;
  const fold = layers.regions.fold('by cable', shown);
  const part = ({ group, role }) => createLayer(group, group.name, `part ghost of-${role}`, invalidate, true, fold);
  layers.regions.parts = Object.fromEntries(regions.map((region) => [region.group.name, part(region)]));
}

// A switch for the wall of each of those who close the way.
function addWalls({ walls }, layers, invalidate) {
  const fold = layers.walls.fold('by whom', walls.length <= FEW);
  const part = ({ group, role }) => createLayer(group, group.name, `part solid of-${role}`, invalidate, true, fold);
  layers.walls.parts = Object.fromEntries(walls.map((wall) => [wall.group.name, part(wall)]));
}

// Shows the path without an obstacle, or for null the proof.
function leavingOut(noPath, layers, invalidate) {
  let without = null;
  return (name) => {
    if (without !== null) layers.obstacles.parts[without].visible = true;
    if (name !== null) layers.obstacles.parts[name].visible = false;
    without = name;
    noPath.leaveOut(name);
    invalidate();
  };
}

function savePicture(picture, title) {
  picture.toBlob((blob) => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${title.replace(/[^\p{L}\p{N}._-]+/gu, '_')}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }, 'image/png');
}

// What stays while models come and go: renderer and camera, labels, colours, and what works on the picture.
function createSetting(model) {
  const container = document.getElementById('view');
  const labels = createLabels(document.getElementById('labels'));
  const frame = createFrame(model);
  let turnGizmo = () => {};
  const stage = createStage(container, frame.box, { margins: panel.coveredMargins, onDraw: (camera, view) => {
    labels.place(camera, view);
    turnGizmo(camera);
  } });
  turnGizmo = createGizmo(document.getElementById('gizmo'), stage.look);
  const theme = createTheme(stage.invalidate);
  theme.createPainter().bind(stage.scene.background, 'background');
  const { look, cut, resize, statistics } = stage;
  const picture = () => labels.written(stage.picture(), container);
  const save = () => savePicture(picture(), document.getElementById('title').textContent);
  connectPrinting(picture, panel.coveredMargins, theme.setPrinting);
  const tools = { look, cut, resize, picture, save, statistics, toggleLook: theme.toggle };
  return { frame, labels, stage, theme, tools };
}

// What stands in for it where nothing can be drawn in 3D.
function createPlainSetting() {
  createTheme(() => {});
  panel.showMessage('This browser cannot draw in 3D (WebGL 2 is not available), so only the texts are shown.');
  return { tools: { look: null } };
}

// Which layers and parts of layers the reader sees, by name.
function visibilityOf(layers) {
  const seen = (parts) => new Map(Object.entries(parts).map(([name, { visible }]) => [name, visible]));
  const parts = Object.entries(layers).filter(([, layer]) => layer.parts);
  return { layers: seen(layers), parts: new Map(parts.map(([key, layer]) => [key, seen(layer.parts)])) };
}

// Only what differs is switched, as a switch draws anew.
function restoreVisibility(layers, before) {
  const restore = (parts, seen) => {
    for (const [name, part] of Object.entries(parts)) {
      const visible = seen?.get(name) ?? part.visible;
      if (visible !== part.visible) part.visible = visible;
    }
  };
  restore(layers, before.layers);
  for (const [key, layer] of Object.entries(layers)) if (layer.parts) restore(layer.parts, before.parts.get(key));
}

// The 3D part of a model: how to move the robot, the layers and the view; `before` is what it replaces.
function createView(model, route, { frame: first, labels, stage, theme, tools }, before) {
  const frame = createFrame(model, first);
  const painter = theme.createPainter();
  const group = new Group();
  if (before) stage.setBox(frame.box);
  const unfold = panel.clearLegend();
  labels.clear();
  const drawn = fillScene(model, route, frame, stage, painter);
  const { contents, obstacles, ghosts, regions, noPath, move } = drawn;
  const layers = createLayers(contents, hiddenAtFirst(model), otherNames(model), group, stage.invalidate);
  addHanging(model, drawn, layers);
  addObstacleParts(model, obstacles, layers, stage);
  addRegionParts(regions, layers, Boolean(model.regions?.shown), stage.invalidate);
  if (contents.feasible.length > 0) layers.feasible.note(describeFeasible(model.feasible));
  drawn.anchors = addNames(model, frame, labels, layers, stage.isCut);
  addGaps(drawn, labels, layers);
  watchSpotlight('cables', (index) => {
    drawn.cables.light(index);
    stage.invalidate();
  });
  if (noPath) addWalls(noPath, layers, stage.invalidate);
  for (const { text, anchor, of } of noPath?.labels ?? []) {
    labels.add(text, anchor, { get visible() { return !drawn.outdated && layers.nearestReachable.visible && of.visible; } });
  }
  const leaveOut = noPath ? leavingOut(noPath, layers, stage.invalidate) : () => {};
  for (const ghost of ghosts) labels.add(ghost.name, ghost.position, layers.startGoal);
  model.result?.via.forEach((k, i) => {
    const at = model.path?.waypoints[k];
    if (at) labels.add(`via ${i + 1}`, frame.point(at), layers.finalPath);
  });
  if (before) restoreVisibility(layers, visibilityOf(before.layers));
  unfold();
  stage.scene.add(group);
  const remove = () => {
    painter.release();
    group.removeFromParent();
    // After the next picture, which may use the same programs of the graphics card.
    stage.afterNext(() => disposeAll(group));
  };
  const point = (signal) => watchPointer(stage, drawn.cables.strands, () => layers.cables.visible, signal);
  panel.showGridStep(gridStep(model));
  return { ...tools, move, leaveOut, layers, frame, drawn, point, remove };
}

const NOTHING = { move: () => {}, leaveOut: () => {}, layers: {}, drawn: null, point: () => {}, remove: () => {} };

// The largest coordinate in the workspace, m.
const sizeOf = ({ workspace }) => (workspace ? Math.max(...[...workspace.min, ...workspace.max].map(Math.abs)) : 1);

function connect(model, planned, view, signal) {
  let route = planned;
  let showPlots = () => null;
  const size = sizeOf(model);
  const resting = model.path ? model.orientation : model.startOrientation;
  const orientationAt = (distance) => route.orientationAt?.(distance) ?? resting;
  const playback = createPlayback(
    route.length,
    route.timed,
    (distance) => {
      const position = route.positionAt(distance);
      view.move(position, orientationAt(distance), showPlots(distance));
      panel.showPosition(position, size);
      panel.showDistance(distance, route.length, route.describe(distance));
    },
    panel.showPlaying,
    signal,
  );
  const jump = (distance) => {
    playback.pause();
    playback.setDistance(distance);
  };
  const leaveOut = (name) => {
    const { waypoints } = model.noPath.without.find(({ obstacle }) => obstacle === name) ?? {};
    route = waypoints ? createRoute(waypoints) : planned;
    view.leaveOut(name);
    playback.restart(route.length);
    panel.showTransport(route.length);
    panel.showStops(route.corners, route.length);
  };
  showPlots = createPlots(model, route, jump);
  showCard(model, route.length, jump);
  panel.connectTransport(playback, route.timed, signal);
  panel.showStops(route.corners, route.length);
  view.point(signal);
  panel.showNoPath(model.noPath, leaveOut);
  panel.showViolations(model.violations, route, jump);
  panel.connectKeys(playback, view, signal);
  const position = () => route.positionAt(playback.distance());
  const orientation = () => orientationAt(playback.distance());
  return { playback, timed: route.timed, position, orientation };
}

// The interface for scripts that drive the page.
function publish(view, { playback, timed, position, orientation }) {
  const { distance: time, setDistance: setTime } = playback;
  const place = { distance: playback.distance, setDistance: playback.setDistance };
  window.cdprViewer = {
    get length() { return timed ? null : playback.length(); },
    get duration() { return timed ? playback.length() : null; },
    ...(timed ? { time, setTime } : place),
    position,
    orientation,
    layers: view.layers,
    look: view.look,
    picture: view.picture ?? null,
    statistics: view.statistics ?? null,
    resetView: view.look && (() => view.look()),
    ready: true,
  };
}

// The share of the way travelled, and whether the platform runs.
function progressOf({ playback }) {
  const length = playback.length();
  return { share: length > 0 ? playback.distance() / length : 0, playing: playback.playing() };
}

/** Shows models one after the other; camera, colours, switches and the place along the path stay. */
function createApp() {
  let setting = null;
  let current = null;
  const show = (model) => {
    const before = current;
    const { share, playing } = before ? progressOf(before) : { share: 0, playing: false };
    before?.session.abort();
    const session = new AbortController();
    const route = routeOf(model);
    panel.showSummary(model);
    if (!before) {
      panel.foldWhereNarrow();
      setting = hasWebGL() ? createSetting(model) : createPlainSetting();
    }
    const view = setting.stage ? createView(model, route, setting, before?.view) : { ...setting.tools, ...NOTHING };
    const connected = connect(model, route, view, session.signal);
    if (!before && view.look) panel.connectTools(view);
    connected.playback.setDistance(share * route.length);
    if (playing) connected.playback.toggle();
    else panel.showPlaying(false);
    before?.view.remove();
    publish(view, connected);
    current = { ...connected, model, view, session, setting };
  };
  return { show, current: () => current };
}

function start() {
  const { live, ...page } = JSON.parse(document.getElementById('cdpr-data').textContent);
  const fill = live ? rememberPage() : null;
  const app = createApp();
  app.show(readModel(page));
  if (live) createEdit(app, live, page, fill);
  else explainNoEditing(readModel(page));
}

try {
  start();
} catch (error) {
  panel.showMessage(`The scene cannot be shown: ${error.message}`);
  throw error;
}

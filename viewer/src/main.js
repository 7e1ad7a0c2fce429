// Entry point: reads the data of the page and puts the viewer together.

import { Box3, Vector3 } from 'three';
import { readModel } from './data.js';
import { createFrame } from './frame.js';
import { createLabels } from './labels.js';
import { createHighlight } from './highlight.js';
import { createLayer, createLayers, createSwitch, placeholder } from './layers.js';
import { createNoPath } from './noPath.js';
import * as panel from './panel.js';
import { createFinalPath, createRawPath, createSearchTree, createViolations } from './paths.js';
import { createPlayback } from './playback.js';
import { createPlots } from './plots.js';
import { createRegions } from './regions.js';
import { createCables, createGhost, createOutlets, createPlatform, platformShapes, rotationOf } from './robot.js';
import { createRoute } from './route.js';
import { createStage, hasWebGL } from './stage.js';
import { createObstacles, createWorkspace } from './surroundings.js';
import { createSwept } from './swept.js';
import { createTheme } from './theme.js';
import { createTimedRoute } from './trajectory.js';
import { describeFeasible, describeTree } from './wording.js';
import { createFeasible } from './workspace.js';

function restingPosition({ start, workspace }) {
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

// Larger trees would hide the picture, too.
const MOST_EDGES = 500;
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
  const highlight = createHighlight(model, frame, shapes, theme);
  const noPath = createNoPath(model, frame, shapes, theme);
  const contents = {
    ...noPath?.contents,
    platform: [platform],
    obstacles: obstacles.objects,
    obstacleNames: model.obstacles.length > 0 ? [placeholder()] : [],
    cables: cables.parts,
    cableNames: model.cables.length > 0 ? [placeholder()] : [],
    outlets: createOutlets(model, frame, theme),
    searchTree: createSearchTree(model.path, frame, theme),
    rawPath: createRawPath(model.path, frame, theme),
    finalPath: createFinalPath(model.path, frame, theme, markedPlaces(model, route)),
    nearest: highlight.objects,
    violations: createViolations(model, route, frame, theme),
    startGoal: ghosts,
    workspace: createWorkspace(model, frame, theme),
    swept: createSwept(model, frame, theme),
    feasible: createFeasible(model, frame),
    regions: regions.map(({ group }) => group),
  };
  const isAt = (ghost) =>
    ghost.position.distanceTo(platform.position) <= SAME_PLACE && ghost.quaternion.angleTo(platform.quaternion) <= SAME_PLACE;
  const move = (position, orientation, nearest) => {
    frame.point(position, platform.position);
    platform.quaternion.copy(rotationOf(orientation));
    cables.move(platform.position, platform.quaternion);
    highlight.move(platform.position, platform.quaternion);
    highlight.show(nearest);
    for (const ghost of ghosts) ghost.visible = !isAt(ghost);
    stage.invalidate();
  };
  return { contents, obstacles, ghosts, regions, noPath, move };
}

const hiddenAtFirst = ({ obstacles, regions, path }) => [
  'cableNames',
  'swept',
  'feasible',
  ...(path?.tree?.count > MOST_EDGES ? ['searchTree'] : []),
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

function addNames(model, frame, labels, layers) {
  for (const { name, parts } of model.obstacles) {
    const box = new Box3().setFromPoints(parts.flatMap(({ vertices }) => vertices.map((v) => frame.point(v))));
    const part = layers.obstacles.parts[name];
    const seen = { get visible() { return layers.obstacleNames.visible && part.visible; } };
    labels.add(name, box.getCenter(new Vector3()), seen);
  }
  for (const { name, outlet } of model.cables) labels.add(name, frame.point(outlet), layers.cableNames);
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

// The 3D part: how to move the robot, the layers and the view.
function createView(model, route) {
  const container = document.getElementById('view');
  const frame = createFrame(model);
  const labels = createLabels(document.getElementById('labels'));
  const stage = createStage(container, frame.box, { margins: panel.coveredMargins, onDraw: labels.place });
  const theme = createTheme(stage.invalidate);
  theme.bind(stage.scene.background, 'background');
  const { contents, obstacles, ghosts, regions, noPath, move } = fillScene(model, route, frame, stage, theme);
  const layers = createLayers(contents, hiddenAtFirst(model), otherNames(model), stage.scene, stage.invalidate);
  addObstacleParts(model, obstacles, layers, stage);
  addRegionParts(regions, layers, Boolean(model.regions?.shown), stage.invalidate);
  if (contents.feasible.length > 0) layers.feasible.note(describeFeasible(model.feasible));
  addNames(model, frame, labels, layers);
  if (noPath) addWalls(noPath, layers, stage.invalidate);
  for (const { text, anchor, of } of noPath?.labels ?? []) {
    labels.add(text, anchor, { get visible() { return layers.nearestReachable.visible && of.visible; } });
  }
  const leaveOut = noPath ? leavingOut(noPath, layers, stage.invalidate) : () => {};
  for (const ghost of ghosts) labels.add(ghost.name, ghost.position, layers.startGoal);
  const { look, cut, resize } = stage;
  const picture = () => labels.written(stage.picture(), container);
  const save = () => savePicture(picture(), model.title);
  const { statistics } = stage;
  return { move, leaveOut, layers, look, cut, resize, picture, save, statistics, toggleLook: theme.toggle };
}

// What stands in for the 3D part where it cannot be drawn.
function createPlainView() {
  createTheme(() => {});
  panel.showMessage('This browser cannot draw in 3D (WebGL 2 is not available), so only the texts are shown.');
  return { move: () => {}, leaveOut: () => {}, layers: {}, look: null };
}

// The largest coordinate in the workspace, m.
const sizeOf = ({ workspace }) => (workspace ? Math.max(...[...workspace.min, ...workspace.max].map(Math.abs)) : 1);

function connect(model, view) {
  const planned = routeOf(model);
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
  };
  showPlots = createPlots(model, route, jump);
  panel.connectTransport(playback, route.timed);
  panel.showNoPath(model.noPath, leaveOut);
  panel.showViolations(model.violations, (violation) => route.placeOf(violation), jump);
  if (view.look) panel.connectTools(view);
  panel.connectKeys(playback, view);
  playback.setDistance(0);
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

function start() {
  const model = readModel(JSON.parse(document.getElementById('cdpr-data').textContent));
  const route = routeOf(model);
  panel.showSummary(model, route.length);
  const view = hasWebGL() ? createView(model, route) : createPlainView();
  publish(view, connect(model, view));
}

try {
  start();
} catch (error) {
  panel.showMessage(`The scene cannot be shown: ${error.message}`);
  throw error;
}

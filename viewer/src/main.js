// Entry point: reads the data of the page and puts the viewer together.

import { Box3, Vector3 } from 'three';
import { readModel } from './data.js';
import { createFrame } from './frame.js';
import { createLabels } from './labels.js';
import { createHighlight } from './highlight.js';
import { createLayer, createLayers, placeholder } from './layers.js';
import * as panel from './panel.js';
import { createFinalPath, createRawPath, createViolations } from './paths.js';
import { createPlayback } from './playback.js';
import { createPlots } from './plots.js';
import { createRegions } from './regions.js';
import { createCables, createGhost, createOutlets, createPlatform, platformShapes } from './robot.js';
import { createRoute } from './route.js';
import { createStage, hasWebGL } from './stage.js';
import { createObstacles, createWorkspace } from './surroundings.js';
import { createSwept } from './swept.js';
import { createTheme } from './theme.js';
import { createFeasible } from './workspace.js';

function restingPosition({ start, workspace }) {
  if (start) return start;
  return workspace ? workspace.min.map((low, i) => (low + workspace.max[i]) / 2) : [0, 0, 0];
}

function routeOf(model) {
  const waypoints = model.path?.waypoints ?? [];
  return createRoute(waypoints.length > 0 ? waypoints : [restingPosition(model)]);
}

function createGhosts(model, frame, shapes, theme) {
  const stops = [['start', model.start], ['goal', model.goal]].filter(([, point]) => point);
  return stops.map(([name, point]) => {
    const ghost = createGhost(shapes, model.orientation, theme);
    ghost.name = name;
    ghost.position.copy(frame.point(point));
    return ghost;
  });
}

// Names of more obstacles than this would hide the picture; they can be switched on.
const MOST_NAMES = 12;

// A ghost right where the platform is would only flicker on it.
const SAME_PLACE = 1e-3;

// Everything drawn, and a function that moves the robot.
function fillScene(model, route, frame, stage, theme) {
  const shapes = platformShapes(model, frame);
  const platform = createPlatform(shapes, model.orientation, theme);
  const cables = createCables(model, frame, theme);
  const ghosts = createGhosts(model, frame, shapes, theme);
  const regions = createRegions(model, frame, theme);
  const highlight = createHighlight(model, frame, shapes, theme);
  const contents = {
    platform: [platform],
    obstacles: createObstacles(model, frame, theme),
    obstacleNames: model.obstacles.length > 0 ? [placeholder()] : [],
    cables: cables.parts,
    cableNames: model.cables.length > 0 ? [placeholder()] : [],
    outlets: createOutlets(model, frame, theme),
    rawPath: createRawPath(model.path, frame, theme),
    finalPath: createFinalPath(model.path, frame, theme),
    nearest: highlight.objects,
    violations: createViolations(model.violations, route, frame, theme),
    startGoal: ghosts,
    workspace: createWorkspace(model, frame, theme),
    swept: createSwept(model, frame, theme),
    feasible: createFeasible(model, frame),
    regions: regions.map(({ group }) => group),
  };
  const move = (position, nearest) => {
    frame.point(position, platform.position);
    cables.move(platform.position);
    highlight.move(platform.position);
    highlight.show(nearest);
    for (const ghost of ghosts) ghost.visible = ghost.position.distanceTo(platform.position) > SAME_PLACE;
    stage.invalidate();
  };
  return { contents, ghosts, regions, move };
}

const hiddenAtFirst = ({ obstacles, regions }) => [
  'cableNames',
  'swept',
  'feasible',
  ...(regions?.shown ? [] : ['regions']),
  ...(obstacles.length > MOST_NAMES ? ['obstacleNames'] : []),
];

function otherNames({ regions }) {
  const onlyShadows = regions?.meshes.every(({ kind }) => kind === 'cable-obstacle');
  return onlyShadows ? { regions: 'shadows of obstacles' } : {};
}

function addNames(model, frame, labels, layers) {
  for (const { name, parts } of model.obstacles) {
    const box = new Box3().setFromPoints(parts.flatMap(({ vertices }) => vertices.map((v) => frame.point(v))));
    labels.add(name, box.getCenter(new Vector3()), layers.obstacleNames);
  }
  for (const { name, outlet } of model.cables) labels.add(name, frame.point(outlet), layers.cableNames);
}

// A switch for each cable whose regions are drawn.
function addRegionParts(regions, layers, shown, invalidate) {
  if (regions.length === 0) return;
  const fold = panel.addLegendFold('by cable', shown);
  const part = ({ group, role }) => createLayer(group, group.name, `part ghost of-${role}`, invalidate, true, fold);
  layers.regions.parts = Object.fromEntries(regions.map((region) => [region.group.name, part(region)]));
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
  const { contents, ghosts, regions, move } = fillScene(model, route, frame, stage, theme);
  const layers = createLayers(contents, hiddenAtFirst(model), otherNames(model), stage.scene, stage.invalidate);
  addRegionParts(regions, layers, Boolean(model.regions?.shown), stage.invalidate);
  if (contents.feasible.length > 0) panel.addRampKey(model.feasible);
  addNames(model, frame, labels, layers);
  for (const ghost of ghosts) labels.add(ghost.name, ghost.position, layers.startGoal);
  const { look, cut, resize } = stage;
  const picture = () => labels.written(stage.picture(), container);
  const save = () => savePicture(picture(), model.title);
  return { move, layers, look, cut, resize, picture, save, toggleLook: theme.toggle };
}

// What stands in for the 3D part where it cannot be drawn.
function createPlainView() {
  createTheme(() => {});
  panel.showMessage('This browser cannot draw in 3D (WebGL 2 is not available), so only the texts are shown.');
  return { move: () => {}, layers: {}, look: null };
}

function connect(model, route, view) {
  let showPlots = () => null;
  const playback = createPlayback(
    route.length,
    (distance) => {
      view.move(route.positionAt(distance), showPlots(distance));
      panel.showDistance(distance, route.length);
    },
    panel.showPlaying,
  );
  const jump = (distance) => {
    playback.pause();
    playback.setDistance(distance);
  };
  showPlots = createPlots(model, route, jump);
  panel.connectTransport(playback);
  panel.showViolations(model.violations, ({ segment, at }) => jump(route.distanceAt(segment, at)));
  if (view.look) panel.connectTools(view);
  panel.connectKeys(playback, view);
  playback.setDistance(0);
  return playback;
}

// The interface for scripts that drive the page.
function publish(route, view, playback) {
  window.cdprViewer = {
    length: route.length,
    distance: playback.distance,
    setDistance: playback.setDistance,
    position: () => route.positionAt(playback.distance()),
    layers: view.layers,
    look: view.look,
    picture: view.picture ?? null,
    resetView: view.look && (() => view.look()),
    ready: true,
  };
}

function start() {
  const model = readModel(JSON.parse(document.getElementById('cdpr-data').textContent));
  const route = routeOf(model);
  panel.showSummary(model, route.length);
  const view = hasWebGL() ? createView(model, route) : createPlainView();
  publish(route, view, connect(model, route, view));
}

try {
  start();
} catch (error) {
  panel.showMessage(`The scene cannot be shown: ${error.message}`);
  throw error;
}

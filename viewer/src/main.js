// Entry point: reads the data of the page and puts the viewer together.

import { readModel } from './data.js';
import { createFrame } from './frame.js';
import { createLabels } from './labels.js';
import { createLayer, createLayers } from './layers.js';
import * as panel from './panel.js';
import { createFinalPath, createRawPath, createViolations } from './paths.js';
import { createPlayback } from './playback.js';
import { createRegions } from './regions.js';
import { createCables, createGhost, createPlatform, platformShapes } from './robot.js';
import { createRoute } from './route.js';
import { createStage, hasWebGL } from './stage.js';
import { createObstacles, createWorkspace } from './surroundings.js';
import { createTheme } from './theme.js';

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

// A ghost right where the platform is would only flicker on it.
const SAME_PLACE = 1e-3;

// Everything drawn, and a function that moves the robot.
function fillScene(model, route, frame, stage, theme) {
  const shapes = platformShapes(model, frame);
  const platform = createPlatform(shapes, model.orientation, theme);
  const cables = createCables(model, frame, theme);
  const ghosts = createGhosts(model, frame, shapes, theme);
  const regions = createRegions(model, frame, theme);
  const contents = {
    platform: [platform],
    obstacles: createObstacles(model, frame, theme),
    cables: cables.parts,
    rawPath: createRawPath(model.path, frame, theme),
    finalPath: createFinalPath(model.path, frame, theme),
    violations: createViolations(model.violations, route, frame, theme),
    startGoal: ghosts,
    workspace: createWorkspace(model, frame, theme),
    regions: regions.map(({ group }) => group),
  };
  const move = (position) => {
    frame.point(position, platform.position);
    cables.move(platform.position);
    for (const ghost of ghosts) ghost.visible = ghost.position.distanceTo(platform.position) > SAME_PLACE;
    stage.invalidate();
  };
  return { contents, ghosts, regions, move };
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
  const layers = createLayers(contents, stage.scene, stage.invalidate);
  const regionLayer = ({ group, role }) => [group.name, createLayer(group, group.name, `part ghost of-${role}`, stage.invalidate)];
  layers.regions.parts = Object.fromEntries(regions.map(regionLayer));
  for (const ghost of ghosts) labels.add(ghost.name, ghost.position, layers.startGoal);
  return { move, layers, resetView: stage.resetView };
}

// What stands in for the 3D part where it cannot be drawn.
function createPlainView() {
  createTheme(() => {});
  panel.showMessage('This browser cannot draw in 3D (WebGL 2 is not available), so only the texts are shown.');
  return { move: () => {}, layers: {}, resetView: null };
}

function connect(model, route, view) {
  const playback = createPlayback(
    route.length,
    (distance) => {
      view.move(route.positionAt(distance));
      panel.showDistance(distance, route.length);
    },
    panel.showPlaying,
  );
  panel.connectTransport(playback);
  panel.showViolations(model.violations, ({ segment, at }) => {
    playback.pause();
    playback.setDistance(route.distanceAt(segment, at));
  });
  if (view.resetView) panel.connectReset(view.resetView);
  panel.connectKeys(playback, view.resetView ?? (() => {}));
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
    resetView: view.resetView,
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

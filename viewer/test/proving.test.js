// Which proofs of the workspace are asked for while a scene changes, with a planner that answers by hand.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createLane } from '../src/edit/planner.js';
import { createProving } from '../src/edit/proving.js';

const SCENE = { robot: {}, obstacles: [], query: { start: [0, 0, 0], goal: [1, 1, 1] } };

// A worker that keeps its requests until they are answered; `asked` has them all, `state` what the page last heard.
function setup() {
  const asked = [];
  let state = null;
  let hear = null;
  const start = () => ({
    postMessage: (message) => asked.push(message),
    addEventListener: (kind, listener) => { if (kind === 'message') hear = listener; },
    terminate: () => {},
  });
  const lane = createLane(start);
  const planner = { ready: async () => ({ divide: lane }) };
  const proving = createProving({ planner, scene: SCENE, draw: () => {}, tell: (news) => { state = news; } });
  const settle = () => new Promise((resolve) => { setTimeout(resolve, 0); });
  const answer = async (min, decided = 1) => {
    const proved = { bounds: [[0, 0, 0], [1, 1, 1]], count: 1, inside: [], volume: { min, max: min }, total: 8 };
    hear({ data: { id: asked.at(-1).id, answer: { proved, decided } } });
    await settle();
  };
  return { proving, asked, answer, settle, state: () => state };
}

const withOutletAt = (x) => ({ ...SCENE, robot: { outlet: x } });

test('a proof is refined until enough is decided', async () => {
  const { proving, asked, answer, settle, state } = setup();
  proving.setActive(true);
  await settle();
  assert.ok(state().busy && state().proved === null);
  await answer(2, 0.5);
  assert.ok(state().busy && state().proved.volume[0] === 2);
  assert.ok(asked[1].request.budget_ms > asked[0].request.budget_ms);
  await answer(3);
  assert.deepEqual([state().busy, state().proved.volume, asked.length], [false, [3, 3], 2]);
});

test('start and goal change nothing', async () => {
  const { proving, asked, answer, settle } = setup();
  proving.setActive(true);
  await settle();
  await answer(3);
  proving.change({ ...SCENE, query: { ...SCENE.query, start: [0, 0, 1] } });
  await settle();
  assert.equal(asked.length, 1);
  proving.change({ ...SCENE, query: { ...SCENE.query, orientation: 'across' } });
  await settle();
  assert.equal(asked.length, 2);
});

test('a drag is one change, and its proofs are quick', async () => {
  const { proving, asked, answer, settle, state } = setup();
  proving.setActive(true);
  await settle();
  await answer(3);
  const drops = withOutletAt(2);
  for (const next of [withOutletAt(1), drops]) {
    proving.change(next, { dragging: true });
    await settle();
    await answer(2, 0.5);
    assert.deepEqual([state().before, state().proved.volume[0]], [[3, 3], 2]);
  }
  assert.ok(asked[1].request.budget_ms < asked[0].request.budget_ms && asked[2].request.budget_ms > asked[1].request.budget_ms);
  proving.change(drops);
  await settle();
  assert.ok(state().busy);
  await answer(2.5);
  assert.deepEqual([state().busy, state().before, state().proved.volume], [false, [3, 3], [2.5, 2.5]]);
});

test('a script does not leave an old volume standing', async () => {
  const { proving, asked, answer, settle, state } = setup();
  proving.setActive(true);
  await settle();
  await answer(3);
  proving.change(withOutletAt(1), { dragging: true });
  await settle();
  proving.change(withOutletAt(1.5), { dragging: true });
  const scripted = proving.once(1000);
  await settle();
  await answer(2);
  await answer(2);
  assert.equal((await scripted).decided, 1);
  await settle();
  await answer(1.5);
  assert.deepEqual([state().busy, state().proved.volume[0], asked.at(-1).request.scene.robot.outlet], [false, 1.5, 1.5]);
});

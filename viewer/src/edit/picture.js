// The picture while it is edited: things where they are now, and what no longer belongs to the scene dimmed or hidden.

const OUTDATED = ['violations', 'nearest', 'swept', 'feasible', 'regions', 'reachable', 'walls', 'culprits', 'nearestReachable', 'detours', 'searchTree', 'rawPath'];
const DIMMED = 0.3;
// Of the 32 layers of three.js one that no camera looks at.
const UNSEEN = 31;

function dim(object, dimmed) {
  object.traverse(({ material }) => {
    if (!material) return;
    if (!material.transparent) Object.assign(material, { transparent: true, needsUpdate: true });
    material.opacity = dimmed ? DIMMED : 1;
  });
}

/**
 * Marks what is drawn as belonging to another scene, or not; a `dimmed` path belongs to another scene, too. Without a
 * picture only the texts are marked.
 */
export function markOutdated(drawn, { outdated, dimmed }) {
  document.documentElement.classList.toggle('outdated', outdated);
  if (!drawn) return;
  const { contents } = drawn;
  for (const key of OUTDATED) {
    for (const object of contents[key] ?? []) object.traverse(({ layers }) => layers.set(outdated ? UNSEEN : 0));
  }
  for (const object of contents.finalPath) dim(object, dimmed);
  drawn.outdated = outdated;
}

function moveObstacle({ drawn, frame, model }, name, by) {
  const index = model.obstacles.findIndex((obstacle) => obstacle.name === name);
  if (index < 0) return;
  const shift = frame.vector(by);
  drawn.obstacles.move(index, shift);
  const anchor = drawn.anchors.get(`obstacle ${name}`);
  if (anchor) anchor.at.copy(anchor.first).add(shift);
}

function moveOutlet({ drawn, frame, model }, index, to) {
  const [marks] = drawn.contents.outlets;
  const place = frame.point(to);
  drawn.cables.moveOutlet(index, place);
  place.toArray(marks.geometry.attributes.position.array, 3 * index);
  marks.geometry.attributes.position.needsUpdate = true;
  const anchor = drawn.anchors.get(`cable ${model.cables[index]?.name}`);
  anchor?.at.copy(place);
}

/** Moves a thing of the picture from where it is drawn to where it is now, m. */
export function moveDrawn(picture, { kind, id }, from, to) {
  if (kind === 'obstacle') moveObstacle(picture, id, to.map((x, i) => x - from[i]));
  else if (kind === 'outlet') moveOutlet(picture, id, to);
  else {
    const ghost = picture.drawn.ghosts.find(({ name }) => name === id);
    if (ghost) picture.frame.point(to, ghost.position);
  }
}

"""Can the better order of rewinding be predicted from the raw path (the paper, section 5.2)?

Plans random scenes of three prisms, rewinds each raw path of Modified RRT in both orders, and counts how often simple rules name the
order that gives the shorter path: ``python python/examples/rewinding_order.py [SCENES]``.
"""

import sys

import numpy as np

import cdpr


def turning(path: np.ndarray) -> np.ndarray:
    """Angle by which a path turns at each inner waypoint, rad."""
    steps = np.diff(path, axis=0)
    steps /= np.linalg.norm(steps, axis=1)[:, None]
    return np.arccos(np.clip((steps[:-1] * steps[1:]).sum(axis=1), -1, 1))


def rules(path: np.ndarray) -> dict[str, float]:
    """Numbers of a path that are positive where backward first is expected to win."""
    segments, angles = np.linalg.norm(np.diff(path, axis=0), axis=1), turning(path)
    return {
        "the first segment is longer than the last": segments[0] - segments[-1],
        "more of its length is in the first half": segments[: len(segments) // 2].sum() - segments[(len(segments) + 1) // 2 :].sum(),
        "it turns more in the first half": angles[: len(angles) // 2].sum() - angles[(len(angles) + 1) // 2 :].sum(),
        "its first bend is the sharper one": angles[0] - angles[-1],
    }


def random_scene(base: cdpr.Scene, rng: np.random.Generator) -> cdpr.Scene:
    """Three upright prisms of the paper's Table 1."""
    scene = base
    for k in range(3):
        width, height = rng.uniform(0.1, 0.3), rng.uniform(0.5, 1.5)
        x, y = rng.uniform(width / 2, 2 - width / 2, 2)
        scene = scene.with_obstacle(f"prism {k}", {"box": [width, width, height], "position": [x, y, height / 2]})
    return scene


def main(scenes: int) -> None:
    base, rng = cdpr.example("empty"), np.random.default_rng(8)
    features, gains = [], []
    for seed in range(scenes):
        scene = random_scene(base, rng)
        if not scene.states_valid([scene.start, scene.goal]).all():
            continue
        raw = cdpr.plan(scene, "modified-rrt", seed=seed, post="none", max_samples=2000)
        if not raw.solved or len(raw.waypoints) < 3:
            continue
        backward, forward = (cdpr.rewind(scene, raw, order=order).cost for order in ("backward", "forward"))
        features.append(list(rules(raw.waypoints).values()))
        gains.append((forward - backward) / raw.cost)
    x, gain = np.array(features), np.array(gains)
    matters = np.abs(gain) > 1e-4
    print(f"{len(gain)} paths with a bend, {matters.sum()} on which the orders differ by more than 0.01 % of the raw path;")
    print(f"backward first is better on {100 * (gain[matters] > 0).mean():.1f} % of them")
    for name, value in zip(rules(np.eye(3)), x[matters].T, strict=True):
        told = value != 0
        right = (value[told] > 0) == (gain[matters][told] > 0)
        kept = 100 * np.where(value[told] > 0, gain[matters][told], -gain[matters][told]).mean() / 2
        spread = 196 * np.sqrt(right.mean() * (1 - right.mean()) / right.size)
        print(f"if {name}: right in {100 * right.mean():.1f} ± {spread:.1f} % of {right.size}, gains {kept:.2f} points over a coin")
    both = 50 * np.abs(gain[matters]).mean()
    print(f"running both orders gains {both:.2f} points over a coin")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2000)

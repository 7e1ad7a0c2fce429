"""How many interferences between cables are missed if distances are measured at samples along a motion only.

The paper (section 3.2) says of checks by the distances of cables that they are "not proper to plan a path". This example
takes random motions of the robot of full rank in the paper's cube, without obstacles, decides each as a whole, and
measures the distances of all pairs of cables at samples, a step apart. A motion that touches is missed if no sample
shows it.

    python python/examples/sampled_interference.py [MOTIONS]
"""

import sys
from itertools import combinations

import numpy as np

import cdpr

DIAMETERS = (0.002, 0.01, 0.05)  # m
STEPS = (0.1, 0.05, 0.02, 0.01)  # m


def segment_distances(p, u, q, v):
    """Distances between the segments p + [0, 1] u and q + [0, 1] v, (n, 3) each, by their closest points."""
    w = p - q
    a, b, c = (u * u).sum(1), (u * v).sum(1), (v * v).sum(1)
    d, e = (u * w).sum(1), (v * w).sum(1)
    # The least of the inner solution, if it is inside both, and of the four ends against the other segment.
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = (b * e - c * d) / (a * c - b * b), (a * e - b * d) / (a * c - b * b)
    inside = (s >= 0) & (s <= 1) & (t >= 0) & (t <= 1)
    places = [(np.where(inside, s, 0.0), np.where(inside, t, 0.0))]
    places += [(np.full_like(a, end), np.clip((e + end * b) / c, 0, 1)) for end in (0.0, 1.0)]
    places += [(np.clip((end * b - d) / a, 0, 1), np.full_like(a, end)) for end in (0.0, 1.0)]
    return np.min([np.linalg.norm(w + s[:, None] * u - t[:, None] * v, axis=1) for s, t in places], axis=0)


def nearest_cables(robot, positions):
    """The least distance between two cables at each position, m."""
    outlets, attachments = np.array(robot.outlets), np.array(robot.attachments)
    least = np.full(len(positions), np.inf)
    for i, j in combinations(range(len(outlets)), 2):
        ends = positions + attachments[i], positions + attachments[j]
        starts = np.broadcast_to(outlets[i], ends[0].shape), np.broadcast_to(outlets[j], ends[1].shape)
        least = np.minimum(least, segment_distances(starts[0], ends[0] - starts[0], starts[1], ends[1] - starts[1]))
    return least


def thick(scene, diameter):
    spec = scene.to_dict()
    for cable in spec["robot"]["cables"]:
        cable["diameter"] = diameter
    return cdpr.Scene.from_dict(spec)


def main(count: int) -> None:
    thin = cdpr.example("empty_rank6")
    rng = np.random.default_rng(3)
    low, high = thin.workspace
    print("diameter  " + "  ".join(f"step {step:g} m" for step in STEPS) + "   of motions that touch")
    for diameter in DIAMETERS:
        scene = thick(thin, diameter)
        ends = rng.uniform(low, high, (8 * count, 3))
        ends = ends[scene.states_valid(ends)][: 2 * count]
        starts, goals = ends[: len(ends) // 2], ends[len(ends) // 2 :][: len(ends) // 2]
        touching = ~scene.motions_valid(starts, goals)
        missed = []
        for step in STEPS:
            seen = 0
            for start, goal in zip(starts[touching], goals[touching], strict=True):
                samples = max(2, int(np.linalg.norm(goal - start) / step) + 2)
                along = start + np.linspace(0, 1, samples)[:, None] * (goal - start)
                seen += (nearest_cables(scene.robot, along) < diameter).any()
            missed.append(100 * (1 - seen / touching.sum()))
        shares = "  ".join(f"{share:8.1f} %" for share in missed)
        print(f"{1e3 * diameter:5.0f} mm  {shares}   {touching.sum()} of {len(starts)}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 3000)

"""Algorithm 2 of the paper, as printed but with the missing line that adds the support point, on four pairs of cubes.

Prints whether each pair meets: None where the loop does not end. docs/departures.md explains why.
"""

from itertools import combinations

import numpy as np


def nearest_to_origin(corners):
    """`minNorm` and `newSimplex`: the point of the hull with the smallest norm, and the fewest corners that contain it."""
    best = None
    for size in range(1, len(corners) + 1):
        for chosen in combinations(corners, size):
            first, edges = chosen[0], np.array([p - chosen[0] for p in chosen[1:]]).reshape(-1, 3)
            weights = np.linalg.lstsq(edges.T, -first, rcond=None)[0] if size > 1 else np.zeros(0)
            if (weights >= 0).all() and weights.sum() <= 1:
                w = first + weights @ edges
                if best is None or w @ w < best[0] @ best[0]:
                    best = w, list(chosen)
    return best


def algorithm_2(a, b, k=100):
    """Whether two convex bodies meet; None if k iterations do not decide."""

    def support(d):
        return max(a, key=lambda p: p @ d) - min(b, key=lambda p: p @ d)

    corners = [support(np.array([1.0, 0.0, 0.0]))]
    for _ in range(k):
        w, simplex = nearest_to_origin(corners)
        if not w.any():
            return True
        v = support(-w)
        if (w == v).all():
            return False
        corners = [*simplex, v]
    return None


def main() -> None:
    """Two pairs that are decided, and two that are not."""
    cube = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    for shift in ([0.5, 0.25, 0.125], [2.0, 2.0, 2.0], [2.0, 0.25, 0.25], [0.3, 0.2, 0.1]):
        print(shift, algorithm_2(cube, cube + shift))


if __name__ == "__main__":
    main()

"""Writes the meshes beside this file: `python testdata/meshes/make_meshes.py`, with NumPy and trimesh.

machine.stl, m: a machine tool, a bed with a column at its back, an L seen from the side.
platform.stl, mm: the platform of CAROCA with a chamfered underside.
"""

from pathlib import Path

import numpy as np
import trimesh

FOLDER = Path(__file__).parent
# Profile in x and z, counter-clockwise, and the triangles that fill it: bed, then column.
PROFILE = [(-1.0, 0.0), (1.2, 0.0), (1.2, 0.7), (-0.2, 0.7), (-0.2, 1.6), (-1.0, 1.6)]
FILLED = [(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)]
HALF_WIDTH = 1.5


def machine() -> trimesh.Trimesh:
    """The profile drawn out along y."""
    n = len(PROFILE)
    corners = [(x, y, z) for y in (-HALF_WIDTH, HALF_WIDTH) for x, z in PROFILE]
    sides = [face for i in range(n) for j in [(i + 1) % n] for face in ((i + n, j, i), (i + n, j + n, j))]
    ends = FILLED + [(c + n, b + n, a + n) for a, b, c in FILLED]
    return trimesh.Trimesh(corners, sides + ends, process=False)


def platform() -> trimesh.Trimesh:
    """A box of 1.2 × 0.6 × 0.4 m, narrower at the bottom."""
    top = [(x, y, z) for x in (-600, 600) for y in (-300, 300) for z in (-100, 200)]
    bottom = [(x, y, -200) for x in (-500, 500) for y in (-200, 200)]
    return trimesh.convex.convex_hull(np.array(top + bottom, dtype=float))


assert machine().is_volume and not machine().is_convex
machine().export(FOLDER / "machine.stl")
platform().export(FOLDER / "platform.stl")

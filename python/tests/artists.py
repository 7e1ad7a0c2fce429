"""Shared by the tests of figures: what has been drawn."""

import matplotlib

matplotlib.use("Agg")
import numpy as np
import pytest
from matplotlib import pyplot


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def named(ax, name):
    """Artists with this gid."""
    return [artist for artist in ax.get_children() if artist.get_gid() == name]


def points_of(line):
    return np.column_stack(line.get_data_3d())


def polygons(collection):
    """Corners of the faces of a collection in space; matplotlib has no public method for this."""
    faces, padding = collection._faces, np.broadcast_to(collection._invalid_vertices, collection._faces.shape[:2])
    return [face[~fill] for face, fill in zip(faces, padding, strict=True)]


def length(way):
    return np.linalg.norm(np.diff(way, axis=0), axis=1).sum()

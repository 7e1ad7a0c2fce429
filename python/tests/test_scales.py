"""Scenes of mixed scales: a body of a millimetre in a hall of a kilometre."""

import numpy as np
import pytest

import cdpr

HALL = 1000.0


def box(size: list[float], at: list[float]) -> list[list[float]]:
    signs = [[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
    return (np.array(signs) * size + at).tolist()


def hall(platform: float, **obstacles: list[list[float]]) -> cdpr.Scene:
    """A robot in the corners of the hall, with a cube as its platform."""
    outlets = [[x, y, z] for x in (0, HALL) for y in (0, HALL) for z in (0, HALL)]
    cube = box([platform] * 3, [0, 0, 0])
    return cdpr.Scene(cdpr.Robot(outlets, cube, [cube]), obstacles, workspace=[[0, 0, 0], [HALL] * 3])


SPECK = box([0.001] * 3, [500, 500, 500])
TOWER = box([100, 100, 800], [500, 500, 400])
SCENES = {
    "a speck in the way of a platform of a metre": (hall(1.0, speck=SPECK), [100, 500, 500], [900, 500, 500]),
    "a speck in the way of a platform as small": (hall(0.001, speck=SPECK), [499.99, 500, 500], [500.01, 500, 500]),
    "a platform of a millimetre and a tower": (hall(0.001, tower=TOWER), [100, 500, 300], [900, 500, 300]),
    "a speck beside a tower": (
        hall(1.0, tower=TOWER, speck=box([0.001] * 3, [440, 500, 300])), [100, 500, 300], [900, 500, 300],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SCENES)
def test_bodies_of_a_millimetre_in_a_hall_of_a_kilometre(name: str) -> None:
    scene, start, goal = SCENES[name]
    result = cdpr.plan(scene, start=start, goal=goal, budget=2.0)
    assert result.solved and result.cost > np.linalg.norm(np.subtract(goal, start))
    for engine in ("cspace", "gjk"):
        assert cdpr.check(scene, result, engine=engine).valid
        assert not scene.motions_valid([start], [goal], engine=engine)[0]


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("reach", [0.002, 1.0, 100.0])
def test_engines_agree_at_every_scale(name: str, reach: float) -> None:
    scene, *_ = SCENES[name]
    rng = np.random.default_rng(0)
    middles = np.array([scene.obstacles[key][0].mean(axis=0) for key in scene.obstacles])
    starts = middles[rng.integers(len(middles), size=3000)] + rng.normal(0, reach, (3000, 3))
    ends = starts + rng.normal(0, reach, (3000, 3))
    found = [scene.motions_valid(starts, ends, engine=engine) for engine in ("cspace", "gjk")]
    assert (found[0] == found[1]).all()

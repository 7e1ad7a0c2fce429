"""Wrenches on arrays: against pycapacity's hyperplane shifting, by hand, and with bad input."""

import numpy as np
import pytest
from conftest import TESTDATA
from pycapacity.algorithms import hyper_plane_shift_method

import cdpr

ROBOTS = {
    "cogiro": ([-6, -4.5, 0.2], [6, 4.5, 4.5]),
    "ipanema2": ([-3.5, -3, 0.5], [3.5, 3, 5]),
    "caroca": ([-3, -3, 0.2], [3, 3, 3]),
    "acrobot": ([0.1, 0.1, 0.1], [0.7, 0.7, 0.9]),
    "mpi_simulator": ([2, 2, 1], [10, 13, 8]),
}


@pytest.fixture(params=ROBOTS)
def built(request):
    robot = cdpr.Robot.load(TESTDATA / "robots" / f"{request.param}.toml")
    low, high = ROBOTS[request.param]
    return robot, np.random.default_rng(3).uniform(low, high, (6, 3))


def limits(robot):
    return np.array([cable["tension"] for cable in robot.to_dict()["cables"]])


def weight(robot):
    """The wrench that gravity exerts, about the platform's origin."""
    force = np.array([0, 0, -9.81 * robot.mass])
    center = np.array(robot.to_dict().get("center_of_mass", [0, 0, 0]))
    return np.concatenate([force, np.cross(center, force)])


def test_margins_agree_with_pycapacity(built):
    robot, positions = built
    low, high = limits(robot).T
    length, force, moment = 0.7, 3.0, 0.5
    scale = np.array([1, 1, 1, 1 / length, 1 / length, 1 / length])
    found = cdpr.capacity_margin(robot, positions, force=force, moment=moment, characteristic_length=length)
    for w, margin in zip(cdpr.wrench_matrix(robot, positions), found, strict=True):
        normals, offsets = hyper_plane_shift_method(scale[:, None] * w, low, high)
        normals, offsets = np.asarray(normals), np.asarray(offsets).ravel()
        sizes = np.linalg.norm(normals, axis=1)
        needed = normals @ (-weight(robot) * scale)
        needed += force * np.linalg.norm(normals[:, :3], axis=1) + moment / length * np.linalg.norm(normals[:, 3:], axis=1)
        assert margin == pytest.approx(((offsets - needed) / sizes).min(), abs=1e-7 * high.max())


@pytest.mark.parametrize(("margin", "part"), [(cdpr.force_margin, slice(0, 3)), (cdpr.moment_margin, slice(3, 6))])
def test_projected_margins_agree_with_pycapacity(built, margin, part):
    robot, positions = built
    low, high = limits(robot).T
    for w, found in zip(cdpr.wrench_matrix(robot, positions), margin(robot, positions), strict=True):
        normals, offsets = hyper_plane_shift_method(w[part], low, high)
        slack = np.asarray(offsets).ravel() - np.asarray(normals) @ -weight(robot)[part]
        least, tolerance = (slack / np.linalg.norm(normals, axis=1)).min(), 1e-7 * high.max()
        # Outside, pycapacity's facets give the largest excess over one of them; the distance is at least that.
        assert found == pytest.approx(least, abs=tolerance) if least >= 0 else found <= least + tolerance


def test_tensions_balance_the_loads_within_limits_and_cannot_be_nearer(built):
    robot, positions = built
    low, high = limits(robot).T
    load = 0.02 * high.max() * np.array([1, -0.5, 0, 0.01, 0, 0.02])
    matrices = cdpr.wrench_matrix(robot, positions)
    tensions = cdpr.tension_distribution(robot, positions, load=load)
    margins = cdpr.capacity_margin(robot, positions, load=load)
    assert (np.isnan(tensions).all(axis=1) == (margins < 0)).all()
    for w, t in zip(matrices, tensions, strict=True):
        if np.isnan(t).any():
            continue
        assert np.linalg.norm(w @ t + weight(robot) + load) <= 1e-9 * high.max()
        assert (t >= low).all() and (t <= high).all()
        # Optimality: t - middle is W^T y up to multipliers of active limits.
        free = (t > low + 1e-7 * high) & (t < high - 1e-7 * high)
        away = t - (low + high) / 2
        y = np.linalg.lstsq(w[:, free].T, away[free], rcond=None)[0]
        multipliers = w.T @ y - away
        scale = 1e-6 * high.max()
        assert np.abs(multipliers[free]).max(initial=0) <= scale
        if np.linalg.matrix_rank(w[:, free]) == 6:  # otherwise other y are possible
            assert (multipliers[t <= low] <= scale).all() and (multipliers[t >= high] >= -scale).all()


def test_a_reference_draws_the_tensions_towards_it():
    robot = cdpr.Robot.load(TESTDATA / "robots" / "ipanema2.toml")
    at = [[0, 0, 3]]
    slack, taut = (cdpr.tension_distribution(robot, at, reference=np.full(8, level)).sum() for level in (20, 150))
    assert slack < taut
    assert np.isnan(cdpr.tension_distribution(robot, [[0, 0, 40]])).all()


def test_threads_and_layout_do_not_change_margins():
    robot = cdpr.Robot.load(TESTDATA / "robots" / "cogiro.toml")
    positions = np.random.default_rng(1).uniform([-6, -4, 0], [6, 4, 4], (1001, 3))
    one = cdpr.capacity_margin(robot, positions, force=10, threads=1)
    assert (one == cdpr.capacity_margin(robot, np.asfortranarray(positions), force=10, threads=2)).all()
    assert one[17] == cdpr.capacity_margin(robot, positions[17:18], force=10)[0]
    assert cdpr.capacity_margin(robot, np.empty((0, 3))).shape == (0,)


def test_an_outlet_has_no_margin_and_no_tensions_and_no_matrix():
    robot = cdpr.Robot.load(TESTDATA / "robots" / "cogiro.toml")
    outlet = robot.outlets[:1] - robot.attachments[:1]
    assert np.isnan(cdpr.capacity_margin(robot, outlet)).all()
    assert np.isnan(cdpr.force_margin(robot, outlet)).all()
    assert np.isnan(cdpr.tension_distribution(robot, outlet)).all()
    with pytest.raises(cdpr.InputError, match=r"positions\[0\]\.cable 0: has length"):
        cdpr.wrench_matrix(robot, outlet)


def test_a_point_mass_has_forces_alone():
    outlets = [[0, 0, 3], [4, 0, 3], [0, 4, 3], [4, 4, 3]]
    robot = cdpr.Robot(outlets, np.zeros((4, 3)), [[[0, 0, 0]]], tensions=[1, 200], mass=5)
    assert cdpr.capacity_margin(robot, [[2, 2, 1]]) == cdpr.force_margin(robot, [[2, 2, 1]])
    assert np.isnan(cdpr.moment_margin(robot, [[2, 2, 1]])).all()
    with pytest.raises(cdpr.InputError, match="all attachments coincide"):
        cdpr.capacity_margin(robot, [[2, 2, 1]], moment=1)


def test_bad_input_is_named():
    robot = cdpr.Robot.load(TESTDATA / "robots" / "cogiro.toml")
    at = [[0, 0, 2]]
    for call, words in [
        (lambda: cdpr.capacity_margin(robot, at, force=-1), "force: found -1"),
        (lambda: cdpr.capacity_margin(robot, at, moment=np.nan), "moment: found NaN"),
        (lambda: cdpr.capacity_margin(robot, [[0, 0, np.nan]]), r"positions\[0\]\[2\]: found nan"),
        (lambda: cdpr.capacity_margin(robot, at, load=[1, 2, 3]), r"load: found an array of shape \(3,\)"),
        (lambda: cdpr.capacity_margin(robot, at, characteristic_length=0), "characteristic_length: found 0"),
        (lambda: cdpr.tension_distribution(robot, at, reference=[1, 2]), r"reference: .* expected \(8,\)"),
        (lambda: cdpr.capacity_margin(robot, at, orientation=[1, 1, 0, 0]), "orientation: found a quaternion"),
        (lambda: cdpr.capacity_margin(robot, at, threads=0), "threads: found 0"),
    ]:
        with pytest.raises(cdpr.InputError, match=words):
            call()
    bare = robot.to_dict()
    del bare["mass"]
    with pytest.raises(cdpr.InputError, match="mass: found none"):
        cdpr.capacity_margin(cdpr.Robot.from_dict(bare), at)


def test_a_scene_with_a_demand_is_planned_and_its_report_tells_margin_and_tensions():
    robot = cdpr.Robot.load(TESTDATA / "robots" / "cogiro.toml")
    spec = {
        "version": 1,
        "robot": robot.to_dict(),
        "workspace": {"min": [-7, -5, 0], "max": [7, 5, 5.3]},
        "obstacles": [{"name": "crate", "box": [0.8, 0.8, 1.6], "position": [0, 0, 0.8]}],
        "wrench": {"force": 60.0, "moment": 10.0},
        "query": {"start": [-4, 0, 0.5], "goal": [4, 0, 0.5]},
    }
    scene = cdpr.Scene.from_dict(spec)
    result = cdpr.plan(scene)
    report = cdpr.check(scene, result)
    assert result.solved and report.valid
    along = cdpr.tensions_along(scene, result)
    assert along.s[-1] == pytest.approx(result.cost)
    assert (along.capacity_margin >= report.min_wrench_margin["value"] - 0.01).all()
    assert report.min_wrench_margin["value"] >= 0
    assert report.tension_range["max"]["value"] == pytest.approx(np.nanmax(along.tensions), rel=1e-2)
    violation = cdpr.check(scene, [[-4, 0, 0.5], [-6.4, 0, 0.5]]).violations[0]
    assert violation.kind == "wrench" and violation.margin is None and violation.wrench_margin < 0
    assert len(violation.at_least) + len(violation.at_greatest) == 3


def test_a_map_holds_the_margins_of_its_positions_and_belongs_to_its_robot(tmp_path):
    scene = cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
    found = cdpr.wrench_map(scene, step=0.8, projected=True, threads=1)
    demand = scene.to_dict()["wrench"]
    flat = found.positions.reshape(-1, 3)
    margins = cdpr.capacity_margin(scene.robot, flat, force=demand["force"], moment=demand["moment"])
    assert (found.margin.ravel() == margins).all()
    assert np.allclose(found.force_margin.ravel(), cdpr.force_margin(scene.robot, flat))
    assert found.feasible.mean() == pytest.approx(found.share)
    assert found.volume == pytest.approx(found.feasible.sum() * 0.8**3)
    found.save(tmp_path / "map.npz")
    found.save(tmp_path / "map.vti")
    assert (np.load(tmp_path / "map.npz")["margin"] == found.margin).all()
    assert (cdpr.WrenchMap.load(tmp_path / "map.npz", scene).margin == found.margin).all()
    for other in (cdpr.Scene.load(TESTDATA / "scenes/caroca.toml"),):
        with pytest.raises(cdpr.InputError, match="another|differ|found"):
            cdpr.WrenchMap.load(tmp_path / "map.npz", other)
    with pytest.raises(cdpr.InputError):
        cdpr.WrenchMap.load(tmp_path / "map.npz", scene, force=1.0)
    (tmp_path / "torn.npz").write_bytes((tmp_path / "map.npz").read_bytes()[:500])
    with pytest.raises(cdpr.CdprError, match="torn.npz"):
        cdpr.WrenchMap.load(tmp_path / "torn.npz")
    with pytest.raises(cdpr.InputError, match="step"):
        cdpr.wrench_map(scene, step=1e-9)


def test_available_sets_reach_as_far_as_the_tensions_allow(empty):
    forces, moments = cdpr.force_set(empty.robot, [0.7, 1.2, 0.8]), cdpr.moment_set(empty.robot, [0.7, 1.2, 0.8])
    assert forces.rank == 3 and forces.triangles.max() < len(forces.vertices)
    w = cdpr.wrench_matrix(empty.robot, [[0.7, 1.2, 0.8]])[0]
    for found, rows in ((forces, w[:3]), (moments, w[3:])):
        direction = np.array([0.3, -0.5, 0.8])
        pull = direction @ rows
        support = np.where(pull > 0, 1000, 10) @ pull  # every cable at the limit that extends farthest
        assert (found.vertices @ direction).max() == pytest.approx(support)
    ball = cdpr.Robot([[0, 0, 1], [1, 0, 1]], [[0, 0, 0]] * 2, [[[0, 0, 0]]], mass=1, tensions=[1, 9])
    with pytest.raises(cdpr.InputError, match="attachments coincide"):
        cdpr.moment_set(ball, [0, 0, 0])
    with pytest.raises(cdpr.InputError, match=r"position: found an array of shape \(2,\)"):
        cdpr.force_set(ball, [0, 0])


def test_every_load_case_counts():
    cogiro = cdpr.Scene.load("testdata/scenes/cogiro.toml")
    wrench = {"force": 50.0, "moment": 5.0}

    def under(mass=91.058, **loads):
        robot = cogiro.to_dict()["robot"] | {"mass": mass}
        return cdpr.Scene.from_dict(cogiro.to_dict() | {"robot": robot, "wrench": wrench | loads})

    side, at = [400.0, 0, 0, 0, 0, 0], [2.5, 1.0, 1.0]
    with pytest.warns(cdpr.CdprWarning, match="every load case"):
        several = under(loads=[[0.0] * 6, side], payload=80.0)
    with pytest.warns(cdpr.CdprWarning, match="list both as `loads`"):
        alone = [under(mass, load=load) for mass in (91.058, 171.058) for load in ([1e-12, 0, 0, 0, 0, 0], side)]
    reports = [cdpr.wrench_at(scene, at) for scene in alone]
    least = min(reports, key=lambda report: report.capacity_margin)
    report = cdpr.wrench_at(several, at)
    assert report.capacity_margin == pytest.approx(least.capacity_margin, abs=1e-6)
    assert report.feasible == all(each.feasible for each in reports)
    names = [f"load {k} of 2 {how} the payload" for how in ("without", "with") for k in (1, 2)]
    assert report.load_case == names[reports.index(least)]
    assert reports[0].load_case is None

    with pytest.raises(cdpr.InputError, match="found 4 load cases, expected one: a map is for one"):
        cdpr.wrench_map(several, step=1.0)
    found = cogiro.replace(wrench={"payload": 4000.0}).explain_motion(cogiro.start, cogiro.start)
    assert found.kind == "wrench" and found.load_case == "with the payload" and "with the payload" in repr(found)

"""Figures: they draw what they claim, and reject bad input with a message."""

import sys
import warnings

import matplotlib
import numpy as np
import pytest
from artists import closed, length, named, points_of, polygons  # noqa: F401 (fixture)
from conftest import ROOT, TESTDATA
from matplotlib import pyplot
from matplotlib.colors import to_hex
from matplotlib.text import Text
from mpl_toolkits.mplot3d.art3d import Line3D, Poly3DCollection

import cdpr
from cdpr import figures
from cdpr._batch import load_tables
from cdpr.figures.__main__ import main
from cdpr.figures._polyhedra import Solid, back_to_front, faces_of_mesh, hidden, overlap, visible

VIEWS = [(22.0, -62.0), (35.0, 40.0), (80.0, 170.0)]
BOX = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
BOX_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


@pytest.fixture
def hard3():
    return cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")


@pytest.fixture(scope="module")
def steps():
    return cdpr.run_batch(ROOT / "experiments/fig7.toml", trials=4)


@pytest.fixture(scope="module")
def repeated():
    return cdpr.run_batch(ROOT / "experiments/fig8.toml", trials=12)


@pytest.fixture(scope="module")
def methods():
    return cdpr.run_batch(ROOT / "experiments/table2.toml", trials=5)


def toward(ax):
    up, around = np.radians([ax.elev, ax.azim])
    return np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])


def box(low, size, name="box"):
    return Solid(np.array(low) + np.array(size) * BOX, BOX_FACES, "#ffffff", name)


@pytest.mark.parametrize("view", VIEWS)
def test_every_cable_goes_from_its_outlet_to_its_attachment(empty, view):
    position = np.array([0.7, 1.2, 0.8])
    ax = figures.scene(empty, at=position, view=view)
    robot = empty.robot
    platform = Solid(*platform_of(ax), "#ffffff", "platform")
    seen = 0
    for k, (outlet, attachment) in enumerate(zip(robot.outlets, robot.attachments, strict=True)):
        (line,) = named(ax, f"cable {k}")
        ends = outlet, position + attachment
        drawn = points_of(line)
        (marker,) = named(ax, f"outlet of cable {k}")
        assert (points_of(marker) == outlet).all()
        if hidden(platform, *ends, toward(ax)) is None:
            assert (drawn == ends).all()
            seen += 1
        else:  # it passes behind the platform: the visible rest lies on the same line
            shown = drawn[np.isfinite(drawn).all(axis=1)]
            away = np.cross(shown - ends[0], (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0]))
            assert (drawn[0] == outlet).all() and np.abs(away).max() < 1e-12
    assert seen >= 5
    assert len([c for c in ax.get_children() if isinstance(c, Line3D) and str(c.get_gid()).startswith("cable ")]) == 8


def platform_of(ax):
    """The platform of the paper's robot as drawn: corners of its visible faces, completed by symmetry."""
    (drawn,) = named(ax, "platform")
    corners = np.vstack(polygons(drawn))
    low, high = corners.min(axis=0), corners.max(axis=0)
    return low + (high - low) * BOX, BOX_FACES


def test_the_platform_is_where_it_was_put_and_turned_as_the_scene_says(empty):
    spec = empty.to_dict()
    spec["query"]["orientation"] = [np.cos(np.pi / 8), 0, 0, np.sin(np.pi / 8)]  # 45 degrees around z
    ax = figures.scene(cdpr.Scene.from_dict(spec), at=[1, 1, 1])
    corners, _ = platform_of(ax)
    half = 0.075 * np.sqrt(2)
    assert corners.min(axis=0) == pytest.approx([1 - half, 1 - half, 0.975])
    assert corners.max(axis=0) == pytest.approx([1 + half, 1 + half, 1.025])
    end = points_of(named(ax, "cable 5")[0])[-1]  # at the upper corner (+, −, +), which the rotation moves to +x
    assert end == pytest.approx([1 + half, 1, 1.025])


@pytest.mark.parametrize("cable", range(8))
def test_shadows_lie_behind_the_obstacle_as_seen_from_the_outlet(hard1, cable):
    name = f"cable {cable} / pillar"
    ax = figures.scene(hard1, shadows=f"cable {cable}")
    pillar = box([0.85, 0.85, 0], [0.3, 0.3, 1.5])
    outlet = hard1.robot.outlets[cable]
    drawn = [face for artist in named(ax, name) for face in polygons(artist)]
    assert drawn
    for corner in np.vstack(drawn):
        # The straight cable to any corner of the shadow touches the pillar on its way, and no corner is in front of it.
        assert float(cdpr.distance([outlet, corner], pillar.vertices)) < 1e-9
    assert not any(str(a.get_gid()).endswith("/ pillar") and a.get_gid() != name for a in ax.get_children())
    mesh = hard1.shadows()[name]
    assert {tuple(c) for c in np.vstack(drawn).round(9)} <= {tuple(c) for c in mesh.vertices.round(9)}


@pytest.mark.parametrize("view", VIEWS)
def test_a_shadows_back_is_painted_before_its_obstacle_and_its_front_after(hard1, view):
    ax = figures.scene(hard1, shadows="cable 4", robot=False, view=view)
    (pillar,) = named(ax, "pillar")
    middle, corners = np.array([1, 1, 0.75]), np.vstack(polygons(pillar))
    sides = set()
    for artist in named(ax, "cable 4 / pillar"):
        for face in polygons(artist):
            normal = np.cross(face[1] - face[0], face[2] - face[1])
            normal *= np.sign(normal @ toward(ax)) or 1
            if overlap(face, corners, toward(ax)):  # otherwise the order does not matter
                in_front = bool((face[0] - middle) @ normal > 0)
                assert (artist.zorder > pillar.zorder) == in_front
                sides.add(in_front)
    assert sides == {True, False}


def test_solids_are_painted_from_back_to_front(hard3):
    ax = figures.scene(hard3, robot=False, view=(20, -90))  # seen along y: south is nearer than west, north is last
    order = sorted(("south", "west", "north"), key=lambda name: named(ax, name)[0].zorder)
    assert order == ["north", "west", "south"]


def test_hidden_parts_agree_with_ray_casting():
    random = np.random.default_rng(3)
    solid, eye = box([0, 0, 0], [1, 2, 3]), np.array([0.6, -0.64, 0.48])
    partly = 0
    for _ in range(300):
        start, end = random.uniform(-2, 4, (2, 3))
        covered = hidden(solid, start, end, eye)
        for t in random.uniform(0, 1, 20):
            place = (1 - t) * start + t * end
            ray = [place, place + 20 * eye]
            blocked = float(cdpr.distance(ray, solid.vertices)) == 0
            inside = covered is not None and covered[0] < t < covered[1]
            if blocked != inside:  # only where the ray grazes the solid
                assert covered is not None and min(abs(t - covered[0]), abs(t - covered[1])) < 1e-4
        length = sum(np.linalg.norm(part[1] - part[0]) for part in visible([solid], start, end, eye))
        share = 0.0 if covered is None else covered[1] - covered[0]
        assert length == pytest.approx((1 - share) * np.linalg.norm(end - start), abs=1e-9)
        partly += 0 < share < 1
    assert partly > 50


def test_the_nearer_of_two_solids_is_painted_last():
    eye = np.array([0.0, -1.0, 0.0])
    wall, post = box([0, 0, 0], [10, 1, 1], "wall"), box([9.5, -0.6, 0], [0.5, 0.5, 1], "post")
    assert [s.name for s in back_to_front([post, wall], eye)] == ["wall", "post"]
    assert [s.name for s in back_to_front([wall, post], -eye)] == ["post", "wall"]


def test_faces_of_a_mesh_are_its_flat_sides(hard1):
    for mesh in hard1.shadows().values():
        faces = faces_of_mesh(mesh.vertices, mesh.triangles)
        corners, edges = len(mesh.vertices), sum(len(face) for face in faces) / 2
        assert corners - edges + len(faces) == 2  # Euler
        assert len(faces) < len(mesh.triangles)


def test_vectors_of_the_model_add_up(hard1):
    ax = figures.model(hard1, cable=4, at=[0.4, 0.5, 0.6])
    p, b, a = (points_of(named(ax, gid)[0]) for gid in "pba")
    assert (p[0] == 0).all() and (b[0] == 0).all() and (p[1] == [0.4, 0.5, 0.6]).all()
    assert (b[1] == hard1.robot.outlets[4]).all()
    assert a[1] - a[0] == pytest.approx(hard1.robot.attachments[4], abs=1e-15)
    written = {text.get_text() for text in ax.texts}
    assert {"$A_i$, attachment", "$B_i$, outlet of cable 4", "pillar", "$x_O$", "$z_P$"} <= written


@pytest.mark.parametrize("direction", ["backward", "forward"])
def test_rewinding_draws_refused_connections_and_the_final_path(hard1, direction):
    raw = cdpr.plan(hard1, "modified-rrt", seed=1, post="none").waypoints
    ax = figures.rewinding(hard1, raw, direction=direction, view=(90, -90))
    before, after = (points_of(named(ax, gid)[0]) for gid in ("before", "after"))
    assert {tuple(p) for p in before} >= {tuple(p) for p in raw}
    refused = [points_of(line) for line in named(ax, "refused")]
    assert refused
    starts, ends = (np.array([line[k] for line in refused]) for k in (0, -1))
    assert not hard1.motions_valid(starts, ends).any()
    assert hard1.motions_valid(after[:-1], after[1:]).all()
    assert length(after) < length(before)
    other = "forward" if direction == "backward" else "backward"
    second = figures.rewinding(hard1, after, direction=other, view=(90, -90))
    both = points_of(named(second, "after")[0])
    assert both == pytest.approx(cdpr.rewind(hard1, raw, order=direction).waypoints, abs=1e-12)


def test_the_ball_of_available_forces_touches_the_surface_from_inside(empty):
    position = [0.7, 1.2, 0.8]
    ax = figures.available_set(empty.robot, position)
    faces = [face for artist in named(ax, "available set") for face in polygons(artist)]
    ball = np.vstack([face for artist in named(ax, "ball") for face in polygons(artist)])
    balance = points_of(named(ax, "balance")[0])[0]
    assert balance == pytest.approx([0, 0, 98.1])
    radius = np.linalg.norm(ball - balance, axis=1)
    assert radius == pytest.approx(cdpr.force_margin(empty.robot, [position])[0])
    gaps = []
    inside = np.mean(np.vstack(faces), axis=0)
    for face in faces:
        normal = np.cross(face[1] - face[0], face[2] - face[1])
        normal *= np.sign((face[0] - inside) @ normal) / np.linalg.norm(normal)
        gaps.append((face[0] - balance) @ normal)
    assert min(gaps) == pytest.approx(radius[0], rel=1e-9)
    assert "N" in ax.get_xlabel() and f"{radius[0]:.0f} N" in ax.get_title()
    moments = figures.available_set(empty.robot, [1.2, 0.9, 0.8], kind="moment")
    assert "N·m" in moments.get_zlabel()


def test_a_step_sweep_draws_the_means_of_the_summary(steps):
    ax = figures.step_sweep(steps)
    (line,) = ax.get_lines()
    assert line.get_xdata() == pytest.approx(np.arange(1, 51) / 100)
    assert line.get_ydata() == pytest.approx(100 * steps.summary["reduction_mean"].to_numpy())
    assert ax.get_xlabel().endswith("(m)") and ax.get_ylabel().endswith("(%)")
    times = figures.step_sweep(steps, "post_seconds")
    (median,) = times.get_lines()
    assert median.get_ydata() == pytest.approx(1e6 * steps.summary["post_seconds_median"].to_numpy())


def test_repeats_draw_a_line_for_each_order(repeated):
    ax = figures.repeats(repeated)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["backward first", "forward first"]
    for container, post in zip(ax.containers, ("backward", "forward"), strict=True):
        rows = repeated.summary[repeated.summary["post"] == post]
        assert container[0].get_ydata() == pytest.approx(100 * rows["reduction_mean"].to_numpy())
        assert np.abs(container[0].get_xdata() - np.arange(1.0, 11.0)).max() < 0.1


def test_boxes_are_those_of_the_data(methods):
    ax = figures.boxes(methods, scenario="hard1", methods=["RRT*", "modified RRT"])
    trials = methods.trials
    for k, name in enumerate(("RRT*", "modified RRT")):
        costs = trials[(trials.scenario == "hard1") & (trials.method == name)].cost
        corners = ax.patches[k].get_path().vertices[:, 1]
        assert (corners.min(), corners.max()) == pytest.approx((costs.quantile(0.25), costs.quantile(0.75)))
        ys = [line.get_ydata() for line in ax.get_lines()]
        assert any(len(y) == 2 and y == pytest.approx([costs.median()] * 2) for y in ys)
        assert any(len(y) == 1 and y == pytest.approx([costs.mean()]) for y in ys)
    assert [label.get_text() for label in ax.get_xticklabels()] == ["RRT*\n(n = 5)", "modified RRT\n(n = 5)"]
    times = figures.boxes(methods, "planning_seconds", scenario="hard3")
    assert times.get_ylabel() == "planning time (ms)"


def test_charts_are_the_same_without_pandas(repeated, monkeypatch):
    with_pandas = [c[0].get_ydata() for c in figures.repeats(repeated).containers]
    monkeypatch.setitem(sys.modules, "pandas", None)
    again = cdpr.run_batch(ROOT / "experiments/fig8.toml", trials=12)
    assert isinstance(again.summary, dict)
    for expected, container in zip(with_pandas, figures.repeats(again).containers, strict=True):
        assert container[0].get_ydata() == pytest.approx(expected)
    assert len(figures.boxes(again, "reduction").patches) == 20


@pytest.fixture(scope="module")
def told():
    """A run with a history: one method that continues, one that is rewound, one that never finds a path."""
    return cdpr.run_batch(
        {
            "version": 1,
            "trials": 9,
            "history": True,
            "scenarios": [
                {"name": "hard3", "scene": str(TESTDATA / "scenes/hard3.toml")},
                {"name": "drawn", "scene": str(TESTDATA / "scenes/empty.toml"), "random": {"count": 3}},
            ],
            "methods": [
                {"name": "on", "planner": "modified-rrt", "post": "none", "options": {"keep_going": True}},
                {"name": "rewound", "planner": "modified-rrt"},
                {"name": "never", "planner": "rrt", "options": {"max_samples": 2}},
            ],
        }
    )


def curves(ax):
    return {line.get_label(): line.get_xydata() for line in ax.get_lines() if not line.get_label().startswith("_")}


@pytest.mark.long
def test_convergence_draws_medians_of_all_trials_and_shares(told):
    best = 2.656139
    lengths, shares = map(curves, figures.convergence(told, scenario="hard3", best=best))
    assert list(lengths) == list(shares) == ["on", "rewound", "never"]
    of_scene = told.history[told.history.scenario == "hard3"]
    history = of_scene[of_scene.method == "on"]
    for at in (60, 200, 350, 499):
        milliseconds, excess = lengths["on"][at]
        past = history[1000 * history.seconds <= milliseconds]
        costs = np.append(past.groupby("trial").cost.min().to_numpy(), [np.inf] * 9)[:9]
        middle = 100 * (np.sort(costs)[4] / best - 1)
        assert excess == pytest.approx(middle) if np.isfinite(middle) else np.isnan(excess)
        assert shares["on"][at][1] == pytest.approx(100 * past.trial.nunique() / 9)
    trials, timings = (table[(table.scenario == "hard3") & (table.method == "rewound")] for table in (told.trials, told.timings))
    assert lengths["rewound"][-1][1] == pytest.approx(100 * (trials.cost.median() / best - 1))
    ended = timings.planning_seconds + timings.post_seconds
    assert lengths["rewound"][-1][0] == pytest.approx(1000 * ended.max())
    assert np.isnan(lengths["never"][:, 1]).all() and (shares["never"][:, 1] == 0).all()


@pytest.mark.long
def test_convergence_in_random_scenes_compares_within_each_scene(told, monkeypatch):
    lengths, shares = map(curves, figures.convergence(told, scenario="drawn", methods=["on"]))
    trials = told.trials[told.trials.scenario == "drawn"]
    costs = trials.pivot(index="trial", columns="method", values="cost")
    excess = np.sort(100 * (costs["on"] / costs.min(axis=1) - 1).fillna(np.inf))[4]
    assert lengths["on"][-1][1] == pytest.approx(excess, abs=1e-9)
    assert shares["on"][-1][1] == pytest.approx(100 * costs["on"].notna().mean()) and list(lengths) == ["on"]


@pytest.mark.long
def test_convergence_says_what_it_needs(told, methods):
    with pytest.raises(cdpr.InputError, match="batch: found no run with a history"):
        figures.convergence(methods, scenario="hard1")
    with pytest.raises(cdpr.InputError, match="scenario: found none, expected one of hard3, drawn"):
        figures.convergence(told)
    with pytest.raises(cdpr.InputError, match="methods: found 'off', expected one of on, rewound, never"):
        figures.convergence(told, scenario="hard3", methods=["off"])


def test_a_given_axes_is_drawn_into_and_the_callers_settings_stay(hard1):
    before = dict(matplotlib.rcParams)
    figure, flat = pyplot.subplots()
    deep = figure.add_subplot(projection="3d")
    assert figures.scene(hard1, ax=deep) is deep
    assert figures.boxes({"a": [1, 2]}, ax=flat) is flat
    assert dict(matplotlib.rcParams) == before


def test_drawing_twice_writes_equal_files(hard1, tmp_path):
    for k in range(2):
        with figures.style():
            figures.scene(hard1, shadows=True).figure.savefig(tmp_path / f"{k}.svg", metadata={"Date": None})
    assert (tmp_path / "0.svg").read_bytes() == (tmp_path / "1.svg").read_bytes()


def test_pdf_files_have_truetype_fonts_and_settings_stay(hard1, tmp_path):
    before = dict(matplotlib.rcParams)
    result = cdpr.plan(hard1)
    for chart in (figures.scene(hard1, result), figures.boxes({"a": [1, 2]}), figures.along(hard1, result)[0]):
        chart.figure.savefig(tmp_path / "figure.pdf")
        assert b"/Type3" not in (tmp_path / "figure.pdf").read_bytes()
        assert b"/FontFile2" in (tmp_path / "figure.pdf").read_bytes()
    assert dict(matplotlib.rcParams) == before
    ax = pyplot.figure().add_subplot()
    with figures.style():
        figures.boxes({"a": [1, 2]}, ax=ax).figure.savefig(tmp_path / "own.pdf")
    assert b"/Type3" not in (tmp_path / "own.pdf").read_bytes()


def test_colours_are_those_of_okabe_and_ito(hard1):
    ax = figures.scene(hard1, cdpr.plan(hard1))
    assert {to_hex(line.get_color()) for line in named(ax, "path")} == {"#009e73"}
    assert all(isinstance(artist, Poly3DCollection) for artist in named(ax, "pillar"))


@pytest.mark.parametrize("name", ["acrobot", "caroca", "cogiro", "concave", "ipanema2", "mpi_simulator"])
def test_every_scene_of_testdata_can_be_drawn(name, tmp_path):
    scene = cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")
    figures.scene(scene, shadows=True).figure.savefig(tmp_path / "scene.svg")
    assert (tmp_path / "scene.svg").stat().st_size > 10_000


def test_a_planar_robot_can_be_drawn(tmp_path):
    outlets, ends = [[0, 0, 0], [2, 0, 0], [1, 2, 0]], [[-0.1, 0, 0], [0.1, 0, 0], [0, 0.1, 0]]
    flat = cdpr.Scene(cdpr.Robot(outlets, ends, [ends]), workspace=[[0, 0, -1e-3], [2, 2, 1e-3]])
    ax = figures.scene(flat, at=[1, 0.8, 0])
    ax.figure.savefig(tmp_path / "planar.svg")
    assert ax.get_zlim() == pytest.approx((-0.05, 0.05))
    assert (points_of(named(ax, "cable 2")[0]) == [[1, 2, 0], [1, 0.9, 0]]).all()


def test_rods_and_points_of_a_platform_are_drawn():
    outlets = [[x, y, 2] for x in (0, 2) for y in (0, 2)]
    rod, bob = [[-0.2, 0, 0], [0.2, 0, 0]], [[0, 0, -0.3]]
    robot = cdpr.Robot(outlets, [rod[0], rod[0], rod[1], rod[1]], [rod, bob])
    ax = figures.scene(cdpr.Scene(robot, workspace=[[0, 0, 0], [2, 2, 2]]), at=[1, 1, 1])
    line, point = named(ax, "platform")
    assert points_of(line) == pytest.approx(np.array(rod) + 1)
    assert points_of(point) == pytest.approx(np.array([[1, 1, 0.7]]))


def test_bad_input_to_figures_is_refused(hard1, steps, methods):
    straight, here = [[0.3, 1, 0.3], [1.7, 1, 1.7]], [[0.3, 1, 0.3]] * 2
    unsolved = cdpr.plan(hard1, start=[1, 1, 1])
    divided = cdpr.workspace(hard1, resolution=0.5)
    bad = (
        (lambda: figures.scene("hard1"), "scene: found the text"),
        (lambda: figures.scene(hard1, [[0, 0, 0]]), "at least two"),
        (lambda: figures.scene(hard1, unsolved), "path: found a result with status 'start_invalid'"),
        (lambda: figures.scene(hard1, at=[0, 0]), r"at: found an array of shape \(2,\)"),
        (lambda: figures.scene(hard1, shadows="cable 9"), "cable 9"),
        (lambda: figures.scene(hard1, view=(1, 2, 3)), "view"),
        (lambda: figures.scene(hard1, ax=pyplot.subplots()[1]), "ax: found Axes, expected Axes3D"),
        (lambda: figures.scene(hard1, poses=3), "poses: found a number of poses without a path"),
        (lambda: figures.scene(hard1, here, poses=0), "poses: found 0, expected 1 to 100"),
        (lambda: figures.scene(hard1, here, at=[1, 1, 1], poses=2), "at: found a position for a platform that is drawn along its path"),
        (lambda: figures.along(hard1, unsolved), "path: found a result with status 'start_invalid'"),
        (lambda: figures.along(hard1, here, ax=[]), "ax: found 0, expected 3 Axes"),
        (lambda: figures.paths(hard1, {}), "paths: found none"),
        (lambda: figures.paths(hard1, {"a": [1, 2]}), r"paths\['a'\]"),
        (lambda: figures.model(hard1, cable=8), "cable: found 8, expected a name, or a number from 0 to 7"),
        (lambda: figures.rewinding(hard1, straight), r"waypoints\[0\].*not valid"),
        (lambda: figures.rewinding(hard1, here, direction="sideways"), "expected one of backward, forward"),
        (lambda: figures.rewinding(hard1, here, step=0), "step: found 0 m"),
        (lambda: figures.available_set(hard1.robot, [1, 1, 1], kind="torque"), "kind: found 'torque'"),
        (lambda: figures.workspace(hard1), "workspace: found"),
        (lambda: figures.workspace(divided, axis="w"), 'axis: found "w", expected one of x, y, z'),
        (lambda: figures.workspace(divided, at=2), r"at: found 2 m, expected a coordinate from 0\.\d+ to 1\.\d+ m"),
        (lambda: figures.workspace(divided, at=np.nan), "at: "),
        (lambda: figures.step_sweep(methods), "does not sweep 'step'"),
        (lambda: figures.step_sweep(None), "batch: found None"),
        (lambda: figures.step_sweep(steps, "speed"), "measure: found 'speed'"),
        (lambda: figures.boxes(methods), "scenario: found none, expected one of hard1, hard3"),
        (lambda: figures.boxes(methods, scenario="hard2"), "scenario: found 'hard2'"),
        (lambda: figures.boxes(methods, scenario="hard1", methods=["RRT"]), "methods: found 'RRT'"),
        (lambda: figures.boxes({}), "data: found nothing"),
        (lambda: figures.boxes({"a": [np.nan]}), r"a: found an array of shape \(1,\), expected .* finite"),
        (lambda: figures.boxes({"a": ["b"]}), "a: found the text 'b', expected numbers"),
    )
    for call, message in bad:
        with pytest.raises(cdpr.InputError, match=message):
            call()


def test_without_matplotlib_the_error_says_how_to_get_it(monkeypatch):
    for name in [n for n in sys.modules if n.startswith("cdpr.figures")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.delattr(cdpr, "figures", raising=False)
    with pytest.raises(ImportError, match=r"pip install 'cdpr\[figures\]'"):
        __import__("cdpr.figures")


def motion_of(name, **limits):
    scene = cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")
    return cdpr.trajectory(scene, cdpr.plan(scene), **limits)


def test_a_motion_is_drawn_with_its_limits_corners_and_what_binds():
    motion = motion_of("cogiro", speed=2, acceleration=4, cable_speed=1.5, blend=0.2)
    charts = figures.trajectory(motion)
    titles = ["speed (m/s)", "acceleration (m/s²)", "cable speeds (m/s)", "tensions (N)", "limited by"]
    assert [chart.get_title("left") for chart in charts] == titles
    speed, acceleration, cables, tensions, strip = charts
    (line,) = named(speed, "speed")
    assert (line.get_ydata() == np.linalg.norm(motion.velocities, axis=1)).all() and (line.get_xdata() == motion.times).all()
    (line,) = named(acceleration, "acceleration")
    assert (line.get_ydata() == np.linalg.norm(motion.accelerations, axis=1)).all()
    for k, cable in enumerate(motion.cables):
        assert (named(cables, cable)[0].get_ydata() == motion.cable_speeds[:, k]).all()
        assert (named(tensions, cable)[0].get_ydata() == motion.tensions[:, k]).all()
        assert to_hex(named(cables, cable)[0].get_color()) == to_hex(named(tensions, cable)[0].get_color())
    drawn = [[line.get_ydata()[0] for line in named(chart, "limit")] for chart in charts[:4]]
    assert drawn == [[2.0], [4.0], [1.5, -1.5], [100.0, 5000.0]]
    assert tensions.get_title("right") == "limits 100 and 5000 N (dashed)"
    for chart in charts:
        assert [line.get_xdata()[0] for line in named(chart, "corner")] == [corner.time for corner in motion.corners]
        assert chart.get_xlim() == (0, motion.duration)
    assert [note.get_text() for note in named(speed, "waypoint")] == [str(corner.waypoint) for corner in motion.corners]
    bars = [path.get_extents() for kind in ("speed", "acceleration", "cable_speed") for bar in named(strip, kind) for path in bar.get_paths()]
    found = sorted((bar.x0, bar.x1) for bar in bars)
    assert np.allclose(found, sorted((entry.start, entry.end) for entry in motion.limiting))
    assert [tick.get_text() for tick in strip.get_yticklabels()] == ["speed", "acceleration", "cable speed"]


def test_a_motion_without_tensions_has_a_chart_less_and_far_limits_are_only_named():
    motion = motion_of("hard1", speed=30, acceleration=2, blend=0.03)
    _, axes = pyplot.subplots(4, 1)
    charts = figures.trajectory(motion, ax=axes)
    assert list(charts) == list(axes) and named(charts[0], "limit") == []
    assert charts[0].get_title("right") == "limit 30 m/s (above)" and charts[2].get_title("right") == ""
    assert charts[0].get_ylim()[1] < 3
    for wrong, message in [(axes[:3], "ax: found 3, expected 4 Axes"), (5, "ax: found 5"), ([1, 2, 3, 4], r"ax\[0\]: found 1")]:
        with pytest.raises(cdpr.InputError, match=message):
            figures.trajectory(motion, ax=wrong)
    with pytest.raises(cdpr.InputError, match="trajectory: found .*expected a Trajectory"):
        figures.trajectory(motion.positions)


RACE = {
    "version": 1,
    "trials": 4,
    "history": True,
    "scenarios": [{"name": "pillar", "scene": str(TESTDATA / "scenes/hard1.toml")}],
    "methods": [{"name": f"a method of six with a long name: {k}", "planner": "two-trees"} for k in range(6)],
}


def test_convergence_is_the_same_from_a_folder_and_includes_paths_without_a_history(tmp_path):
    def straight(scene, *, seed):
        return [scene.start, scene.goal]

    drawn = {"name": "drawn", "scene": str(TESTDATA / "scenes/empty.toml"), "random": {"count": 1}}
    methods = [{"name": "a", "planner": "two-trees", "proof": False}, {"name": "b", "planner": straight, "proof": False}]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cdpr.CdprWarning)
        batch = cdpr.run_batch({**RACE, "scenarios": [drawn], "methods": methods, "trials": 12})
    batch.save(tmp_path / "run")
    ours, folder = (figures.convergence(run) for run in (batch, load_tables(tmp_path / "run")))
    for before, after in zip(ours, folder, strict=True):
        for line, again in zip(before.lines, after.lines, strict=True):
            np.testing.assert_array_equal(line.get_xydata(), again.get_xydata())
    solved = (np.asarray(batch.trials["status"]) == "solved")[np.asarray(batch.trials["method"]) == "b"].mean()
    assert 0 < solved < 1 and ours[1].lines[2].get_ydata()[-1] == pytest.approx(100 * solved)


def extents(figure, artists):
    figure.draw_without_rendering()
    return [Text.get_window_extent(artist) if isinstance(artist, Text) else artist.get_window_extent() for artist in artists]


@pytest.mark.parametrize("name", ["turn", "hard3", "cogiro", "forest"])
def test_names_in_space_do_not_cover_each_other(name):
    scene = cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")
    ax = figures.scene(scene, cdpr.plan(scene, "rrt-connect") if name == "turn" else None)
    areas = extents(ax.figure, [text for text in ax.texts if text.get_text()])
    ticks = [text for axis in (ax.xaxis, ax.yaxis, ax.zaxis) for text in axis.get_ticklabels() if text.get_text()]
    numbers = extents(ax.figure, ticks)
    for k, area in enumerate(areas):
        others = areas[:k] + numbers
        assert not any(area.overlaps(other) for other in others), [text.get_text() for text in ax.texts][k]


def test_legends_and_labels_of_new_figures_are_inside_them_and_beside_the_data(steps, repeated):
    hard1 = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    path = cdpr.plan(hard1)
    race = cdpr.run_batch(RACE)
    charts = {
        "paths": figures.paths(hard1, {f"path number {k}, with a name": path for k in range(6)}),
        "steps": figures.step_sweep(steps),
        "repeats": figures.repeats(repeated),
        "lengths": figures.convergence(race)[0],
        "boxes": figures.boxes(race),
        "section": figures.workspace(cdpr.workspace(hard1, resolution=0.1), axis="x"),
        "moments": figures.available_set(cdpr.Robot.load(TESTDATA / "robots/paper_rank6.toml"), [0.7, 1.2, 0.8], kind="moment"),
    }
    for name, ax in charts.items():
        figure = ax.figure
        named_above = [legend for legend in (ax.get_legend(), *figure.legends) if legend is not None]
        low, high = ax.get_xlim()
        labels = [axis.label for axis in ax._axis_map.values()]
        labels += [tick for tick in ax.get_xticklabels() if low <= tick.get_position()[0] <= high]
        for area in extents(figure, [artist for artist in named_above + labels if not hasattr(artist, "get_text") or artist.get_text()]):
            assert figure.bbox.x0 <= area.x0 and area.x1 <= figure.bbox.x1, name
            assert figure.bbox.y0 <= area.y0 and area.y1 <= figure.bbox.y1, name
        for area in extents(figure, named_above):
            assert not area.overlaps(ax.bbox.padded(-1)), name


def test_names_of_many_boxes_are_turned():
    few = figures.boxes({"one name": [1, 2], "another": [2, 3]})
    many = figures.boxes({f"a rather long name {k}": [k, k + 1] for k in range(9)})
    assert few.get_xticklabels()[0].get_rotation() == 0 and few.get_xticklabels()[0].get_text() == "one name\n(n = 2)"
    assert many.get_xticklabels()[0].get_rotation() == 40 and many.get_xticklabels()[0].get_text() == "a rather long name 0 (n = 2)"


def test_the_figures_of_a_run_are_drawn_from_its_folder(steps, repeated, methods, tmp_path, monkeypatch):
    names = {
        "steps": ["01-three-prisms-modified-rrt-reduction", "02-reduction-over-step", "03-time-over-step"],
        "repeated": ["01-three-prisms-modified-rrt-reduction", "02-reduction-over-repeats", "03-time-over-repeats"],
        "methods": ["01-hard1-cost", "02-hard3-cost"],
        "race": ["01-drawn-cost", "02-drawn-convergence"],
    }
    race = {**RACE, "scenarios": [{"name": "drawn", "scene": str(TESTDATA / "scenes/empty.toml"), "random": {"count": 2}}]}
    for name, batch in (("steps", steps), ("repeated", repeated), ("methods", methods), ("race", cdpr.run_batch(race))):
        batch.save(tmp_path / name)
        monkeypatch.setattr(sys, "argv", ["figures", str(tmp_path / name), "-o", str(tmp_path / f"{name}-drawn")])
        main()
        assert sorted(file.stem for file in (tmp_path / f"{name}-drawn").iterdir()) == names[name]
    monkeypatch.setattr(sys, "argv", ["figures", str(tmp_path / "nowhere"), "-o", str(tmp_path)])
    with pytest.raises(SystemExit, match="2"):
        main()

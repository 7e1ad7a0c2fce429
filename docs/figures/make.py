"""Draw the pictures of the documentation with cdpr.figures: `make figures`, or some of them by name.

    python docs/figures/make.py fig3 fig5

Every run writes the same files, except for plots of measured times (fig7, right; planners; gap-over-time) and browser
screenshots (page, no-path-page, edit).
"""

import functools
import io
import json
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Polygon, Rectangle
from matplotlib.patheffects import withStroke
from mpl_toolkits.mplot3d import Axes3D
from PIL import Image
from playwright.sync_api import Page, sync_playwright

import cdpr
from cdpr import figures
from cdpr.figures import BLACK, BLUE, COLUMN, GREY, LIGHT, ORANGE, PAGE, SKY, VERMILION

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[1]
BROWSERS = ("chromium", "google-chrome", "chromium-browser")
SOFTWARE = ["--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
SHOWN_AT = 0.55  # of the path
NEAREST_THERE = "cable 1"
DRAG_STEPS = 40
DRAG = (640, 640), (730, 660)  # of the mouse, pixels, until nothing hides the path
METHODS = {
    "RRT*": ("rrt-star", "none"),
    "modified RRT": ("modified-rrt", "none"),
    "RRT* + post-processing": ("rrt-star", "both"),
    "modified RRT + post-processing": ("modified-rrt", "both"),
}


@functools.cache
def scene(name: str) -> cdpr.Scene:
    """A scene of testdata."""
    return cdpr.Scene.load(ROOT / f"testdata/scenes/{name}.toml")


@functools.cache
def run(name: str) -> cdpr.BatchResult:
    """A run of an experiment."""
    return cdpr.run_batch(ROOT / f"experiments/{name}.toml")


def spaces(rows: int, columns: int, height: float) -> tuple[Figure, list[Axes3D]]:
    """A page-wide figure of drawings in space."""
    figure = pyplot.figure(figsize=(PAGE, height))
    axes = [figure.add_subplot(rows, columns, k + 1, projection="3d") for k in range(rows * columns)]
    figure.subplots_adjust(left=0, right=0.97, bottom=0.06, top=0.95, wspace=0.02, hspace=0.1)
    return figure, axes


def titled(ax: Axes3D, text: str) -> None:
    """Put a title close above a drawing."""
    ax.set_title(text, y=1.02, fontsize=8)


def random_prisms(count: int, seed: int) -> cdpr.Scene:
    """The paper's robot among prisms as in its Table 1: 0.1 to 0.3 m wide, 0.5 to 1.5 m high."""
    random = np.random.default_rng(seed)
    obstacles = {}
    for k in range(count):
        wide, deep, high = random.uniform([0.1, 0.1, 0.5], [0.3, 0.3, 1.5])
        x, y = random.uniform(0.4, 1.6, 2)
        corners = np.array([[i, j, h] for i in (0, 1) for j in (0, 1) for h in (0, 1)])
        obstacles[f"O{k + 1}"] = [x, y, 0] + corners * [wide, deep, high]
    return cdpr.Scene(scene("empty").robot, obstacles, workspace=[[0, 0, 0], [2, 2, 2]])


def fig1() -> Figure:
    """Three random obstacles, and their shadows."""
    figure, (left, right) = spaces(1, 2, 3.5)
    among = random_prisms(3, seed=4)
    places = np.random.default_rng(4).uniform(0.4, 1.6, (100, 3))
    position = places[among.states_valid(places)][0]
    figures.scene(among, at=position, ax=left)
    figures.scene(among, at=position, shadows=True, labels=False, ax=right)
    titled(left, "(a) robot among three obstacles")
    titled(right, "(b) shadows of the obstacles, all cables")
    return figure


def fig2() -> Figure:
    """The model."""
    figure = pyplot.figure(figsize=(4.6, 4.2))
    ax = figure.add_subplot(projection="3d")
    figure.subplots_adjust(left=0, right=0.97, bottom=0.04, top=1)
    corners = np.array([[x, y, z] for x in (-0.35, 0.35) for y in (-0.25, 0.25) for z in (-0.15, 0.15)])
    outlets = np.array([[x, y, z] for x in (-1.5, 1.5) for y in (-1.5, 1.5) for z in (0, 3)])
    robot = cdpr.Robot(outlets, corners, [corners])
    pillar = [[x, y, z] for x in (0.8, 1.2) for y in (0.1, 0.5) for z in (0, 1.4)]
    drawn = cdpr.Scene(robot, {"obstacle": pillar}, workspace=[[-1.5, -1.5, 0], [1.5, 1.5, 3]])
    position = [-0.2, 0.2, 1.6]
    assert drawn.states_valid([position]).all()
    figures.model(drawn, cable=1, at=position, ax=ax)
    return figure


def fig3() -> Figure:
    """Shadows of one obstacle."""
    figure, (left, right) = spaces(1, 2, 3.5)
    figures.scene(scene("hard1"), shadows=["cable 1", "cable 4"], ax=left)
    figures.scene(scene("hard1_rank6"), shadows=True, labels=False, ax=right)
    titled(left, "(a) shadows for cables 1 and 4")
    titled(right, "(b) shadows for all cables of a fully constrained robot")
    return figure


def fig4() -> Figure:
    """The forces that are available at a position."""
    figure, (left, right) = spaces(1, 2, 3.6)
    position = np.random.default_rng(1).uniform(0.5, 1.5, 3).round(2)
    figures.scene(scene("empty_rank6"), at=position, labels=False, ax=left)
    figures.available_set(scene("empty_rank6").robot, position, ax=right)
    titled(left, f"(a) the platform at ({', '.join(f'{x:g}' for x in position)}) m")
    titled(right, f"(b) {right.get_title()}")
    return figure


def fig5() -> Figure:
    """Rewinding, backward and then forward."""
    figure, (left, right) = spaces(1, 2, 3.6)
    raw = cdpr.plan(scene("hard3"), "modified-rrt", seed=8, post="none").waypoints
    once = cdpr.rewind(scene("hard3"), raw, order="backward-only")
    figures.rewinding(scene("hard3"), raw, direction="backward", ax=left)
    figures.rewinding(scene("hard3"), once, direction="forward", ax=right)
    titled(left, "(a) backward")
    titled(right, "(b) then forward")
    return figure


def fig6() -> Figure:
    """Paths of the four methods."""
    figure, axes = spaces(2, 2, 7.0)
    for letter, ax, (name, (planner, post)) in zip("abcd", axes, METHODS.items(), strict=True):
        result = cdpr.plan(scene("hard1"), planner, seed=2, post=post)
        figures.paths(scene("hard1"), {name: result}, ax=ax)
        ax.get_legend().remove()
        titled(ax, f"({letter}) {name}: {result.cost:.2f} m, {len(result.waypoints)} waypoints")
    return figure


def fig7() -> Figure:
    """The step of rewinding."""
    figure, (left, right) = charts(2, 2.5)
    figures.step_sweep(run("fig7"), "reduction", ax=left)
    figures.step_sweep(run("fig7"), "post_seconds", ax=right)
    return figure


def fig8() -> Figure:
    """Order and repeats of rewinding."""
    figure, (left, right) = charts(2, 2.6)
    figures.repeats(run("fig8"), ax=left)
    trials = run("fig8").trials
    reduction = 100 * (1 - trials.cost / trials.raw_cost)
    once = {f"{order} first": f"modified RRT, {order}, repeats 01" for order in ("backward", "forward")}
    reductions = {name: reduction[trials.method == method] for name, method in once.items()}
    figures.boxes(reductions, label="reduction of path length (%)", ax=right)
    right.set_title("after one repeat", fontsize=8)
    return figure


def fig9() -> Figure:
    """The two scenes of the study and their shadows."""
    figure, axes = spaces(2, 2, 7.0)
    for row, (name, what) in enumerate((("hard1", "one obstacle"), ("hard3", "three obstacles"))):
        figures.scene(scene(name), labels=True, ax=axes[2 * row])
        figures.scene(scene(name), shadows=True, labels=False, robot=False, ax=axes[2 * row + 1])
        titled(axes[2 * row], f"({'ac'[row]}) {what}")
        titled(axes[2 * row + 1], f"({'bd'[row]}) shadows for all cables")
    return figure


def table2() -> Figure:
    """Path lengths of Table 2."""
    figure, axes = charts(2, 3.2)
    for ax, name in zip(axes, ("hard1", "hard3"), strict=True):
        figures.boxes(run("table2"), scenario=name, ax=ax)
        ax.set_title(name, fontsize=8)
    return figure


NODES = [4000, 8000, 16_000, 32_000, 64_000]
SEEDS = range(10)
BEST_KNOWN = {"hard1": 2.435167, "hard3": 2.656139}  # m


def rrt_star_convergence() -> Figure:
    """Path length of RRT* over the nodes of its tree."""
    figure, ax = pyplot.subplots(figsize=(COLUMN * 1.3, 3), layout="constrained")
    with ThreadPoolExecutor() as pool:  # planning leaves the interpreter to others
        for (name, best), colour in zip(BEST_KNOWN.items(), (BLUE, VERMILION), strict=True):
            trials = [(name, nodes, seed) for nodes in NODES for seed in SEEDS]
            found = np.reshape(list(pool.map(raw_cost, trials)), (len(NODES), len(SEEDS)))
            ax.plot(NODES, found.mean(axis=1), "o-", color=colour, label=f"{name}, mean of {len(SEEDS)} seeds")
            ax.fill_between(NODES, found.min(axis=1), found.max(axis=1), color=colour, alpha=0.2, linewidth=0)
            ax.axhline(best, color=colour, linestyle="--", linewidth=1, label=f"{name}, best known")
    ax.set(xscale="log", xlabel="nodes of the tree", ylabel="path length (m)")
    ax.minorticks_off()
    ax.set_xticks(NODES, [f"{nodes:,}" for nodes in NODES])
    ax.grid()
    figure.legend(loc="outside upper center", ncols=2)
    return figure


def raw_cost(trial: tuple[str, int, int]) -> float:
    """Length that RRT* with a ball of 0.3 m finds with so many nodes, m."""
    name, nodes, seed = trial
    options = {"post": "none", "near_radius": 0.3, "keep_going": True, "max_nodes": nodes, "max_samples": 500_000}
    return cdpr.plan(scene(name), "rrt-star", seed=seed, **options).raw_cost


def planners(*scenarios: str) -> Figure:
    """Cost against time of all planners."""
    figure, axes = pyplot.subplots(
        *(2, len(scenarios)), figsize=(PAGE, 3.6), height_ratios=[3, 1], sharex=True, sharey="row", layout="constrained"
    )
    for name, ax in zip(scenarios, axes.T, strict=True):
        figures.convergence(run("planners"), scenario=name, best=BEST_KNOWN.get(name), ax=ax)
        ax[0].set_title(name, fontsize=8)
    for ax in axes[:, 1:].flat:
        ax.set_ylabel("")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside upper center", ncols=6)
    return figure


PROVED = ["acrobot", "concave", "hard1", "hard3", "forest"]
OPEN_GAPS = ["ipanema2", "mpi_simulator", "caroca", "cogiro"]
GAPS = 10.0 ** -np.arange(0, 5.5, 0.5)
EFFORT = 60.0  # s for each gap; the first one that takes longer is a scene's last


def gap_over_time() -> Figure:
    """Proved gaps against time, in the scenes of testdata whose shortest path is not straight."""
    figure, axes = pyplot.subplots(1, 2, figsize=(PAGE, 2.9), sharex=True, sharey=True, layout="constrained")
    colours = (BLUE, VERMILION, ORANGE, SKY, BLACK)
    for ax, names in zip(axes, (PROVED, OPEN_GAPS), strict=True):
        for name, colour in zip(names, colours, strict=False):
            seconds, gaps = proved_gaps(scene(name))
            ax.plot(seconds, 100 * gaps, ".-", drawstyle="steps-post", color=colour, label=name)
        ax.set(xscale="log", yscale="log", xlabel="processor time (s)")
        ax.grid()
        ax.legend()
    axes[0].set(ylabel="proved gap (%)", title="(a) proved to less than 0.1 %")
    axes[1].set(title="(b) not proved to 1 % in 60 s")
    return figure


def proved_gaps(asked: cdpr.Scene) -> tuple[np.ndarray, np.ndarray]:
    """Smallest gaps between the best path and a bound, as shares, and the processor time after which they are proved."""
    cost = cdpr.plan(asked).cost
    found = []
    for gap in GAPS:
        began, given = time.process_time(), time.monotonic()
        bound = cdpr.lower_bound(asked, gap=gap, budget=EFFORT)
        found.append((time.process_time() - began, max(cost / bound - 1, GAPS[-1])))
        if time.monotonic() - given > EFFORT:
            break
    seconds, gaps = np.array(sorted(found)).T
    return seconds, np.minimum.accumulate(gaps)


def wrench_study() -> Figure:
    """CoGiRo's path without and with [wrench], and the slack along both."""
    spec = scene("cogiro").to_dict()
    del spec["wrench"]
    return slack_of({"without [wrench]": cdpr.Scene.from_dict(spec), "with [wrench]": scene("cogiro")})


def wrench_rules() -> Figure:
    """CoGiRo's path by the paper's rule for wrenches and by certified motions, and the slack along both."""
    paper = cdpr.Scene.load(ROOT / "experiments/scenes/cogiro_paper_rule.toml")
    return slack_of({"the paper's grid": paper, "certified": scene("cogiro")})


def slack_of(scenes: dict[str, cdpr.Scene]) -> Figure:
    """Paths planned by two variants of CoGiRo's scene, from above and from the side, and the scene's slack along both."""
    figure, axes = pyplot.subplot_mosaic(
        [["top", "along"], ["side", "along"]], figsize=(PAGE, 4), width_ratios=[1, 1.3], layout="constrained"
    )
    top, side, along = (axes[name] for name in ("top", "side", "along"))
    demanding = scene("cogiro")
    spec = demanding.to_dict()
    for (name, asked), colour in zip(scenes.items(), (VERMILION, BLUE), strict=True):
        way = cdpr.tensions_along(demanding, cdpr.plan(asked, "modified-rrt"))
        broken = np.where(way.capacity_margin < 0, 1.0, np.nan)
        for ax, x, y in (
            (top, way.positions[:, 0], way.positions[:, 1]),
            (side, way.positions[:, 0], way.positions[:, 2]),
            (along, way.s, way.capacity_margin),
        ):
            ax.plot(x, y, color=colour, linewidth=1.2, label=name)
            ax.plot(x, y * broken, color=colour, linewidth=4, alpha=0.35, solid_capstyle="butt")
    for ax, axis, title in ((top, 1, "(a) from above"), (side, 2, "(b) from the side")):
        for obstacle in spec["obstacles"]:
            middle, size = np.array(obstacle["position"]), np.array(obstacle["box"])
            corner = (middle - size / 2)[[0, axis]]
            ax.add_patch(Rectangle(corner, size[0], size[axis], facecolor=LIGHT, edgecolor=GREY))
        for end in ("start", "goal"):
            place = np.array(spec["query"][end])[[0, axis]]
            ax.plot(*place, "D", color=BLACK, markersize=3)
            ax.annotate(end, place, (5, 0), textcoords="offset points", va="bottom")
        ax.set(xlabel="x (m)", ylabel=f"{'xyz'[axis]} (m)", xlim=(-6, 6), aspect="equal", title=title)
    along.axhline(0, color=BLACK, linewidth=0.8)
    along.set(xlabel="distance along the path (m)", ylabel="capacity margin beyond the demand (N)", title="(c) slack")
    along.legend()
    return figure


OPEN, REACHED = -1, "#d7ecd9"  # region of open boxes in certificates; tint


def no_path() -> Figure:
    """Two slices through the certificate that scene closed has no path."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "proof.json"
        cdpr.plan(scene("closed")).proof.save(file)
        certificate = json.loads(file.read_text())
    boxes = np.array([row[:6] for row in certificate["boxes"]])
    regions = np.array([row[6] for row in certificate["boxes"]])
    pairs = [" and ".join(region["who"]) for region in certificate["regions"]]
    ends = {name: np.array(certificate[name]) for name in ("start", "goal")}
    reached = flood(boxes, regions == OPEN, ends["start"])
    colours = np.where(reached, REACHED, "white").astype(object)
    filled = dict(zip(pairs, (SKY, ORANGE), strict=True))
    for k, colour in enumerate(filled.values()):
        colours[regions == k] = colour
    figure, axes = charts(2, 3.7)
    for letter, ax, normal, height in zip("ab", axes, (1, 2), (ends["goal"][1], ends["goal"][2]), strict=True):
        slice_of(boxes, colours, normal, height, ax)
        for name, place in ends.items():
            if place[normal] == height:
                across = np.delete(place, normal)
                ax.plot(*across, "D", color=BLACK, markersize=4)
                words = ax.annotate(name, across, (0, 6), textcoords="offset points", ha="center", fontweight="bold")
                words.set_path_effects([withStroke(linewidth=2, foreground="white")])
        ax.set_title(f"({letter}) {'xyz'[normal]} = {height:g} m")
    patches = [Patch(facecolor=colour, edgecolor=GREY, label=f"closed by {pair}") for pair, colour in filled.items()]
    patches.append(Patch(facecolor=REACHED, edgecolor=GREY, label="open, connected with the start"))
    patches.append(Patch(facecolor="white", edgecolor=GREY, label="open, not connected with it"))
    figure.legend(handles=patches, loc="outside lower center", ncols=2)
    return figure


def flood(boxes: np.ndarray, passable: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Which boxes are connected with a point through passable boxes that touch."""
    low, high = boxes[:, :3], boxes[:, 3:]
    reached = passable & (low <= start).all(axis=1) & (start <= high).all(axis=1)
    waiting = list(np.flatnonzero(reached))
    while waiting:
        box = waiting.pop()
        touching = passable & ~reached & (low <= high[box]).all(axis=1) & (low[box] <= high).all(axis=1)
        reached |= touching
        waiting += list(np.flatnonzero(touching))
    return reached


def slice_of(boxes: np.ndarray, colours: np.ndarray, normal: int, height: float, ax: Axes) -> None:
    """Draw the boxes at a height along one axis; where two meet there, the one above."""
    u, v = np.delete(np.arange(3), normal)
    cut = (boxes[:, normal] <= height) & (height < boxes[:, normal + 3])
    low_u, low_v, high_u, high_v = (boxes[cut][:, k] for k in (u, v, u + 3, v + 3))
    corners = [(low_u, low_v), (high_u, low_v), (high_u, high_v), (low_u, high_v)]
    squares = np.array(corners).transpose(2, 0, 1)
    ax.add_collection(PolyCollection(squares, facecolors=list(colours[cut]), edgecolors=GREY, linewidths=0.4))
    ticks = np.linspace(0, 2, 5)
    ax.set(xlim=(0, 2), ylim=(0, 2), xticks=ticks, yticks=ticks, aspect="equal")
    ax.set(xlabel=f"{'xyz'[u]} (m)", ylabel=f"{'xyz'[v]} (m)")


def charts(columns: int, height: float) -> tuple[Figure, np.ndarray]:
    """A page-wide figure of charts."""
    return pyplot.subplots(1, columns, figsize=(PAGE, height), layout="constrained")


def trajectory() -> Figure:
    """A timed motion of CoGiRo."""
    path = cdpr.plan(scene("cogiro"))
    motion = cdpr.trajectory(scene("cogiro"), path, speed=2, acceleration=4, cable_speed=1.5, blend=0.2)
    figure = figures.trajectory(motion)[0].figure
    assert isinstance(figure, Figure)
    return figure


def turn() -> Figure:
    """A bar that turns on its way, and what happens along the way."""
    figure = pyplot.figure(figsize=(PAGE, 3.6))
    space = figure.add_axes((0.0, 0.08, 0.52, 0.86), projection="3d")
    above, below = (figure.add_axes((0.60, bottom, 0.38, 0.33)) for bottom in (0.57, 0.13))
    result = cdpr.plan(scene("turn"), seed=2)
    figures.scene(scene("turn"), result, poses=7, labels=False, view=(38, -62), ax=space)
    figures.along(scene("turn"), result, ax=[above, below])
    above.tick_params(labelbottom=False)
    return figure


def workspace() -> Figure:
    """A section of CoGiRo's workspace."""
    return figures.workspace(cdpr.workspace(scene("cogiro"), resolution=0.2), at=2.4).figure


def turning() -> Figure:
    """The arc of a corner of a turning platform and its chord; the deviation over the angle."""
    figure, (plan, chart) = charts(2, 2.4)
    angle, step = np.radians(100), np.array([0.9, 0.0])
    corners = np.array([[-0.35, -0.12], [0.35, -0.12], [0.35, 0.12], [-0.35, 0.12]])

    def at(share: float) -> np.ndarray:
        sine, cosine = np.sin(angle * share), np.cos(angle * share)
        return corners @ np.array([[cosine, sine], [-sine, cosine]]) + share * step

    for share in np.linspace(0, 1, 9):
        ends = share in (0, 1)
        plan.add_patch(Polygon(at(share), fill=False, edgecolor=BLACK if ends else LIGHT, linewidth=1.0 if ends else 0.6))
    shares = np.linspace(0, 1, 101)
    arc = np.array([at(share)[2] for share in shares])
    chord = arc[0] + shares[:, None] * (arc[-1] - arc[0])
    plan.plot(*arc.T, color=BLUE, label="way of a corner")
    plan.plot(*chord.T, color=BLUE, linestyle="--", linewidth=0.8, label="chord")
    plan.plot(*np.array([arc[50], chord[50]]).T, color=VERMILION, label="deviation, at most θ²ρ/8")
    plan.set_aspect("equal")
    plan.set_axis_off()
    plan.legend(loc="upper center", bbox_to_anchor=(0.5, 0), frameon=False)
    degrees = np.logspace(-1, 2, 50)
    for reach, colour in ((0.1, SKY), (0.5, BLUE), (1.0, BLACK)):
        chart.loglog(degrees, 1e3 * reach * np.radians(degrees) ** 2 / 8, color=colour, label=f"ρ = {reach:g} m")
    chart.set_xlabel("turn (°)")
    chart.set_ylabel("deviation (mm)")
    chart.legend(frameon=False)
    return figure


DRAWINGS: dict[str, Callable[[], Figure]] = {
    "fig1": fig1,
    "fig2": fig2,
    "fig3": fig3,
    "fig4": fig4,
    "fig5": fig5,
    "fig6": fig6,
    "fig7": fig7,
    "fig8": fig8,
    "fig9": fig9,
    "turn": turn,
    "workspace": workspace,
    "table2": table2,
    "rrt-star-convergence": rrt_star_convergence,
    "planners-scenes": functools.partial(planners, "hard1", "hard3", "forest"),
    "planners-random": functools.partial(planners, "3 random prisms", "6 random prisms"),
    "gap-over-time": gap_over_time,
    "wrench-study": wrench_study,
    "wrench-rules": wrench_rules,
    "no-path": no_path,
    "trajectory": trajectory,
    "turning": turning,
}


@contextmanager
def shown(question: cdpr.Scene, result: cdpr.Result, size: tuple[int, int] = (1280, 800)) -> Iterator[Page]:
    """The page of a result in a browser."""
    program = os.environ.get("CDPR_CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        raise SystemExit("found no Chromium, expected one on the path or its name in CDPR_CHROMIUM")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        view = Path(folder) / "view.html"
        cdpr.save_view(view, question, result)
        browser = playwright.chromium.launch(executable_path=program, args=SOFTWARE)
        tab = browser.new_page(viewport={"width": size[0], "height": size[1]}, color_scheme="light")
        tab.goto(view.as_uri())
        tab.wait_for_function("Boolean(window.cdprViewer?.ready)")
        yield tab
        browser.close()


def drawn(tab: Page, file: Path) -> None:
    tab.wait_for_timeout(1000)  # ms, until the picture has been drawn
    tab.screenshot(path=file)


def page(file: Path) -> None:
    """The page of a planned path, as a browser shows it: beside the pillar, whose shadow a cable avoids."""
    hard1 = scene("hard1")
    result = cdpr.plan(hard1)
    with shown(hard1, result) as tab:
        tab.evaluate("distance => window.cdprViewer.setDistance(distance)", SHOWN_AT * result.cost)
        tab.evaluate(
            """cable => {
                const { regions } = cdprViewer.layers;
                regions.visible = true;
                for (const [name, part] of Object.entries(regions.parts)) part.visible = name === cable;
            }""",
            NEAREST_THERE,
        )
        tab.mouse.move(*DRAG[0])
        tab.mouse.down()
        tab.mouse.move(*DRAG[1], steps=5)
        tab.mouse.up()
        drawn(tab, file)


def no_path_page(file: Path) -> None:
    """The page of a proof that there is no path."""
    closed = scene("closed")
    with shown(closed, cdpr.plan(closed)) as tab:
        drawn(tab, file)


def edit(file: Path) -> None:
    """The page while the pillar is dragged up and down: the path follows. An animation, from the real page with a real pointer."""
    pictures = []
    with shown(scene("hard1"), cdpr.plan(scene("hard1")), size=(1000, 640)) as tab:
        tab.keyboard.press("e")
        tab.evaluate("() => { for (const id of ['details', 'plots']) document.getElementById(id).open = false; }")
        tab.wait_for_timeout(1000)
        place = tab.evaluate("() => cdpr.where('pillar')")
        tab.mouse.move(place["x"], place["y"])
        tab.mouse.down()
        tab.keyboard.down("Shift")
        for step in range(DRAG_STEPS):
            angle = 2 * np.pi * step / (DRAG_STEPS - 1)
            tab.mouse.move(place["x"], place["y"] - 40 * np.sin(angle), steps=2)
            tab.wait_for_timeout(350)  # ms, until the path has followed
            pictures.append(picture_of(tab))
        tab.mouse.up()
        tab.keyboard.up("Shift")
        tab.wait_for_timeout(1500)
        pictures.append(picture_of(tab))
    pictures = [picture.quantize(96, dither=Image.Dither.NONE) for picture in pictures]
    times = [120] * (len(pictures) - 1) + [1500]
    pictures[0].save(file, save_all=True, append_images=pictures[1:], duration=times, loop=0, optimize=True)


def picture_of(tab: Page) -> Image.Image:
    """What the browser shows."""
    return Image.open(io.BytesIO(tab.screenshot())).convert("RGB")


PAGES = {"page": page, "no-path-page": no_path_page, "edit": edit}


KINDS = {"page": ".png", "no-path-page": ".png", "edit": ".gif"}


def main(names: list[str]) -> None:
    """Draw these, or all."""
    unknown = set(names) - {*DRAWINGS, *PAGES}
    if unknown:
        raise SystemExit(f"found {', '.join(sorted(unknown))}, expected some of {', '.join([*PAGES, *DRAWINGS])}")
    for name in names or [*DRAWINGS, *PAGES]:
        file = FOLDER / f"{name}{KINDS.get(name, '.svg')}"
        if name in PAGES:
            PAGES[name](file)
        else:
            with figures.style():
                figure = DRAWINGS[name]()
                figure.savefig(file, metadata={"Date": None})
                pyplot.close(figure)
        print(f"{file.name}: {file.stat().st_size / 1000:.0f} kB", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])

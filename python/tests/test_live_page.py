"""The page that plans, in a real browser: things are dragged with the pointer, and the path follows."""

import contextlib
import json
import math
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import program
from pages import HOSTILE, PHONE, SCENES, STATUS, Open, edit, settled, status, wait_until, where
from playwright.sync_api import Browser, Download, Locator, Page

import cdpr

PILLAR = [1.0, 1.0, 0.75]


def length_in(text: str) -> float:
    """The length at the beginning of a status line, m."""
    return float(text.split(" m")[0])


def numbers(page: Page) -> np.ndarray[Any, Any]:
    """The position in the number fields, m."""
    fields = page.locator(".edit-thing > .edit-field input")
    return np.array(fields.evaluate_all("(all) => all.map((x) => x.valueAsNumber)"))


def drag_pillar(page: Page, by: tuple[float, float]) -> None:
    """Presses on the pillar and moves the pointer until it has moved by x and y, m; the button stays down."""
    at = where(page, "pillar")
    page.mouse.move(*at)
    page.mouse.down()
    page.mouse.move(*(at + [6, 0]))
    begin, first = np.array(PILLAR), None
    columns = []
    for step in [(0, 0), (60, 0), (0, 60)]:
        page.mouse.move(*(at + step), steps=4)
        page.wait_for_timeout(120)
        first = numbers(page) if first is None else first
        columns.append((numbers(page) - first)[:2] / 60)
    place = at
    for steps in [12, 2, 2]:
        rest = np.asarray(by) - (numbers(page) - begin)[:2] if steps == 2 else by
        place = place + np.linalg.solve(np.array(columns[1:]).T, rest)
        page.mouse.move(*place, steps=steps)
        page.wait_for_timeout(200)


def saved(page: Page, what: str) -> Download:
    """Saves by the menu."""
    page.locator("summary", has_text="save").click()
    with page.expect_download() as download:
        page.get_by_role("button", name=what).click()
    return download.value


def check(scene: Path, path: Path) -> None:
    """As `cdpr check`."""
    done = subprocess.run([program(), "check", scene, path], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture
def live(open_page: Open, hard1: cdpr.Scene) -> Page:
    page = open_page(hard1, cdpr.plan(hard1, seed=0))
    edit(page)
    return page


def test_the_pillar_is_dragged_and_both_files_are_valid(live: Page, tmp_path: Path) -> None:
    before = settled(live)
    drag_pillar(live, (0.3, 0.0))
    assert np.allclose(numbers(live), [1.3, 1.0, 0.75], atol=0.011)
    live.mouse.up()
    moved = numbers(live)
    assert 0.27 < math.dist(moved, PILLAR) < 0.33
    after = settled(live)
    assert length_in(after) != length_in(before)
    files = [tmp_path / "scene.toml", tmp_path / "path.json"]
    for file, what in zip(files, ["scene (TOML)", "path (JSON)"], strict=True):
        saved(live, what).save_as(file)
    check(*files)
    assert cdpr.Scene.load(files[0]).to_dict()["obstacles"][0]["position"] == moved.tolist()
    assert json.loads(files[1].read_text())["cost"] == pytest.approx(length_in(after), abs=1e-3)


def test_a_drag_repairs_the_path_on_show(live: Page) -> None:
    settled(live)
    live.evaluate("""() => {
        const post = Worker.prototype.postMessage;
        window.asked = [];
        Worker.prototype.postMessage = function (message) { asked.push(message.request); post.call(this, message); };
    }""")
    drag_pillar(live, (0.1, 0.0))
    sketched = [one for one in live.evaluate("asked") if one and one["ask"] == "plan"]
    live.mouse.up()
    assert sketched and all(len(one["path"]["waypoints"]) > 1 for one in sketched)
    settled(live)
    last = [one for one in live.evaluate("asked") if one and one["ask"] == "plan"][-1]
    assert "path" not in last and last["options"].get("budget_ms") != sketched[0]["options"]["budget_ms"]


@pytest.mark.long
def test_the_drag_shows_paths_on_its_way_and_is_one_step(live: Page) -> None:
    before = (settled(live), live.evaluate("document.querySelector('#status').textContent"))
    drag_pillar(live, (0.1, 0.1))
    wait_until(live, "document.querySelector('.edit-text').textContent.includes('above the shortest')")
    live.mouse.up()
    settled(live)
    moved = numbers(live)
    live.keyboard.press("Control+z")
    assert (settled(live), live.evaluate("document.querySelector('#status').textContent")) == before
    assert numbers(live).tolist() == PILLAR
    assert live.get_by_role("button", name="undo").is_disabled()
    live.keyboard.press("Control+y")
    settled(live)
    assert numbers(live).tolist() == moved.tolist()


def test_pictures_are_coarser_only_while_something_is_dragged(live: Page) -> None:
    width = "document.querySelector('#view canvas').width"
    settled(live)
    before = live.evaluate(width)
    drag_pillar(live, (0.1, 0.0))
    assert live.evaluate(width) in [before, before // 2]  # the same with a graphics card
    live.mouse.up()
    settled(live)
    assert live.evaluate(width) == before


def test_a_changed_scene_is_laid_out_few_times(live: Page) -> None:
    settled(live)
    session = live.context.new_cdp_session(live)
    session.send("Performance.enable")

    def layouts() -> float:
        return next(m["value"] for m in session.send("Performance.getMetrics")["metrics"] if m["name"] == "LayoutCount")

    before = layouts()
    live.evaluate("""async () => {
        for (let k = 0; k < 10; k += 1) {
            await cdpr.move('pillar', [1, 0.85 + k / 100, 0.75]);
            await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        }
    }""")
    # 10 each; asking for the size of each label by itself makes 38 of them.
    assert layouts() - before <= 200


@pytest.mark.long
def test_escape_cancels_a_drag(live: Page) -> None:
    before = settled(live)
    drag_pillar(live, (0.3, 0.3))
    live.keyboard.press("Escape")
    live.mouse.up()
    assert settled(live) == before
    assert numbers(live).tolist() == PILLAR
    assert live.get_by_role("button", name="undo").is_disabled()


def test_things_move_along_arrows_vertically_by_keys_and_by_typing(live: Page) -> None:
    settled(live)
    live.mouse.click(*where(live, "pillar"))
    for key, moved in [("ArrowRight", [0.01, 0, 0]), ("ArrowUp", [0.01, 0.01, 0]), ("PageUp", [0.01, 0.01, 0.01])]:
        live.keyboard.press(key)
        assert np.allclose(numbers(live), np.array(PILLAR) + moved)
    live.keyboard.press("Shift+ArrowDown")
    assert np.allclose(numbers(live), [1.01, 1.01, 0.75])
    fields = live.locator(".edit-thing > .edit-field input")
    fields.nth(0).fill("1.123")
    fields.nth(0).press("Enter")
    assert numbers(live)[0] == 1.123
    at = where(live, "pillar")
    live.mouse.move(*at)
    live.keyboard.down("Shift")
    live.mouse.down()
    live.mouse.move(*(at - [0, 40]), steps=5)
    live.keyboard.up("Shift")
    live.mouse.up()
    x, y, z = numbers(live)
    assert (x, y) == (1.123, 1.01) and z > 0.8
    settled(live)


def test_an_invalid_goal_says_why_and_offers_the_nearest_place(live: Page) -> None:
    settled(live)
    live.mouse.click(*where(live, "goal"))
    for field, value in enumerate(["1", "1", "1"]):
        live.locator(".edit-thing > .edit-field input").nth(field).fill(value)
        live.locator(".edit-thing > .edit-field input").nth(field).press("Enter")
    wait_until(live, "document.querySelector('.edit-text').textContent.includes('platform meets pillar')")
    assert status(live).startswith("goal not valid: platform meets pillar, 2")
    assert status(live).endswith(" mm deep")
    # In one look, as the answer may come between two.
    assert live.evaluate("document.querySelector('html.outdated') !== null || !document.querySelector('#plots').checkVisibility()")
    live.get_by_role("button", name="move to the nearest valid place").click()
    assert "above the shortest" in settled(live) or "the shortest path" in status(live)
    assert not live.get_by_role("button", name="move to the nearest valid place").is_visible()


def field(page: Page, axis: int) -> Locator:
    """The number field of a coordinate of the selected thing."""
    return page.locator(".edit-thing > .edit-field input").nth(axis)


@pytest.mark.long
def test_numbers_are_read_as_they_are_meant(live: Page) -> None:
    before = settled(live)
    live.mouse.click(*where(live, "pillar"))
    x = field(live, 0)
    for text in ["1e308", "1e400", "nan", "", "-2e6"]:
        x.press("Control+a")
        x.press_sequentially(text or "5")
        x.press("Enter" if text else "Backspace")
        live.wait_for_timeout(50)
        live.locator("canvas").first.focus()
        assert numbers(live).tolist() == PILLAR
        assert status(live) == before
    assert live.get_by_role("button", name="undo").is_disabled()
    x.press("Control+a")
    x.press_sequentially("1,1")
    x.press("Enter")
    assert numbers(live).tolist() == [1.1, 1.0, 0.75]
    settled(live)
    x.press("Control+z")
    assert (settled(live), numbers(live).tolist()) == (before, PILLAR)


@pytest.mark.long
def test_a_number_is_not_overwritten_while_it_is_typed(live: Page) -> None:
    settled(live)
    live.mouse.click(*where(live, "pillar"))
    y = field(live, 1)
    y.press("Control+a")
    y.press_sequentially("0.9")
    live.evaluate("cdpr.plan({ seed: 2 })")
    y.press_sequentially("7")
    y.press("Enter")
    assert numbers(live).tolist() == [1.0, 0.97, 0.75]
    settled(live)


@pytest.mark.long
def test_an_obstacle_is_removed_while_it_is_dragged(live: Page) -> None:
    before = settled(live)
    drag_pillar(live, (0.1, 0.1))
    live.keyboard.press("Delete")
    live.mouse.move(400, 400, steps=4)
    live.mouse.up()
    settled(live)
    assert live.evaluate("cdpr.where('pillar')") is None
    live.keyboard.press("Control+z")
    assert settled(live) == before
    live.mouse.click(*where(live, "pillar"))
    assert numbers(live).tolist() == PILLAR


@pytest.mark.long
def test_a_held_key_is_one_step_even_where_there_is_no_path(live: Page) -> None:
    settled(live)
    live.mouse.click(*where(live, "goal"))
    # A held key plans quickly only; the goal ends below the floor.
    press = "(repeat) => dispatchEvent(new KeyboardEvent('keydown', { key: 'PageDown', repeat }))"
    for count in range(260):
        live.evaluate(press, count > 0)
    wait_until(live, "document.querySelector('.edit-text').textContent.includes('goal not valid')")
    live.evaluate("dispatchEvent(new KeyboardEvent('keyup', { key: 'PageDown' }))")
    assert settled(live).startswith("goal not valid")
    live.keyboard.press("Control+z")
    assert "longer than the straight line" in settled(live)
    assert live.get_by_role("button", name="undo").is_disabled()


def test_a_scene_that_is_refused_says_why_and_recovers(live: Page) -> None:
    before = settled(live)
    message = live.evaluate("cdpr.move('pillar', [0, 0, 0]).catch((error) => error.message)")
    assert message.startswith('robot.cables[0].outlet: found a point 150.000 mm inside obstacle "pillar"')
    assert settled(live) == message
    live.locator("summary", has_text="save").click()
    live.get_by_role("button", name="scene (TOML)").click()
    wait_until(live, "document.querySelector('.edit-text').textContent.startsWith('not saved: robot.cables[0]')")
    live.keyboard.press("Control+z")
    assert settled(live) == before


@pytest.mark.long
@pytest.mark.parametrize(
    ("call", "problem"),
    [
        ("plan({ start: [1, 2] })", "start: expected three numbers"),
        ("plan({ goal: [NaN, 1, 1] })", "goal: expected three numbers"),
        ("plan({ start: [1, 1, 1], seed: 1.5 })", "seed: expected a whole number"),
        ("plan({ seed: 1, budgetMs: 0 })", "budgetMs: expected a positive number"),
        ("move('pillar', [1, 'a', 1])", "position: expected three numbers"),
        ("move('pillar', [1e308, 1, 1])", "position: expected three numbers"),
        ("move('pillar')", "position: expected three numbers"),
    ],
)
def test_wrong_calls_change_nothing(live: Page, call: str, problem: str) -> None:
    before = settled(live)
    assert live.evaluate(f"cdpr.{call}.catch((error) => error.message)").startswith(problem)
    assert settled(live) == before
    assert live.get_by_role("button", name="undo").is_disabled()
    assert live.evaluate("cdpr.plan()")["status"] == "solved"
    assert live.get_by_role("button", name="undo").is_disabled()


@pytest.mark.long
def test_things_are_selected_by_keys(live: Page) -> None:
    settled(live)
    names = []
    for key in ["n", "n", "n", "n", "Shift+N", "Shift+N", "Shift+N", "Shift+N"]:
        live.keyboard.press(key)
        names.append(live.locator(".edit-name").inner_text())
    assert names[:4] == ["start", "goal", "pillar", "outlet of cable 0"]
    assert names[4:] == ["pillar", "goal", "start", "outlet of cable 7"]


@pytest.mark.long
def test_old_answers_are_forgotten_but_no_step(live: Page) -> None:
    first = settled(live)
    costs = live.evaluate("""async () => {
        const costs = [];
        for (let k = 0; k < 30; k += 1) costs.push((await cdpr.move('pillar', [1, 0.85 + k / 100, 0.75])).cost);
        return costs;
    }""")
    for cost in reversed(costs[:-1]):
        live.keyboard.press("Control+z")
        assert length_in(settled(live)) == pytest.approx(cost, abs=6e-4)
    live.keyboard.press("Control+z")
    assert settled(live) == first


def test_boxes_are_added_and_removed(live: Page) -> None:
    before = settled(live)
    live.get_by_role("button", name="+ box").click()
    settled(live)
    assert "box 1" in live.locator(".legend-name").all_inner_texts()
    assert live.locator(".edit-name").inner_text() == "box 1"
    live.keyboard.press("Delete")
    settled(live)
    assert "box 1" not in live.locator(".legend-name").all_inner_texts()
    live.keyboard.press("Control+z")
    live.keyboard.press("Control+z")
    assert settled(live) == before


@pytest.mark.long
def test_the_changed_page_is_saved_as_one_file(live: Page, open_page: Open, tmp_path: Path) -> None:
    settled(live)
    cost = live.evaluate("cdpr.move('pillar', [1.1, 1.1, 0.75])")["cost"]
    saved(live, "this page (HTML)").save_as(tmp_path / "changed.html")
    again = open_page(tmp_path / "changed.html", file="again.html")
    assert again.evaluate("cdprViewer.length") == pytest.approx(cost)
    edit(again)
    again.mouse.click(*where(again, "pillar"))
    assert numbers(again).tolist() == [1.1, 1.1, 0.75]
    assert again.evaluate("cdpr.plan({ seed: 0 })")["cost"] == pytest.approx(cost, rel=1e-12)


def is_long(name: str) -> list[pytest.MarkDecorator]:
    return [] if name in ["closed", "hard1"] else [pytest.mark.long]


@pytest.mark.filterwarnings("ignore:the scene lists several orientations")
@pytest.mark.parametrize("name", [pytest.param(n, marks=is_long(n)) for n in sorted(p.stem for p in SCENES.glob("*.toml"))])
def test_the_page_plans_as_the_program_does(open_page: Open, name: str) -> None:
    scene = cdpr.Scene.load(SCENES / f"{name}.toml")
    page = open_page(scene, cdpr.plan(scene, seed=0))
    for seed in [0, 3]:
        native = cdpr.plan(scene, seed=seed)
        found = page.evaluate("(seed) => cdpr.plan({ seed })", seed)
        assert found["status"] == native.status
        assert found["cost"] == (pytest.approx(native.cost, rel=1e-12) if native.solved else None)
        if native.solved:
            assert np.allclose(found["waypoints"], native.waypoints, rtol=0, atol=1e-5)


def test_plans_with_other_ends_are_shown(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1, cdpr.plan(hard1, seed=0))
    start, goal = [0.5, 1.0, 1.6], [1.0, 1.6, 1.6]
    found = page.evaluate("(ends) => cdpr.plan(ends)", {"start": start, "goal": goal})
    assert found["cost"] == pytest.approx(cdpr.plan(hard1, start=start, goal=goal, seed=0).cost, rel=1e-12)
    page.evaluate("cdprViewer.setDistance(0)")
    assert page.evaluate("cdprViewer.position()") == start
    assert page.evaluate("cdprViewer.length") == pytest.approx(found["cost"])


@pytest.mark.long
def test_a_scene_without_start_and_goal_gets_them(open_page: Open, hard1: cdpr.Scene, tmp_path: Path) -> None:
    page = open_page(hard1.replace(start=None, goal=None))
    edit(page)
    assert status(page) == "add a start and a goal to plan a path"
    first, last = page.get_by_role("button", name="+ start"), page.get_by_role("button", name="+ goal")
    first.click()
    assert np.allclose(numbers(page), [1, 1, 1]) and first.is_hidden() and last.is_visible()
    wait_until(page, f"{STATUS}.dataset.kind === 'bad'")
    assert status(page).startswith("start not valid: platform meets pillar")
    page.get_by_role("button", name="move to the nearest valid place").click()
    wait_until(page, f"{STATUS}.dataset.kind === ''")
    assert status(page) == "add a goal to plan a path"
    last.click()
    page.locator(".edit-thing input").nth(0).fill("1.7")
    page.keyboard.press("Tab")
    assert length_in(settled(page)) > 0
    scene, path = tmp_path / "scene.toml", tmp_path / "path.json"
    saved(page, "scene (TOML)").save_as(scene)
    saved(page, "path (JSON)").save_as(path)
    check(scene, path)
    undo = page.get_by_role("button", name="undo (Ctrl+Z)")
    for _ in range(4):
        undo.click()
    assert status(page) == "add a start and a goal to plan a path"
    assert page.evaluate("[cdpr.where('start'), cdpr.where('goal')]") == [None, None]


def test_what_is_missing_is_said_before_the_planner_is_ready(open_page: Open, hard1: cdpr.Scene) -> None:
    page = open_page(hard1.replace(goal=None))
    page.evaluate("void (WebAssembly.compile = () => new Promise(() => {}))")
    edit(page)
    assert status(page) == "add a goal to plan a path"


def test_without_webgl_the_scene_can_be_edited_by_scripts(browser: Browser, hard1: cdpr.Scene, tmp_path: Path) -> None:
    no_webgl = "HTMLCanvasElement.prototype.getContext = () => null"
    with phone(browser, hard1, tmp_path, no_webgl) as page:
        assert "WebGL 2 is not available" in page.locator("body").inner_text()
        page.locator("#edit-toggle").click()
        found = page.evaluate("cdpr.move('pillar', [1, 1.1, 0.75])")
        assert found["status"] == "solved" and f"{found['cost']:.3f} m" in settled(page)


def test_the_last_of_many_moves_wins(live: Page) -> None:
    answers = live.evaluate("""() => Promise.all(
        Array.from({ length: 30 }, (_, k) => cdpr.move('pillar', [1, 0.85 + k / 100, 0.75])))""")
    *others, last = [answer["status"] for answer in answers]
    assert last == "solved" and set(others) == {"superseded"}
    live.wait_for_timeout(500)
    assert live.evaluate("cdprViewer.length") == pytest.approx(answers[-1]["cost"])
    assert f"{answers[-1]['cost']:.3f} m" in status(live)


@pytest.mark.long
def test_unknown_and_hostile_names(open_page: Open, hard1: cdpr.Scene) -> None:
    spec = hard1.to_dict()
    side = {"box": [0.1, 0.1, 0.1]}
    spec["obstacles"] = [{"name": n, **side, "position": [1.0, 1.0, 0.2 + 0.3 * k]} for k, n in enumerate(HOSTILE)]
    scene = cdpr.Scene.from_dict(spec)
    page = open_page(scene, cdpr.plan(scene, seed=0))
    message = page.evaluate("cdpr.move('toString', [1, 1, 1]).catch((error) => error.message)")
    assert message.startswith('there is no obstacle "toString"; there are "')
    edit(page)
    for name in HOSTILE:
        to = [0.5, 1.5, 1.0]
        assert page.evaluate("([name, to]) => cdpr.move(name, to)", [name, to])["status"] == "solved"
        page.mouse.click(*where(page, name))
        assert page.locator(".edit-name").inner_text() == name
        assert page.evaluate("([name, to]) => cdpr.move(name, to)", [name, [1.9, 0.1, 0.1]])["status"] == "solved"
    assert page.evaluate("window.hacked") is None
    assert page.locator("#edit img, #edit script, #edit svg[onload]").count() == 0


@pytest.mark.long
def test_a_finger_selects_before_it_moves(browser: Browser, hard1: cdpr.Scene, tmp_path: Path) -> None:
    with phone(browser, hard1, tmp_path) as page:
        page.locator("#edit-toggle").tap()
        at, goal = where(page, "pillar"), where(page, "goal")
        swipe(page, at, at + [60, 0])
        assert page.locator(".edit-thing.none").count() == 1
        assert np.abs(where(page, "goal") - goal).max() > 5  # the view has turned
        page.touchscreen.tap(*where(page, "pillar"))
        assert page.locator(".edit-name").inner_text() == "pillar"
        assert numbers(page).tolist() == PILLAR
        at = where(page, "pillar") + [0, 20]
        swipe(page, at, at + [40, 0])
        settled(page)
        assert math.dist(numbers(page), PILLAR) > 0.05
        for button in page.locator("#edit button:visible").all():
            box = button.bounding_box()
            assert box and min(box["width"], box["height"]) >= 43.5


def swipe(page: Page, start: Any, end: Any) -> None:
    """A finger that goes from one place to another."""
    session = page.context.new_cdp_session(page)

    def touch(kind: str, *places: Any) -> None:
        points = [{"x": float(x), "y": float(y)} for x, y in places]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    touch("touchStart", start)
    for share in np.linspace(0.1, 1, 10):
        touch("touchMove", np.asarray(start) + share * (np.asarray(end) - start))
        page.wait_for_timeout(30)
    touch("touchEnd")
    page.wait_for_timeout(300)


@contextlib.contextmanager
def phone(browser: Browser, scene: cdpr.Scene, folder: Path, script: str = "") -> Iterator[Page]:
    cdpr.save_view(folder / "phone.html", scene, cdpr.plan(scene, seed=0))
    size = {"width": PHONE[0], "height": PHONE[1]}
    context = browser.new_context(viewport=size, has_touch=True, is_mobile=True)
    page = context.new_page()
    problems: list[str] = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    if script:
        page.add_init_script(script)
    page.goto((folder / "phone.html").as_uri())
    wait_until(page, "Boolean(window.cdprViewer?.ready)")
    yield page
    context.close()
    assert problems == []


@pytest.mark.parametrize("lacking", ["WebAssembly", "Worker", "DecompressionStream"])
def test_what_the_browser_lacks_is_said(browser: Browser, hard1: cdpr.Scene, tmp_path: Path, lacking: str) -> None:
    with phone(browser, hard1, tmp_path, f"delete window.{lacking}") as page:
        assert page.locator("#edit-toggle").count() == 0
        said = page.locator("#edit-missing").inner_text()
        assert said.startswith("Editing is not available: this browser, or this private window, lacks ")
        assert page.evaluate("cdpr.plan({}).catch((error) => error.message)") == said

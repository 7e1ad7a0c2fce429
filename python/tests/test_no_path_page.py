"""The HTML page of a scene without a path: why there is none, and what opens the way."""

import json
import math
import re

import numpy as np
import pytest
from pages import HOSTILE, SCENES, Open, picture, plain

import cdpr


@pytest.fixture(scope="module")
def closed() -> cdpr.Scene:
    return cdpr.Scene.load(SCENES / "closed.toml")


def proof_of(result: cdpr.Result) -> cdpr.Proof:
    assert result.status == "no_path" and result.proof is not None
    return result.proof


def test_a_scene_without_a_path_says_why_and_shows_it(open_page: Open, closed: cdpr.Scene) -> None:
    result = cdpr.plan(closed)
    proof, page = proof_of(result), open_page(closed, result)
    assert page.locator("#status").inner_text().split("\n") == ["no path", "proved: there is none"]
    assert page.locator("#closed-by li").all_inner_texts() == ["cable 1 and south", "cable 3 and north"]
    said = plain(page.locator("#reached").inner_text())
    assert f"({proof.reachable_volume:.4g} m³)" in said
    assert f"within {np.linalg.norm(proof.nearest_to_goal - closed.goal):.3f} m of the goal" in said
    assert re.search(r"at least 26 % of its workspace", said)
    labels = [plain(text) for text in page.locator(".label:not(.cable):visible").all_inner_texts()]
    assert {"nearest reachable", "0.625 m to the goal", "start", "goal", "south", "north"} == set(labels)
    names = page.locator(".legend-name").all_inner_texts()
    assert {"can be reached from the start", "wall that closes the way", "obstacles that close the way"} <= set(names)
    parts = "Object.keys(cdprViewer.layers.walls.parts)"
    assert page.evaluate(parts) == ["cable 1 and south", "cable 3 and north"]
    before = picture(page)
    layers = ["reachable", "walls", "culprits", "nearestReachable", "walls.parts['cable 3 and north']"]
    for layer in layers:
        page.evaluate(f"cdprViewer.layers.{layer}.visible = false")
        assert picture(page) != before, layer
        page.evaluate(f"cdprViewer.layers.{layer}.visible = true")
        assert picture(page) == before, layer


@pytest.mark.long
def test_a_proof_is_shown_between_its_own_ends(open_page: Open, closed: cdpr.Scene) -> None:
    page = open_page(closed, cdpr.plan(closed, start=[0.3, 1.0, 0.6]))
    data = json.loads(page.locator("#cdpr-data").text_content() or "")
    assert (data["start"], data["goal"]) == ([0.3, 1.0, 0.6], closed.goal.tolist())
    assert data["no_path"]["culprits"] and data["path"]["status"] == "no_path"


def test_a_button_shows_the_path_without_an_obstacle(open_page: Open, closed: cdpr.Scene) -> None:
    result = cdpr.plan(closed)
    proof, page = proof_of(result), open_page(closed, result)
    before, seen = picture(page), set()
    assert not page.locator("#transport").is_visible()
    for name in ["north", "south"]:
        cost = proof.without[name]
        button = page.get_by_role("button", name=f"without {name}")
        assert cost is not None and plain(button.inner_text()) == f"without {name}: {cost:.3f} m"
        button.click()
        assert page.locator("#remedies button[aria-pressed=true]").all_inner_texts() == [button.inner_text()]
        assert math.isclose(page.evaluate("cdprViewer.length"), cost)
        assert page.locator("#transport").is_visible()
        shown = {other: page.evaluate(f"cdprViewer.layers.obstacles.parts.{other}.visible") for other in proof.without}
        assert shown == {other: other != name for other in proof.without}
        page.evaluate("cdprViewer.setDistance(cdprViewer.length)")
        assert np.allclose(page.evaluate("cdprViewer.position()"), closed.goal)
        page.evaluate("cdprViewer.setDistance(0)")
        seen.add(picture(page))
    button.click()
    assert page.locator("#remedies button[aria-pressed=true]").count() == 0
    assert page.evaluate("cdprViewer.length") == 0 and not page.locator("#transport").is_visible()
    assert picture(page) == before and before not in seen and len(seen) == 2


@pytest.mark.long
def test_an_obstacle_that_does_not_open_the_way_alone_says_so(open_page: Open, closed: cdpr.Scene) -> None:
    twins = closed.with_obstacle("twin", {"box": [0.14, 0.14, 0.86]}, position=[1.78, 0.32, 0.43])
    result = cdpr.plan(twins)
    (still,) = [name for name, cost in proof_of(result).without.items() if cost is None]
    assert still in ("south", "twin")
    page = open_page(twins, result)
    button = page.get_by_role("button", name=f"without {still}")
    assert button.inner_text() == f"without {still}: still no path found" and button.is_disabled()


@pytest.mark.long
@pytest.mark.parametrize("look", ["light", "dark"])
def test_many_may_close_the_way_and_names_stay_names(open_page: Open, closed: cdpr.Scene, look: str) -> None:
    spec = closed.to_dict()
    spec["obstacles"][0]["name"], spec["obstacles"][1]["name"] = HOSTILE[0], "__proto__"
    scene = cdpr.Scene.from_dict(spec)
    page = open_page(scene, cdpr.plan(scene), look=look)
    assert page.locator("#closed-by li").all_inner_texts() == [f"cable 1 and {HOSTILE[0]}", "cable 3 and __proto__"]
    for button in page.locator("#remedies button").all():
        button.click()
        assert page.evaluate("cdprViewer.length") > 2
    assert page.evaluate("window.hacked") is None and page.locator("#no-path img, #no-path script").count() == 0

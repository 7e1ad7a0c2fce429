"""The HTML page of a proved workspace."""

import json
import re
import subprocess
from pathlib import Path

import pytest
from conftest import program
from pages import SCENES, Open, picture, plain

import cdpr


def test_the_page_shows_the_surface_and_says_what_takes_the_rest(open_page: Open) -> None:
    scene = cdpr.Scene.load(SCENES / "closed.toml")
    found = cdpr.workspace(scene, resolution=0.1)
    page = open_page(scene, found)
    said = page.locator("#status").inner_text().split("\n")
    assert said[0] == "workspace" and plain(said[1]) == f"{found.volume.min:.4g} to {found.volume.max:.4g} m³"
    remarks = [plain(text) for text in page.locator("#remarks p").all_inner_texts()]
    assert remarks[0].endswith("in 2 parts, start and goal in different ones")
    most_taken = max(found.shares, key=lambda kind: found.shares[kind].share)
    assert remarks[2].startswith(f"{most_taken.replace('-', ' and ')}: {100 * found.shares[most_taken].share:.1f} %")
    assert len(remarks) == 2 + len(found.shares)
    before = picture(page)
    page.evaluate("cdprViewer.layers.proved.visible = false")
    assert picture(page) != before


def test_the_page_says_at_how_many_orientations_positions_are_valid(open_page: Open) -> None:
    scene = cdpr.Scene.load(SCENES / "plank.toml")
    for valid_at, said in (
        ("every", "at every one of 2 orientations"),
        ("any", "at any of 2 orientations"),
        ("turns", "during the turns through 10 orientations"),
    ):
        found = cdpr.workspace(scene, orientations=["across", "along"], valid_at=valid_at, resolution=0.1)
        assert open_page(scene, found).locator("#remarks p").first.inner_text().endswith(f", valid {said}")


def test_the_command_writes_the_same_page(tmp_path: Path) -> None:
    scene = SCENES / "plank.toml"
    command = [program(), "workspace", scene, "--orientation", "across", "--resolution", "0.1", "--html", tmp_path / "page.html"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    loaded = cdpr.Scene.load(scene)
    found = cdpr.workspace(loaded, orientation="across", resolution=0.1)
    cdpr.save_view(tmp_path / "same.html", loaded, found)
    pages = [(tmp_path / name).read_text() for name in ("page.html", "same.html")]
    (data, same) = (json.loads(re.search(r'id="cdpr-data"[^>]*>(.*?)</script>', page, re.DOTALL)[1]) for page in pages)  # type: ignore[index]
    assert data == same and data["orientation"] != [1, 0, 0, 0] and data["proved_workspace"]["inside"]


def test_the_page_replaces_no_input_and_has_its_own_name(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    cdpr.example("hard1").save(scene)
    before = scene.read_bytes()
    for html, more, said in (
        ("scene.toml", [], "is an input of this command"),
        ("page.txt", [], "expected .html"),
        ("same.html", ["-o", "same.html"], "is the name of two outputs"),
        ("-", ["-o", "-"], "found - for both -o and --html"),
    ):
        line = [program(), "workspace", "scene.toml", "--resolution", "0.5", "--html", html, *more]
        done = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True)
        assert (done.returncode, done.stdout) == (2, "") and said in done.stderr, done.stderr
    assert scene.read_bytes() == before and list(tmp_path.iterdir()) == [scene]


def test_what_cannot_be_drawn_is_named(hard1: cdpr.Scene) -> None:
    found = cdpr.workspace(hard1, resolution=0.5)
    with pytest.raises(cdpr.InputError, match="workspace: found the workspace of .*, expected that of this scene"):
        cdpr.save_view("page.html", hard1.replace(clearance=0.01), found)
    with pytest.raises(cdpr.InputError, match="orientations: found some for a Workspace"):
        cdpr.save_view("page.html", hard1, found, orientations=[1, 0, 0, 0])
    flat = hard1.replace(workspace=([0, 0.925, 0], [2, 1.075, 2]))
    planar = cdpr.workspace(flat, resolution=0.5)
    assert planar.dimension == 2
    with pytest.raises(cdpr.InputError, match="workspace: found a flat one"):
        cdpr.save_view("page.html", flat, planar)

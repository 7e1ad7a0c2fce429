"""Every code block of the documentation runs, page by page, and prints what the page says.

The blocks of a page run in order and share one folder and one Python namespace. The folder starts empty; only pages
listed in IN_A_CLONE find testdata and experiments in it.

- `python` is executed; `sh` runs with `cdpr` on the path and must end with status 0.
- `toml` must be a valid file. If its first line is a comment with a file name, it becomes that file; a fragment of a
  scene is inserted into the scene that `cdpr new` writes.
- `text` is the output of the preceding block, except for times.
- `rust` is tested by cargo, `pycon` (examples of docstrings) by doctest, and `console` and `pyi` (help, signatures) are
  compared with the output of docs/reference/make.py, as are all pages that it generates.

Blocks that cannot run here follow `<!-- skip: next "why" -->`; SKIPPED counts them by page.
"""

import contextlib
import functools
import importlib
import importlib.util
import io
import os
import re
import shutil
import subprocess
import tomllib
import unittest
from collections import Counter
from pathlib import Path

import jsonschema
import pytest
from conftest import ROOT, TESTDATA, program
from sybil import Sybil
from sybil.evaluators.python import PythonEvaluator
from sybil.parsers.markdown import CodeBlockParser, SkipParser

import cdpr

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md")), *sorted((ROOT / "crates").glob("*/README.md"))]
NAMES = [str(page.relative_to(ROOT)) for page in PAGES]
MARKS = {
    "docs/howto/simulate.md": [pytest.mark.skipif(importlib.util.find_spec("mujoco") is None, reason="needs MuJoCo")],
    "docs/howto/stations.md": [pytest.mark.long],
}
SKIPPED = {
    "crates/cdpr-cli/README.md": 1,
    "docs/howto/cluster.md": 1,
    "docs/ompl.md": 1,
    "docs/python.md": 1,
    "docs/reproduction.md": 3,
    "docs/ros2.md": 1,
    "docs/rust.md": 2,
    "docs/tutorial.md": 1,
    "docs/understand/planners.md": 1,
    "docs/understand/wrench.md": 1,
}
# Pages that tell the reader to use a clone of the repository.
IN_A_CLONE = {"README.md", "docs/figures.md", "docs/howto/cluster.md"}
ELSEWHERE = {"rust", "pycon", "console", "pyi", "js"}
FENCE = re.compile(r"^```(.*)\n(?:.*\n)*?```$", re.MULTILINE)
TIME = re.compile(r"\d[\d.]* (ms|s|µs)\b")
RUN_BY_CARGO = re.compile(r"cargo run .*-p cdpr-cli -- ")


class Page:
    """Runs the blocks of a page in `folder`."""

    def __init__(self, folder: Path, in_a_clone: bool = False):
        self.folder = folder
        self.printed = ""
        self.python_block = PythonEvaluator()
        for name in ("testdata", "experiments") if in_a_clone else ():
            shutil.copytree(ROOT / name, folder / name)
        (folder / "bin").mkdir()
        (folder / "bin/cdpr").symlink_to(program())
        self.environment = os.environ | {"PATH": f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}"}

    def evaluators(self):
        return {"python": self.python, "sh": self.shell, "toml": self.toml, "text": self.text}

    def python(self, example):
        with contextlib.redirect_stdout(io.StringIO()) as out:
            self.python_block(example)
        self.printed = out.getvalue()

    def shell(self, example):
        script = RUN_BY_CARGO.sub("cdpr ", example.parsed)
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", script],
            env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )  # fmt: skip
        assert done.returncode == 0, f"status {done.returncode} of\n{script}\n{done.stdout}"
        self.printed = done.stdout

    def toml(self, example):
        text = str(example.parsed)
        data = tomllib.loads(text)
        if "dependencies" in data:
            for name, source in data["dependencies"].items():
                assert (ROOT / source["path"].removeprefix("../cdpr/") / "Cargo.toml").is_file(), name
        elif named := re.match(r"# (\S+\.toml)\n", text):
            (self.folder / named[1]).write_text(text)
            self.good_file(named[1], data)
        else:
            whole = tomllib.loads((self.folder / "starter.toml").read_text()) if "version" not in data else {}
            cdpr.Scene.from_dict(whole | data)

    def good_file(self, name, data):
        if "cables" in data:
            cdpr.Robot.load(name)
        elif "trials" in data:
            jsonschema.validate(data, cdpr.schema("experiment"))
        else:
            cdpr.Scene.load(name)

    def text(self, example):
        assert TIME.sub("TIME", self.printed.strip()) == TIME.sub("TIME", example.parsed.strip())


@pytest.mark.parametrize("name", [pytest.param(name, marks=MARKS.get(name, [])) for name in NAMES])
def test_a_page_does_what_it_says(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    page = Page(tmp_path, in_a_clone=name in IN_A_CLONE)
    subprocess.run([page.folder / "bin/cdpr", "new", "starter.toml"], check=True, capture_output=True)
    parsers = [CodeBlockParser(language, evaluator) for language, evaluator in page.evaluators().items()]
    skipped = []
    for example in Sybil([*parsers, SkipParser()]).parse(ROOT / name).examples():
        try:
            example.evaluate()
        except unittest.SkipTest as why:
            skipped.append(str(why))
    assert len(skipped) == SKIPPED.get(name, 0), skipped
    assert "" not in skipped


@pytest.mark.parametrize("name", NAMES)
def test_no_block_of_a_page_is_left_out(name):
    kinds = Counter(FENCE.findall((ROOT / name).read_text()))
    assert set(kinds) <= {"python", "sh", "toml", "text"} | ELSEWHERE  # no directive either: GitHub would print it


@functools.cache
def reference_maker():
    spec = importlib.util.spec_from_file_location("make_reference", ROOT / "docs/reference/make.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", ["command-line.md", "experiment.md", "python.md", "rust.md", "scene.md"])
def test_reference_pages_are_up_to_date(name, monkeypatch):
    monkeypatch.setenv("CDPR", str(program()))
    checked_in = (ROOT / "docs/reference" / name).read_text(encoding="utf-8")
    assert checked_in == reference_maker().PAGES[name](), "write it anew: make reference"


def test_reference_pages_name_everything_public():
    pages = {name: (ROOT / "docs/reference" / name).read_text(encoding="utf-8") for name in reference_maker().PAGES}
    for module in ("cdpr", "cdpr.figures", "cdpr.ompl"):
        found = importlib.import_module(module)
        public = [name for name in found.__all__ if callable(getattr(found, name))]
        assert [name for name in public if f"### {module}.{name}\n" not in pages["python.md"]] == []
    for key in cdpr.schema("scene")["properties"]:
        assert f"`{key}`" in pages["scene.md"]
    assert "cdpr wrench [OPTIONS]" in pages["command-line.md"]


MORE = ["ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "fuzz/README.md", "testdata/README.md", "viewer/README.md"]
LINK = re.compile(r"\]\(([^)\s:]*?)(#[^)\s]*)?\)")


@pytest.mark.parametrize("name", [*NAMES, *MORE])
def test_links_lead_somewhere(name):
    """On GitHub; the site's own links are checked where it is built."""
    page = ROOT / name
    for target, anchor in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        file = (page.parent / target).resolve() if target else page
        assert file.exists(), target
        if anchor and file.suffix == ".md":
            assert anchor[1:] in anchors(file), target + anchor


@functools.cache
def anchors(file):
    headings = re.findall(r"^#+ (.*)$", FENCE.sub("", file.read_text(encoding="utf-8")), re.MULTILINE)
    return {reference_maker().anchor(heading) for heading in headings}

"""The Rust sources keep the structure that ARCHITECTURE.md describes.

- No import cycles, in any crate: among the modules that one module declares, none imports itself through others. A
  re-exported name belongs to the module that defines it. A module may use what its parent modules define, and tests
  may use anything.
- ARCHITECTURE.md is short. It names every crate, and the top-level modules of the core in an order in which each uses only
  earlier ones.
- The wheel and the Rust tests share one build of the core and its dependencies.
"""

import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CRATES = sorted(path.name for path in (ROOT / "crates").iterdir())

USE = r"\buse ([^;]+);"
INLINE_PATH = r"(?<![\w:])(?:crate|super)(?:::\w+)+"
INLINE_TESTS = re.compile(r"^#\[cfg\(test\)\]\nmod \w+ \{.*?^\}", re.MULTILINE | re.DOTALL)
BRANCH = r"(?:[^,{}]|\{(?:[^{}]|\{[^{}]*\})*\})+"  # of a `use`: commas within braces do not end it

Module = tuple[str, ...]  # ("geometry", "hull"); the crate itself is ()
UsePath = list[str]  # ["super", "hull", "Facet"]


def sources(crate: str) -> dict[Module, str]:
    """The code of each module, without comments and tests."""
    folder = ROOT / "crates" / crate / "src"
    files = [file for file in folder.rglob("*.rs") if file.name != "tests.rs"]
    files = {file.relative_to(folder).with_suffix("").parts: file.read_text() for file in files}
    return {() if module in (("lib",), ("main",)) else module: code(text) for module, text in files.items()}


def code(text: str) -> str:
    return re.sub(r"//.*", "", INLINE_TESTS.sub("", text))


def used(tree: str) -> Iterator[tuple[UsePath, str]]:
    """The paths of a `use` and the names that they bind: `a::{b, c as d}` gives a::b as b and a::c as d."""
    start, brace, rest = tree.partition("{")
    if brace:
        for branch in re.findall(BRANCH, rest[: rest.rindex("}")]):
            if branch.strip():
                yield from used(start + branch.strip())
    else:
        path, _, name = tree.partition(" as ")
        parts = [part for part in path.strip().split("::") if part not in ("", "self")]
        yield parts, name.strip() or parts[-1]


class Crate:
    """The modules of a crate and what they import."""

    def __init__(self, modules: dict[Module, str]) -> None:
        self.modules = modules
        self.imports = {
            module: [import_ for tree in re.findall(USE, text) for import_ in used(tree)] for module, text in modules.items()
        }

    def needs(self, module: Module) -> set[Module]:
        """The modules of the crate that define the names that a module uses."""
        paths = [path for path, _ in self.imports[module]]
        paths += [path.split("::") for path in re.findall(INLINE_PATH, self.modules[module])]
        found = {self.defining(module, path) for path in paths}
        return {other for other in found if other not in (None, module)}

    def defining(self, module: Module, path: UsePath) -> Module | None:
        """The module that defines the target of a path, seen from a module; None outside the crate."""
        here, names = module, list(path)
        while names and names[0] in ("crate", "super"):
            here = () if names.pop(0) == "crate" else here[:-1]
        if names == path and (*module, names[0]) not in self.modules:
            return None
        while names and (*here, names[0]) in self.modules:
            here = (*here, names.pop(0))
        imported = next((path for path, name in self.imports[here] if [name] == names[:1] != ["*"]), None)
        if imported in (None, path):  # the same path: repeated by a module within the same file
            return here
        return self.defining(here, imported + names[1:]) or here

    def circles(self) -> Iterator[str]:
        """For each module, an import cycle among the modules that it declares, if there is one."""
        arrows = sorted((module, other) for module in self.modules for other in self.needs(module))
        for parent in self.modules:
            depth = len(parent)
            children: dict[str, set[str]] = {}
            for a, b in arrows:
                inside = a[:depth] == parent == b[:depth] and min(len(a), len(b)) > depth
                if inside and a[depth] != b[depth]:
                    children.setdefault(a[depth], set()).add(b[depth])
            try:
                TopologicalSorter(children).prepare()
            except CycleError as error:
                yield "::".join([*parent, " -> ".join(reversed(error.args[1]))])


@pytest.mark.parametrize("crate", CRATES)
def test_no_module_imports_itself_through_others(crate: str) -> None:
    circles = list(Crate(sources(crate)).circles())
    assert not circles, "; ".join(circles)


def test_a_circle_is_found_through_the_name_that_a_parent_exports() -> None:
    modules = {
        (): "mod low; mod room;",
        ("low",): "use crate::room::{self, b::{B}};",
        ("room",): "mod a; mod b; pub use a::A as Renamed; pub struct Own;",
        ("room", "a"): "use super::Own;",
        ("room", "b"): "use super::Renamed;",
    }
    assert list(Crate(modules).circles()) == []
    modules["room", "a"] += "fn f() -> super::b::B {}"
    assert list(Crate(modules).circles()) == ["room::a -> b -> a"]
    modules["room", "a"] = "use std::low; use crate::low::L;"
    assert list(Crate(modules).circles()) == ["low -> room -> low"]


def test_the_root_of_the_core_names_what_a_user_needs_and_hides_the_rest() -> None:
    root = (ROOT / "crates/cdpr-core/src/lib.rs").read_text(encoding="utf-8")
    shown = re.findall(r"(?<!#\[doc\(hidden\)\]\n)^pub mod (\w+);", root, re.MULTILINE)
    assert shown == []
    names = [name for tree in re.findall(r"^pub use ([^;]+);", root, re.MULTILINE) for _, name in used(tree)]
    assert {"Scene", "Query", "plan", "CompiledScene", "Trajectory", "Watch", "nalgebra"} <= set(names)
    assert len(names) <= 80


ARCHITECTURE = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
MODULES = ARCHITECTURE.partition("\n## Modules of the core\n")[2].partition("\n## ")[0]


def test_the_architecture_can_be_read_in_ten_minutes() -> None:
    assert len(ARCHITECTURE.encode()) <= 12_000


@pytest.mark.parametrize("crate", CRATES)
def test_the_architecture_names_every_crate(crate: str) -> None:
    assert f"| `{crate}` |" in ARCHITECTURE


def test_the_architecture_lists_the_modules_of_the_core_in_an_order_in_which_each_uses_only_earlier_ones() -> None:
    crate = Crate(sources("cdpr-core"))
    order = re.findall(r"^\| `(\w+)` \|", MODULES, re.MULTILINE)
    assert sorted(order) == sorted({module[0] for module in crate.modules if module})
    place = {name: place for place, name in enumerate(order)}
    arrows = {(module[0], other[0]) for module in crate.modules if module for other in crate.needs(module) if other}
    assert [f"{a} uses {b}" for a, b in sorted(arrows) if place[b] > place[a]] == []


def crates_with_features(*selected: str) -> set[str]:
    command = ["cargo", "tree", "--locked", "--prefix", "none", "--format", "{p} {f}", *selected]
    lines = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout.splitlines()
    return {line.removesuffix(" (*)") for line in lines}


@pytest.mark.skipif(shutil.which("cargo") is None, reason="needs cargo")
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the features are aligned on Linux")
def test_the_wheel_compiles_nothing_again_that_the_tests_compiled() -> None:
    wheel = crates_with_features("--package", "cdpr-py", "--edges", "normal,build")
    tests = crates_with_features("--workspace", "--exclude", "cdpr-benches")
    assert wheel <= tests, "add the missing features to crates/cdpr-py/Cargo.toml"

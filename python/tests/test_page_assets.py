"""The compiled parts of the page belong to their sources."""

import base64
import hashlib
import re
import shutil
import subprocess
import zlib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
VIEWER = ROOT / "viewer"
ASSETS = ROOT / "crates/cdpr-view/src/assets"
MOST_BYTES_OF_PLANNER = 2_460_000


def sources(asset: str) -> list[Path]:
    """The sources of an asset in the order in which viewer/build.mjs reads them."""
    listed = re.search(rf"^  {asset}: \[(.*)\],$", (VIEWER / "build.mjs").read_text(), re.MULTILINE)
    assert listed is not None
    paths = [(VIEWER / name).resolve() for name in re.findall(r"'([^']+)'", listed[1])]
    inside = [sorted(filter(Path.is_file, path.rglob("*")), key=str) if path.is_dir() else [path] for path in paths]
    return [path for group in inside for path in group if "/assets/" not in str(path)]


def compiled(rust: str) -> str:
    """What is compiled of a Rust file, as in viewer/build.mjs: neither its unit tests nor its comments."""
    tests = re.compile(r"^#\[cfg\(test\)\]\nmod \w+ \{\n.*?^\}\n", re.MULTILINE | re.DOTALL)
    return re.sub(r"^[ \t]*(//.*)?\n", "", tests.sub("", rust), flags=re.MULTILINE)


def content(path: Path) -> bytes:
    return compiled(path.read_text()).encode() if path.suffix == ".rs" else path.read_bytes()


def test_comments_and_tests_are_not_compiled() -> None:
    code = "fn f() {\n    g(); // kept: it ends a line of code\n}\n"
    assert compiled("//! Words.\n\n" + code + "    // more\n#[cfg(test)]\nmod tests {\n    use f;\n}\n") == code


@pytest.mark.parametrize("asset", ["page", "planner"])
def test_the_assets_are_built_from_their_sources(asset: str) -> None:
    found = hashlib.sha256(b"".join(map(content, sources(asset)))).hexdigest()
    built = (ASSETS / f"{asset}.sha256").read_text().strip()
    assert found == built, f"the sources of the {asset} have changed: run `make viewer`, and commit its assets"


def test_the_planner_is_a_small_webassembly_module() -> None:
    ours = "".join(chr(code) for code in range(33, 127) if chr(code) not in "\"$&'/<\\{}")  # viewer/src/base85.js
    pythons = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~"
    text = (ASSETS / "planner.txt").read_text().translate(str.maketrans(ours, pythons))
    module = zlib.decompress(base64.b85decode(text), wbits=-15)
    assert module.startswith(b"\0asm")
    assert len(module) <= MOST_BYTES_OF_PLANNER
    assert not re.search(rb"/(root|home|Users|tmp|work)/|registry", module), "it names folders of the machine that compiled it"


def test_the_script_passes_its_unit_tests() -> None:
    node = shutil.which("node")
    if node is None:
        pytest.skip("no Node found: install Node 20 or later")
    files = sorted(map(str, (VIEWER / "test").glob("*.test.js")))
    found = subprocess.run([node, "--test", *files], capture_output=True, text=True)
    assert found.returncode == 0, found.stdout + found.stderr

"""Wheel and sdist as users get them: in fresh environments, outside the checkout."""

import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest
from conftest import ROOT

WHEELS = ROOT / "target" / "wheels"

# A newcomer's first steps, without access to the checkout.
FIRST_STEPS = """
import importlib.metadata, subprocess, sys
from pathlib import Path
import numpy as np
import cdpr

home = Path(cdpr.__file__).resolve()
assert Path(sys.prefix).resolve() in home.parents, home
assert (home.parent / "py.typed").exists() and (home.parent / "_core.pyi").exists()
assert importlib.metadata.version("cdpr") == cdpr.__version__
assert set(importlib.metadata.metadata("cdpr").get_all("Provides-Extra")) >= {"figures", "ompl", "pandas"}
cube = np.array([[x, y, z] for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)])
outlets = [[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)]
scene = cdpr.Scene(cdpr.Robot(outlets, cube, [cube]), {}, workspace=[[0, 0, 0], [2, 2, 2]])
scene = scene.with_obstacle("pillar", cube * [1, 1, 6], position=[1, 1, 0.6])
scene = scene.replace(start=[0.3, 1, 0.3], goal=[1.7, 1, 1.7])
result = cdpr.plan(scene)
assert result.solved and cdpr.check(scene, result).valid and 1.98 < result.cost < 2.3, result
result.save("path.json")
cdpr.save_view("view.html", scene, result)
scene.save("scene.toml")
assert cdpr.Scene.load("scene.toml") == scene.replace(name="scene")
for name, extra in (("ompl", "ompl"), ("figures", "figures")):
    try:
        __import__(f"cdpr.{name}")
    except ImportError as problem:
        assert f"pip install 'cdpr[{extra}]'" in str(problem)
    else:
        raise AssertionError(f"{name} is here, but was not asked for")
command = [next(Path(sys.prefix).glob(f"{folder}/cdpr*")) for folder in ("bin", "Scripts") if (Path(sys.prefix) / folder).exists()][:1]
for arguments in ("new --example hard1 hard1.toml", "plan hard1.toml -o hard1.json --html hard1.html", "check hard1.toml hard1.json"):
    subprocess.run([*command, *arguments.split()], check=True, stdout=subprocess.DEVNULL)
again = subprocess.run([sys.executable, "-m", "cdpr", "check", "hard1.toml", "no.json"], capture_output=True, text=True)
assert again.returncode == 2 and "no.json" in again.stderr, again
assert cdpr.Scene.load("hard1.toml") == cdpr.example("hard1")
print("planned", round(result.cost, 3))
"""


def quiet(*command, cwd, **environment):
    """Run a program and return its output, isolated from this process's Python and build."""
    ours = ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV", "CARGO_TARGET_DIR")
    inherited = {key: value for key, value in os.environ.items() if key not in ours}
    run = subprocess.run(command, cwd=cwd, env=inherited | environment, capture_output=True, text=True)
    assert run.returncode == 0, f"{run.stdout}\n{run.stderr}"
    return run.stdout


def planned_with(package, folder, **environment):
    """Install a package into its own environment and take the first steps there."""
    quiet(sys.executable, "-m", "venv", folder / "env", cwd=folder)
    python = next(path for path in (folder / "env/bin/python", folder / "env/Scripts/python.exe") if path.exists())
    install = ("-m", "pip", "install", "--quiet", "--disable-pip-version-check", package)
    quiet(python, *install, cwd=folder, **environment)
    (folder / "elsewhere").mkdir()
    return quiet(python, "-I", "-c", FIRST_STEPS, cwd=folder / "elsewhere")


def test_the_wheel_is_for_every_python_from_3_11_on():
    (wheel,) = WHEELS.glob("*.whl")
    assert "-cp311-abi3-" in wheel.name
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {"cdpr/py.typed", "cdpr/_core.pyi", "cdpr/_core.abi3.so", "cdpr/ompl.py"} <= names
    assert not [name for name in names if "test" in name or not name.startswith("cdpr")]


@pytest.mark.long
def test_the_wheel_plans_in_an_environment_of_its_own(tmp_path):
    (wheel,) = WHEELS.glob("*.whl")
    assert planned_with(wheel, tmp_path) == "planned 2.103\n"


@pytest.mark.sdist
def test_the_sdist_builds_and_plans_outside_of_the_checkout(tmp_path):
    quiet(sys.executable, "-m", "maturin", "sdist", "--out", tmp_path, cwd=ROOT)
    (sdist,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        names = [Path(*Path(name).parts[1:]).as_posix() for name in archive.getnames()]
        texts = {name: archive.extractfile(member) for name, member in zip(names, archive.getmembers(), strict=True)}
        manifests = {name: texts[name].read().decode() for name in names if name.endswith((".toml", "PKG-INFO"))}
    assert {"Cargo.lock", "Cargo.toml", "pyproject.toml", "README.md", "LICENSE-MIT", "LICENSE-APACHE"} <= set(names)
    assert {"crates/cdpr-core/Cargo.toml", "crates/cdpr-py/Cargo.toml", "python/cdpr/py.typed"} <= set(names)
    assert not [name for name in names if name.startswith(("target/", "viewer/", ".venv/")) or "node_modules" in name]
    assert not [name for name, text in manifests.items() if str(ROOT) in text]
    # Without optimisation: only whether it builds is tested here; the wheel is tested optimised.
    assert planned_with(sdist, tmp_path, MATURIN_PEP517_ARGS="--profile dev") == "planned 2.103\n"

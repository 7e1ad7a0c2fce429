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

FIRST_STEPS = ROOT / "release/first_steps.py"


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
    return quiet(python, "-I", FIRST_STEPS, cwd=folder / "elsewhere")


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

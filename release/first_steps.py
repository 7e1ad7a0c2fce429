"""What a newcomer does first with an installed package: run in an empty folder, without access to the checkout."""

import importlib.metadata
import subprocess
import sys
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

folder = next(folder for folder in (Path(sys.prefix) / "bin", Path(sys.prefix) / "Scripts") if folder.exists())
command = next(folder.glob("cdpr*"))
steps = (
    "new --example hard1 hard1.toml",
    "plan hard1.toml -o hard1.json --html hard1.html",
    "check hard1.toml hard1.json",
    "new --example-files examples",
    "import examples/caspr/CoGiRo -o cogiro.toml",
    "new hall.toml --robot cogiro.toml --obstacle examples/meshes/machine.stl",
)
for step in steps:
    subprocess.run([command, *step.split()], check=True, stdout=subprocess.DEVNULL)
assert cdpr.Scene.load("hard1.toml") == cdpr.example("hard1")
version = subprocess.run([command, "--version"], check=True, capture_output=True, text=True).stdout
assert version == f"cdpr {cdpr.__version__}\n", version
again = subprocess.run([sys.executable, "-m", "cdpr", "check", "hard1.toml", "no.json"], capture_output=True, text=True)
assert again.returncode == 2 and "no.json" in again.stderr, again
print("planned", round(result.cost, 3))

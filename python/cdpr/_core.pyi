"""The compiled part of cdpr; the package around it is the interface."""

from typing import final

import numpy as np
from numpy.typing import NDArray

__version__: str
MAX_COORDINATE: float

_Point = tuple[float, float, float]
_Floats = NDArray[np.float64]

@final
class Scene:
    @staticmethod
    def load(path: str) -> Scene: ...
    @staticmethod
    def from_json(text: str) -> Scene: ...
    def to_json(self) -> str: ...
    def fingerprint(self) -> str: ...
    def notes(self) -> list[str]: ...
    def states_valid(
        self, positions: _Floats, engine: str, interference: str, threads: int | None
    ) -> NDArray[np.bool_]: ...
    def motions_valid(
        self, starts: _Floats, ends: _Floats, engine: str, interference: str, threads: int | None
    ) -> NDArray[np.bool_]: ...
    def violations(self, start: _Point, end: _Point, engine: str, interference: str) -> str: ...
    def check(self, waypoints: _Floats, engine: str, interference: str) -> str: ...
    def plan(
        self,
        planner: str,
        engine: str,
        interference: str,
        seed: int,
        start: _Point | None,
        goal: _Point | None,
        step: float,
        post: str,
        repeats: int,
        max_samples: int,
        budget: float | None,
    ) -> str: ...
    def rewind(
        self, waypoints: _Floats, step: float, order: str, repeats: int, engine: str, interference: str
    ) -> str: ...
    def page(
        self,
        status: str | None,
        waypoints: _Floats | None,
        cost: float | None,
        raw_waypoints: _Floats | None,
        raw_cost: float | None,
        planner: str | None,
        interference: str,
    ) -> str: ...

def check_robot(text: str) -> None: ...
def load_robot(path: str) -> str: ...
def load_path(path: str, scene: Scene | None) -> list[list[float]]: ...
def save_path(path: str, json: str) -> None: ...
def schema(of: str) -> str: ...
def save_text(path: str, text: str) -> None: ...
def polytope_distance(a: _Floats, b: _Floats) -> tuple[float, list[float], list[float], float]: ...

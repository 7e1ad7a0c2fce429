"""The compiled part of cdpr, used by the package."""

from collections.abc import Callable, Sequence
from typing import final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Experiment",
    "GRAVITY",
    "MAX_COORDINATE",
    "Scene",
    "Statics",
    "Trajectory",
    "UNIT_QUATERNION",
    "WrenchMap",
    "__version__",
    "check_robot",
    "check_target",
    "command",
    "example",
    "import_robot",
    "lengths_from",
    "load_path",
    "load_robot",
    "other_poses",
    "panic",
    "plan",
    "plan_many",
    "polytope_distance",
    "pose_from_lengths",
    "save_mjcf",
    "save_path",
    "save_robot",
    "save_text",
    "schema",
]

__version__: str
GRAVITY: list[float]
MAX_COORDINATE: float
UNIT_QUATERNION: float

_Point = tuple[float, float, float]
_Turn = tuple[float, float, float, float]
_Floats = NDArray[np.float64]
_Ints = NDArray[np.int64]
_Maybe = _Floats | None
_States = tuple[list[_Floats], list[_Floats], list[_Maybe]]
_Search = tuple[str, str, str, int, float | None, str | None, int | None, float | None, str, bool]
_Poses = tuple[_Floats, _Floats, _Floats, _Floats, _Ints, _Ints]
_Set = tuple[int, _Point, float, _Floats, NDArray[np.int64]]

@final
class Scene:
    @staticmethod
    def load(path: str) -> Scene: ...
    @staticmethod
    def from_json(text: str) -> Scene: ...
    def to_json(self) -> str: ...
    def save(self, path: str) -> None: ...
    def fingerprint(self) -> str: ...
    def notes(self) -> list[str]: ...
    def warnings(self, told: list[str]) -> list[str]: ...
    def states_valid(
        self,
        positions: _Floats,
        engine: str,
        interference: str,
        threads: int | None,
        orientations: _Floats | None = None,
    ) -> NDArray[np.bool_]: ...
    def motions_valid(
        self,
        starts: _Floats,
        ends: _Floats,
        engine: str,
        interference: str,
        threads: int | None,
        orientations: tuple[_Floats, _Floats] | None = None,
    ) -> NDArray[np.bool_]: ...
    def motion_valid(
        self,
        start: Sequence[float],
        end: Sequence[float],
        engine: str,
        interference: str,
        orientations: tuple[Sequence[float], Sequence[float]] | None = None,
    ) -> bool: ...
    def orientation(self) -> list[float]: ...
    def end_orientations(self) -> list[list[float]]: ...
    def turns(self) -> bool: ...
    def turn_weight(self) -> float: ...
    def orientations(self) -> list[tuple[str, list[float]]]: ...
    def for_path(
        self,
        orientation: list[float] | None,
        orientation_name: str | None = None,
        planned_for: tuple[str, str] | None = None,
        strict: bool = False,
        turns: _Floats | None = None,
    ) -> tuple[Scene | None, str | None, bool]: ...
    def at(self, place: str, orientation: str | _Turn) -> Scene: ...
    def orientation_is_open(self) -> bool: ...
    def position_box(self) -> tuple[list[float], list[float]]: ...
    def clearance(self, positions: _Floats, threads: int | None, orientations: _Floats | None = None) -> _Floats: ...
    def nearest_valid(
        self,
        position: tuple[float, float, float],
        margin: float,
        engine: str,
        interference: str,
        orientation: tuple[float, float, float, float] | None = None,
    ) -> tuple[float, float, float] | None: ...
    def violations(
        self,
        start: _Point,
        end: _Point,
        engine: str,
        interference: str,
        orientations: tuple[_Turn, _Turn] | None = None,
    ) -> str: ...
    def check(
        self, waypoints: _Floats, engine: str, interference: str, orientations: _Floats | None = None
    ) -> str: ...
    def wrench_at(
        self, position: _Point, force: float | None, moment: float | None, chosen: str | None
    ) -> str: ...
    def tensions_along(
        self,
        waypoints: _Floats,
        step: float,
        reference: list[float] | None,
        chosen: str | None,
        orientations: _Floats | None = None,
    ) -> tuple[list[_Floats], _Floats, _Maybe, tuple[_Floats, _Floats, list[_Maybe]]]: ...
    def lower_bound(
        self, gap: float | None, budget: float | None, start: _Point | None, goal: _Point | None, certified: bool
    ) -> tuple[float, str | None]: ...
    def shorten(
        self,
        waypoints: _Floats,
        post: str,
        step: float,
        repeats: int,
        engine: str,
        interference: str,
        orientations: _Floats | None = None,
    ) -> str: ...
    def regions(
        self, space: str | None, all: bool, cables: list[str], obstacles: list[str]
    ) -> list[tuple[str, _Floats, NDArray[np.int64]]]: ...
    def save_regions(
        self, path: str, space: str | None, all: bool, cables: list[str], obstacles: list[str]
    ) -> None: ...
    def rewind_tries(
        self, waypoints: _Floats, step: float, order: str
    ) -> tuple[_Floats, _Floats, _Floats, list[bool]]: ...
    def bodies(self) -> str: ...
    def page(
        self, path: str | None, tree: tuple[_Floats, _Ints] | None, certificate: str | None, interference: str, live: bool
    ) -> str: ...

@final
class Statics:
    def __new__(
        cls,
        robot: str,
        orientation: list[float] | None,
        gravity: _Point | None,
        load: list[float] | None,
        characteristic_length: float,
    ) -> Statics: ...
    def wrench_matrix(self, positions: _Floats) -> _Floats: ...
    def cable_lengths(self, positions: _Floats) -> _Floats: ...
    def capacity_margin(
        self,
        positions: _Floats,
        force: float,
        moment: float,
        vertices: list[tuple[float, ...]] | None,
        threads: int | None,
    ) -> _Floats: ...
    def force_margin(self, positions: _Floats, threads: int | None) -> _Floats: ...
    def moment_margin(self, positions: _Floats, threads: int | None) -> _Floats: ...
    def force_set(self, position: _Point) -> _Set: ...
    def moment_set(self, position: _Point) -> _Set: ...
    def tensions(
        self, positions: _Floats, reference: list[float] | None, chosen: str | None, threads: int | None
    ) -> _Floats: ...

@final
class Trajectory:
    @staticmethod
    def of(
        scene: Scene,
        waypoints: _Floats,
        quaternions: _Floats | None,
        limits: str,
        rate: float | None,
        chosen: str | None,
    ) -> Trajectory: ...
    @staticmethod
    def load(path: str, scene: Scene | None, strict: bool) -> tuple[Trajectory, str | None]: ...
    @staticmethod
    def from_json(file: str, scene: str | None) -> Trajectory: ...
    def to_json(self) -> tuple[str, str | None]: ...
    def __deepcopy__(self, _memo: object) -> Trajectory: ...
    def page(self, scene: Scene, interference: str, strict: bool) -> tuple[str, str | None]: ...
    def save(self, path: str, joints: str | None, effort: bool) -> None: ...
    def facts(self) -> str: ...
    def turns(self) -> bool: ...
    def samples(self) -> tuple[_Floats, _States]: ...
    def at(self, times: _Floats) -> _States: ...

@final
class WrenchMap:
    @staticmethod
    def of(
        scene: Scene,
        step: float,
        force: float | None,
        moment: float | None,
        projected: bool,
        threads: int | None,
    ) -> WrenchMap: ...
    @staticmethod
    def load(path: str, scene: Scene | None, force: float | None, moment: float | None) -> WrenchMap: ...
    def save(self, path: str) -> None: ...
    def to_bytes(self) -> bytes: ...
    @staticmethod
    def from_bytes(bytes: bytes) -> WrenchMap: ...
    def capacity(self) -> _Floats: ...
    def force(self) -> _Floats | None: ...
    def moment(self) -> _Floats | None: ...
    def summary(self) -> tuple[list[float], float, float, float, list[list[float]] | None]: ...

@final
class Experiment:
    @staticmethod
    def load(path: str) -> Experiment: ...
    @staticmethod
    def from_json(text: str) -> Experiment: ...
    def to_json(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def trials(self) -> int: ...
    @property
    def groups(self) -> int: ...
    @property
    def scenarios(self) -> list[tuple[str, bool]]: ...
    @property
    def methods(self) -> list[tuple[str, bool]]: ...
    def scene(self, scenario: int, trial: int) -> Scene: ...
    def seed(self, group: int, trial: int) -> int: ...
    def foregone(self, group: int, scene: Scene) -> str | None: ...
    def external_rows(
        self,
        unit: tuple[int, int],
        scene: Scene,
        status: str,
        path: _Floats,
        seconds: float | None,
        history: list[tuple[float, int, float]],
    ) -> tuple[bytes, str | None]: ...
    def run(
        self, first: int, end: int, threads: int | None, progress: Callable[[int, int], object] | None
    ) -> tuple[list[bytes], list[str]]: ...
    def tables(self, first: int, end: int, rows: list[bytes]) -> tuple[bytes, bytes, bytes | None, str]: ...
    def save(self, path: str, first: int, end: int, rows: list[bytes]) -> None: ...

def check_robot(text: str) -> str: ...
def import_robot(
    path: str, bodies: str | None, cable_set: str | None, platform: str | None, units: str
) -> tuple[str, list[str]]: ...
def load_robot(path: str) -> str: ...
def save_robot(path: str, text: str) -> None: ...
def load_path(
    path: str, scene: Scene | None, strict: bool
) -> tuple[list[list[float]], list[float] | None, str, str | None]: ...
def save_path(path: str, json: str) -> None: ...
def save_mjcf(
    path: str, scene: Scene, motion: Trajectory | None, control: str, strict: bool
) -> tuple[list[str], str | None]: ...
def plan(
    scene: Scene,
    search: _Search,
    start: _Point | None,
    goal: _Point | None,
    start_orientation: str | _Turn | None,
    goal_orientation: str | _Turn | None,
    minimise: str,
    motion: str | None,
    on_improvement: Callable[[float, float, _Floats], object] | None,
) -> tuple[str, tuple[_Floats, _Ints], str | None, Trajectory | None]: ...
def plan_many(
    scene: Scene,
    search: _Search,
    starts: _Floats,
    goals: _Floats,
    start_orientation: str | _Turn | None,
    goal_orientation: str | _Turn | None,
    threads: int | None,
    progress: Callable[[int, int], object] | None,
) -> list[tuple[str, tuple[_Floats, _Ints], str | None]]: ...
def schema(of: str) -> str: ...
def check_target(path: str) -> None: ...
def command(arguments: list[str]) -> int: ...
def example(name: str) -> str: ...
def panic(thread: str) -> None: ...
def save_text(path: str, text: str) -> None: ...
def lengths_from(robot: str, joints: str, values: _Floats, tensions: _Floats | None, many: bool) -> _Floats: ...
def pose_from_lengths(
    robot: str, lengths: _Floats, orientation: _Turn | None, guess: tuple[_Point, _Turn] | None, many: bool
) -> _Poses: ...
def other_poses(
    robot: str, lengths: _Floats, orientation: _Turn | None, poses: list[tuple[list[float], list[float]]]
) -> list[_Poses]: ...
def polytope_distance(a: _Floats, b: _Floats) -> tuple[float, list[float], list[float], float]: ...

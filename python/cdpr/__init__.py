"""Collision-free path planning for cable-driven parallel robots in cluttered environments.

A platform hangs on cables that run to fixed outlets. A path of the platform is collision-free if, along the whole path,
platform and cables touch neither obstacles nor each other.

What concerns the geometry of a scene alone is a method of `Scene`: `Scene.motions_valid`, `Scene.clearance`, `Scene.shadows`. What
computes an answer with options, or from a path, is a function: `plan`, `check`, `trajectory`, `workspace`, `wrench_map`.

>>> import cdpr
>>> cube = [[x, y, z] for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)]
>>> robot = cdpr.Robot(
...     outlets=[[x, y, z] for x in (0, 2) for y in (0, 2) for z in (0, 2)], attachments=cube, platform=[cube]
... )
>>> pillar = [[x, y, z] for x in (0.9, 1.1) for y in (0.9, 1.1) for z in (0, 1.2)]
>>> scene = cdpr.Scene(robot, {"pillar": pillar}, workspace=[[0, 0, 0], [2, 2, 2]])
>>> result = cdpr.plan(scene, start=[0.3, 1, 0.3], goal=[1.7, 1, 1.7])
>>> result.status
'solved'
>>> bool(scene.motions_valid(result.waypoints[:-1], result.waypoints[1:]).all())
True
"""

from ._core import __version__
from ._aliases import example, save_shadows, shadows
from ._batch import BatchResult, run_batch, trial_scene
from ._examples import save_example_files
from ._export import save_mjcf
from ._forward import PoseEstimate, pose_from_lengths
from ._geometry import Distance, distance
from ._plan_many import plan_many
from ._planning import check, load_path, lower_bound, plan, refine, rewind, schema
from ._proof import Proof, check_proof
from ._replanning import replan
from ._results import Milestone, Path, Report, Result, SearchTree
from ._robot import Robot, import_robot
from ._scene import Scene
from ._shadows import Mesh
from ._stations import Station
from ._task import Task, TaskLeg, task
from ._tensions import Settling, Tensions, WrenchReport, tensions_along, wrench_at
from ._tour import Tour, tour
from ._trajectory import Corner, Limiting, MotionState, Trajectory, load_trajectory, trajectory
from ._view import View, save_view, show
from ._violation import Exemption, Violation
from ._workspace import Bounds, Share, Workspace, WorkspacePart, workspace
from ._wrench import (
    AvailableSet,
    capacity_margin,
    force_margin,
    force_set,
    moment_margin,
    moment_set,
    tension_distribution,
    wrench_matrix,
)
from ._wrench_map import WrenchMap, wrench_map
from .exceptions import AnotherSceneWarning, CdprError, CdprWarning, FileError, InputError, InternalError

__all__ = [
    "AnotherSceneWarning",
    "AvailableSet",
    "BatchResult",
    "Bounds",
    "CdprError",
    "CdprWarning",
    "Corner",
    "Distance",
    "Exemption",
    "FileError",
    "InputError",
    "InternalError",
    "Limiting",
    "Mesh",
    "Milestone",
    "MotionState",
    "Path",
    "PoseEstimate",
    "Proof",
    "Report",
    "Result",
    "Robot",
    "Scene",
    "SearchTree",
    "Settling",
    "Share",
    "Station",
    "Task",
    "TaskLeg",
    "Tensions",
    "Tour",
    "Trajectory",
    "Violation",
    "View",
    "Workspace",
    "WorkspacePart",
    "WrenchMap",
    "WrenchReport",
    "__version__",
    "capacity_margin",
    "check",
    "check_proof",
    "distance",
    "example",
    "force_margin",
    "force_set",
    "import_robot",
    "load_path",
    "load_trajectory",
    "lower_bound",
    "moment_margin",
    "moment_set",
    "plan",
    "plan_many",
    "pose_from_lengths",
    "refine",
    "replan",
    "rewind",
    "run_batch",
    "save_example_files",
    "save_mjcf",
    "save_shadows",
    "save_view",
    "schema",
    "shadows",
    "show",
    "task",
    "tension_distribution",
    "tensions_along",
    "tour",
    "trajectory",
    "trial_scene",
    "workspace",
    "wrench_at",
    "wrench_map",
    "wrench_matrix",
]

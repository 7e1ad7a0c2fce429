"""The checker of certificates accepts proofs that there is no path, and nothing else."""

import copy
import json
import math
import random
import time
from pathlib import Path
from typing import Any

import pytest

import cdpr
from cdpr._certify import check_certificate
from conftest import TESTDATA

DATA = Path(__file__).parent / "data"
SAMPLES = ["corner", "platform", "two-cables"]

Table = dict[str, Any]


def sample(name: str = "corner") -> tuple[Table, Table]:
    """A scene, and the certificate that it has no path."""
    scene, file = (json.loads((DATA / f"proof-{name}{end}.json").read_text()) for end in (".scene", ""))
    return scene, file


def refused(scene: Table, file: Table | str, reason: str = ".", fingerprint: str | None = None) -> str:
    """The message with which a certificate is refused."""
    with pytest.raises(ValueError, match=reason) as problem:
        check_certificate(scene, file, fingerprint)
    message = str(problem.value)
    assert message and len(message) < 500
    return message


@pytest.mark.parametrize("name", SAMPLES)
def test_samples_are_proofs(name):
    scene, file = sample(name)
    check_certificate(scene, file, file["scene"])
    check_certificate(scene, json.dumps(file), None)
    check_certificate({**scene, "query": None}, file, None)


def test_question_must_be_the_same():
    scene, file = sample()
    refused(scene, file, "another scene", "0123456789abcdef")
    refused(scene, {**file, "start": [0.3, 1.0, 0.31]}, "another question")
    refused(scene, {**file, "goal": file["start"], "start": file["goal"]}, "another question")
    half = math.sqrt(0.5)
    refused(scene, {**file, "orientation": [half, 0, 0, half]}, "another orientation")
    refused(scene, {**file, "orientation": [2.0, 0, 0, 0]}, "unit quaternion")
    check_certificate(scene, {**file, "orientation": [-1.0, 0, 0, 0]}, None)  # the same rotation
    named = {**scene, "orientations": [{"name": "a"}, {"name": "b", "rpy_degrees": [0, 0, 90]}]}
    check_certificate(named, file, None)
    named["query"] = {**scene["query"], "orientation": "b"}
    refused(named, file, "another orientation")


def test_other_obstacles_are_another_scene_even_without_fingerprint():
    scene, file = sample()
    for k, body in enumerate(scene["obstacles"]):
        if any(body["name"] in region["who"] for region in file["regions"]):
            changed = copy.deepcopy(scene)
            changed["obstacles"][k]["position"][0] += 1e-5
            refused(changed, file, "beyond the positions")
    for region in file["regions"]:
        refused({**scene, "ignore": [region["who"]]}, file, "ignores")
    for key, most in (("min", -0.1), ("max", 2.1)):
        changed = copy.deepcopy(scene)
        changed["workspace"][key][1] = most
        refused(changed, file, "box: found")


def test_files_that_are_no_certificates():
    scene, file = sample()
    text = json.dumps(file)
    for cut in (0, 1, 100, len(text) // 2, len(text) - 1):
        refused(scene, text[:cut], "truncated")
    refused(scene, "[" * 100_000, "without end")
    refused(scene, "[1, 2]", "format")
    refused(scene, text.replace('"margin": 1e-06', '"margin": 1e-06, "margin": 1e-06'), "twice")
    refused(scene, text.replace("1.0", "NaN", 1), "NaN")
    refused(scene, text.replace("1.0", "1e999", 1), "orientation")
    refused(scene, {**file, "version": 2}, "version: found 2, expected 1")
    refused(scene, {**file, "version": True}, "version")
    refused(scene, {**file, "format": "cdpr-path"}, "format")
    refused(scene, {**file, "note": ""}, "unknown key 'note'")
    for key in file:
        refused(scene, {k: v for k, v in file.items() if k != key}, key)
        refused(scene, {**file, key: None}, key)
        refused(scene, {**file, key: [math.nan] * 4}, key)


@pytest.mark.parametrize("margin", [0, -1e-6, 1e-9, 5e-7, 0.01, math.inf, math.nan, "1e-6", None, True])
def test_margin(margin):
    scene, file = sample()
    refused(scene, {**file, "margin": margin})


def test_too_many_items_are_refused_at_once():
    scene, file = sample()
    before = time.perf_counter()
    refused(scene, {**file, "boxes": file["boxes"][:1] * 10_000_000}, "found 10000000 boxes, expected at most 1000000")
    refused(scene, {**file, "regions": file["regions"][:1] * 10_001}, "at most 10000")
    planes = {**file["regions"][0], "half_spaces": file["regions"][0]["half_spaces"] * 200}
    refused(scene, {**file, "regions": [planes]}, "at most 1000")
    assert time.perf_counter() - before < 5


def box_with(file: Table, closed: bool) -> int:
    return next(k for k, box in enumerate(file["boxes"]) if (box[6] >= 0) == closed)


@pytest.mark.parametrize(
    ("at", "value", "reason"),
    [
        (6, 2, "region 2"),
        (6, -3, "region -3"),
        (6, -2, "reason"),
        (6, 0.0, "region 0.0"),
        (6, None, "region None"),
        (0, math.nan, "nan"),
        (0, math.inf, "inf"),
        (0, None, "None"),
        (0, "0", "'0'"),
        (0, 10**400, "10000"),
        (0, 5.0, "min < max"),
    ],
)
def test_boxes_must_be_boxes(at, value, reason):
    scene, file = sample()
    file["boxes"][box_with(file, True)][at] = value
    refused(scene, file, reason)


def connecting(file: Table) -> list[int]:
    """Closed boxes that touch both the open boxes reached from the start and those reached from the goal."""
    boxes = file["boxes"]

    def touches(a, b):
        return all(a[k] <= b[k + 3] and b[k] <= a[k + 3] for k in range(3))

    def reached(point):
        found, front = [], [point + point]
        while front:
            box = front.pop()
            new = [b for b in boxes if b[6] == -1 and touches(b, box) and b not in found]
            found, front = found + new, front + new
        return found

    sides = reached(file["start"]), reached(file["goal"])
    closed = [k for k, box in enumerate(boxes) if box[6] != -1]
    return [k for k in closed if all(any(touches(boxes[k], b) for b in side) for side in sides)]


def damage(kind: str, file: Table, bridges: list[int], random: random.Random) -> str:
    """Damage a certificate at random; what was done."""
    boxes, regions = file["boxes"], file["regions"]
    k, j, axis = random.randrange(len(boxes)), random.randrange(len(regions)), random.randrange(6)
    if kind == "moved":
        boxes[k][axis] = math.nextafter(boxes[k][axis], random.choice([-math.inf, math.inf]))
    elif kind == "removed":
        del boxes[k]
    elif kind == "doubled":
        boxes.insert(random.randrange(len(boxes)), list(boxes[k]))
    elif kind == "opened":
        k = random.choice(bridges)
        boxes[k][6] = -1
    elif kind == "widened":
        k = random.randrange(len(regions[j]["half_spaces"]))
        regions[j]["half_spaces"][k][3] += 1e-5
    elif kind == "start":
        file["start"] = [x + (random.random() - 0.5) * 1e-3 for x in file["goal"]]
    elif kind == "goal":
        file["goal"] = [x + (random.random() - 0.5) * 1e-3 for x in file["start"]]
    elif kind == "margin":
        file["margin"] = random.choice([1e-9, 1e-7, 1e-12, 5e-324])
    elif kind == "who":
        cable, other = regions[j]["who"]
        names = {f"prism {n}" for n in range(10)} - {other}
        regions[j]["who"] = [cable, random.choice(sorted(names))]
    elif kind == "nan":
        boxes[k][axis] = math.nan
    return f"{kind}, {k}, {j}, {axis}"


KINDS = ["moved", "removed", "doubled", "opened", "widened", "start", "goal", "margin", "who", "nan"]


@pytest.mark.long
@pytest.mark.parametrize("name", SAMPLES)
def test_random_damage_is_refused(name):
    scene, file = sample(name)
    bridges, dice = connecting(file), random.Random(name)
    assert bridges
    for n in range(100):
        damaged = copy.deepcopy(file)
        kind = KINDS[n % len(KINDS)]
        done = damage(kind, damaged, bridges, dice)
        asked = {**scene, "query": None} if kind in ("start", "goal") else scene  # else it is another question at once
        try:
            refused(asked, damaged)
        except pytest.fail.Exception:
            pytest.fail(f"accepted after damage: {done}")


def test_truncated_text_is_refused_wherever_it_ends():
    scene, file = sample()
    text = json.dumps(file)
    dice = random.Random(1)
    for _ in range(100):
        refused(scene, text[: dice.randrange(len(text))])


# Small scenes in which the middle of three slabs of the box of positions is closed for a reason. The open boxes need
# not be free, so only this one reason decides.


def cable(outlet, attachment=(0, 0, 0), **keys) -> Table:
    return {"outlet": list(outlet), "attachment": list(attachment), **keys}


def small_scene(cables, obstacles=(), platform=({"vertices": [[0, 0, 0]]},), **keys) -> Table:
    robot = {"platform": list(platform), "cables": list(cables), "mass": 10.0}
    low, high = ([s + x for x in (0, 0, 0)] for s in (0.0, 1.0))
    return {"version": 1, "workspace": {"min": low, "max": high}, "robot": robot, "obstacles": list(obstacles), **keys}


def slabs(reason, low=0.4, high=0.6, box=((0, 0, 0), (1, 1, 1)), axis=0) -> Table:
    """A certificate that closes low < x < high."""

    def part(a, b):
        corners = [[float(x) for x in corner] for corner in box]
        corners[0][axis], corners[1][axis] = a, b
        return corners[0] + corners[1]

    first, last = float(box[0][axis]), float(box[1][axis])
    boxes = [[*part(first, low), -1], [*part(low, high), -2, reason], [*part(high, last), -1]]
    middle = [(a + b) / 2 for a, b in zip(*box, strict=True)]
    start, goal = (middle[:axis] + [x] + middle[axis + 1 :] for x in (first, last))
    return {
        "format": "cdpr-proof", "version": 1, "scene": "", "orientation": [1, 0, 0, 0], "margin": 1e-6, "start": start,
        "goal": goal, "box": [list(box[0]), list(box[1])], "regions": [], "boxes": boxes,
    }  # fmt: skip


FAR = cable((0.5, 0.5, 9))
WALL = {"name": "wall", "box": [0.2, 1, 1], "position": [0.5, 0.5, 0.5]}
BELOW = [cable((x, y, -5.0), (x / 9, y / 9, 0), tension=[1, 50]) for x in (-1, 1) for y in (-1, 1)]
TOP = {"name": "top", "box": [4, 4, 0.1], "position": [0, 0, 0.5]}  # a part of the platform above its origin
BASE = {"box": [0.2, 0.2, 0.2], "position": [0, 0, -0.1]}  # one with the origin on its upper face
CASES = {  # scene, reason, the slab that is closed, and one that is too large
    "platform": (small_scene([FAR], [WALL]), ["wall", "platform"], {}, (0.3999, 0.6)),
    "platform with clearance": (
        small_scene([FAR], [WALL], clearance=0.1), ["platform", "wall"], {"low": 0.3}, (0.2999, 0.6)
    ),
    "cable": (
        small_scene([cable((-1, 0.5, 0.5))], [WALL]), ["cable 0", "wall"], {"low": 0.5, "high": 0.9}, (0.39, 0.9)
    ),
    "thick cable": (
        small_scene([cable((-1, 0.5, 0.5), name="a", diameter=0.2)], [WALL]), ["wall", "a"], {"low": 0.3}, (0.29, 0.6)
    ),
    "cable from an obstacle": (
        small_scene([cable((0.4, 0.5, 0.5))], [WALL]), ["cable 0", "wall"], {"high": 0.9}, (0.3999, 0.9)
    ),
    "too short": (small_scene([cable((0.5, 0.5, 0.5), length=[0.8, 9])]), ["cable 0"], {}, (0.1, 0.9)),
    "too long": (small_scene([cable((-3, 0.5, 0.5), length=[0.1, 3.4])]), ["cable 0"], {"high": 0.9}, (0.39, 0.9)),
    "crossing cables": (
        small_scene([cable((0.5, 0.5, 3), diameter=0.3), cable((0.5, 1, 2), (0, -0.75, -1), diameter=0.3)]),
        ["cable 1", "cable 0"], {}, (0.1, 0.9),
    ),
    "wrench": (small_scene(BELOW, wrench={}), ["wrench", 0, 0, 1, 0, 0, 0], {}, None),
    "wrench at a limit": (  # 50 N each, nearly upwards: 200 N less the tilt of up to 0.6/4
        small_scene([cable((0, 0, 5)), *(cable((0, 0, 5), (0, k, 0)) for k in (-1e-2, 1e-2, 2e-2))],
                    wrench={"force": 102}),
        ["wrench", 0, 0, 1, 0, 0, 0], {}, None,
    ),
    "cable through the platform": (
        small_scene([cable((0.5, 0.5, 9))], platform=[BASE, TOP]), ["platform", "cable 0"],
        {"box": ((0.1, 0.1, 0.1), (0.9, 0.9, 0.9))}, None,
    ),
    "cable into the part it is attached to": (
        small_scene([cable((0.5, 0.5, -1))], platform=[BASE]), ["cable 0", "platform"],
        {"box": ((0.1, 0.1, 0.2), (0.9, 0.9, 1))}, None,
    ),
}  # fmt: skip
for limited in CASES["wrench at a limit"][0]["robot"]["cables"]:
    limited["tension"] = [0, 50]


@pytest.mark.parametrize("name", CASES)
def test_reasons(name):
    scene, reason, where, beyond = CASES[name]
    check_certificate(scene, slabs(reason, **where), None)
    if beyond is not None:
        larger = where | dict(zip(("low", "high"), beyond, strict=True))
        refused(scene, slabs(reason, **larger), "not all of its positions")


def test_reasons_that_do_not_hold():
    wall = small_scene([FAR, cable((0.5, 0, 9))], [WALL, {**WALL, "name": "other", "position": [5, 5, 5]}])
    for reason in (["platform", "other"], ["cable 0", "other"], ["cable 0"], ["cable 0", "cable 1"]):
        refused(wall, slabs(reason), "not all of its positions")
    for reason in (["wall"], ["platform"], ["wall", "other"], ["cable 9", "wall"], ["platform", "platform"], []):
        refused(wall, slabs(reason))
    refused(wall, slabs(["wrench", 0, 0, 1, 0, 0, 0]), "no certified requirement")
    refused(wall, slabs(["wrench", 0, 0, math.nan, 0, 0, 0]), "nan")
    for rule in ({"ignore": [["wall", "platform"]]}, {"ignore": [["platform", "wall"]]}):
        refused({**wall, **rule}, slabs(["platform", "wall"]), "ignores")
    touching = {**wall, "touch": [["wall", "platform"]], "clearance": 0.1}
    check_certificate(touching, slabs(["platform", "wall"]), None)
    refused(touching, slabs(["platform", "wall"], low=0.35), "not all")
    kinds = {"platform_obstacle": 0.05, "pairs": [{"between": ["platform", "wall"], "clearance": 0.1}]}
    check_certificate({**wall, "clearances": kinds}, slabs(["platform", "wall"], low=0.3), None)
    refused({**wall, "clearances": kinds}, slabs(["platform", "wall"], low=0.29), "not all")


def test_cables_that_share_an_end_forbid_nothing():
    for pair in ([cable((0, 0, 9)), cable((1, 0, 9))], [cable((0, 0, 9)), cable((0, 0, 9), (0, 0, 1))]):
        refused(small_scene(pair), slabs(["cable 0", "cable 1"]), "not all")


def test_a_gap_below_the_margin_at_every_position_forbids_nothing():
    near = cable((0.4 - 5e-7, 0.5, 0.5))  # the cable starts less than the margin from the wall
    refused(small_scene([near], [WALL]), slabs(["cable 0", "wall"], low=0.1, high=0.3), "not all")
    pair = [cable((0, 0, 9)), cable((1, 0, 9), (5e-7, 0, 0))]
    refused(small_scene(pair), slabs(["cable 0", "cable 1"]), "not all")


@pytest.mark.parametrize("depth", [0.0, 1e-16, 9e-8, -9e-8])
def test_an_outlet_on_a_wall_forbids_the_same_wherever_rounding_puts_it(depth):
    # A cable may leave the wall; if its outlet is a little below the surface, it enters the wall on no more positions.
    mounted, surface = small_scene([cable((0.4 + depth, 0.5, 0.5))], [WALL]), 0.4 + depth
    check_certificate(mounted, slabs(["cable 0", "wall"], low=surface, high=0.9), None)
    for beyond in (2e-6, 2e-5, 1e-3):
        refused(mounted, slabs(["cable 0", "wall"], low=surface - beyond, high=0.9), "not all")


def test_an_outlet_on_an_edge_forbids_what_is_below_both_faces():
    block = {**WALL, "box": [0.2, 4, 1.4], "position": [0.5, 0.5, 0]}

    def check(low, top):
        space = {"min": [0, 0, 0], "max": [1, 1, top]}
        scene = small_scene([cable((0.4, 0.5, 0.7))], [block], workspace=space)
        check_certificate(scene, slabs(["cable 0", "wall"], low=low, high=0.9, box=((0, 0, 0), (1, 1, top))), None)

    check(0.4, 0.7)
    for low, top in ((0.4 - 2e-6, 0.7), (0.4, 0.7 + 2e-6)):
        with pytest.raises(ValueError, match="not all"):
            check(low, top)


@pytest.mark.parametrize("thickness", [0.1, 2e-3, 1e-4, 1e-5])
def test_a_cable_does_not_pass_through_a_plate_however_thin(thickness):
    plate = {"box": [0.2, 0.2, thickness], "position": [0, 0, -thickness / 2]}

    def check(outlet, lowest):  # attached on its upper face
        space = {"min": [0, 0, lowest - thickness], "max": [1, 1, 1]}
        scene = small_scene([cable((0.5, 0.5, outlet))], platform=[plate], workspace=space)
        box = ((0.1, 0.1, lowest), (0.9, 0.9, 1))
        check_certificate(scene, slabs(["cable 0", "platform"], box=box), None)

    check(-1, 0.2)
    check(0.2, 0.2)
    with pytest.raises(ValueError, match="not all"):
        check(0.2 + 2e-6, 0.2)


def test_a_clearance_that_is_just_attainable_is_required():
    # The cable is attached 0.1 m from the platform's other part; in doubles, 0.15 - 0.05 is a little less. Where it leads
    # towards that part, it is nearer.
    parts = [{"vertices": [[0.15, 0, 0]]}, {"box": [0.1, 0.5, 0.5]}]
    box = ((0.05, 0.25, 0.25), (0.85, 0.75, 0.75))

    def beside(clearance):
        return small_scene([cable((0.5, 0.5, 0.5), (0.15, 0, 0))], platform=parts, clearance=clearance)

    check_certificate(beside(0.1), slabs(["cable 0", "platform"], low=0.42, high=0.7, box=box), None)
    refused(beside(0.1), slabs(["cable 0", "platform"], low=0.2, high=0.7, box=box), "not all")
    refused(beside(0.1 + 1e-8), slabs(["cable 0", "platform"], low=0.42, high=0.5, box=box), "not all")


def test_cables_whose_ends_nearly_coincide_meet_in_one_point():
    def apart(distance):
        cables = [cable((0.5, 0.5, 5), (x, 0, 0), tension=[0, 50]) for x in (0, distance)]
        return small_scene(cables, wrench={"force": 102})

    moment = ["wrench", 0, 0, 1, 0, 0, 1]
    refused(apart(0.99e-7), slabs(moment), "a moment that does not count")
    check_certificate(apart(1.01e-7), slabs(moment), None)


def test_flat_parts_with_the_attachment_on_them_forbid_nothing():
    plate = {"box": [0.2, 0.2, 0.0]}
    refused(
        small_scene([cable((0.5, 0.5, -1))], platform=[plate]),
        slabs(["cable 0", "platform"], box=((0.1, 0.1, 0), (0.9, 0.9, 1))),
        "not all",
    )


def test_cable_keeps_what_distance_it_can_from_the_neighbour_of_the_part_that_carries_it():
    # The outlet is 0.1 m from the wall, on a plate of the same name; 0.2 m cannot be kept.
    plate = {"name": "wall", "box": [0.1, 0.1, 0.1], "position": [0.35, 0.5, 0.55]}
    scene = small_scene([cable((0.3, 0.5, 0.5))], [plate, WALL], clearance=0.2)
    refused(scene, slabs(["cable 0", "wall"], low=0.1, high=0.2), "not all")
    alone = small_scene([cable((0.3, 0.5, 0.5))], [WALL], clearance=0.2)
    check_certificate(alone, slabs(["cable 0", "wall"], low=0.1, high=0.2), None)  # forbidden everywhere


def test_wrenches_that_can_be_balanced_are_no_reason():
    scene, reason, where, _ = copy.deepcopy(CASES["wrench at a limit"])
    scene["wrench"]["force"] = 95
    refused(scene, slabs(reason, **where), "not all")
    scene["wrench"]["force"] = 102
    for changed in ({"rule": "grid"}, {"margin": "projected"}):
        wrench = scene["wrench"] | changed
        mixed = ["wrench", 0, 0, 1, 1e-6, 0, 0] if "margin" in changed else reason
        refused({**scene, "wrench": wrench}, slabs(mixed, **where), "wrench as a reason")
    scene["robot"]["mass"] = 30.0  # 294 N, more than all cables hold
    scene["wrench"] = {}
    check_certificate(scene, slabs(reason, **where), None)
    check_certificate(scene, slabs(["wrench", 0, 0, 1e-9, 0, 0, 0], **where), None)
    refused(scene, slabs(["wrench", 0, 0, -1, 0, 0, 0], **where), "not all")
    scene["wrench"] = {"load": [0, 0, 200, 0, 0, 0]}  # lifts the platform
    refused(scene, slabs(reason, **where), "not all")
    scene["wrench"] = {"loads": [[0, 0, 200, 0, 0, 0], [0, 0, 150, 0, 0, 0]]}
    refused(scene, slabs(reason, **where), "not all")
    scene["wrench"]["payload"] = 5.0  # not enough to overload them
    refused(scene, slabs(reason, **where), "not all")
    for overloading in ({"payload": 20.0}, {"loads": [[0, 0, 200, 0, 0, 0], [0, 0, 0, 0, 0, 0]]}):
        check_certificate({**scene, "wrench": scene["wrench"] | overloading}, slabs(reason, **where), None)


def test_moments_of_the_weight_and_of_vertices_count():
    scene = copy.deepcopy(CASES["wrench at a limit"][0])
    sideways = ["wrench", 0, 0, 0, 0, -1, 0]  # the attachments are all at x = 0, so the tilt alone resists
    scene["wrench"] = {}
    refused(scene, slabs(sideways), "not all")
    scene["robot"]["center_of_mass"] = [0.1, 0, 0]  # 9.81 N·m about -y
    refused(scene, slabs(["wrench", 0, 0, 0, 0, 1, 0]), "not all")
    check_certificate(scene, slabs(sideways), None)
    scene["robot"]["center_of_mass"] = [0, 0, 0]
    scene["wrench"] = {"vertices": [[0, 0, 0, 0, -9.81, 0], [0] * 6]}
    check_certificate(scene, slabs(sideways), None)


def test_tilings():
    scene = small_scene([FAR], [WALL])
    whole = slabs(["platform", "wall"])
    for boxes in ([], whole["boxes"][:1], whole["boxes"][1:], whole["boxes"] * 2, [[0, 0, 0, 1, 1, 1, -1]] * 2):
        refused(scene, {**whole, "boxes": boxes})
    pinwheel = [  # five rectangles around a middle one: no plane passes between them
        [0, 0, 0.6, 0.4], [0.6, 0, 1, 0.6], [0.4, 0.6, 1, 1], [0, 0.4, 0.4, 1], [0.4, 0.4, 0.6, 0.6],
    ]  # fmt: skip
    boxes = [[x, y, 0.0, u, v, 1.0, -1] for x, y, u, v in pinwheel]
    refused(scene, {**whole, "boxes": boxes}, "do not tile")
    # Open boxes that touch the goal's in a corner only.
    corner = [[0, 0, 0, 0.5, 0.5, 1, -1], [0.5, 0, 0, 1, 0.5, 1, -2, ["platform", "wall"]],
              [0, 0.5, 0, 0.5, 1, 1, -2, ["platform", "wall"]], [0.5, 0.5, 0, 1, 1, 1, -1]]  # fmt: skip
    touching = {**whole, "boxes": corner, "start": [0.1, 0.1, 0.5], "goal": [0.9, 0.9, 0.5]}
    refused(scene, touching, "connected")
    refused(scene, {**touching, "start": [0.9, 0.1, 0.5]}, "start: found no open box")
    refused(scene, {**touching, "start": [1.1, 0.9, 0.5]}, "start: found no open box")


def test_turned_platform():
    # A bar along y, turned to lie along x, reaches 0.3 m further towards the wall.
    half = math.sqrt(0.5)
    bar = {"box": [0.02, 0.6, 0.02]}
    low, high = (0.3, 0.01, 0.01), (0.7, 0.99, 0.99)
    scene = small_scene([FAR], [WALL], platform=[bar], orientations=[{"name": "turned", "rpy_degrees": [0, 0, 90]}])
    file = {**slabs(["platform", "wall"], low=0.31, high=0.69, box=(low, high)), "orientation": [half, 0, 0, half]}
    check_certificate(scene, file, None)
    refused({**scene, "orientations": []}, file, "another orientation")
    refused({**scene, "orientations": []}, {**file, "orientation": [1, 0, 0, 0]})


def test_planning_proves_and_anyone_can_check(tmp_path):
    scene = cdpr.Scene.load(TESTDATA / "scenes/closed.toml")
    result = cdpr.plan(scene)
    assert (result.status, result.solved, result.waypoints.shape) == ("no_path", False, (0, 3))
    assert result.found_by is None
    proof = result.proof
    assert proof.culprits == (("cable 1", "south"), ("cable 3", "north")) and proof.blocking == ("south", "north")
    for name, cost in proof.without.items():
        found = cdpr.plan(scene.without(name))
        assert found.solved and found.cost <= cost * 1.0001
    assert scene.states_valid([proof.nearest_to_goal])[0] and proof.margin == 1e-6
    file = tmp_path / "proof.json"
    proof.save(file)
    assert cdpr.check_proof(scene, file)
    with pytest.raises(cdpr.FileError, match="another scene"):
        cdpr.check_proof(scene.without("south"), file)
    with pytest.raises(cdpr.FileError, match="another question"):
        cdpr.check_proof(scene.replace(start=[0.3, 1, 0.5]), file)
    file.write_text(file.read_text()[:-100])
    with pytest.raises(cdpr.FileError, match="truncated"):
        cdpr.check_proof(scene, file)
    with pytest.raises(cdpr.FileError, match="cannot be read"):
        cdpr.check_proof(scene, tmp_path / "missing.json")


@pytest.mark.parametrize("planner", ["anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"])
def test_every_planner_gives_the_same_proof(planner):
    scene = cdpr.Scene.load(TESTDATA / "scenes/closed.toml")
    first, second = (cdpr.plan(scene, planner, seed=seed) for seed in range(2))
    assert first.status == "no_path" and first.proof == second.proof
    assert first.stats["samples"] == second.stats["samples"] == 0
    assert cdpr.plan(scene, planner, max_samples=300, proof=False).status == "budget_spent"


def test_a_narrow_passage_is_found_where_sampling_fails(tmp_path):
    # The platform passes between the wall, 0.9 m high, and the ceiling with 1 cm to spare.
    robot = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml").robot
    upper = cdpr.Robot(robot.outlets[4:], robot.attachments[4:], [cdpr_box([0.15, 0.15, 0.05])])
    space = [[0, 0, 0], [2, 2, 0.96]]
    wall = cdpr.Scene(upper, workspace=space, start=[0.3, 1, 0.3], goal=[1.7, 1, 0.3])
    wall = wall.with_obstacle("wall", cdpr_box([0.1, 2.0, 0.9]), position=[1, 1, 0.45])
    assert cdpr.plan(wall, "rrt", max_samples=2000, proof=False).status == "budget_spent"
    found = cdpr.plan(wall, "rrt", max_samples=2000)
    assert found.solved and cdpr.check(wall, found).valid
    assert (found.found_by, cdpr.plan(wall, "two-trees").found_by) == ("decision", "two-trees")
    found.save(tmp_path / "path.json")
    written = json.loads((tmp_path / "path.json").read_text())
    assert (written["planner"], written["found_by"]) == ("rrt", "decision")


def cdpr_box(sides: list[float]) -> list[list[float]]:
    """The corners of a box."""
    return [[x, y, z] for x in (-sides[0] / 2, sides[0] / 2) for y in (-sides[1] / 2, sides[1] / 2)
            for z in (-sides[2] / 2, sides[2] / 2)]  # fmt: skip

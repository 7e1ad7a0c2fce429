"""Shadows and other forbidden regions, checked by an independent mesh library."""

import numpy as np
import pytest
import trimesh
from conftest import TESTDATA

import cdpr

SCENES = [
    "scenes/hard1.toml",
    "scenes/hard3.toml",
    "scenes/concave.toml",
    "cases/crossing.toml",
    "cases/own_platform.toml",
]


@pytest.mark.filterwarnings("ignore::cdpr.CdprWarning")
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("all_regions", [False, True])
def test_every_mesh_is_closed_and_oriented_outward(name, all_regions):
    scene = cdpr.Scene.load(TESTDATA / name)
    found = scene.shadows(all_regions=all_regions)
    assert found or not all_regions
    for key, mesh in found.items():
        assert mesh.name == key == " / ".join(mesh.culprits)
        assert (mesh.vertices.dtype, mesh.triangles.dtype) == (np.float64, np.int64)
        assert mesh.vertices.shape[1] == mesh.triangles.shape[1] == 3
        other = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=False)
        assert other.is_watertight and other.is_winding_consistent, key
        if mesh.kind == "cable-cable":
            assert mesh.volume == pytest.approx(0, abs=1e-12)
        else:
            assert mesh.volume > 0
            assert other.volume == pytest.approx(mesh.volume, abs=1e-12)


def test_convex_shadows_stay_closed_when_equal_vertices_are_merged(hard1):
    for mesh in hard1.shadows().values():
        merged = trimesh.Trimesh(mesh.vertices, mesh.triangles, process=True)
        assert merged.is_watertight and len(merged.vertices) == len(mesh.vertices)


def test_positions_in_the_region_of_the_platform_are_invalid(hard1):
    region = hard1.shadows(all_regions=True)["platform / pillar"]
    assert region.volume == pytest.approx(0.45**2 * 1.5, rel=1e-12)  # 0.3 + 0.15 wide; it ends at the floor
    low, high = region.vertices.min(axis=0), region.vertices.max(axis=0)
    points = np.random.default_rng(5).uniform(low, high, (200, 3))
    assert not hard1.states_valid(points).any()


@pytest.mark.parametrize("extension", ["obj", "ply", "stl"])
def test_files_hold_what_the_arrays_hold(hard1, tmp_path, extension):
    path = tmp_path / f"one.{extension}"
    hard1.save_shadows(path, cables="cable 3", obstacles=["pillar"])
    (mesh,) = hard1.shadows(cables="cable 3").values()
    read = trimesh.load(path, force="mesh")
    assert read.is_watertight and read.is_winding_consistent
    assert read.volume == pytest.approx(mesh.volume, rel=1e-6 if extension == "stl" else 1e-14)
    assert len(read.faces) == len(mesh.triangles)


def test_an_obj_file_has_an_object_for_each_mesh(hard1, tmp_path):
    path = tmp_path / "all.obj"
    hard1.save_shadows(path)
    objects = trimesh.load_scene(path, split_objects=True).geometry
    found = hard1.shadows()
    assert set(objects) == {name.replace(" / ", "_").replace(" ", "_") for name in found}
    for name, mesh in found.items():
        read = objects[name.replace(" / ", "_").replace(" ", "_")]
        assert read.is_watertight and read.is_winding_consistent
        assert read.volume == pytest.approx(mesh.volume, rel=1e-12)


def test_the_page_shows_the_regions(hard1, tmp_path):
    hard1.save_shadows(tmp_path / "s.html", space="position")
    assert '"space":"position"' in (tmp_path / "s.html").read_text()


def test_bad_names_spaces_and_extensions_are_refused(hard1, tmp_path):
    with pytest.raises(cdpr.InputError, match="cable: found \"cabel 3\".*did you mean \"cable 3\""):
        hard1.shadows(cables=["cabel 3"])
    with pytest.raises(cdpr.InputError, match="space: found \"attachment\" with all regions"):
        hard1.shadows(space="attachment", all_regions=True)
    with pytest.raises(cdpr.InputError, match="space: found \"joint\", expected one of attachment, position"):
        hard1.shadows(space="joint")
    with pytest.raises(cdpr.FileError, match=".step, expected .obj, .ply, .stl or .html"):
        hard1.save_shadows(tmp_path / "s.step")
    assert not list(tmp_path.iterdir())

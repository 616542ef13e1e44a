# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import gc
import re
from pathlib import Path

import numpy as np
import pytest

import meristem
from plants import grown_small_tree, small_tree


def test_views_outlive_their_plant() -> None:
    plant = grown_small_tree()
    skeleton = plant.stems[0].skeleton
    views = [skeleton.position, plant.organs.frame, plant.organs.tint, plant.meshes[0].mesh.positions]
    views += [plant.meshes[1].frames, plant.materials[0].picture, plant.prototypes[0].mesh.triangles]
    copies = [np.array(array) for array in views]
    del plant, skeleton
    gc.collect()
    meristem.read("bush").grow()  # uses memory that was freed before
    for array, copied in zip(views, copies):
        np.testing.assert_array_equal(array, copied)


def test_views_are_read_only_and_copy_nothing() -> None:
    plant = grown_small_tree()
    for array in (plant.stems[0].skeleton.radius, plant.organs.birth, plant.meshes[0].mesh.triangles):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
        with pytest.raises(ValueError):
            array.flags.writeable = True
    skeleton = plant.stems[0].skeleton
    assert np.shares_memory(skeleton.position, plant.stems[0].skeleton.position)
    assert np.shares_memory(plant.organs.frame, plant.organs.frame)


def test_meshes_cover_what_was_counted() -> None:
    plant = grown_small_tree()
    triangles = sum(len(meshes) * len(meshes.mesh.triangles) for meshes in plant.meshes)
    assert triangles == plant.triangle_count == plant.measure()["triangles"]
    corners = []
    for meshes in plant.meshes:
        frames = np.asarray(meshes.frames, dtype=np.float64)
        places = meshes.mesh.positions @ frames[:, :3] + frames[:, 3:]
        corners += [places.min(axis=(0, 1)), places.max(axis=(0, 1))]
        assert meshes.mesh.triangles.max() < len(meshes.mesh.positions)
        assert 0 <= meshes.material < len(plant.materials)
    np.testing.assert_allclose(plant.bounds, [np.min(corners, axis=0), np.max(corners, axis=0)], atol=1e-5)


def test_organs_stand_on_their_stems() -> None:
    plant = grown_small_tree()
    organs, skeleton = plant.organs, plant.stems[0].skeleton
    assert len(organs) == len(organs.frame) == len(organs.prototype) == len(organs.tint) == len(organs.birth) > 100
    assert organs.prototype.max() < len(plant.prototypes)
    gaps = [np.linalg.norm(skeleton.position - origin, axis=1).min() for origin in organs.frame[:50, 3]]
    assert max(gaps) < 0.1
    assert {prototype.component for prototype in plant.prototypes} == {"leaf"}


def test_measures_are_those_of_the_columns() -> None:
    plant = grown_small_tree()
    measures = plant.measure()
    skeleton = plant.stems[0].skeleton
    child = skeleton.parent >= 0
    lengths = np.linalg.norm(skeleton.position[child] - skeleton.position[skeleton.parent[child]], axis=1)
    assert measures["nodes"] == len(skeleton) == plant.node_count
    assert measures["length"] == pytest.approx(lengths.sum(), rel=1e-5)
    assert measures["height"] == pytest.approx(np.ptp(skeleton.position[:, 1]), rel=1e-5)
    assert measures["leaf_count"] == len(plant.organs)
    assert measures["leaf_exposure"] is None
    assert len(plant.measure(each=True)["each"]) == 1


def test_light_on_organs_is_what_measures_average() -> None:
    plant = grown_small_tree()
    light = plant.organ_light()
    measures = plant.measure(light=True)
    for name in ("exposure", "irradiance"):
        assert len(light[name]) == len(plant.organs)
        mean = np.average(light[name], weights=light["area"])
        assert measures[f"leaf_{name}"] == pytest.approx(mean, rel=1e-9)
    assert light["area"].sum() == pytest.approx(measures["leaf_area"], rel=1e-9)


def test_organs_tell_what_made_them_and_where_they_stand() -> None:
    plant = grown_small_tree()
    light, organs = plant.organ_light(), plant.organs
    assert set(organs.component) == {"leaf"}
    np.testing.assert_array_equal(organs.instance, np.arange(len(organs)))
    np.testing.assert_array_equal(organs.position, organs.frame[:, 3])
    assert set(organs.tree) == {0}
    for name in ("component", "instance", "tree", "position"):
        np.testing.assert_array_equal(light[name], getattr(organs, name))
    [tree] = plant.measure(each=True)["each"]
    assert (tree["component"], tree["instance"], tree["row"]) == ("tree", 0, None)
    assert tree["leaf_count"] == len(organs)
    np.testing.assert_array_equal(tree["position"], plant.stems[0].skeleton.position[0])
    assert plant.stems[0].skeleton.measure(each=True)["each"][0]["component"] is None


def test_light_is_measured_under_another_scene() -> None:
    plant = grown_small_tree()
    dark = meristem.Scene({"obstacles": [{"box": [[-50, 50, -50], [50, 51, 50]]}]})
    assert plant.organ_light(scene=dark)["exposure"].max() == 0
    assert plant.organ_light()["exposure"].max() > 0
    assert plant.measure(scene=dark, light=True)["leaf_exposure"] == 0


def test_leaf_layers_sum_up_to_the_leaf_area() -> None:
    plant = grown_small_tree()
    layers = plant.leaf_layers(0.1)
    assert layers["leaf_area"].sum() == pytest.approx(plant.measure()["leaf_area"])
    np.testing.assert_allclose(layers["high"] - layers["low"], 0.1)
    assert len(plant.leaf_layers()["low"]) < len(layers["low"])
    with pytest.raises(ValueError, match="height must be above 0"):
        plant.leaf_layers(0)


def test_skeleton_table_has_the_rows_of_the_file(tmp_path: Path) -> None:
    plant = grown_small_tree()
    table = plant.skeleton_table()
    plant.save(tmp_path / "tree.csv")
    lines = (tmp_path / "tree.csv").read_text().splitlines()
    assert lines[0].split(",") == list(table)
    assert len(lines) == 1 + plant.node_count
    assert all(len(column) == plant.node_count for column in table.values())
    assert set(table["component"]) == {"tree"}
    assert table["parent"][0] == -1
    np.testing.assert_array_equal(table["radius"].astype(np.float32), plant.stems[0].skeleton.radius)


# A test of the command line holds the docstring to the table of formats.
FORMATS = re.findall(r"(\.[a-z.]*[a-z])(?=[,.])",
                     (meristem.Plant.save.__doc__ or "").split("format:")[1].split("\n\n")[0])


@pytest.mark.parametrize("name", ["tree" + ending for ending in FORMATS])
def test_files_have_the_same_bytes_on_any_number_of_threads(tmp_path: Path, name: str) -> None:
    contents = []
    for threads in (1, 2):
        plant = meristem.Document(small_tree()).grow(threads=threads, trace=name.endswith(".points.csv"))
        plant.save(tmp_path / name, threads=threads)
        contents.append((tmp_path / name).read_bytes())
    assert contents[0] == contents[1]


def test_instanced_files_are_smaller(tmp_path: Path) -> None:
    plant = grown_small_tree()
    plant.save(tmp_path / "flat.glb")
    plant.save(tmp_path / "instanced.glb", instanced=True)
    assert (tmp_path / "instanced.glb").stat().st_size < (tmp_path / "flat.glb").stat().st_size
    with pytest.raises(ValueError, match="only .glb can be instanced"):
        plant.save(tmp_path / "tree.obj", instanced=True)


def test_levels_of_detail_are_smaller_files(tmp_path: Path) -> None:
    plant = grown_small_tree()
    for level in range(2):
        plant.save(tmp_path / f"{level}.ply", lod=level)
    sizes = [(tmp_path / f"{level}.ply").stat().st_size for level in range(2)]
    assert sizes[1] < 0.6 * sizes[0]
    with pytest.raises(ValueError, match="level 8 of detail is not worth a file, as level [2-7] is not: (it would|with )"):
        plant.save(tmp_path / "8.ply", lod=8)
    assert not (tmp_path / "8.ply").exists()
    with pytest.raises(ValueError, match="lod is 9; expected 0 to 8"):
        plant.save(tmp_path / "tree.ply", lod=9)
    with pytest.raises(ValueError, match="only files with meshes have levels of detail"):
        plant.save(tmp_path / "tree.csv", lod=1)


@pytest.mark.parametrize("model", ["low-poly-poplar", "low-poly-palm"])
def test_a_level_is_written_where_the_command_line_would_write_it(model: str, tmp_path: Path) -> None:
    """A level is written if every level up to it is worth a file compared with the previous one."""
    plant = meristem.read(model).grow()
    written = []
    for level in range(1, 4):
        path = tmp_path / f"{level}.ply"
        try:
            plant.save(path, lod=level)
        except ValueError as error:
            finer = "" if level == len(written) + 1 else f", as level {len(written) + 1} is not"
            assert str(error).startswith(f"level {level} of detail is not worth a file{finer}: ")
        else:
            written.append(level)
        assert path.exists() == (level in written)
    assert written == list(range(1, len(written) + 1))
    assert len(written) < 3


def test_saving_refuses_what_cannot_be_written(tmp_path: Path) -> None:
    document = meristem.Document(small_tree())
    document.save(tmp_path / "tree.json")
    plant = meristem.read(tmp_path / "tree.json").grow()
    with pytest.raises(meristem.InputError, match="'.glp' is not a format that can be written.*did you mean '.glb'"):
        plant.save(tmp_path / "tree.glp")
    with pytest.raises(meristem.MachineError):
        plant.save(tmp_path / "no" / "such" / "folder.glb")
    assert [path.name for path in tmp_path.iterdir()] == ["tree.json"]


def test_files_that_were_read_are_not_written_over(tmp_path: Path) -> None:
    house = Path(meristem.read("avenue").file).parent / "house.obj"
    (tmp_path / "house.obj").write_bytes(house.read_bytes())
    content = small_tree()
    content["scene"]["obstacles"] = [{"mesh": "house.obj", "translate": [30, 0, 0]}]
    plant = meristem.Document(content, file=str(tmp_path / "tree.json")).grow()
    with pytest.raises(meristem.InputError, match="would be overwritten, and it is read"):
        plant.save(tmp_path / "house.obj")
    assert (tmp_path / "house.obj").read_bytes() == house.read_bytes()


def test_pictures_are_arrays_and_files_alike() -> None:
    plant = grown_small_tree()
    picture = plant.render(size=(60, 40), samples=2)
    assert picture.shape == (40, 60, 4) and picture.dtype == np.uint8
    assert (picture[..., 3] == 255).all()
    np.testing.assert_array_equal(picture, plant.render(size=(60, 40), samples=2, threads=1))
    clear = plant.render(size=(60, 40), samples=2, transparent=True)
    assert (clear[..., 3] == 0).any() and (clear[..., 3] > 0).any()
    assert not np.array_equal(picture, plant.render(size=(60, 40), samples=2, view=(90, 10)))
    assert not np.array_equal(picture, plant.render(size=(60, 40), samples=2, hull=True))
    assert plant.png(size=(60, 40), samples=2).startswith(b"\x89PNG")


def test_pictures_are_written_whole_and_over_nothing_that_was_read(tmp_path: Path) -> None:
    plant = grown_small_tree()
    plant.save_picture(tmp_path / "leaf.png", size=(60, 40), samples=2)
    assert (tmp_path / "leaf.png").read_bytes() == plant.png(size=(60, 40), samples=2)
    content = small_tree()
    content["components"]["leaf"]["texture"] = {"picture": {"colour": "leaf.png"}}
    textured = meristem.Document(content, file=tmp_path / "tree.json").grow()
    with pytest.raises(meristem.InputError, match="would be overwritten, and it is read"):
        textured.save_picture(tmp_path / "leaf.png", size=(60, 40), samples=1)
    with pytest.raises(meristem.InputError, match="expected a file that ends in .png"):
        plant.save_picture(tmp_path / "leaf.gif")
    assert [path.name for path in tmp_path.iterdir()] == ["leaf.png"]


@pytest.mark.parametrize(
    "made_by_plants",
    [
        meristem.Plant,
        meristem.Stem,
        meristem.Organs,
        meristem.OrganPrototype,
        meristem.Material,
        meristem.MeshInstances,
    ],
)
def test_what_only_the_library_makes_cannot_be_made(made_by_plants: type) -> None:
    with pytest.raises(TypeError, match=f"{made_by_plants.__name__} cannot be made"):
        made_by_plants()
    with pytest.raises(TypeError):
        made_by_plants.__new__(made_by_plants)


@pytest.mark.parametrize("made_of_nothing", [meristem.Document, meristem.Skeleton, meristem.Mesh, meristem.Scene])
def test_objects_without_content_are_no_crash(made_of_nothing: type) -> None:
    with pytest.raises(Exception):
        repr(made_of_nothing.__new__(made_of_nothing))


def test_pictures_refuse_impossible_options() -> None:
    plant = grown_small_tree()
    with pytest.raises(meristem.InputError):
        plant.render(size=(0, 10))
    with pytest.raises(meristem.InputError):
        plant.render(samples=0)
    with pytest.raises(ValueError, match="view must be an azimuth"):
        plant.render(view=(0, 95))


def test_growth_follows_time() -> None:
    document = meristem.Document(small_tree()).set({"leaf.length": "0.05 + 0.05*t"})
    areas = [document.grow(time).measure()["leaf_area"] for time in (0, 1)]
    assert areas[1] == pytest.approx(2 * areas[0], rel=0.05)  # the width stays constant
    for time in (float("nan"), float("inf")):
        with pytest.raises(ValueError, match="time must be a finite number of seconds"):
            meristem.Document(small_tree()).grow(time)


def test_exploding_documents_are_stopped_by_their_limits() -> None:
    content = small_tree()
    content["limits"] = {"triangles": 1000}
    plant = meristem.Document(content).grow()
    assert len(plant.stems) == 1  # meshes are made on demand
    assert plant.measure()["triangles"] > 1000  # measures count triangles and hold no meshes
    for ask in (lambda: plant.meshes, lambda: plant.bounds):
        with pytest.raises(meristem.InputError, match="triangles"):
            ask()


def document_with_bark() -> meristem.Document:
    return meristem.Document(small_tree(texture={"bark": "smooth", "pixels": 32}))


def test_meshes_and_pictures_are_made_once_and_the_same_whatever_is_asked_for_first(tmp_path: Path) -> None:
    first, second = document_with_bark().grow(), document_with_bark().grow()
    assert "triangles" not in repr(first)
    measures = first.measure()
    assert "triangles" not in repr(first)  # measures hold no meshes
    mesh = first.meshes[0].mesh.positions
    assert f"{measures['triangles']} triangles" in repr(first)
    first.save(tmp_path / "first.glb")
    second.save(tmp_path / "second.glb")
    assert (tmp_path / "first.glb").read_bytes() == (tmp_path / "second.glb").read_bytes()
    assert second.measure() == measures
    assert np.shares_memory(first.meshes[0].mesh.positions, mesh)
    picture = first.materials[0].picture
    assert picture is not None and np.shares_memory(picture, first.materials[0].picture)


def test_plants_of_one_document_share_their_pictures() -> None:
    document = document_with_bark()
    first = document.grow().materials[0].picture
    second = document.set({"leaf.length": 0.07}, seed=5).grow().materials[0].picture
    assert first is not None and second is not None and np.shares_memory(first, second)
    other = document.set({"tree.colour": "#405060"}).grow().materials[0].picture
    assert other is not None and not np.array_equal(first, other)


def test_a_stem_in_an_obstacle_is_a_warning_of_the_plant(tmp_path: Path) -> None:
    path = tmp_path / "limb.json"
    path.write_text(
        """{"meristem": 1, "scene": {"obstacles": [{"box": [[-1, 1, -1], [1, 2, 1]]}]},
            "components": {"limb": {"type": "tree", "length": 3}}}"""
    )
    document = meristem.read(path)
    [warning] = document.grow().warnings
    assert (warning.severity, warning.path, warning.line) == ("warning", "components.limb", 2)
    assert "does not avoid obstacles" in warning.message
    assert document.set({"limb.length": 0.5}).grow().warnings == ()

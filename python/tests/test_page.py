# SPDX-License-Identifier: Apache-2.0
"""Scene packets of plants, and the pages that show them. tests/studio/page opens such pages in a browser."""

from __future__ import annotations

import base64
import gzip
import html
import os
import re
from pathlib import Path

import meristem
import numpy as np
import pytest
from meristem import _page
from packets import Packet
from plants import grown_small_tree, small_tree

needs_view = pytest.mark.skipif(
    not _page.has_viewer(), reason="the module was built without the view of pages, which needs node and its packages"
)


def textured_tree() -> meristem.Plant:
    """Returns a plant with several components, tinted instances, leaves with holes, and bark with normals."""
    content = small_tree(texture={"bark": {"style": "furrowed"}})
    content["components"]["leaf"].update(
        {"edge": "picture", "texture": {"leaf": {"veins": "pinnate"}, "pixels": 128}, "colours": ["#406020", "#a08020"]}
    )
    return meristem.Document(content).grow()


def packet_of_page(page: str) -> bytes:
    [packed] = re.findall(r'<script type="text/plain" id="packed-plant">([^<]*)</script>', page)
    return gzip.decompress(base64.b64decode(packed, validate=True))


# --- packets ----------------------------------------------------------------------------------------------------------


def test_a_packet_draws_the_plants_meshes_and_instances() -> None:
    plant = textured_tree()
    packet = Packet(plant.packet())
    drawn = packet.batches()
    assert len(drawn) == len(plant.meshes) >= 2
    wanted = {(one.component, len(one.mesh.triangles), len(one.frames)) for one in plant.meshes}
    assert {(batch["component"], mesh["triangles"], one["count"]) for batch, mesh, one in drawn} == wanted
    assert sum(mesh["triangles"] * one["count"] for _, mesh, one in drawn) == plant.triangle_count
    assert packet.head["triangles"] == packet.head["of"]["triangles"] == plant.triangle_count
    assert packet.head["of"]["nodes"] == plant.node_count
    assert packet.head["whole"] and packet.head["fit"] and packet.head["share"] == 1
    assert plant.bounds is not None
    np.testing.assert_allclose(packet.head["bounds"], plant.bounds, rtol=1e-6)


def test_arrays_of_a_packet_are_those_of_the_plant() -> None:
    plant = textured_tree()
    packet = Packet(plant.packet())
    by_name = {one.component: one for one in plant.meshes}
    assert len(by_name) == len(plant.meshes)  # one batch per component
    for batch, mesh, instances in packet.batches():
        own = by_name[batch["component"]]
        np.testing.assert_array_equal(packet.array(mesh, "positions"), own.mesh.positions)
        np.testing.assert_array_equal(packet.array(mesh, "indices"), own.mesh.triangles)
        normals = packet.array(mesh, "normals")[:, :3] / 127
        assert np.einsum("ij,ij->i", normals, own.mesh.normals).min() > 0.99
        rows = packet.array(instances, "frames").reshape(-1, 3, 4)
        np.testing.assert_array_equal(rows[:, :, :3].transpose(0, 2, 1), own.frames[:, :3])
        np.testing.assert_array_equal(rows[:, :, 3], own.frames[:, 3])
        if "tints" in instances:
            tints = packet.array(instances, "tints")[:, :3] / 255 * instances["tint_scale"]
            np.testing.assert_allclose(tints, own.tints, atol=0.5 / 255 * max(instances["tint_scale"]) + 1e-6)


def test_materials_of_a_packet_have_their_pictures() -> None:
    plant = textured_tree()
    packet = Packet(plant.packet())
    pictures = {one["key"]: one for one in packet.head["pictures"]}
    for material in packet.head["materials"]:
        own = plant.materials[material["index"]]
        assert material["name"] == own.name
        for name, picture in (("picture", own.picture), ("normals", own.normal_picture)):
            assert (name in material) == (picture is not None)
            if picture is not None:
                found = pictures[material[name]]
                assert (found["height"], found["width"]) == picture.shape[:2]
                start = b"\x89PNG" if found["type"] == "image/png" else b"\xff\xd8\xff"
                assert packet.bytes_of(found, "bytes").startswith(start)
    assert [one["masked"] for one in packet.head["materials"]].count(True) == 1


def test_a_packet_of_fewer_triangles_has_at_most_so_many_and_tells_how_many_there_are() -> None:
    plant = meristem.read("bush").grow()
    for most in (plant.triangle_count // 3, plant.triangle_count // 20):
        packet = Packet(plant.packet(triangles=most))
        assert packet.head["triangles"] == sum(mesh["triangles"] * one["count"] for _, mesh, one in packet.batches())
        assert 0.3 * most < packet.head["triangles"] <= most
        assert packet.head["of"]["triangles"] == plant.triangle_count
        assert 0 < packet.head["share"] < 1
    assert plant.packet(triangles=plant.triangle_count) == plant.packet()


def test_packets_are_the_same_on_any_number_of_threads() -> None:
    plant = textured_tree()
    first = plant.packet(threads=1)
    assert all(textured_tree().packet(threads=threads) == first for threads in (2, 3, 8))


def test_a_plant_without_anything_to_see_has_an_empty_packet() -> None:
    plant = meristem.Document({"meristem": 1, "components": {"view": {"type": "camera"}}}).grow()
    head = Packet(plant.packet()).head
    assert head["triangles"] == 0 and "batches" not in head and "bounds" not in head


def test_packets_refuse_fewer_triangles_than_none() -> None:
    with pytest.raises(TypeError):
        grown_small_tree().packet(triangles=-1)


# --- pages ------------------------------------------------------------------------------------------------------------


@needs_view
def test_a_page_holds_the_plant_and_all_that_shows_it() -> None:
    plant = grown_small_tree()
    page = plant.to_html(view=(90, -5.5))
    assert packet_of_page(page) == plant.packet()
    assert "<title>Small tree</title>" in page and 'data-look="90 -5.5"' in page
    assert "{{" not in page
    assert not re.search(r'(src|href)="', page)  # the page requests nothing else
    assert "three" in page and "MIT" in page  # licence of the included code
    assert plant.to_html(view=(90, -5.5)) == page


@needs_view
def test_names_of_plants_are_text_and_no_markup() -> None:
    name = "<script>alert('{{packet}}')</script> & \"more\""
    page = meristem.Document({**small_tree(), "name": name}).grow().to_html()
    assert f"<title>{html.escape(name)}</title>" in page
    assert page.count("</script>") == grown_small_tree().to_html().count("</script>")


@needs_view
def test_pages_are_written_whole_under_names_of_pages(tmp_path: Path) -> None:
    plant = grown_small_tree()
    plant.save_html(tmp_path / "tree.HTML", triangles=500)
    page = (tmp_path / "tree.HTML").read_text(encoding="utf-8")
    assert page == plant.to_html(triangles=500)
    assert Packet(packet_of_page(page)).head["triangles"] <= 500
    with pytest.raises(ValueError, match="'tree.glb' is not a page; expected a name that ends in .html"):
        plant.save_html(tmp_path / "tree.glb")
    with pytest.raises(meristem.MachineError, match="cannot write '.*tree.html': No such file"):
        plant.save_html(tmp_path / "nowhere" / "tree.html")
    assert os.listdir(tmp_path) == ["tree.HTML"]


@needs_view
@pytest.mark.parametrize("view", [(361, 0), (0, 90), (float("nan"), 0)])
def test_views_out_of_range_are_refused(view: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match="an azimuth from -360 to 360 and an altitude from -89 to 89"):
        grown_small_tree().to_html(view=view)


def test_without_the_view_pages_say_what_is_missing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(_page, "_TEMPLATE", tmp_path / "viewer.html")
    with pytest.raises(meristem.MachineError, match="the module was built without the view of pages, which needs node"):
        grown_small_tree().to_html()
    assert len(grown_small_tree().packet()) > 1000


@needs_view
def test_a_frame_in_a_notebook_holds_the_page_as_one_attribute() -> None:
    page = grown_small_tree().to_html()
    frame = _page.PageInNotebook(page, (300, 200))._repr_html_()
    found = re.fullmatch(r'<iframe srcdoc="([^"]*)" sandbox="allow-scripts" [^<>]*></iframe>', frame)
    assert found is not None and html.unescape(found[1]) == page
    assert 'width="300" height="200"' in frame

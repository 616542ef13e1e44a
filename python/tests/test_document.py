# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import copy
import json
import os
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import meristem
from plants import small_tree


def test_dicts_go_in_and_come_out_the_same() -> None:
    content = small_tree()
    assert meristem.Document(content).to_dict() == content


def test_text_reads_as_the_same_document() -> None:
    document = meristem.Document(small_tree())
    assert meristem.Document(document.text).to_dict() == document.to_dict()


def test_documents_do_not_change_with_what_they_were_made_of() -> None:
    content = small_tree()
    document = meristem.Document(content)
    before = document.grow().stems[0].skeleton.hash
    content["components"]["tree"]["points"] = 7
    document.to_dict()["components"]["tree"]["points"] = 8
    assert document.to_dict()["components"]["tree"]["points"] == 300
    assert document.grow().stems[0].skeleton.hash == before


def test_a_dict_changed_while_growing_changes_nothing() -> None:
    content = small_tree()
    document = meristem.Document(content)
    expected = document.grow().stems[0].skeleton.hash

    def change(stage: str, fraction: float) -> None:
        content["components"]["tree"]["points"] = 3
        content["components"].pop("leaf", None)

    plant = document.grow(progress=change)
    assert plant.stems[0].skeleton.hash == expected
    assert "leaf" not in content["components"]
    assert len(plant.organs) > 0


def test_numpy_numbers_and_arrays_are_values() -> None:
    content = small_tree()
    content["components"]["tree"]["points"] = np.int64(200)
    content["components"]["tree"]["step"] = np.float32(0.25)
    content["components"]["tree"]["crown"]["profile"] = np.array([[0, 0.5], [0.5, 1.5], [0, 3]])
    read = meristem.Document(content).to_dict()["components"]["tree"]
    assert read["points"] == 200
    assert read["step"] == 0.25
    assert read["crown"]["profile"] == [[0, 0.5], [0.5, 1.5], [0, 3]]


def test_set_gives_another_document() -> None:
    document = meristem.Document(small_tree())
    other = document.set({"size": 0.1, "tree.points": 100, "links[0].density": 20, "scene.latitude": 40}, seed=9)
    assert document.seed == 5 and other.seed == 9
    changed = other.to_dict()
    assert changed["variables"]["size"]["value"] == 0.1
    assert changed["components"]["tree"]["points"] == 100
    assert changed["links"][0]["density"] == 20
    assert changed["scene"]["latitude"] == 40
    assert changed["seed"] == 9
    assert document.to_dict() == small_tree()


def test_whole_keys_can_be_set() -> None:
    document = meristem.Document(small_tree()).set({"scene": {"sky": 0.25}, "seed": 12})
    assert document.to_dict()["scene"] == {"sky": 0.25}
    assert document.seed == 12


def test_faults_in_set_values_say_so() -> None:
    with pytest.raises(meristem.InputError) as caught:
        meristem.Document(small_tree()).set({"leaf.lenght": 1})
    assert str(caught.value).startswith("set leaf.lenght: components.leaf.lenght: 'lenght' is not a parameter")


def test_a_seed_that_is_set_goes_before_an_earlier_one() -> None:
    document = meristem.Document(small_tree(), seed=3)
    assert document.set({"seed": 9}).seed == 9
    assert document.set({"tree.points": 9}).seed == 3
    assert document.set({"seed": 9}, seed=4).seed == 4


@pytest.mark.parametrize("path", ["", "a..b", ".x", "[0]", "x["])
def test_paths_that_are_none_are_refused(path: str) -> None:
    with pytest.raises(meristem.InputError, match="is not a path; expected one such as"):
        meristem.Document(small_tree()).set({path: {"meristem": 1}})


def test_documents_that_say_the_same_are_equal() -> None:
    document = meristem.Document(small_tree())
    assert document == meristem.Document(document.text) == pickle.loads(pickle.dumps(document))
    assert len({document, copy.copy(document), meristem.Document(small_tree())}) == 1
    assert document != document.set(seed=8) and document != document.set({"tree.points": 8})
    assert document != small_tree()


def test_set_again_replaces_and_keeps_the_rest() -> None:
    document = meristem.Document(small_tree()).set({"tree.points": 100, "size": 0.1}).set({"tree.points": 50})
    assert document.to_dict()["components"]["tree"]["points"] == 50
    assert document.to_dict()["variables"]["size"]["value"] == 0.1


def test_the_same_seed_gives_the_same_plant() -> None:
    document = meristem.Document(small_tree())
    hashes = {seed: document.set(seed=seed).grow().stems[0].skeleton.hash for seed in (1, 2)}
    assert hashes[1] != hashes[2]
    assert meristem.Document(small_tree(), seed=1).grow(threads=1).stems[0].skeleton.hash == hashes[1]


def test_models_can_be_read_by_name() -> None:
    assert "oak" in meristem.models()
    oak = meristem.read("oak", set={"age": 20}, seed=3)
    assert oak.name == "Oak" and oak.seed == 3
    assert oak.components["tree"] == "colonize"
    age = next(variable for variable in oak.variables if variable.name == "age")
    assert age.value == 20 and age.min < 20 < age.max and age.unit == "years"


def test_variables_tell_what_they_are_derived_from() -> None:
    content = small_tree()
    content["variables"]["half"] = {"value": "size/2", "private": True}
    content["components"]["leaf"]["width"] = "half"
    size, half = meristem.Document(content).set({"size": 0.1}).variables
    assert (size.expression, size.private) == (None, False)
    assert (half.value, half.expression, half.private) == (0.05, "size/2", True)
    assert meristem.Document(content).set({"half": 0.02}).variables[1].expression is None


def test_saved_documents_can_be_read(tmp_path: Path) -> None:
    document = meristem.Document(small_tree()).set({"tree.points": 120}, seed=4)
    document.save(tmp_path / "tree.json")
    assert meristem.read(tmp_path / "tree.json").to_dict() == document.to_dict()


def test_saving_where_named_files_would_not_be_found_is_refused(tmp_path: Path) -> None:
    avenue = meristem.read("avenue")
    with pytest.raises(meristem.InputError, match="would not find 'house.obj' from there"):
        avenue.save(tmp_path / "avenue.json")
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "house.obj").write_bytes((Path(avenue.file).parent / "house.obj").read_bytes())
    with pytest.raises(meristem.InputError):
        avenue.save(tmp_path / "elsewhere.json")


def test_pickled_documents_grow_the_same() -> None:
    document = meristem.Document(small_tree()).set({"tree.points": 90}, seed=2**53)
    copied = pickle.loads(pickle.dumps(document))
    assert copied.seed == 2**53
    assert copied.grow().stems[0].skeleton.hash == document.grow().stems[0].skeleton.hash


def test_errors_carry_their_diagnostics() -> None:
    content = small_tree(stp=0.1)
    content["components"]["leaf"]["length"] = "siz * 2"
    with pytest.raises(meristem.InputError) as caught:
        meristem.Document(content)
    first, second = caught.value.diagnostics
    assert (first.path, first.nearest, first.severity) == ("components.tree.stp", "step", "error")
    assert (second.path, second.nearest) == ("components.leaf.length", "size")
    assert first.line > 0 and first.column > 0
    assert str(caught.value) == f"{first.text}\n{second.text}"
    assert isinstance(caught.value, ValueError) and isinstance(caught.value, meristem.Error)


def test_errors_survive_pickling() -> None:
    with pytest.raises(meristem.InputError) as caught:
        meristem.read("oka")
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.diagnostics == caught.value.diagnostics
    assert again.diagnostics[0].nearest == "oak"
    assert str(copy.copy(again)) == str(caught.value)


def test_files_that_cannot_be_read_are_the_machines_fault(tmp_path: Path) -> None:
    with pytest.raises(meristem.MachineError, match="nowhere.json") as caught:
        meristem.read(tmp_path / "nowhere.json")
    assert isinstance(caught.value, OSError)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (float("nan"), "a number is nan; expected a finite number"),
        (np.float64("inf"), "a number is inf; expected a finite number"),
        (2**53 + 1, "the whole number 9007199254740993 is too large"),
        (10**400, "a number is too large"),
        (1j, "a value is of type complex"),
        (b"bytes", "a value is of type bytes"),
        ({1: 2}, "a key is of type int; expected texts as keys"),
        (object(), "a value is of type object"),
    ],
)
def test_values_that_no_document_can_hold_are_refused(value: Any, message: str) -> None:
    with pytest.raises(meristem.InputError) as caught:
        meristem.Document(small_tree(step=value))
    assert message in str(caught.value)
    assert caught.value.diagnostics[0].path.startswith("components.tree.step")


def test_what_a_number_raises_comes_out() -> None:
    class Broken:
        def __float__(self) -> float:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        meristem.Document(small_tree(step=Broken()))


def test_half_characters_are_refused() -> None:
    with pytest.raises(meristem.InputError, match="half a character"):
        meristem.Document({**small_tree(), "name": "a\ud800"})
    with pytest.raises(meristem.InputError, match="half a character"):
        meristem.Document({**small_tree(), "a\ud800": 1})


def test_paths_may_be_bytes_and_any_name_of_the_system(tmp_path: Path) -> None:
    document = meristem.Document(small_tree())
    name = os.fsencode(tmp_path) + b"/caf\xe9.json"  # not UTF-8
    document.save(os.fsdecode(name))
    assert os.path.exists(name)
    assert meristem.read(os.fsdecode(name)).to_dict() == document.to_dict()


@pytest.mark.parametrize("path", ["o\0x.json", "-"])
def test_paths_that_name_no_file_are_refused(path: str) -> None:
    with pytest.raises(ValueError):
        meristem.Document(small_tree()).save(path)


def test_a_list_that_holds_itself_is_refused() -> None:
    endless: list[Any] = []
    endless.append(endless)
    with pytest.raises(meristem.InputError, match="nested too deeply"):
        meristem.Document(small_tree(step=endless))


@pytest.mark.parametrize("seed", [-1, 2**53 + 1])
def test_seeds_out_of_range_are_refused(seed: int) -> None:
    with pytest.raises(ValueError, match="seed must be a whole number from 0 to"):
        meristem.Document(small_tree(), seed=seed)


def test_seeds_of_other_types_are_refused() -> None:
    with pytest.raises(TypeError, match="seed must be a whole number"):
        meristem.Document(small_tree(), seed=1.5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="set must be a dict"):
        meristem.Document(small_tree(), set=[1])  # type: ignore[arg-type]


def test_components_tell_their_parameters() -> None:
    types = meristem.components()
    assert set(types) >= {"colonize", "leaf", "tree", "camera"}
    step = types["colonize"]["parameters"]["step"]
    assert step["default"] == 0.05 and "(m)" in step["expected"] and step["doc"]
    assert "colonize" in str(meristem.schema())


def test_parameter_tables_tell_editors_the_usual_range() -> None:
    tables = meristem.parameter_tables()
    rows = tables["tables"][tables["components"]["colonize"]["table"]]["rows"]
    step = next(row for row in rows if row["name"] == "step")
    assert step["above"] < step["usual"][0] < step["default"] < step["usual"][1] <= step["max"]


def test_documents_keep_to_a_root(tmp_path: Path) -> None:
    root = tmp_path / "root"
    root.mkdir()
    (tmp_path / "nodes.csv").write_text("x,y,z,parent\n0,0,0,-1\n0,0,1,0\n")
    (root / "nodes.csv").write_text("x,y,z,parent\n0,0,0,-1\n0,0,1,0\n")
    (root / "link.csv").symlink_to("../nodes.csv")

    def naming(name: str) -> str:
        return json.dumps({"meristem": 1, "components": {"tree": {"type": "skeleton", "file": name}}})

    (root / "plant.json").write_text(naming("nodes.csv"))
    plant = meristem.read(root / "plant.json", root=root)
    assert plant.root == str(root)
    assert plant.set(seed=3).root == str(root)
    assert pickle.loads(pickle.dumps(plant)).root == str(root)
    with pytest.raises(meristem.InputError, match="outside the folder that may be read"):
        plant.set({"tree.file": "../nodes.csv"})
    told = set()
    for name in ("../nodes.csv", "../missing.csv", "link.csv", str(tmp_path / "nodes.csv")):
        with pytest.raises(meristem.InputError, match="outside the folder that may be read") as raised:
            meristem.Document(naming(name), file=root / "plant.json", root=root)
        told.add(str(raised.value).replace(name, "NAME"))
    assert len(told) == 1, "the message must not say what exists"
    (tmp_path / "plant.json").write_text(naming("nodes.csv"))
    for name in ("plant.json", "missing.json"):
        with pytest.raises(meristem.InputError, match="outside the folder that may be read"):
            meristem.read(tmp_path / name, root=root)
        with pytest.raises(meristem.InputError, match="outside the folder that may be read"):
            meristem.Session.open(tmp_path / name, root=root)
    assert meristem.Session(plant).document is not None
    assert meristem.read("bush", root=root).name == meristem.read("bush").name


def test_messages_escape_what_a_terminal_acts_on(tmp_path: Path) -> None:
    hostile = "a\x1b[2J\u009b\u202e\u2066"
    for content in (
        {"meristem": 1, "components": {hostile: {"type": "leef"}}},
        {"meristem": 1, hostile: 1},
        {"meristem": 1, "components": {"leaf": {"type": "leaf", "length": hostile}}},
    ):
        with pytest.raises(meristem.InputError) as raised:
            meristem.Document(content)
        assert all(character == "\n" or character.isprintable() for character in str(raised.value))
        assert all(one.message.isprintable() and one.expected.isprintable() for one in raised.value.diagnostics)
    with pytest.raises(meristem.MachineError) as failed:
        meristem.read("bush").grow().save(str(tmp_path / "none" / (hostile + ".csv")))
    assert str(failed.value).isprintable()

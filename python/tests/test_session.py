# SPDX-License-Identifier: Apache-2.0
"""Sessions: edits that preserve the text, undo, errors, and partial regrowth."""

from __future__ import annotations

from pathlib import Path

import pytest

import meristem

BUSH = """// A bush.
{
  "meristem": 1,
  "variables": {"many": 5},
  "components": {
    "stem": {"type": "tree", "length": 0.50, "radius": 0.01},  // straight
    "leaf": {"type": "leaf", "length": 0.1, "width": 0.03}
  },
  "links": [{"from": "stem", "to": "leaf", "kind": "branch", "count": "many"}]
}
"""


def apply(text: str, patch: list[tuple[int, int, str]]) -> str:
    data = text.encode()
    for offset, length, replacement in reversed(patch):
        data = data[:offset] + replacement.encode() + data[offset + length :]
    return data.decode()


def test_an_edit_changes_the_text_where_it_must_and_gives_the_way_back() -> None:
    session = meristem.Session(BUSH)
    change = session.set("stem.length", 0.75)
    assert session.text == BUSH.replace("0.50", "0.75")
    assert apply(BUSH, change.patch) == session.text
    assert apply(session.text, change.inverse) == BUSH
    assert session.document is not None and session.document.to_dict()["components"]["stem"]["length"] == 0.75


def test_several_values_are_one_step() -> None:
    session = meristem.Session(BUSH)
    session.edit({"many": 7, "leaf.curl": 20})
    assert session.undo_count == 1
    session.undo()
    assert session.text == BUSH and session.redo_count == 1
    session.redo()
    assert '"curl": 20' in session.text


def test_members_and_elements_come_go_move_and_get_other_names() -> None:
    session = meristem.Session(BUSH)
    session.insert("components.bud", {"type": "simple"})
    session.insert("links[]", ["leaf", "bud"])
    session.move("links[1]", 0)
    session.rename("components.leaf", "blade")
    session.unset("blade.curl")
    session.rename("many", "count_of_leaves")
    assert session.is_good, session.faults
    assert list(session.document.components)[:3] == ["stem", "blade", "bud"]
    session.remove("components.bud")
    assert session.is_good and '"bud"' not in session.text


def test_notes_are_comments_and_go_where_their_components_go() -> None:
    session = meristem.Session(BUSH)
    assert session.notes == {"stem": "straight"}
    session.note("components.leaf", "along the stem")
    assert '    // along the stem\n    "leaf"' in session.text
    session.move("components.leaf", 0)
    assert session.text.index("// along the stem") < session.text.index('"leaf"') < session.text.index('"stem"')
    session.note("components.leaf", "")
    assert session.notes == {"stem": "straight"}


def test_parts_of_one_plant_are_put_into_another() -> None:
    bush = meristem.Session(BUSH)
    part = bush.part(["leaf"])
    assert '"leaf"' in part and '"stem"' not in part
    tree = meristem.Session('{"meristem": 1, "components": {"leaf": {"type": "simple"}}}')
    tree.paste(bush.part(["stem", "leaf"]), names={"leaf": "blade"})
    assert tree.is_good, tree.faults
    assert list(tree.document.components)[:3] == ["leaf", "stem", "blade"]
    assert '"many": 5' in tree.text and tree.notes == {"stem": "straight"} and tree.undo_count == 1
    with pytest.raises(meristem.InputError):
        bush.part(["nobody"])


def test_text_as_somebody_types_it() -> None:
    session = meristem.Session(BUSH)
    at = BUSH.encode().index(b"0.50")
    session.edit_text([(at, 4, "0.9")])
    assert session.text == BUSH.replace("0.50", "0.9")
    with pytest.raises(ValueError):
        session.edit_text([(10**6, 1, "")])


def test_faulty_text_is_kept_and_the_last_growth_stays() -> None:
    session = meristem.Session(BUSH)
    organs = len(session.grow().organs)
    session.set("leaf.width", "thick")
    assert not session.is_good
    assert session.faults[0].path == "components.leaf.width" and "thick" in session.text
    assert len(session.grow().organs) == organs
    with pytest.raises(meristem.InputError, match="leef"):
        session.set("leef.width", 1)
    session.undo()
    assert session.is_good


def test_what_grew_anew_is_told() -> None:
    session = meristem.Session(BUSH)
    session.grow()
    assert len(session.difference["added"]) == 2
    session.grow()
    assert session.difference == {"added": [], "changed": [], "removed": []}
    session.set("leaf.colour", "#ff0000")
    session.grow()
    assert session.difference["changed"] == ["leaf[0]"]


def test_a_preview_leaves_the_text() -> None:
    session = meristem.Session(BUSH)
    session.preview({"many": 2})
    assert len(session.grow().organs) == 2 and session.text == BUSH
    session.preview()
    assert len(session.grow().organs) == 5


def test_sessions_open_models_and_keep_to_a_root(tmp_path: Path) -> None:
    session = meristem.Session.open("bush", seed=4)
    assert session.is_good and session.document.seed == 4
    outside = meristem.Session(
        {
            "meristem": 1,
            "scene": {"obstacles": [{"mesh": "/etc/passwd"}]},
            "components": {"box": {"type": "simple"}},
        },
        root=tmp_path,
    )
    assert outside.faults[0].message == "'/etc/passwd': this lies outside the folder that may be read"
    assert outside.document is None
    with pytest.raises(meristem.InputError):
        outside.grow()


def test_a_document_that_is_set_grows_the_same_as_one_read_anew() -> None:
    first = meristem.Document(BUSH)
    first.grow()
    other = first.set({"leaf.length": 0.2}).set({"many": 9})
    other.grow()
    again = other.set({"stem.length": 0.6}).grow()
    alone = meristem.Document(BUSH, set={"leaf.length": 0.2, "many": 9, "stem.length": 0.6}).grow()
    assert (again.organs.frame == alone.organs.frame).all()
    assert (again.stems[0].skeleton.position == alone.stems[0].skeleton.position).all()


def test_a_session_of_a_document_has_its_text_with_the_values_that_were_set() -> None:
    document = meristem.Document(BUSH).set({"many": 8, "leaf.curl": 20}, seed=9)
    session = meristem.Session(document)
    assert session.text.startswith("// A bush.") and '"many": 8' in session.text and '"curl": 20' in session.text
    assert session.document is not None and session.document.seed == 9
    assert meristem.Session(meristem.Document(BUSH)).text == BUSH
    with pytest.raises(TypeError, match="has its own file, values and seed"):
        meristem.Session(document, seed=3)


def test_a_session_saves_its_text_as_it_is(tmp_path: Path) -> None:
    session = meristem.Session(BUSH)
    session.set("many", 6)
    session.save(tmp_path / "bush.json")
    assert (tmp_path / "bush.json").read_text(encoding="utf-8") == session.text
    session.edit_text([(0, 0, "{")])
    with pytest.raises(meristem.InputError):
        session.save(tmp_path / "faulty.json")
    assert not (tmp_path / "faulty.json").exists()

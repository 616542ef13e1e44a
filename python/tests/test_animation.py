# SPDX-License-Identifier: Apache-2.0
"""Plants at different times: keys, clocks, and growth as time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import meristem

KEYED: dict[str, Any] = {
    "meristem": 1,
    "variables": {"wide": 1},
    "components": {"box": {"type": "simple", "size": ["wide", 1, 1]}},
    "animation": {"length": 4, "keys": {"box.size[1]": [[0, 1], [4, 3]], "wide": [[0, 1], [2, 5]]}},
}


def test_a_plant_stands_as_its_keys_say() -> None:
    document = meristem.Document(KEYED)
    for time, width, height in ((0, 1, 1), (1, 3, 1.5), (4, 5, 3), (9, 5, 3)):
        plain = {**KEYED, "components": {"box": {"type": "simple", "size": [width, height, 1]}}}
        del plain["animation"], plain["variables"]
        by_hand = meristem.Document(plain).grow().bounds
        bounds = document.grow(time).bounds
        assert by_hand is not None and bounds is not None
        np.testing.assert_array_equal(bounds, by_hand)


def test_a_tree_grows_over_time() -> None:
    document = meristem.Document({
        "meristem": 1,
        "components": {"tree": {"type": "organize", "iterations": 6}},
        "animation": {"length": 6, "steps_per_second": 1},
    })
    nodes = [document.grow(time).node_count for time in (1, 2, 4, 6)]
    assert nodes == sorted(nodes) and nodes[0] < nodes[-1]


def test_faults_of_keys_are_told_with_their_place() -> None:
    wrong = {**KEYED, "animation": {"length": 4, "keys": {"box.siz": [[0, 1]]}}}
    with pytest.raises(meristem.InputError, match="size"):
        meristem.Document(wrong)


def test_an_animation_is_saved_for_engines(tmp_path: Path) -> None:
    path = tmp_path / "box.glb"
    meristem.Document(KEYED).save_animated(path, keys=3)
    assert path.read_bytes()[:4] == b"glTF"
    assert b'"name":"growth"' in path.read_bytes()
    with pytest.raises(ValueError, match="keys must be from 2"):
        meristem.Document(KEYED).save_animated(path, keys=1)
    stages: list[str] = []
    with pytest.raises(meristem.InputError, match="cannot hold an animation"):
        meristem.Document(KEYED).save_animated(tmp_path / "a.ply", progress=lambda stage, _: stages.append(stage))
    assert not stages, "nothing is grown for a file that cannot be written"
    still = {key: value for key, value in KEYED.items() if key != "animation"}
    with pytest.raises(meristem.InputError, match="no animation"):
        meristem.Document(still).save_animated(path)


def test_a_grammar_with_lives_has_a_time() -> None:
    text = "A\n#rules\nA @ 1.5 -> F A\n"
    assert str(meristem.derive(text, time=1.4)) == "A"
    assert str(meristem.derive(text, time=3)) == "FFA"
    with pytest.raises(meristem.InputError, match="counts no steps"):
        meristem.derive(text, 3)
    with pytest.raises(meristem.InputError, match="does not give its time"):
        meristem.derive(text)

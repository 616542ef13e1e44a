# SPDX-License-Identifier: Apache-2.0
"""Reads scene packets as described in apps/studio/protocol.md."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

#: Numbers per vertex, instance or triangle, and their type
ARRAYS = {
    "positions": (3, "<f4"),
    "normals": (4, "<i1"),
    "tangents": (4, "<i1"),
    "frames": (12, "<f4"),
    "tints": (4, "<u1"),
}
NUMBERS = {"u16": "<u2", "u32": "<u4", "f32": "<f4"}


class Packet:
    """The head, and the arrays that it names."""

    def __init__(self, data: bytes) -> None:
        assert data[:4] == b"MSP1"
        size = int.from_bytes(data[4:8], "little")
        assert size % 4 == 0
        self.head: dict[str, Any] = json.loads(data[8 : 8 + size])
        self._arrays = data[8 + size :]

    def array(self, item: dict[str, Any], name: str) -> NDArray[Any]:
        """Returns an array of a mesh or a set of instances, with a row per vertex, triangle or instance."""
        at, count = item[name]
        assert at % 4 == 0
        width, kind = ARRAYS.get(name, (0, ""))
        if name == "uvs":
            width, kind = 2, NUMBERS[item["uv_type"]]
        elif name == "indices":
            width, kind = 3, NUMBERS[item["index_type"]]
        return np.frombuffer(self._arrays, kind, count, at).reshape(-1, width)

    def bytes_of(self, item: dict[str, Any], name: str) -> bytes:
        at, count = item[name]
        return self._arrays[at : at + count]

    def batches(self) -> list[tuple[dict[str, Any], dict[str, Any], dict[str, Any]]]:
        """Returns the drawn batches, each with its mesh and its set of instances."""
        meshes = {mesh["key"]: mesh for mesh in self.head["meshes"]}
        sets = {one["key"]: one for one in self.head["instances_of"]}
        return [(one, meshes[one["mesh"]], sets[one["instances_of"]]) for one in self.head["batches"]]

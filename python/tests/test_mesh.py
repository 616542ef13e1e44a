# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import meristem

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])


def test_the_hull_of_a_cube_is_the_cube() -> None:
    inner = np.random.default_rng(1).random((50, 3))
    hull = meristem.convex_hull(np.vstack([CUBE, inner]))
    assert hull.area == pytest.approx(6)
    assert hull.volume == pytest.approx(1)
    assert hull.normals is None and hull.uvs is None and hull.tangents is None
    assert len(hull.positions) == 8 and len(hull.triangles) == 12


def test_flat_points_have_an_empty_hull() -> None:
    assert len(meristem.convex_hull(CUBE * [1, 0, 1]).triangles) == 0


def test_meshes_can_be_built_from_arrays() -> None:
    mesh = meristem.Mesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
    assert mesh.area == pytest.approx(2)
    assert mesh.triangles.tolist() == [[0, 1, 2]]
    assert not mesh.positions.flags.writeable


@pytest.mark.parametrize(
    ("positions", "triangles", "error", "message"),
    [
        (CUBE.T, [[0, 1, 2]], ValueError, r"positions must have shape \(n, 3\), not \(3, 8\)"),
        (CUBE, [0, 1, 2], ValueError, r"triangles must have shape \(m, 3\), not \(3,\)"),
        (CUBE, [[0, 1, 8]], ValueError, r"triangles\[2\] is 8; expected 0 to 7"),
        (CUBE, [[0, 1, -1]], ValueError, r"triangles\[2\] is -1"),
        (CUBE, [[0.0, 1.0, 2.0]], TypeError, "triangles must hold whole numbers"),
        ("text", [[0, 1, 2]], TypeError, "positions must hold real numbers"),
    ],
)
def test_wrong_meshes_are_refused(positions: Any, triangles: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        meristem.Mesh(positions, triangles)

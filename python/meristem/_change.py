# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from typing import NamedTuple


class Change(NamedTuple):
    """What a step of a Session did to the text's UTF-8 bytes.

    Both are lists of (offset, length, replacement): `length` bytes at `offset` go and the replacement comes; offsets are
    those of the text before the whole list, and rise.
    """

    patch: list[tuple[int, int, str]]
    inverse: list[tuple[int, int, str]]  #: gives the bytes before back

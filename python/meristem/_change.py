# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

from typing import NamedTuple


class Change(NamedTuple):
    """A step of a Session as changes of the text's UTF-8 bytes.

    Both fields are lists of (offset, length, replacement): the replacement replaces `length` bytes at `offset`. Offsets
    count in the text before the whole list, in rising order.
    """

    patch: list[tuple[int, int, str]]  #: makes the step
    inverse: list[tuple[int, int, str]]  #: restores the earlier bytes

# SPDX-License-Identifier: Apache-2.0
"""The change of a leaf's form with age, and the error of interpolating an omitted age."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping, NamedTuple, Sequence

import numpy as np
from meristem import grass

from .measured import AgedMidrib, Floats

TIP = 0.05  #: median error of the tip, as a share of the length


class Form(NamedTuple):
    """A midrib in leaf lengths."""

    age: float
    leaf: grass.GrassLeaf


@dataclass(frozen=True)
class AgeError:
    """Errors of a form interpolated from the previous and the next age, as shares of the length."""

    leaf_class: int
    age: float
    tip: float
    most: float  #: anywhere along the midrib
    nearest: float  #: error of the tip if the previous form is used unchanged


def make_form(midrib: AgedMidrib) -> Form:
    """Returns the midrib as measured, without smoothing."""
    chords = np.hypot(*np.diff(midrib.points, axis=0).T)
    places = np.append(0, np.cumsum(chords))
    s = places / places[-1]
    s[-1] = 1
    x, y = ((midrib.points - midrib.points[0]) / places[-1]).T
    return Form(midrib.age, grass.GrassLeaf(1, 0.05, s, x, y, 1 - s))


def points_of(leaf: grass.GrassLeaf) -> Floats:
    return np.column_stack([leaf.x, leaf.y])


def form_at(family: grass.MidribFamily, like: grass.GrassLeaf, age: float) -> Floats:
    """Returns the points of the whole midrib at an age."""
    return points_of(grass.aged(like, family, age, full_age=min(age, 1)))


def leave_out(leaf_class: int, forms: Sequence[Form]) -> list[AgeError]:
    """Interpolates each age except the first and last from the others."""
    errors = []
    for k in range(1, len(forms) - 1):
        age, leaf = forms[k]
        family = grass.MidribFamily([*forms[:k], *forms[k + 1 :]])
        pieces = family.piece_count
        true = points_of(grass.resampled(leaf, pieces))
        before = points_of(grass.resampled(forms[k - 1].leaf, pieces))
        off = np.hypot(*(form_at(family, leaf, age) - true).T)
        nearest = float(np.hypot(*(before - true)[-1]))
        errors.append(AgeError(leaf_class, age, float(off[-1]), float(off.max()), nearest))
    return errors


def leave_each_out(classes: Mapping[int, Sequence[AgedMidrib]]) -> dict[int, list[AgeError]]:
    return {name: leave_out(name, [make_form(midrib) for midrib in midribs]) for name, midribs in classes.items()}

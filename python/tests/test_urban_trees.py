# SPDX-License-Identifier: Apache-2.0
"""Shipped broad-leaved trees must have the height, diameter and crown of measured trees of their species."""

from __future__ import annotations

import sys
from pathlib import Path

import meristem
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "studies"))

from data_sets import data_files  # noqa: E402
from fit_study.urban import (  # noqa: E402
    SPECIES,
    Species,
    breast_diameter,
    measure_tree,
    outside,
    outside_ratios,
    read_bands,
)

SIZED = [species for species in SPECIES if species.size is not None]
#: The project's own file has the bands of some species, rounded outward to two digits.
BANDS = data_files("trees/urban_bands.csv", "trees/urban_tree_ranges.csv")


@pytest.mark.parametrize("species", SPECIES, ids=[species.model for species in SPECIES])
def test_trees_are_within_the_bands_of_their_species(species: Species) -> None:
    found = measure_tree(meristem.read(species.model).grow())
    for path in BANDS:
        assert outside(found, read_bands(species.measured, path)) == [], path


@pytest.mark.parametrize("species", SIZED, ids=[species.model for species in SIZED])
def test_trees_of_other_sizes_keep_the_proportions_of_their_species(species: Species) -> None:
    """Trees as thick as measured trees must have their slenderness and crown width."""
    assert species.size is not None
    for size in species.sizes:
        found = measure_tree(meristem.read(species.model, set={species.size: size}).grow())
        for path in BANDS:
            assert outside_ratios(found, read_bands(species.measured, path)) == [], (size, path)


def test_sizes_reach_from_end_to_end_of_their_variable() -> None:
    for species in SIZED:
        [variable] = [one for one in meristem.read(species.model).variables if one.name == species.size]
        assert (min(species.sizes), max(species.sizes)) == (variable.min, variable.max), species.model


def test_models_are_of_the_species_that_they_are_compared_with() -> None:
    for species in SPECIES:
        assert species.name in meristem.read(species.model).description


def test_the_diameter_is_that_of_the_thickest_stem_at_breast_height() -> None:
    # A tapering trunk of 10 to 20 cm in radius, and a second stem that bends below 1.3 m and up again.
    skeleton = meristem.Skeleton(
        [-1, 0, 1, 0, 3, 4],
        [[0, 1, 0], [0, 2, 0], [0, 3, 0], [1, 3, 0], [1, 2, 0], [1, 4, 0]],
        radius=[0.2, 0.16, 0.1, 0.05, 0.05, 0.05],
    )
    assert breast_diameter(skeleton) == pytest.approx(2 * (0.16 - 0.3 * 0.06))

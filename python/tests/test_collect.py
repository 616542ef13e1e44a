# SPDX-License-Identifier: Apache-2.0
"""The table of a batch's results."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import meristem
import numpy as np
import pytest
from plants import small_tree


def table_of(*results: Any, values: list[dict[str, Any]] | None = None, **arguments: Any) -> Any:
    """Returns the table of results, as if grown with seeds from 0."""
    values = values or [{} for _ in results]
    rows = [meristem.BatchResult(seed, one, result) for seed, (one, result) in enumerate(zip(values, results))]
    return meristem.collect(rows, **arguments)


def test_a_batch_becomes_a_table_of_seeds_values_and_measures() -> None:
    batch = meristem.batch(
        meristem.Document(small_tree()),
        seeds=[7, 8],
        grid={"tree.points": [100, 200]},
        measure=["height", "nodes"],
        processes=1,
    )
    table = meristem.collect(batch)
    assert table.dtype.names == ("seed", "tree.points", "height", "nodes")
    assert table["seed"].tolist() == [7, 8, 7, 8]
    assert table["tree.points"].tolist() == [100, 100, 200, 200]
    assert table["nodes"].dtype == np.float64
    plant = meristem.Document(small_tree(points=200), seed=8).grow()
    assert (table[3]["height"], table[3]["nodes"]) == (plant.measure()["height"], plant.node_count)


def test_what_is_unknown_is_nan() -> None:
    table = table_of({"slenderness": None}, {"slenderness": 40}, {})
    assert np.array_equal(table["slenderness"], [math.nan, 40, math.nan], equal_nan=True)
    assert np.isnan(table_of({"slenderness": None})["slenderness"]).all()


def test_results_without_names_are_one_column() -> None:
    assert table_of(3, 4.5)["result"].tolist() == [3, 4.5]


def test_arrays_of_one_shape_make_columns_of_that_shape() -> None:
    table = table_of({"a": np.eye(2, dtype=np.float32)}, {"a": np.ones((2, 2), dtype=np.float32)})
    assert table["a"].shape == (2, 2, 2)
    assert table["a"].dtype == np.float32
    assert table["a"][0].tolist() == [[1, 0], [0, 1]]


def test_a_missing_array_is_nan() -> None:
    table = table_of({"a": np.arange(3)}, {})
    expected: Any = [[0, 1, 2], [math.nan] * 3]
    assert np.array_equal(table["a"], expected, equal_nan=True)


def test_arrays_of_several_shapes_are_refused_unless_named() -> None:
    with pytest.raises(ValueError, match=r"the arrays 'a' differ in shape \(\(2,\), \(3,\)\); name it in `lists`"):
        table_of({"a": np.arange(2)}, {"a": np.arange(3)})
    table = table_of({"a": np.arange(2)}, {"a": np.arange(3)}, lists="a")
    expected: Any = [[0, 1, math.nan], [0, 1, 2]]
    assert np.array_equal(table["a"], expected, equal_nan=True)


def test_lists_are_left_out_unless_named_and_then_filled_up() -> None:
    results = [{"height": 1, "ratios": [4, None]}, {"height": 2, "ratios": [1, 2, 3]}, {"height": 3, "ratios": None}]
    assert table_of(*results).dtype.names == ("seed", "height")
    table = table_of(*results, lists=["ratios"])
    expected: Any = [[4, math.nan, math.nan], [1, 2, 3], [math.nan] * 3]
    assert np.array_equal(table["ratios"], expected, equal_nan=True)


def test_a_list_that_no_plant_has_is_refused() -> None:
    with pytest.raises(ValueError, match="no plant has a result 'ratio'; expected one of height"):
        table_of({"height": 1}, lists=["ratio"])


@pytest.mark.parametrize("result", [1 + 2j, np.complex128(1j), {1, 2}, [1j], object()])
def test_results_that_are_no_numbers_are_refused_by_name(result: Any) -> None:
    lists = ["odd"] if isinstance(result, list) else []
    with pytest.raises(ValueError, match="the results 'odd' must be (numbers|lists of numbers)"):
        table_of({"height": 1, "odd": 1}, {"height": 2, "odd": result}, lists=lists)


@pytest.mark.parametrize("result", [3, "abc", ["a"], {"a": 1}, [[1, 2], [3, 4]], [[1, 2], [3]], np.eye(2)])
def test_what_is_named_in_lists_must_be_a_list_of_numbers(result: Any) -> None:
    with pytest.raises(ValueError, match="the results 'x' must be lists of numbers"):
        table_of({"x": [1, 2]}, {"x": result}, lists="x")


def test_names_of_lists_are_texts() -> None:
    with pytest.raises(TypeError, match="lists must be names of results, not int"):
        table_of({"x": [1, 2]}, lists=3)


@pytest.mark.parametrize("name", [3, ("a", "b"), None, ""])
def test_names_of_columns_must_be_texts(name: Any) -> None:
    with pytest.raises(ValueError, match="the name of a column must be a text, not "):
        table_of({"height": 1, name: 2})


def test_numbers_of_any_kind_become_floats() -> None:
    numbers = [True, 2**70, np.float32(0.5), np.array(3), Fraction(1, 4)]
    assert table_of(*numbers)["result"].tolist() == [1, 2.0**70, 0.5, 3, 0.25]


def test_two_columns_of_one_name_are_refused() -> None:
    for values, result in (
        ({"x": 1, "result.x": 2}, {"x": 3}),
        ({"x": 1}, {"x": 3, "result.x": 4}),
        ({"x": 1}, {"result.x": 4, "x": 3}),
    ):
        with pytest.raises(ValueError, match="two columns would have the name 'result.x'"):
            table_of(result, values=[values])
    with pytest.raises(ValueError, match="two columns would have the name 'seed'"):
        table_of(1, values=[{"seed": 4}])


def test_a_result_of_a_values_name_keeps_both() -> None:
    table = table_of({"height": 2}, {"height": 3}, values=[{"height": 20}, {"height": 30}])
    assert table["height"].tolist() == [20, 30]
    assert table["result.height"].tolist() == [2, 3]


def test_values_that_are_no_numbers_stay_what_they_are() -> None:
    values: list[dict[str, Any]] = [
        {"kind": "round", "sun": {"hour": 9}, "place": [0, 1]},
        {"kind": "tall", "sun": None, "place": [2, 3]},
    ]
    table = table_of(1, 2, values=values)
    assert table["kind"].tolist() == ["round", "tall"]
    assert table["sun"].tolist() == [{"hour": 9}, None]
    assert table["place"].tolist() == [[0, 1], [2, 3]]


def test_lists_as_values_may_differ_in_length() -> None:
    table = table_of(1, 2, values=[{"size": [1.0]}, {"size": [1.0, 2.0]}])
    assert table["size"].tolist() == [[1], [1, 2]]


def test_lists_of_texts_as_values_stay_lists() -> None:
    table = table_of(1, 2, values=[{"parts": ["stem", "leaf"]}, {"parts": ["stem", "bud"]}])
    assert table["parts"].tolist() == [["stem", "leaf"], ["stem", "bud"]]


def test_the_largest_seed_is_kept() -> None:
    rows = [meristem.BatchResult(2**64 - 1, {}, 0)]
    assert meristem.collect(rows)["seed"][0] == 2**64 - 1


def test_no_results_make_an_empty_table() -> None:
    table = meristem.collect([])
    assert (len(table), table.dtype.names) == (0, ("seed",))

# SPDX-License-Identifier: Apache-2.0
"""The results of a batch as one table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._batch import BatchResult


def collect(batch: Iterable[BatchResult], *, lists: str | Iterable[str] = ()) -> NDArray[np.void]:
    """Grows a whole batch and returns a structured array (n,), one row per plant, in the batch's order.

    The columns are `seed`, the paths of values, and the names of measures or of the function's dict, or `result` if the
    function returns no dict. A result with the name of a path or `seed` is called `result.NAME`. Numbers are float64,
    NaN for None and for missing results. Arrays of one shape for all plants make columns of shape (n, ...).

    Some lists, such as `length_by_order`, differ in length from plant to plant. Only lists named in `lists` become
    columns, as long as the longest list; shorter lists are filled up with NaN. Raises ValueError for arrays that differ
    in shape, and for results that are neither numbers nor texts nor dicts. Also raises ValueError for names in `lists`
    that no plant has or that are not lists of numbers, for names that are not texts, and for two columns of one name.
    """
    if not isinstance(lists, Iterable):
        raise TypeError(f"lists must be names of results, not {type(lists).__name__}")
    rows = list(batch)
    wanted = (lists,) if isinstance(lists, str) else tuple(lists)
    columns: dict[str, NDArray[Any]] = {"seed": _seeds(rows)}
    for path, values in _by_name([row.values for row in rows]).items():
        _add(columns, path, _value_column(values))
    results = _by_name([row.result if isinstance(row.result, Mapping) else {"result": row.result} for row in rows])
    for name in wanted:
        if rows and name not in results:
            raise ValueError(f"no plant has a result {name!r}; expected one of {', '.join(results)}")
    taken = set(columns)
    for name, items in results.items():
        column = _list_column(name, items) if name in wanted else _result_column(name, items)
        if column is not None:
            _add(columns, f"result.{name}" if name in taken else name, column)
    return _table(len(rows), columns)


def _by_name(dicts: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """Returns the values of each name in all dicts, None if a dict lacks the name."""
    names = dict.fromkeys(name for one in dicts for name in one)
    for name in names:
        if not isinstance(name, str) or not name:
            raise ValueError(f"the name of a column must be a text, not {name!r}")
    return {name: [one.get(name) for one in dicts] for name in names}


def _add(columns: dict[str, NDArray[Any]], name: str, column: NDArray[Any]) -> None:
    if name in columns:
        raise ValueError(f"two columns would have the name {name!r}; give the result another name")
    columns[name] = column


def _seeds(rows: Sequence[BatchResult]) -> NDArray[Any]:
    seeds = [int(row.seed) for row in rows]
    is_large = any(seed >= 2**63 for seed in seeds)
    return np.array(seeds, dtype=np.uint64 if is_large else np.int64)


def _value_column(values: list[Any]) -> NDArray[Any]:
    """Returns a numpy array of numbers, texts or lists of one shape, and an array of objects otherwise."""
    try:
        column = np.array(_with_nan(values))
    except ValueError:
        column = np.empty(0, dtype=object)
    if column.dtype.kind in "biuf" or (column.dtype.kind == "U" and all(isinstance(value, str) for value in values)):
        return column
    column = np.empty(len(values), dtype=object)
    for index, value in enumerate(values):  # one by one, because assigning all would split lists
        column[index] = value
    return column


def _result_column(name: str, items: list[Any]) -> NDArray[Any] | None:
    present = [item for item in items if item is not None]
    if any(isinstance(item, Sequence) and not isinstance(item, (str, bytes)) for item in present):
        return None
    if any(isinstance(item, np.ndarray) and item.ndim > 0 for item in present):
        return _array_column(name, items, present)
    if any(isinstance(item, (str, bytes, Mapping)) for item in present):
        return _value_column(items)
    column = _numbers(items)
    if column is None:
        raise ValueError(f"the results {name!r} must be numbers or arrays of numbers, texts or dicts")
    return column


def _array_column(name: str, items: list[Any], present: list[Any]) -> NDArray[Any]:
    shapes = {np.shape(item) for item in present}
    if len(shapes) > 1:
        told = ", ".join(str(shape) for shape in sorted(shapes)[:3])
        raise ValueError(f"the arrays {name!r} differ in shape ({told}); name it in `lists`, or bring them to one")
    if len(present) == len(items):
        return np.array(items)
    missing = np.full(shapes.pop(), math.nan)
    return np.array([missing if item is None else item for item in items])


def _list_column(name: str, items: list[Any]) -> NDArray[Any]:
    rows = [_numbers([] if item is None else item) for item in items]
    lists = [row for row in rows if row is not None]
    if len(lists) < len(rows):
        raise ValueError(f"the results {name!r} must be lists of numbers, as `lists` names them")
    column = np.full((len(lists), max(map(len, lists))), math.nan)
    for row, numbers in zip(column, lists):
        row[: len(numbers)] = numbers
    return column


def _numbers(items: Any) -> NDArray[np.float64] | None:
    """Returns the items (n,), with NaN for None. Returns None if they are not a series of numbers."""
    try:
        numbers = np.array(_with_nan(items))
        if numbers.ndim != 1 or numbers.dtype.kind not in "biufO" or isinstance(items, Mapping):
            return None
        return numbers.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        return None


def _with_nan(values: Iterable[Any]) -> list[Any]:
    return [math.nan if value is None else value for value in values]


def _table(length: int, columns: Mapping[str, NDArray[Any]]) -> NDArray[np.void]:
    table = np.empty(length, dtype=[(name, column.dtype, column.shape[1:]) for name, column in columns.items()])
    for name, column in columns.items():
        table[name] = column
    return table

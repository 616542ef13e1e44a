# SPDX-License-Identifier: Apache-2.0
"""Grows many plants of one document, over seeds and parameters, on all cores."""

from __future__ import annotations

import itertools
import math
import multiprocessing
import operator
import os
import pickle
import sys
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sized
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

from ._carried import Carried
from ._core import Document, Plant, Skeleton
from ._executor import check_executor
from ._job import Job, Measure, Task, refuse_seed
from ._pool import refuse_unguarded_program
from ._progress import ProgressCallback, teller
from ._runner import Runner

Values = Mapping[str, Any]


@dataclass(frozen=True)
class BatchResult:
    """One plant of a batch.

    batch() yields it:

        results = meristem.batch(meristem.read("tulip"), seeds=range(3), measure="height", processes=1)
        for result in results:
            print(result.seed, result.result["height"])
    """

    seed: int  #: seed of the plant
    values: dict[str, Any]  #: values by path, from `grid` or `samples`, without the values of `set`
    result: Any  #: a dict of measures, or the result of the function


def batch(
    document: Document,
    *,
    seeds: Iterable[int] = range(10),
    set: Values | None = None,
    grid: Mapping[str, Iterable[Any]] | None = None,
    samples: Iterable[Values] | None = None,
    measure: str | Iterable[str] | Callable[[Plant], Any] | None = None,
    processes: int | None = None,
    executor: Executor | None = None,
    progress: ProgressCallback | bool | None = None,
) -> Generator[BatchResult, None, None]:
    """Grows a plant for every seed of every set of values, and yields a BatchResult for each, in this order.

    `set` gives values for all plants, as in Document.set(). `grid` has sequences of values by path. All combinations
    grow, and the last path changes fastest. `samples`, instead of a grid, are dicts of values. Samples and seeds may be
    endless: only a bounded number of plants grows ahead, and memory stays flat.

    `measure`: names of measures (one or several), all of them if None, or a function of the plant that returns
    numbers, arrays, or a dict of them. Results are copies. Workers import the function, so define it at the top level
    of a module. Each plant grows on one thread, in `processes` processes at a time: all cores if None; 1 grows in this
    process. The results do not depend on it. Instead of processes, an `executor` grows the plants in chunks: any object
    with the interface concurrent.futures.Executor, such as Dask's or mpi4py's. The document is sent with the files that
    it names. `progress` is called with the number of finished plants and the total, None if it is unknown. True prints
    them on standard error, with the remaining time.

    The processes end with the loop, also after `break` or an error, or by close(). Raises InputError at once if the
    first values do not suit the document, and ValueError and TypeError for wrong arguments. The iterator raises the
    errors of growth and of the function, with a note of seed and values, and MachineError if a process was killed.
    """
    refuse_unguarded_program()
    if not isinstance(document, Document):
        raise TypeError(f"document must be a Document, not {type(document).__name__}")
    if not isinstance(seeds, Iterable):
        raise TypeError(f"seeds must be several numbers, such as [3] or range(10), not {type(seeds).__name__}")
    tell = teller(progress, "plant")
    if set is not None:
        document = document.set(set)
        refuse_seed(set)
    count = check_processes(processes, executor)
    sets = _sets_of_values(grid, samples)
    total = _total(seeds, sets)
    if (grid is not None or samples is not None) and iter(seeds) is seeds:
        raise ValueError("beside grid or samples, seeds must be a list or range: every set of values uses all of them")
    job = Job(document, check_measure(measure))
    tasks = _checked_tasks(job, (Task(seed, values) for values in map(_values_of, sets) for seed in seeds))
    pickled = pickle_job(job, executor) if count > 1 or executor is not None else None
    return _grow(job, pickled, count if total is None else min(count, total), tasks, total, tell, executor)


def _grow(
    job: Job,
    pickled: bytes | None,
    count: int,
    tasks: Iterable[Task],
    total: int | None,
    progress: ProgressCallback | None,
    executor: Executor | None,
) -> Generator[BatchResult, None, None]:
    done = itertools.count(1)

    def tell() -> None:
        if progress is not None:
            progress(next(done), total)

    with Runner(job, pickled, count, executor) as runner:
        for task, result in runner.run(tasks, tell):
            yield BatchResult(task.seed, dict(task.values), result)


def check_processes(processes: int | None, executor: Executor | None) -> int:
    """Returns the number of worker processes, or 1 with an executor. Raises ValueError if both are given."""
    if executor is None:
        return count_processes(processes)
    check_executor(executor)
    if processes is not None:
        raise ValueError("an executor has its own workers: give processes or executor, not both")
    return 1


def count_processes(processes: int | None) -> int:
    """Returns the number of worker processes: all cores if None. Raises ValueError below 1."""
    if processes is not None:
        count = operator.index(processes)
        if count < 1:
            raise ValueError(f"processes must be at least 1, not {count}")
        return count
    if multiprocessing.current_process().daemon:
        return 1  # workers of some pools cannot start processes
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _sets_of_values(grid: Mapping[str, Iterable[Any]] | None, samples: Iterable[Values] | None) -> Iterable[Values]:
    if grid is not None and samples is not None:
        raise ValueError("give grid or samples, not both")
    if samples is not None:
        if isinstance(samples, Mapping) or not isinstance(samples, Iterable):
            raise TypeError("samples must be several dicts, such as [{'age': 20}, {'age': 40}]")
        return samples
    if grid is not None and not isinstance(grid, Mapping):
        raise TypeError(f"grid must be a dict of sequences, such as {{'age': [20, 40]}}, not {type(grid).__name__}")
    columns = {}
    for path, values in (grid or {}).items():
        if isinstance(values, str) or not hasattr(values, "__iter__"):
            raise TypeError(f"grid['{path}'] must be a sequence of values, such as [20, 40]")
        columns[path] = list(values)
    return _Combinations(columns)


class _Combinations(Sized):
    """All combinations of a grid, for repeated iteration."""

    def __init__(self, columns: dict[str, list[Any]]) -> None:
        self._columns = columns

    def __len__(self) -> int:
        return math.prod(len(values) for values in self._columns.values())

    def __iter__(self) -> Iterator[Values]:
        for combination in itertools.product(*self._columns.values()):
            yield dict(zip(self._columns, combination))


def _total(seeds: Iterable[int], sets: Iterable[Values]) -> int | None:
    if isinstance(seeds, Sized) and isinstance(sets, Sized):
        return len(seeds) * len(sets)
    return None


def _values_of(sample: Values) -> dict[str, Any]:
    try:
        return dict(sample)
    except (TypeError, ValueError):
        raise TypeError(f"samples must be dicts, such as {{'age': 20}}, not {type(sample).__name__}") from None


def _checked_tasks(job: Job, tasks: Iterator[Task]) -> Iterator[Task]:
    """Returns the tasks. Raises InputError if the first task does not suit the document."""
    for first in tasks:
        job.document_of(first)
        return itertools.chain([first], tasks)
    return tasks


def check_measure(measure: str | Iterable[str] | Callable[[Plant], Any] | None) -> Measure:
    """Returns the measure for a Job. Raises ValueError for unknown names."""
    if measure is None or callable(measure):
        return measure
    if not isinstance(measure, Iterable):
        raise TypeError(f"measure must be names of measures or a function of the plant, not {type(measure).__name__}")
    names = (measure,) if isinstance(measure, str) else tuple(measure)
    known = Skeleton([-1], [[0, 0, 0]]).measure()
    for name in names:
        if name not in known:
            raise ValueError(f"there is no measure {name!r}; expected one of {', '.join(known)}")
    return names


def pickle_job(job: Job, executor: Executor | None = None) -> bytes:
    """Returns the pickled job for the workers. For an executor, it includes the files of its document.

    Raises RuntimeError and TypeError for programs and functions that workers cannot import.
    """
    program = getattr(sys.modules["__main__"], "__file__", None)
    if program == "<stdin>" and executor is None:
        raise RuntimeError(
            "workers cannot read a program from standard input: put it into a file, or grow with processes=1"
        )
    if callable(job.measure):
        module = getattr(job.measure, "__module__", None)
        name = getattr(job.measure, "__qualname__", repr(job.measure))
        how = "define it at the top of a module, or grow with processes=1"
        if module == "__main__" and program is None:  # a notebook or a prompt
            raise TypeError(f"a worker cannot import {name}, because this session is not a file; {how}")
        try:
            pickle.dumps(job.measure)
        except Exception as error:
            raise TypeError(f"a worker cannot import {name} ({error}); {how}") from error
    return pickle.dumps(job if executor is None else replace(job, document=Carried(job.document)))

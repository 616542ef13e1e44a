# SPDX-License-Identifier: Apache-2.0
"""Runs tasks of one job: in this process, on worker processes, which stay for further tasks, or on an executor."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from types import TracebackType
from typing import Any

from ._executor import AnyJob, ExecutorPool
from ._pool import Pool


class Runner:
    """Runs the tasks of a job. Leaving its `with` block ends the worker processes; an executor keeps running."""

    def __init__(
        self, job: AnyJob, pickled: bytes | None, count: int, executor: Executor | None = None, *, chunks: bool = True
    ) -> None:
        """Uses the executor with the pickled job. Without an executor, uses `count` processes, or this process if there
        is no pickled job.

        Tasks are sent to an executor in `chunks`, or one by one.
        """
        self._job = job
        self._pool: Pool | ExecutorPool | None = None
        if pickled is not None:
            self._pool = Pool(pickled, count) if executor is None else ExecutorPool(pickled, executor, chunks=chunks)

    def run(self, tasks: Iterable[Any], tell: Callable[[], None]) -> Iterator[tuple[Any, Any]]:
        """Yields the tasks with their results, in order. Calls `tell` for each finished task."""
        if self._pool is not None:
            for task, result in self._pool.run(tasks, tell):
                yield task, pickle.loads(result)
            return
        for task in tasks:
            result = self._job.run(task)
            tell()
            yield task, pickle.loads(result)

    def __enter__(self) -> Runner:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._pool is not None:
            self._pool.stop()

# SPDX-License-Identifier: Apache-2.0
"""Runs tasks of one job: here, on worker processes, which stay for the next ones, or on an executor."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from types import TracebackType
from typing import Any

from ._executor import AnyJob, ExecutorPool
from ._pool import Pool


class Runner:
    """Where the tasks of a job are run. Its end, by `with`, is that of the processes; an executor goes on."""

    def __init__(
        self, job: AnyJob, pickled: bytes | None, count: int, executor: Executor | None = None, *, chunks: bool = True
    ) -> None:
        """With the pickled job on an executor or, without one, on `count` processes; in this one if there is none.

        Tasks go to an executor in `chunks`, or one by one.
        """
        self._job = job
        self._pool: Pool | ExecutorPool | None = None
        if pickled is not None:
            self._pool = Pool(pickled, count) if executor is None else ExecutorPool(pickled, executor, chunks=chunks)

    def run(self, tasks: Iterable[Any], tell: Callable[[], None]) -> Iterator[tuple[Any, Any]]:
        """The tasks with their results, in order. Calls `tell` whenever one is done."""
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

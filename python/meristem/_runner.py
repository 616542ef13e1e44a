# SPDX-License-Identifier: Apache-2.0
"""Runs plants of one job, here or on worker processes, which stay for the next ones."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterable, Iterator
from types import TracebackType
from typing import Any

from ._job import Job, Task
from ._pool import Pool


class Runner:
    """Where the plants of a job are grown. Its end, by `with`, is that of the processes."""

    def __init__(self, job: Job, pickled: bytes | None, count: int) -> None:
        """On `count` processes with the pickled job; in this one if there is none."""
        self._job = job
        self._pool = Pool(pickled, count) if pickled is not None else None

    def run(self, tasks: Iterable[Task], tell: Callable[[], None]) -> Iterator[tuple[Task, Any]]:
        """The tasks with their results, in order. Calls `tell` whenever a plant is done."""
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

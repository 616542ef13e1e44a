# SPDX-License-Identifier: Apache-2.0
"""Runs the tasks of a job on whatever offers `concurrent.futures.Executor`: Dask, processes, MPI.

Tasks travel in chunks that take about half a second each, by the time that the last ones took, so that even an engine
that needs milliseconds for a task costs next to nothing. A few chunks for each worker are under way, never more, so the
memory of this process does not rise with the number of tasks. Results come in order.

The job travels by content, and workers keep it: a small one with every chunk, a large one only to workers that say that
they do not have it. What a job raises travels as data, so whatever else a future raises is a failure of the engine.
"""

from __future__ import annotations

import hashlib
import os
import threading
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import CancelledError, Executor, Future
from typing import Any, Optional, Protocol, Tuple

from ._errors import MachineError
from ._pool import load_job, pickle_failure, result_of

_SECONDS = 0.5  #: that a chunk should take
_MOST_TOGETHER = 1000
_UNDER_WAY = 3  #: chunks for each worker: the one that it runs, and what waits for it
_SMALL = 32_000  #: bytes of a job that travels with every chunk
_RECOUNT = 5.0  #: seconds after which workers are counted again: some engines hire and lay off
_JOBS_KEPT = 4

#: Pickled result or pickled failure of each task, and the seconds that they took; None: the worker has no such job.
_Answers = Optional[Tuple["list[tuple[bytes | None, bytes | None]]", float]]


class AnyJob(Protocol):
    """What a job does for each task: see _job.py."""

    def run(self, task: Any) -> bytes: ...


class ExecutorPool:
    """The tasks of one job on an executor, which stays the caller's. Has what a Pool has."""

    def __init__(self, job: bytes, executor: Executor, *, chunks: bool = True) -> None:
        """`job` is pickled. Without `chunks`, each task is sent by itself."""
        self._job = job
        self._key = hashlib.blake2b(job, digest_size=16).hexdigest()
        self._executor = executor
        self._most_together = _MOST_TOGETHER if chunks else 1
        self._seconds = 0.0  #: a task's, of late
        self._largest = 0  #: chunk that has come back
        self._under_way: deque[tuple[Future[_Answers], list[Any]]] = deque()
        self._workers = 0
        self._counted = -_RECOUNT

    def run(self, tasks: Iterable[Any], tell: Callable[[], None]) -> Iterator[tuple[Any, bytes]]:
        """The tasks with their pickled results, in order. Calls `tell` for each task that is done.

        Raises what the job raises, at the task's turn, and MachineError where the engine fails.
        """
        source = iter(tasks)
        try:
            while True:
                self._send(source)
                if not self._under_way:
                    return
                future, chunk = self._under_way[0]
                answers = self._answers_of(future, chunk)
                self._under_way.popleft()
                for task, (result, failure) in zip(chunk, answers):
                    tell()
                    yield task, result_of(result, failure)
        finally:
            self.stop()

    def stop(self) -> None:
        """Cancels what has not begun; what has begun ends by itself, within about half a second or one task."""
        for future, _ in self._under_way:
            future.cancel()
        self._under_way.clear()

    def _send(self, source: Iterator[Any]) -> None:
        while len(self._under_way) < _UNDER_WAY * self._count_workers():
            chunk = self._next_chunk(source)
            if not chunk:
                return
            self._under_way.append((self._submit(chunk, len(self._job) <= _SMALL), chunk))

    def _next_chunk(self, source: Iterator[Any]) -> list[Any]:
        # Twice the largest one at most, as the first tasks may have been quick by chance.
        most = min(max(1, 2 * self._largest), self._most_together)
        count = 1 if self._seconds <= 0 else int(min(max(_SECONDS / self._seconds, 1), most))
        chunk = []
        for task in source:
            chunk.append(task)
            if len(chunk) == count:
                break
        return chunk

    def _submit(self, chunk: Sequence[Any], with_job: bool) -> Future[_Answers]:
        try:
            return self._executor.submit(run_chunk, self._key, self._job if with_job else None, list(chunk))
        except Exception as error:
            raise MachineError(f"the executor takes no more tasks: {_words(error)}") from error

    def _answers_of(self, future: Future[_Answers], chunk: list[Any]) -> list[tuple[bytes | None, bytes | None]]:
        answers = self._wait(future, chunk)
        if answers is None:
            again = self._submit(chunk, True)
            self._under_way[0] = (again, chunk)
            answers = self._wait(again, chunk)
            assert answers is not None
        results, seconds = answers
        each = seconds / len(chunk)
        self._largest = max(self._largest, len(chunk))
        self._seconds = each if self._seconds <= 0 else 0.7 * self._seconds + 0.3 * each
        return results

    @staticmethod
    def _wait(future: Future[_Answers], chunk: list[Any]) -> _Answers:
        try:
            return future.result()
        except (KeyboardInterrupt, SystemExit):
            raise
        except CancelledError:
            raise MachineError(f"the executor has cancelled what was under way at {chunk[0]}") from None
        except Exception as error:
            raise MachineError(f"the executor has failed at {chunk[0]}: {_words(error)}") from error

    def _count_workers(self) -> int:
        now = time.monotonic()
        if now - self._counted >= _RECOUNT:
            self._counted = now
            self._workers = count_workers(self._executor)
        return self._workers


def count_workers(executor: Executor) -> int:
    """How many tasks the executor runs at once, as far as it tells; else the cores of this machine."""
    client = getattr(executor, "_client", None)  # Dask's
    if client is not None and hasattr(client, "nthreads"):
        return max(1, sum(int(count) for count in client.nthreads().values()))
    for holder in (executor, getattr(executor, "_pool", None)):  # mpi4py's pool has a size
        for name in ("num_workers", "_max_workers", "size"):
            count = getattr(holder, name, None)
            if isinstance(count, int) and count > 0:
                return count
    return os.cpu_count() or 1


def check_executor(executor: object) -> Executor:
    """The executor. Raises TypeError for what is none, with what to write instead."""
    if hasattr(executor, "submit") and hasattr(executor, "shutdown"):
        return executor  # type: ignore[return-value]
    hint = "; Client.get_executor() gives one" if hasattr(executor, "get_executor") else ""
    raise TypeError(f"executor must be a concurrent.futures.Executor, not {type(executor).__name__}{hint}")


def _words(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


# In the worker

_jobs: OrderedDict[str, Any] = OrderedDict()
_lock = threading.Lock()  # a worker may run several tasks at once, on threads


def run_chunk(key: str, job: bytes | None, tasks: Sequence[Any]) -> _Answers:
    """What a worker does with a chunk: one task after another, up to the first that fails."""
    try:
        known = _job_of(key, job)
    except Exception as error:
        return [(None, pickle_failure(error))], 0.0
    if known is None:
        return None
    begin = time.perf_counter()
    answers: list[tuple[bytes | None, bytes | None]] = []
    for task in tasks:
        try:
            answers.append((known.run(task), None))
        except Exception as error:
            answers.append((None, pickle_failure(error)))
            break
    return answers, time.perf_counter() - begin


def _job_of(key: str, job: bytes | None) -> AnyJob | None:
    with _lock:
        known = _jobs.get(key)
        if known is None:
            if job is None:
                return None
            known = load_job(job)
            _jobs[key] = known
            while len(_jobs) > _JOBS_KEPT:
                _jobs.popitem(last=False)
        _jobs.move_to_end(key)
        return known

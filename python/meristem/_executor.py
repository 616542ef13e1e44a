# SPDX-License-Identifier: Apache-2.0
"""Runs the tasks of a job on any object with the interface `concurrent.futures.Executor`: Dask, processes, MPI.

Tasks are sent in chunks of about half a second, estimated from previous tasks. Even an engine that needs milliseconds
per task then costs almost nothing. At most a few chunks per worker are under way, so the memory of this process does
not rise with the number of tasks. Results come in order.

The job is sent by content, and workers keep it. A small job is sent with every chunk. A large job is sent only to
workers that report that they lack it. Errors of a job are sent as data, so any other error of a future is a failure of
the engine.
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

_SECONDS = 0.5  #: intended time of a chunk
_MOST_TOGETHER = 1000
_UNDER_WAY = 3  #: chunks per worker: the running chunk and waiting chunks
_SMALL = 32_000  #: largest size of a job that is sent with every chunk
_RECOUNT = 5.0  #: seconds after which workers are counted again, because some engines add and remove workers
_JOBS_KEPT = 4

#: Pickled result or pickled failure of each task, and the seconds of the chunk. None: the worker lacks the job.
_Answers = Optional[Tuple["list[tuple[bytes | None, bytes | None]]", float]]


class AnyJob(Protocol):
    """The work for each task: see _job.py."""

    def run(self, task: Any) -> bytes: ...


class ExecutorPool:
    """The tasks of one job on an executor, which stays the caller's. Has what a Pool has."""

    def __init__(self, job: bytes, executor: Executor, *, chunks: bool = True) -> None:
        """`job` is pickled. Without `chunks`, each task is sent separately."""
        self._job = job
        self._key = hashlib.blake2b(job, digest_size=16).hexdigest()
        self._executor = executor
        self._most_together = _MOST_TOGETHER if chunks else 1
        self._seconds = 0.0  #: recent seconds per task
        self._largest = 0  #: tasks of the largest finished chunk
        self._under_way: deque[tuple[Future[_Answers], list[Any]]] = deque()
        self._workers = 0
        self._counted = -_RECOUNT

    def run(self, tasks: Iterable[Any], tell: Callable[[], None]) -> Iterator[tuple[Any, bytes]]:
        """Yields the tasks with their pickled results, in order. Calls `tell` for each finished task.

        Raises the job's errors at the task's turn, and MachineError if the engine fails.
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
        """Cancels tasks that have not begun. Running chunks end within about half a second or one task."""
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
        # At most twice the largest chunk so far, because the first tasks may have been quick by chance.
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
    """Returns the number of tasks that the executor runs at once. If it is unknown, returns the number of cores."""
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
    """Returns the executor. For other objects, raises TypeError with advice."""
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
    """Runs a chunk in a worker: one task after another, up to the first failure."""
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

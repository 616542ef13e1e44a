# SPDX-License-Identifier: Apache-2.0
"""Worker processes that grow the plants of a batch, and end with it.

Each worker has one pipe to the calling process. Tasks come in, and pickled results go out. When the other end is
closed, by stop() or by the death of the calling process, the worker cancels its growth and exits. This needs no polling
and no thread in the calling process, and no worker outlives the calling process.

The pools of the standard library are not suitable: their workers always finish a plant that they have begun, and the
task of a killed worker is unknown.
"""

from __future__ import annotations

import itertools
import multiprocessing
import os
import pickle
import queue
import signal
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from multiprocessing.resource_tracker import ensure_running
from typing import TYPE_CHECKING, Callable, Optional, Tuple

from ._core import Progress
from ._errors import MachineError
from ._job import Job, Task, add_note

if TYPE_CHECKING:
    from multiprocessing.context import ForkServerContext, SpawnContext

_NAME = "meristem batch worker"
_UNGUARDED = 97  #: a worker's exit code if the program would start a batch in each worker
_GIVEN = 2  #: largest number of tasks of a worker: the running task and the next one, so that it never waits
_AHEAD = 4  #: largest number of plants per worker ahead of the next result
_GRACE = 0.3  #: seconds for which a function of the plant may continue after the end

#: Number of the task, pickled result, pickled failure
_Answer = Tuple[int, Optional[bytes], Optional[bytes]]


class Pool:
    """Processes that run one Job for many tasks."""

    def __init__(self, job: bytes, count: int) -> None:
        """Starts `count` processes. `job` is a pickled Job."""
        self._workers: list[_Worker] = []
        self._numbers = itertools.count()  #: number of tasks, over all runs
        # Not "fork": a forked child has the locks of the library's threads, but not the threads.
        context: ForkServerContext | SpawnContext
        if "forkserver" in multiprocessing.get_all_start_methods():
            context = multiprocessing.get_context("forkserver")
            context.set_forkserver_preload(["meristem._server"])  # halves the time in which workers start
        else:
            context = multiprocessing.get_context("spawn")
        try:
            with _interrupts_deferred():
                for _ in range(count):
                    ours, theirs = context.Pipe()
                    process = context.Process(target=_work, args=(theirs, job), name=_NAME, daemon=True)
                    self._workers.append(_Worker(ours, process))
                    process.start()
                    theirs.close()  # so that this end shows the death of the worker
        except BaseException:
            self.stop()
            raise

    def run(self, tasks: Iterable[Task], tell: Callable[[], None]) -> Iterator[tuple[Task, bytes]]:
        """Yields the tasks with their pickled results, in order. Calls `tell` for each finished plant.

        Takes only a bounded number of `tasks` ahead. Raises the job's errors at the plant's turn, and MachineError if a
        worker dies. May be called again: results of an earlier run that was left before its end are dropped.
        """
        first = next(self._numbers)
        source = zip(self._numbers, tasks)
        due: deque[tuple[int, Task]] = deque()
        answers: dict[int, _Answer] = {}
        while True:
            self._give(source, due)
            if not due:
                return
            number, task = due[0]
            for answer in self._receive(may_wait=number not in answers):
                if answer[0] > first:
                    answers[answer[0]] = answer
                    tell()
            if number in answers:
                self._give(source, due)
                due.popleft()
                yield task, result_of(*answers.pop(number)[1:])

    def stop(self) -> None:
        """Ends all workers, also in the middle of a plant. Returns when they have ended, within about half a second."""
        for worker in self._workers:
            worker.dismiss()
        deadline = time.monotonic() + 2 * _GRACE
        for worker in self._workers:
            worker.end_until(deadline)
        self._workers.clear()

    def _give(self, source: Iterator[tuple[int, Task]], due: deque[tuple[int, Task]]) -> None:
        """Sends tasks to the workers with the fewest tasks, until all are busy or enough plants are ahead."""
        while len(due) < _AHEAD * len(self._workers):
            worker = min(self._workers, key=lambda worker: len(worker.tasks))
            if len(worker.tasks) == _GIVEN:
                return
            item = next(source, None)
            if item is None:
                return
            due.append(item)
            worker.give(*item)

    def _receive(self, may_wait: bool) -> Iterator[_Answer]:
        """Returns the answers that have arrived. With `may_wait`, waits for at least one."""
        connections = {worker.connection: worker for worker in self._workers}
        for connection in wait(list(connections), None if may_wait else 0):
            yield connections[connection].take()  # type: ignore[index]


@contextmanager
def _interrupts_deferred() -> Iterator[None]:
    """Defers Ctrl-C during the block, here and in a server of workers that starts in it; see _server.py."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    ensure_running()  # a server of workers would start this tracker, which unblocks interrupts when it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Worker:
    """A worker process, seen from the calling process."""

    def __init__(self, connection: Connection, process: BaseProcess) -> None:
        self.connection = connection
        self.process = process
        self.tasks: deque[Task] = deque()  #: tasks without an answer; the worker runs the first of them

    def give(self, number: int, task: Task) -> None:
        self.tasks.append(task)
        try:
            self.connection.send((number, task))
        except OSError:
            pass  # the worker has died; take() reports this after its last answers

    def take(self) -> _Answer:
        try:
            answer: _Answer = self.connection.recv()
        except (EOFError, OSError):
            raise self._death() from None
        self.tasks.popleft()
        return answer

    def dismiss(self) -> None:
        try:
            self.connection.send(None)  # a copy of this end in a forked process would keep the pipe open
        except OSError:
            pass  # it has died already
        self.connection.close()

    def end_until(self, deadline: float) -> None:
        if self.process.pid is None:
            return  # it never started
        self.process.join(max(0.0, deadline - time.monotonic()))
        if self.process.is_alive():
            self.process.kill()
            self.process.join()

    def _death(self) -> Exception:
        self.process.join(_GRACE)
        code = self.process.exitcode
        if code == _UNGUARDED:
            return RuntimeError(
                "every worker of a batch imports the program, and this one would start a batch there as well; put "
                "what it does under:\n\n    if __name__ == '__main__':\n"
            )
        how = f"was killed by signal {-code}" if code is not None and code < 0 else f"ended with exit code {code}"
        hint = "; memory may have run out: fewer processes need less" if code == -9 else ""
        where = f" at {self.tasks[0]}" if self.tasks else ""
        return MachineError(f"a worker process of the batch {how}{where}{hint}")


def result_of(result: bytes | None, failure: bytes | None) -> bytes:
    """Returns the pickled result. For a pickled failure, raises its error with its traceback in the worker."""
    if result is not None:
        return result
    assert failure is not None
    error, text = pickle.loads(failure)
    raise error from _InWorker(text)


class _InWorker(Exception):
    """Shows the traceback of an error in a worker."""

    def __init__(self, text: str) -> None:
        super().__init__(text)

    def __str__(self) -> str:
        return f'\n"""\n{self.args[0]}"""'


# In the worker


def refuse_unguarded_program() -> None:
    """Ends a worker that imports a program which starts a batch when it is imported.

    Ends without a message. The exit code informs the calling process, which raises one error for all workers.
    """
    if multiprocessing.current_process().name == _NAME and not _has_begun:
        sys.stdout.flush()
        os._exit(_UNGUARDED)


_has_begun = False


def _work(connection: Connection, job_bytes: bytes) -> None:
    """Runs a worker: one task after the other until the pipe is closed."""
    global _has_begun
    _has_begun = True
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all processes; the calling process ends the others
    progress = Progress()
    tasks: queue.SimpleQueue[tuple[int, Task] | None] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(connection, tasks, progress), daemon=True).start()
    job: Job | None = None
    while (item := tasks.get()) is not None:
        number, task = item
        try:
            # Loaded here, so that an unreadable document or function is reported as an error.
            job = job or load_job(job_bytes)
            answer: _Answer = (number, job.run(task, progress), None)
        except Exception as error:
            answer = (number, None, pickle_failure(error))
        try:
            connection.send(answer)
        except OSError:
            return


def _listen(connection: Connection, tasks: queue.SimpleQueue[tuple[int, Task] | None], progress: Progress) -> None:
    """Passes tasks on. At the end it cancels the growth, and exits if a function of the plant still runs."""
    try:
        while (item := connection.recv()) is not None:
            tasks.put(item)
    except (EOFError, OSError):
        pass
    tasks.put(None)
    progress.cancel()
    time.sleep(_GRACE)
    os._exit(1)


def load_job(job: bytes) -> Job:
    """Returns the job. Raises TypeError if this process cannot import the job's function."""
    try:
        loaded: Job = pickle.loads(job)
    except (AttributeError, ImportError) as error:
        raise TypeError(f"a worker cannot import the function ({error}); define it at the top of a module") from error
    return loaded


def pickle_failure(error: Exception) -> bytes:
    """Pickles an error with its traceback as text, for result_of()."""
    text = "".join(traceback.format_exception(type(error), error, error.__traceback__))
    try:
        failure = pickle.dumps((error, text))
        pickle.loads(failure)  # some errors can be pickled but not unpickled
    except Exception:
        in_words = RuntimeError(f"{type(error).__name__}: {error}")
        for note in getattr(error, "__notes__", []):
            add_note(in_words, note)
        failure = pickle.dumps((in_words, text))
    return failure

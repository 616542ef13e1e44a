# SPDX-License-Identifier: Apache-2.0
"""Worker processes that grow the plants of a batch, and end with it.

Each worker has one pipe to the process that asks: tasks come in, pickled results go out, and once the other end is
closed, whether by stop() or because that process has died, the worker cancels what it grows and exits. So nothing has
to be polled, no thread runs on the asking side, and no worker outlives it.

The pools of the standard library were not taken: their workers finish a plant once begun however long it takes, and
they do not tell which task a killed worker had.
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
_UNGUARDED = 97  #: a worker's exit code, where the program would start a batch in each worker in turn
_GIVEN = 2  #: tasks that a worker has at most: the one it grows, and the next, so that it never waits for one
_AHEAD = 4  #: plants a worker that may be grown ahead of the one that is due
_GRACE = 0.3  #: seconds that a function of the plant may go on after the end

#: Number of the task, pickled result, pickled failure
_Answer = Tuple[int, Optional[bytes], Optional[bytes]]


class Pool:
    """Processes that run one Job for many tasks."""

    def __init__(self, job: bytes, count: int) -> None:
        """Starts `count` processes. `job` is a pickled Job."""
        self._workers: list[_Worker] = []
        self._numbers = itertools.count()  #: of tasks, over all runs
        # Not "fork": a forked child has the locks of the library's threads as they were, but not the threads.
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
                    theirs.close()  # so that our end tells when the worker has died
        except BaseException:
            self.stop()
            raise

    def run(self, tasks: Iterable[Task], tell: Callable[[], None]) -> Iterator[tuple[Task, bytes]]:
        """The tasks with their pickled results, in order. Calls `tell` whenever a plant is done.

        Takes from `tasks` only as many as are grown ahead. Raises what the job raises, at the plant's turn, and
        MachineError where a worker dies. May be called again; what an earlier run that was left before its end has
        given to the workers is dropped.
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
        """Ends all workers, also in the midst of a plant; returns once they have, within half a second or so."""
        for worker in self._workers:
            worker.dismiss()
        deadline = time.monotonic() + 2 * _GRACE
        for worker in self._workers:
            worker.end_until(deadline)
        self._workers.clear()

    def _give(self, source: Iterator[tuple[int, Task]], due: deque[tuple[int, Task]]) -> None:
        """Gives tasks to the workers that have the fewest, until all are busy or enough is ahead."""
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
        """The answers that have come; with `may_wait` at least one."""
        connections = {worker.connection: worker for worker in self._workers}
        for connection in wait(list(connections), None if may_wait else 0):
            yield connections[connection].take()  # type: ignore[index]


@contextmanager
def _interrupts_deferred() -> Iterator[None]:
    """Has Ctrl-C wait meanwhile, here and in a server of workers that is started; see _server.py."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    ensure_running()  # a server starts with it, and it lets interrupts through when it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Worker:
    """A worker process as the asking process sees it."""

    def __init__(self, connection: Connection, process: BaseProcess) -> None:
        self.connection = connection
        self.process = process
        self.tasks: deque[Task] = deque()  #: given and not yet answered; it has the first in hand

    def give(self, number: int, task: Task) -> None:
        self.tasks.append(task)
        try:
            self.connection.send((number, task))
        except OSError:
            pass  # it has died; take() tells that, after the answers that it has still given

    def take(self) -> _Answer:
        try:
            answer: _Answer = self.connection.recv()
        except (EOFError, OSError):
            raise self._death() from None
        self.tasks.popleft()
        return answer

    def dismiss(self) -> None:
        try:
            self.connection.send(None)  # a copy of our end in a forked process would keep the pipe open
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
    """The pickled result. Raises the error of a pickled failure instead, with where it was raised in the worker."""
    if result is not None:
        return result
    assert failure is not None
    error, text = pickle.loads(failure)
    raise error from _InWorker(text)


class _InWorker(Exception):
    """Shows where in a worker an error was raised."""

    def __init__(self, text: str) -> None:
        super().__init__(text)

    def __str__(self) -> str:
        return f'\n"""\n{self.args[0]}"""'


# In the worker


def refuse_unguarded_program() -> None:
    """Ends a worker that imports a program which starts a batch when it is imported.

    Quietly, as its exit code tells the asking process, which raises one error in place of each worker's.
    """
    if multiprocessing.current_process().name == _NAME and not _has_begun:
        sys.stdout.flush()
        os._exit(_UNGUARDED)


_has_begun = False


def _work(connection: Connection, job_bytes: bytes) -> None:
    """What a worker does: one task after the other until the pipe is closed."""
    global _has_begun
    _has_begun = True
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all processes; the asking one ends the others
    progress = Progress()
    tasks: queue.SimpleQueue[tuple[int, Task] | None] = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(connection, tasks, progress), daemon=True).start()
    job: Job | None = None
    while (item := tasks.get()) is not None:
        number, task = item
        try:
            # Here and not before, so that a document or function that cannot be read is told as an error.
            job = job or load_job(job_bytes)
            answer: _Answer = (number, job.run(task, progress), None)
        except Exception as error:
            answer = (number, None, pickle_failure(error))
        try:
            connection.send(answer)
        except OSError:
            return


def _listen(connection: Connection, tasks: queue.SimpleQueue[tuple[int, Task] | None], progress: Progress) -> None:
    """Passes tasks on; at the end cancels what grows, and exits if a function of the plant goes on."""
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
    """The job. Raises TypeError where it is of a function that this process cannot import."""
    try:
        loaded: Job = pickle.loads(job)
    except (AttributeError, ImportError) as error:
        raise TypeError(f"a worker cannot import the function ({error}); define it at the top of a module") from error
    return loaded


def pickle_failure(error: Exception) -> bytes:
    """An error with its traceback in words, as result_of() raises it."""
    text = "".join(traceback.format_exception(type(error), error, error.__traceback__))
    try:
        failure = pickle.dumps((error, text))
        pickle.loads(failure)  # some errors can be written but not read
    except Exception:
        in_words = RuntimeError(f"{type(error).__name__}: {error}")
        for note in getattr(error, "__notes__", []):
            add_note(in_words, note)
        failure = pickle.dumps((in_words, text))
    return failure

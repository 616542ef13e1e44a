# SPDX-License-Identifier: Apache-2.0
"""Whole programs that grow batches: stopped by Ctrl-C, killed, written without a guard."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import meristem
import pytest

if not hasattr(os, "killpg"):
    pytest.skip("needs process groups", allow_module_level=True)

# A batch whose plants would take hours after the first one. It prints the processes that grow them.
ENDLESS = """
import multiprocessing, os, time
import meristem

def first_then_never(plant):
    while {wait} and plant.document.seed > 0:
        time.sleep(1)
    return 0

if __name__ == "__main__":
    long = {{"tree.points": 1000000, "tree.step": 0.001}}
    quick = {{"tree.points": 20, "tree.step": 0.2}}
    samples = [quick] + [quick if {wait} else long] * 50
    results = meristem.batch(meristem.read("oak"), samples=samples, seeds=[{seeds}], measure=first_then_never,
                             processes=2)
    next(results)
    print(*[process.pid for process in multiprocessing.active_children()], flush=True)
    {then}
"""


def write_program(folder: Path, then: str, wait: bool = False) -> Path:
    program = folder / "program.py"
    program.write_text(ENDLESS.format(then=then, wait=wait, seeds="0, 1" if wait else "0"))
    return program


def start(program: Path) -> tuple[subprocess.Popen[str], list[int]]:
    """Starts the program and returns it with its workers after they have begun to grow."""
    process = subprocess.Popen(
        [sys.executable, "-B", str(program)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": str(Path(meristem.__file__).parents[1])},
    )
    assert process.stdout is not None
    workers = [int(word) for word in process.stdout.readline().split()]
    assert len(workers) == 2, process.communicate()
    return process, workers


def is_running(pid: int) -> bool:
    try:
        os.kill(pid, 0)
        state = Path(f"/proc/{pid}/stat")
        return not state.exists() or state.read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (ProcessLookupError, FileNotFoundError):
        return False


def wait_until_ended(pids: list[int]) -> None:
    """Waits until none of the processes runs. This takes half a second, or fails after 30 seconds."""
    deadline = time.monotonic() + 30
    while any(is_running(pid) for pid in pids):
        assert time.monotonic() < deadline, "workers outlive their batch"
        time.sleep(0.02)


@pytest.mark.parametrize("wait", [False, True])
def test_ctrl_c_ends_the_program_and_its_workers_with_one_traceback(tmp_path: Path, wait: bool) -> None:
    process, workers = start(write_program(tmp_path, "next(results)", wait))
    os.killpg(process.pid, signal.SIGINT)  # like a terminal: to all processes
    _, errors = process.communicate(timeout=60)
    assert process.returncode == -signal.SIGINT
    assert errors.count("Traceback") == 1
    assert errors.rstrip().endswith("KeyboardInterrupt")
    wait_until_ended(workers)


# Interrupts a server of workers at its start, as Ctrl-C in a terminal would. Python runs this before everything else.
INTERRUPTED = """
import os, signal, sys
if any("multiprocessing.forkserver" in word for word in sys.orig_argv):
    open("interrupted", "w").close()
    os.kill(os.getpid(), signal.SIGINT)
"""


@pytest.mark.skipif("forkserver" not in multiprocessing.get_all_start_methods(), reason="needs a server of workers")
@pytest.mark.skipif(sys.version_info < (3, 10), reason="needs sys.orig_argv")
def test_ctrl_c_while_workers_start_is_left_to_the_program(tmp_path: Path) -> None:
    (tmp_path / "sitecustomize.py").write_text(INTERRUPTED)
    (tmp_path / "program.py").write_text(GUARDED)
    ended = run(["program.py"], tmp_path, path=[tmp_path])
    assert (ended.stdout, ended.stderr) == ("True 10\n", "")
    assert (tmp_path / "interrupted").exists()


@pytest.mark.parametrize("wait", [False, True])
def test_workers_do_not_outlive_a_killed_program(tmp_path: Path, wait: bool) -> None:
    process, workers = start(write_program(tmp_path, "next(results)", wait))
    process.kill()
    process.communicate(timeout=60)
    wait_until_ended(workers)


def test_an_error_beside_a_batch_that_is_kept_ends_its_workers(tmp_path: Path) -> None:
    process, workers = start(write_program(tmp_path, "raise SystemExit('enough')"))
    _, errors = process.communicate(timeout=60)
    assert errors == "enough\n"
    wait_until_ended(workers)


def run(
    arguments: list[str], folder: Path, text: str = "", path: Sequence[Path] = ()
) -> subprocess.CompletedProcess[str]:
    """Runs Python. `text` is the standard input; `path` is an additional folder of modules."""
    return subprocess.run(
        [sys.executable, "-B", *arguments],
        cwd=folder,
        input=text,
        capture_output=True,
        text=True,
        timeout=60,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, [*path, Path(meristem.__file__).parents[1]]))},
    )


UNGUARDED = """
import meristem
print(len(meristem.collect(meristem.batch(meristem.read("oak", set={"age": 8}), measure="nodes", processes=2))))
"""


# Prints whether functions of workers can still be interrupted, and the number of plants.
GUARDED = """
import multiprocessing, signal
import meristem

def is_interruptible(_):
    return signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, [])

if __name__ == "__main__":
    bush = meristem.read("bush")
    count = len(meristem.collect(meristem.batch(bush, measure="nodes", processes=2)))
    with multiprocessing.get_context("forkserver").Pool(1) as pool:
        print(pool.map(is_interruptible, [0])[0], count)
"""


def test_a_program_without_a_guard_is_told_what_it_lacks(tmp_path: Path) -> None:
    (tmp_path / "unguarded.py").write_text(UNGUARDED)
    ended = run(["unguarded.py"], tmp_path)
    assert ended.returncode == 1
    assert ended.stderr.count("Traceback") == 1
    assert "put what it does under:\n\n    if __name__ == '__main__':" in ended.stderr


def test_a_session_without_a_file_grows_batches_of_measures(tmp_path: Path) -> None:
    ended = run(["-c", UNGUARDED], tmp_path)
    assert (ended.stdout, ended.stderr) == ("10\n", "")


def test_a_session_without_a_file_is_told_that_its_functions_cannot_be_imported(tmp_path: Path) -> None:
    ended = run(["-c", "def height(plant): return 1\n" + UNGUARDED.replace('"nodes"', "height")], tmp_path)
    assert "TypeError: a worker cannot import height, because this session is not a file" in ended.stderr


def test_a_program_from_standard_input_is_told_to_be_a_file(tmp_path: Path) -> None:
    ended = run(["-"], tmp_path, UNGUARDED)
    assert "RuntimeError: workers cannot read a program from standard input" in ended.stderr

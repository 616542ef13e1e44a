# SPDX-License-Identifier: Apache-2.0
"""Data sets whose workers and programs are killed by their process ids, and that are then continued."""

from __future__ import annotations

import contextlib
import os
import signal
import time
from pathlib import Path

import meristem
import pytest

from datasets import digest, plan, python, rod, rows_there

PLANTS = 400

PROGRAM = """
import multiprocessing, sys
from concurrent.futures import ProcessPoolExecutor
from datasets import plan, rod
import meristem

def tell(done, total):
    if done > 0:
        print(*[process.pid for process in multiprocessing.active_children()], flush=True)

if __name__ == "__main__":
    if sys.argv[2] == "own":
        meristem.dataset(rod(), plan({plants}), sys.argv[1], processes=2, progress=tell)
    else:
        with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("forkserver")) as executor:
            meristem.dataset(rod(), plan({plants}), sys.argv[1], executor=executor, progress=tell)
"""


@pytest.mark.parametrize("engine", ["own", "executor"])
def test_a_killed_worker_and_a_killed_program_lose_nothing(tmp_path: Path, engine: str) -> None:
    program = tmp_path / "program.py"
    program.write_text(PROGRAM.format(plants=PLANTS))
    folder = tmp_path / "rods"

    # A worker is killed: the program ends with an error message.
    process = python(str(program), str(folder), engine, folder=tmp_path)
    assert process.stdout is not None
    worker = int(process.stdout.readline().split()[0])
    os.kill(worker, signal.SIGKILL)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 1 and "MachineError" in errors, errors
    there = rows_there(folder)
    assert 0 < there < PLANTS

    # Later, the program itself is killed.
    process = python(str(program), str(folder), engine, folder=tmp_path)
    assert process.stdout is not None
    deadline = time.monotonic() + 60
    workers: set[int] = set()
    while process.poll() is None and rows_there(folder) < min(PLANTS - 20, there + 60):
        assert time.monotonic() < deadline
        workers.update(map(int, process.stdout.readline().split()))
    process.kill()
    for left in workers:  # workers of the standard library's pool do not end on their own
        with contextlib.suppress(ProcessLookupError):
            os.kill(left, signal.SIGKILL)
    process.communicate(timeout=60)

    # After a restart, the result equals an undisturbed run.
    made = meristem.dataset(rod(), plan(PLANTS), folder, processes=1)
    assert made.found >= there and made.verify() == []
    meristem.dataset(rod(), plan(PLANTS), tmp_path / "whole", processes=1)
    assert digest(folder) == digest(tmp_path / "whole")


def test_two_programs_do_not_make_one_data_set(tmp_path: Path) -> None:
    read = meristem.DatasetPlan({"meristem_dataset": 1, **plan(3)}, documents={"rod": rod()})
    holder = python(
        "-c",
        "import meristem; from datasets import plan, rod;"
        "read = meristem.DatasetPlan({'meristem_dataset': 1, **plan(3)}, documents={'rod': rod()});"
        "held = meristem.DatasetFolder(read, 'rods'); print('open', flush=True); import time; time.sleep(60)",
        folder=tmp_path,
    )
    assert holder.stdout is not None and holder.stdout.readline() == "open\n"
    with pytest.raises(meristem.MachineError, match="another program"):
        meristem.DatasetFolder(read, tmp_path / "rods")
    holder.kill()
    holder.communicate(timeout=60)
    assert meristem.DatasetFolder(read, tmp_path / "rods").done == 0

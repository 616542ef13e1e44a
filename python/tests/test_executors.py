# SPDX-License-Identifier: Apache-2.0
"""Batches and data sets on executors: the standard library's, Dask's and mpi4py's."""

from __future__ import annotations

import multiprocessing
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import meristem
import pytest

from datasets import digest, plan, rod

PLANTS = 120


def node_count(plant: meristem.Plant) -> int:
    return len(plant.stems[0].skeleton.position)


def fails_at_seven(plant: meristem.Plant) -> int:
    if plant.document.seed == 7:
        raise ValueError("seven")
    return plant.document.seed


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("reference") / "rods"
    meristem.dataset(rod(), plan(PLANTS), folder, processes=1)
    return digest(folder)


def processes(count: int = 2) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(count, mp_context=multiprocessing.get_context("forkserver"))


@pytest.fixture(scope="module")
def dask_executor() -> Iterator[Executor]:
    distributed = pytest.importorskip("distributed", reason="python3-distributed is not installed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        yield client.get_executor()


def test_a_batch_is_the_same_on_an_executor() -> None:
    here = [one.result for one in meristem.batch(rod(), seeds=range(40), measure="height", processes=1)]
    told: list[int] = []
    with ThreadPoolExecutor(2) as executor:
        there = meristem.batch(
            rod(), seeds=range(40), measure="height", executor=executor, progress=lambda done, _: told.append(done)
        )
        assert [one.result for one in there] == here
    assert told == list(range(1, 41))


def test_a_data_set_is_the_same_on_processes(tmp_path: Path, reference: str) -> None:
    with processes() as executor:
        meristem.dataset(rod(), plan(PLANTS), tmp_path / "rods", executor=executor)
    assert digest(tmp_path / "rods") == reference


def test_a_data_set_is_the_same_on_dask(tmp_path: Path, reference: str, dask_executor: Executor) -> None:
    meristem.dataset(rod(), plan(PLANTS), tmp_path / "rods", executor=dask_executor)
    assert digest(tmp_path / "rods") == reference
    counts = [one.result for one in meristem.batch(rod(), seeds=range(9), measure=node_count, executor=dask_executor)]
    assert counts == [5] * 9


MPI = """
import sys
from datasets import plan, rod
from mpi4py.futures import MPICommExecutor
import meristem

if __name__ == "__main__":
    with MPICommExecutor() as executor:
        if executor is not None:
            meristem.dataset(rod(), plan(int(sys.argv[2])), sys.argv[1], executor=executor)
"""


def test_a_data_set_is_the_same_on_mpi(tmp_path: Path, reference: str) -> None:
    pytest.importorskip("mpi4py", reason="python3-mpi4py is not installed")
    if shutil.which("mpiexec") is None:
        pytest.skip("openmpi-bin is not installed")
    program = tmp_path / "program.py"
    program.write_text(MPI)
    path = os.pathsep.join([str(Path(meristem.__file__).parents[1]), str(Path(__file__).parent)])
    root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"} if os.geteuid() == 0 else {}
    ended = subprocess.run(
        ["mpiexec", "--oversubscribe", "-n", "2", sys.executable, "-B", str(program), str(tmp_path / "rods"), str(PLANTS)],
        env={**os.environ, **root, "PYTHONPATH": path, "OMPI_MCA_btl_vader_single_copy_mechanism": "none"},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert ended.returncode == 0, ended.stderr
    assert digest(tmp_path / "rods") == reference


class Apart(Executor):
    """Runs tasks in workers that cannot see the folder, because it has another name there."""

    def submit(self, function: Any, key: str, job: bytes | None, tasks: list[Any]) -> Future[Any]:  # type: ignore[override]
        future: Future[Any] = Future()
        hidden = job.replace(b"/rods", b"/sdor") if job is not None else None
        future.set_result(function(key, hidden, tasks))
        return future


def test_workers_that_do_not_see_the_folder_send_what_they_made(tmp_path: Path, reference: str) -> None:
    meristem.dataset(rod(), plan(PLANTS), tmp_path / "rods", executor=Apart())
    assert digest(tmp_path / "rods") == reference


class Counting(ThreadPoolExecutor):
    """Counts pending tasks, and records which tasks carry the job."""

    most = 0
    now = 0
    with_job = 0

    def submit(self, function: Any, key: str, job: bytes | None, tasks: list[Any]) -> Future[Any]:  # type: ignore[override]
        self.now += 1
        self.with_job += job is not None
        self.most = max(self.most, self.now)
        future = super().submit(function, key, job, tasks)
        future.add_done_callback(lambda _: setattr(self, "now", self.now - 1))
        return future


def test_few_chunks_are_under_way_and_endless_seeds_end() -> None:
    import itertools

    with Counting(2) as executor:
        for one in meristem.batch(rod(), seeds=itertools.count(), measure="height", executor=executor):
            if one.seed == 60:
                break
    assert executor.most <= 6


def test_a_large_job_travels_only_where_it_is_missing(tmp_path: Path) -> None:
    large = meristem.Document({**rod().to_dict(), "description": "long " * 20_000})
    with Counting(1) as executor:
        batch = meristem.batch(large, seeds=range(30), measure="height", executor=executor)
        assert len(list(batch)) == 30
    assert 1 <= executor.with_job <= 3  # including tasks submitted before the worker had the job


def test_an_error_of_the_function_comes_at_its_plant() -> None:
    with ThreadPoolExecutor(2) as executor:
        results = meristem.batch(rod(), seeds=range(20), measure=fails_at_seven, executor=executor)
        assert [next(results).seed for _ in range(7)] == list(range(7))
        with pytest.raises(ValueError, match="seven") as caught:
            next(results)
    assert "seed 7" in caught.value.__notes__[0]


class Broken(Executor):
    def submit(self, function: Any, /, *arguments: Any, **more: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_exception(RuntimeError("the cluster is gone"))
        return future


def test_a_failure_of_the_engine_is_the_machines() -> None:
    with pytest.raises(meristem.MachineError, match="seed 3.*the cluster is gone"):
        list(meristem.batch(rod(), seeds=[3], measure="height", executor=Broken()))
    with pytest.raises(ValueError, match="processes or executor"):
        meristem.batch(rod(), executor=Broken(), processes=2)

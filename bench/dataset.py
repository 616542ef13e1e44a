#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures data sets of many plants: equal bytes on all engines, costs of engines, memory, continued runs, and killed
workers.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/dataset.py [PART...]

The parts are digests, ratio, overhead, memory, resume, killed and oaks; all of them by default. The last part prints
the cost of an oak for each kind of file, for the manual. Each plant of digests, memory, resume and killed is a sapling
of about a millisecond. The parts ratio and overhead use trees of about 20 ms; their number of points is chosen for this
machine. The lines of the table are written to the file named by MERISTEM_BENCH_TABLE. MERISTEM_BENCH=small runs
everything in tiny sizes. Engines that are not installed are left out, with a message.
"""

from __future__ import annotations

import hashlib
import multiprocessing
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import meristem

SMALL = os.environ.get("MERISTEM_BENCH") == "small"
SAPLING: dict[str, Any] = {
    "meristem": 1,
    "name": "Sapling",
    "variables": {"tall": {"value": 1, "min": 0.5, "max": 2}},
    "components": {
        "stem": {"type": "tree", "length": "tall", "radius": 0.02, "segments": 8},
        "leaf": {"type": "leaf", "length": 0.1, "width": 0.05},
    },
    "links": [{"from": "stem", "to": "leaf", "kind": "branch", "density": 12}],
}

figures: list[list[str]] = []


def tell(figure: str, value: str, asked: str = "", held: bool | None = None, reference: str = "", ratio: str = "") -> None:
    mark = "" if held is None else "held" if held else "not held"
    figures.append([f"dataset {figure}", value, reference, ratio, asked, mark])
    print(f"{figure}: {value}{', asked ' + asked if asked else ''}{' (' + mark + ')' if mark else ''}", flush=True)


def sapling_plan(plants: int) -> dict[str, Any]:
    return {
        "seeds": plants,
        "files": [".csv"],
        "measures": ["height", "nodes", "leaf_area"],
        "vary": {"tall": {"normal": [1, 0.3]}},
    }


def tree(points: int) -> meristem.Document:
    grown = {"type": "colonize", "points": points, "crown": {"profile": [[0, 0.6], [0.6, 1.6], [0, 3]]}}
    return meristem.Document({"meristem": 1, "name": "Tree", "components": {"tree": grown}})


def tree_plan(plants: int) -> dict[str, Any]:
    return {"seeds": plants, "files": [".csv"], "measures": ["height"]}


def digest(folder: Path) -> str:
    all_files = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        below = path.relative_to(folder)
        if path.is_file() and below.parts[0] != "partial":
            all_files.update(f"{below}\n".encode())
            all_files.update(path.read_bytes())
    return all_files.hexdigest()


@contextmanager
def process_pool(workers: int) -> Iterator[Executor]:
    with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("forkserver")) as executor:
        yield executor


@contextmanager
def dask(workers: int) -> Iterator[Executor]:
    import distributed

    with distributed.LocalCluster(
        n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        yield client.get_executor()


def warm(executor: Executor) -> None:
    """Makes every worker import the module, so that only the tasks are measured."""
    for _ in meristem.batch(meristem.Document(SAPLING), seeds=range(40), measure="height", executor=executor):
        pass


def timed(body: Callable[[], object]) -> float:
    begin = time.perf_counter()
    body()
    return time.perf_counter() - begin


MPI = """
import sys
from mpi4py.futures import MPICommExecutor
sys.path.insert(0, {bench!r})
import dataset, meristem

if __name__ == "__main__":
    with MPICommExecutor() as executor:
        if executor is not None:
            document = meristem.Document(dataset.SAPLING)
            meristem.dataset(document, dataset.sapling_plan({plants}), sys.argv[1], executor=executor)
"""


def on_mpi(plants: int, folder: Path, scratch: Path) -> None:
    program = scratch / "mpi.py"
    program.write_text(MPI.format(bench=str(Path(__file__).parent), plants=plants))
    root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"} if os.geteuid() == 0 else {}
    subprocess.run(
        ["mpiexec", "--oversubscribe", "-n", "2", sys.executable, "-B", str(program), str(folder)],
        env={**os.environ, **root, "OMPI_MCA_btl_vader_single_copy_mechanism": "none"},
        check=True,
    )


def digests(scratch: Path) -> None:
    plants = 40 if SMALL else 2000
    document = meristem.Document(SAPLING)
    plan = sapling_plan(plants)
    meristem.dataset(document, plan, scratch / "here", processes=1)
    expected = digest(scratch / "here")

    def own() -> None:
        meristem.dataset(document, plan, scratch / "own", processes=2)

    def on(engine: Any, name: str) -> None:
        with engine(2) as executor:
            meristem.dataset(document, plan, scratch / name, executor=executor)

    ways: dict[str, Callable[[], None]] = {
        "own": own,
        "processes": lambda: on(process_pool, "processes"),
        "dask": lambda: on(dask, "dask"),
        "mpi": lambda: on_mpi(plants, scratch / "mpi", scratch),
    }
    equal = 0
    for name, way in ways.items():
        try:
            seconds = timed(way)
        except (ImportError, FileNotFoundError) as error:
            print(f"{name} is left out: {error}")
            continue
        is_equal = digest(scratch / name) == expected
        equal += is_equal
        print(f"{plants} saplings on {name}: {seconds:.1f} s, {'the same bytes' if is_equal else 'OTHER BYTES'}")
    tell(f"equal digests of {plants} plants", str(equal), "4", equal == 4)


def points_for(seconds: float) -> int:
    """Returns the number of points of a tree that takes about this time on this machine."""
    points = 200
    while True:
        document = tree(points)
        each = min(timed(lambda: document.set(seed=seed).grow(threads=1).measure(threads=1)) for seed in range(3))
        if each >= seconds:
            return max(50, int(points * seconds / each))
        points *= 2


def ratio(scratch: Path) -> None:
    document = tree(50 if SMALL else points_for(0.02))
    plants = 20 if SMALL else 1000
    walls: dict[int, list[float]] = {1: [], 2: []}
    for turn in range(1 if SMALL else 3):
        for workers in (1, 2):
            with process_pool(workers) as executor:
                warm(executor)
                folder = scratch / f"ratio{workers}{turn}"
                walls[workers].append(
                    timed(lambda: meristem.dataset(document, tree_plan(plants), folder, executor=executor))
                )
    best = min(walls[1]) / min(walls[2])
    each = 1000 * min(walls[1]) / plants
    tell(f"two workers over one, {each:.0f} ms a plant", f"{best:.2f}", ">= 1.9", best >= 1.9)


def overhead(scratch: Path) -> None:
    document = tree(50 if SMALL else points_for(0.02))
    plants = 20 if SMALL else 500
    here = min(
        timed(lambda: meristem.dataset(document, tree_plan(plants), scratch / f"here{turn}", processes=1))
        for turn in range(1 if SMALL else 3)
    )
    for name, engine in {"processes": process_pool, "dask": dask}.items():
        try:
            with engine(1) as executor:
                warm(executor)
                walls = [
                    timed(lambda: meristem.dataset(document, tree_plan(plants), scratch / f"{name}{turn}", executor=executor))
                    for turn in range(1 if SMALL else 3)
                ]
        except ImportError as error:
            print(f"{name} is left out: {error}")
            continue
        more = min(walls) / here - 1
        tell(f"overhead of {name} at {1000 * here / plants:.0f} ms a plant", f"{100 * more:.1f} %", "< 5 %", more < 0.05)


def memory(scratch: Path) -> None:
    plants = 200 if SMALL else 100_000
    program = scratch / "memory.py"
    program.write_text(
        f"import sys, resource; sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
        "import dataset, meristem\n"
        "if __name__ == '__main__':\n"
        f"    meristem.dataset(meristem.Document(dataset.SAPLING), dataset.sapling_plan({plants}), sys.argv[1], processes=2)\n"
        "    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)\n"
    )
    begin = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-B", str(program), str(scratch / "many")], capture_output=True, text=True, check=True
    )
    seconds = time.perf_counter() - begin
    megabytes = int(done.stdout) / 1024
    tell(f"driver of {plants} plants", f"{megabytes:.0f} MB", "< 150 MB", megabytes < 150)
    print(f"{plants / seconds:.0f} plants a second on two processes, with their files")


def resume(scratch: Path) -> None:
    plants = 100 if SMALL else 10_000
    document, plan = meristem.Document(SAPLING), sapling_plan(plants)
    meristem.dataset(document, plan, scratch / "done", processes=2)
    seconds = timed(lambda: meristem.dataset(document, plan, scratch / "done", processes=2))
    tell(f"resume of {plants} plants that are there", f"{seconds:.2f} s", "< 2 s", seconds < 2)


KILLED = """
import multiprocessing, os, sys
sys.path.insert(0, {bench!r})
import dataset, meristem

def tell(done, total):
    print(done, *[process.pid for process in multiprocessing.active_children()], flush=True)

if __name__ == "__main__":
    document = meristem.Document(dataset.SAPLING)
    meristem.dataset(document, dataset.sapling_plan({plants}), sys.argv[1], processes=2, progress=tell)
"""


def killed(scratch: Path) -> None:
    plants = 100 if SMALL else 2000
    program = scratch / "killed.py"
    program.write_text(KILLED.format(bench=str(Path(__file__).parent), plants=plants))
    folder = scratch / "stopped"
    for victim, after in (("worker", plants // 4), ("driver", plants // 2)):
        process = subprocess.Popen(
            [sys.executable, "-B", str(program), str(folder)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        assert process.stdout is not None
        for line in process.stdout:
            done, *workers = map(int, line.split())
            if done >= after:
                os.kill(workers[0] if victim == "worker" else process.pid, signal.SIGKILL)
                break
        process.communicate()
        print(f"a {victim} was killed after {done} plants")
    document, plan = meristem.Document(SAPLING), sapling_plan(plants)
    made = meristem.dataset(document, plan, folder, processes=2)
    meristem.dataset(document, plan, scratch / "undisturbed", processes=2)
    same = digest(folder) == digest(scratch / "undisturbed")
    tell(f"killed twice, {made.found} of {plants} kept", "equal" if same else "different", "equal", same)


#: The files of each oak, as rows of the manual.
KEPT: dict[str, dict[str, Any]] = {
    "measures": {"measures": "all"},
    "skeleton as .csv and .mtg": {"files": [".csv", ".mtg"]},
    ".glb with textures, and measures": {"files": [".glb"], "measures": "all"},
    "depth, organs and COCO, 512 x 512": {
        "pictures": {"size": [512, 512], "colour": "none", "depth": "pfm", "organs": True, "coco": True}
    },
    "the same with a picture of 16 samples": {
        "pictures": {"size": [512, 512], "samples": 16, "depth": "pfm", "organs": True, "coco": True}
    },
}


def byte_count(size: float) -> str:
    for unit in ("B", "KB", "MB", "GB"):
        if size < 1000:
            return f"{size:.1f} {unit}"
        size /= 1000
    return f"{size:.1f} TB"


def oaks(scratch: Path) -> None:
    """Returns processor seconds and bytes per oak, including one reading of the document and one painting of its
    textures."""
    plants = 1 if SMALL else 8
    for number, (what, kept) in enumerate(KEPT.items()):
        if SMALL and number > 1:
            return
        folder = scratch / f"oaks{number}"
        begin = time.process_time()
        made = meristem.dataset("oak", {"seeds": plants, **kept}, folder, processes=1)
        seconds = (time.process_time() - begin) / plants
        kinds: dict[str, int] = {}
        for row in made.rows():
            for path, size in zip(row["files"].split(), map(int, row["bytes"].split())):
                ending = "." + path.rpartition("/")[2].partition(".")[2]
                kinds[ending] = kinds.get(ending, 0) + size
        tables = [path.read_bytes() for path in (folder / "manifest").iterdir()]
        kinds["row of the manifest"] = sum(len(table) - table.index(b"\n") - 1 for table in tables)
        sizes = ", ".join(f"{ending} {byte_count(size / plants)}" for ending, size in kinds.items())
        total = sum(kinds.values()) / plants
        print(
            f"{what}: {seconds:.2f} s, {byte_count(total)} per oak ({sizes}); a million: "
            f"{seconds * 1e6 / 100 / 3600:.1f} hours on 100 cores, {byte_count(total * 1e6)}",
            flush=True,
        )


PARTS = {
    "digests": digests,
    "ratio": ratio,
    "overhead": overhead,
    "memory": memory,
    "resume": resume,
    "killed": killed,
    "oaks": oaks,
}


def main() -> None:
    names = sys.argv[1:] or list(PARTS)
    for name in names:
        if name not in PARTS:
            raise SystemExit(f"no such part: {name}; there are {', '.join(PARTS)}")
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    for name in names:
        scratch = Path(tempfile.mkdtemp(prefix="meristem-bench-"))
        try:
            PARTS[name](scratch)
        finally:
            shutil.rmtree(scratch)
    print(f"peak memory of this process {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")
    table = os.environ.get("MERISTEM_BENCH_TABLE")
    if table and not SMALL:
        with open(table, "a", encoding="utf-8") as file:
            file.writelines("\t".join(line) + "\n" for line in figures)
    if any(line[5] == "not held" for line in figures) and not SMALL:
        raise SystemExit(1)


if __name__ == "__main__":
    main()

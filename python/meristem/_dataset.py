# SPDX-License-Identifier: Apache-2.0
"""Makes data sets of many plants on any executor, continues, checks and reads them."""

from __future__ import annotations

import csv
import importlib
import os
import pickle
import warnings
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Union

import numpy as np

from ._batch import check_processes
from ._core import DatasetFolder, DatasetPlan, Document, Progress, read, require_finished, verify_dataset
from ._job import add_note
from ._pool import refuse_unguarded_program
from ._progress import ProgressCallback, teller
from ._runner import Runner
from ._whole_file import whole_file

#: A Document or its name, several of these, or a dict of them by the names in the manifest.
Documents = Union[None, str, Document, Iterable[Union[str, Document]], Mapping[str, Union[str, Document]]]
Plan = Union[str, "os.PathLike[str]", Mapping[str, Any], DatasetPlan]

#: Columns of the manifest that describe files and are not numbers of plants.
_OF_FILES = ("files", "bytes", "hashes", "version")


@dataclass(frozen=True)
class _Range:
    """Plants that one worker makes, one after another."""

    begin: int
    end: int

    def __str__(self) -> str:
        return f"the plants {self.begin} to {self.end - 1}"


@dataclass(frozen=True)
class _Job:
    """The job for each range. It is sent with the contents of the plan and its documents."""

    plan: DatasetPlan
    folder: str

    def run(self, task: _Range, progress: Progress | None = None) -> bytes:
        try:
            return pickle.dumps(self.plan.make(self.folder, task.begin, task.end, progress=progress))
        except Exception as error:
            add_note(error, f"in the data set's {str(task)[4:]}")
            raise


@dataclass(frozen=True)
class Dataset:
    """A complete data set in a folder.

    dataset() and open_dataset() return it:

        plan = {"meristem_dataset": 1, "name": "Tulips", "seeds": 3, "files": [".mtg"], "measures": ["height"]}
        data = meristem.dataset("tulip", plan, "tulips", processes=1)
        print(data.plants, "plants, the highest", data.table()["height"].max(), "m")
    """

    folder: Path  #: folder of the manifest and of all files
    plants: int  #: number of all plants, including failed plants
    found: int  #: number of plants that existed before the call
    faults: tuple[str, ...]  #: faults that were found and repaired: one line each, the first hundred
    failed: int = 0  #: number of plants that have an error instead of files and measures
    failures: tuple[str, ...] = ()  #: key and error of failed plants: one line each, the first ten

    def rows(self) -> Iterator[dict[str, str]]:
        """Returns the rows of the manifest, in the order of the plants, as texts by column name."""
        return _rows_of(self.folder)

    def table(self) -> np.ndarray[Any, Any]:
        """Returns the values and measures as a structured array, a row for each plant.

        Columns of numbers are 64-bit floats, NaN if a plant has no value. All other columns are texts. Columns about
        files are left out.
        """
        return _table_of(self.folder, self.plants)

    def save_npz(self, path: str | os.PathLike[str]) -> None:
        """Writes the columns of table() as arrays of an .npz file, whole or not at all."""
        table = self.table()
        with whole_file(Path(path)) as partial, partial.open("wb") as file:
            np.savez_compressed(file, **{name: table[name] for name in table.dtype.names or ()})

    def save_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes the manifest with all columns as a Parquet file. Raises ImportError without pyarrow."""
        with whole_file(Path(path)) as partial:
            _write_parquet(self, partial)

    def verify(
        self, *, root: str | os.PathLike[str] = "", allow_old: bool = False, threads: int = 0
    ) -> list[str]:
        """Compares all files with the manifest, and the manifest with its hashes and the plan.

        Returns the faults, one line each. Tables of earlier versions of the program have no hashes and cannot be
        checked: this is a fault, or with `allow_old` a warning. With a `root`, no file outside this folder is read, as
        in verify_dataset.
        """
        check = verify_dataset(self.folder, root=root, allow_old=allow_old, threads=threads)
        for warning in check["warnings"]:
            warnings.warn(warning, stacklevel=2)
        faults: list[str] = check["faults"]
        return faults


def dataset(
    documents: Documents,
    plan: Plan,
    folder: str | os.PathLike[str],
    *,
    executor: Executor | None = None,
    processes: int | None = None,
    resume: bool = True,
    repair: bool = False,
    progress: ProgressCallback | bool | None = None,
) -> Dataset:
    """Makes or continues the data set of a plan in a folder, and returns it when all plants are made.

    `documents`, one or several, or a dict of them by name, replace the documents of the plan; None uses the plan's
    documents. `plan` is a dict, or the path of a JSON file. Correct plants in the folder are not made again. `repair`
    reads all files to check them; otherwise only existence and sizes of files are checked. With `resume=False`, a
    folder that holds a data set is refused.

    The plants grow on the `executor`, any object with the interface concurrent.futures.Executor, or else on `processes`
    (all cores if None). Workers that can reach the folder write into it. Files of other workers are sent back and
    written here. The bytes are equal in both cases. `progress` is called with the number of finished plants and the
    total. True prints them on standard error, with the remaining time.

    If a plant cannot grow with its values, its row has an error. A warning gives the number of failed plants, as do
    `failed` and `failures` of the result. Raises InputError if the plan is wrong or the folder holds something else,
    and MachineError if the disk or a worker fails. Finished plants are not lost: repeat the call to continue.
    """
    refuse_unguarded_program()
    count = check_processes(processes, executor)
    read_plan = _plan_of(documents, plan)
    opening = "repair" if repair else "resume" if resume else "fresh"
    target = DatasetFolder(read_plan, folder, opening=opening)
    tell = teller(progress, "plant")
    if target.done < len(target):
        _make(target, read_plan, count, executor, tell)
    target.finish()
    made = Dataset(
        Path(folder), len(target), target.found, tuple(target.faults), target.failed, tuple(target.failures)
    )
    is_new = target.found < len(target)
    if is_new or not (made.folder / "manifest.npz").exists():
        made.save_npz(made.folder / "manifest.npz")
        target.add_file("manifest.npz")
    if is_new or not (made.folder / "manifest.parquet").exists():
        try:
            made.save_parquet(made.folder / "manifest.parquet")
            target.add_file("manifest.parquet")
        except ImportError:
            pass  # the library is not installed
    if target.failed:
        warnings.warn(f"{made.folder}: {target.failed_text}", stacklevel=2)
    return made


def open_dataset(folder: str | os.PathLike[str]) -> Dataset:
    """Returns the data set in a folder, as dataset() does, without its plan.

    Raises InputError if the folder holds no data set, or if plants are missing; dataset() then continues it.
    """
    plants = 0
    failed = 0
    failures: list[str] = []
    for row in _rows_of(Path(folder)):
        plants += 1
        if row["error"]:
            failed += 1
            failures += [f"{row['key']}: {row['error']}"] if failed <= 10 else []
    require_finished(folder, plants)
    return Dataset(Path(folder), plants, plants, (), failed, tuple(failures))


def _make(
    target: DatasetFolder, plan: DatasetPlan, count: int, executor: Executor | None, tell: ProgressCallback | None
) -> None:
    job = _Job(plan, os.path.abspath(target.path))
    pickled = pickle.dumps(job) if executor is not None or count > 1 else None

    def ranges() -> Iterator[_Range]:
        while (following := target.next()) is not None:
            yield _Range(*following)

    with Runner(job, pickled, count, executor, chunks=False) as runner:
        for task, (seconds, apart) in runner.run(ranges(), lambda: None):
            target.add(task.begin, task.end, seconds, apart)
            if tell is not None:
                tell(target.done, len(target))


def _plan_of(documents: Documents, plan: Plan) -> DatasetPlan:
    if isinstance(plan, DatasetPlan):
        if documents is not None:
            raise TypeError("a DatasetPlan has its documents already: give None for them")
        return plan
    named = _named(documents)
    if isinstance(plan, Mapping):
        return DatasetPlan({"meristem_dataset": 1, **plan}, documents=named)
    if not isinstance(plan, (str, os.PathLike)):
        raise TypeError(f"plan must be a dict or the path of a file, not {type(plan).__name__}")
    path = os.fspath(plan)
    return DatasetPlan(Path(path).read_text(encoding="utf-8"), file=path, documents=named)


def _named(documents: Documents) -> dict[str, Document]:
    if documents is None:
        return {}
    if isinstance(documents, (str, Document)):
        documents = [documents]
    if isinstance(documents, Mapping):
        return {str(name): _document(one) for name, one in documents.items()}
    if not isinstance(documents, Iterable):
        raise TypeError(f"documents must be a Document, several, or a dict of them, not {type(documents).__name__}")
    named: dict[str, Document] = {}
    for one in documents:
        document = _document(one)
        name = Path(document.file).stem if document.file != "<python>" else document.name or "document"
        if name in named:
            raise ValueError(f"two documents are called {name!r}; give a dict of documents by their names")
        named[name] = document
    return named


def _document(one: object) -> Document:
    if isinstance(one, Document):
        return one
    if isinstance(one, (str, os.PathLike)):
        return read(one)
    raise TypeError(f"documents must be Document objects or names, not {type(one).__name__}")


def _rows_of(folder: Path) -> Iterator[dict[str, str]]:
    for path in sorted((folder / "manifest").glob("*.csv")):
        with path.open(newline="", encoding="utf-8") as file:
            yield from csv.DictReader(file)


def _number(field: str) -> float | None:
    try:
        return float(field)
    except ValueError:
        return None


def _table_of(folder: Path, plants: int) -> np.ndarray[Any, Any]:
    # The first pass finds which columns are numbers, and how long texts are; so the rows are never all in memory.
    widths: dict[str, int] = {}
    texts: set[str] = {"key", "document", "error"}
    for row in _rows_of(folder):
        for name, field in row.items():
            if name in _OF_FILES:
                continue
            widths[name] = max(widths.get(name, 1), len(field))
            if name not in texts and field and _number(field) is None:
                texts.add(name)
    types = [(name, f"U{width}" if name in texts else "f8") for name, width in widths.items()]
    table: np.ndarray[Any, Any] = np.empty(plants, dtype=types)
    for index, row in enumerate(_rows_of(folder)):
        table[index] = tuple(
            row[name] if name in texts else float(row[name]) if row[name] else float("nan") for name in widths
        )
    return table


def _write_parquet(made: Dataset, path: Path) -> None:
    pyarrow = importlib.import_module("pyarrow")
    parquet = importlib.import_module("pyarrow.parquet")

    table = made.table()
    columns = {name: table[name] for name in table.dtype.names or ()}
    of_files: list[dict[str, str]] = [{name: row[name] for name in _OF_FILES} for row in made.rows()]
    for name in _OF_FILES:
        columns[name] = [row[name] for row in of_files]
    parquet.write_table(pyarrow.table(columns), path)

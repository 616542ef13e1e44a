# SPDX-License-Identifier: Apache-2.0
"""Data sets of many plants: made on any executor, gone on with, checked, read."""

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

#: A Document or the name of one, several of them, or a dict of them by the names that the manifest has.
Documents = Union[None, str, Document, Iterable[Union[str, Document]], Mapping[str, Union[str, Document]]]
Plan = Union[str, "os.PathLike[str]", Mapping[str, Any], DatasetPlan]

#: Columns of the manifest that tell where things are, and are no numbers of plants.
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
    """What is done for each range. Travels with the plan and its documents by content."""

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
    """A data set in a folder, all plants made."""

    folder: Path
    plants: int  #: all, those that failed among them
    found: int  #: of them, plants that were there before
    faults: tuple[str, ...]  #: what was there and not right, and was made again: one line each, the first hundred
    failed: int = 0  #: plants that have an error in place of files and measures
    failures: tuple[str, ...] = ()  #: key and error of those plants: one line each, the first ten

    def rows(self) -> Iterator[dict[str, str]]:
        """The rows of the manifest, in the order of the plants, texts by the names of the columns."""
        return _rows_of(self.folder)

    def table(self) -> np.ndarray[Any, Any]:
        """The values and measures as a structured array, a row for each plant.

        Columns of numbers are 64-bit floats, NaN where a plant has none; others are texts. The columns that tell of
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

    def verify(self, *, root: str | os.PathLike[str] = "", threads: int = 0) -> list[str]:
        """Compares all files with the manifest, and the manifest with its hashes and the plan.

        Gives what is wrong, one line each. Warns of what cannot be checked, such as tables without a hash. With a
        `root`, no file outside that folder is read, as in verify_dataset.
        """
        check = verify_dataset(self.folder, root=root, threads=threads)
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
    """Makes the data set of a plan in a folder, or goes on with it, and gives it once all plants are there.

    `documents`, one or several, or a dict of them by name, take the place of those that the plan names; None leaves
    it to the plan. `plan` is a dict, or the path of a JSON file. What is in the folder and right is not made again:
    `repair` reads all of it to find out, else files must be there with their sizes. With `resume=False`, a folder that
    holds a data set is refused.

    The plants grow on the `executor`, whatever offers concurrent.futures.Executor, or else on `processes` (all cores if
    None). Workers write into the folder where they see it; else their files come back and are written here. The bytes
    are the same. `progress` is called with the number of plants done and that of all; True tells them on standard
    error, with the time left.

    A plant that its values do not allow is a row with its error. A warning tells how many plants have failed, as do
    `failed` and `failures` of the result. Raises InputError with what is wrong with the plan or
    where the folder holds something else, MachineError where the disk or a worker fails. Nothing that was made is lost
    then: the same call goes on.
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
            pass  # there is no library for it
    if target.failed:
        warnings.warn(f"{made.folder}: {target.failed_text}", stacklevel=2)
    return made


def open_dataset(folder: str | os.PathLike[str]) -> Dataset:
    """The data set in a folder, as dataset() gives it, without its plan.

    Raises InputError where there is none, or where plants are still missing: then dataset() goes on with it.
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

# SPDX-License-Identifier: Apache-2.0
"""One plant of a batch: grows it on one thread and computes its result."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Union

from ._core import LIGHT_MEASURES, Document, Plant, Progress
from ._errors import InputError

#: Names of measures; None for all that need no light on leaves; or a function of the plant.
Measure = Union[None, "tuple[str, ...]", Callable[[Plant], Any]]


@dataclass(frozen=True)
class Task:
    """A plant of a batch."""

    seed: int
    values: Mapping[str, Any]

    def __str__(self) -> str:
        return f"seed {self.seed} with {dict(self.values)}" if self.values else f"seed {self.seed}"


@dataclass(frozen=True)
class Failure:
    """The result of a plant that could not be grown."""

    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Job:
    """The work for every plant of a batch."""

    document: Document
    measure: Measure
    keeps_failures: bool = False  #: if true, values from which no plant can grow give a Failure instead of an error

    def document_of(self, task: Task) -> Document:
        refuse_seed(task.values)
        return self.document.set(task.values, seed=task.seed)

    def run(self, task: Task, progress: Progress | None = None) -> bytes:
        """Grows a plant and returns the pickled result. It is a copy, so that no view keeps the plant in memory.

        Raises the errors of growth and of the function, with a note of the seed and the values.
        """
        try:
            plant = self.document_of(task).grow(threads=1, progress=progress)
            return _pickle_result(_measure(plant, self.measure, progress))
        except InputError as error:
            if self.keeps_failures:
                return pickle.dumps(Failure(f"seed {task.seed}: {error}"))
            add_note(error, f"in the batch's plant of {task}")
            raise
        except Exception as error:
            add_note(error, f"in the batch's plant of {task}")
            raise


def refuse_seed(values: Mapping[str, Any]) -> None:
    """Raises ValueError for a value that the seeds of the batch would replace."""
    if "seed" in values:
        raise ValueError("seeds are given by `seeds`, not by a value 'seed'")


def _measure(plant: Plant, measure: Measure, progress: Progress | None) -> Any:
    if callable(measure):
        return measure(plant)
    light = measure is not None and not LIGHT_MEASURES.isdisjoint(measure)
    measures: dict[str, Any] = plant.measure(light=light, threads=1, progress=progress)
    return measures if measure is None else {name: measures[name] for name in measure}


def _pickle_result(result: Any) -> bytes:
    try:
        return pickle.dumps(result, 4)  # under protocol 5, read-only arrays stay read-only
    except Exception as error:
        raise TypeError(
            f"the function returned what cannot be sent between processes ({error}); "
            "return numbers, texts, arrays, or dicts and lists of them"
        ) from error


def add_note(error: BaseException, note: str) -> None:
    """Makes tracebacks end with `note`: from Python 3.11 on, and wherever the error's `__notes__` are shown."""
    notes = getattr(error, "__notes__", [])
    setattr(error, "__notes__", [*notes, note])  # add_note() came with Python 3.11

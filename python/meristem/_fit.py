# SPDX-License-Identifier: Apache-2.0
"""Fits plants to measurements: finds values of a document's variables whose plants have the requested measures."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any, Literal, Protocol

from ._batch import check_measure, count_processes, pickle_job
from ._core import Document, Plant, Session
from ._evolution import Evolution, latin_hypercube
from ._handle import Handle, Range, check_handles
from ._job import Failure, Job, Task
from ._pool import refuse_unguarded_program
from ._runner import Runner
from ._surrogate import guess_point
from ._target import CheckedTarget, Target, Wanted, check_targets

#: Why a search ended
Reason = Literal["reached", "growths", "converged", "stopped", "interrupted"]


class AskAndTell(Protocol):
    """An optimizer with the interface of the package cmaes: ask() returns points of the unit box, tell() accepts their
    values."""

    @property
    def population_size(self) -> int: ...
    def ask(self) -> Any: ...
    def tell(self, solutions: list[tuple[Any, float]]) -> None: ...
    def should_stop(self) -> bool: ...


#: A function of (loss, bounds), such as scipy.optimize.differential_evolution, which calls loss with points of the unit
#: box
Minimizer = Callable[[Callable[[Any], float], "list[tuple[float, float]]"], Any]


@dataclass(frozen=True)
class FitPoint:
    """A set of values that was tried, and its result."""

    values: dict[str, float | int]  #: the values that were tried, by variable
    error: float  #: root of the weighted mean square of all targets' errors; infinite if growth failed
    measures: dict[str, float]  #: means over the seeds
    errors: dict[str, float]  #: error of each target, in its scale: positive if the measure is too large
    failure: str | None  #: the failure; None if growth succeeded


@dataclass(frozen=True)
class FitProgress:
    """The progress of a fit."""

    growths: int  #: number of plants that have grown
    total: int  #: largest number of growths
    error: float  #: error of the best values so far
    values: dict[str, float | int]  #: the best values so far; empty before the first growth
    seconds_left: float  #: estimate, if all growths are needed

    def __str__(self) -> str:
        left = f"{self.seconds_left / 60:.0f} min" if self.seconds_left >= 90 else f"{self.seconds_left:.0f} s"
        return f"{self.growths} of {self.total} growths, error {self.error:.3g}, {left} left"


@dataclass(frozen=True)
class FitResult:
    """The best values that a fit has found.

    fit() returns it:

        tulip = meristem.read("tulip")
        found = meristem.fit(tulip, {"stem_length": (0.2, 0.6)}, {"height": 0.45}, growths=20, processes=1)
        print(found.values, "with an error of", found.error)
    """

    values: dict[str, float | int]  #: the best values, by variable
    error: float  #: error of the best values; see FitPoint
    measures: dict[str, float]  #: measures of the plants with these values, means over the seeds
    errors: dict[str, float]  #: error of each target; see FitPoint
    history: list[FitPoint]  #: all sets of values that were tried, in order
    growths: int  #: number of plants that were grown
    failures: list[str]  #: the kinds of failures, each once
    reason: Reason  #: why the fit ended
    session: Session = field(repr=False)  #: the document with the values set, its comments kept

    @property
    def document(self) -> Document:
        """The document with the values set."""
        document = self.session.document
        assert document is not None
        return document

    @property
    def text(self) -> str:
        """The text of the document, with changed numbers for the values that were set."""
        return self.session.text

    def save(self, path: Any) -> None:
        """Writes the text to a file. Raises as Session.save() does."""
        self.session.save(path)


def fit(
    document: Document,
    variables: str | Iterable[str] | Mapping[str, Range],
    targets: Mapping[str, Wanted | Target],
    *,
    seeds: Iterable[int] | None = None,
    compare: Literal["mean", "each"] = "mean",
    growths: int = 400,
    tolerance: float = 1e-4,
    measure: Callable[[Plant], Any] | None = None,
    optimizer: AskAndTell | Minimizer | None = None,
    key: int = 0,
    processes: int | None = None,
    progress: Callable[[FitProgress], object] | None = None,
) -> FitResult:
    """Finds values of a document's variables whose plants have the requested measures. Returns a FitResult.

    `variables` are names, whose ranges the document declares, or a dict of ranges by name: (low, high), None for the
    declared range, or range(12, 65) for whole numbers. `targets` gives the value of each measure by name: a number, a
    band (low, high), or a Target with scale and weight. `measure`, a function of the plant that returns a dict of
    numbers, gives measures of your own, as in batch(). With several `seeds` (the document's own if None), the fit
    compares the mean over their plants, or each plant with compare="each".

    It ends after `growths` plants, or when the error is below `tolerance`. The search is an evolution strategy with a
    model of the measures. Its result depends only on `key`, on any number of `processes`. `optimizer` replaces the
    search by an object with the interface of the package cmaes (ask, tell, population_size, should_stop), or by a
    function of (loss, bounds) as in scipy.optimize. Both see the unit box: 0 and 1 are the ends of each range.

    `progress` is called with a FitProgress after every growth. If it returns True, or on Ctrl-C, the fit ends with the
    best values so far. Values whose plant cannot be grown, or lacks a measure, count as the worst; the result lists
    these failures. Raises ValueError and TypeError for wrong arguments, and ValueError if no values give the measures.
    """
    refuse_unguarded_program()
    if not isinstance(document, Document):
        raise TypeError(f"document must be a Document, not {type(document).__name__}")
    if compare not in ("mean", "each"):
        raise ValueError(f"compare is {compare!r}; expected 'mean' or 'each'")
    if growths < 1:
        raise ValueError(f"growths must be at least 1, not {growths}")
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be a function of a FitProgress, not {type(progress).__name__}")
    handles = check_handles(document, variables)
    checked = check_targets(targets)
    given_seeds = [document.seed] if seeds is None else list(seeds)
    if not given_seeds:
        raise ValueError("seeds must have at least one number")
    job = Job(document, check_measure(measure or [target.name for target in checked]), keeps_failures=True)
    job.document_of(Task(given_seeds[0], {}))  # refuses a wrong seed at once
    count = count_processes(processes)
    bytes_of_job = pickle_job(job) if count > 1 else None
    search = _Search(handles, checked, given_seeds, compare == "each", growths, tolerance, progress)
    with Runner(job, bytes_of_job, min(count, growths)) as runner:
        search.runner = runner
        reason: Reason = "converged"
        try:
            if optimizer is None:
                _evolve(search, document, key)
            elif hasattr(optimizer, "ask") and hasattr(optimizer, "tell"):
                _ask_and_tell(search, optimizer)
            elif callable(optimizer):
                optimizer(search.loss, [(0.0, 1.0)] * len(handles))
            else:
                raise TypeError(f"optimizer must have ask and tell, or be a function, not {type(optimizer).__name__}")
        except (Exception, KeyboardInterrupt):
            # Optimizers may wrap the exception that ends a search in an error of their own.
            if search.ended is None or (search.ended == "interrupted" and search.best is None):
                raise
            reason = search.ended
        if reason not in ("stopped", "interrupted"):
            with suppress(KeyboardInterrupt):
                search.round_values()
    return search.result(document, reason)


class _Enough(Exception):
    """Ends a search from within a loss or an optimizer."""


@dataclass(frozen=True)
class _Row:
    """One compared number: a target's mean over the seeds, or its value for one seed."""

    target: CheckedTarget
    places: Sequence[int]  #: of the seeds
    weight: float  #: root of its share of all weights


class _Search:
    """The points that were tried, and the growth of the next points."""

    runner: Runner

    def __init__(
        self,
        handles: Sequence[Handle],
        targets: Sequence[CheckedTarget],
        seeds: Sequence[int],
        each: bool,
        growths: int,
        tolerance: float,
        progress: Callable[[FitProgress], object] | None,
    ) -> None:
        self.handles = handles
        self.history: list[FitPoint] = []
        self.shares: list[list[float]] = []  #: the points that could be measured; the next two fields belong to them
        self.measured: list[list[float]] = []
        self.points: list[FitPoint] = []
        self.best: int | None = None  #: index into `points`
        self.ended: Reason | None = None  #: the reason for the end of the search
        self.grown = 0
        self._targets = targets
        self._seeds = seeds
        self._growths = growths
        self._tolerance = tolerance
        self._progress = progress
        self._start = time.monotonic()
        self._told = 0  #: finished growths; `grown` counts the noted growths
        # A growth for each value that may turn out to be a whole number
        self._kept_back = len(seeds) * sum(handle.may_be_whole for handle in handles)
        if growths < 8 * self._kept_back:
            self._kept_back = 0
        self._known: dict[tuple[float | int, ...], FitPoint] = {}
        self._should_stop = False
        groups = [[place] for place in range(len(seeds))] if each else [list(range(len(seeds)))]
        weights = math.fsum(target.weight for target in targets) * len(groups)
        self._rows = [
            _Row(target, group, math.sqrt(target.weight / weights)) for target in targets for group in groups
        ]

    def errors_of(self, measured: Sequence[float]) -> list[float]:
        """Returns the weighted errors of measures. The root of the sum of their squares is the error of the point."""
        return [row.weight * row.target.error_of(number) for row, number in zip(self._rows, measured)]

    def loss(self, point: Sequence[float]) -> float:
        """Returns the error at a point of the unit box."""
        return self.try_points([point])[0]

    def try_points(self, points: Sequence[Sequence[float]]) -> list[float]:
        """Returns the errors at points of the unit box. Notes all grown points before it ends the search."""
        all_values = [
            tuple(handle.value_at(float(share)) for handle, share in zip(self.handles, point)) for point in points
        ]
        fresh = [values for values in dict.fromkeys(all_values) if values not in self._known]
        may_grow = max(self._growths - self._kept_back - self.grown, 0) // len(self._seeds)
        try:
            self._try_values(fresh[:may_grow])
        except KeyboardInterrupt:
            self.ended = "interrupted"
            raise
        if len(fresh) > may_grow:
            self._end("growths")
        return [self._known[values].error for values in all_values]

    def round_values(self) -> None:
        """Rounds each value to a whole number if the error does not rise, since the document may round it anyway."""
        for handle in self.handles:
            if self.best is None or not handle.may_be_whole or self.grown + len(self._seeds) > self._growths:
                continue
            best = self.points[self.best]
            rounded = dict(best.values)
            rounded[handle.name] = round(best.values[handle.name])
            key = tuple(rounded[one.name] for one in self.handles)
            if key not in self._known:
                for _ in self._grow([key]):
                    pass
            if self._known[key].error <= best.error:
                self.best = len(self.points)
                self.points.append(replace(self._known[key], values=rounded))

    def _try_values(self, all_values: Sequence[tuple[float | int, ...]]) -> None:
        for _ in self._grow(all_values):
            if self.best is not None and self.points[self.best].error <= self._tolerance:
                self._end("reached")
            if self._should_stop:
                self._end("stopped")

    def _grow(self, all_values: Sequence[tuple[float | int, ...]]) -> Iterator[None]:
        """Grows and notes the sets of values one after the other."""
        tasks = [Task(seed, self._named(values)) for values in all_values for seed in self._seeds]
        results = self.runner.run(tasks, self._tell)
        for values in all_values:
            self._note(values, [next(results)[1] for _ in self._seeds])
            self.grown += len(self._seeds)
            yield

    def _end(self, reason: Reason) -> None:
        self.ended = reason
        raise _Enough(reason)

    def result(self, document: Document, reason: Reason) -> FitResult:
        failures = list(dict.fromkeys(point.failure for point in self.history if point.failure is not None))
        if self.best is None:
            raise ValueError(f"none of {len(self.history)} sets of values gave the measures; the first: {failures[0]}")
        best = self.points[self.best]
        session = Session(document)
        session.edit(best.values)
        return FitResult(
            best.values, best.error, best.measures, best.errors, self.history, self.grown, failures, reason, session
        )

    def _named(self, values: Sequence[float | int]) -> dict[str, float | int]:
        return {handle.name: value for handle, value in zip(self.handles, values)}

    def _note(self, values: tuple[float | int, ...], results: Sequence[Any]) -> None:
        """Notes the plants of all seeds."""
        failure = next((str(result) for result in results if isinstance(result, Failure)), None)
        columns: dict[str, list[float]] = {}
        for target in self._targets:
            if failure is None:
                columns[target.name], failure = _numbers_of(target.name, results)
        named = self._named(values)
        if failure is not None:
            point = FitPoint(named, math.inf, {}, {}, f"{failure} with {named}")
        else:
            measured = [row.target.mean_of([columns[row.target.name][k] for k in row.places]) for row in self._rows]
            errors = self.errors_of(measured)
            point = FitPoint(
                named,
                math.sqrt(math.fsum(error**2 for error in errors)),
                {target.name: target.mean_of(columns[target.name]) for target in self._targets},
                {target.name: self._error_of(target, measured) for target in self._targets},
                None,
            )
            # The share of the rounded value.
            self.shares.append([handle.share_of(value) for handle, value in zip(self.handles, values)])
            self.measured.append(measured)
            self.points.append(point)
            if self.best is None or point.error < self.points[self.best].error:
                self.best = len(self.points) - 1
        self.history.append(point)
        self._known[values] = point

    def _error_of(self, target: CheckedTarget, measured: Sequence[float]) -> float:
        errors = [target.error_of(number) for row, number in zip(self._rows, measured) if row.target is target]
        return errors[0] if len(errors) == 1 else math.sqrt(math.fsum(e**2 for e in errors) / len(errors))

    def _tell(self) -> None:
        self._told += 1
        if self._progress is None:
            return
        best = self.points[self.best] if self.best is not None else None
        seconds = time.monotonic() - self._start
        left = seconds / self._told * (self._growths - self._told)
        state = FitProgress(
            self._told, self._growths, best.error if best else math.inf, dict(best.values) if best else {}, left
        )
        if self._progress(state) is True:
            self._should_stop = True


def _numbers_of(name: str, results: Sequence[Mapping[str, Any]]) -> tuple[list[float], str | None]:
    """Returns the measure of all plants, and its fault or None."""
    numbers = []
    for result in results:
        if not isinstance(result, Mapping):
            raise TypeError(f"the function must return a dict of numbers by names of targets, not {result!r}")
        if name not in result:
            raise ValueError(f"the function gave no {name!r}; it gave {', '.join(result)}")
        value = result[name]
        if value is None:
            return [], f"a plant has no {name}"
        with suppress(TypeError, ValueError):
            numbers.append(float(value))
            if math.isfinite(numbers[-1]):
                continue
            return [], f"a plant has no finite {name}"
        raise TypeError(f"the measure {name!r} is not a number but {type(value).__name__}; a fit needs numbers")
    return numbers, None


# --- searches ---------------------------------------------------------------------------------------------------------

_STRAY = 0.25  #: standard deviation of the first generation, as a share of the range
_MOST_STALE = 50  #: generations without a new set of values after which a search ends


def _evolve(search: _Search, document: Document, key: int) -> None:
    """Searches by evolution from the best of a spread of points. In each generation one point is the guess of the
    surrogate.

    If its points no longer differ, another evolution begins elsewhere with twice the population.
    """
    dimensions = len(search.handles)
    given = {variable.name: variable.value for variable in document.variables}
    first = [handle.share_of(given[handle.name]) for handle in search.handles]
    size = Evolution(first, _STRAY).population_size
    for attempt in range(20):
        grown = search.grown
        spread = latin_hypercube(2 * size, dimensions, key, attempt)
        if attempt == 0:
            spread.insert(0, first)  # the document's own values
        losses = search.try_points(spread)
        mean = spread[min(range(len(spread)), key=lambda k: losses[k])]
        evolution = Evolution(mean, _STRAY, population_size=size, key=(key, attempt))
        stale = 0
        while not evolution.should_stop() and stale < _MOST_STALE:
            before = search.grown
            points = [evolution.ask() for _ in range(size - 1)]
            points.append(_guess(search) or evolution.ask())
            evolution.tell(list(zip(points, search.try_points(points))))
            stale = stale + 1 if search.grown == before else 0
        size *= 2
        if search.grown == grown:
            return  # nothing is left to try


def _guess(search: _Search) -> list[float] | None:
    """Returns the surrogate's point, unless it was tried already."""
    if search.best is None:
        return None
    guess = guess_point(search.shares, search.measured, search.best, search.errors_of)
    if guess is None or any(math.dist(guess, share) < 1e-6 for share in search.shares):
        return None
    return guess


def _ask_and_tell(search: _Search, optimizer: Any) -> None:
    stale = 0
    should_stop = getattr(optimizer, "should_stop", lambda: False)
    while not should_stop() and stale < _MOST_STALE:
        before = search.grown
        points = [optimizer.ask() for _ in range(optimizer.population_size)]
        optimizer.tell(list(zip(points, search.try_points(points))))
        stale = stale + 1 if search.grown == before else 0

# SPDX-License-Identifier: Apache-2.0
"""Fits: results, rejected inputs, and kept properties."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

import meristem
from meristem._evolution import Evolution, folded, latin_hypercube, normal, solve, uniform
from meristem._surrogate import guess_point

# A stem with two kinds of side shoots: every measure is a simple function of the variables.
COMB = """// A comb.
{
  "meristem": 1,
  "name": "Comb",
  "seed": 3,
  "variables": {
    "tall": {"value": 2, "min": 1, "max": 5, "unit": "m"},  // of the stem
    "thick": {"value": 0.05, "min": 0.01, "max": 0.1, "unit": "m"},
    "teeth": {"value": 6, "min": 2, "max": 40},
    "reach": {"value": 0.3, "min": 0.1, "max": 1, "unit": "m"},
    "hidden": {"value": 1, "private": true},
    "twice": {"value": "2*reach", "unit": "m"},
    "endless": 3
  },
  "components": {
    "stem": {"type": "tree", "length": "tall*hidden", "radius": "thick", "segments": 8},
    "tooth": {"type": "tree", "length": "twice/2*(1 + 0.1*gauss(0,1))", "radius": 0.005, "segments": 2}
  },
  "links": [{"from": "stem", "to": "tooth", "kind": "branch", "count": "teeth + 0*endless", "angle": 90}]
}
"""
comb = meristem.Document(COMB)
NAMES = ["tall", "thick", "teeth", "reach"]
MEASURES = ("height", "stem_diameter", "axes", "length")


def measured(document: meristem.Document) -> dict[str, float]:
    measures = document.grow(threads=1).measure(threads=1)
    return {name: measures[name] for name in MEASURES}


def planted() -> tuple[dict[str, Any], dict[str, Any]]:
    truth = {"tall": 3.7, "thick": 0.022, "teeth": 23, "reach": 0.71}
    return truth, measured(comb.set(truth))


def fit_quickly(*arguments: Any, **options: Any) -> meristem.FitResult:
    return meristem.fit(*arguments, **{"processes": 1, "growths": 60, **options})


# --- results ----------------------------------------------------------------------------------------------------------


def test_planted_values_are_found() -> None:
    truth, measures = planted()
    result = fit_quickly(comb, {**dict.fromkeys(NAMES), "teeth": range(2, 41)}, measures, growths=400, tolerance=0.003)
    assert result.reason == "reached" and result.error <= 0.003
    assert result.values["teeth"] == 23 and isinstance(result.values["teeth"], int)
    for name in NAMES:
        variable = next(one for one in comb.variables if one.name == name)
        assert result.values[name] == pytest.approx(truth[name], abs=0.05 * (variable.max - variable.min)), name
    assert measured(result.document) == pytest.approx(result.measures)
    assert result.growths <= 400 and len(result.history) == result.growths


@pytest.mark.parametrize("key", range(3))
def test_any_number_of_processes_finds_the_same(key: int) -> None:
    targets = planted()[1]
    one = fit_quickly(comb, NAMES, targets, key=key, growths=300, tolerance=0.003)
    two = fit_quickly(comb, NAMES, targets, key=key, growths=300, tolerance=0.003, processes=3)
    assert one.history == two.history and one.values == two.values
    assert (one.growths, one.reason, one.text) == (two.growths, two.reason, two.text)


def test_another_key_is_another_search() -> None:
    targets = planted()[1]
    assert fit_quickly(comb, NAMES, targets).history != fit_quickly(comb, NAMES, targets, key=1).history


def test_what_the_document_rounds_stays_whole() -> None:
    result = fit_quickly(comb, ["teeth", "reach"], {"axes": 18, "length": 9.5}, growths=80)
    assert result.values["teeth"] == 17 and '"teeth": {"value": 17,' in result.text
    assert result.error < 1e-3 and result.growths == len(result.history) <= 80
    assert fit_quickly(comb, ["tall"], {"height": 3.3}).values["tall"] == pytest.approx(3.3, abs=1e-3)


def test_within_a_band_all_is_good() -> None:
    result = fit_quickly(comb, "tall", {"height": (3, 3.5), "axes": (0, 100)})
    assert result.error == 0 and 3 <= result.measures["height"] <= 3.5 and result.reason == "reached"


def test_targets_that_exclude_each_other_are_weighed() -> None:
    def found(weight: float) -> float:
        targets = {"height": meristem.Target(4.0, scale=1), "tips_and_height": meristem.Target(2.0, scale=1, weight=weight)}
        result = fit_quickly(comb, ["tall"], targets, measure=twice_the_height)
        return result.measures["height"]

    # The minimum of w1 (h - 4)^2 + w2 (h - 2)^2 is the weighted mean.
    assert found(1) == pytest.approx(3, abs=0.01)
    assert found(3) == pytest.approx(2.5, abs=0.01)


def twice_the_height(plant: meristem.Plant) -> dict[str, float]:
    height = plant.measure(threads=1)["height"]
    return {"height": height, "tips_and_height": height}


def test_the_mean_over_seeds_is_compared_or_each_plant() -> None:
    targets = {"length": 6.0}
    mean = fit_quickly(comb, ["reach"], targets, seeds=range(5), growths=100)
    lengths = [measured(comb.set(mean.values, seed=seed))["length"] for seed in range(5)]
    assert mean.measures["length"] == pytest.approx(sum(lengths) / 5)
    assert mean.error == pytest.approx(abs(mean.errors["length"]), abs=1e-12) and mean.error < 1e-3
    each = fit_quickly(comb, ["reach"], targets, seeds=range(5), compare="each", growths=100)
    lengths = [measured(comb.set(each.values, seed=seed))["length"] for seed in range(5)]
    assert each.error == pytest.approx(math.sqrt(sum((length / 6 - 1) ** 2 for length in lengths) / 5))
    assert each.error > mean.error and each.growths % 5 == 0


def test_azimuths_go_the_short_way_around() -> None:
    result = fit_quickly(comb, ["tall"], {"an_azimuth": (350, 10)}, measure=height_as_an_azimuth)
    azimuth = result.measures["an_azimuth"]
    assert result.error == 0 and (azimuth >= 350 or azimuth <= 10)
    at_359 = fit_quickly(comb, {"tall": (1, 3.5)}, {"an_azimuth": 359}, measure=height_as_an_azimuth)
    assert at_359.values["tall"] == 3.5 and at_359.errors["an_azimuth"] == pytest.approx(-44 / 180)


def height_as_an_azimuth(plant: meristem.Plant) -> dict[str, float]:
    return {"an_azimuth": 90 * plant.measure(threads=1)["height"] % 360}


# --- returned values --------------------------------------------------------------------------------------------------


def test_the_text_keeps_its_comments_and_can_be_saved(tmp_path: Path) -> None:
    result = fit_quickly(comb.set({"thick": 0.03}, seed=8), ["tall"], {"height": 3.25})
    value = f"{result.values['tall']:g}"
    assert value == "3.25"
    changed = COMB.replace('{"value": 2,', '{"value": 3.25,').replace('"value": 0.05', '"value": 0.03')
    assert result.text == changed.replace('"seed": 3', '"seed": 8')
    result.save(tmp_path / "comb.json")
    assert (tmp_path / "comb.json").read_text(encoding="utf-8") == result.text
    assert meristem.read(tmp_path / "comb.json").grow().measure()["height"] == result.measures["height"]
    assert result.session.undo_count > 0


def test_history_and_progress_tell_of_every_growth() -> None:
    states: list[meristem.FitProgress] = []
    result = fit_quickly(comb, ["tall"], {"height": 3.3}, tolerance=0, growths=25, progress=states.append)
    assert [state.growths for state in states] == list(range(1, 26)) and {state.total for state in states} == {25}
    assert states[-1].seconds_left == 0 and states[-1].error >= result.error
    assert str(states[-1]).startswith("25 of 25 growths, error ")
    assert result.reason == "growths" and len(result.history) == result.growths == 25
    best = min(result.history, key=lambda point: point.error)
    assert (best.values, best.error, best.measures, best.errors) == (
        result.values, result.error, result.measures, result.errors)


def test_progress_may_stop_it_with_the_best_so_far() -> None:
    result = fit_quickly(comb, ["tall"], {"height": 3.3}, tolerance=0, progress=lambda state: state.growths == 7)
    assert result.reason == "stopped" and result.growths == 7


@pytest.mark.parametrize("processes", [1, 2])
def test_an_interrupt_keeps_the_best_so_far(processes: int) -> None:
    def interrupt(state: meristem.FitProgress) -> None:
        if state.growths == 20:
            raise KeyboardInterrupt

    result = fit_quickly(comb, NAMES, planted()[1], tolerance=0, progress=interrupt, processes=processes)
    assert result.reason == "interrupted" and 10 <= result.growths < 20
    assert result.error == min(point.error for point in result.history)


def test_growths_that_fail_count_as_the_worst_and_are_told() -> None:
    limited = meristem.Document({**comb.to_dict(), "limits": {"nodes": 90}})
    result = fit_quickly(limited, ["teeth", "reach"], {"axes": 20, "length": 10}, growths=80)
    failed = [point for point in result.history if point.failure]
    assert failed and all(point.error == math.inf and not point.measures for point in failed)
    assert any("limit" in failure and "seed 3" in failure for failure in result.failures)
    assert result.measures["axes"] == pytest.approx(20, abs=1)


def test_a_measure_that_a_plant_lacks_counts_as_failed() -> None:
    result = fit_quickly(comb, {"tall": (1, 2)}, {"stem_diameter": meristem.Target(0.03, scale=1), "height": 1.4}, growths=30)
    assert any("no stem_diameter" in failure for failure in result.failures)
    assert result.measures["height"] == pytest.approx(1.4, abs=0.02)
    with pytest.raises(ValueError, match="none of .* sets of values gave the measures; the first: a plant has no stem_d"):
        fit_quickly(comb, {"tall": (1, 1.2)}, {"stem_diameter": 0.1})


def test_where_nothing_new_is_left_it_ends() -> None:
    result = fit_quickly(comb, {"teeth": range(4, 9)}, {"axes": 30}, growths=100)
    assert result.reason == "converged" and result.values == {"teeth": 8} and result.growths <= 6


def test_what_the_function_raises_is_raised() -> None:
    with pytest.raises(ZeroDivisionError):
        fit_quickly(comb, ["tall"], {"height": 2}, measure=lambda plant: {"height": 1 / 0})
    with pytest.raises(ValueError, match="gave no 'height'; it gave width"):
        fit_quickly(comb, ["tall"], {"height": 2}, measure=lambda plant: {"width": 1})
    with pytest.raises(TypeError, match="is not a number but list"):
        fit_quickly(comb, ["tall"], {"length_by_order": 2})


# --- rejected inputs --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("variables", "message"),
    [
        (["tal"], "'Comb' has no variable 'tal'; expected 'tall', or another of tall, thick, teeth, reach, endless"),
        (["zzz"], "expected one of tall, thick"),
        (["twice"], r"'twice' is computed as '2\*reach'; expected one of reach"),
        (["hidden"], "'hidden' is private; expected"),
        ([], "at least one name"),
        ({"tall": (3, 2)}, "the range of 'tall' is 3 to 2; expected one that rises"),
        ({"teeth": range(5, 6)}, "at least two whole numbers"),
        ({"teeth": range(9, 5, -1)}, "whole numbers that rise"),
    ],
)
def test_variables_that_cannot_be_turned_are_refused(variables: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        meristem.fit(comb, variables, {"height": 2})


@pytest.mark.parametrize(
    ("targets", "kind", "message"),
    [
        ({"hieght": 2}, ValueError, "there is no measure 'hieght'; expected one of trees"),
        ({}, ValueError, "at least one measure"),
        ([("height", 2)], TypeError, "must be a dict"),
        ({"height": (3, 2)}, ValueError, "a band from 3 down to 2"),
        ({"height": (1, 2, 3)}, ValueError, "not 3 numbers"),
        ({"height": "2"}, TypeError, "a number or a band"),
        ({"height": math.nan}, ValueError, "finite"),
        ({"height": 0}, ValueError, "no scale: its value is 0"),
        ({"height": meristem.Target(2, scale=-1)}, ValueError, "scale: it must be above 0"),
        ({"height": meristem.Target(2, weight=0)}, ValueError, "weight must be above 0"),
    ],
)
def test_targets_that_make_no_sense_are_refused(targets: Any, kind: type[Exception], message: str) -> None:
    with pytest.raises(kind, match=message):
        meristem.fit(comb, ["tall"], targets)


def test_other_arguments_are_checked() -> None:
    with pytest.raises(TypeError, match="must be a Document"):
        meristem.fit("oak", ["age"], {"height": 2})  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="'mean' or 'each'"):
        fit_quickly(comb, ["tall"], {"height": 2}, compare="all")
    with pytest.raises(ValueError, match="growths must be at least 1"):
        fit_quickly(comb, ["tall"], {"height": 2}, growths=0)
    with pytest.raises(ValueError, match="seeds must have"):
        fit_quickly(comb, ["tall"], {"height": 2}, seeds=[])
    with pytest.raises(TypeError, match="optimizer must have ask and tell"):
        fit_quickly(comb, ["tall"], {"height": 2}, optimizer=3)
    with pytest.raises(TypeError, match="progress must be a function"):
        fit_quickly(comb, ["tall"], {"height": 2}, progress=3)


# --- other optimizers -------------------------------------------------------------------------------------------------


def test_cmaes_may_search() -> None:
    cmaes = pytest.importorskip("cmaes")
    numpy = pytest.importorskip("numpy")
    truth, measures = planted()
    search = cmaes.CMA(mean=numpy.full(2, 0.5), sigma=0.3, bounds=numpy.array([[0, 1]] * 2), seed=1)
    targets = {name: measures[name] for name in ("height", "stem_diameter")}
    result = fit_quickly(comb, ["tall", "thick"], targets, optimizer=search, growths=250, tolerance=0.003)
    assert result.reason == "reached" and result.values["tall"] == pytest.approx(truth["tall"], abs=0.03)


def test_scipy_may_search() -> None:
    optimize = pytest.importorskip("scipy.optimize")
    result = fit_quickly(comb, ["tall"], {"height": 3.3}, optimizer=optimize.direct, growths=100, tolerance=0.001)
    assert result.reason == "reached" and result.values["tall"] == pytest.approx(3.3, abs=0.01)


# --- the default search -----------------------------------------------------------------------------------------------


def sphere(x: list[float]) -> float:
    return math.fsum(a * a for a in x)


def ellipsoid(x: list[float]) -> float:
    """An ellipsoid whose longest axis is a hundred times the shortest."""
    return math.fsum(10 ** (4 * i / (len(x) - 1)) * a * a for i, a in enumerate(x))


def rosenbrock(x: list[float]) -> float:
    y = [1 + 4 * a for a in x]
    return math.fsum(100 * (y[i + 1] - y[i] ** 2) ** 2 + (1 - y[i]) ** 2 for i in range(len(y) - 1))


@pytest.mark.parametrize("key", range(3))
@pytest.mark.parametrize(("function", "evaluations"), [(sphere, 1200), (ellipsoid, 3000), (rosenbrock, 3000)])
def test_evolution_finds_the_lowest_point(function: Any, evaluations: int, key: int) -> None:
    lowest = [0.6, 0.7, 0.35, 0.5]
    evolution = Evolution([0.3] * 4, 0.3, key=key)
    best, count = math.inf, 0
    while not evolution.should_stop() and count < evaluations:
        points = [evolution.ask() for _ in range(evolution.population_size)]
        values = [function([a - b for a, b in zip(point, lowest)]) for point in points]
        evolution.tell(list(zip(points, values)))
        best, count = min(best, *values), count + len(points)
    assert best < 1e-8


def test_evolution_takes_in_points_that_it_did_not_ask_for() -> None:
    evolution = Evolution([0.1] * 3, 0.1)
    for _ in range(8):
        points = [evolution.ask() for _ in range(evolution.population_size - 1)] + [[0.9, 0.9, 0.9]]
        evolution.tell([(point, math.dist(point, [0.9] * 3)) for point in points])
    assert math.dist(evolution.mean, [0.9] * 3) < 0.2
    assert all(0 <= number <= 1 for number in evolution.ask())


def test_draws_are_functions_of_their_key() -> None:
    assert uniform(1, "a") == uniform(1, "a") != uniform(1, "b")
    draws = [normal(7, k) for k in range(4000)]
    assert abs(sum(draws)) / 4000 < 0.05 and sum(d * d for d in draws) / 4000 == pytest.approx(1, abs=0.08)
    assert all(0 < uniform(k) < 1 for k in range(1000))
    # Exact values, because they are equal on every machine.
    assert uniform(0).hex() == "0x1.9047192fac641p-1"


def test_a_latin_hypercube_has_a_point_in_each_slice() -> None:
    points = latin_hypercube(10, 3, 5)
    for axis in range(3):
        assert sorted(int(10 * point[axis]) for point in points) == list(range(10))


def test_walls_are_mirrors() -> None:
    assert [folded(x) for x in (0.25, -0.25, 1.25, 2.25, -1.5)] == pytest.approx([0.25, 0.25, 0.75, 0.25, 0.5])


def test_solve_leaves_open_what_is_open() -> None:
    assert solve([[0, 2], [3, 1]], [4, 5]) == pytest.approx([1, 2])
    assert solve([[1, 1], [1, 1]], [2, 2]) == pytest.approx([2, 0])


def test_the_guess_is_exact_for_polynomials_of_second_degree() -> None:
    def measures(x: float, y: float) -> list[float]:
        return [1 + 2 * x - y + x * y, 3 - x + 0.5 * y * y, x * x]

    wanted = measures(0.62, 0.4)
    shares = latin_hypercube(20, 2, 1)
    known = [measures(*share) for share in shares]
    errors = [math.dist(values, wanted) for values in known]
    guess = guess_point(shares, known, errors.index(min(errors)), lambda m: [a - b for a, b in zip(m, wanted)])
    assert guess == pytest.approx([0.62, 0.4], abs=1e-3)


def test_the_guess_stays_in_the_box() -> None:
    shares = latin_hypercube(8, 2, 1)
    known = [[x + y] for x, y in shares]
    best = max(range(8), key=lambda k: known[k])
    guess = guess_point(shares, known, best, lambda m: [m[0] - 5])
    assert guess is not None and max(guess) <= 1 and sum(guess) > known[best][0]
    assert guess_point(shares[:2], known[:2], 0, lambda m: m) is None

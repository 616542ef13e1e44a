# SPDX-License-Identifier: Apache-2.0
"""Batches: order, errors, and no remaining workers."""

from __future__ import annotations

import itertools
import multiprocessing
import os
import pickle
import random
import signal
import time
from multiprocessing.process import BaseProcess
from types import SimpleNamespace
from typing import Any, Iterable, Iterator, cast

import meristem
import numpy as np
import pytest
from meristem._job import Task
from meristem._pool import _Worker
from plants import long_growth, small_tree

BOTH = pytest.mark.parametrize("processes", [1, 2])


def tree() -> meristem.Document:
    return meristem.Document(small_tree())


def node_count(plant: meristem.Plant) -> int:
    return plant.node_count


def positions(plant: meristem.Plant) -> Any:
    return plant.stems[0].skeleton.position


def the_plant(plant: meristem.Plant) -> meristem.Plant:
    return plant


class OddError(Exception):
    """Can be pickled but not unpickled."""

    def __init__(self, one: int, two: int) -> None:
        super().__init__(f"{one} and {two}")


def fail_at_seed_3(plant: meristem.Plant) -> int:
    if plant.document.seed == 3:
        raise ZeroDivisionError("no such share")
    return plant.node_count


def fail_oddly(plant: meristem.Plant) -> None:
    raise OddError(1, 2)


def kill_itself_at_seed_2(plant: meristem.Plant) -> int:
    if plant.document.seed == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    return plant.node_count


def never_end_from_seed_1(plant: meristem.Plant) -> int:
    while plant.document.seed >= 1:
        time.sleep(1)
    return plant.node_count


def test_any_number_of_processes_gives_the_same_results_in_the_same_order() -> None:
    def grow(processes: int) -> list[meristem.BatchResult]:
        grid: dict[str, Iterable[float]] = {"tree.points": [100, 400], "size": [0.05, 0.1]}
        return list(meristem.batch(tree(), seeds=range(3), grid=grid, processes=processes))

    here = grow(1)
    assert len({result.result["nodes"] for result in here}) > 4
    assert grow(2) == here
    assert grow(3) == here


def test_seeds_change_fastest_then_the_last_path() -> None:
    grid: dict[str, Iterable[float]] = {"tree.points": np.array([50, 60]), "size": (0.05, 0.1)}
    results = meristem.batch(tree(), seeds=(4, 9), grid=grid, measure="nodes", processes=1)
    plan = [(result.seed, result.values["tree.points"], result.values["size"]) for result in results]
    assert plan == [(s, p, z) for p in (50, 60) for z in (0.05, 0.1) for s in (4, 9)]


def test_a_result_is_what_its_document_grows_by_itself() -> None:
    document = meristem.read("bush")
    for result in meristem.batch(document, seeds=(3, 4), measure=positions, processes=2):
        alone = document.set(seed=result.seed).grow()
        assert np.array_equal(result.result, positions(alone))


def test_set_fixes_values_and_grids_go_over_them() -> None:
    fixed = {"tree.points": 80, "size": 0.03}
    (result,) = meristem.batch(tree(), seeds=[1], set=fixed, grid={"size": [0.1]}, measure=node_count, processes=1)
    assert result.values == {"size": 0.1}
    assert result.result == tree().set({"tree.points": 80, "size": 0.1}, seed=1).grow().node_count


def test_samples_may_come_from_an_endless_generator() -> None:
    def samples() -> Iterator[dict[str, float]]:
        generator = random.Random(1)
        while True:
            yield {"size": generator.uniform(0.02, 0.2)}

    results = meristem.batch(tree(), seeds=[1, 2], samples=samples(), measure="leaf_area", processes=2)
    first = list(itertools.islice(results, 6))
    assert [result.seed for result in first] == [1, 2] * 3
    assert len({result.values["size"] for result in first}) == 3


@BOTH
def test_only_a_bounded_number_of_seeds_is_taken_ahead(processes: int) -> None:
    taken = []

    def seeds() -> Iterator[int]:
        for seed in itertools.count():
            taken.append(seed)
            yield seed

    results = meristem.batch(tree(), seeds=seeds(), measure="nodes", processes=processes)
    assert [next(results).seed for _ in range(10)] == list(range(10))
    assert len(taken) <= 10 + 4 * processes
    results.close()


@BOTH
def test_progress_is_told_of_every_plant_and_the_total(processes: int) -> None:
    told: list[tuple[int, int | None]] = []
    results = meristem.batch(
        tree(), seeds=range(4), processes=processes, progress=lambda done, total: told.append((done, total))
    )
    assert len(list(results)) == 4
    assert told == [(1, 4), (2, 4), (3, 4), (4, 4)]


def test_the_total_of_a_generator_is_unknown() -> None:
    told: list[tuple[int, int | None]] = []
    list(meristem.batch(tree(), seeds=iter([1]), processes=1, progress=lambda done, total: told.append((done, total))))
    assert told == [(1, None)]


@BOTH
def test_results_are_copies_of_what_the_plant_has(processes: int) -> None:
    (result,) = meristem.batch(tree(), seeds=[1], measure=positions, processes=processes)
    assert result.result.flags.writeable
    assert not isinstance(result.result.base, meristem.Plant)


def test_measures_of_light_are_taken_when_named() -> None:
    (result,) = meristem.batch(tree(), seeds=[5], measure=["height", "leaf_exposure"], processes=1)
    assert list(result.result) == ["height", "leaf_exposure"]
    assert result.result["leaf_exposure"] == tree().set(seed=5).grow().measure(light=True)["leaf_exposure"]


def test_nothing_is_grown_of_no_seeds_or_values() -> None:
    assert list(meristem.batch(tree(), seeds=[])) == []
    assert list(meristem.batch(tree(), grid={"size": []})) == []


def test_an_unknown_path_is_refused_before_anything_grows() -> None:
    with pytest.raises(meristem.InputError, match="no variable 'sice'.*did you mean 'size'"):
        meristem.batch(tree(), grid={"sice": [1, 2]})
    with pytest.raises(meristem.InputError, match="no variable 'sice'"):
        meristem.batch(tree(), set={"sice": 1})


@BOTH
def test_an_error_comes_at_its_plants_turn_and_names_it(processes: int) -> None:
    results = meristem.batch(tree(), seeds=[8], grid={"tree.points": [100, -1, 100]}, processes=processes)
    assert next(results).values == {"tree.points": 100}
    with pytest.raises(meristem.InputError, match="points") as caught:
        next(results)
    assert caught.value.__notes__ == ["in the batch's plant of seed 8 with {'tree.points': -1}"]
    assert list(results) == []
    assert multiprocessing.active_children() == []


@BOTH
def test_a_later_sample_with_a_seed_is_refused_at_its_turn(processes: int) -> None:
    results = meristem.batch(tree(), seeds=[8], samples=[{"size": 0.1}, {"seed": 4}], processes=processes)
    assert next(results).values == {"size": 0.1}
    with pytest.raises(ValueError, match="seeds are given by `seeds`"):
        next(results)


@BOTH
def test_what_the_function_raises_is_passed_on(processes: int) -> None:
    results = meristem.batch(tree(), measure=fail_at_seed_3, processes=processes)
    assert [next(results).seed for _ in range(3)] == [0, 1, 2]
    with pytest.raises(ZeroDivisionError, match="no such share") as caught:
        next(results)
    assert caught.value.__notes__ == ["in the batch's plant of seed 3"]
    if processes > 1:
        assert "in fail_at_seed_3" in str(caught.value.__cause__)


def test_an_error_that_cannot_be_read_back_is_told_in_words() -> None:
    with pytest.raises(RuntimeError, match="OddError: 1 and 2"):
        list(meristem.batch(tree(), measure=fail_oddly, processes=2))


def test_a_killed_worker_is_told_with_its_plant() -> None:
    results = meristem.batch(tree(), measure=kill_itself_at_seed_2, processes=2)
    with pytest.raises(meristem.MachineError, match="killed by signal 9 at seed 2; memory may have run out"):
        list(results)
    assert multiprocessing.active_children() == []


def test_workers_that_are_killed_between_results_are_told() -> None:
    results = meristem.batch(tree(), seeds=range(50), measure="nodes", processes=2)
    assert next(results).seed == 0
    for worker in multiprocessing.active_children():
        worker.kill()
        worker.join()
    with pytest.raises(meristem.MachineError, match="killed by signal 9"):
        list(results)


def test_a_worker_that_dies_is_told_with_the_plant_in_hand_after_its_answers() -> None:
    ours, theirs = multiprocessing.Pipe()
    worker = _Worker(ours, cast(BaseProcess, SimpleNamespace(join=lambda timeout: None, exitcode=-9)))
    worker.give(0, Task(6, {}))
    worker.give(1, Task(7, {}))
    theirs.send((0, b"", None))
    theirs.recv(), theirs.recv()
    theirs.close()
    worker.give(2, Task(8, {}))
    assert worker.take() == (0, b"", None)
    with pytest.raises(meristem.MachineError, match="killed by signal 9 at seed 7;"):
        worker.take()


def test_a_function_that_workers_cannot_import_is_refused_at_once() -> None:
    def local(plant: meristem.Plant) -> int:
        return plant.node_count

    for function in (local, lambda plant: plant.node_count):
        with pytest.raises(TypeError, match="define it at the top of a module, or grow with processes=1"):
            meristem.batch(tree(), measure=function, processes=2)
        assert len(list(meristem.batch(tree(), seeds=[1], measure=function, processes=1))) == 1


@BOTH
def test_a_result_that_cannot_be_sent_is_refused(processes: int) -> None:
    with pytest.raises(TypeError, match="return numbers, texts, arrays"):
        list(meristem.batch(tree(), measure=the_plant, processes=processes))


def test_leaving_the_loop_ends_workers_in_the_midst_of_plants() -> None:
    values: list[dict[str, float]] = [{"tree.points": 50}, *[{"tree.points": 10**6, "tree.step": 0.001}] * 4]
    for result in meristem.batch(tree(), seeds=[1], samples=values, processes=2):
        assert result.values == values[0]
        assert len(multiprocessing.active_children()) == 2
        break
    assert multiprocessing.active_children() == []


def test_leaving_the_loop_ends_functions_that_do_not() -> None:
    results = meristem.batch(tree(), measure=never_end_from_seed_1, processes=2)
    assert next(results).seed == 0
    results.close()
    assert multiprocessing.active_children() == []


def test_results_can_be_pickled() -> None:
    (result,) = meristem.batch(long_growth(), seeds=[1], set={"tree.points": 50}, measure="nodes", processes=1)
    assert pickle.loads(pickle.dumps(result)) == result


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"grid": {"size": [1]}, "samples": [{}]}, ValueError, "grid or samples, not both"),
        ({"grid": {"size": 0.1}}, TypeError, r"grid\['size'\] must be a sequence"),
        ({"grid": {"size": "0.1"}}, TypeError, r"grid\['size'\] must be a sequence"),
        ({"grid": [1]}, TypeError, "grid must be a dict of sequences.*not list"),
        ({"grid": {"seed": [4, 5]}}, ValueError, "seeds are given by `seeds`"),
        ({"set": {"seed": 4}}, ValueError, "seeds are given by `seeds`"),
        ({"samples": [{"size": 1, "seed": 4}]}, ValueError, "seeds are given by `seeds`"),
        ({"samples": {"size": 1}}, TypeError, "samples must be several dicts"),
        ({"samples": 3}, TypeError, "samples must be several dicts"),
        ({"samples": [3]}, TypeError, "samples must be dicts.*not int"),
        ({"samples": [{}], "seeds": itertools.count()}, ValueError, "seeds must be a list or range"),
        ({"measure": 3}, TypeError, "measure must be names of measures or a function of the plant, not int"),
        ({"measure": ["hight"]}, ValueError, "there is no measure 'hight'; expected one of trees, nodes"),
        ({"processes": 0}, ValueError, "processes must be at least 1, not 0"),
        ({"processes": 1.5}, TypeError, "integer"),
        ({"progress": 3}, TypeError, "progress must be a function of two numbers, or True, not int"),
        ({"seeds": 3}, TypeError, "seeds must be several numbers, such as .* not int"),
        ({"seeds": ["one"]}, TypeError, "seed must be a whole number"),
        ({"seeds": [-1]}, ValueError, "seed must be a whole number from 0"),
    ],
)
def test_wrong_arguments_are_refused_at_once(arguments: dict[str, Any], error: type, message: str) -> None:
    with pytest.raises(error, match=message):
        meristem.batch(tree(), **arguments)


def test_a_document_is_asked_for() -> None:
    with pytest.raises(TypeError, match="document must be a Document, not str"):
        meristem.batch("oak")  # type: ignore[arg-type]

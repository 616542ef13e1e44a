# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from numpy.typing import NDArray

import meristem
from plants import LONG_GROWTH, grown_small_tree, long_growth, small_tree


def test_progress_tells_stages_and_rising_fractions() -> None:
    told: list[tuple[str, float]] = []
    meristem.Document(small_tree()).grow(progress=lambda stage, fraction: told.append((stage, fraction)))
    assert "expanding" in {stage for stage, _ in told}
    # A stage begins at 0 and rises to 1, also if the next stage has an equal name.
    begins = [k for k, (_, fraction) in enumerate(told) if fraction == 0] + [len(told)]
    assert begins[0] == 0
    for begin, end in zip(begins, begins[1:]):
        fractions = [fraction for _, fraction in told[begin:end]]
        assert fractions == sorted(fractions) and fractions[-1] == 1
        assert len({stage for stage, _ in told[begin:end]}) == 1


def test_a_progress_can_be_watched_from_another_thread() -> None:
    progress = meristem.Progress()
    seen: list[str] = []
    done = threading.Event()

    def watch() -> None:
        while not done.wait(0.001):
            seen.append(progress.stage)

    watcher = threading.Thread(target=watch)
    watcher.start()
    meristem.read("oak").grow(progress=progress)
    done.set()
    watcher.join()
    assert len(set(seen) - {""}) > 0  # other threads ran while the oak grew
    assert progress.fraction == 1 and not progress.cancelled


def test_cancelling_from_another_thread_stops_growth() -> None:
    progress = meristem.Progress()
    timer = threading.Timer(0.05, progress.cancel)
    timer.start()
    with pytest.raises(meristem.Cancelled):
        long_growth().grow(progress=progress)
    timer.join()
    assert progress.cancelled


def test_a_cancelled_progress_begins_nothing() -> None:
    progress = meristem.Progress()
    progress.cancel()
    with pytest.raises(meristem.Cancelled):
        meristem.Document(small_tree()).grow(progress=progress)


def test_what_a_callback_raises_stops_the_call_and_comes_out() -> None:
    def fail(stage: str, fraction: float) -> None:
        raise KeyError(stage)

    with pytest.raises(KeyError):
        long_growth().grow(progress=fail)


def press_ctrl_c_during(call: Callable[[], object]) -> None:
    """Calls `call` while a signal is pending, which may arrive as soon as the timer's thread runs."""
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        call()
    timer.join()


def test_keyboard_interrupts_stop_growth() -> None:
    press_ctrl_c_during(long_growth().grow)
    assert grown_small_tree().node_count > 0  # growth must still work afterwards


def hull_points() -> NDArray[np.float64]:
    points = np.random.default_rng(1).normal(size=(1_000_000, 3))
    return np.asarray(points / np.linalg.norm(points, axis=1, keepdims=True))


def long_calls() -> dict[str, Callable[[], Callable[[], object]]]:
    """Returns functions that prepare long calls, by name."""

    def tubes() -> Callable[[], object]:
        count = 400_000
        line = np.column_stack([np.zeros(count), np.arange(count), np.sin(np.arange(count))])
        skeleton = meristem.Skeleton(np.arange(count) - 1, line, radius=np.full(count, 0.1))
        return lambda: meristem.tubes(skeleton, sides=64, error=0)

    def render() -> Callable[[], object]:
        plant = grown_small_tree()
        return lambda: plant.render(size=(1500, 1500), samples=500)

    def organ_light() -> Callable[[], object]:
        day = {"scene.latitude": 50, "scene.sun": {"day": 170, "every_hours": 0.5}}
        return meristem.read("spruce", set=day).grow().organ_light

    def hull() -> Callable[[], object]:
        points = hull_points()
        return lambda: meristem.convex_hull(points)

    def colonize() -> Callable[[], object]:
        points = np.random.default_rng(1).random((300_000, 3)) * 8 + [-4, 2, -4]
        return lambda: meristem.colonize(points, step=0.02, influence=0.3, kill=0.05)

    return {"tubes": tubes, "render": render, "organ_light": organ_light, "hull": hull, "colonize": colonize}


@pytest.mark.parametrize("name", long_calls())
def test_ctrl_c_stops_every_long_call(name: str) -> None:
    press_ctrl_c_during(long_calls()[name]())


def large_text() -> str:
    """A document whose reading takes a second or more."""
    leaves = ",".join(f'"c{k}":{{"type":"leaf"}}' for k in range(400_000))
    return f'{{"meristem":1,"components":{{{leaves}}}}}'


def test_ctrl_c_stops_reading(tmp_path: Path) -> None:
    text = large_text()
    file = tmp_path / "large.json"
    file.write_text(text, encoding="utf-8")
    small = meristem.Session(small_tree())
    document = meristem.Document(small_tree())
    given: tuple[tuple[Callable[[Any], object], Any], ...] = (
        (meristem.read, file),
        (meristem.Document, text),
        (meristem.Session, text),
        (meristem.Session.open, file),
        (small.edit_text, [(0, len(small.text.encode()), text)]),
        (document.set, {"components": json.loads(text)["components"]}),
    )
    for call, argument in given:
        read: list[object] = []
        # A call that is not stopped leaves its result in the list before Python sees the interrupt.
        press_ctrl_c_during(lambda: read.extend(map(call, [argument])))
        assert read == [], call
    assert small.is_good and small.undo_count == 0 and len(small.text) < 5000


def test_ctrl_c_stops_reading_files(tmp_path: Path) -> None:
    rows = range(800_000)
    table = tmp_path / "nodes.csv"
    table.write_text("node,x,y,z,parent,radius\n" + "".join(f"{k},{k},0,1,{k - 1},0.1\n" for k in rows))
    press_ctrl_c_during(lambda: meristem.read_skeleton(table))
    document = tmp_path / "d.json"
    document.write_text('{"meristem": 1, "components": {"t": {"type": "skeleton", "file": "nodes.csv"}}}')
    press_ctrl_c_during(lambda: meristem.read(document))


def test_ctrl_c_stops_the_conversion_of_a_large_dict() -> None:
    large = {"meristem": 1, "components": {f"c{k}": {"type": "leaf"} for k in range(1_000_000)}}
    press_ctrl_c_during(lambda: meristem.Document(large))


def test_other_threads_run_while_a_session_reads() -> None:
    session = meristem.Session(small_tree())
    seen: list[str] = []

    def edit() -> None:
        session.edit_text([(0, len(session.text.encode()), large_text())])

    reader = threading.Thread(target=edit)
    reader.start()
    while reader.is_alive():
        try:
            seen.append("few" if session.undo_count == 0 else "done")
        except RuntimeError as error:
            seen.append(str(error))
    reader.join()
    assert "another thread is using the session" in seen
    assert session.undo_count == 1


@pytest.mark.parametrize("callback", ["None", "print_nothing"])
def test_calls_on_daemon_threads_end_with_the_program(callback: str) -> None:
    program = f"""
import threading, time, meristem
def print_nothing(stage, fraction): pass
grow = meristem.read("oak", set={LONG_GROWTH}).grow
threading.Thread(target=grow, kwargs={{"progress": {callback}}}, daemon=True).start()
time.sleep(0.1)
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert (run.returncode, run.stdout) == (0, "")
    assert "terminate" not in run.stderr


def test_interrupted_files_are_not_half_written(tmp_path: Any) -> None:
    plant = meristem.read("oak", set={"age": 160}).grow()

    def interrupt(stage: str, fraction: float) -> None:
        if fraction > 0.3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        plant.save(tmp_path / "oak.glb", progress=interrupt)
    assert list(tmp_path.iterdir()) == []


def test_plants_grow_side_by_side_on_threads() -> None:
    documents = [meristem.Document(small_tree(), seed=seed) for seed in range(4)]
    expected = [document.grow().stems[0].skeleton.hash for document in documents]
    found = [""] * len(documents)

    def grow(k: int) -> None:
        found[k] = documents[k].grow(threads=1 + k % 2).stems[0].skeleton.hash

    threads = [threading.Thread(target=grow, args=(k,)) for k in range(len(documents))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == expected


def test_one_progress_watches_one_call_at_a_time() -> None:
    progress = meristem.Progress(lambda stage, fraction: nested.append(stage))
    nested: list[str] = []
    errors: list[str] = []

    def grow_within(stage: str, fraction: float) -> None:
        try:
            meristem.Document(small_tree()).grow(progress=within)
        except ValueError as error:
            errors.append(str(error))

    within = meristem.Progress(grow_within)
    meristem.Document(small_tree()).grow(progress=within)
    assert errors and set(errors) == {"this Progress watches another call; make one for each call"}
    meristem.Document(small_tree()).grow(progress=progress)
    assert nested


@pytest.mark.parametrize("threads", [-1, 1025])
def test_impossible_numbers_of_threads_are_refused(threads: int) -> None:
    with pytest.raises(ValueError, match="threads must be 0"):
        meristem.Document(small_tree()).grow(threads=threads)


def test_a_progress_must_be_callable() -> None:
    with pytest.raises(TypeError, match="progress must be a Progress"):
        meristem.Document(small_tree()).grow(progress=3)  # type: ignore[arg-type]

# SPDX-License-Identifier: Apache-2.0
"""The study of cut leaders, with few trees."""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path

import meristem
import numpy as np
import pytest

STUDIES = Path(__file__).resolve().parents[2] / "studies"
sys.path.insert(0, str(STUDIES))

import cut_leader as study  # noqa: E402
from cut_study import adaptations, cuts, growth, trees  # noqa: E402

FIGURES = ("table", "trends", "adaptations", "growth", "lambda", "trees")
SEEDS = range(8)


def run_script(arguments: list[str], path: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-B", str(STUDIES / "cut_leader.py"), *arguments]
    return subprocess.run(command, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, timeout=300)


@pytest.fixture(scope="module")
def quick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Runs a quick study and returns its folder."""
    folder = tmp_path_factory.mktemp("study")
    done = run_script(["--quick", "-o", str(folder)], str(Path(meristem.__file__).parents[1]))
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert "published" in done.stdout and "expected" in done.stdout
    return folder


def read_rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def row_of(path: Path, name: str) -> dict[str, float]:
    """Returns the numbers of the row whose first cell is `name`."""
    [row] = [row for row in read_rows(path) if next(iter(row.values())) == name]
    return {key: float(cell) for key, cell in list(row.items())[1:]}


# --- trees ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", SEEDS)
def test_without_a_cut_forks_divide_just_what_comes(seed: int) -> None:
    tree = trees.grow_tree(trees.SLIM, 9, seed)
    for number in range(1, tree.last):
        here, next_one = tree.stem[number], tree.stem[number + 1]
        divided = tree.resource[next_one] + tree.side_resource(number)
        assert divided == pytest.approx(tree.resource[here], rel=1e-5)


@pytest.mark.parametrize("seed", SEEDS)
def test_what_a_cut_bud_passes_back_is_halved_from_lateral_to_lateral(seed: int) -> None:
    cut = cuts.find_cut(trees.SLIM, seed)
    assert cut is not None
    tree = trees.grow_tree(trees.SLIM, 9, seed, cut)
    assert tree.last == cut.above
    assert tree.skeleton["terminal_bud"][tree.stem[cut.above]] == trees.DAMAGED
    # The topmost lateral gets the resource of the fork minus half of the cut bud's claim.
    claimed = 2 * (tree.resource[tree.stem[cut.above]] - tree.side_resource(cut.above))
    assert claimed > 0
    for place, number in enumerate(range(cut.above - 1, 0, -1), start=2):
        from_below = tree.resource[tree.stem[number]] - tree.resource[tree.stem[number + 1]]
        assert tree.side_resource(number) - from_below == pytest.approx(claimed / 2**place, abs=1e-4)


def test_trees_grow_alike_until_they_are_cut() -> None:
    cut = cuts.find_cut(trees.SLIM, 1)
    assert cut is not None
    before, uncut = trees.grow_tree(trees.SLIM, 8, 1), trees.grow_tree(trees.SLIM, 9, 1)
    tree = trees.grow_tree(trees.SLIM, 8, 1, cut)
    below = before.skeleton.position[before.stem[: cut.above + 1]]
    assert np.array_equal(tree.skeleton.position[tree.stem], below)
    assert np.array_equal(uncut.skeleton.position[uncut.stem[: cut.above + 1]], below)
    assert growth.count_metamers(uncut, 9)[8] == len(before.skeleton) - 1


def test_changed_settings_keep_what_is_not_changed() -> None:
    changed = trees.change(trees.SLIM, resource={"lambda": 0.6}, damage=False)
    assert changed["resource"] == {"alpha": 1.8, "lambda": 0.6} and changed["damage"] is False
    assert trees.SLIM["resource"]["lambda"] == 0.52 and "damage" not in trees.SLIM


def test_above_one_half_of_lambda_laterals_never_have_to_wait() -> None:
    free = trees.change(trees.SLIM, laterals_wait=False)
    for seed in SEEDS:
        as_ever = trees.grow_tree(trees.SLIM, 18, seed).skeleton
        assert trees.grow_tree(free, 18, seed).skeleton.hash == as_ever.hash


def test_the_more_takeover_the_less_the_successor_turns_aside() -> None:
    turns = []
    for takeover in (0, 0.5, 2):
        effect = adaptations.study_adaptation(trees.change(trees.SLIM, takeover=takeover), SEEDS)
        turns.append(effect.turn)
    assert turns[0] > turns[1] + 5 > turns[2] + 10 > 10


# --- the table --------------------------------------------------------------------------------------------------------


def test_the_published_tree_stands_in_the_table_as_printed() -> None:
    assert cuts.PUBLISHED.leader_share == pytest.approx(0.28131, abs=1e-5)
    assert -cuts.PUBLISHED.total.gain == pytest.approx(6.030)
    gains = [pair.gain for pair in cuts.PUBLISHED.laterals]
    assert gains == pytest.approx([2.255, 0.868, 1.322, 0.297, 0.784])  # the source prints the first as 2.225


def test_a_summary_of_one_tree_is_that_tree() -> None:
    one = cuts.summarize([cuts.PUBLISHED])
    assert one.laterals == cuts.PUBLISHED.laterals and one.total == cuts.PUBLISHED.total
    assert (one.trees, one.alike, one.fall_holds, one.leader_holds, one.all_rise) == (1, 1, 1, 1, 1)


def test_trees_without_a_branched_lateral_are_left_out() -> None:
    bare = trees.change(trees.SLIM, lateral_threshold=1000)
    assert cuts.find_cut(bare, 0) is None
    assert cuts.compare_cuts(bare, SEEDS) == []


def test_a_quick_study_writes_its_files(quick: Path) -> None:
    assert len(read_rows(quick / "cuts.csv")) == study.QUICK_SEEDS
    assert len(read_rows(quick / "readings.csv")) == len(cuts.READINGS)
    assert len(read_rows(quick / "growth.csv")) == len(growth.SETS) * (growth.ITERATIONS + 1)
    for name in FIGURES:
        assert (quick / f"{name}.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_the_cut_changes_what_the_tree_divides_as_published(quick: Path) -> None:
    found = row_of(quick / "readings.csv", cuts.READING.name)
    assert found["total"] == pytest.approx(cuts.PUBLISHED.total.uncut, rel=0.35)
    assert found["total_cut"] == pytest.approx(cuts.PUBLISHED.total.cut, rel=0.35)
    assert found["leader"] == pytest.approx(cuts.PUBLISHED.leader, rel=0.35)
    assert 0.20 < found["leader_share"] < 0.35
    assert found["fall_holds"] >= 0.95 and found["all_rise"] >= 0.9
    assert found["alike"] > 0.5
    for k in range(cuts.LATERALS):
        assert found[f"lateral_{k + 1}_cut"] > found[f"lateral_{k + 1}"]


def test_each_adaptation_does_what_it_is_for(quick: Path) -> None:
    effects = {name: row_of(quick / "adaptations.csv", name) for name in adaptations.ADAPTATIONS}
    on = effects["all on"]
    assert on["grows_on"] == 1
    assert effects["nothing passed back"]["grows_on"] < 0.8
    again = effects["cut buds grow again"]
    assert again["fall"] < on["fall"] / 2 and again["all_rise"] < on["all_rise"]
    assert effects["laterals open as terminals"]["uncut_metamers"] > 4 * on["uncut_metamers"]
    assert effects["no turn to the leader"]["turn"] > on["turn"] + 5


def test_growth_is_that_of_the_trial_and_rises_with_lambda(quick: Path) -> None:
    rows = read_rows(quick / "growth.csv")
    for name, trials in growth.TRIAL.items():
        for trial in trials:
            [row] = [row for row in rows if (row["set"], int(row["iteration"])) == (name, trial.iteration)]
            assert float(row["metamers"]) == pytest.approx(trial.metamers, rel=0.25)
            if trial.height is not None:
                assert float(row["height"]) == pytest.approx(trial.height, rel=0.1)
    for name in study.LAMBDA_SETS:
        heights = [float(row["height"]) for row in read_rows(quick / "lambda.csv") if row["set"] == name]
        assert len(heights) == len(growth.LAMBDAS) and np.all(np.diff(heights) > 0)


def test_all_expectations_hold_in_a_quick_study(quick: Path) -> None:
    assert [row["what"] for row in read_rows(quick / "expectations.csv") if row["holds"] != "True"] == []


def test_without_the_module_the_script_says_how_to_get_it(tmp_path: Path) -> None:
    done = run_script([], str(tmp_path))
    assert done.returncode == 1
    assert "./dev python" in done.stderr and "Traceback" not in done.stderr


def test_numbers_of_seeds_below_one_are_refused(tmp_path: Path) -> None:
    done = run_script(["--seeds", "0", "-o", str(tmp_path)], str(Path(meristem.__file__).parents[1]))
    assert done.returncode == 2
    assert "at least 1" in done.stderr
    assert not list(tmp_path.iterdir())

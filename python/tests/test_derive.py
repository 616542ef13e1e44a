# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import gc
import os
import signal
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import meristem

KOCH = """#define angle = 60
#steps 2
F
F -> F+(angle)F-(2*angle)F+(angle)F
"""

CHANCE = """A(1)
A(x) : * : 1 -> F(x)[+A(x)]A(x)
A(x) : * : 2 -> F(x)[-A(x/2)]A(x/2)
#interpret
F(x) -> f(x/2)f(x/2)
"""

# Takes minutes, because of its many steps.
ENDLESS = "A(0)" + "B" * 100_000 + "\nA(x) -> A(x+1)\n"


def test_a_word_is_its_text_and_its_modules() -> None:
    step = "{0}+(60){0}-(120){0}+(60){0}"
    assert str(meristem.derive(KOCH, 0)) == "F"
    assert str(meristem.derive(KOCH, steps=1)) == step.format("F")
    word = meristem.derive(KOCH)
    assert str(word) == step.format(step.format("F"))
    assert len(word) == 31
    assert word.counts == {"F": 16, "+": 10, "-": 5}
    assert repr(word) == "<meristem.Word of 31 modules>"


def test_letters_index_the_alphabet_and_parameters_follow_each_other() -> None:
    word = meristem.derive("A(1)\nA(x) -> F[B(x,2*x)]A(x+1)", 2)
    assert str(word) == "F[B(1,2)]F[B(2,4)]A(3)"
    assert [word.alphabet[letter] for letter in word.letters] == [
        *[("F", 0), ("[", 0), ("B", 2), ("]", 0)] * 2, ("A", 1)]
    assert word.parameters.tolist() == [1, 2, 2, 4, 3]
    arities = np.array([arity for _, arity in word.alphabet])
    assert arities[word.letters].sum() == len(word.parameters)
    assert (word.letters.dtype, word.parameters.dtype) == (np.uint16, np.float64)


def test_arrays_are_views_that_outlive_the_word_and_cannot_be_written() -> None:
    word = meristem.derive("A(1)\nA(x) -> A(x/2)A(x/2)", 15)
    letters, parameters = word.letters, word.parameters
    assert np.shares_memory(letters, word.letters) and np.shares_memory(parameters, word.parameters)
    for array in (letters, parameters):
        with pytest.raises(ValueError):
            array[0] = 0
    del word
    gc.collect()
    assert letters.shape == parameters.shape == (2**15,)
    assert np.all(letters == letters[0]) and np.all(parameters == 2.0**-15)


def test_an_empty_word_has_empty_columns() -> None:
    word = meristem.derive("A\nA ->", 1)
    assert (str(word), len(word), word.counts) == ("", 0, {})
    assert word.letters.shape == word.parameters.shape == (0,)


def test_counts_are_by_symbol_with_any_number_of_parameters() -> None:
    word = meristem.derive("F[F(1)]F(1,2)+", 0)
    assert word.counts == {"[": 1, "]": 1, "F": 3, "+": 1}
    assert [letter for letter in word.alphabet if letter[0] == "F"] == [("F", 0), ("F", 1), ("F", 2)]


def test_words_are_equal_by_what_they_say() -> None:
    word = meristem.derive("A(1)B", 0)
    # Another grammar, with its alphabet in another order.
    same = meristem.derive("#ignore B\nC\nC -> A(1)B", 1)
    assert same.alphabet != word.alphabet and same == word
    for other in ("A(2)B", "A(1)", "A(1)BB", "A(1)A(1)", "AB", "BA(1)"):
        assert meristem.derive(other, 0) != word
    assert word != "A(1)B"
    with pytest.raises(TypeError, match="unhashable"):
        hash(word)


def test_draws_come_from_the_seed_alone() -> None:
    words = {str(meristem.derive(CHANCE, 6, seed=seed)) for seed in range(8)}
    assert len(words) == 8
    one = meristem.derive(CHANCE, 15, seed=1, drawn=True, threads=1)
    assert len(one) > 100_000  # more than one block of the parallel loops
    for threads in (2, 3, 8):
        assert meristem.derive(CHANCE, 15, drawn=True, threads=threads) == one, "the seed is 1 if not given"
    assert meristem.derive(CHANCE, 3, seed=2**53) == meristem.derive(CHANCE, 3, seed=np.uint64(2**53))


def test_constants_take_the_place_of_definitions() -> None:
    assert str(meristem.derive(KOCH, 1, constants={"angle": 45})) == "F+(45)F-(90)F+(45)F"
    assert str(meristem.derive(KOCH, 1, constants={"angle": np.float32(0.5)})) == "F+(0.5)F-(1)F+(0.5)F"
    assert meristem.derive(KOCH, 1, constants={}) == meristem.derive(KOCH, 1)
    with pytest.raises(meristem.InputError, match="does not define 'angel'; .*did you mean 'angle'"):
        meristem.derive(KOCH, 1, constants={"angel": 45})


def test_drawn_words_have_interpretations_in_them() -> None:
    plain, drawn = meristem.derive(CHANCE, 5), meristem.derive(CHANCE, 5, drawn=True)
    assert drawn.counts["f"] == 2 * plain.counts["F"] and "F" not in drawn.counts
    assert meristem.derive(KOCH, drawn=True) == meristem.derive(KOCH)


def test_files_are_paths_and_what_they_include_stands_beside_them(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "fir.txt").write_text("#steps 1\nF\nF -> F-F\n")
    stand = tmp_path / "stand.txt"
    stand.write_text("T+T\n#include parts/fir.txt as T\n")
    assert str(meristem.derive(stand, 0, drawn=True)) == "F-F+F-F"
    with pytest.raises(meristem.InputError, match="cannot include others"):
        meristem.derive(stand.read_text(), 0)
    with pytest.raises(meristem.InputError, match="there is no such file; did you mean '.*stand.txt'"):
        meristem.derive(tmp_path / "stant.txt", 0)


def test_faults_have_their_places(tmp_path: Path) -> None:
    bad = "A(1)\nA(x) -> A(y)\n A -> ]\n"
    with pytest.raises(meristem.InputError) as caught:
        meristem.derive(bad, 1)
    assert [(d.file, d.line, d.column) for d in caught.value.diagnostics] == [("<python>", 2, 11), ("<python>", 3, 7)]
    file = tmp_path / "bad.txt"
    file.write_text("A(1)\nA(x) -> A(1/(x-1))\n")
    with pytest.raises(meristem.InputError) as caught:
        meristem.derive(file, 1)
    (fault,) = caught.value.diagnostics
    assert (fault.file, fault.line) == (str(file), 2)
    assert fault.message.startswith("'1/(x-1)' is not a finite number where")
    with pytest.raises(meristem.InputError, match=r"<python>: the grammar does not give the number of steps"):
        meristem.derive("F")
    with pytest.raises(meristem.InputError, match=r"<python>:2: .* modules of a word are too many"):
        meristem.derive("F\nF -> FF", 1000)


def test_rules_that_never_match_are_warned_of() -> None:
    with pytest.warns(UserWarning, match="<python>:3:1: this rule can never match: no word has 'B'"):
        word = meristem.derive("A\nA -> AA\nB -> A\n", 1)
    assert str(word) == "AA"


@pytest.mark.parametrize("arguments, error, message", [
    ({"grammar": 3}, TypeError, "grammar must be a text"),
    ({"grammar": b"F"}, TypeError, "grammar must be a text"),
    ({"steps": -1}, ValueError, "steps must be from 0 to 1000000"),
    ({"steps": 1_000_001}, ValueError, "steps must be from 0 to 1000000"),
    ({"steps": 1.5}, TypeError, "steps"),
    ({"seed": -1}, ValueError, "seed must be a whole number from 0"),
    ({"seed": 0.5}, TypeError, "seed must be a whole number"),
    ({"constants": [1]}, TypeError, "constants must be a dict"),
    ({"constants": {"angle": "wide"}}, TypeError, "must be a number"),
    ({"constants": {"angle": np.nan}}, meristem.InputError, "a number is nan"),
    ({"threads": -1}, ValueError, "threads"),
])
def test_wrong_arguments_are_refused(arguments: dict[str, Any], error: type[Exception], message: str) -> None:
    given: dict[str, Any] = {"grammar": KOCH, "steps": 1, **arguments}
    with pytest.raises(error, match=message):
        meristem.derive(**given)


def test_words_are_made_by_derive_alone() -> None:
    with pytest.raises(TypeError, match="derive"):
        meristem.Word()


def test_progress_tells_and_cancels() -> None:
    stages: list[str] = []
    meristem.derive(CHANCE, 12, drawn=True, progress=lambda stage, fraction: stages.append(stage))
    assert set(stages) == {"deriving", "interpreting"}
    progress = meristem.Progress()
    timer = threading.Timer(0.1, progress.cancel)
    timer.start()
    with pytest.raises(meristem.Cancelled):
        meristem.derive(ENDLESS, 1_000_000, progress=progress)
    timer.join()


def test_keyboard_interrupts_stop_it() -> None:
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        meristem.derive(ENDLESS, 1_000_000)
    timer.join()

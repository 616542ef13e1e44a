#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`meristem derive` from the user's view. Usage: derive_test.py PROGRAM [unittest options]"""

import json
import os
import re
import signal
import unittest

import cli_case
from cli_case import DONE, FAILED, WRONG_INPUT

KOCH = """#define angle = 60
#steps 2
F
F -> F+(angle)F-(2*angle)F+(angle)F
"""

# Branches that are at random as long as their parent or half as long; drawn as two segments.
CHANCE = """#define length 1
#axiom
A(length)
#rules
A(x) : * : 1 -> F(x)[+A(x)]A(x)
A(x) : * : 2 -> F(x)[-A(x/2)]A(x/2)
#interpret
F(x) -> f(x/2)f(x/2)
"""

THOUSANDFOLD = "F\nF -> " + 1000 * "F" + "\n"


class Derive(cli_case.Case):
    def setUp(self):
        super().setUp()
        self.write("koch.txt", KOCH)
        self.write("chance.txt", CHANCE)
        self.write("thousandfold.txt", THOUSANDFOLD)

    def derive(self, *arguments, **options):
        done = self.run_program("derive", *arguments, **options)
        self.assertEqual(done.returncode, DONE, done.stderr.decode())
        self.assertEqual(done.stderr, b"")
        return done.stdout.decode()

    def stats(self, *arguments):
        return json.loads(self.derive(*arguments, "--stats"))

    def assert_refuses(self, grammar, message, *arguments):
        self.write("bad.txt", grammar)
        self.assertEqual(self.assert_ends(WRONG_INPUT, "derive", "bad.txt", *arguments), message + "\n")

    # Words

    def test_writes_the_word_and_a_lines_end(self):
        step = "{0}+(60){0}-(120){0}+(60){0}"
        self.assertEqual(self.derive("koch.txt", "--steps", "0"), "F\n")
        self.assertEqual(self.derive("koch.txt", "--steps", "1"), step.format("F") + "\n")
        self.assertEqual(self.derive("koch.txt"), step.format(step.format("F")) + "\n")

    def test_reads_standard_input_and_writes_files(self):
        self.assertEqual(self.derive("-", input=KOCH.encode()), self.derive("koch.txt"))
        self.write("word.txt", "before")
        self.assertEqual(self.derive("koch.txt", "-o", "word.txt"), "")
        self.assertEqual(self.read("word.txt").decode(), self.derive("koch.txt"))

    def test_an_empty_word_is_an_empty_line(self):
        self.assertEqual(self.derive("-", "--steps", "1", input=b"A\nA ->\n"), "\n")
        self.assertEqual(json.loads(self.derive("-", "--steps", "1", "--stats", input=b"A\nA ->\n")),
                         {"steps": 1, "length": 0, "counts": {}})

    def test_a_long_word_is_whole(self):
        word = self.derive("-", "--steps", "17", input=b"#symbols Leaf\nLeaf(1)F\nF -> F Leaf(0.5) F\n")
        self.assertEqual(word.count("Leaf(0.5)"), 2**17 - 1)
        self.assertEqual(word.replace(" Leaf(0.5)", " "), "Leaf(1)F" + " F" * (2**17 - 1) + "\n")

    def test_draws_by_the_seed(self):
        words = {self.derive("chance.txt", "--steps", "6", "--seed", str(seed)) for seed in range(1, 9)}
        self.assertEqual(len(words), 8)
        self.assertEqual(self.derive("chance.txt", "--steps", "6"),
                         self.derive("chance.txt", "--steps", "6", "--seed", "1"))

    def test_same_word_on_any_number_of_threads(self):
        # More than one block of the parallel loops.
        first = self.derive("chance.txt", "--steps", "15", "--drawn", "--threads", "1")
        self.assertGreater(len(first), 500_000)
        for threads in ("2", "3", "8"):
            self.assertEqual(self.derive("chance.txt", "--steps", "15", "--drawn", "--quiet", "--threads", threads), first)

    def test_definitions_take_other_values(self):
        self.assertEqual(self.derive("koch.txt", "--steps", "1", "--define", "angle=45"), "F+(45)F-(90)F+(45)F\n")
        self.assertEqual(self.derive("koch.txt", "--steps", "1", "--define", "angle=3", "--define", "angle=1/4"),
                         "F+(0.25)F-(0.5)F+(0.25)F\n")

    def test_drawn_words_have_interpretations_in_them(self):
        plain = self.derive("chance.txt", "--steps", "3")
        drawn = self.derive("chance.txt", "--steps", "3", "--drawn")
        self.assertEqual(re.sub(r"F\((.*?)\)", lambda m: f"f({float(m[1]) / 2:g})" * 2, plain), drawn)
        self.assertNotEqual(plain, drawn)
        self.assertEqual(self.derive("koch.txt", "--drawn"), self.derive("koch.txt"))

    def test_stats_count_symbols_with_any_number_of_parameters(self):
        self.assertEqual(self.stats("koch.txt"), {"steps": 2, "length": 31, "counts": {"F": 16, "+": 10, "-": 5}})
        self.write("arities.txt", "F[F(1)]F(1,2)+\n")
        self.assertEqual(self.stats("arities.txt", "--steps", "0"),
                         {"steps": 0, "length": 6, "counts": {"[": 1, "]": 1, "F": 3, "+": 1}})
        stats = self.stats("chance.txt", "--steps", "4", "--drawn")
        drawn = self.derive("chance.txt", "--steps", "4", "--drawn").strip()
        symbols = re.sub(r"\(.*?\)", "", drawn)
        self.assertEqual(stats["length"], len(symbols))
        self.assertEqual(stats["counts"], {symbol: symbols.count(symbol) for symbol in set(symbols)})

    def test_included_grammars_stand_beside_the_grammar(self):
        os.mkdir(self.path("trees"))
        self.write("trees/stand.txt", "T+T\n#include parts/fir.txt as T\n")
        os.mkdir(self.path("trees/parts"))
        self.write("trees/parts/fir.txt", "#steps 2\nF\nF -> F-F\n")
        self.assertEqual(self.derive("trees/stand.txt", "--steps", "0", "--drawn"), "F-F-F-F+F-F-F-F\n")
        errors = self.assert_ends(WRONG_INPUT, "derive", "trees/stand.txt", "--steps", "0", "-o", "trees/parts/fir.txt")
        self.assertIn("'trees/parts/fir.txt' would be overwritten, and it is read", errors)
        self.write("trees/stand.txt", "T+T\n#include parts/fire.txt as T\n")
        self.assertEqual(self.assert_ends(WRONG_INPUT, "derive", "trees/stand.txt", "--steps", "0"),
                         "trees/stand.txt:2:1: 'parts/fire.txt': there is no such file; did you mean "
                         "'parts/fir.txt'?\n")

    # Errors

    def test_wrong_uses(self):
        for arguments in ([], ["koch.txt", "--steps", "-1"], ["koch.txt", "--steps", "1.5"],
                          ["koch.txt", "--steps", "1000001"], ["koch.txt", "--seed", "-1"],
                          ["koch.txt", "--define"], ["koch.txt", "--threads", "0"], ["koch.txt", "thousandfold.txt"]):
            self.assert_ends(WRONG_INPUT, "derive", *arguments)
        self.assertIn("'nowhere.txt'", self.assert_ends(FAILED, "derive", "nowhere.txt"))
        self.assertIn("'koch.txt' would be overwritten, and it is read",
                      self.assert_ends(WRONG_INPUT, "derive", "koch.txt", "-o", "koch.txt"))
        self.assertIn("nowhere/word.txt", self.assert_ends(FAILED, "derive", "koch.txt", "-o", "nowhere/word.txt"))

    def test_steps_must_be_said(self):
        self.assert_refuses("F\n", "bad.txt: the grammar does not give the number of steps; expected '#steps N' in "
                            "it, or --steps N")

    def test_definitions_that_cannot_be(self):
        expected = "; expected NAME=VALUE, such as angle=22.5"
        self.assert_refuses(KOCH, "meristem: --define 'angle' defines nothing" + expected, "--define", "angle")
        self.assert_refuses(KOCH, "meristem: --define '=3' defines nothing" + expected, "--define", "=3")
        for value in ("", "wide", "1/0", "ran(1)", "1 2"):
            self.assert_refuses(KOCH, f"meristem: --define 'angle': '{value}' is not a number" + expected, "--define",
                                "angle=" + value)
        self.assert_refuses(KOCH, "bad.txt: the grammar does not define 'angel'; expected a name that it defines: angle; "
                            "did you mean 'angle'?", "--define", "angel=3")

    def test_faults_and_warnings_have_file_line_and_column(self):
        self.assert_refuses("A(1)\nA(x) -> A(y)\n A -> ]\n",
                            "bad.txt:2:11: 'y' is not a known name; expected a variable or a constant\n"
                            "bad.txt:3:7: ']' closes no '['; expected '[' before it")
        done = self.run_program("derive", "-", "--steps", "1", input=b"A\nA -> AA\nB -> A\n")
        self.assertEqual(done.stdout, b"AA\n")
        self.assertEqual(done.stderr.decode(),
                         "warning: <standard input>:3:1: this rule can never match: no word has 'B'\n")
        self.assertEqual(self.derive("-", "--steps", "1", "--quiet", input=b"A\nA -> AA\nB -> A\n"), "AA\n")

    def test_faults_of_deriving_have_file_and_line(self):
        self.assert_refuses("A(1)\nA(x) -> A(1/(x-1))\n",
                            "bad.txt:2: '1/(x-1)' is not a finite number where 'A(x) -> A(1/(x-1))' is applied; "
                            "expected a condition that leaves this case out (most likely a division by zero)",
                            "--steps", "1")
        errors = self.assert_ends(WRONG_INPUT, "derive", "thousandfold.txt", "--steps", "1000", "-o", "word.txt")
        self.assertRegex(errors, r"(?m)^thousandfold\.txt:2: 1000000000 modules of a word are too many; .*at most 200000000 ")

    def test_documents_are_not_grammars(self):
        for document in (cli_case.BOX, "// A box.\n" + cli_case.BOX):
            self.assert_refuses(document, "bad.txt: this is a plant document; expected the text of a grammar; 'meristem "
                                "grow' takes documents")

    def test_a_signal_leaves_nothing(self):
        self.write("endless.txt", "A(0)" + "B" * 100_000 + "\nA(x) -> A(x+1)\n")
        before = sorted(os.listdir(self.folder))
        errors = self.stop(signal.SIGINT, "derive", "endless.txt", "--steps", "1000000", "-o", "word.txt")
        self.assertIn("no file was left half-written", errors)
        self.assertEqual(sorted(os.listdir(self.folder)), before)


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shell completion and the man page. Both must contain every option of the help, bash must complete them, and other
shells, if installed, must accept their scripts.

Usage: completion_test.py PROGRAM
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


def printed(*arguments):
    done = run(*arguments)
    assert done.returncode == 0, done.stderr
    return done.stdout


def help_options(command):
    return set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", printed(command, "--help"), re.MULTILINE))


COMMANDS = re.findall(r"^  (\w+) +\S", printed("--help").split("Subcommands:")[1], re.MULTILINE)

# Prints the completions that bash offers for the last word of the command line.
COMPLETE = """
source "$1"; shift
meristem() { "$PROGRAM" "$@"; }
compopt() { :; }
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_meristem
printf '%s\\n' "${COMPREPLY[@]}"
"""


class Completion(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def script(self, shell):
        path = os.path.join(self.folder, shell)
        with open(path, "w", encoding="utf-8") as file:
            file.write(printed("completion", shell))
        return path

    def offered(self, *words):
        done = subprocess.run(["bash", "-c", COMPLETE, "bash", self.script("bash"), "meristem", *words], cwd=self.folder,
                              env={**os.environ, "PROGRAM": PROGRAM}, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stderr, "")
        return [word for word in done.stdout.split("\n") if word]

    def test_knows_every_option_of_the_help(self):
        self.assertIn("grow", COMMANDS)
        texts = {shell: printed("completion", shell) for shell in ("bash", "zsh", "fish")}
        man = printed("completion", "--man").replace("\\-", "-")
        for command in COMMANDS:
            for option in help_options(command):
                with self.subTest(command=command, option=option):
                    self.assertIn(option, texts["bash"])
                    self.assertIn(f"*{option}[", texts["zsh"])
                    self.assertIn(f" -l {option[2:]}", texts["fish"])
                    self.assertIn(f"\\fB{option}\\fR", man)

    def test_bash_completes(self):
        self.assertEqual(sorted(self.offered("gr")), ["graph", "grow"])
        self.assertEqual(self.offered("gro"), ["grow"])
        self.assertEqual(self.offered("grow", "--see"), ["--seed"])
        self.assertEqual(self.offered("completion", "z"), ["zsh"])
        self.assertIn("oak", self.offered("grow", "oa"))
        open(os.path.join(self.folder, "oaken.json"), "w", encoding="utf-8").close()
        self.assertEqual(sorted(self.offered("render", "oak")), ["oak", "oak-life", "oaken.json"])
        self.assertEqual(self.offered("grow", "oak", "-o", "oaken"), ["oaken.json"])
        self.assertEqual(self.offered("grow", "oak", "--seed", "oa"), [])

    def test_shells_accept_their_scripts(self):
        for shell in ("bash", "zsh", "fish"):
            if shutil.which(shell) is None:
                continue
            with self.subTest(shell=shell):
                checked = subprocess.run([shell, "-n", self.script(shell)], capture_output=True, text=True)
                self.assertEqual((checked.returncode, checked.stderr), (0, ""))

    def test_man_page_is_well_formed(self):
        page = printed("completion", "--man")
        self.assertTrue(page.startswith(".TH MERISTEM 1"))
        for command in COMMANDS:
            self.assertIn(f'.SS "meristem {command}', page)
        if shutil.which("groff") is None:
            return
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=page, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_refuses_other_shells(self):
        for arguments in (["completion"], ["completion", "tcsh"], ["completion", "bash", "--man"]):
            with self.subTest(arguments=arguments):
                self.assertEqual(run(*arguments).returncode, 2)


if __name__ == "__main__":
    unittest.main()

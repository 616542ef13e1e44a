#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The base of the command-line tests: a folder with two documents, and the built program, run in this folder.

A test file begins with `import cli_case`, which takes the program from the first argument.
"""

import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))

DONE, FAILED, WRONG_INPUT, PARTLY_DONE = 0, 1, 2, 3

TREE = """{
  "meristem": 1,
  "variables": {"points": 300},
  "components": {
    "tree": {"type": "colonize", "crown": {"profile": [[0.2, 0.5], [1, 1], [0.2, 2]]}, "points": "points",
             "step": 0.05, "influence": 0.5, "kill": 0.15},
    "leaf": {"type": "leaf", "length": "0.05*(1 + 0.3*gauss(0,1))"}
  },
  "links": [{"from": "tree", "to": "leaf", "kind": "branch", "density": 20}]
}"""

BOX = '{"meristem": 1, "components": {"box": {"type": "simple"}}}'

MTG = """CODE:\tFORM-A
CLASSES:
P\t1\tFREE\tFREE\tEXPLICIT
A\t2\tFREE\tFREE\tEXPLICIT
S\t3\tFREE\tFREE\tEXPLICIT
FEATURES:
XX\tREAL
YY\tREAL
ZZ\tREAL
Thickness\tREAL
MTG:
ENTITY-CODE\t\tXX\tYY\tZZ\tThickness
/P1
^/A1\t\t0\t0\t0\t400
^/S1\t\t0\t0\t200\t200
\t+A1/S1\t100\t0\t300\t120
^<S2\t\t0\t0\t400\t160
"""

# Enough work for a signal to arrive long before the end.
LONG_RENDER = ["--size", "600x600", "--samples", "2048"]
LONG_GROWTH = ["--set", "points=3000000", "--set", "tree.step=0.002", "--set", "tree.kill=0.002"]


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("tree.json", TREE)
        self.write("box.json", BOX)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())

    def resources(self, *arguments):
        """Runs the program without its output. Returns its exit code and what the system counted of the run (rusage)."""
        command = [PROGRAM, *arguments, "--quiet"]
        process = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        return process.returncode, usage

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_program(self, *arguments, **options):
        options.setdefault("stdin", subprocess.DEVNULL if "input" not in options else None)
        if options["stdin"] is None:
            del options["stdin"]
        options.setdefault("stdout", subprocess.PIPE)
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, stderr=subprocess.PIPE, timeout=300, **options)

    def start(self, *arguments, **options):
        options.setdefault("stderr", subprocess.PIPE)
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, **options)

    def assert_ends(self, code, *arguments, **options):
        """Runs the program and returns standard error. The folder must contain only the earlier files afterwards."""
        before = sorted(os.listdir(self.folder))
        done = self.run_program(*arguments, **options)
        errors = done.stderr.decode()
        self.assertEqual(done.returncode, code, errors)
        if code != DONE:
            self.assertEqual(sorted(os.listdir(self.folder)), before)
            self.assertNotEqual(errors, "")
        return errors

    def stop(self, signal_number, *arguments):
        """Sends the signal after the first line of progress, and returns standard error."""
        process = self.start(*arguments)
        first = process.stderr.readline()
        self.assertRegex(first.decode(), r"^[a-z ]+ \d+ %\n$", "a plain line of progress")
        process.send_signal(signal_number)
        errors = process.stderr.read().decode()
        self.assertEqual(process.wait(60), -signal_number, errors)
        process.stdout.close()
        process.stderr.close()
        return errors

    def assert_rejects(self, document, message):
        self.write("bad.json", document)
        for command in (["check"], ["grow", "-o", "out.glb"]):
            errors = self.assert_ends(WRONG_INPUT, command[0], "bad.json", *command[1:])
            self.assertIn(message, errors)

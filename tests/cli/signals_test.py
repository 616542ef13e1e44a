#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Signals and terminals: the state after a stopped command, and the progress bar.

Usage: signals_test.py PROGRAM [unittest options]
"""

import os
import pty
import re
import select
import signal
import time
import unittest

import cli_case
from cli_case import LONG_GROWTH, LONG_RENDER


class Signals(cli_case.Case):
    def test_render_leaves_nothing(self):
        before = sorted(os.listdir(self.folder))
        errors = self.stop(signal.SIGINT, "render", "tree.json", "-o", "a.png", *LONG_RENDER)
        self.assertIn("no file was left half-written", errors)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_growth_leaves_an_existing_file(self):
        self.write("a.glb", "before")
        before = sorted(os.listdir(self.folder))
        self.stop(signal.SIGTERM, "grow", "tree.json", "-o", "a.glb", *LONG_GROWTH)
        self.assertEqual(sorted(os.listdir(self.folder)), before)
        self.assertEqual(self.read("a.glb"), b"before")

    def test_measuring_leaves_nothing(self):
        before = sorted(os.listdir(self.folder))
        self.stop(signal.SIGINT, "measure", "tree.json", "-o", "a.txt", "--organs", "a.csv", *LONG_GROWTH)
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_reading_a_large_document_stops(self):
        leaf = '{"type": "leaf", "length": 0.1}'
        components = ", ".join(f'"c{k}": {leaf}' for k in range(300_000))
        text = '{"meristem": 1, "components": {' + components + "}}"
        # The document comes through a pipe, so that the signal is sent after the program has read all of it.
        pipe = os.path.join(self.folder, "large.json")
        os.mkfifo(pipe)
        process = self.start("check", "--quick", "large.json")
        with open(pipe, "w") as document:
            document.write(text)
        time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=10)
        self.assertEqual(process.returncode, -signal.SIGINT)

    def test_reading_large_files_stops(self):
        rows = range(400_000)
        mesh = "".join(f"v {k % 1000} {k // 1000} {k % 7}\n" for k in rows)
        mesh += "".join(f"f {k + 1} {k + 2} {k + 1001}\n" for k in rows[:-1001])
        table = "node,x,y,z,parent,radius\n" + "".join(f"{k},{k % 1000},{k // 1000},1,{k - 1},0.1\n" for k in rows)
        cases = {"m.obj": (mesh, '"scene": {"obstacles": [{"mesh": "m.obj", "broken": true}]}, '
                                 '"components": {"t": {"type": "tree"}}'),
                 "p.xyz": ("".join(f"{k % 1000} {k // 1000} {k % 7}\n" for k in rows),
                           '"components": {"t": {"type": "colonize", "points": {"file": "p.xyz"}}}'),
                 "n.csv": (table, '"components": {"t": {"type": "skeleton", "file": "n.csv"}}')}
        for name, (content, members) in cases.items():
            with self.subTest(name):
                self.write(name, content)
                self.write("d.json", '{"meristem": 1, ' + members + "}")
                begin = time.monotonic()
                self.assert_ends(0, "check", "--quick", "d.json")
                whole = time.monotonic() - begin
                stops = []
                for share in (0.3, 0.5, 0.7):
                    process = self.start("check", "--quick", "d.json")
                    time.sleep(share * whole)
                    sent = time.monotonic()
                    process.send_signal(signal.SIGINT)
                    process.communicate(timeout=60)
                    if process.returncode == -signal.SIGINT:
                        stops.append((time.monotonic() - sent) / whole)
                # At least one signal came while the program was reading. The median wait is far shorter than the run.
                self.assertTrue(stops and sorted(stops)[(len(stops) - 1) // 2] < 0.25, stops)

    def test_ignored_signals_stay_ignored(self):
        process = self.start("render", "tree.json", "-o", "a.png", *LONG_RENDER,
                             preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        process.stderr.readline()
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGTERM)

    def test_terminal_shows_a_bar_and_takes_it_away(self):
        ours, theirs = pty.openpty()
        process = self.start("render", "tree.json", "-o", "a.png", *LONG_RENDER, stderr=theirs)
        os.close(theirs)
        shown = b""
        deadline = time.monotonic() + 120
        while not re.search(rb"rendering +\[=* *\] +\d+ %", shown) and time.monotonic() < deadline:
            if select.select([ours], [], [], 1)[0]:
                shown += os.read(ours, 4096)
        self.assertRegex(shown, rb"\r\x1b\[Krendering +\[=* *\] +\d+ %")
        process.send_signal(signal.SIGINT)
        try:
            while piece := os.read(ours, 4096):
                shown += piece
        except OSError:  # the end of a terminal on Linux
            pass
        os.close(ours)
        process.stdout.close()
        self.assertEqual(process.wait(60), -signal.SIGINT)
        self.assertRegex(shown, rb"\r\x1b\[Kmeristem: stopped")


if __name__ == "__main__":
    unittest.main()

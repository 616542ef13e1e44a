# SPDX-License-Identifier: Apache-2.0
"""Every shipped model opens in the studio: one page opens them one after another and waits for each picture at rest.

In:  the program; the program that compares messages with the protocol; with `--times`, a line for
     each model says how long its pictures took.
"""

from __future__ import annotations

import sys
import tempfile
import time
import unittest
from pathlib import Path
from typing import Any

from studio_client import Page, Studio, check_recorded

PROGRAM, PROTOCOL = sys.argv[1], sys.argv[2]
SHOWS_TIMES = "--times" in sys.argv


class ModelsTest(unittest.TestCase):
    def test_each_model_shows_itself_and_nothing_of_the_model_before(self) -> None:
        with tempfile.TemporaryDirectory() as folder, Studio(PROGRAM, Path(folder)) as studio, studio.page() as page:
            names = [model["name"] for model in page.ask("models")["models"]]
            self.assertGreater(len(names), 60)
            for name in names:
                with self.subTest(name):
                    self.open(page, name)
            self.assertEqual(check_recorded(PROTOCOL, Path(folder)), [])

    def open(self, page: Page, name: str) -> None:
        begin = time.monotonic()
        answer = page.ask("open", model=name)
        self.assertEqual((answer["is"], answer.get("good")), ("done", True), answer.get("faults"))
        page.messages.clear()
        page.packets.clear()
        first: dict[str, Any] | None = None
        while first is None or first["draft"]:
            count = len(page.packets)
            message = page.receive()
            self.assertFalse(message is not None and message["is"] == "failed", message)
            if len(page.packets) == count:
                continue
            head = page.packets[-1][0]
            self.assertEqual(head["hash"], answer["hash"], "a packet shows another document")
            if first is None:
                self.assertTrue(head["whole"] and head["fit"], "the first packet keeps something of the model before")
                self.assertGreater(head["triangles"], 0)
                first_seconds = time.monotonic() - begin
            self.check_components(head, answer["tree"])
            first = head
        if SHOWS_TIMES:
            print(f"{name:<20} {first_seconds:7.2f} s {time.monotonic() - begin:7.2f} s {first['triangles']:>8} triangles")

    def check_components(self, head: dict[str, Any], tree: dict[str, Any]) -> None:
        """Checks that the drawn components are components or obstacles of the document. The first name of a path such as
        "oak.leaf" is the component that places a plant of another document."""
        drawn = {batch["component"].split(".")[0] for batch in head.get("batches", [])
                 if not batch["component"].startswith("scene.obstacles[")}  # fmt: skip
        self.assertLessEqual(drawn, set(tree["components"]))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])

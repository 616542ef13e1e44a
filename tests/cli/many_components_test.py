#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Documents of many components grow in time in proportion to their number, however they are linked."""

import json
import unittest

import cli_case


def one_below_all(count):
    """Returns links from one component to all others."""
    return [["c0", f"c{k}"] for k in range(1, count)]


def ten_below_each(count):
    """Returns the links of a hierarchy in which ten components stand on each."""
    return [[f"c{(k - 1) // 10}", f"c{k}"] for k in range(1, count)]


class ManyComponentsTest(cli_case.Case):
    def seconds(self, name):
        """Returns the processor time of growing a document, seconds."""
        code, usage = self.resources("check", name)
        self.assertEqual(code, cli_case.DONE)
        return usage.ru_utime

    def test_ten_times_as_many_take_ten_times_as_long(self):
        for links in (one_below_all, ten_below_each):
            with self.subTest(links=links.__name__):
                times = []
                for count in (3_000, 30_000):
                    components = {f"c{k}": {"type": "leaf", "length": 0.1} for k in range(count)}
                    document = {"meristem": 1, "components": components, "links": links(count)}
                    self.write("many.json", json.dumps(document))
                    times.append(self.seconds("many.json"))
                self.assertLess(times[1], 25 * times[0])  # in proportion to the square: 100


if __name__ == "__main__":
    unittest.main()

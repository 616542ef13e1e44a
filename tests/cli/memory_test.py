#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Peak memory of growth, as reported by the system. It does not depend on the speed of the program."""

import unittest

import cli_case

BUSH = """{
  "meristem": 1,
  "components": {
    "field": {"type": "field", "rows": 20, "plants": %d},
    "star": {"type": "hydra", "number": 50},
    "crown": {"type": "hydra", "number": 20},
    "leaf": {"type": "leaf"}
  },
  "links": [["field", "star"], ["star", "crown"], ["crown", "leaf"]]
}"""

NESTED = """{
  "meristem": 1,
  "components": {
    "a": {"type": "simple", "recursion": 100}, "b": {"type": "simple", "recursion": 100},
    "c": {"type": "simple", "recursion": 100}, "d": {"type": "simple", "recursion": 100}
  },
  "links": [["a", "b"], ["b", "c"], ["c", "d"], ["d", "d"], ["d", "c"], ["d", "b"], ["d", "a"]]
}"""


class MemoryTest(cli_case.Case):
    def peak(self, *arguments):
        """Returns the exit code and the peak memory of one run in bytes."""
        code, usage = self.resources(*arguments)
        return code, 1024 * usage.ru_maxrss

    def test_an_instance_takes_less_than_200_bytes(self):
        peaks = []
        for plants in (10, 60):  # 200,000 and 1,200,000 leaves
            self.write("bush.json", BUSH % plants)
            code, peak = self.peak("grow", "bush.json", "-o", "bush.csv")
            self.assertEqual(code, cli_case.DONE)
            peaks.append(peak)
        self.assertLess((peaks[1] - peaks[0]) / 1_000_000, 200)

    def test_nested_recursions_are_refused_before_memory_is_spent(self):
        self.write("nested.json", NESTED)
        code, peak = self.peak("grow", "nested.json", "-o", "nested.csv")
        self.assertEqual(code, cli_case.WRONG_INPUT)
        self.assertLess(peak, 400_000_000)


if __name__ == "__main__":
    unittest.main()

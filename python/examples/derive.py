# SPDX-License-Identifier: Apache-2.0
"""Grammars (L-systems): words, their letters as arrays, and queries on them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import meristem

KOCH = """
#define angle = 60
#axiom
F(1)
#rules
F(x) -> F(x/3)+(angle)F(x/3)-(2*angle)F(x/3)+(angle)F(x/3)
"""

word = meristem.derive(KOCH, 1)
print("one step:", word)

# Letters and parameters are arrays over the word's memory: here the path that they draw in the plane.
word = meristem.derive(KOCH, 8)
print("eight steps:", word.counts)
symbols = np.array([symbol for symbol, arity in word.alphabet])[word.letters]
turns = np.select([symbols == "+", symbols == "-"], [word.parameters, -word.parameters])  # each has one parameter
steps = np.where(symbols == "F", word.parameters, 0) * np.exp(1j * np.radians(np.cumsum(turns)))
path = np.cumsum(steps)
print(f"it ends at {path[-1].real:.3f}, rises to {path.imag.max():.3f} and is {np.abs(steps).sum():.3f} long")

# Another angle with the same text.
print("at right angles:", meristem.derive(KOCH, 1, constants={"angle": 90}))

# A stochastic grammar in a file: each seed gives another word.
file = Path("bush.txt")
file.write_text("""#steps 7
A
A : * : 2 -> F[+A][-A]A
A : * : 1 -> FA
#interpret
A -> L
""")
for seed in (1, 2, 3):
    counts = meristem.derive(file, seed=seed, drawn=True).counts
    print(f"seed {seed}: {counts['F']} internodes, {counts['L']} leaves")

# SPDX-License-Identifier: Apache-2.0
"""Progress, cancelling and errors, which all long calls share."""

from __future__ import annotations

import threading
import time

import meristem

document = meristem.read("oak", set={"age": 60})

# A call reports its stage and its finished share to its `progress` function.
stages: dict[str, int] = {}


def count_stages(stage: str, fraction: float) -> None:
    stages[stage] = stages.get(stage, 0) + 1


document.grow(progress=count_stages)
print("stages:", ", ".join(stages))

# Other threads can read a Progress and cancel it, because they run during growth.
progress = meristem.Progress()
threading.Timer(0.02, progress.cancel).start()
begin = time.perf_counter()
try:
    document.grow(progress=progress)
    print("grown before it was cancelled")
except meristem.Cancelled:
    print(f"cancelled while {progress.stage or 'beginning'}, after {time.perf_counter() - begin:.2f} s")

# Errors give the position, the fault, and the nearest valid name.
try:
    document.set({"leaf.lenght": 0.1})
except meristem.InputError as error:
    for diagnostic in error.diagnostics:
        print(f"{diagnostic.path}: {diagnostic.message}; did you mean '{diagnostic.nearest}'?")

# SPDX-License-Identifier: Apache-2.0
"""Documents: reading, setting values, writing, and faults."""

from __future__ import annotations

import tempfile
from pathlib import Path

import meristem

print("shipped:", ", ".join(meristem.models()))

oak = meristem.read("oak")
print(oak, "-", oak.description)
for variable in oak.variables:
    if variable.private:
        continue  # a name for a value that expressions share, and no handle
    values = f"{variable.value:g} {variable.unit} ({variable.min:g} to {variable.max:g})"
    print(f"  {variable.name} = {values}: {variable.doc}")

# A document never changes; set() returns another document.
old = oak.set({"age": 120, "leaf.length": 0.12}, seed=3)
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "old_oak.json"
    old.save(path)
    assert meristem.read(path).to_dict() == old.to_dict()
    print(f"{path.name}: {path.stat().st_size} bytes")

# The error lists all faults at once, with their paths.
content = old.to_dict()
content["components"]["tree"]["pionts"] = 12
content["links"][1]["to"] = "laef"
try:
    meristem.Document(content)
except meristem.InputError as error:
    print(error)

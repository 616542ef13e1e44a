# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of docstrings: all indented code of a docstring as one program, in a separate folder."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Iterator

import numpy as np
import pytest

import meristem
from meristem import grass

#: Classes whose docstrings must have an example, besides those that have one by chance.
MAIN = ["BatchResult", "Dataset", "DatasetPlan", "Document", "FitResult", "Mesh", "Organs", "Plant", "Progress",
        "Scene", "Session", "Skeleton", "Target", "Trace", "Word", "grass", "meristem"]


def documented() -> Iterator[tuple[str, str]]:
    """Yields name and docstring of the modules, and of all public names and their members."""
    for module in (meristem, grass):
        yield module.__name__.rsplit(".", 1)[-1], inspect.cleandoc(module.__doc__ or "")
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.ismodule(value) or isinstance(value, str):
                continue
            yield name, inspect.cleandoc(value.__doc__ or "")
            members = [key for key in vars(value) if not key.startswith("_")] if inspect.isclass(value) else []
            for key in members:
                yield f"{name}.{key}", inspect.cleandoc(getattr(value, key).__doc__ or "")


def code_of(docstring: str) -> str:
    lines = [line[4:] for line in docstring.splitlines() if line.startswith("    ") or not line]
    return "\n".join(lines).strip()


EXAMPLES = {name: code for name, docstring in documented() if (code := code_of(docstring))}


def test_main_classes_have_an_example() -> None:
    assert [name for name in MAIN if name not in EXAMPLES] == []


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_the_example_runs(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    exec(compile(EXAMPLES[name], f"the docstring of {name}", "exec"), {"meristem": meristem, "np": np})

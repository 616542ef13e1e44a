# SPDX-License-Identifier: Apache-2.0
"""Runs the code blocks of the manual's pages on Python: all blocks of a page as one program, in a separate folder."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import meristem
import pytest
from meristem._page import has_viewer

MANUAL = Path(__file__).resolve().parents[2] / "docs" / "manual"
LEFT_OUT = ("# a file of yours", "# a package of yours")
PAGES = ".save_html("  # blocks with it need the view of pages, which is not built without node


def program_of(page: Path) -> str:
    """Returns the page's blocks at their original line numbers. Omits blocks that need a user's file or package."""
    program: list[str] = []
    block: list[str] | None = None
    for line in page.read_text().splitlines():
        if block is None:
            block = [] if line == "```python" else None
            program.append("")
        elif line == "```":
            is_left_out = any(mark in block for mark in LEFT_OUT)
            is_left_out |= not has_viewer() and any(PAGES in line for line in block)
            program += [""] * len(block) if is_left_out else block
            program.append("")
            block = None
        else:
            block.append(line)
    assert block is None, f"a block of {page.name} does not end"
    return "\n".join(program) + "\n"


@pytest.mark.parametrize("name", ["python", "python-batches", "python-fits", "many-plants", "pruning"])
def test_the_examples_of_the_page_run(name: str, tmp_path: Path) -> None:
    program = program_of(MANUAL / f"{name}.md")
    assert "meristem." in program
    (tmp_path / f"{name}.py").write_text(program)
    hidden = {"DISPLAY", "WAYLAND_DISPLAY"}  # no program must open
    environment = {name: value for name, value in os.environ.items() if name not in hidden}
    environment["PYTHONPATH"] = str(Path(meristem.__file__).parents[1])
    run = subprocess.run(
        [sys.executable, "-B", f"{name}.py"], cwd=tmp_path, env=environment, capture_output=True, text=True
    )
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.strip()


def test_only_blocks_that_need_a_file_are_left_out(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    blocks = "```python\na = 1\n```\n```python\n# a file of yours\nb = 2\n```\n```sh\nc\n```\n```python\nd\n```\n"
    page.write_text("Text\n" + blocks)
    assert program_of(page).split("\n") == ["", "", "a = 1", "", "", "", "", "", "", "", "", "", "d", "", ""]


def blocks_of(page: Path, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)


def test_programs_for_clusters_are_well_formed() -> None:
    """Programs that need a cluster are not run. They must compile, and the shell must be able to parse its scripts."""
    page = MANUAL / "many-plants.md"
    programs = [block for block in blocks_of(page, "python") if any(mark in block for mark in LEFT_OUT)]
    assert len(programs) == 3
    for program in programs:
        compile(program, page.name, "exec")
    scripts = [block for block in blocks_of(page, "sh") if "#SBATCH" in block]
    assert len(scripts) == 1
    for script in scripts:
        read = subprocess.run(["sh", "-n"], input=script, capture_output=True, text=True)
        assert (read.returncode, read.stderr) == (0, "")

# SPDX-License-Identifier: Apache-2.0
"""Data sets: making, continuing, checking, reading."""

from __future__ import annotations

import csv
import json
import pickle
import shutil
import sys
import types
from pathlib import Path
from typing import Any

import meristem
import numpy as np
import pytest

from datasets import digest, plan, python, rod


def test_a_plan_makes_files_rows_and_a_card(tmp_path: Path) -> None:
    made = meristem.dataset(rod(), plan(6, name="Rods"), tmp_path / "rods", processes=1)
    assert (made.plants, made.found, made.faults) == (6, 0, ())
    rows = list(made.rows())
    assert [row["key"] for row in rows] == [f"{k:06}" for k in range(6)]
    assert [row["seed"] for row in rows] == ["1", "2", "3", "4", "5", "6"]
    for row in rows:
        assert 0.5 <= float(row["tall"]) <= 2
        assert float(row["height"]) == pytest.approx(float(row["tall"]), rel=0.1)
        assert (made.folder / row["files"]).stat().st_size == int(row["bytes"])
    assert "# Rods" in (made.folder / "README.md").read_text()
    assert made.verify() == []


def test_values_are_those_that_the_plan_tells(tmp_path: Path) -> None:
    read = meristem.DatasetPlan({"meristem_dataset": 1, **plan(3)}, documents={"rod": rod()})
    assert len(read) == 3
    made = meristem.dataset(None, read, tmp_path / "rods", processes=1)
    for number, row in enumerate(made.rows()):
        planned = read.plant(number)
        assert (row["key"], int(row["seed"])) == (planned["key"], planned["seed"])
        assert float(row["tall"]) == planned["values"]["tall"]
        alone = rod().set(planned["values"], seed=planned["seed"]).grow()
        assert float(row["height"]) == alone.measure()["height"]
    with pytest.raises(IndexError, match="3 plants"):
        read.plant(3)


def test_a_plan_travels_by_content(tmp_path: Path) -> None:
    (tmp_path / "points.csv").write_text("x,z\n0,0\n2,0\n")
    (tmp_path / "row.json").write_text(
        json.dumps(
            {
                "meristem": 1,
                "components": {
                    "row": {"type": "places", "table": "points.csv"},
                    "rod": {"type": "tree", "length": 1, "radius": 0.02},
                },
                "links": [["row", "rod"]],
            }
        )
    )
    document = meristem.read(tmp_path / "row.json")
    name, files = document.bundle()
    assert name == "row.json" and [path for path, _ in files] == ["points.csv", "row.json"]
    pickled = pickle.dumps(meristem.DatasetPlan({"meristem_dataset": 1, "measures": ["trees"]}, documents={"row": document}))
    (tmp_path / "points.csv").unlink()  # another machine does not have this file
    made = meristem.dataset(None, pickle.loads(pickled), tmp_path / "rows", processes=1)
    assert [row["trees"] for row in made.rows()] == ["2"]


def test_own_processes_make_the_same_bytes(tmp_path: Path) -> None:
    meristem.dataset(rod(), plan(120), tmp_path / "one", processes=1)
    meristem.dataset(rod(), plan(120), tmp_path / "two", processes=2)
    assert digest(tmp_path / "one") == digest(tmp_path / "two")


def test_goes_on_with_what_is_there_and_right(tmp_path: Path) -> None:
    meristem.dataset(rod(), plan(20), tmp_path / "rods", processes=1)
    before = digest(tmp_path / "rods")
    (tmp_path / "rods/plants/0000/000007.csv").unlink()
    made = meristem.dataset(rod(), plan(20), tmp_path / "rods", processes=1)
    assert (made.found, len(made.faults)) == (19, 1)
    assert made.faults[0].endswith("000007.csv is missing")
    assert digest(tmp_path / "rods") == before
    path = tmp_path / "rods/plants/0000/000003.csv"
    path.write_bytes(path.read_bytes()[:-2] + b"9\n")
    assert [fault.rsplit(maxsplit=7)[0] for fault in made.verify()] == [str(path)]
    assert meristem.dataset(rod(), plan(20), tmp_path / "rods", processes=1).found == 20
    assert meristem.dataset(rod(), plan(20), tmp_path / "rods", processes=1, repair=True).found == 19
    assert digest(tmp_path / "rods") == before
    with pytest.raises(meristem.InputError, match="holds a data set already"):
        meristem.dataset(rod(), plan(20), tmp_path / "rods", resume=False)


def test_verify_finds_each_changed_value_and_repair_puts_it_back(tmp_path: Path) -> None:
    rods = tmp_path / "rods"
    meristem.dataset(rod(), plan(20), rods, processes=1)
    before = digest(rods)
    table = rods / "manifest/00000.csv"
    row = next(csv.DictReader(table.open()))
    npz = (rods / "manifest.npz").read_bytes()
    damages: list[tuple[Path, bytes, str]] = [
        (table, table.read_bytes().replace(row["height"].encode(), b"1.5", 1), ":2: row 000000, column 'height' ('1.5')"),
        (table, table.read_bytes().replace(row["tall"].encode(), b"1.5", 1), "column 'tall': '1.5' has changed"),
        (rods / "manifest.npz", npz[:-1] + b"x", "has other bytes than were written"),
    ]
    for path, damaged, message in damages:
        path.write_bytes(damaged)
        faults = meristem.open_dataset(rods).verify()
        assert len(faults) == 1 and faults[0].startswith(str(path)) and message in faults[0]
        made = meristem.dataset(rod(), plan(20), rods, processes=1, repair=True)
        assert made.faults and made.verify() == []
        assert digest(rods) == before


def test_tables_without_hashes_are_a_fault_unless_they_are_allowed(tmp_path: Path) -> None:
    made = meristem.dataset(rod(), plan(3), tmp_path / "rods", processes=1)
    info = json.loads((made.folder / "dataset.json").read_text())
    for name in ("files", "tables", "hash"):
        del info[name]
    del info["documents"][0]["files"]
    info["meristem_dataset_folder"] = 1
    (made.folder / "dataset.json").write_text(json.dumps(info))
    shutil.rmtree(made.folder / "checks")
    faults = made.verify()
    assert len(faults) == 1 and "the tables could not be checked" in faults[0]
    assert meristem.verify_dataset(made.folder)["faults"] == faults
    with pytest.warns(UserWarning, match="the tables could not be checked"):
        assert made.verify(allow_old=True) == []
    made = meristem.dataset(rod(), plan(3), tmp_path / "rods", processes=1)
    assert made.found == 3 and made.verify() == []


def test_a_check_reads_nothing_outside_the_root(tmp_path: Path) -> None:
    made = meristem.dataset(rod(), plan(3), tmp_path / "sets/rods", processes=1)
    assert meristem.verify_dataset(made.folder, root=tmp_path / "sets")["faults"] == []
    assert made.verify(root=tmp_path / "sets") == []
    with pytest.raises(meristem.InputError, match="lies outside the folder that may be read"):
        meristem.verify_dataset(made.folder, root=made.folder / "plants")
    file = made.folder / "plants/0000/000001.csv"
    shutil.move(file, tmp_path / "moved.csv")
    file.symlink_to(tmp_path / "moved.csv")
    assert made.verify() == []
    with pytest.raises(meristem.InputError, match="leads outside the folder that may be read") as raised:
        made.verify(root=tmp_path / "sets")
    assert raised.value.diagnostics[0].file == str(file)


def test_a_killed_program_leaves_no_temporary_files(tmp_path: Path) -> None:
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    program = (
        "import os, sys, tempfile; tempfile.tempdir = sys.argv[1]\n"
        "import meristem; from meristem._core import ScratchFolder\n"
        "kept = ScratchFolder(sys.argv[1], 'meristem-'); print(kept.path, flush=True)\n"
        "if len(sys.argv) > 2: os._exit(0)\n"
    )
    killed = python("-c", program, str(scratch), "killed", folder=tmp_path)
    path, _ = killed.communicate(timeout=60)
    assert Path(path.strip()).is_dir()
    python("-c", program, str(scratch), folder=tmp_path).communicate(timeout=60)
    assert list(scratch.iterdir()) == []


def test_refuses_another_plan_and_an_edited_document(tmp_path: Path) -> None:
    meristem.dataset(rod(), plan(3), tmp_path / "rods", processes=1)
    before = digest(tmp_path / "rods")
    with pytest.raises(meristem.InputError, match="another plan"):
        meristem.dataset(rod(), plan(4), tmp_path / "rods")
    edited = meristem.Document({**rod().to_dict(), "description": "Other"})
    with pytest.raises(meristem.InputError, match="has changed since"):
        meristem.dataset(edited, plan(3), tmp_path / "rods")
    assert digest(tmp_path / "rods") == before


def test_failed_plants_are_rows_with_their_error(tmp_path: Path) -> None:
    with pytest.warns(UserWarning, match="rods: 2 of 4 plants written, 2 failed: 000002: .*nodes"):
        made = meristem.dataset(rod(), plan(2, grid={"limits.nodes": [100, 2]}), tmp_path / "rods", processes=1)
    assert made.failed == 2 and [line[:8] for line in made.failures] == ["000002: ", "000003: "]
    again = meristem.open_dataset(tmp_path / "rods")
    assert (again.failed, again.failures) == (made.failed, made.failures)
    errors = [row["error"] for row in made.rows()]
    assert errors[:2] == ["", ""] and all("nodes" in error for error in errors[2:])
    table = made.table()
    assert np.isnan(table["height"][2:]).all() and not np.isnan(table["height"][:2]).any()
    assert "of them failed | 2" in (made.folder / "README.md").read_text()


def test_tables_are_arrays(tmp_path: Path) -> None:
    made = meristem.dataset(
        {"short": rod(), "long": rod().set({"tall": 2})},
        {"seeds": [3], "measures": ["height"], "samples": [{"rod.radius": 0.01}, {"rod.radius": 0.02}]},
        tmp_path / "rods",
        processes=1,
    )
    table = made.table()
    assert list(table["document"]) == ["short", "short", "long", "long"]
    assert list(table["rod.radius"]) == [0.01, 0.02, 0.01, 0.02]
    assert table["height"][2] > 1.5 * table["height"][0]
    with np.load(tmp_path / "rods/manifest.npz") as arrays:
        assert list(arrays["height"]) == list(table["height"])
    again = meristem.open_dataset(tmp_path / "rods")
    assert again.plants == 4 and (again.table() == table).all()
    with pytest.raises(meristem.InputError, match="no data set"):
        meristem.open_dataset(tmp_path)


def test_a_library_for_parquet_gets_all_columns(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Debian has no pyarrow, so a stand-in records its inputs."""
    made = meristem.dataset(rod(), plan(2), tmp_path / "rods", processes=1)
    library, writer = types.ModuleType("pyarrow"), types.ModuleType("pyarrow.parquet")

    def write_table(columns: dict[str, Any], path: Path) -> None:
        path.write_text(json.dumps({name: list(column) for name, column in columns.items()}))

    setattr(library, "table", dict)
    setattr(writer, "write_table", write_table)
    with monkeypatch.context() as context:
        context.setitem(sys.modules, "pyarrow", None)
        with pytest.raises(ImportError):
            made.save_parquet(tmp_path / "rods.parquet")
        context.setitem(sys.modules, "pyarrow", library)
        context.setitem(sys.modules, "pyarrow.parquet", writer)
        made.save_parquet(tmp_path / "rods.parquet")
    columns = json.loads((tmp_path / "rods.parquet").read_text())
    rows = list(made.rows())
    assert set(columns) == set(rows[0])
    assert columns["height"] == [float(row["height"]) for row in rows]
    assert columns["files"] == [row["files"] for row in rows]
    assert not list(tmp_path.glob("*.partial"))


def test_faults_of_a_plan_have_their_places(tmp_path: Path) -> None:
    path = tmp_path / "plan.json"
    path.write_text('{"meristem_dataset": 1,\n "seedz": 3, "files": [".glb"]}')
    with pytest.raises(meristem.InputError) as caught:
        meristem.dataset(rod(), path, tmp_path / "rods")
    fault = caught.value.diagnostics[0]
    assert (fault.file, fault.line, fault.nearest) == (str(path), 2, "seeds")
    assert not (tmp_path / "rods").exists()
    for wrong, message in [
        ({"plan": 3}, "plan must be a dict"),
        ({"documents": 3}, "documents must be a Document"),
        ({"executor": 3}, "must be a concurrent.futures.Executor"),
        ({"progress": 3}, "progress must be"),
    ]:
        arguments = {"documents": rod(), "plan": plan(1), "folder": tmp_path / "rods", **wrong}
        with pytest.raises(TypeError, match=message):
            meristem.dataset(**arguments)  # type: ignore[arg-type]


def test_progress_tells_plants_and_words(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told: list[tuple[int, int | None]] = []
    meristem.dataset(rod(), plan(30), tmp_path / "a", processes=1, progress=lambda *both: told.append(both))
    assert told[-1] == (30, 30) and told == sorted(told)
    meristem.dataset(rod(), plan(30), tmp_path / "b", processes=1, progress=True)
    assert capsys.readouterr().err.splitlines()[-1] == "30 of 30 plants"


def test_opens_only_what_is_finished(tmp_path: Path) -> None:
    with pytest.raises(meristem.InputError, match="holds no data set"):
        meristem.open_dataset(tmp_path)
    meristem.dataset(rod(), {**plan(20), "rows": 5}, tmp_path / "rods", processes=1)
    assert meristem.open_dataset(tmp_path / "rods").plants == 20
    (tmp_path / "rods/manifest/00002.csv").unlink()
    with pytest.raises(meristem.InputError, match="15 of 20 plants"):
        meristem.open_dataset(tmp_path / "rods")


def test_refuses_an_unknown_way_to_open(tmp_path: Path) -> None:
    made = meristem.DatasetPlan({"meristem_dataset": 1, "measures": ["height"]}, documents={"rod": rod()})
    with pytest.raises(ValueError, match="expected resume, repair or fresh"):
        meristem.DatasetFolder(made, tmp_path / "rods", opening="mend")
    assert not (tmp_path / "rods").exists()

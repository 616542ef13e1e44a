# SPDX-License-Identifier: Apache-2.0
"""The files that the build backend packs, and its messages for missing files. Compiles nothing."""

from __future__ import annotations

import csv
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from base64 import urlsafe_b64encode
from pathlib import Path

import pytest

import meristem
from meristem import _core

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(_core.__file__).resolve().parents[2]

sys.path.insert(0, str(ROOT / "python"))
import build_backend  # noqa: E402
sys.path.pop(0)


def built_wheel(folder: Path) -> Path:
    """Builds a wheel with a placeholder for the library, because the real library takes seconds to pack."""
    library = folder / "build" / "python" / "meristem" / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
    library.parent.mkdir(parents=True, exist_ok=True)
    library.write_bytes(b"library")
    return folder / "wheels" / build_backend.build_wheel(str(folder / "wheels"), {"build-dir": str(folder / "build")})


def test_the_record_lists_every_file_with_its_hash(tmp_path: Path) -> None:
    with zipfile.ZipFile(built_wheel(tmp_path)) as wheel:
        record = f"meristem-{meristem.__version__}.dist-info/RECORD"
        rows = {path: (digest, size) for path, digest, size in csv.reader(wheel.read(record).decode().splitlines())}
        assert sorted(rows) == sorted(wheel.namelist())
        assert rows.pop(record) == ("", "")
        for path, (digest, size) in rows.items():
            content = wheel.read(path)
            sum_of_it = urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
            assert (digest, size) == (f"sha256={sum_of_it}", str(len(content)))


def test_the_wheel_holds_types_models_and_licence(tmp_path: Path) -> None:
    with zipfile.ZipFile(built_wheel(tmp_path)) as wheel:
        names = wheel.namelist()
    info = f"meristem-{meristem.__version__}.dist-info"
    assert {"meristem/__init__.py", "meristem/_core.pyi", "meristem/py.typed", f"{info}/LICENSE"} <= set(names)
    assert {f"meristem/models/{name}.json" for name in meristem.models()} <= set(names)
    assert {f"meristem/models/{file.name}" for file in (ROOT / "models").glob("*.obj")} <= set(names)
    assert not [name for name in names if "__pycache__" in name or name.startswith("/")]


def test_the_wheel_holds_the_view_that_the_build_has_made(tmp_path: Path) -> None:
    with zipfile.ZipFile(built_wheel(tmp_path / "without")) as wheel:
        assert "meristem/viewer.html" not in wheel.namelist()
    page = tmp_path / "with" / "build" / "python" / "meristem" / "viewer.html"
    page.parent.mkdir(parents=True)
    page.write_text("view")
    with zipfile.ZipFile(built_wheel(tmp_path / "with")) as wheel:
        assert wheel.read("meristem/viewer.html") == b"view"


def test_equal_sources_give_equal_bytes(tmp_path: Path) -> None:
    first, second = built_wheel(tmp_path / "a"), built_wheel(tmp_path / "b")
    assert first.name == second.name
    assert first.read_bytes() == second.read_bytes()
    archives = [folder / build_backend.build_sdist(str(folder)) for folder in (tmp_path / "a", tmp_path / "b")]
    assert archives[0].read_bytes() == archives[1].read_bytes()


def test_nothing_half_written_is_left(tmp_path: Path) -> None:
    wheel = built_wheel(tmp_path)
    assert list(wheel.parent.iterdir()) == [wheel]


def test_prepared_metadata_are_those_of_the_wheel(tmp_path: Path) -> None:
    folder = build_backend.prepare_metadata_for_build_wheel(str(tmp_path))
    with zipfile.ZipFile(built_wheel(tmp_path)) as wheel:
        assert (tmp_path / folder / "METADATA").read_bytes() == wheel.read(f"{folder}/METADATA")
    assert f"\nVersion: {meristem.__version__}\n" in (tmp_path / folder / "METADATA").read_text(encoding="utf-8")


def test_the_source_archive_holds_what_the_build_reads(tmp_path: Path) -> None:
    with tarfile.open(tmp_path / build_backend.build_sdist(str(tmp_path))) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames()}
    rooms = re.findall(r"^add_subdirectory\((\w+)\)", (ROOT / "meristem" / "CMakeLists.txt").read_text(), re.MULTILINE)
    assert {f"meristem/{room}/CMakeLists.txt" for room in rooms} <= names
    assert {"PKG-INFO", "pyproject.toml", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "python/build_backend.py",
            "python/bindings/module.cpp", "python/meristem/_core.pyi", "models/oak.json"} <= names
    assert not [name for name in names if "__pycache__" in name or name.startswith(("build/", "out/"))]


def test_missing_tools_are_named_with_their_packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(SystemExit, match="cmake and ninja-build and pkg-config and g\\+\\+ must be installed") as error:
        build_backend.build_wheel(str(tmp_path))
    assert "pybind11-dev" in str(error.value)


def test_a_folder_without_the_library_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="is not there; was .* built with MERISTEM_PYTHON_MODULE=ON"):
        build_backend.build_wheel(str(tmp_path), {"build-dir": str(tmp_path)})


def test_an_editable_install_takes_the_source_trees_files(tmp_path: Path) -> None:
    """In the build tree, the package consists of links to the source tree's files."""
    with zipfile.ZipFile(tmp_path / build_backend.build_editable(str(tmp_path), {"build-dir": str(BUILD)})) as wheel:
        wheel.extractall(tmp_path / "site")
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    use = f"import site; site.addsitedir({str(tmp_path / 'site')!r}); import meristem; print(meristem.__file__)"
    printed = subprocess.run([sys.executable, "-B", "-c", use], cwd=tmp_path, env=environment, capture_output=True,
                             text=True, check=True).stdout
    assert Path(printed.strip()).resolve() == ROOT / "python" / "meristem" / "__init__.py"


def test_dev_installs_the_packages_that_the_backend_names() -> None:
    text = (ROOT / "dev").read_text(encoding="utf-8")
    lists = dict(re.findall(r"^(\w+)_packages=\(([^)]*)\)", text, re.MULTILINE))
    of_the_program_alone = {"ccache", "libcli11-dev", "libboost-dev", "zlib1g-dev"}
    expected = set(lists["build"].split()) - of_the_program_alone | set(lists["python"].split())
    assert set(build_backend.DEBIAN_PACKAGES) == expected

# SPDX-License-Identifier: Apache-2.0
"""Builds the Python package: the functions that pip calls for `pip install .` (PEP 517 and 660).

In: the source tree, and the compilers and libraries of Debian's packages. The backend uses only the standard library
     and fetches nothing: pip hides all other packages from a backend, and the machine may have no network.
Out: a wheel, a source archive, or an editable install. Equal sources give equal bytes.

CMake builds in build/pip-<Python's tag>, which is kept, so that a second install compiles only what has changed.
`pip install --config-settings build-dir=DIR .` compiles nothing and uses the library in DIR.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path
from typing import Mapping, Optional, Sequence, Union

Settings = Optional[Mapping[str, Union[str, Sequence[str]]]]
Members = dict[str, bytes]  # the content of an archive, by path

ROOT = Path(__file__).resolve().parents[1]
TOOLS = {"cmake": "cmake", "ninja": "ninja-build", "pkg-config": "pkg-config", "c++": "g++"}
DEBIAN_PACKAGES = (
    "g++ cmake ninja-build pkg-config libglm-dev libfmt-dev nlohmann-json3-dev libtbb-dev libxxhash-dev "
    "librandom123-dev libembree-dev libjpeg-dev libpng-dev libturbojpeg0-dev libqhull-dev pybind11-dev "
    "python3-dev python3-numpy"
).split()
SOURCE_PARTS = (
    "CMakeLists.txt", "CMakePresets.json", "LICENSE", "NOTICE", "README.md", "cmake", "meristem", "models",
    "pyproject.toml", "python",
)
METADATA = """\
Metadata-Version: 2.1
Name: meristem
Version: {version}
Summary: {summary}
License: Apache-2.0
License-File: LICENSE
License-File: NOTICE
Requires-Python: >=3.9
Requires-Dist: numpy >=1.22
Provides-Extra: plots
Requires-Dist: matplotlib ; extra == 'plots'
"""


# --- what pip calls ---------------------------------------------------------------------------------------------------


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    return []


def get_requires_for_build_sdist(config_settings: Settings = None) -> list[str]:
    return []


def get_requires_for_build_editable(config_settings: Settings = None) -> list[str]:
    return []


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings: Settings = None) -> str:
    for path, content in distribution_info().items():
        target = Path(metadata_directory, path)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
    return f"{name_and_version()}.dist-info"


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    library = built_library(config_settings)
    members = written_half() | shipped_models() | {f"meristem/{library.name}": library.read_bytes()} | viewer(library)
    return write_wheel(Path(wheel_directory), members)


def build_editable(wheel_directory: str, config_settings: Settings = None,
                   metadata_directory: str | None = None) -> str:
    """Builds a wheel that only names the build tree's package, whose Python files are links to the source tree."""
    folder = built_library(config_settings).parents[1]
    return write_wheel(Path(wheel_directory), {"__editable__.meristem.pth": f"{folder}\n".encode()})


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    members = source_files() | {"PKG-INFO": metadata_text().encode()}
    name = f"{name_and_version()}.tar.gz"
    write_whole(Path(sdist_directory, name), tar_gz(name_and_version(), members))
    return name


# --- what the package says of itself ----------------------------------------------------------------------------------


def project_field(field: str) -> str:
    """Returns VERSION or DESCRIPTION of project() in CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(rf'^project\([^)]*\b{field}\s+(?:"([^"]*)"|([^\s)]+))', text, re.MULTILINE)
    if found is None:
        raise SystemExit(f"meristem: CMakeLists.txt gives project() no {field}")
    return str(found[1] or found[2])


def name_and_version() -> str:
    return f"meristem-{project_field('VERSION')}"


def metadata_text() -> str:
    return METADATA.format(version=project_field("VERSION"), summary=project_field("DESCRIPTION"))


def wheel_tag() -> str:
    """Returns a tag such as cp311-cp311-linux_x86_64: this interpreter, its binary interface and this machine."""
    abi = "cp" + str(sysconfig.get_config_var("SOABI")).split("-")[1]
    platform = re.sub(r"[^0-9a-zA-Z_]", "_", sysconfig.get_platform())
    return f"cp{sys.version_info[0]}{sys.version_info[1]}-{abi}-{platform}"


def distribution_info() -> Members:
    folder = f"{name_and_version()}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: meristem {project_field('VERSION')}\nRoot-Is-Purelib: false\n"
    return {
        f"{folder}/METADATA": metadata_text().encode(),
        f"{folder}/WHEEL": f"{wheel}Tag: {wheel_tag()}\n".encode(),
        f"{folder}/LICENSE": (ROOT / "LICENSE").read_bytes(),
        f"{folder}/NOTICE": (ROOT / "NOTICE").read_bytes(),
    }


# --- building ---------------------------------------------------------------------------------------------------------


def built_library(settings: Settings) -> Path:
    """Returns the compiled module, built now or found in the setting `build-dir`."""
    chosen = (settings or {}).get("build-dir")
    if chosen is not None and not isinstance(chosen, str):
        raise SystemExit("meristem: give the setting build-dir once")
    folder = Path(chosen).resolve() if chosen else ROOT / "build" / f"pip-{sys.implementation.cache_tag}"
    if not chosen:
        compile_library(folder)
    library = folder / "python" / "meristem" / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
    if not library.is_file():
        raise SystemExit(f"meristem: {library} is not there; was {folder} built with MERISTEM_PYTHON_MODULE=ON "
                         f"for {sys.executable}?")
    return library


def compile_library(folder: Path) -> None:
    lacking = [package for tool, package in TOOLS.items() if shutil.which(tool) is None]
    if lacking:
        raise SystemExit(f"meristem: {' and '.join(lacking)} must be installed to build it.\n{install_advice()}")
    # The interpreter itself rather than a virtual environment's link to it, which may be gone at the next install.
    interpreter = Path(sys.executable).resolve()
    configure = ["cmake", "--preset", "release", "-B", str(folder), "-D", "MERISTEM_APPS=OFF",
                 "-D", "MERISTEM_PYTHON_MODULE=ON", "-D", f"Python_EXECUTABLE={interpreter}",
                 "-D", f"CMAKE_CXX_COMPILER_LAUNCHER={shutil.which('ccache') or ''}"]
    if subprocess.run(configure, cwd=ROOT).returncode != 0:
        raise SystemExit(f"meristem: CMake could not configure the build; its words stand above.\n{install_advice()}")
    if subprocess.run(["cmake", "--build", str(folder), "--target", "meristem_python"], cwd=ROOT).returncode != 0:
        raise SystemExit("meristem: the library could not be compiled; the compiler's words stand above.")


def install_advice() -> str:
    missing = missing_packages()
    if not missing:
        return f"It needs, by the names of Debian's packages: {' '.join(DEBIAN_PACKAGES)}"
    return f"On Debian, as root: apt-get install --no-install-recommends {' '.join(missing)}"


def missing_packages() -> list[str]:
    """Returns the required Debian packages that are not installed. Empty on other systems."""
    if shutil.which("dpkg-query") is None:
        return []
    query = ["dpkg-query", "-W", "-f=${Package} ${db:Status-Status}\n", *DEBIAN_PACKAGES]
    lines = subprocess.run(query, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.splitlines()
    return [package for package in DEBIAN_PACKAGES if f"{package} installed" not in lines]


# --- what goes into archives ------------------------------------------------------------------------------------------


def written_half() -> Members:
    folder = ROOT / "python" / "meristem"
    files = [*folder.glob("*.py"), *folder.glob("*.pyi"), folder / "py.typed"]
    return {f"meristem/{file.name}": file.read_bytes() for file in files}


def viewer(library: Path) -> Members:
    """Returns the page that shows plants in browsers, if the build has made it."""
    page = library.with_name("viewer.html")
    return {f"meristem/{page.name}": page.read_bytes()} if page.is_file() else {}


def shipped_models() -> Members:
    models = ROOT / "models"
    files = [path for ending in ("json", "obj", "csv") for path in models.rglob(f"*.{ending}")]
    return {f"meristem/models/{file.relative_to(models).as_posix()}": file.read_bytes() for file in files}


def source_files() -> Members:
    """Returns the files that a build needs, without the results of builds and tests."""
    members: Members = {}
    for part in SOURCE_PARTS:
        files = [ROOT / part] if (ROOT / part).is_file() else (ROOT / part).rglob("*")
        for file in files:
            relative = file.relative_to(ROOT)
            if file.is_file() and not any(name.startswith((".", "__pycache__")) for name in relative.parts):
                members[relative.as_posix()] = file.read_bytes()
    return members


# --- archives ---------------------------------------------------------------------------------------------------------


def write_wheel(folder: Path, members: Members) -> str:
    """Writes a wheel with the members, its metadata, and the list of all hashes."""
    whole = dict(sorted(members.items())) | distribution_info()
    record = f"{name_and_version()}.dist-info/RECORD"
    lines = [f"{path},sha256={digest(content)},{len(content)}" for path, content in whole.items()]
    whole[record] = "\n".join([*lines, f"{record},,", ""]).encode()
    name = f"{name_and_version()}-{wheel_tag()}.whl"
    write_whole(folder / name, zipped(whole))
    return name


def digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def zipped(members: Members) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in members.items():
            # A fixed date and fixed rights, so that only contents make a difference.
            entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # Unix, whose rights these are
            entry.external_attr = (0o100755 if path.endswith(".so") else 0o100644) << 16
            archive.writestr(entry, content)
    return stream.getvalue()


def tar_gz(top: str, members: Members) -> bytes:
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for path, content in sorted(members.items()):
            # The defaults, which fix date, rights and owner.
            entry = tarfile.TarInfo(f"{top}/{path}")
            entry.size = len(content)
            archive.addfile(entry, io.BytesIO(content))
    return gzip.compress(stream.getvalue(), mtime=0)


def write_whole(path: Path, content: bytes) -> None:
    """Writes beside the path and renames, so that an interruption leaves no partial file under the name."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        part.write_bytes(content)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)

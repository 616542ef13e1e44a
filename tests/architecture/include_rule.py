#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the architecture rules of the library's rooms.

In:  the root of a source tree (by default this one).
Out: one line per error, `file:line: message`, and exit code 1. No output and exit code 0 without errors.

A room includes and links only itself and earlier rooms. The doors (the programs and the Python module) include public
headers of all rooms, but no other door. The library never includes a door. A public header includes only public headers
and no heavy libraries, so that it compiles fast. A source includes the header with its own name first, which shows that
the header compiles alone; the build checks headers without a source. A public header states its purpose: in a sentence
at its head, or above its first declaration. Every file of a room is in a list of its CMakeLists.txt, so that no test is
left out unnoticed.

Constants and types in unnamed namespaces have unique names in a room, because sources are compiled in batches. A test
has a namespace with its file's name, so its helpers may have any names. A room links exactly the rooms whose headers it
includes, and the folders of a room do not include each other in a circle.

A public type says what it belongs to (`PlantCounts`, not `Counts`). One word is enough only for the nouns in NOUNS.
"""

import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

ROOMS = ["base", "plant", "scene", "grow", "shape", "measure", "output", "graph", "components", "document", "export",
         "dataset"]
DOORS = ["apps", "python"]
HEAVY = ("nlohmann/", "embree", "CLI/", "tbb/", "oneapi/", "png.h", "boost/", "tiny_gltf", "tiny_obj_loader",
         "valijson/", "Eigen/")
# Public types of one word: nouns of the field, of geometry and of programming that mean one thing in the whole library.
NOUNS = set("""
    Alphabet Animation Asset Box Bud Cache Camera Cancelled Change Colonize Crown Curve Deformation Diagnostic Directions
    Document Ellipsoid Emitted Emitter Expression Fingerprint Frame Grammar Graph Grower Image Individual Lamp Letter
    Light Link Loft Material Measures Mesh Metamers Obstacle Obstacles Organ Parameter Phyllotaxis Plant Planting
    Progress Prototype Provenance Ray Registry Scan Scanner Scene Seedling Session Site Skeleton Sky Stand Stem
    Surroundings Table Texture Tropism Value Variable Varying Word
""".split())
LISTS = ("SOURCES", "HEADERS", "TESTS", "PUBLIC", "PRIVATE", "TESTED_WITH")

DECLARATION = re.compile(r"(?!(inline )?namespace\b)(//|[A-Za-z])")
OWN_NAME = re.compile(r"(?:inline )?(?:constexpr|const) [^=;({]*?\b(?P<constant>k[A-Z]\w*)\b|"
                      r"(?:struct|class|enum class|enum) (?P<type>\w+)(?!.*;$)|using (?P<alias>\w+) =")
PUBLIC_TYPE = re.compile(r"(?:struct|class|enum class|enum) (?P<type>[A-Z][a-z]+)\b(?!.*;$)|using (?P<alias>[A-Z][a-z]+) =")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?P<kind>["<])(?P<name>[^">]+)[">]')


class Fault(NamedTuple):
    place: Path
    line: int
    message: str

    def text(self, root: Path) -> str:
        return f"{self.place.relative_to(root)}:{self.line}: {self.message}"


class Include(NamedTuple):
    line: int
    name: str
    quoted: bool


def includes_of(path: Path) -> Iterator[Include]:
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        found = INCLUDE.match(line)
        if found:
            yield Include(number, found["name"], found["kind"] == '"')


def sources_below(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cpp"))


def room_lists(cmake: Path) -> dict[str, list[str]]:
    """Returns the lists in a room's `meristem_room(NAME SOURCES ... HEADERS ...)`."""
    lists: dict[str, list[str]] = {name: [] for name in LISTS}
    if not cmake.exists():
        return lists
    text = re.sub(r"#.*", "", cmake.read_text(encoding="utf-8"))
    call = re.search(r"meristem_room\(([^)]*)\)", text)
    current = None
    for word in call.group(1).split()[1:] if call else []:
        if word in lists:
            current = lists[word]
        elif current is not None:
            current.append(word)
    return lists


def include_fault(room: str, is_test: bool, include: Include) -> str | None:
    """Returns the reason why a file of `room` must not have `include`, or None."""
    parts = include.name.split("/")
    if parts[0] in DOORS:
        return f'the library does not include its doors, but this includes "{include.name}"'
    if parts[0] == "tests":
        return None if is_test else f'only tests include "{include.name}"'
    if parts[0] == "meristem":
        if len(parts) < 3 or parts[1] not in ROOMS:
            return f'"{include.name}" is in no room'
        if ROOMS.index(parts[1]) > ROOMS.index(room):
            return f'{room} stands before {parts[1]} in the line and may not include "{include.name}"'
        return None
    return f'write "{include.name}" from the root: "meristem/<room>/..."' if include.quoted else None


def check_room_includes(root: Path, room: str, public: set[Path]) -> Iterator[Fault]:
    for path in sources_below(root / "meristem" / room):
        for include in includes_of(path):
            wrong = include_fault(room, path.stem.endswith("_test"), include)
            if wrong is None and path in public:
                wrong = public_header_fault(root, public, include)
            if wrong:
                yield Fault(path, include.line, wrong)


def door_fault(root: Path, door: str, public: set[Path], include: Include) -> str | None:
    """Returns the reason why a file of `door` must not have `include`, or None."""
    first = include.name.split("/")[0]
    if first in DOORS and first != door:
        return f'a door includes the library and not another door, but this includes "{include.name}"'
    if first == "meristem" and root / include.name not in public:
        return f'a door includes public headers only, and "{include.name}" is none'
    return None


def check_door_includes(root: Path, door: str, public: set[Path]) -> Iterator[Fault]:
    for path in sources_below(root / door):
        for include in includes_of(path):
            wrong = door_fault(root, door, public, include)
            if wrong:
                yield Fault(path, include.line, wrong)


def check_own_headers(root: Path, room: str) -> Iterator[Fault]:
    for path in sources_below(root / "meristem" / room):
        header = path.with_suffix(".h")
        if path.suffix != ".cpp" or not header.exists():
            continue
        own = header.relative_to(root).as_posix()
        first = next(includes_of(path), None)
        if first is None or first.name != own:
            yield Fault(path, first.line if first else 1, f'the first include is not "{own}"')


def public_header_fault(root: Path, public: set[Path], include: Include) -> str | None:
    if include.name.startswith(HEAVY):
        return f"<{include.name}> is heavy and stays out of public headers"
    if include.name.startswith("meristem/") and root / include.name not in public:
        return f'a public header includes "{include.name}", which is not installed'
    return None


def check_sentences(root: Path, public: set[Path]) -> Iterator[Fault]:
    """Checks that a public header has a sentence at its head, or a `///` sentence above its first declaration."""
    for path in sorted(public):
        lines = path.read_text(encoding="utf-8").splitlines()
        guard = next((k for k, line in enumerate(lines) if line.startswith("#pragma once")), len(lines))
        if any(line.startswith("// ") and "SPDX-License-Identifier" not in line for line in lines[:guard]):
            continue
        declared = first_declaration(lines, guard + 1)
        if declared is not None and not lines[declared].startswith("//") and "///<" not in lines[declared]:
            yield Fault(path, declared + 1, "the header says neither at its head nor here what it is for")


def check_type_names(root: Path, public: set[Path]) -> Iterator[Fault]:
    """Checks that public types have names of several words, or one of the nouns that mean one thing everywhere."""
    for path in sorted(public):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            found = PUBLIC_TYPE.match(line)
            name = found and (found["type"] or found["alias"])
            if name and name not in NOUNS:
                yield Fault(path, number, f"{name} is one general word; say what it belongs to, as in PlantCounts")


def first_declaration(lines: list[str], begin: int) -> int | None:
    """Returns the first line at the left margin that is a declaration or the comment of one. Directives, namespaces and
    forward declarations (`class B;`, also of a template) do not count."""
    for k in range(begin, len(lines)):
        named = lines[k + 1] if lines[k].startswith("template <") and k + 1 < len(lines) else lines[k]
        if DECLARATION.match(lines[k]) and not re.fullmatch(r"(class|struct) \w+;", named):
            return k
    return None


def check_room_lists(root: Path, room: str, lists: dict[str, list[str]]) -> Iterator[Fault]:
    folder = root / "meristem" / room
    cmake = folder / "CMakeLists.txt"
    listed = set(lists["SOURCES"] + lists["HEADERS"] + lists["TESTS"])
    for path in sources_below(folder):
        name = path.relative_to(folder).as_posix()
        if path.suffix == ".cpp" and name not in listed:
            yield Fault(path, 1, "is in no list of the room's CMakeLists.txt, so nothing compiles it")
        if path.stem.endswith("_test") and name in lists["SOURCES"]:
            yield Fault(cmake, 1, f"{name} is a test and belongs to TESTS")
    for target in lists["PUBLIC"] + lists["PRIVATE"]:
        if not target.startswith("meristem::"):
            continue
        other = target.removeprefix("meristem::")
        if other not in ROOMS:
            yield Fault(cmake, 1, f"links {target}, which is no room")
        elif ROOMS.index(other) >= ROOMS.index(room):
            yield Fault(cmake, 1, f"{room} stands before {other} in the line and may not link it")


def check_links(root: Path, room: str, lists: dict[str, list[str]]) -> Iterator[Fault]:
    """Checks that a room links the rooms that it includes: PUBLIC for headers, otherwise PRIVATE."""
    cmake = root / "meristem" / room / "CMakeLists.txt"
    included: dict[str, set[str]] = {"PUBLIC": set(), "PRIVATE": set()}
    for path in sources_below(root / "meristem" / room):
        if path.stem.endswith("_test"):
            continue
        for include in includes_of(path):
            parts = include.name.split("/")
            if parts[0] == "meristem" and len(parts) > 2 and parts[1] in ROOMS and parts[1] != room:
                included["PUBLIC" if path.suffix == ".h" else "PRIVATE"].add(parts[1])
    included["PRIVATE"] -= included["PUBLIC"]
    earlier = set(ROOMS[: ROOMS.index(room)])  # later rooms are reported as separate errors
    for kind, rooms in included.items():
        linked = {target.removeprefix("meristem::") for target in lists[kind]} & earlier
        for other in sorted((rooms & earlier) - linked):
            yield Fault(cmake, 1, f"{room} includes {other} and does not link it as {kind}")
        for other in sorted(linked - rooms):
            yield Fault(cmake, 1, f"links meristem::{other} as {kind} without including it so")


def check_folders(root: Path, room: str) -> Iterator[Fault]:
    """Checks that the folders of a room, including its top folder, do not include each other in a circle."""
    top = root / "meristem" / room
    edges: dict[str, dict[str, tuple[Path, int]]] = {}
    for path in sources_below(top):
        if path.stem.endswith("_test"):
            continue
        own = path.parent.relative_to(top).as_posix()
        for include in includes_of(path):
            prefix = f"meristem/{room}/"
            if include.name.startswith(prefix):
                other = Path(include.name.removeprefix(prefix)).parent.as_posix()
                if other != own:
                    edges.setdefault(own, {}).setdefault(other, (path, include.line))
    for own in sorted(edges):
        for other, (path, line) in sorted(edges[own].items()):
            if own in reached_from(edges, other):
                yield Fault(path, line, f'the folders "{own}" and "{other}" of {room} include each other in a circle')


def reached_from(edges: dict[str, dict[str, tuple[Path, int]]], begin: str) -> set[str]:
    reached = {begin}
    waiting = [begin]
    while waiting:
        for other in edges.get(waiting.pop(), {}):
            if other not in reached:
                reached.add(other)
                waiting.append(other)
    return reached


def names_of_its_own(path: Path) -> Iterator[tuple[int, str, str]]:
    """Yields the constants and types that a source defines at the left margin of an unnamed namespace: line number,
    name and, for an alias, the aliased type."""
    inside = False
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if line == "namespace {":
            inside = True
        elif line == "}  // namespace":
            inside = False
        elif inside:
            found = OWN_NAME.match(line)
            if found:
                name = found["constant"] or found["type"] or found["alias"]
                yield number, name, line if found["alias"] else ""


def check_batches(root: Path, sources: list[Path]) -> Iterator[Fault]:
    """Checks for name clashes: the unnamed namespaces of a batch are one. Aliases may repeat if their type is equal."""
    first: dict[str, tuple[Path, str]] = {}
    for path in sources:
        for line, name, alias in names_of_its_own(path):
            other, other_alias = first.setdefault(name, (path, alias))
            if other != path and (not alias or alias != other_alias):
                yield Fault(path, line, f"{name} has the name of one in {other.relative_to(root)}; in a batch of "
                                        "sources they clash")


def check_tests(folder: Path) -> Iterator[Fault]:
    """Checks that tests use the namespace of their file, so that helpers with equal names do not clash in a batch."""
    for path in sorted(folder.rglob("*_test.cpp")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            if re.match(r"namespace (?!fs\b)", line) and not line.endswith(f"::{path.stem} {{"):
                yield Fault(path, number, f"is not the namespace meristem::{path.stem}; in a batch of tests, helpers of one "
                                          "name clash")
                break


def check_order(root: Path) -> Iterator[Fault]:
    """Checks that the build adds the rooms in order and that every folder is a room."""
    cmake = root / "meristem" / "CMakeLists.txt"
    added = re.findall(r"^add_subdirectory\((\w+)\)", cmake.read_text(encoding="utf-8"), re.MULTILINE)
    if added != ROOMS:
        yield Fault(cmake, 1, f"adds the rooms as {', '.join(added)}; the line is {', '.join(ROOMS)}")
    for folder in sorted(path for path in (root / "meristem").iterdir() if path.is_dir()):
        if folder.name not in ROOMS:
            yield Fault(folder, 1, "is no room")


def check(root: Path) -> list[Fault]:
    faults = list(check_order(root))
    lists = {room: room_lists(root / "meristem" / room / "CMakeLists.txt") for room in ROOMS}
    public = {root / "meristem" / room / header for room in ROOMS for header in lists[room]["HEADERS"]}
    for room in ROOMS:
        faults += check_room_lists(root, room, lists[room])
        faults += check_links(root, room, lists[room])
        faults += check_folders(root, room)
        faults += check_room_includes(root, room, public)
        faults += check_own_headers(root, room)
        folder = root / "meristem" / room
        faults += check_batches(root, [folder / name for name in lists[room]["SOURCES"] if (folder / name).is_file()])
    faults += check_sentences(root, public)
    faults += check_type_names(root, public)
    for folder in [root / "meristem", *(root / door for door in DOORS)]:
        faults += check_tests(folder)
    for door in DOORS:
        faults += check_batches(root, sorted((root / door).rglob("*.cpp")))
        faults += check_door_includes(root, door, public)
    return faults


def main(arguments: list[str]) -> int:
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parents[2]
    faults = check(root)
    for fault in faults:
        print(fault.text(root))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

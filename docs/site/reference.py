# SPDX-License-Identifier: Apache-2.0
"""A Sphinx extension: the references of C++ and Python.

In:  the public headers, through doxygen (cpp_model.py); the Python module (python_model.py); the programs in
     tests/consumer/examples, whose functions are the examples of the C++ classes.
Out: the directives `cpp-header`, `cpp-room`, `cpp-names`, `python-page` and `python-names`, and all names for the
     search.

Pages are made of nodes and not of reStructuredText, because comments are plain sentences. Names without a comment are
warnings, which fail the build.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Iterator, Optional

from docutils import nodes
from docutils.parsers.rst import Directive
from sphinx import addnodes
from sphinx.domains import Domain, ObjType
from sphinx.util import logging

import cpp_model
import python_model
from prose import Resolve, code_block, first_sentence, inline, link, prose, table

logger = logging.getLogger(__name__)

ROOT = Path(__file__).resolve().parents[2]
KIND_TITLES = (("function", "Functions"), ("typedef", "Types"), ("enum", "Enumerations"), ("variable", "Constants"),
               ("define", "Macros"))


class Reference:
    """Everything that the references show, with the address of each name."""

    def __init__(self, root: Path, work: Path, headers: list[str], rooms: dict[str, str]) -> None:
        self.warnings = cpp_model.run_doxygen(root, work, headers)
        self.headers = {header.path: header for header in cpp_model.read_headers(work / "xml", root, headers)}
        self.rooms = rooms
        self.examples = read_examples(root / "tests" / "consumer" / "examples")
        self.names = python_model.read_module(root)
        self.cpp: dict[str, tuple[str, str]] = {}  # qualified name to page and anchor
        self.ids: dict[str, tuple[str, str]] = {}  # doxygen's id to page and anchor
        self.python: dict[str, tuple[str, str]] = {}
        self.objects: dict[str, list[tuple[str, str, str, str, str, int]]] = {"cplusplus": [], "python": []}
        for header in self.headers.values():
            self._add_cpp(header.declarations, page_of_header(header.path), {})
        for module, names in self.names.items():
            for name in names:
                self._add_python(module, name)

    def _add_cpp(self, declarations: list[cpp_model.Declaration], page: str, used: dict[str, int]) -> None:
        for one in declarations:
            anchor = re.sub(r"[^\w]+", "-", one.qualified).strip("-") or "operator"
            used[anchor] = used.get(anchor, 0) + 1
            anchor = anchor if used[anchor] == 1 else f"{anchor}-{used[anchor]}"
            self.cpp.setdefault(one.qualified, (page, anchor))
            self.ids[one.id] = (page, anchor)
            self.objects["cplusplus"].append((one.qualified, one.qualified, one.kind, page, anchor, 1))
            self._add_cpp(one.members, page, used)

    def _add_python(self, module: str, name: python_model.Name) -> None:
        page = page_of_python(module, name)
        full = name.name if module == "meristem" else f"{module.rsplit('.', 1)[1]}.{name.name}"
        self.python[full] = self.python[name.name] = (page, full)
        self.objects["python"].append((f"meristem.{full}", f"meristem.{full}", name.kind, page, full, 1))
        for member in name.members:
            anchor = f"{full}.{member.name}"
            self.python[anchor] = (page, anchor)
            self.objects["python"].append((f"meristem.{anchor}", f"meristem.{anchor}", member.kind, page, anchor, 1))

    def faults(self) -> list[str]:
        known = {one.qualified for header in self.headers.values() for one in header.declarations}
        lost = [f"tests/consumer/examples: there is no '{name}', of which an example is given"
                for name in self.examples if name not in known]
        return [*self.warnings, *cpp_model.faults_of(list(self.headers.values())), *python_model.faults_of(self.names),
                *lost]


def read_examples(folder: Path) -> dict[str, tuple[str, str]]:
    """Returns sentence and code of the example for each class: the body of the function below "// Example of NAME"."""
    found = {}
    form = re.compile(r"^// Example of (\w+): (.*?)\nvoid \w+\([^)]*\) \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
    for path in sorted(folder.glob("*.cpp")):
        for match in form.finditer(path.read_text(encoding="utf-8")):
            sentence = re.sub(r"\n// ?", " ", match[2])
            code = "\n".join(line.removeprefix("  ") for line in match[3].rstrip().splitlines())
            found[match[1]] = (sentence, code)
    return found


def page_of_header(path: str) -> str:
    return "reference/cpp/" + path.removeprefix("meristem/").removesuffix(".h")


def page_of_python(module: str, name: python_model.Name) -> str:
    if module != "meristem":
        return "reference/python/" + module.rsplit(".", 1)[1]
    if name.kind == "class":
        return f"reference/python/{name.name}"
    return "reference/python/errors" if name.kind == "exception" else "reference/python/functions"


# --- nodes ------------------------------------------------------------------------------------------------------------


class Page(Directive):
    """The base of the directives. Their argument is a path or a name."""

    required_arguments = 1

    @property
    def builder(self) -> Any:
        return self.state.document.settings.env.app.builder

    @property
    def page(self) -> str:
        return str(self.state.document.settings.env.docname)

    @property
    def reference(self) -> Reference:
        found: Reference = self.state.document.settings.env.app.reference
        return found

    def address(self, place: tuple[str, str]) -> str:
        page, anchor = place
        relative = "" if page == self.page else self.builder.get_relative_uri(self.page, page)
        return f"{relative}#{anchor}" if anchor else relative

    def section(self, title: str, anchor: str) -> nodes.section:
        return nodes.section("", nodes.title(title, title), ids=[anchor], names=[title])


def description(language: str, kind: str, anchor: str, signatures: list[list[nodes.Node]],
                content: list[nodes.Node]) -> addnodes.desc:
    """Returns the description of a name: its signatures and its content. The first signature has the anchor."""
    node = addnodes.desc(domain=language, objtype=kind, noindex=False, classes=[language, kind])
    for index, signature in enumerate(signatures):
        ids = [anchor] if index == 0 else []
        node += addnodes.desc_signature("", "", *signature, ids=ids, classes=["sig-object", language])
    node += addnodes.desc_content("", *content)
    return node


def quiet(text: str, *classes: str) -> nodes.inline:
    return nodes.inline(text, text, classes=["sig-quiet", *classes])


class CppPage(Page):
    def resolver(self, scope: str) -> Resolve:
        """Names are looked up in the class first, and then in the scopes around it."""
        def resolve(name: str) -> Optional[str]:
            parts = scope.split("::") if scope else []
            for count in range(len(parts), -1, -1):
                place = self.reference.cpp.get("::".join([*parts[:count], name.replace(".", "::")]))
                if place:
                    return self.address(place)
            return None
        return resolve

    def signature(self, one: cpp_model.Declaration) -> list[nodes.Node]:
        found: list[nodes.Node] = [quiet(one.template, "sig-template")] if one.template else []
        for piece in one.signature:
            place = self.reference.ids.get(piece.target) if piece.target else None
            if place and piece.target != one.id:
                found.append(link(piece.text, self.address(place)))
            elif piece.text == one.name:
                found.append(addnodes.desc_name(piece.text, piece.text))
            else:
                found.append(nodes.inline(piece.text, piece.text))
        return found

    def describe(self, one: cpp_model.Declaration) -> addnodes.desc:
        resolve = self.resolver(one.qualified if one.members else one.qualified.rpartition("::")[0])
        content = prose(one.text, resolve, "cpp")
        if one.values:
            rows = [[[nodes.literal(name, name)], inline(text, resolve)] for name, text in one.values]
            content.append(table(rows, [30, 70], ["value", "meaning"]))
        content += self.example(one)
        content += self.members(one.members)
        return description("cplusplus", one.kind, self.reference.ids[one.id][1], [self.signature(one)], content)

    def members(self, declarations: list[cpp_model.Declaration]) -> list[nodes.Node]:
        """Returns descriptions. Overloads that share a comment are one description."""
        found: list[addnodes.desc] = []
        described: dict[str, addnodes.desc] = {}
        for one in declarations:
            shared = described.get(one.qualified)
            if shared is not None and not one.text:
                anchor = self.reference.ids[one.id][1]
                shared.insert(len(shared) - 1, addnodes.desc_signature(
                    "", "", *self.signature(one), ids=[anchor], classes=["sig-object", "cplusplus"]))
            else:
                described[one.qualified] = self.describe(one)
                found.append(described[one.qualified])
        return found

    def example(self, one: cpp_model.Declaration) -> list[nodes.Node]:
        if one.qualified not in self.reference.examples:
            return []
        sentence, code = self.reference.examples[one.qualified]
        return [nodes.paragraph("", "", nodes.strong("", "Example: "), *inline(sentence, self.resolver(""))),
                code_block(code, "cpp")]


class CppHeader(CppPage):
    """All declarations of a header. Argument: its path."""

    def run(self) -> list[nodes.Node]:
        header = self.reference.headers[self.arguments[0]]
        room = ("reference/cpp/" + header.room, "")
        found: list[nodes.Node] = [nodes.paragraph(
            "", "", link("C++ reference", self.address(("reference/cpp/index", ""))), nodes.Text(" › "),
            link(header.room, self.address(room)), classes=["way"])]
        found.append(code_block(f'#include "{header.path}"', "cpp"))
        if not any(one.text.startswith(header.purpose) for one in header.declarations):
            found += prose(header.purpose, self.resolver(""), "cpp")
        for one in header.declarations:
            if one.kind in cpp_model.CLASSES:
                section = self.section(one.name, f"class-{one.name}")
                section += self.describe(one)
                found.append(section)
        for kind, title in KIND_TITLES:
            group = [one for one in header.declarations if one.kind == kind]
            if group:
                section = self.section(title, title.lower())
                section.extend(self.members(group))
                found.append(section)
        return found


class CppRoom(CppPage):
    """The headers of a room, with their purposes and names. Argument: the room."""

    def run(self) -> list[nodes.Node]:
        room = self.arguments[0]
        resolve = self.resolver("")
        found: list[nodes.Node] = [nodes.paragraph(
            "", "", link("C++ reference", self.address(("reference/cpp/index", ""))), classes=["way"])]
        text = self.reference.rooms[room]
        found.append(nodes.paragraph("", "", *inline(text[0].upper() + text[1:].removesuffix(".") + ".", resolve)))
        rows = []
        for header in self.reference.headers.values():
            if header.room != room:
                continue
            page = page_of_header(header.path)
            names = [one for one in header.declarations if one.kind in cpp_model.CLASSES]
            cell: list[nodes.Node] = inline(sentence_of(header), resolve)
            for index, one in enumerate(names):
                cell += [nodes.Text(", " if index else " "), link(one.name, self.address(self.reference.ids[one.id]))]
            rows.append([[link(header.path.removeprefix(f"meristem/{room}/"), self.address((page, "")))], cell])
        found.append(table(rows, [30, 70], ["header", "what it is for, and its classes"]))
        return found


def sentence_of(header: cpp_model.Header) -> str:
    return first_sentence(header.purpose)


class CppNames(CppPage):
    """A table of rooms, or of all names: the argument is "rooms", "examples" or "all"."""

    def run(self) -> list[nodes.Node]:
        what, resolve = self.arguments[0], self.resolver("")
        if what == "rooms":
            rows = [[[link(room, self.address((f"reference/cpp/{room}", "")))], inline(text, resolve)]
                    for room, text in self.reference.rooms.items()]
            return [table(rows, [20, 80], ["room", "what lives there"])]
        every = [one for header in self.reference.headers.values() for one in header.declarations]
        if what == "examples":
            every = [one for one in every if one.qualified in self.reference.examples]
        rows, seen = [], set()
        for one in sorted(every, key=lambda one: (one.name.lower(), one.name)):
            if one.qualified not in seen and not one.name.startswith("operator"):
                seen.add(one.qualified)
                rows.append([[link(one.qualified, self.address(self.reference.ids[one.id]))],
                             inline(first_sentence(one.text), resolve)])
        return [table(rows, [35, 65], ["name", "what it is"])]


class PythonPage(Page):
    def resolver(self, scope: str) -> Resolve:
        def resolve(name: str) -> Optional[str]:
            bare = name.removeprefix("meristem.")
            place = self.reference.python.get(f"{scope}.{bare}") or self.reference.python.get(bare)
            return self.address(place) if place else None
        return resolve

    def signature(self, text: str, name: str, kind: str) -> list[nodes.Node]:
        """Returns a signature with links to the classes of the module."""
        found: list[nodes.Node] = [quiet(kind + " ")] if kind in ("class", "exception", "property") else []
        own = name.removeprefix("_")
        for index, part in enumerate(re.split(r"([A-Za-z_][\w.]*)", text)):
            place = self.reference.python.get(part) if part[:1].isupper() else None
            if index <= 1 and part.rsplit(".", 1)[-1] in (name, own):
                found.append(addnodes.desc_name(part, part))
            elif place:
                found.append(link(part, self.address(place)))
            elif part:
                found.append(nodes.inline(part, part))
        return found

    def describe(self, one: python_model.Name, full: str) -> addnodes.desc:
        scope = full if one.members else full.rpartition(".")[0]
        content = prose(one.text, self.resolver(scope), "python")
        content += [self.describe(member, f"{full}.{member.name}") for member in one.members]
        signatures = [self.signature(text, one.name, one.kind) for text in one.signatures]
        return description("python", one.kind, full, signatures, content)


class PythonDocs(PythonPage):
    """Descriptions of names. Argument: a class, "functions", "errors" or "grass"."""

    def run(self) -> list[nodes.Node]:
        page = f"reference/python/{self.arguments[0]}"
        found: list[nodes.Node] = [nodes.paragraph(
            "", "", link("Python reference", self.address(("reference/python/index", ""))), classes=["way"])]
        listed = [(module, name) for module, names in self.reference.names.items() for name in names
                  if page_of_python(module, name) == page]
        listed.sort(key=lambda one: one[1].kind == "constant")
        for module, name in listed:
            full = name.name if module == "meristem" else f"{module.rsplit('.', 1)[1]}.{name.name}"
            described = self.describe(name, full)
            if len(listed) == 1:
                return [*found, described]
            section = self.section(name.name, f"section-{name.name}")
            section += described
            found.append(section)
        return found


class PythonNames(PythonPage):
    """A table of names of one kind. Argument: class, function, exception, constant or grass."""

    def run(self) -> list[nodes.Node]:
        kind = self.arguments[0]
        module = "meristem.grass" if kind == "grass" else "meristem"
        rows = []
        for name in self.reference.names[module]:
            if kind in ("grass", name.kind):
                full = name.name if module == "meristem" else f"grass.{name.name}"
                rows.append([[link(name.name, self.address(self.reference.python[full]))],
                             inline(first_sentence(name.text), self.resolver(""))])
        return [table(rows, [30, 70], ["name", "what it is"])]


# --- search -----------------------------------------------------------------------------------------------------------


class NamesDomain(Domain):
    """Tells the search of all names."""

    def get_objects(self) -> Iterator[tuple[str, str, str, str, str, int]]:
        reference: Reference = self.env.app.reference  # type: ignore[attr-defined]
        yield from reference.objects[self.name]

    def resolve_any_xref(self, *arguments: Any) -> list[Any]:
        """Markdown links to pages and not to names."""
        return []

    def merge_domaindata(self, docnames: Any, otherdata: Any) -> None:
        """The names do not come from the pages that a process has read."""


class CppDomain(NamesDomain):
    name, label = "cplusplus", "C++"
    object_types = {kind: ObjType(kind) for kind in
                    ("class", "struct", "union", "function", "variable", "typedef", "enum", "define")}


class PythonDomain(NamesDomain):
    name, label = "python", "Python"
    object_types = {kind: ObjType(kind) for kind in
                    ("class", "exception", "function", "method", "property", "attribute", "constant")}


def read_everything(app: Any) -> None:
    app.reference = Reference(ROOT, Path(app.config.reference_work), app.config.reference_headers,
                              app.config.reference_rooms)
    for fault in app.reference.faults():
        logger.warning(fault)


def setup(app: Any) -> dict[str, bool]:
    app.add_config_value("reference_work", "", "env")
    app.add_config_value("reference_headers", [], "env")
    app.add_config_value("reference_rooms", {}, "env")
    app.connect("builder-inited", read_everything)
    for name, directive in (("cpp-header", CppHeader), ("cpp-room", CppRoom), ("cpp-names", CppNames),
                            ("python-page", PythonDocs), ("python-names", PythonNames)):
        app.add_directive(name, directive)
    app.add_domain(CppDomain)
    app.add_domain(PythonDomain)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

# SPDX-License-Identifier: Apache-2.0
"""Reads the declarations of the public C++ headers from doxygen's XML.

In:  the folder of doxygen's XML, and the public headers.
Out: a Header for each header with its classes, functions, types and constants, in the order of the source.

Comments of the project are plain sentences with `code` in backticks. doxygen reads copies of the headers in which the
characters of its commands are escaped, so it changes nothing in the sentences. `faults_of` lists public names that have
no comment.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterator

Element = ElementTree.Element

CLASSES = ("class", "struct", "union")
DOXYFILE = """\
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
WARN_IF_DOC_ERROR = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
JAVADOC_AUTOBRIEF = NO
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
MACRO_EXPANSION = NO
STRIP_FROM_PATH = .
"""
# Characters of doxygen's commands, and private characters that stand for them while doxygen reads.
ESCAPES = {ord(character): chr(0xE000 + index) for index, character in enumerate("\\\\<>&@#%~")}
UNESCAPES = {ord(private): chr(character) for character, private in ESCAPES.items()}
ROW = chr(0xE100)  # begins a row of a table, which stays a line
LONGEST_VALUE = 60  # characters of an initial value that a signature shows


@dataclass
class Piece:
    """A piece of a signature. `target` is the id of the declaration that it names, or empty."""

    text: str
    target: str = ""


@dataclass
class Declaration:
    """A class, function, variable, type or enumeration."""

    id: str
    kind: str  #: class, struct, union, function, variable, typedef, enum, define
    name: str  #: without scopes, for example "parent"
    qualified: str  #: without the project's namespace, for example "Skeleton::parent"
    file: str
    line: int
    text: str  #: the comment: paragraphs separated by empty lines; empty if there is none
    signature: list[Piece] = field(default_factory=list)
    template: str = ""  #: template parameters, for example "template <typename T>"
    members: list[Declaration] = field(default_factory=list)
    values: list[tuple[str, str]] = field(default_factory=list)  #: name and comment of each value of an enumeration
    is_exempt: bool = False  #: needs no comment: the language or another declaration states what it does


@dataclass
class Header:
    path: str  #: as programs include it, for example "meristem/plant/skeleton.h"
    purpose: str  #: comment at the head of the file; else the comment on its first class or function
    declarations: list[Declaration]

    @property
    def room(self) -> str:
        return self.path.split("/")[1]


def text_of(element: Element | None) -> str:
    """Returns a description as paragraphs separated by empty lines. An item of a list is a paragraph that begins with
    "- "."""
    if element is None:
        return ""
    blocks: list[str] = []

    def read(node: Element, mark: str) -> None:
        words = node.text or ""
        for child in node:
            if child.tag == "itemizedlist":
                blocks.append(mark + words)
                words, mark = "", ""
                for item in child:
                    for paragraph in item:
                        read(paragraph, "- ")
            elif child.tag == "ndash":
                words += "--"
            elif child.tag == "mdash":
                words += "---"
            elif child.tag in ("ref", "linebreak"):
                words += "".join(child.itertext())
            else:
                raise ValueError(f"doxygen's element '{child.tag}' has no meaning here: {''.join(node.itertext())}")
            words += child.tail or ""
        blocks.append(mark + words)

    for paragraph in element:
        read(paragraph, "")
    cleaned = [re.sub(r"\s+", " ", block).translate(UNESCAPES).replace(" " + ROW, "\n|").replace(ROW, "|").strip()
               for block in blocks]
    return "\n\n".join(block for block in cleaned if block not in ("", "-"))


def comment_of(element: Element) -> str:
    parts = [text_of(element.find("briefdescription")), text_of(element.find("detaileddescription"))]
    return "\n\n".join(part for part in parts if part)


def pieces_of(element: Element | None, fallback: str = "") -> list[Piece]:
    """Returns a type or value as pieces, written as the project's sources are formatted."""
    if element is None:
        return [Piece(fallback)] if fallback else []
    marked = element.text or ""
    for child in element:
        marked += f"\1{child.get('refid', '')}\2{''.join(child.itertext())}\3{child.tail or ''}"
    marked = re.sub(r"\s+", " ", marked)
    for before, after in (("< ", "<"), (" >", ">"), (" &", "&"), (" *", "*"), ("( ", "("), (" )", ")"), (" '", "'")):
        marked = marked.replace(before, after)
    pieces = []
    for part in re.split("(\1[^\3]*\3)", marked):
        if part.startswith("\1"):
            target, text = part[1:-1].split("\2")
            pieces.append(Piece(text, target))
        elif part:
            pieces.append(Piece(part))
    return pieces


def plain(pieces: list[Piece]) -> str:
    return "".join(piece.text for piece in pieces)


def without(pieces: list[Piece], *words: str) -> list[Piece]:
    if pieces and not pieces[0].target:
        pieces[0].text = re.sub(rf"^((?:{'|'.join(words)})\s+)+", "", pieces[0].text)
    return [piece for piece in pieces if piece.text]


def template_of(element: Element) -> str:
    parameters = element.find("templateparamlist")
    if parameters is None:
        return ""
    written = []
    for parameter in parameters:
        kind = plain(pieces_of(parameter.find("type")))
        name = parameter.findtext("declname") or ""
        value = parameter.find("defval")
        written.append(f"{kind} {name}".strip() + (f" = {plain(pieces_of(value))}" if value is not None else ""))
    return f"template <{', '.join(written)}>"


def parameters_of(member: Element) -> list[Piece]:
    pieces = [Piece("(")]
    for index, parameter in enumerate(member.findall("param")):
        pieces += [Piece(", ")] if index else []
        pieces += pieces_of(parameter.find("type"))
        name = parameter.findtext("declname") or ""
        pieces += [Piece(f" {name}")] if name else []
        array = parameter.findtext("array") or ""
        pieces += [Piece(array)] if array else []
        value = parameter.find("defval")
        pieces += [Piece(" = "), *pieces_of(value)] if value is not None else []
    return [*pieces, Piece(")")]


def signature_of(member: Element, name: str) -> list[Piece]:
    kind = member.get("kind")
    kept = without(pieces_of(member.find("type")), "inline", "static", "virtual")
    pieces = [Piece(word + " ") for word in ("static", "explicit") if member.get(word) == "yes"]
    pieces += [Piece("virtual ")] if member.get("virt") in ("virtual", "pure-virtual") else []
    if kind == "typedef":
        return [Piece("using "), Piece(name), Piece(" = "), *kept]
    if kind == "define":
        return [Piece("#define "), Piece(name), *parameters_of_macro(member)]
    pieces += [*kept, Piece(" ")] if kept else []
    pieces.append(Piece(name))
    if kind == "function":
        arguments = member.findtext("argsstring") or ""
        behind = re.sub(r"^\s*=\s*default$", "", arguments[arguments.rfind(")") + 1:])
        behind = re.sub(r"\s*=\s*", " = ", behind).strip()
        return [*pieces, *parameters_of(member), *([Piece(" " + behind)] if behind else [])]
    pieces += [Piece(member.findtext("argsstring") or "")]
    value = plain(pieces_of(member.find("initializer")))
    if value:
        pieces.append(Piece(" " + value if len(value) <= LONGEST_VALUE else " = …"))
    return pieces


def parameters_of_macro(member: Element) -> list[Piece]:
    names = [parameter.findtext("defname") or "" for parameter in member.findall("param")]
    return [Piece(f"({', '.join(names)})")] if names else []


def is_exempt(member: Element, name: str, owner: str) -> bool:
    """Returns true for functions whose meaning the language or a base class defines."""
    arguments = re.sub(r"\s", "", member.findtext("argsstring") or "")
    if member.get("kind") != "function":
        return False
    is_special = name in (owner, "~" + owner, "operator=")
    copies = is_special and re.match(rf"\((?:const)?{re.escape(owner)}&", arguments) is not None
    is_plain = name.startswith("~") or name == "operator==" or copies or (is_special and arguments == "()")
    return is_plain or arguments.endswith(("=default", "=delete", "override")) or member.find("reimplements") is not None


def is_hidden(member: Element, name: str, owner: str) -> bool:
    arguments = re.sub(r"\s", "", member.findtext("argsstring") or "")
    return name.startswith("~") or (arguments.endswith("=delete") and name in (owner, "operator="))


def qualified(name: str) -> str:
    return re.sub(r"^meristem::", "", name)


def member_of(element: Element, owner: str = "", scope: str = "") -> Declaration:
    name = element.findtext("name") or ""
    place = element.find("location")
    assert place is not None
    values = [(value.findtext("name") or "", comment_of(value)) for value in element.findall("enumvalue")]
    kind = element.get("kind") or ""
    signature = [Piece("enum class "), Piece(name)] if kind == "enum" else signature_of(element, name)
    return Declaration(element.get("id") or "", kind, name, scope + name, place.get("file") or "",
                       int(place.get("line") or 0), comment_of(element), signature, template_of(element), [], values,
                       is_exempt(element, name, owner))


def public_members(compound: Element) -> Iterator[Element]:
    for section in compound.findall("sectiondef"):
        yield from (member for member in section.findall("memberdef")
                    if member.get("prot") == "public" and member.get("kind") != "friend")


def class_of(compound: Element) -> Declaration:
    full = qualified(compound.findtext("compoundname") or "")
    name = full.rsplit("::", 1)[-1]
    place = compound.find("location")
    assert place is not None
    members = [member_of(member, name, full + "::") for member in public_members(compound)
               if not is_hidden(member, member.findtext("name") or "", name)]
    kind = compound.get("kind") or ""
    bases = [pieces for base in compound.findall("basecompoundref")
             for pieces in ([Piece(" : ") if base is compound.find("basecompoundref") else Piece(", ")],
                            [Piece(qualified(base.text or ""), base.get("refid") or "")])]
    signature = [Piece(kind + " "), Piece(name), *(piece for base in bases for piece in base)]
    return Declaration(compound.get("id") or "", kind, name, full, place.get("file") or "",
                       int(place.get("line") or 0), comment_of(compound), signature, template_of(compound),
                       sorted(members, key=lambda member: member.line))


def compounds_of(folder: Path) -> Iterator[Element]:
    for path in sorted(folder.glob("*.xml")):
        if path.name != "index.xml":
            yield from ElementTree.parse(path).getroot().findall("compounddef")


def read_declarations(folder: Path) -> list[Declaration]:
    """Returns all public declarations. Nested classes are members of their classes."""
    classes: dict[str, Declaration] = {}
    free: dict[str, Declaration] = {}
    inner: dict[str, str] = {}  # id of a public nested class to the id of the class around it
    nested_ids: set[str] = set()  # of nested classes, private ones too
    for compound in compounds_of(folder):
        kind = compound.get("kind")
        if kind in CLASSES:
            nested_ids.update(nested.get("refid") or "" for nested in compound.findall("innerclass"))
        if kind in CLASSES and "<" not in (compound.findtext("compoundname") or ""):
            classes[compound.get("id") or ""] = class_of(compound)
            inner.update({nested.get("refid") or "": compound.get("id") or ""
                          for nested in compound.findall("innerclass") if nested.get("prot") == "public"})
        elif kind in ("namespace", "file"):
            scope = qualified((compound.findtext("compoundname") or "") + "::") if kind == "namespace" else ""
            for member in public_members(compound):
                if kind == "namespace" or member.get("kind") == "define":
                    declaration = member_of(member, "", scope)
                    free[declaration.id] = declaration
    for nested, around in inner.items():
        if nested in classes and around in classes:
            classes[around].members.append(classes[nested])
            classes[around].members.sort(key=lambda member: member.line)
    top = [found for found in classes.values() if found.id not in nested_ids]
    return sorted([*top, *free.values()], key=lambda found: (found.file, found.line))


def head_of(text: str) -> str:
    """Returns the comment between the licence and `#pragma once`: paragraphs, and code that is indented."""
    head = text.partition("#pragma once")[0]
    lines = [line[2:].removeprefix(" ") for line in head.splitlines() if line.startswith("//") and "SPDX" not in line]
    is_item = False
    for index, line in enumerate(lines):
        is_item = line.startswith("- ") or (is_item and line.startswith("  "))
        if line.startswith("  ") and not is_item:
            lines[index] = "  " + line  # code, which comments indent by two
    return "\n".join(lines).strip("\n")


def purpose_of(text: str, declarations: list[Declaration]) -> str:
    """Returns the head of a header, or else the comment on its first class, function or other name."""
    order = {**{kind: 0 for kind in CLASSES}, "function": 1}
    described = sorted((one for one in declarations if one.text), key=lambda one: order.get(one.kind, 2))
    return head_of(text) or (described[0].text.partition("\n\n")[0] if described else "")


def escaped(text: str) -> str:
    """Returns the text of a header with comments in which no character is a command for doxygen."""
    text = re.sub(r"(///<?)(.*)", lambda comment: comment[1] + comment[2].translate(ESCAPES), text)
    return re.sub(r"(///) \|", rf"\1 {ROW}", text)


def run_doxygen(root: Path, folder: Path, paths: list[str]) -> list[str]:
    """Writes the XML of the headers to `folder`/xml. Returns doxygen's warnings."""
    shutil.rmtree(folder, ignore_errors=True)
    for path in paths:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(escaped((root / path).read_text(encoding="utf-8")), encoding="utf-8")
    (folder / "Doxyfile").write_text(DOXYFILE + f"INPUT = {' '.join(paths)}\n", encoding="utf-8")
    run = subprocess.run(["doxygen", "Doxyfile"], cwd=folder, capture_output=True, text=True)
    warnings = [line.replace(f"{folder}/", "") for line in (run.stdout + run.stderr).splitlines() if line.strip()]
    return warnings or ([f"doxygen ended with {run.returncode}"] if run.returncode else [])


def read_headers(folder: Path, root: Path, paths: list[str]) -> list[Header]:
    by_file: dict[str, list[Declaration]] = {}
    for declaration in read_declarations(folder):
        by_file.setdefault(declaration.file, []).append(declaration)
    headers = []
    for path in paths:
        found = by_file.get(path, [])
        headers.append(Header(path, purpose_of((root / path).read_text(encoding="utf-8"), found), found))
    return headers


def faults_of(headers: list[Header]) -> list[str]:
    """Lists public names without a comment. Overloads share the comment of the function above them."""
    faults = []

    def check(declarations: list[Declaration]) -> None:
        described: set[str] = set()
        for one in declarations:
            if one.text:
                described.add(one.qualified)
            elif not one.is_exempt and one.qualified not in described:
                faults.append(f"{one.file}:{one.line}: {one.kind} {one.qualified} has no comment")
            check(one.members)

    for header in headers:
        check(header.declarations)
        if not header.purpose:
            faults.append(f"{header.path}:1: the header does not state its purpose")
    return faults

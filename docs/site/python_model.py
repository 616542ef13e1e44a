# SPDX-License-Identifier: Apache-2.0
"""Reads the public names of the Python module.

In:  python/meristem/*.py and *.pyi for signatures and types; the built module for docstrings of compiled things.
Out: a Name for each public name, with members.

A test holds the stub to the module (python/tests/test_stubs.py), so signatures come from the stub. `faults_of` lists
public names without a docstring.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Union

Node = Union[ast.FunctionDef, ast.ClassDef, ast.AnnAssign]

SHOWN_OPERATORS = {"__getitem__": "self[{}]", "__iter__": "iter(self)", "__len__": "len(self)",
                   "__enter__": "with self"}
#: Types by their private names. read_names adds the aliases of all sources, such as `Wanted`.
PLAIN_TYPES = {"_ProgressCallback": "Callable[[str, float], object]"}


@dataclass
class Name:
    name: str
    kind: str  #: class, exception, function, method, property, attribute, constant
    text: str  #: the docstring, without the signature
    signatures: list[str]
    members: list[Name] = field(default_factory=list)


@dataclass
class Source:
    """The definitions of one file of the package, by name."""

    nodes: dict[str, list[Node]]
    comments: dict[int, str]  #: comments `#:` by line; lines that have nothing else are negative


def source_of(path: Path) -> Source:
    text = path.read_text(encoding="utf-8")
    nodes: dict[str, list[Node]] = {}
    for node in ast.parse(text).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            nodes.setdefault(node.name, []).append(node)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            nodes.setdefault(node.target.id, []).append(node)
    comments = {-number if line.lstrip().startswith("#:") else number: found[1].strip()
                for number, line in enumerate(text.splitlines(), 1) if (found := re.search(r"#: (.*)", line))}
    return Source(nodes, comments)


class Plain(ast.NodeTransformer):
    """Writes Union[A, B] as A | B, Optional[A] as A | None, Tuple as tuple, and quoted types without quotes."""

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:
        name = ast.unparse(node.value)
        if name == "Literal":
            return node
        self.generic_visit(node)
        parts = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if name not in ("Union", "Optional"):
            return node
        parts = [*parts, ast.Constant(None)] if name == "Optional" else parts
        joined = parts[0]
        for part in parts[1:]:
            joined = ast.BinOp(joined, ast.BitOr(), part)
        return joined

    def visit_Name(self, node: ast.Name) -> ast.AST:
        return ast.Name("tuple") if node.id == "Tuple" else node

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        return self.visit(ast.parse(node.value, mode="eval").body) if isinstance(node.value, str) else node


def type_text(node: ast.expr | None) -> str:
    if node is None:
        return ""
    text = ast.unparse(Plain().visit(node))
    for _ in range(2):  # aliases of aliases
        text = re.sub(r"\b\w+\b", lambda word: PLAIN_TYPES.get(word[0], word[0]), text)
    return re.sub(r"\bnp\.", "numpy.", text)


def aliases_of(text: str) -> dict[str, str]:
    """Returns the names of types that a source defines, such as `Wanted = Union[float, Tuple[float, float]]`."""
    found = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and \
                isinstance(node.value, (ast.Subscript, ast.BinOp)) and re.match(r"_?[A-Z][a-z]", node.targets[0].id):
            found[node.targets[0].id] = ast.unparse(Plain().visit(node.value))
    return found


def signature_text(name: str, function: ast.FunctionDef, is_method: bool) -> str:
    """Returns a signature as the source writes it, without `self` and without private parameters."""
    arguments = function.args
    places = [*arguments.posonlyargs, *arguments.args]
    defaults = [None] * (len(places) - len(arguments.defaults)) + list(arguments.defaults)
    if is_method and places and places[0].arg in ("self", "cls"):
        places, defaults = places[1:], defaults[1:]
    parts = [parameter_text(argument, default) for argument, default in zip(places, defaults)]
    if arguments.vararg:
        parts.append("*" + parameter_text(arguments.vararg, None))
    elif arguments.kwonlyargs:
        parts.append("*")
    parts += [parameter_text(argument, default)
              for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    if arguments.kwarg:
        parts.append("**" + parameter_text(arguments.kwarg, None))
    result = type_text(function.returns)
    shown = f"{name}({', '.join(parts)})"
    return shown if not result or function.name == "__init__" else f"{shown} -> {result}"


def parameter_text(argument: ast.arg, default: ast.expr | None) -> str:
    annotation = type_text(argument.annotation)
    text = f"{argument.arg}: {annotation}" if annotation else argument.arg
    return text if default is None else f"{text} = {ast.unparse(default)}" if annotation else \
        f"{text}={ast.unparse(default)}"


def docstring_of(value: Any) -> str:
    """Returns a docstring without the signatures that pybind11 puts at its head."""
    text = getattr(value, "__doc__", None) or ""
    if not inspect.isfunction(value) and not inspect.isclass(value):
        text = re.sub(r"^(\d+\. )?\w+\(.*$|^Overloaded function\.$", "", text, flags=re.MULTILINE)
    return inspect.cleandoc(re.sub(r"\n{3,}", "\n\n", text.strip("\n")))


def is_property(function: ast.FunctionDef) -> bool:
    return any(isinstance(mark, ast.Name) and mark.id in ("property", "cached_property")
               for mark in function.decorator_list)


def is_dataclass(node: ast.ClassDef) -> bool:
    return any("dataclass" in ast.unparse(mark) for mark in node.decorator_list)


def member_of(owner: Any, name: str, nodes: list[ast.FunctionDef], class_name: str) -> Name:
    value = inspect.getattr_static(owner, name, None)
    value = getattr(value, "__func__", value)
    if is_property(nodes[0]):
        return Name(name, "property", docstring_of(value), [f"{name}: {type_text(nodes[0].returns)}"])
    if name in SHOWN_OPERATORS:
        parameters = nodes[0].args.args[1:]
        shown = SHOWN_OPERATORS[name].format(parameters[0].arg if parameters else "")
        return Name(name, "method", docstring_of(value), [f"{shown} -> {type_text(nodes[0].returns)}"])
    is_static = any(isinstance(mark, ast.Name) and mark.id == "staticmethod" for mark in nodes[0].decorator_list)
    shown = f"{class_name}.{name}" if is_static else name
    return Name(name, "method", docstring_of(value), [signature_text(shown, node, not is_static) for node in nodes])


def class_of(name: str, value: Any, node: ast.ClassDef, source: Source) -> Name:
    members: dict[str, list[ast.FunctionDef]] = {}
    attributes = []
    for child in node.body:
        if isinstance(child, ast.Expr) and isinstance(child.value, ast.Constant) and attributes:
            attributes[-1].text = attributes[-1].text or inspect.cleandoc(str(child.value.value))
        elif isinstance(child, ast.FunctionDef):
            members.setdefault(child.name, []).append(child)
        elif isinstance(child, ast.AnnAssign) and isinstance(child.target, ast.Name) and child.target.id[0] != "_":
            text = source.comments.get(child.lineno, "") or comment_above(source, child.lineno)
            has_default = child.value is not None and not isinstance(child.value, ast.Call)
            default = f" = {ast.unparse(child.value)}" if has_default else ""
            attributes.append(Name(child.target.id, "attribute", text,
                                   [f"{child.target.id}: {type_text(child.annotation)}{default}"]))
    constructors = [signature_text(name, one, True) for one in members.pop("__init__", [])]
    if is_dataclass(node) and not constructors:
        constructors = [f"{name}({', '.join(one.signatures[0] for one in attributes)})"]
    shown = [member_of(value, one, nodes, name) for one, nodes in members.items()
             if not one.startswith("_") or one in SHOWN_OPERATORS]
    is_exception = inspect.isclass(value) and issubclass(value, Exception)
    return Name(name, "exception" if is_exception else "class", docstring_of(value), constructors or [name],
                [*attributes, *shown])


def comment_above(source: Source, line: int) -> str:
    """Returns the comment `#:` that has the line above to itself."""
    return source.comments.get(-(line - 1), "")


def read_names(package: Path, module: Any) -> list[Name]:
    """Returns the public names of a module of the package, in their order in `__all__`."""
    files = [*package.glob("*.py"), *package.glob("*.pyi")]
    for path in files:
        PLAIN_TYPES.update(aliases_of(path.read_text(encoding="utf-8")))
    sources = {path.stem: source_of(path) for path in files}
    names = []
    for name in module.__all__:
        value = getattr(module, name)
        if inspect.ismodule(value):
            continue
        home = getattr(value, "__module__", None) or "meristem._core"
        source = sources[home.rsplit(".", 1)[-1] if isinstance(home, str) else "_core"]
        if name not in source.nodes:
            source = sources["_core"]
        nodes = source.nodes[name]
        first = nodes[0]
        if isinstance(first, ast.ClassDef):
            names.append(class_of(name, value, first, source))
        elif isinstance(first, ast.FunctionDef):
            functions = [node for node in nodes if isinstance(node, ast.FunctionDef)]
            names.append(Name(name, "function", docstring_of(value),
                              [signature_text(name, node, False) for node in functions]))
        else:
            names.append(Name(name, "constant", comment_above(source, first.lineno),
                              [f"{name}: {type_text(first.annotation)}"]))
    return names


def read_module(root: Path) -> dict[str, list[Name]]:
    """Returns the public names of `meristem` and `meristem.grass`."""
    found = {}
    for module in ("meristem", "meristem.grass"):
        found[module] = read_names(root / "python" / "meristem", importlib.import_module(module))
    return found


def faults_of(names: dict[str, list[Name]]) -> list[str]:
    faults = []
    for module, found in names.items():
        for one in found:
            faults += [f"{module}.{one.name} has no docstring"] if not one.text else []
            faults += [f"{module}.{one.name}.{member.name} has no docstring" for member in one.members
                       if not member.text and member.name not in SHOWN_OPERATORS]
    return faults

# SPDX-License-Identifier: Apache-2.0
"""Compares the type stubs, the docstrings and the manual with the compiled module."""

from __future__ import annotations

import ast
import inspect
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any, Iterator, NamedTuple

import numpy as np
import pytest
from plants import small_tree

import meristem
from meristem import _core, grass

ROOT = Path(__file__).resolve().parents[2]
STUB = ROOT / "python" / "meristem" / "_core.pyi"

# Members of every class, and members needed for pickling.
UNLISTED = {"__doc__", "__module__", "__dict__", "__repr__", "__getstate__", "__setstate__", "__hash__"}
UNLISTED |= {"__slotnames__"}  # copyreg adds it to a class that was pickled

Stub = dict[str, list[ast.FunctionDef]]  # functions and properties by name; several if overloaded


class Parameter(NamedTuple):
    name: str
    is_keyword_only: bool
    default: Any


NO_DEFAULT = object()


def stub_classes() -> dict[str, Stub]:
    """Returns the members of each class of the stub. Members of the module have the key ''."""
    tree = ast.parse(STUB.read_text(encoding="utf-8"))
    public = [node for node in tree.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")]
    return {"": members_of(tree), **{node.name: members_of(node) for node in public}}


def members_of(node: ast.Module | ast.ClassDef) -> Stub:
    members: Stub = {}
    for child in node.body:
        if isinstance(child, ast.FunctionDef):
            members.setdefault(child.name, []).append(child)
    return members


def compiled_classes() -> dict[str, Any]:
    classes = {name: value for name, value in vars(_core).items() if inspect.isclass(value)}
    return {"": _core, **classes}


def compiled_members(owner: Any) -> set[str]:
    if isinstance(owner, ModuleType):
        return {name for name, value in vars(owner).items() if inspect.isroutine(value)}
    has_constructor = owner.__init__.__doc__.startswith("__init__(")
    return set(vars(owner)) - UNLISTED - (set() if has_constructor else {"__init__"})


def is_property(function: ast.FunctionDef) -> bool:
    return any(isinstance(mark, ast.Name) and mark.id == "property" for mark in function.decorator_list)


def functions() -> Iterator[tuple[str, list[ast.FunctionDef], str]]:
    """Yields each function with a docstring: its full name, its stubs, and pybind11's docstring."""
    compiled = compiled_classes()
    for class_name, members in stub_classes().items():
        for name, stubs in members.items():
            if not is_property(stubs[0]):
                function = getattr(compiled[class_name], name)
                docstring = getattr(function, "__doc__", "") or ""
                if inspect.isfunction(function):  # written in Python and added to the class
                    docstring = f"{name}{inspect.signature(function)}\n\n{docstring}"
                yield f"{class_name}.{name}".strip("."), stubs, docstring


def parameters_of(function: ast.FunctionDef) -> list[Parameter]:
    arguments = function.args
    places = [*arguments.posonlyargs, *arguments.args]
    values = [NO_DEFAULT] * (len(places) - len(arguments.defaults)) + [value_of(node) for node in arguments.defaults]
    found = [Parameter(argument.arg, False, value) for argument, value in zip(places, values)]
    for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults):
        found.append(Parameter(argument.arg, True, NO_DEFAULT if default is None else value_of(default)))
    return [parameter for parameter in found if parameter.name != "self"]


def value_of(node: ast.expr) -> Any:
    """Returns a default value. Fractions are rounded to floats, because pybind11 prints all digits of a float."""
    value = ast.literal_eval(node)
    return float(np.float32(value)) if isinstance(value, float) else value


def signatures_of(docstring: str) -> list[ast.FunctionDef]:
    """Returns the signature lines of a docstring: the first line, or the numbered lines if overloaded."""
    lines = docstring.splitlines()
    numbered = re.findall(r"^\d+\. (.*)$", docstring, re.MULTILINE)
    signatures = numbered if len(lines) > 1 and lines[1] == "Overloaded function." else lines[:1]
    trees = [ast.parse(f"def {line}: ...") for line in signatures]
    return [function for tree in trees for function in tree.body if isinstance(function, ast.FunctionDef)]


def text_of(docstring: str) -> str:
    """Returns a docstring without signatures."""
    return re.sub(r"^(\d+\. )?\w+\(.*$|^Overloaded function\.$", "", docstring, flags=re.MULTILINE).strip()


def test_stub_and_module_have_the_same_names() -> None:
    stubs, compiled = stub_classes(), compiled_classes()
    assert sorted(stubs) == sorted(compiled)
    assert len(stubs) > 10
    for name, owner in compiled.items():
        assert sorted(stubs[name]) == sorted(compiled_members(owner)), f"members of {name or 'the module'}"


def test_stub_and_signatures_have_the_same_parameters() -> None:
    checked = 0
    for name, stubs, docstring in functions():
        assert "::" not in docstring, f"{name} shows a C++ name, as of a class that is bound only later: {docstring}"
        signatures = signatures_of(docstring)
        # A function may have several types for different arguments.
        signatures = signatures * len(stubs) if len(signatures) == 1 else signatures
        assert len(stubs) == len(signatures), name
        for stub, signature in zip(stubs, signatures):
            assert parameters_of(stub) == parameters_of(signature), f"{name}: the stub says {ast.unparse(stub)}"
            checked += len(parameters_of(stub))
    assert checked > 50


def test_properties_are_properties_in_the_stub() -> None:
    compiled = compiled_classes()
    for class_name, members in stub_classes().items():
        for name, stubs in members.items():
            value = inspect.getattr_static(compiled[class_name], name)
            assert isinstance(value, property) == is_property(stubs[0]), f"{class_name}.{name}"


def test_everything_public_of_the_compiled_half_has_a_docstring() -> None:
    silent = [name for name, _, docstring in functions() if not text_of(docstring) and not name.endswith("__")]
    for class_name, owner in compiled_classes().items():
        properties = [name for name, value in vars(owner).items() if isinstance(value, property) and not value.__doc__]
        silent += [f"{class_name}.{name}" for name in properties]
        if class_name and not owner.__doc__:
            silent.append(class_name)
    assert silent == []


def test_everything_public_of_the_written_half_has_a_docstring() -> None:
    silent = []
    public = {name: getattr(module, name) for module in (meristem, grass) for name in module.__all__}
    for name, value in public.items():
        members: dict[str, Any] = vars(value) if inspect.isclass(value) else {}
        silent += [f"{name}.{key}" for key, member in members.items()
                   if (inspect.isfunction(member) or isinstance(member, property))
                   and not key.startswith("_") and not member.__doc__]
        if callable(value) and not value.__doc__:
            silent.append(name)
    assert silent == []


# --- types of results -------------------------------------------------------------------------------------------------


def grown_objects() -> list[Any]:
    """Returns one object of each class that growth makes."""
    document = meristem.Document(small_tree())
    plant = document.grow()
    stem = plant.stems[0]
    return [document, document.scene, plant, plant.organs, plant.prototypes[0], plant.meshes[0], plant.meshes[0].mesh,
            plant.materials[0], stem, stem.skeleton, meristem.derive("F(1)", 0), meristem.Progress(), *grass_objects()]


def grass_objects() -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "midrib.csv"
        file.write_text("rank,lindex,age,x,y\n1,2,0.5,0,0\n1,2,0.5,0,1\n1,2,0.5,1,2\n", encoding="utf-8")
        [measured] = grass.read_midribs(file)
    fitted = grass.fit_leaf(*measured.points.T, [0, 0.5, 1], [1, 0.8, 0])
    return [measured, fitted, fitted.leaf, grass.MidribFamily(fitted.leaf), grass.reduction_order(fitted.leaf)]


def is_of_type(value: Any, annotation: ast.expr) -> bool:
    """Returns true if a value has an annotated type, for the types that the stub uses."""
    if isinstance(annotation, ast.BinOp):
        return is_of_type(value, annotation.left) or is_of_type(value, annotation.right)
    if isinstance(annotation, ast.Constant):
        return value is annotation.value
    if isinstance(annotation, ast.Subscript):
        parts = annotation.slice.elts if isinstance(annotation.slice, ast.Tuple) else [annotation.slice]
        return is_of_container(value, ast.unparse(annotation.value), parts)
    name = ast.unparse(annotation)
    known: dict[str, Any] = {**vars(_core), **vars(meristem), "int": int, "str": str, "bool": bool, "float": float}
    return type(value) is known[name]


def is_of_container(value: Any, name: str, parts: list[ast.expr]) -> bool:
    if name == "NDArray" and not isinstance(value, np.ndarray):
        return False
    if name == "NDArray":
        wanted = np.dtype(ast.unparse(parts[0]).removeprefix("np."))
        # The width of a text column is the length of the longest text.
        same = value.dtype.kind == wanted.kind if wanted.kind == "U" else value.dtype == wanted
        return same
    if name == "dict":
        return isinstance(value, dict) and all(is_of_type(key, parts[0]) for key in value)
    if name == "list" or ast.unparse(parts[-1]) == "...":
        return type(value).__name__ == name and all(is_of_type(item, parts[0]) for item in value)
    return isinstance(value, tuple) and len(value) == len(parts) and all(map(is_of_type, value, parts))


def test_properties_have_the_types_of_the_stub() -> None:
    stubs = stub_classes()
    faults, checked = [], 0
    for thing in grown_objects():
        for name, (function, *_) in stubs[type(thing).__name__].items():
            if is_property(function):
                assert function.returns is not None
                value = getattr(thing, name)
                if not is_of_type(value, function.returns):
                    faults.append(f"{type(thing).__name__}.{name} is {value!r}, not {ast.unparse(function.returns)}")
                checked += 1
    assert faults == []
    assert checked > 40


# --- mypy, the manual -------------------------------------------------------------------------------------------------


def test_mypy_passes_strictly(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    folders = [ROOT / "python" / "meristem", ROOT / "python" / "examples", ROOT / "studies"]
    files = [str(file) for folder in folders for file in sorted(folder.rglob("*.py"))]
    assert len(files) > 3
    cache = os.environ.get("MYPY_CACHE_DIR", str(tmp_path))
    run = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", cache, *files,
                          str(ROOT / "python" / "build_backend.py")],
                         cwd=ROOT, env={**os.environ, "MYPYPATH": str(ROOT / "python")}, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_manual_names_everything_public() -> None:
    pages = [page.read_text(encoding="utf-8") for page in sorted((ROOT / "docs" / "manual").glob("python*.md"))]
    if not pages:
        pytest.skip("docs/manual/python.md is not written yet")
    words = set(re.findall(r"\w+", "\n".join(pages)))
    assert [name for name in (*meristem.__all__, *grass.__all__) if name not in words] == []

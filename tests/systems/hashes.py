#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hashes what the shipped documents grow to, and compares the hashes of two systems.

    tests/systems/hashes.py PROGRAM [DOCUMENT...]     prints a line `sha256  name` for each document (all of models/)
    tests/systems/hashes.py --compare LIST LIST       names the documents whose lines differ; exit code 1 if any does

A hash covers the GLB file that the document grows to: meshes, instances, materials and textures.
"""
import hashlib
import pathlib
import subprocess
import sys
import tempfile

MODELS = pathlib.Path(__file__).resolve().parents[2] / "models"


def hash_of(program, document, folder):
    """Returns the hash of the GLB file of a document."""
    target = pathlib.Path(folder) / "plant.glb"
    subprocess.run([program, "grow", str(document), "-o", str(target), "--quiet"], check=True)
    digest = hashlib.sha256()
    with open(target, "rb") as file:
        while piece := file.read(1 << 20):
            digest.update(piece)
    return digest.hexdigest()


def print_hashes(program, documents):
    with tempfile.TemporaryDirectory() as folder:
        for document in documents:
            print(f"{hash_of(program, document, folder)}  {document.stem}", flush=True)


def read_list(path):
    """Returns the hash of each name in a list."""
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    return {name: digest for digest, name in (line.split(maxsplit=1) for line in lines if line.strip())}


def compare(first, second):
    """Returns the sorted names whose hashes differ or that one list lacks."""
    return sorted(name for name in first.keys() | second.keys() if first.get(name) != second.get(name))


def main(arguments):
    if len(arguments) == 3 and arguments[0] == "--compare":
        first, second = map(read_list, arguments[1:])
        for name in (different := compare(first, second)):
            print(f"{name}: {first.get(name, 'missing')} and {second.get(name, 'missing')}")
        print(f"{len(first.keys() | second.keys()) - len(different)} documents have equal hashes, {len(different)} do not")
        return 1 if different or not first else 0
    if not arguments or arguments[0].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    documents = [pathlib.Path(name) for name in arguments[1:]] or sorted(MODELS.glob("*.json"))
    print_hashes(arguments[0], documents)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

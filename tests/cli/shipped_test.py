#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks shipped documents. `meristem check` must accept the documents of the manual's figures, with the settings of
each figure. Models must have few variables. Every picture that the manual shows must exist. figures_test.py checks the
models themselves, where it measures them.

Usage: shipped_test.py PROGRAM REPOSITORY
"""

import json
import pathlib
import re
import subprocess
import sys

program, repository = sys.argv[1], pathlib.Path(sys.argv[2])
figures = repository / "docs/manual/figures"
failures = 0


def fail(message):
    global failures
    failures += 1
    print(message)


def check(document, *settings):
    done = subprocess.run([program, "check", str(document), *settings], capture_output=True, text=True, timeout=60)
    told = done.stdout + done.stderr
    # Pictures of a variable's effect may use values beyond its sensible range.
    warnings = [line for line in told.splitlines() if "warning" in line and not ("--set" in settings and "beyond its range" in line)]
    if done.returncode != 0 or warnings:
        fail(f"{document.name} {' '.join(settings)}:\n{told}")


def only_settings(options):
    """Returns the --set options among options of `render`, each with its value."""
    return [word for k, option in enumerate(options) if option == "--set" for word in options[k:k + 2]]


models = sorted((repository / "models").glob("*.json"))
documents = sorted(figures.glob("*.json"))
for path in documents + sorted((repository / "models" / "films").glob("*.json")):
    check(path)

for path in models:
    text = re.sub(r"^\s*//.*$", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    variables = json.loads(text).get("variables", {})
    handles = [v for v in variables.values() if not (isinstance(v, dict) and v.get("private"))]
    if not 1 <= len(handles) <= 6:
        fail(f"{path.name} has {len(handles)} variables; a person wants one to six")

pictures = set()
for line in (figures / "figures.txt").read_text(encoding="utf-8").splitlines():
    if line.strip() and not line.startswith("#"):
        name, document, *options = line.split()
        pictures.add(name)
        # The documents were grown above. With settings they are only read, because there are hundreds of pictures.
        check(figures / f"{document}.json", "--quick", *only_settings(options))

manifest = {line.split()[1] for line in (repository / "docs" / "pictures.txt").read_text(encoding="utf-8").splitlines()
            if not line.startswith("#")}
for picture in (repository / "docs").glob("**/*.*g"):
    if picture.suffix not in (".png", ".jpg"):
        continue
    if picture.stat().st_size > 250_000:
        fail(f"{picture}: a picture of {picture.stat().st_size} bytes; everyone who clones carries it")
    name = picture.relative_to(repository).as_posix()
    # JPEGs show plants. PNGs are charts of studies. Tests of the studio draw the pictures of its page, and `meristem
    # shade` draws pictures of shade.
    is_no_render = name.startswith(("docs/manual/studio/", "docs/manual/figures/shade-"))
    if picture.suffix == ".jpg" and not is_no_render and name not in manifest:
        fail(f"{picture}: docs/pictures.txt does not say what it shows; draw it with ./dev gallery, and charts of studies as PNG")
for name in manifest:
    if not (repository / name).is_file():
        fail(f"docs/pictures.txt: there is no picture {name}")
for name in pictures:
    if f"docs/manual/figures/{name}.jpg" not in manifest:
        fail(f"figures.txt: docs/pictures.txt has no {name}; draw it with ./dev gallery")

# Each type except the camera has a document and a picture for the palette of the studio.
listed = subprocess.run([program, "components", "--json"], capture_output=True, text=True, check=True, timeout=60).stdout
types = list(json.loads(listed)["components"])
for name in types:
    part = repository / "apps/studio/parts" / f"{name}.json"
    if name == "camera":
        continue
    if not part.is_file():
        fail(f"{part}: the studio's palette needs a document of the type {name}")
    elif f"apps/studio/parts/{name}.jpg" not in manifest:
        fail(f"docs/pictures.txt has no picture of {part}; draw it with ./dev gallery")

if not (models and documents and pictures and types):
    fail("there are no models, no documents or no figures")
print(f"{len(models)} models, {len(documents)} documents of {len(pictures)} figures, {failures} faults")
sys.exit(failures > 0)

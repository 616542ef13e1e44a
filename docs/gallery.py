#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the pictures of the documentation that have changed, and writes the gallery page.

In:  the built program, models/*.json, docs/manual/figures/figures.txt and graphs.txt, apps/studio/parts/*.json,
     docs/pictures.txt.
Out: docs/gallery/*.jpg, docs/manual/figures/*.jpg and *.svg, apps/studio/parts/*.jpg, docs/pictures.txt with the
     fingerprint of each picture, docs/gallery.md.

A picture is drawn again only if its fingerprint differs from its fingerprint in docs/pictures.txt. `meristem render
--fingerprint` prints the fingerprint without drawing. `--check` draws and writes nothing, and ends with 1 if a picture
has changed. `--accept` accepts the pictures as they are. Named pictures are always drawn anew.
"""

import argparse
import html
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
MANIFEST = ROOT / "docs" / "pictures.txt"
PAGE = ROOT / "docs" / "gallery.md"
FIGURES = ROOT / "docs" / "manual" / "figures"
MOST_KILOBYTES = 250  # of one picture, to keep clones small
QUALITY = 88

# Documents that are also shown with other settings: picture, model, options.
FURTHER = [("oak_young", "oak", ["--set", "age=10"]), ("oak_old", "oak", ["--set", "age=140"])]


class Picture(NamedTuple):
    path: Path
    document: Path
    options: list[str]

    @property
    def name(self) -> str:
        return self.path.relative_to(ROOT).as_posix()


def planned_pictures() -> list[Picture]:
    gallery = ROOT / "docs" / "gallery"
    models = sorted((ROOT / "models").glob("*.json"))
    pictures = [Picture(gallery / f"{model.stem}.jpg", model, []) for model in models]
    pictures += [Picture(gallery / f"{name}.jpg", ROOT / "models" / f"{model}.json", options)
                 for name, model, options in FURTHER]
    pictures += [Picture(part.with_suffix(".jpg"), part, [])
                 for part in sorted((ROOT / "apps" / "studio" / "parts").glob("*.json"))]
    for line in (FIGURES / "figures.txt").read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            name, document, *options = line.split()
            pictures.append(Picture(FIGURES / f"{name}.jpg", FIGURES / f"{document}.json", options))
    return pictures


def read_manifest() -> dict[str, str]:
    if not MANIFEST.is_file():
        return {}
    lines = MANIFEST.read_text(encoding="utf-8").splitlines()
    return dict(reversed(line.split(maxsplit=1)) for line in lines if line and not line.startswith("#"))


def write_manifest(fingerprints: dict[str, str]) -> None:
    head = "# What each picture shows, as `meristem render --fingerprint` tells it; `./dev gallery` keeps this file.\n"
    MANIFEST.write_text(head + "".join(f"{fingerprints[name]} {name}\n" for name in sorted(fingerprints)),
                        encoding="utf-8")


def run(program: str, *arguments: str) -> str:
    done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, cwd=ROOT, check=False, encoding="utf-8")
    if done.returncode != 0:
        sys.exit(f"gallery: this failed: {' '.join([program, *arguments])}")
    return done.stdout


def draw(program: str, picture: Picture) -> None:
    run(program, "render", str(picture.document), "-o", str(picture.path), "--quiet", "--quality", str(QUALITY),
        "--max-size", str(MOST_KILOBYTES), *picture.options)


def update_pictures(program: str, wanted: list[str], check: bool, accept: bool) -> int:
    """Draws the changed pictures, or only counts them, or accepts the pictures as they are."""
    fingerprints = read_manifest()
    pictures = planned_pictures()
    moved = 0
    kept = {}
    for number, picture in enumerate(pictures, start=1):
        present = run(program, "render", str(picture.document), "--fingerprint", "--quiet", *picture.options).strip()
        is_same = fingerprints.get(picture.name) == present and picture.path.is_file()
        if not is_same or picture.path.stem in wanted:
            moved += 1
            print(f"[{number}/{len(pictures)}] {picture.name}{' has moved' if check else ''}", flush=True)
            if not check and not accept:
                draw(program, picture)
        kept[picture.name] = present
        if not check:
            write_manifest({**fingerprints, **kept})
    if not check:
        write_manifest(kept)
    return moved


def update_graphs(program: str, check: bool) -> int:
    """Draws the manual's changed graphs, or only counts them. Graphs are drawn for the comparison."""
    moved = 0
    for line in (FIGURES / "graphs.txt").read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        name, document, *options = line.split()
        path = FIGURES / f"{name}.svg"
        drawing = run(program, "graph", str(FIGURES / f"{document}.json"), "--quiet", *options)
        if path.is_file() and path.read_text(encoding="utf-8") == drawing:
            continue
        moved += 1
        print(f"{path.relative_to(ROOT)}{' has moved' if check else ''}", flush=True)
        if not check:
            path.write_text(drawing, encoding="utf-8")
    return moved


def facts_of(program: str, model: Path) -> dict[str, str]:
    """Returns the figures of a plant for the gallery."""
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        run(program, "grow", str(model), "-o", f"{folder}/plant.glb", "--quiet")
        seconds = time.perf_counter() - begin
        megabytes = Path(folder, "plant.glb").stat().st_size / 1e6
    measures = json.loads(run(program, "measure", str(model), "--json", "--quiet"))

    def number(name: str, form: str) -> str:
        value = measures.get(name)
        return format(value, form if value < 100 or form == ",d" else ",.0f") if value else "-"

    return {"triangles": number("triangles", ",d"), "seconds": f"{seconds:.2f}", "megabytes": f"{megabytes:.1f}",
            "height": number("height", ".2f"), "leaf_area": number("leaf_area", ".3g")}


def title_of(model: Path) -> tuple[str, str]:
    """Returns the name and the description of a document."""
    text = "\n".join(line for line in model.read_text(encoding="utf-8").splitlines()
                     if not line.lstrip().startswith("//"))
    document = json.loads(text)
    return document.get("name", model.stem), document.get("description", "")


def write_page(program: str) -> None:
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, stdout=subprocess.PIPE, check=False,
                            encoding="utf-8").stdout.strip()
    models = sorted((ROOT / "models").glob("*.json"))
    lines = ["# Gallery", "",
             "Every plant here is a text document in [`models/`](../models). `meristem render oak -o oak.png` draws a plant, and "
             "`meristem grow oak -o oak.glb` writes its 3D model. Copy a document and change its numbers to make a plant of your "
             "own.", "",
             "| | | | |", "| --- | --- | --- | --- |"]
    for begin in range(0, len(models), 4):
        row = models[begin:begin + 4]
        lines.append("| " + " | ".join(f"![{html.escape(title_of(model)[0])}](gallery/{model.stem}.jpg)"
                                       for model in row) + " |" + " |" * (4 - len(row)))
        lines.append("| " + " | ".join(f"[`{model.stem}`](../models/{model.name})" for model in row) + " |" +
                     " |" * (4 - len(row)))
    lines += ["", "The oak at 10 and at 140 years (`--set age=10`, `--set age=140`):", "",
              "![The oak at 10 years](gallery/oak_young.jpg) ![The oak at 140 years](gallery/oak_old.jpg)", "",
              "## Triangles and seconds", "",
              f"`./dev gallery` has measured this table with version {commit} on a machine of two cores. *Seconds* is the "
              "time of the whole command `meristem grow MODEL -o plant.glb`, and *MB* the size of the file.", "",
              "| document | what | triangles | seconds | MB | height, m | leaf area, m² |",
              "| --- | --- | ---: | ---: | ---: | ---: | ---: |"]
    for model in models:
        facts = facts_of(program, model)
        lines.append(f"| [`{model.stem}`](../models/{model.name}) | {title_of(model)[1]} | {facts['triangles']} | "
                     f"{facts['seconds']} | {facts['megabytes']} | {facts['height']} | {facts['leaf_area']} |")
    PAGE.write_text("\n".join(lines) + "\n", encoding="utf-8")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the built program")
    parser.add_argument("--check", action="store_true", help="draw nothing; end with 1 where a picture has moved")
    parser.add_argument("--accept", action="store_true",
                        help="draw nothing; note that the pictures show what the program would draw now")
    parser.add_argument("names", nargs="*", help="pictures to draw in any case, such as `oak`")
    arguments = parser.parse_args()
    program = str(Path(arguments.program).resolve())
    moved = update_graphs(program, arguments.check)
    moved += update_pictures(program, arguments.names, arguments.check, arguments.accept)
    if arguments.check:
        return 1 if moved else 0
    print(f"{moved} pictures {'accepted' if arguments.accept else 'drawn'}")
    write_page(program)
    return 0


if __name__ == "__main__":
    sys.exit(main())

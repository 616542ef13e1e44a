# SPDX-License-Identifier: Apache-2.0
"""Collects the pages of the site in one folder, for Sphinx.

In:  the Markdown pages of the source tree, the public headers, the names of the Python module.
Out: the pages at the paths that they have in the source tree, and index.rst, reference/cpp/* and reference/python/*.

The Markdown is written for readers of the repository. Two things change in the copies. A link to a file
that is no page becomes `source:PATH` (source_pages.py). A picture in a table becomes a thumbnail with a link to the
picture. Lines stay, so that messages name the right ones.
"""

from __future__ import annotations

import json
import posixpath
import re
import shutil
import sys
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "architecture"))
import include_rule  # noqa: E402
import link_rule  # noqa: E402

SITE = Path(__file__).resolve().parent
PAGE_LIST = PurePosixPath("docs/manual/index.md")  # its headings and links are the contents of the site
THUMBNAIL = 480  # pixels, the longer side: twice the width of a column
PICTURE = re.compile(r"(?<!\[)!\[([^\]]*)\]\(([^)\s]+)\)")


@dataclass
class Site:
    root: Path
    folder: Path  #: of the collected pages
    sources: set[str]  #: files and folders that pages link to and that are no pages
    thumbnails: set[str]


def public_headers(root: Path) -> list[str]:
    """Returns the paths of the public headers, as programs include them."""
    return [f"meristem/{room}/{header}" for room in include_rule.ROOMS
            for header in include_rule.room_lists(root / "meristem" / room / "CMakeLists.txt")["HEADERS"]]


def rooms(root: Path) -> dict[str, str]:
    """Returns what lives in each room, from the table of the page on architecture."""
    text = (root / "docs" / "architecture.md").read_text(encoding="utf-8")
    found = dict(re.findall(r"^\| `(\w+)` \| (.*) \|$", text, re.MULTILINE))
    return {room: found[room] for room in include_rule.ROOMS}


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def copy(site: Site, name: str) -> None:
    target = site.folder / name
    target.parent.mkdir(parents=True, exist_ok=True)
    if not target.exists():
        shutil.copy2(site.root / name, target)


# --- Markdown ---------------------------------------------------------------------------------------------------------


def with_thumbnails(site: Site, page: PurePosixPath, text: str) -> str:
    """Makes the pictures of tables small, with links to the large ones."""
    def change(found: re.Match[str]) -> str:
        name = posixpath.normpath(page.parent / found[2])
        if not name.endswith((".jpg", ".png")) or not (site.root / name).exists():
            return found[0]
        site.thumbnails.add(name)
        site.sources.add(name)
        return f"[![{found[1]}](/thumbnails/{name})](source:{name})"

    lines = [PICTURE.sub(change, line) if line.startswith("|") else line for line in text.split("\n")]
    return "\n".join(lines)


def staged_page(site: Site, page: PurePosixPath, pages: set[PurePosixPath], text: str) -> str:
    def new_target(link: link_rule.Link) -> str:
        file = link_rule.file_of(page, link.target)
        if file is None or link.target.startswith("/") or not (site.root / file).exists():
            return link.target  # Sphinx warns of files that do not exist
        if link.is_picture:
            copy(site, file.as_posix())
            return link.target
        if file in pages:
            return link.target
        site.sources.add(file.as_posix())
        return f"source:{file.as_posix()}"

    return link_rule.with_targets(with_thumbnails(site, page, text), new_target)


def contents(pages: dict[PurePosixPath, str]) -> list[tuple[str, list[str]]]:
    """Returns the headings of the manual's first page with their pages, and all other pages as "Project"."""
    found: list[tuple[str, list[str]]] = []
    seen: set[PurePosixPath] = set()
    text = pages[PAGE_LIST]
    for heading, body in re.findall(r"^## (.*)\n((?:(?!## ).*\n?)*)", text, re.MULTILINE):
        names = [link_rule.file_of(PAGE_LIST, link.target) for link in link_rule.links_of(body)]
        listed = [name for name in dict.fromkeys(names) if name in pages and name not in seen]
        seen.update(listed)
        found.append((heading, [docname(name) for name in listed]))
    found[0][1].insert(0, docname(PAGE_LIST))
    found[-1][1].extend(["reference/python/index", "reference/cpp/index"])
    others = [page for page in pages if page not in seen and page != PAGE_LIST]
    order = ["README.md", "docs/architecture.md", "CONTRIBUTING.md"]
    others.sort(key=lambda page: (order.index(str(page)) if str(page) in order else len(order), str(page)))
    return [*found, ("Project", [docname(page) for page in others])]


def docname(page: PurePosixPath) -> str:
    return page.with_suffix("").as_posix()


def toctree(caption: str, names: list[str]) -> str:
    lines = [".. toctree::", "   :hidden:", *([f"   :caption: {caption}"] if caption else []), ""]
    return "\n".join([*lines, *(f"   {name}" if " </" in name else f"   /{name}" for name in names), "", ""])


# --- references -------------------------------------------------------------------------------------------------------


def titled(title: str, *parts: str) -> str:
    return "\n".join([title, "=" * len(title), "", *parts, ""])


def write_cpp_pages(site: Site, headers: list[str]) -> None:
    names = list(rooms(site.root))
    for header in headers:
        page = header.removeprefix("meristem/").removesuffix(".h")
        write(site.folder / "reference" / "cpp" / f"{page}.rst",
              ":orphan:\n\n" + titled(f"{page}.h", f".. cpp-header:: {header}"))
    for room in names:
        write(site.folder / "reference" / "cpp" / f"{room}.rst", titled(f"Room {room}", f".. cpp-room:: {room}"))
    write(site.folder / "reference" / "cpp" / "names.rst", titled("All C++ names", ".. cpp-names:: all"))
    listed = toctree("", [f"reference/cpp/{name}" for name in [*names, "names"]])
    first = (SITE / "cpp.rst").read_text(encoding="utf-8")
    write(site.folder / "reference" / "cpp" / "index.rst", first + "\n" + listed)


def write_python_pages(site: Site, classes: list[str]) -> None:
    titles = {"functions": "Functions and constants", "errors": "Errors", "grass": "meristem.grass"}
    for name in [*classes, *titles]:
        write(site.folder / "reference" / "python" / f"{name}.rst",
              titled(titles.get(name, f"meristem.{name}"), f".. python-page:: {name}"))
    names = [f"{titles.get(name, name)} </reference/python/{name}>"
             for name in ["functions", *classes, "errors", "grass"]]
    listed = toctree("", names)
    write(site.folder / "reference" / "python" / "index.rst",
          (SITE / "python.rst").read_text(encoding="utf-8") + "\n" + listed)


# ----------------------------------------------------------------------------------------------------------------------


def make_thumbnails(site: Site) -> None:
    from PIL import Image  # a package of the site alone

    for name in sorted(site.thumbnails):
        target = site.folder / "thumbnails" / name
        if target.exists() and target.stat().st_mtime >= (site.root / name).stat().st_mtime:
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        with Image.open(site.root / name) as picture:
            picture.draft("RGB", (2 * THUMBNAIL, 2 * THUMBNAIL))
            picture.thumbnail((THUMBNAIL, THUMBNAIL))
            picture.save(target, quality=85)


def collect_pages(root: Path, folder: Path, classes: list[str]) -> Site:
    """Writes all pages below `folder`."""
    for old in folder.glob("*"):
        if old.name != "thumbnails":
            shutil.rmtree(old) if old.is_dir() else old.unlink()
    site = Site(root, folder, set(), set())
    tree = link_rule.Tree(root)
    pages = {page: text for page, text in tree.texts.items() if not page.parts[0].startswith(".")}
    for page, text in pages.items():
        write(folder / page, staged_page(site, page, set(pages), text))
    write_cpp_pages(site, public_headers(root))
    write_python_pages(site, classes)
    parts = [toctree(caption, names) for caption, names in contents(pages)]
    for page in SITE.glob("*.rst"):
        site.sources.update(re.findall(r"<source:([^>]+)>", page.read_text(encoding="utf-8")))
    first = (SITE / "index.rst").read_text(encoding="utf-8")
    for picture in re.findall(r"image:: /(\S+)", first):
        copy(site, picture)
    write(folder / "index.rst", first + "\n" + "".join(parts))
    make_thumbnails(site)
    write(folder / "sources.json", json.dumps(sorted(site.sources)))
    return site

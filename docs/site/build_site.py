#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the documentation site. Usage: build_site.py OUTPUT [JOBS]

In:  the Markdown pages, the public C++ headers, the built Python module in PYTHONPATH.
Out: OUTPUT/html/index.html. Exit code 1 after any warning, a public name without a comment, or a broken link.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote

sys.path.insert(0, str(Path(__file__).resolve().parent))
import python_model  # noqa: E402
import stage  # noqa: E402
import theme  # noqa: E402

LINK = re.compile(r'<(?:a|img|link|script)\b[^>]*?\b(?:href|src)="([^"]*)"')
ANCHOR = re.compile(r'\b(?:id|name)="([^"]+)"')


def broken_links(site: Path) -> list[str]:
    """Returns the links of all pages that lead to no file or no place within the site."""
    texts = {path: path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    anchors = {path: set(ANCHOR.findall(text)) for path, text in texts.items()}
    faults = set()
    for page, text in texts.items():
        for target in set(LINK.findall(text)):
            name, _, anchor = unquote(target.replace("&amp;", "&")).partition("#")
            name = name.partition("?")[0]
            if re.match(r"[a-z]+:|//", name):
                continue
            file = (page.parent / name).resolve() if name else page
            if file.is_dir():
                file /= "index.html"
            where = f"{page.relative_to(site)}: {target}"
            if not file.exists():
                faults.add(f"{where}: there is no such file")
            elif anchor and file in anchors and anchor not in anchors[file]:
                faults.add(f"{where}: the page has no such place")
    return sorted(faults)


def main() -> int:
    output = Path(sys.argv[1]).resolve()
    jobs = sys.argv[2] if len(sys.argv) > 2 else "auto"
    names = python_model.read_module(stage.ROOT)
    classes = [name.name for name in names["meristem"] if name.kind == "class"]
    stage.collect_pages(stage.ROOT, output / "pages", classes)
    html = output / "html"
    shutil.rmtree(html, ignore_errors=True)  # pages that no longer exist
    run = subprocess.run(
        [sys.executable, "-B", "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q", "-E", "-j", jobs,
         "-c", str(stage.SITE), "-d", str(output / "doctrees"), "-D", f"reference_work={output / 'doxygen'}",
         str(output / "pages"), str(html)])
    if not (html / "index.html").exists():
        return 1  # Sphinx has stopped
    theme.mend_theme(html)
    faults = broken_links(html)
    print(*(f"broken link: {fault}" for fault in faults[:100]), sep="\n", end="\n" if faults else "")
    return 1 if run.returncode or faults else 0


if __name__ == "__main__":
    sys.exit(main())

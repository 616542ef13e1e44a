# SPDX-License-Identifier: Apache-2.0
"""Mends what the theme furo lacks as Debian 12 packs it.

Debian's style sheet has no rules for systems that prefer dark pages, and imports a file that is not there. Its script
is a module without its bundle. Other versions of furo stay as they are.
"""

from __future__ import annotations

import re
from pathlib import Path

DARK = re.compile(r'@media not print \{\s*body\[data-theme="dark"\] \{(.*?)\}', re.DOTALL)


def mended_style(css: str) -> str:
    css = re.sub(r"^@import url\(/javascript/[^)]*\);\n", "", css)
    dark = DARK.search(css)
    if "prefers-color-scheme" in css or dark is None:
        return css
    return (css + "\n@media not print {\n  @media (prefers-color-scheme: dark) {\n"
            f'    body:not([data-theme="light"]) {{{dark[1]}}}\n  }}\n}}\n')


def mend_theme(html: Path) -> None:
    """Changes the copies of the theme's files in a built site."""
    style, script = html / "_static/styles/furo.css", html / "_static/scripts/furo.js"
    style.write_text(mended_style(style.read_text(encoding="utf-8")), encoding="utf-8")
    if script.read_text(encoding="utf-8").startswith("import "):
        script.write_text((html / "_static/theme.js").read_text(encoding="utf-8"), encoding="utf-8")

# SPDX-License-Identifier: Apache-2.0
"""Sphinx's settings for the documentation site; build_site.py runs Sphinx with them."""

import re
import sys
from pathlib import Path

from pygments.lexers import JavascriptLexer

sys.path.insert(0, str(Path(__file__).resolve().parent))
import stage  # noqa: E402

project = "Meristem"
author = "The Meristem authors"
release = re.search(r"^version: (.*)$", (stage.ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)[1]
extensions = ["myst_parser", "reference", "sidebar", "source_pages"]

myst_heading_anchors = 6
myst_url_schemes = ("http", "https", "mailto", "source")

reference_headers = stage.public_headers(stage.ROOT)
reference_rooms = stage.rooms(stage.ROOT)

html_theme = "furo"
html_title = f"Meristem {release}"
html_logo = html_favicon = str(stage.ROOT / "apps/studio/page/src/icon.svg")
html_static_path = [str(stage.SITE / "static")]
html_css_files = ["site.css"]
html_js_files = [("site.js", {"defer": "defer"})]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_use_index = False
html_domain_indices = False
# The studio's page has equal colours (apps/studio/page/src/style/base.css).
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#217a48", "color-brand-content": "#1a663b",
                            "color-api-name": "#1d231f"},
    "dark_css_variables": {"color-brand-primary": "#58c183", "color-brand-content": "#72d198",
                           "color-api-name": "#e4e9e5"},
}
pygments_style = "friendly"
pygments_dark_style = "github-dark"
highlight_language = "none"
smartquotes = False  # quotes in the manual and in comments are often those of code


def setup(app):
    """Documents contain comments, and parts of documents contain "...", which Pygments' lexer of JSON refuses."""
    for name in ("json", "jsonc"):
        app.add_lexer(name, JavascriptLexer)

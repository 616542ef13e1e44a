#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""CMakeLists.txt, CHANGELOG.md, CITATION.cff and the pages that name packages agree on one release and one date.

Usage: release_test.py ROOT
"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])


def found(name: str, pattern: str) -> str:
    match = re.search(pattern, (root / name).read_text(encoding="utf-8"), re.MULTILINE)
    return match[1] if match else f"nothing that matches {pattern}"


RELEASE = r"^## (\d+\.\d+\.\d+) - \d{4}-\d\d-\d\d$"
DATE = r"^## \d+\.\d+\.\d+ - (\d{4}-\d\d-\d\d)$"
facts = {
    "version": {"CMakeLists.txt": found("CMakeLists.txt", r"^project\(meristem VERSION (\S+)"),
                "CHANGELOG.md": found("CHANGELOG.md", RELEASE),
                "CITATION.cff": found("CITATION.cff", r"^version: (\S+)$"),
                "README.md": found("README.md", r"/meristem_(\S+)_amd64\.deb"),
                "docs/manual/python.md": found("docs/manual/python.md", r"/python3-meristem_(\S+)_amd64\.deb")},
    "date": {"CHANGELOG.md": found("CHANGELOG.md", DATE),
             "CITATION.cff": found("CITATION.cff", r"^date-released: (\S+)$")},
}
faults = [f"the {fact} differs: {', '.join(f'{name} has {text}' for name, text in of_files.items())}"
          for fact, of_files in facts.items() if len(set(of_files.values())) > 1]
print(*faults, f"{len(faults)} faults", sep="\n")
sys.exit(bool(faults))

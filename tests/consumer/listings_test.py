#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the manual's page on C++. It must show exactly the programs that the tests build and run, each as a whole. The
headers and folders that it names must be installed. Usage: listings_test.py REPOSITORY
"""

import pathlib
import re
import sys

repository = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(repository / "tests/architecture"))
import include_rule  # noqa: E402

page = repository / "docs/manual/cpp.md"
programs = {path.name: path.read_text(encoding="utf-8") for path in (repository / "tests/consumer").glob("*.cpp")}
licence = "// SPDX-License-Identifier: Apache-2.0\n"
text = page.read_text(encoding="utf-8")
failures = 0

for block in re.finditer(r"^```cpp\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
    names = [name for name, program in programs.items() if program == licence + block[1]]
    for name in names:
        del programs[name]
    if not names:
        failures += 1
        print(f"{page}:{1 + text.count(chr(10), 0, block.start())}: this is no program of tests/consumer")
for name in programs:
    failures += 1
    print(f"{page}: does not show {name} as it is")
installed = {f"{room}/{header}" for room in include_rule.ROOMS
             for header in include_rule.room_lists(repository / "meristem" / room / "CMakeLists.txt")["HEADERS"]}
for name in re.findall(r"`([a-z]+/[a-z_/]*(?:\.h|/))`", text):
    if not any(header == name or (name.endswith("/") and header.startswith(name)) for header in installed):
        failures += 1
        print(f"{page}: names {name}, which is not installed")
sys.exit(failures > 0)

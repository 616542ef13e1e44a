#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that include_rule.py finds each kind of error, in small artificial source trees."""

import tempfile
import unittest
from pathlib import Path

import include_rule


class IncludeRule(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        self.write("meristem/CMakeLists.txt", "".join(f"add_subdirectory({room})\n" for room in include_rule.ROOMS))
        for room in include_rule.ROOMS:
            self.write(f"meristem/{room}/CMakeLists.txt", f"meristem_room({room} HEADERS a.h)")
            self.write(f"meristem/{room}/a.h", "#pragma once\n")

    def write(self, name: str, text: str) -> None:
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def faults(self) -> list[str]:
        return [fault.text(self.root) for fault in include_rule.check(self.root)]

    def assert_only_fault(self, *parts: str) -> None:
        faults = self.faults()
        self.assertEqual(len(faults), 1, faults)
        for part in parts:
            self.assertIn(part, faults[0])

    def test_a_tree_that_keeps_the_rule_has_no_fault(self) -> None:
        self.write("meristem/grow/CMakeLists.txt",
                   "meristem_room(grow HEADERS a.h SOURCES a.cpp TESTS a_test.cpp PUBLIC meristem::scene fmt::fmt)")
        self.write("meristem/grow/a.h", '#include "meristem/scene/a.h"\n')
        self.write("meristem/grow/a.cpp", '#include "meristem/grow/a.h"\n#include <nlohmann/json.hpp>\n')
        self.write("meristem/grow/a_test.cpp", '#include "meristem/base/a.h"\n#include "tests/support/a.h"\n')
        self.assertEqual(self.faults(), [])

    def test_a_room_may_not_include_a_later_one(self) -> None:
        self.write("meristem/plant/a.h", '#pragma once\n\n#  include "meristem/graph/a.h"\n')
        self.assert_only_fault("meristem/plant/a.h:3:", "plant stands before graph")

    def test_a_room_links_what_it_includes(self) -> None:
        self.write("meristem/grow/CMakeLists.txt", "meristem_room(grow HEADERS a.h PRIVATE meristem::scene)")
        self.write("meristem/grow/a.h", '#include "meristem/scene/a.h"\n')
        faults = self.faults()
        self.assertEqual(len(faults), 2, faults)
        self.assertIn("grow includes scene and does not link it as PUBLIC", faults[0])
        self.assertIn("links meristem::scene as PRIVATE without including it so", faults[1])

    def test_what_tests_include_is_no_link_of_the_room(self) -> None:
        self.write("meristem/grow/CMakeLists.txt",
                   "meristem_room(grow HEADERS a.h TESTS a_test.cpp TESTED_WITH meristem::scene)")
        self.write("meristem/grow/a_test.cpp", '#include "meristem/scene/a.h"\n')
        self.assertEqual(self.faults(), [])

    def test_folders_of_a_room_include_each_other_without_a_circle(self) -> None:
        self.write("meristem/grow/CMakeLists.txt", "meristem_room(grow HEADERS a.h b/b.h c/c.h)")
        self.write("meristem/grow/b/b.h", '#include "meristem/grow/c/c.h"\n')
        self.write("meristem/grow/c/c.h", "#pragma once\n")
        self.assertEqual(self.faults(), [])
        self.write("meristem/grow/c/c.h", '#include "meristem/grow/b/b.h"\n')
        faults = self.faults()
        self.assertEqual(len(faults), 2, faults)
        self.assertIn('meristem/grow/b/b.h:1: the folders "b" and "c" of grow', faults[0])

    def test_angle_brackets_do_not_hide_an_include(self) -> None:
        self.write("meristem/base/a.h", "#include <meristem/output/a.h>\n")
        self.assert_only_fault("meristem/base/a.h:1:", "base stands before output")

    def test_the_library_may_not_include_its_doors(self) -> None:
        self.write("meristem/output/a.h", '#include "apps/cli/main.h"\n')
        self.assert_only_fault("does not include its doors")
        self.write("meristem/output/a.h", "#include <python/bindings/values.h>\n")
        self.assert_only_fault("does not include its doors")

    def test_a_door_includes_public_headers_of_all_rooms_and_its_own(self) -> None:
        everything = "".join(f'#include "meristem/{room}/a.h"\n' for room in include_rule.ROOMS)
        self.write("python/bindings/a.cpp", everything + '#include "values.h"\n#include <pybind11/pybind11.h>\n')
        self.write("apps/cli/a.cpp", everything + '#include "apps/cli/main.h"\n')
        self.assertEqual(self.faults(), [])

    def test_a_door_may_not_include_what_is_not_public(self) -> None:
        self.write("meristem/document/parse.h", "#pragma once\n")
        self.write("python/bindings/a.cpp", '#include "values.h"\n#include "meristem/document/parse.h"\n')
        self.assert_only_fault("python/bindings/a.cpp:2:", "public headers only")

    def test_a_door_may_not_include_another(self) -> None:
        self.write("python/bindings/a.cpp", '#include "apps/cli/frames.h"\n')
        self.assert_only_fault("python/bindings/a.cpp:1:", "not another door")

    def test_only_tests_include_test_support(self) -> None:
        self.write("meristem/plant/a.h", '#include "tests/support/check_mesh.h"\n')
        self.assert_only_fault("only tests include")

    def test_a_source_includes_its_own_header_first(self) -> None:
        self.write("meristem/plant/CMakeLists.txt", "meristem_room(plant HEADERS a.h SOURCES a.cpp)")
        self.write("meristem/plant/a.cpp", '#include <vector>\n#include "meristem/plant/a.h"\n')
        self.assert_only_fault("meristem/plant/a.cpp:1:", 'the first include is not "meristem/plant/a.h"')

    def test_includes_start_at_the_root(self) -> None:
        self.write("meristem/plant/a.h", '#include "skeleton.h"\n')
        self.assert_only_fault("from the root")

    def test_an_unknown_room_is_named(self) -> None:
        self.write("meristem/plant/a.h", '#include "meristem/util/a.h"\n')
        self.assert_only_fault("is in no room")

    def test_a_heavy_library_stays_out_of_public_headers(self) -> None:
        self.write("meristem/document/a.h", "#include <nlohmann/json.hpp>\n")
        self.assert_only_fault("meristem/document/a.h:1:", "heavy")

    def test_a_private_header_may_be_heavy(self) -> None:
        self.write("meristem/document/parse.h", "#include <nlohmann/json.hpp>\n")
        self.assertEqual(self.faults(), [])

    def test_a_public_header_includes_public_headers_only(self) -> None:
        self.write("meristem/document/parse.h", "#pragma once\n")
        self.write("meristem/document/a.h", '#include "meristem/document/parse.h"\n')
        self.assert_only_fault("meristem/document/a.h:1:", "not installed")

    def test_a_public_header_says_what_it_is_for(self) -> None:
        body = "#pragma once\n#include <vector>\n\nnamespace meristem {\n\nclass B;\n\n%sstruct A {};\n\n}  // namespace meristem\n"
        licence = "// SPDX-License-Identifier: Apache-2.0\n"
        for text in (licence + body % "/// A thing.\n", licence + "// Things.\n" + body % "", licence + "#pragma once\n"):
            self.write("meristem/plant/a.h", text)
            self.assertEqual(self.faults(), [])
        self.write("meristem/plant/a.h", licence + body % "")
        self.assert_only_fault("meristem/plant/a.h:9:", "what it is for")
        self.write("meristem/plant/b.h", licence + body % "")  # not public
        self.write("meristem/plant/a.h", licence + body % "/// A thing.\n")
        self.assertEqual(self.faults(), [])

    def test_a_public_type_says_what_it_belongs_to(self) -> None:
        form = "// Things.\n#pragma once\n\nnamespace meristem {\n\n%s\n\n}  // namespace meristem\n"
        for good in ("struct PlantCounts {\n  struct Way {};\n};", "class Plant {\n};", "class Way;", "using Vec3 = int;"):
            self.write("meristem/plant/a.h", form % good)
            self.assertEqual(self.faults(), [], good)
        for bad in ("struct Counts {", "class Work final {", "enum class Held {", "using Room = int;"):
            self.write("meristem/plant/a.h", form % bad)
            self.assert_only_fault("meristem/plant/a.h:6:", "one general word")
            self.write("meristem/plant/a.h", "// Things.\n#pragma once\n")
            self.write("meristem/plant/b.h", form % bad)  # not public
            self.assertEqual(self.faults(), [])

    def test_sources_of_a_batch_have_names_of_their_own(self) -> None:
        own = '#include "meristem/shape/%s.h"\n\nnamespace {\n\n%s\n\n}  // namespace\n'
        for first, second in (("constexpr double kStep = 1;", "constexpr int kStep = 2;"),
                              ("struct Walk {\n};", "class Walk {\n};"),
                              ("using Walk = int;", "using Walk = double;")):
            self.write("meristem/shape/CMakeLists.txt", "meristem_room(shape HEADERS a.h SOURCES b.cpp c.cpp)")
            for name, text in (("b", first), ("c", second)):
                self.write(f"meristem/shape/{name}.h", "#pragma once\n")
                self.write(f"meristem/shape/{name}.cpp", own % (name, text))
            self.assert_only_fault("meristem/shape/c.cpp:5:", "meristem/shape/b.cpp")
            self.write("meristem/shape/c.cpp", own % ("c", first.replace("kStep", "kOther").replace("Walk", "Way")))
            self.assertEqual(self.faults(), [])
        self.write("meristem/shape/b.cpp", own % ("b", "using Walk = int;"))
        self.write("meristem/shape/c.cpp", own % ("c", "using Walk = int;"))
        self.assertEqual(self.faults(), [])

    def test_a_test_has_a_namespace_of_its_name(self) -> None:
        self.write("meristem/shape/CMakeLists.txt", "meristem_room(shape HEADERS a.h TESTS b_test.cpp)")
        self.write("meristem/shape/b_test.cpp", "\nnamespace meristem {\nnamespace {\n")
        self.assert_only_fault("meristem/shape/b_test.cpp:2:", "meristem::b_test")
        self.write("meristem/shape/b_test.cpp", "namespace fs = std::filesystem;\nnamespace meristem::b_test {\n")
        self.assertEqual(self.faults(), [])

    def test_a_source_outside_all_lists_is_found(self) -> None:
        self.write("meristem/shape/forgotten_test.cpp", "")
        self.assert_only_fault("meristem/shape/forgotten_test.cpp:1:", "nothing compiles it")

    def test_a_test_is_listed_as_a_test(self) -> None:
        self.write("meristem/shape/CMakeLists.txt", "meristem_room(shape HEADERS a.h SOURCES a_test.cpp)")
        self.write("meristem/shape/a_test.cpp", "")
        self.assert_only_fault("belongs to TESTS")

    def test_a_room_may_not_link_a_later_one(self) -> None:
        self.write("meristem/scene/CMakeLists.txt", "meristem_room(scene HEADERS a.h PRIVATE meristem::shape)")
        self.assert_only_fault("meristem/scene/CMakeLists.txt:1:", "may not link")

    def test_the_build_adds_the_rooms_in_order(self) -> None:
        reversed_rooms = "".join(f"add_subdirectory({room})\n" for room in reversed(include_rule.ROOMS))
        self.write("meristem/CMakeLists.txt", reversed_rooms)
        self.assert_only_fault("the line is base, plant")

    def test_every_folder_is_a_room(self) -> None:
        (self.root / "meristem" / "helpers").mkdir()
        self.assert_only_fault("meristem/helpers", "is no room")


if __name__ == "__main__":
    unittest.main()

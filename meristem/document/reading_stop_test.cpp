// SPDX-License-Identifier: Apache-2.0
// Readers of files can be stopped at many places. The number of checks is counted, because times differ from machine to
// machine; reading_bench measures the longest time from a cancel to the stop.
#include "meristem/base/reading_stop.h"

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/read_columns.h"
#include "meristem/base/read_file.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/plant/file/node_table.h"
#include "meristem/plant/mtg/mtg.h"
#include "meristem/plant/mtg/mtg_skeleton.h"
#include "meristem/scene/file/read_mesh.h"
#include "meristem/scene/file/read_points.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "tests/support/temporary_folder.h"

namespace meristem::reading_stop_test {

constexpr int kRows = 20'000;

std::string lines(const std::string& head, const std::function<std::string(int)>& line) {
  std::string text = head;
  for (int k = 0; k < kRows; ++k) text += line(k) + "\n";
  return text;
}

std::string obj() {
  std::string text = lines("", [](int k) { return fmt::format("v {} {} 0", k, k % 7); });
  return text + lines("", [](int k) { return fmt::format("f 1 {} {}", k % 1000 + 2, k % 1000 + 3); });
}

std::string ply() {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {0}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {0}\nproperty list uchar int vertex_indices\nend_header\n",
      kRows);
  text += lines("", [](int k) { return fmt::format("{} {} 0", k, k % 7); });
  return text + lines("", [](int k) { return fmt::format("3 0 {} {}", k % 1000 + 1, k % 1000 + 2); });
}

std::string binary_ply() {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "end_header\n",
      kRows);
  return text + std::string(std::size_t{12} * kRows, '\0');
}

std::string points() {
  return lines("", [](int k) { return fmt::format("{} {} 0", k, k % 7); });
}

std::string table() {
  return lines("a,b,c\n", [](int k) { return fmt::format("{},{},t{}", k, 2 * k, k % 3); });
}

std::string nodes() {
  return lines("node,x,y,z,parent,radius\n", [](int k) { return fmt::format("{},{},0,1,{},0.1", k, k, k - 1); });
}

std::string mtg() {
  return lines(
      "CODE:\tFORM-A\nCLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n$\t0\tFREE\tFREE\tIMPLICIT\n"
      "S\t1\tFREE\tFREE\tEXPLICIT\nDESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\nFEATURES:\nNAME\tTYPE\nXX\tREAL\n"
      "YY\tREAL\nZZ\tREAL\nMTG:\nENTITY-CODE\tXX\tYY\tZZ\n",
      [](int k) { return k == 0 ? std::string("/S1\t0\t0\t0") : fmt::format("^<S{}\t0\t0\t{}", k + 1, k); });
}

struct Reader {
  const char* name;
  std::string text;
  std::function<void(const std::string& text)> read;
};

std::vector<Reader> readers() {
  const auto mesh = [](const std::string& text) { parse_mesh(text, "m", {}); };
  const auto cloud = [](const std::string& text) { parse_points(text, "p", {}); };
  return {
      {"obj", obj(), mesh},
      {"ply", ply(), mesh},
      {"binary ply", binary_ply(), cloud},
      {"points", points(), cloud},
      {"columns", table(),
       [](const std::string& text) {
         read_columns(text, {{"a"}, {"b"}}, {});
       }},
      {"table", table(), [](const std::string& text) { read_text_table(text, {}); }},
      {"nodes", nodes(), [](const std::string& text) { skeleton_of(read_node_table(text, "n.csv", {}), {}, "n.csv"); }},
      {"mtg", mtg(), [](const std::string& text) { skeleton_of(read_mtg(text, "m.mtg", {}), "m.mtg", {}, {}); }},
      {"closed mesh", obj(), [](const std::string& text) { closedness_errors(parse_mesh(text, "m", {})); }},
      {"body", obj(), [](const std::string& text) { body_error(parse_mesh(text, "m", {})); }}};
}

TEST(ReadingStop, ReadersCheckItOftenAndAreStoppedByIt) {
  for (const Reader& reader : readers()) {
    SCOPED_TRACE(reader.name);
    const std::uint64_t before = ReadingStop::check_count();
    reader.read(reader.text);
    EXPECT_GE(ReadingStop::check_count() - before, static_cast<std::uint64_t>(kRows) / 256);
    Progress progress;
    const ReadingStop stop(&progress);
    reader.read(reader.text);
    progress.cancel();
    EXPECT_THROW(reader.read(reader.text), Cancelled);
  }
  EXPECT_EQ(ReadingStop::progress(), nullptr) << "a stop ends with its object";
}

TEST(ReadingStop, NullLeavesTheStopOfTheCaller) {
  Progress progress;
  const ReadingStop outer(&progress);
  {
    const ReadingStop inner(nullptr);
    EXPECT_EQ(ReadingStop::progress(), &progress);
    Progress own;
    const ReadingStop innermost(&own);
    EXPECT_EQ(ReadingStop::progress(), &own);
  }
  EXPECT_EQ(ReadingStop::progress(), &progress);
}

/// A document's Progress stops the readers of the files that it names. The file of the crown's points is read last.
TEST(ReadingStop, TheProgressOfADocumentStopsTheReadersOfItsFiles) {
  const TemporaryFolder folder;
  std::ofstream(folder / "points.xyz") << points();
  const std::string text =
      R"({"meristem": 1, "components": {"tree": {"type": "colonize", "points": {"file": "points.xyz"}}}})";
  Progress progress;
  const std::uint64_t before = ReadingStop::check_count();
  try {
    read_document(text, folder / "d.json", builtin_components(), {.progress = &progress});
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what();
  }
  EXPECT_GE(ReadingStop::check_count() - before, static_cast<std::uint64_t>(kRows) / 256);
  EXPECT_EQ(ReadingStop::progress(), nullptr);
}

TEST(ReadingStop, LargeFilesAreReadInPieces) {
  const TemporaryFolder folder;
  std::ofstream(folder / "large") << std::string(13'000'000, 'x');
  const std::uint64_t before = ReadingStop::check_count();
  EXPECT_EQ(read_file(folder / "large", 20'000'000).size(), 13'000'000U);
  EXPECT_GE(ReadingStop::check_count() - before, 4U);
  Progress progress;
  progress.cancel();
  const ReadingStop stop(&progress);
  EXPECT_THROW(read_file(folder / "large", 20'000'000), Cancelled);
}

}  // namespace meristem::reading_stop_test

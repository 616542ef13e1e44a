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

/// One step of reading a file. Earlier steps are done when the step is made, so only this step is counted and stopped.
struct Reader {
  const char* name;
  std::function<void()> read;
};

/// Returns a mesh of that many triangles. Every triangle has its own corners.
TriangleMesh loose_triangles(int count) {
  TriangleMesh mesh;
  for (int k = 0; k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const DVec3 corner : {DVec3(k, 0, 0), DVec3(k, 1, 0), DVec3(k, 0, 1)}) mesh.positions.push_back(corner);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

std::vector<Reader> readers() {
  const auto mesh = [](std::string text) { return [text = std::move(text)] { parse_mesh(text, "m", {}); }; };
  const auto cloud = [](std::string text) { return [text = std::move(text)] { parse_points(text, "p", {}); }; };
  const auto columns = [](const std::string& text) { read_columns(text, {{"a"}, {"b"}}, {}); };
  const NodeTable node_table = read_node_table(nodes(), "n.csv", {});
  const MtgTree mtg_tree = read_mtg(mtg(), "m.mtg", {});
  const TriangleMesh body = parse_mesh(obj(), "m", {});
  const TriangleMesh triangles = loose_triangles(kRows);
  return {{"obj", mesh(obj())},
          {"ply", mesh(ply())},
          {"binary ply", cloud(binary_ply())},
          {"points", cloud(points())},
          {"columns", [columns, text = table()] { columns(text); }},
          {"table", [text = table()] { read_text_table(text, {}); }},
          {"nodes", [text = nodes()] { read_node_table(text, "n.csv", {}); }},
          {"skeleton of nodes", [node_table] { skeleton_of(node_table, {}, "n.csv"); }},
          {"mtg", [text = mtg()] { read_mtg(text, "m.mtg", {}); }},
          {"skeleton of an mtg", [mtg_tree] { skeleton_of(mtg_tree, "m.mtg", {}, {}); }},
          {"closed mesh", [body] { closedness_errors(body); }},
          {"body", [body] { body_error(body); }},
          {"tree of obstacles", [triangles] { Obstacles({Obstacle{.mesh = triangles}}); }}};
}

TEST(ReadingStop, ReadersCheckItOftenAndAreStoppedByIt) {
  for (const Reader& reader : readers()) {
    SCOPED_TRACE(reader.name);
    const std::uint64_t before = ReadingStop::check_count();
    reader.read();
    EXPECT_GE(ReadingStop::check_count() - before, static_cast<std::uint64_t>(kRows) / 256);
    Progress progress;
    const ReadingStop stop(&progress);
    reader.read();
    progress.cancel();
    EXPECT_THROW(reader.read(), Cancelled);
  }
  EXPECT_EQ(ReadingStop::progress(), nullptr) << "a stop ends with its object";
}

/// A few triangles are copied without a check, so the tree of their rays is what is stopped.
TEST(ReadingStop, TheTreeOfFewObstaclesIsStopped) {
  const std::vector<Obstacle> few{Obstacle{.mesh = loose_triangles(20)}};
  Progress progress;
  const ReadingStop stop(&progress);
  EXPECT_EQ(Obstacles(few).bodies().size(), 1U);
  progress.cancel();
  EXPECT_THROW(Obstacles{few}, Cancelled);
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

/// A stopped reading leaves nothing behind that the next one would miss.
TEST(ReadingStop, ADocumentWithObstaclesIsReadAgainAfterAStop) {
  const TemporaryFolder folder;
  std::ofstream(folder / "house.obj") << obj();
  const std::string text =
      R"({"meristem": 1, "scene": {"obstacles": [{"mesh": "house.obj", "broken": true}]},
          "components": {"t": {"type": "tree"}}})";
  const auto read = [&](const Progress& progress) {
    return read_document(text, folder / "d.json", builtin_components(), {.progress = &progress});
  };
  Progress stopped;
  stopped.cancel();
  EXPECT_THROW(read(stopped), Cancelled);
  const std::uint64_t before = ReadingStop::check_count();
  EXPECT_EQ(read(Progress()).scene.obstacles.bodies().size(), 1U);
  // Vertices and faces of the file, its edges, and the triangles of the tree.
  EXPECT_GE(ReadingStop::check_count() - before, static_cast<std::uint64_t>(4 * kRows) / 256);
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

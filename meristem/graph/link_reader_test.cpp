// SPDX-License-Identifier: Apache-2.0
// Links as documents write them; what is wrong with them is tested with whole documents.
#include "meristem/graph/link_reader.h"

#include <gtest/gtest.h>

#include "meristem/graph/add_camera.h"
#include "meristem/graph/table/table.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::link_reader_test {

Value pair(const char* from, const char* to) { return Value(Value::List{Value(from), Value(to)}); }

Value link(const char* kind, const Value::Object& keys = {}) {
  Value::Object written{{"from", "pole"}, {"to", "stick"}, {"kind", kind}};
  written.insert(written.end(), keys.begin(), keys.end());
  return Value(std::move(written));
}

// The graph of a pole and a stick with these links.
Graph read(const Value::List& links, std::vector<Diagnostic>& errors) {
  Graph graph = GraphBuilder(test_components()).component("pole", "pole").component("stick", "stick").graph();
  ParameterReader reader({}, graph.limits);
  const DocumentPath top;
  LinkReader(graph, reader).read(Value(links), DocumentPath(top, "links"));
  errors = reader.take_diagnostics();
  return graph;
}

Graph sound(const Value::List& links) {
  std::vector<Diagnostic> errors;
  Graph graph = read(links, errors);
  EXPECT_TRUE(errors.empty()) << errors[0].text();
  return graph;
}

TEST(LinkReader, ALinkIsOfItsKindAlone) {
  const Graph graph =
      sound({pair("pole", "stick"), link("child"), link("leaf"), link("branch", {{"count", 3}, {"angle", 90}})});
  ASSERT_EQ(graph.links.size(), 4U);
  EXPECT_TRUE(graph.links[0].is<ChildLink>());
  EXPECT_TRUE(graph.links[1].is<ChildLink>());
  EXPECT_TRUE(graph.links[2].is<LeafLink>());
  const auto* branch = graph.links[3].as<BranchLink>();
  ASSERT_NE(branch, nullptr);
  EXPECT_EQ(branch->placement.count, PartCount(3));
  EXPECT_DOUBLE_EQ(branch->placement.angle.plain, kPi / 2);
}

TEST(LinkReader, EndsAreFoundByTheirIds) {
  const Graph graph = sound({pair("stick", "pole")});
  EXPECT_EQ(graph.links[0].from, 1U);
  EXPECT_EQ(graph.links[0].to, 0U);
}

TEST(LinkReader, LeavesFaultyLinksOutAndReadsTheRest) {
  std::vector<Diagnostic> errors;
  const Graph graph = read({pair("pole", "stock"), pair("pole", "stick")}, errors);
  EXPECT_EQ(graph.links.size(), 1U);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "links[0][1]");
  EXPECT_EQ(errors[0].nearest, "stick");
}

TEST(LinkReader, KeysOfAPlacementBelongToBranchLinks) {
  std::vector<Diagnostic> errors;
  read({link("leaf", {{"count", 3}})}, errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].path, "links[0].count");
  EXPECT_EQ(errors[0].message, "'count' belongs to branch links");
}

TEST(AddCamera, LinksToWhatHangsOnNothing) {
  Graph graph = sound({pair("pole", "stick")});
  add_camera(graph, test_components().camera());
  ASSERT_EQ(graph.components.size(), 3U);
  EXPECT_EQ(graph.components[2].id, "camera");
  ASSERT_EQ(graph.links.size(), 2U);
  EXPECT_EQ(graph.links[1].from, 2U);
  EXPECT_EQ(graph.links[1].to, 0U);
  add_camera(graph, test_components().camera());
  EXPECT_EQ(graph.components.size(), 3U) << "one is enough";
}

}  // namespace meristem::link_reader_test

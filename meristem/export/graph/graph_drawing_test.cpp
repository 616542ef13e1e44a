// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/graph/graph_drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "meristem/document/document.h"

namespace meristem::graph_drawing_test {

/// Returns figure 6.1 of the source, with a ball at each end.
Document first_example() {
  return read_document(R"json({"meristem": 1, "components": {
      "A": {"type": "camera"}, "B": {"type": "simple"}, "C": {"type": "hydra", "number": 3},
      "D": {"type": "tree", "recursion": 3}, "E": {"type": "simple"}, "F": {"type": "leaf"}},
      "links": [["A", "B"], ["B", "C"], ["C", "D"], {"from": "D", "to": "F", "kind": "branch", "count": 2},
                ["D", "D"], {"from": "D", "to": "E", "kind": "leaf"}]})json",
                       "first.json", builtin_components());
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

TEST(GraphDrawing, DrawsARecursionsFirstComponentTwiceAndItsLinesDoubled) {
  const std::string svg = draw_graph(first_example().graph);
  EXPECT_EQ(count(svg, ">D<"), 2U);
  for (const char* id : {"A", "B", "C", "E", "F"}) EXPECT_EQ(count(svg, std::string(">") + id + "<"), 1U) << id;
  EXPECT_EQ(count(svg, "stroke-width=\"4.8\""), 1U);          // one doubled line
  EXPECT_EQ(count(svg, "stroke=\"#fff\" stroke-width"), 1U);  // with its white middle
  EXPECT_EQ(count(svg, "stroke-width=\"3.6\""), 1U);          // branch
  EXPECT_EQ(count(svg, "stroke-dasharray=\"6 4\""), 1U);      // leaf
  EXPECT_EQ(count(svg, "<rect"), 8U);                         // the paper and seven boxes
}

TEST(GraphDrawing, WritesTypesWhereAskedFor) {
  const Document document = first_example();
  EXPECT_EQ(draw_graph(document.graph).find(">hydra<"), std::string::npos);
  EXPECT_EQ(count(draw_graph(document.graph, {.shows_types = true}), ">hydra<"), 1U);
}

TEST(GraphDrawing, NumbersInstancesByMultiplierAndDepth) {
  const Document document = first_example();
  Progress progress;
  const InstanceTree tree = instance_tree(document.graph, document.scene, 0, 100, progress);
  // A, B, C, three chains of three D, a ball at the end of each, two leaves on each D.
  EXPECT_EQ(tree.instances.size(), 3U + 9 + 3 + 18);
  const std::string svg = draw_instance_tree(document.graph, tree);
  for (const char* name : {"11", "12", "13", "21", "33"}) {
    EXPECT_EQ(count(svg, fmt::format(">D<tspan dy=\"3.5\" font-size=\"8.5\">{}<", name)), 1U) << name;
  }
}

TEST(GraphDrawing, TooManyInstancesAreRefused) {
  const Document document = first_example();
  Progress progress;
  EXPECT_THROW(instance_tree(document.graph, document.scene, 0, 10, progress), InputError);
}

}  // namespace meristem::graph_drawing_test

// SPDX-License-Identifier: Apache-2.0
// What links mean together: root, recursions, and what is refused.
#include <initializer_list>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/graph/graph.h"
#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::structure_test {

using Links = std::initializer_list<std::pair<const char*, const char*>>;

// Returns a graph of a camera "v" and `sticks` sticks "A", "B", ..., each with the given recursion.
GraphBuilder graph(int sticks, Links links, int recursion = 2) {
  GraphBuilder builder(test_components());
  builder.component("v", "camera");
  for (char id = 'A'; id < 'A' + sticks; ++id) {
    builder.component(std::string(1, id), "stick", {{"recursion", recursion}});
  }
  for (const auto& [from, to] : links) builder.link(from, to);
  return builder;
}

// The only fault.
std::string error(const GraphBuilder& builder) {
  const std::vector<std::string> errors = builder.structure_errors();
  EXPECT_EQ(errors.size(), 1U);
  return errors.empty() ? "" : errors[0];
}

LinkStructure structure_of(const GraphBuilder& builder) { return builder.sound_graph().structure; }

// The level of the recursion with this head.
std::size_t level_of(const GraphBuilder& builder, char head) {
  for (const LinkStructure::Recursion& recursion : structure_of(builder).recursions) {
    if (builder.graph().components[recursion.head].id[0] == head) return recursion.level;
  }
  ADD_FAILURE() << "no recursion at " << head;
  return 0;
}

TEST(Structure, ChainsAndDiamondsHaveNoRecursion) {
  EXPECT_TRUE(structure_of(graph(4, {{"v", "A"}, {"A", "B"}, {"A", "C"}, {"B", "D"}, {"C", "D"}})).recursions.empty());
}

TEST(Structure, ALinkToAnAncestorIsARecursionFromThere) {
  const auto builder = graph(3, {{"v", "A"}, {"A", "B"}, {"B", "C"}, {"C", "B"}});
  const LinkStructure structure = structure_of(builder);
  ASSERT_EQ(structure.recursions.size(), 1U);
  EXPECT_EQ(structure.recursions[0].head, 2U);
  EXPECT_EQ(structure.recursion_of_link, (std::vector<std::uint32_t>{kNoIndex, kNoIndex, kNoIndex, 0}));
  EXPECT_EQ(structure.recursion_of, (std::vector<std::uint32_t>{kNoIndex, kNoIndex, 0, 0}));
}

TEST(Structure, ADetourBelongsToTheRecursionItLeadsInto) {
  // D leads into C, from where the way goes back to A.
  const auto builder = graph(4, {{"v", "A"}, {"A", "B"}, {"B", "C"}, {"C", "A"}, {"A", "D"}, {"D", "C"}});
  EXPECT_EQ(structure_of(builder).recursion_of, (std::vector<std::uint32_t>{kNoIndex, 0, 0, 0, 0}));
}

TEST(Structure, NestedRecursionsCountTheirLevelsFromOutside) {
  const auto builder = graph(3, {{"v", "A"}, {"A", "B"}, {"B", "C"}, {"C", "B"}, {"C", "A"}});
  EXPECT_EQ(level_of(builder, 'A'), 0U);
  EXPECT_EQ(level_of(builder, 'B'), 1U);
}

TEST(Structure, ARecursionThatBeginsInsideAndGoesItsOwnWayLiesWithin) {
  for (const Links& links : {Links{{"v", "A"}, {"A", "B"}, {"B", "C"}, {"C", "A"}, {"B", "D"}, {"D", "B"}},
                             Links{{"v", "A"}, {"A", "B"}, {"B", "A"}, {"B", "D"}, {"D", "B"}, {"v", "C"}}}) {
    const auto builder = graph(4, links);
    EXPECT_EQ(level_of(builder, 'A'), 0U);
    EXPECT_EQ(level_of(builder, 'B'), 1U);
  }
}

TEST(Structure, ManyLinksBackToOneAncestorAreOneLevel) {
  const auto builder = graph(6, {{"v", "A"},
                                 {"A", "B"},
                                 {"B", "C"},
                                 {"C", "D"},
                                 {"D", "E"},
                                 {"E", "F"},
                                 {"F", "F"},
                                 {"F", "A"},
                                 {"F", "A"},
                                 {"F", "A"},
                                 {"F", "A"},
                                 {"F", "A"}});
  EXPECT_EQ(level_of(builder, 'A'), 0U);
  EXPECT_EQ(level_of(builder, 'F'), 1U);
}

TEST(Structure, CrossingRecursionsAreRefusedWithBothNamed) {
  const std::string text = error(graph(4, {{"v", "A"}, {"A", "B"}, {"B", "C"}, {"C", "A"}, {"C", "D"}, {"D", "B"}}));
  EXPECT_EQ(text,
            "links: the recursions A > B > C > A and B > C > D > B cross; "
            "expected recursions that lie apart or one within the other");
}

TEST(Structure, ACycleWithoutARecursionIsRefusedAtItsLink) {
  EXPECT_EQ(error(graph(2, {{"v", "A"}, {"A", "B"}, {"B", "A"}}, 1)),
            "links[2]: the links A > B > A form an endless circle; "
            "expected a \"recursion\" of at least 2 in 'A', or no link back");
  EXPECT_NE(error(graph(1, {{"v", "A"}, {"A", "A"}}, 1)).find("A > A form an endless circle"), std::string::npos);
}

TEST(Structure, TooManyLevelsAreRefused) {
  const std::string text = error(graph(5, {{"v", "A"},
                                           {"A", "B"},
                                           {"B", "C"},
                                           {"C", "D"},
                                           {"D", "E"},
                                           {"E", "E"},
                                           {"E", "D"},
                                           {"E", "C"},
                                           {"E", "B"},
                                           {"E", "A"}}));
  EXPECT_NE(text.find("components.E: 'E' recurses within 4 other recursions"), std::string::npos) << text;
}

TEST(Structure, ComponentsThatHangOnNothingAreNamed) {
  const auto errors = graph(3, {{"v", "A"}, {"B", "C"}, {"C", "B"}}).structure_errors();
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0],
            "components.B: 'B' cannot be reached from the camera by links; "
            "expected a link such as [\"v\", \"B\"]");
}

TEST(Structure, OneCameraIsTheRoot) {
  auto two = graph(1, {{"v", "A"}});
  two.component("w", "camera");
  EXPECT_EQ(error(two), "components.w: 'w' is a second camera beside 'v'; expected one camera per document");
  EXPECT_NE(error(graph(1, {{"v", "A"}, {"A", "v"}})).find("links[1]: the link leads to the camera 'v'"),
            std::string::npos);
  GraphBuilder none(test_components());
  none.component("A", "stick");
  EXPECT_EQ(error(none), "components: the graph has no camera; expected one camera, the root of all links");
}

TEST(Structure, ThousandsOfLinksBackAreCountedInOneFault) {
  GraphBuilder builder(test_components());
  builder.component("v", "camera").component("A", "stick", {{"recursion", 2}}).link("v", "A");
  for (int k = 0; k < 5000; ++k) builder.link("A", "A");
  EXPECT_EQ(error(builder), "links: 5000 links lead back to an ancestor; expected at most 64 recursions");
}

}  // namespace meristem::structure_test

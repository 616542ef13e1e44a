// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/strahler.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace meristem::strahler_test {

/// Returns a tree in which every inner node forks into `arity` children, `levels` times in a row, with `run` segments
/// between forks.
Skeleton even_tree(int arity, int levels, int run) {
  Skeleton skeleton;
  std::vector<NodeIndex> ends{skeleton.add_node(kNoNode, {0, 0, 0}, 0)};
  for (int level = 0; level <= levels; ++level) {
    std::vector<NodeIndex> next;
    for (const NodeIndex end : ends) {
      for (int child = 0; child < (level == 0 ? 1 : arity); ++child) {
        NodeIndex last = end;
        for (int k = 0; k < run; ++k) last = skeleton.add_node(last, {child, level, k}, 0);
        next.push_back(last);
      }
    }
    ends = next;
  }
  return skeleton;
}

std::vector<std::uint64_t> streams_of(const Skeleton& skeleton) {
  return strahler_streams(skeleton, strahler_numbers(skeleton, NodeChildren(skeleton)));
}

TEST(Strahler, EvenTreesHaveTheirArityAsRatio) {
  for (const int arity : {2, 3, 5}) {
    const std::vector<std::uint64_t> streams = streams_of(even_tree(arity, 4, 3));
    ASSERT_EQ(streams.size(), 5U);
    for (const double ratio : bifurcation_ratios(streams)) EXPECT_DOUBLE_EQ(ratio, arity);
    EXPECT_NEAR(mean_bifurcation_ratio(streams), arity, 1e-12);
    EXPECT_EQ(streams.back(), 1U);
  }
}

TEST(Strahler, SideTwigsDoNotRaiseAStem) {
  // A stem of six segments with a twig at each node has number 2 below the last twig and 1 above.
  Skeleton skeleton;
  NodeIndex last = skeleton.add_node(kNoNode, {0, 0, 0}, 0);
  for (int k = 1; k <= 6; ++k) {
    last = skeleton.add_node(last, {0, k, 0}, 0);
    if (k < 6) skeleton.add_node(last, {1, k, 0}, 0);
  }
  EXPECT_EQ(streams_of(skeleton), (std::vector<std::uint64_t>{6, 1}));
  EXPECT_EQ(strahler_numbers(skeleton, NodeChildren(skeleton))[0], 2);
}

TEST(Strahler, AChainIsOneStream) {
  const Skeleton chain = even_tree(1, 5, 2);
  EXPECT_EQ(streams_of(chain), (std::vector<std::uint64_t>{1}));
  EXPECT_TRUE(bifurcation_ratios(streams_of(chain)).empty());
  EXPECT_THROW(mean_bifurcation_ratio(streams_of(chain)), std::invalid_argument);
  EXPECT_TRUE(streams_of({}).empty());
}

}  // namespace meristem::strahler_test

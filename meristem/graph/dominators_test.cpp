// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/dominators.h"

#include <gtest/gtest.h>

#include "meristem/base/random.h"

namespace meristem::dominators_test {

using Edges = std::vector<std::vector<Dominators::Node>>;

/// Which nodes can be reached from the root without passing `closed`.
std::vector<bool> reached(const Edges& edges, Dominators::Node root, Dominators::Node closed) {
  std::vector<bool> seen(edges.size());
  std::vector<Dominators::Node> ahead;
  const auto meet = [&](Dominators::Node node) {
    if (seen[node]) return;
    seen[node] = true;
    if (node != closed) ahead.push_back(node);
  };
  meet(root);
  while (!ahead.empty()) {
    const Dominators::Node node = ahead.back();
    ahead.pop_back();
    for (const Dominators::Node to : edges[node]) meet(to);
  }
  return seen;
}

TEST(Dominators, AreTheNodesThatEveryWayPasses) {
  for (std::uint64_t round = 0; round < 200; ++round) {
    const RandomKey key = RandomKey().child(round);
    const auto count = static_cast<std::size_t>(2 + 30 * key.uniform(0));
    Edges edges(count);
    const auto links = static_cast<std::uint64_t>(3 * static_cast<double>(count) * key.uniform(1));
    const auto node = [&](std::uint64_t k) {
      return static_cast<Dominators::Node>(static_cast<double>(count) * key.child("ends").uniform(k));
    };
    for (std::uint64_t k = 0; k < links; ++k) edges[node(2 * k)].push_back(node(2 * k + 1));
    const Dominators dominators(edges, 0);
    const std::vector<bool> can_be_reached = reached(edges, 0, static_cast<Dominators::Node>(count));
    for (Dominators::Node above = 0; above < count; ++above) {
      const std::vector<bool> without = reached(edges, 0, above);
      for (Dominators::Node below = 0; below < count; ++below) {
        const bool is_expected = below != above && can_be_reached[below] && !without[below];
        EXPECT_EQ(dominators.is_strictly_dominated(below, above), is_expected)
            << "round " << round << ", " << below << " below " << above;
      }
    }
  }
}

TEST(Dominators, OfALongChainAreFoundWithoutRecursion) {
  Edges edges(200'000);
  for (Dominators::Node k = 0; k + 1 < edges.size(); ++k) edges[k].push_back(k + 1);
  edges.back().push_back(0);
  const Dominators dominators(edges, 0);
  EXPECT_TRUE(dominators.is_strictly_dominated(199'999, 1));
  EXPECT_FALSE(dominators.is_strictly_dominated(1, 199'999));
}

TEST(Dominators, AreNoLongerSoughtAfterCancelling) {
  Edges edges(10'000);
  for (Dominators::Node k = 0; k + 1 < edges.size(); ++k) edges[k].push_back(k + 1);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(Dominators(edges, 0, &progress), Cancelled);
}

}  // namespace meristem::dominators_test

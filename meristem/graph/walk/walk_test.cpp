// SPDX-License-Identifier: Apache-2.0
// The order, the blocks and the numbers that a walk shows to its visitor.
#include "meristem/graph/walk/walk.h"

#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/build_graph.h"
#include "tests/support/test_components.h"

namespace meristem::walk_test {

Scene known_scene() {
  Scene scene;
  scene.fingerprint = 1;
  return scene;
}

/// 600 poles on a star, with sticks along them.
Graph poles_with_sticks() {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 600}});
  builder.component("pole", "pole", {{"nodes", 5}}).component("leaf", "stick", {{"omit", Value::List{"i % 3 == 0"}}});
  builder.link("view", "star").link("star", "pole").link("pole", "leaf", LinkKind::branch, {{"count", 8}});
  return builder.sound_graph();
}

/// Records the batches of a walk.
class Recorder : public WalkVisitor {
 public:
  /// If `expands_again` is true, each instance is expanded once more alone.
  explicit Recorder(const Graph& graph, bool expands_again = false) : graph_(graph), expands_again_(expands_again) {}

  std::vector<std::string> roots;
  std::vector<std::string> components;       // of the expanded batches, in their order
  std::vector<std::uint64_t> keys;           // of the expanded instances, in their order
  std::vector<std::size_t> blocks;           // number of blocks of each result
  std::vector<std::size_t> grown;            // number of grown plants of each batch
  std::vector<std::size_t> parts;            // number of organs of each batch
  std::vector<std::size_t> parts_alone;      // number of organs of its instances, each expanded alone
  std::vector<const BatchResult*> results;   // of the batches
  std::vector<std::size_t> children;         // number of children, for each link that is followed
  std::vector<std::size_t> children_blocks;  // sum of the children of the parents' blocks, for each link
  std::vector<std::string> errors;           // broken promises of the walk

  void on_root(const Batch& root) override {
    roots.push_back(id(root));
    if (!components.empty()) errors.emplace_back("a batch comes before the root");
    placed_.insert(root.site(0).key.bits());
  }

  void on_expanded(const ExpandedBatch& expanded) override {
    components.push_back(id(expanded.batch));
    blocks.push_back(expanded.result.blocks.size());
    grown.push_back(expanded.grown == nullptr ? 0 : expanded.grown->skeletons.size());
    results.push_back(&expanded.result);
    parts.push_back(0);
    for (const Emitted& block : expanded.result.blocks) parts.back() += block.organs.size();
    parts_alone.push_back(0);
    for (std::size_t k = 0; expands_again_ && k < expanded.batch.count(); ++k) {
      parts_alone.back() += expanded.expand_alone(k).organs.size();
    }
    expanded.batch.read([&](const Site& site) {
      keys.push_back(site.key.bits());
      if (!placed_.contains(site.key.bits())) errors.push_back("not placed before: " + id(expanded.batch));
    });
  }

  void on_children(const PlacedChildren& placed) override {
    if (id(placed.parent) != components.back()) errors.emplace_back("children of an earlier batch");
    if (graph_.links[placed.link].to != placed.batch.component) errors.emplace_back("children of another link");
    if (placed.batch.first != placed_.size()) errors.emplace_back("a wrong number of the first instance");
    children.push_back(placed.batch.count());
    children_blocks.push_back(std::accumulate(placed.per_block.begin(), placed.per_block.end(), std::size_t{0}));
    placed.batch.read([&](const Site& site) { placed_.insert(site.key.bits()); });
  }

 private:
  const std::string& id(const Batch& batch) const { return graph_.components[batch.component].id; }

  const Graph& graph_;
  bool expands_again_;
  std::set<std::uint64_t> placed_;  // keys of all instances so far
};

void walk_over(const Graph& graph, WalkVisitor& visitor, WalkOptions options = {}) {
  const Scene scene = known_scene();
  Progress progress;
  Walk(graph, scene, 0, progress, std::move(options)).run(visitor);
}

Recorder recorded(const Graph& graph, WalkOptions options = {}) {
  Recorder recorder(graph);
  walk_over(graph, recorder, std::move(options));
  return recorder;
}

TEST(Walk, ShowsEachInstanceOnceAfterItsParent) {
  const Graph graph = poles_with_sticks();
  const Recorder shown = recorded(graph);
  EXPECT_EQ(shown.roots, std::vector<std::string>{"view"});
  EXPECT_EQ(shown.components, (std::vector<std::string>{"view", "star", "pole", "leaf"}));
  EXPECT_EQ(shown.errors, std::vector<std::string>());
  EXPECT_EQ(shown.children, (std::vector<std::size_t>{1, 600, 600 * 8}));
  EXPECT_EQ(std::set(shown.keys.begin(), shown.keys.end()).size(), 1 + 1 + 600 + 600 * 8U);
  EXPECT_EQ(shown.keys.size(), 1 + 1 + 600 + 600 * 8U);
}

TEST(Walk, BlocksHaveTheRequestedNumberOfInstances) {
  const Graph graph = poles_with_sticks();
  const Recorder many = recorded(graph);
  EXPECT_EQ(many.blocks, (std::vector<std::size_t>{1, 1, 3, (600 * 8 + kBlock - 1) / kBlock}));
  EXPECT_EQ(many.children_blocks, many.children);
  const Recorder one = recorded(graph, {.per_block = 1});
  EXPECT_EQ(one.blocks, (std::vector<std::size_t>{1, 1, 600, 600 * 8}));
  EXPECT_EQ(one.children_blocks, one.children);
  EXPECT_EQ(one.keys, many.keys);
}

TEST(Walk, InSlicesShowsTheSameInstances) {
  const Graph graph = poles_with_sticks();
  const Recorder whole = recorded(graph);
  const Recorder sliced = recorded(graph, {.in_slices = true});
  EXPECT_GT(sliced.components.size(), whole.components.size());
  EXPECT_EQ(sliced.keys.size(), whole.keys.size());
  EXPECT_EQ(std::set(sliced.keys.begin(), sliced.keys.end()), std::set(whole.keys.begin(), whole.keys.end()));
}

TEST(Walk, AnInstanceExpandedAloneMakesItsPartsAgain) {
  const Graph graph = poles_with_sticks();
  Recorder shown(graph, true);
  walk_over(graph, shown);
  EXPECT_EQ(shown.parts.back(), 600U * 5);  // 3 of 8 are omitted
  EXPECT_EQ(shown.parts_alone, shown.parts);
}

TEST(Walk, ACacheShowsTheSameBatchesAndResults) {
  const Graph graph = poles_with_sticks();
  Cache cache;
  const Recorder first = recorded(graph, {.cache = &cache});
  const Recorder second = recorded(graph, {.cache = &cache});
  EXPECT_EQ(second.results, first.results);
  EXPECT_EQ(second.keys, first.keys);
  EXPECT_EQ(second.children, first.children);
  EXPECT_EQ(second.children_blocks, (std::vector<std::size_t>{0, 0, 0}));
  EXPECT_EQ(second.errors, std::vector<std::string>());
}

TEST(Walk, PlantsGrowAfterAllOtherBatches) {
  GraphBuilder builder(test_components());
  builder.component("view", "camera").component("star", "star", {{"number", 3}}).component("sprout", "sprout");
  builder.component("tip", "stick").component("stick", "stick", {{"recursion", 4}});
  builder.link("view", "star").link("star", "sprout").link("star", "stick").link("stick", "stick");
  builder.link("sprout", "tip", LinkKind::leaf);
  const Graph graph = builder.sound_graph();
  const Recorder shown = recorded(graph, {.per_block = 2});
  EXPECT_EQ(shown.components,
            (std::vector<std::string>{"view", "star", "stick", "stick", "stick", "stick", "sprout", "tip"}));
  EXPECT_EQ(shown.grown, (std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 3, 0}));
  EXPECT_EQ(shown.blocks, (std::vector<std::size_t>{1, 1, 2, 2, 2, 2, 3, 2}));
  EXPECT_EQ(shown.errors, std::vector<std::string>());
}

/// Needs a number of batches.
class Impatient final : public Recorder {
 public:
  Impatient(const Graph& graph, std::size_t batches) : Recorder(graph), batches_(batches) {}
  bool is_done() const override { return components.size() >= batches_; }

 private:
  std::size_t batches_;
};

TEST(Walk, StopsWhenTheVisitorIsDone) {
  const Graph graph = poles_with_sticks();
  for (const std::size_t batches : {0U, 1U, 3U}) {
    Impatient visitor(graph, batches);
    walk_over(graph, visitor);
    EXPECT_EQ(visitor.components.size(), batches);
  }
}

}  // namespace meristem::walk_test

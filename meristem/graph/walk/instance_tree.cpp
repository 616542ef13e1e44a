// SPDX-License-Identifier: Apache-2.0
// Builds the tree of instances. The walk numbers the instances of whole batches in the order in which it places them,
// so a batch's number is the index of its first instance in the tree. Blocks of one instance tell how many children
// each instance has.
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/instances.h"
#include "meristem/graph/walk/walk.h"

namespace meristem {

namespace {

class TreeVisitor final : public WalkVisitor {
 public:
  TreeVisitor(const Graph& graph, std::uint64_t max) : graph_(graph), max_(max) {}

  void on_root(const Batch& root) override {
    require_room(root);
    tree_.instances.push_back({.component = root.component});
  }

  void on_children(const PlacedChildren& children) override {
    require_room(children.batch);
    std::size_t parent = 0;     // index in the batch of the parents
    std::size_t of_parent = 0;  // number of its children so far
    children.batch.read([&](const Site& site) {
      while (of_parent == children.per_block[parent]) {
        ++parent;
        of_parent = 0;
      }
      ++of_parent;
      tree_.instances.push_back({.component = children.batch.component,
                                 .parent = static_cast<std::uint32_t>(children.parent.first + parent),
                                 .link = children.link,
                                 .i = site.i,
                                 .n = site.n});
    });
  }

  InstanceTree take_tree() { return std::move(tree_); }

 private:
  /// Throws an InputError if the instances of a batch are too many.
  void require_room(const Batch& batch) const {
    if (tree_.instances.size() + batch.count() <= max_) return;
    throw InputError(Diagnostic{.message = fmt::format("there are more than {} instances", max_),
                                .expected = "a smaller plant, or a greater number of instances that are drawn",
                                .path = "components." + graph_.components[batch.component].id});
  }

  const Graph& graph_;
  std::uint64_t max_;
  InstanceTree tree_;
};

}  // namespace

InstanceTree instance_tree(const Graph& graph, const Scene& scene, double time, std::uint64_t max, Progress& progress) {
  TreeVisitor visitor(graph, max);
  Walk(graph, scene, time, progress, {.per_block = 1}).run(visitor);
  return visitor.take_tree();
}

}  // namespace meristem

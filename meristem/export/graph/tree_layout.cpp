// SPDX-License-Identifier: Apache-2.0
// Places the nodes of a forest. Subtrees are laid out from the leaves up, and each one is moved right until its outline
// clears the outlines of its left siblings. A second pass adds up the relative positions from the roots down.
#include "meristem/export/graph/tree_layout.h"

#include <algorithm>
#include <utility>

namespace meristem {

namespace {

constexpr double kBetweenCousins = 0.25;  // additional distance between subtrees, compared with leaves

/// The outline of a subtree. The lowest level comes first, so that a level above is added at the end. Positions are
/// relative to the subtree's root plus `shift`.
struct Outline {
  std::vector<double> left;
  std::vector<double> right;
  double shift = 0;

  std::size_t depth() const { return left.size(); }
  double left_at(std::size_t level) const { return left[left.size() - 1 - level] + shift; }
  double right_at(std::size_t level) const { return right[right.size() - 1 - level] + shift; }
};

/// Returns the minimum distance of the root of `next` from the origin of `so_far`.
double distance(const Outline& so_far, const Outline& next, bool are_leaves) {
  const std::size_t shared = std::min(so_far.depth(), next.depth());
  double min = 0;
  for (std::size_t level = 0; level < shared; ++level) {
    min = std::max(min, so_far.right_at(level) - next.left_at(level) + 1);
  }
  return min + (are_leaves ? 0 : kBetweenCousins);
}

/// Returns the outline of both. The deeper outline is kept, and the other one is written over it.
Outline joined(Outline so_far, Outline next) {
  const bool keeps_next = next.depth() > so_far.depth();
  Outline& kept = keeps_next ? next : so_far;
  const Outline& other = keeps_next ? so_far : next;
  for (std::size_t level = 0; level < other.depth(); ++level) {
    const std::size_t at = kept.depth() - 1 - level;
    if (keeps_next) {
      kept.left[at] = other.left_at(level) - kept.shift;
    } else {
      kept.right[at] = other.right_at(level) - kept.shift;
    }
  }
  return std::move(kept);
}

}  // namespace

TreePlaces place_tree(std::span<const std::uint32_t> parents) {
  const std::size_t count = parents.size();
  TreePlaces places;
  places.level.resize(count);
  std::vector<std::vector<std::uint32_t>> children(count + 1);  // the last entry lists the roots
  for (std::uint32_t node = 0; node < count; ++node) {
    const bool is_root = parents[node] == kNoParent;
    children[is_root ? count : parents[node]].push_back(node);
    places.level[node] = is_root ? 0 : places.level[parents[node]] + 1;
    places.levels = std::max(places.levels, places.level[node] + 1);
  }
  // From the leaves up: compute each child's position relative to its parent.
  std::vector<double> relative(count, 0);
  std::vector<Outline> outlines(count);
  const auto place_children = [&](const std::vector<std::uint32_t>& of) {
    Outline all;
    std::vector<double> starts;
    bool was_leaf = true;
    for (const std::uint32_t child : of) {
      Outline& own = outlines[child];
      const bool is_leaf = own.depth() == 1;
      const double start = starts.empty() ? 0 : distance(all, own, is_leaf && was_leaf);
      starts.push_back(start);
      own.shift += start;
      all = starts.size() == 1 ? std::move(own) : joined(std::move(all), std::move(own));
      was_leaf = is_leaf;
    }
    const double middle = starts.empty() ? 0 : (starts.front() + starts.back()) / 2;
    for (std::size_t k = 0; k < of.size(); ++k) relative[of[k]] = starts[k] - middle;
    all.shift -= middle;
    return all;
  };
  for (std::size_t node = count; node-- > 0;) {
    Outline outline = place_children(children[node]);
    outline.left.push_back(-outline.shift);
    outline.right.push_back(-outline.shift);
    outlines[node] = std::move(outline);
  }
  place_children(children[count]);
  // From the roots down: compute absolute positions, the leftmost at 0.
  places.across.resize(count);
  double min = 0;
  for (std::size_t node = 0; node < count; ++node) {
    const double above = parents[node] == kNoParent ? 0 : places.across[parents[node]];
    places.across[node] = above + relative[node];
    min = node == 0 ? places.across[node] : std::min(min, places.across[node]);
  }
  for (double& across : places.across) places.breadth = std::max(places.breadth, across -= min);
  return places;
}

}  // namespace meristem

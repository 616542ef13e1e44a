// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/nearest_nodes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr int kPartLevel = 5;              // 32 parts at most
constexpr std::size_t kNodesToShare = 64;  // fewer new nodes are not worth a second thread
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Infinity bounds nothing, but everything is below it.
float just_above(float square) { return std::nextafter(square, kInfinity); }

}  // namespace

NearestNodes::NearestNodes(std::vector<Vec3> points, Progress& progress)
    : living_(points.size()), tree_(points, progress), part_level_(std::min(kPartLevel, tree_.leaf_level())) {
  x_.resize(points.size());
  y_.resize(points.size());
  z_.resize(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    x_[k] = points[k].x;
    y_[k] = points[k].y;
    z_[k] = points[k].z;
  }
  std::vector<Vec3>().swap(points);
  distance2_.assign(living_, kInfinity);
  node_.assign(living_, kNoNode);
  farthest2_.assign(tree_.node_count(), living_ > 0 ? kInfinity : 0);
  is_influenced_.assign(tree_.leaf_count(), 0);
  for (Leaf leaf = 0; leaf < tree_.leaf_count(); ++leaf) {
    begin_.push_back(tree_.first_point(tree_.leaf_level(), leaf));
    end_.push_back(tree_.first_point(tree_.leaf_level(), leaf + 1));
  }
  influenced_.resize(std::size_t{1} << part_level_);
}

void NearestNodes::add_nodes(NodeIndex first, std::span<const NewNode> nodes, Progress& progress) {
  if (living_ == 0) return;
  std::vector<Candidate> candidates;
  candidates.reserve(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const float influence2 = nodes[k].influence * nodes[k].influence;
    candidates.push_back({nodes[k].position, just_above(influence2), first + static_cast<NodeIndex>(k)});
  }
  // Parts are disjoint, so each may be written by a thread of its own.
  const std::size_t parts = influenced_.size();
  parallel_for(parts, nodes.size() < kNodesToShare ? parts : 1, [&](std::size_t begin, std::size_t end) {
    Descent descent;
    for (std::size_t part = begin; part < end; ++part) {
      progress.check();
      descent.stack.assign(candidates.begin(), candidates.end());
      descent.influenced = &influenced_[part];
      const auto index = static_cast<std::uint32_t>(part);
      const std::size_t near = push_candidates(PointTree::place(part_level_, index), 0, candidates.size(), descent);
      if (near > candidates.size()) descend(part_level_, index, candidates.size(), descent);
    }
  });
}

/// Pushes those from `first` to `last` on the stack that may take over a point in a node of the tree, and returns the
/// stack's new size.
std::size_t NearestNodes::push_candidates(std::uint32_t place, std::size_t first, std::size_t last,
                                          Descent& descent) const {
  const Box& box = tree_.boxes()[place];
  const float farthest2 = farthest2_[place];
  descent.stack.resize(2 * last - first);
  const Candidate* const candidates = descent.stack.data();
  Candidate* out = descent.stack.data() + last;
  for (std::size_t k = first; k < last; ++k) {
    *out = candidates[k];
    const float within2 = std::min(farthest2, out->within2);
    out += distance2(box, out->position) < within2 ? 1 : 0;
  }
  const auto size = static_cast<std::size_t>(out - candidates);
  descent.stack.resize(size);
  return size;
}

/// Lets the candidates from `first` to the end of the stack take over points in a node of the tree. Recurses no deeper
/// than the tree, whose height is the logarithm of the points.
void NearestNodes::descend(int level, std::uint32_t index, std::size_t first, Descent& descent) {
  const std::size_t last = descent.stack.size();
  if (level == tree_.leaf_level()) {
    bool any = false;
    for (std::size_t k = first; k < last; ++k) any = compare(index, descent.stack[k]) || any;
    if (any && is_influenced_[index] == 0) {
      is_influenced_[index] = 1;
      descent.influenced->push_back(index);
    }
    return;
  }
  for (const std::uint32_t child : {2 * index, 2 * index + 1}) {
    const std::size_t size = push_candidates(PointTree::place(level + 1, child), first, last, descent);
    if (size > last) descend(level + 1, child, last, descent);
    descent.stack.resize(last);
  }
  const std::uint32_t left = PointTree::place(level + 1, 2 * index);
  farthest2_[PointTree::place(level, index)] = std::max(farthest2_[left], farthest2_[left + 1]);
}

/// Gives a leaf's points that the candidate is nearer to over to it, and returns whether there are any.
bool NearestNodes::compare(Leaf leaf, const Candidate& candidate) {
  const std::uint32_t place = PointTree::place(tree_.leaf_level(), leaf);
  // Candidates before this one may have served the leaf better.
  if (distance2(tree_.boxes()[place], candidate.position) >= farthest2_[place]) return false;
  const float* x = x_.data() + begin_[leaf];
  const float* y = y_.data() + begin_[leaf];
  const float* z = z_.data() + begin_[leaf];
  float* nearest2 = distance2_.data() + begin_[leaf];
  NodeIndex* nearest = node_.data() + begin_[leaf];
  const auto count = static_cast<std::int32_t>(end_[leaf] - begin_[leaf]);
  const Vec3 position = candidate.position;
  // Selections instead of branches, and the maximum over the bits of floats (which order like the floats, as none is
  // negative): so compilers take four points at a time, which saves a quarter of all growth. The horizontal squares are
  // added first: turning a cloud about the vertical by a right angle then changes no bit.
  std::int32_t taken = 0;
  std::int32_t farthest2 = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    const float dx = x[k] - position.x;
    const float dy = y[k] - position.y;
    const float dz = z[k] - position.z;
    const float square = (dx * dx + dz * dz) + dy * dy;
    const float before = nearest2[k];
    const bool takes = square < before && square < candidate.within2;
    const float kept = takes ? square : before;
    nearest[k] = takes ? candidate.node : nearest[k];
    taken |= takes ? 1 : 0;
    nearest2[k] = kept;
    const auto bits = std::bit_cast<std::int32_t>(kept);
    farthest2 = bits > farthest2 ? bits : farthest2;
  }
  farthest2_[place] = std::bit_cast<float>(farthest2);
  return taken != 0;
}

void NearestNodes::remove(Leaf leaf, std::uint32_t point) {
  const std::uint32_t last = --end_[leaf];
  x_[point] = x_[last];
  y_[point] = y_[last];
  z_[point] = z_[last];
  distance2_[point] = distance2_[last];
  node_[point] = node_[last];
  if (begin_[leaf] == last) farthest2_[PointTree::place(tree_.leaf_level(), leaf)] = 0;
  --living_;
}

std::optional<Vec3> NearestNodes::nearest_point(Vec3 place) const {
  struct Node {
    int level;
    std::uint32_t index;
  };
  std::optional<Vec3> nearest;
  float least2 = kInfinity;
  const auto gap2 = [&](Node node) {
    return distance2(tree_.boxes()[PointTree::place(node.level, node.index)], place);
  };
  std::vector<Node> open{{0, 0}};
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    if (!(gap2(node) < least2)) continue;
    if (node.level < tree_.leaf_level()) {
      // Look into the nearer half first.
      Node first{node.level + 1, 2 * node.index};
      Node second{node.level + 1, 2 * node.index + 1};
      if (gap2(second) < gap2(first)) std::swap(first, second);
      open.push_back(second);
      open.push_back(first);
      continue;
    }
    for (std::uint32_t k = begin_[node.index]; k < end_[node.index]; ++k) {
      const Vec3 point(x_[k], y_[k], z_[k]);
      const Vec3 offset = point - place;
      const float square = (offset.x * offset.x + offset.z * offset.z) + offset.y * offset.y;
      if (square < least2) {
        least2 = square;
        nearest = point;
      }
    }
  }
  return nearest;
}

}  // namespace meristem

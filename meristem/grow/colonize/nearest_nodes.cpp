// SPDX-License-Identifier: Apache-2.0
// New nodes descend a tree of points together. A tree node stores the largest distance of its points to their nodes, so
// the descent skips parts that no new node can improve.
#include "meristem/grow/colonize/nearest_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include "meristem/base/parallel.h"

namespace meristem {
namespace {

constexpr int kPartLevel = 5;  // 32 parts at most
constexpr std::size_t kCandidatesAtOnce = 1024;
constexpr std::size_t kNodesToShare = 64;  // fewer new nodes are handled by one thread
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Explicit vector types: compilers do not vectorise a loop over points inside a loop over candidates. They halve the
// time of the whole growth.
constexpr std::uint32_t kLanes = 4;
using Floats [[gnu::vector_size(kLanes * sizeof(float))]] = float;
using Indices [[gnu::vector_size(kLanes * sizeof(NodeIndex))]] = NodeIndex;

/// Loads the first `count` lanes from an array, and sets the others to 0.
template <class Vector, class Element>
Vector load(const Element* from, std::uint32_t count) {
  Vector lanes{};
  if (count == kLanes) {
    std::memcpy(&lanes, from, sizeof(lanes));  // a constant size is one instruction, a variable size is a function call
  } else {
    std::memcpy(&lanes, from, count * sizeof(Element));
  }
  return lanes;
}

template <class Vector, class Element>
void store(const Vector& lanes, Element* to, std::uint32_t count) {
  if (count == kLanes) {
    std::memcpy(to, &lanes, sizeof(lanes));
  } else {
    std::memcpy(to, &lanes, count * sizeof(Element));
  }
}

// Infinity stays infinity, and any other value becomes the next larger float.
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
  Candidates candidates{.first = first};
  for (const NewNode& node : nodes) {
    candidates.x.push_back(node.position.x);
    candidates.y.push_back(node.position.y);
    candidates.z.push_back(node.position.z);
    candidates.within2.push_back(just_above(node.influence * node.influence));
    candidates.are_alike = candidates.are_alike && node.influence == nodes[0].influence;
  }
  if (nodes.size() >= kNodesToShare) return descend_in_parts(candidates, progress);
  progress.check();
  std::vector<std::uint32_t> all(nodes.size());
  std::iota(all.begin(), all.end(), 0U);
  start_descent(0, 0, all, candidates);
}

/// Sends each candidate to the parts that it may be near, and descends the parts in parallel. Parts are disjoint, so
/// each can be written by its own thread.
void NearestNodes::descend_in_parts(const Candidates& candidates, const Progress& progress) {
  const std::size_t parts = influenced_.size();
  const std::size_t count = candidates.x.size();
  const std::size_t blocks = (count + kCandidatesAtOnce - 1) / kCandidatesAtOnce;
  std::vector<std::vector<std::uint32_t>> near(blocks * parts);
  parallel_for(count, kCandidatesAtOnce, [&](std::size_t begin, std::size_t end) {
    progress.check();
    std::vector<std::uint32_t>* const own = near.data() + begin / kCandidatesAtOnce * parts;
    for (auto candidate = static_cast<std::uint32_t>(begin); candidate < end; ++candidate) {
      // Descend from the top of the tree, so that distant halves are skipped early.
      std::array<std::uint32_t, (1U << kPartLevel) + 1> open{0};
      std::size_t open_count = is_near(0, candidate, candidates) ? 1 : 0;
      while (open_count > 0) {
        const std::uint32_t tree_node = open[--open_count];
        if (tree_node >= parts - 1) {
          own[tree_node - (parts - 1)].push_back(candidate);
          continue;
        }
        for (const std::uint32_t child : {2 * tree_node + 1, 2 * tree_node + 2}) {
          open[open_count] = child;
          open_count += is_near(child, candidate, candidates) ? 1 : 0;
        }
      }
    }
  });
  parallel_for(parts, 1, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> all;
    for (std::size_t part = begin; part < end; ++part) {
      progress.check();
      all.clear();
      for (std::size_t block = 0; block < blocks; ++block) {
        const std::vector<std::uint32_t>& some = near[block * parts + part];
        all.insert(all.end(), some.begin(), some.end());
      }
      if (!all.empty()) start_descent(part_level_, static_cast<std::uint32_t>(part), all, candidates);
    }
  });
  for (std::uint32_t node = PointTree::place(part_level_, 0); node-- > 0;) join_halves(node);
}

/// Starts the descent of one part. `near` lists the candidates that may be near, in rising order.
void NearestNodes::start_descent(int level, std::uint32_t index, std::span<const std::uint32_t> near,
                                 const Candidates& candidates) {
  // Reserve space for the list of all candidates and one list per level.
  const std::size_t count = near.size();
  Descent descent{&candidates,
                  std::vector<std::uint32_t>(count * static_cast<std::size_t>(tree_.leaf_level() - level + 2))};
  std::copy(near.begin(), near.end(), descent.stack.begin());
  const std::size_t top = push_near(PointTree::place(level, index), 0, count, descent);
  if (top > count) descend(level, index, count, top, descent);
}

/// Returns true if a candidate may become the nearest node of a point in a node of the tree.
bool NearestNodes::is_near(std::uint32_t tree_node, std::uint32_t candidate, const Candidates& candidates) const {
  const Vec3 position(candidates.x[candidate], candidates.y[candidate], candidates.z[candidate]);
  const float within2 = std::min(farthest2_[tree_node], candidates.within2[candidate]);
  return distance2(tree_.boxes()[tree_node], position) < within2;
}

/// Pushes the candidates from `first` to `last` that may be near a point in a node of the tree. Returns the new top of
/// the stack.
std::size_t NearestNodes::push_near(std::uint32_t tree_node, std::size_t first, std::size_t last,
                                    Descent& descent) const {
  const Box box = tree_.boxes()[tree_node];
  const float farthest2 = farthest2_[tree_node];
  const Candidates& candidates = *descent.candidates;
  const std::uint32_t* const from = descent.stack.data();
  std::uint32_t* const to = descent.stack.data();
  std::size_t top = last;
  for (std::size_t k = first; k < last; ++k) {
    const std::uint32_t candidate = from[k];
    const Vec3 position(candidates.x[candidate], candidates.y[candidate], candidates.z[candidate]);
    const float within2 = std::min(farthest2, candidates.within2[candidate]);
    to[top] = candidate;
    top += distance2(box, position) < within2 ? 1 : 0;
  }
  return top;
}

/// Assigns points in a node of the tree to the candidates from `first` to `last` of the stack, where these are nearer.
/// The recursion is as deep as the tree: the logarithm of the number of points.
void NearestNodes::descend(int level, std::uint32_t index, std::size_t first, std::size_t last, Descent& descent) {
  if (level == tree_.leaf_level()) {
    const std::span<const std::uint32_t> near = std::span(descent.stack).subspan(first, last - first);
    if (compare(index, near, *descent.candidates) && is_influenced_[index] == 0) {
      is_influenced_[index] = 1;
      influenced_[index >> (tree_.leaf_level() - part_level_)].push_back(index);
    }
    return;
  }
  for (const std::uint32_t child : {2 * index, 2 * index + 1}) {
    const std::size_t top = push_near(PointTree::place(level + 1, child), first, last, descent);
    if (top > last) descend(level + 1, child, last, top, descent);
  }
  join_halves(PointTree::place(level, index));
}

/// Assigns the points of a leaf to nearer candidates. Returns true if any point of the leaf has a node.
bool NearestNodes::compare(Leaf leaf, std::span<const std::uint32_t> near, const Candidates& candidates) {
  bool any = false;
  float farthest2 = 0;
  for (std::uint32_t k = begin_[leaf]; k < end_[leaf]; k += kLanes) {
    // Four points stay in registers while all candidates are tested. The horizontal squares are added first, so that
    // rotating a cloud about the vertical by a right angle changes no bit.
    const std::uint32_t count = std::min(kLanes, end_[leaf] - k);
    const auto x = load<Floats>(x_.data() + k, count);
    const auto y = load<Floats>(y_.data() + k, count);
    const auto z = load<Floats>(z_.data() + k, count);
    const auto before2 = load<Floats>(distance2_.data() + k, count);
    const auto before = load<Indices>(node_.data() + k, count);
    // If all candidates have equal reach, compare it once instead of for each candidate.
    const Floats reach2 = Floats{} + candidates.within2[near[0]];
    auto min2 = candidates.are_alike ? (reach2 < before2 ? reach2 : before2) : before2;
    auto nearest = before;
    const auto look_at = [&](std::uint32_t candidate, auto... within2) {
      const Floats dx = x - candidates.x[candidate];
      const Floats dy = y - candidates.y[candidate];
      const Floats dz = z - candidates.z[candidate];
      const Floats square = (dx * dx + dz * dz) + dy * dy;
      const auto takes = ((square < min2) & ... & (square < within2));
      nearest = takes ? Indices{} + (candidates.first + candidate) : nearest;
      min2 = takes ? square : min2;
    };
    if (candidates.are_alike) {
      for (const std::uint32_t candidate : near) look_at(candidate);
      min2 = nearest == before ? before2 : min2;
    } else {
      for (const std::uint32_t candidate : near) look_at(candidate, candidates.within2[candidate]);
    }
    store(min2, distance2_.data() + k, count);
    store(nearest, node_.data() + k, count);
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      any = any || min2[lane] < before2[lane];
      farthest2 = std::max(farthest2, min2[lane]);
    }
  }
  farthest2_[PointTree::place(tree_.leaf_level(), leaf)] = farthest2;
  return any;
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

std::optional<Vec3> NearestNodes::nearest_point(Vec3 position) const {
  struct Node {
    int level;
    std::uint32_t index;
  };
  std::optional<Vec3> nearest;
  float min2 = kInfinity;
  const auto gap2 = [&](Node node) {
    return distance2(tree_.boxes()[PointTree::place(node.level, node.index)], position);
  };
  std::vector<Node> open{{0, 0}};
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    if (!(gap2(node) < min2)) continue;
    if (node.level < tree_.leaf_level()) {
      // Search the nearer half first.
      Node first{node.level + 1, 2 * node.index};
      Node second{node.level + 1, 2 * node.index + 1};
      if (gap2(second) < gap2(first)) std::swap(first, second);
      open.push_back(second);
      open.push_back(first);
      continue;
    }
    for (std::uint32_t k = begin_[node.index]; k < end_[node.index]; ++k) {
      const Vec3 point(x_[k], y_[k], z_[k]);
      const float square = squared_length(point - position);
      if (square < min2) {
        min2 = square;
        nearest = point;
      }
    }
  }
  return nearest;
}

}  // namespace meristem

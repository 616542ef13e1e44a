// SPDX-License-Identifier: Apache-2.0
// Finds the nearest round segment with a hierarchy of boxes. A PointTree divides the midpoints of the segments. Each
// tree node stores the box of its segments' axes and their largest radius. The distance to the box minus that radius is
// a lower bound for the distance to a surface.
#include "meristem/plant/segment_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "meristem/base/point_tree.h"

namespace meristem {

namespace {

constexpr std::size_t kLeafSegments = 16;
constexpr std::size_t kDeepestStack = 80;  // two entries per level
constexpr float kSlack = 2e-6F;            // relative margin for the rounding of bounds and distances

}  // namespace

float RoundSegment::distance(Vec3 position) const {
  const Vec3 way = end - begin;
  const float length2 = glm::dot(way, way);
  const float share = length2 > 0 ? std::clamp(glm::dot(position - begin, way) / length2, 0.0F, 1.0F) : 0;
  const float off_axis = glm::length(position - (begin + share * way));
  return std::abs(off_axis - (begin_radius + share * (end_radius - begin_radius)));
}

void append_segments(const Skeleton& skeleton, std::uint32_t first_axis, std::vector<RoundSegment>& segments) {
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    const NodeIndex parent = skeleton.parent[node];
    if (parent == kNoNode) continue;
    const bool begins = skeleton.axis[parent] != skeleton.axis[node];
    segments.push_back({skeleton.position[parent], skeleton.position[node],
                        begins ? skeleton.radius[node] : skeleton.radius[parent], skeleton.radius[node],
                        first_axis + skeleton.axis[node]});
  }
}

struct SegmentTree::Boxes {
  std::vector<RoundSegment> segments;  // in the order of the tree
  std::unique_ptr<const PointTree> tree;
  std::vector<Box> box;  // one for each tree node
  std::vector<float> thickest;
};

SegmentTree::SegmentTree(std::vector<RoundSegment> segments, const Progress& progress) {
  auto made = std::make_unique<Boxes>();
  std::vector<NumberedPoint> middles;
  middles.reserve(segments.size());
  for (const RoundSegment& segment : segments) {
    middles.push_back({0.5F * (segment.begin + segment.end), static_cast<std::uint32_t>(middles.size())});
  }
  made->tree = std::make_unique<const PointTree>(middles, progress, kLeafSegments);
  made->segments.reserve(segments.size());
  for (const NumberedPoint& middle : middles) made->segments.push_back(segments[middle.number]);

  // Compute the leaves from their segments, then each higher node from its two halves.
  const PointTree& tree = *made->tree;
  made->box.resize(tree.node_count());
  made->thickest.resize(tree.node_count(), 0);
  for (int level = tree.leaf_level(); level >= 0; --level) {
    for (std::uint32_t index = 0; index < std::uint32_t{1} << level; ++index) {
      const std::uint32_t place = PointTree::place(level, index);
      if (level < tree.leaf_level()) {
        for (const std::uint32_t half : {2 * place + 1, 2 * place + 2}) {
          made->box[place].add(made->box[half]);
          made->thickest[place] = std::max(made->thickest[place], made->thickest[half]);
        }
        continue;
      }
      for (std::uint32_t k = tree.first_point(level, index); k < tree.first_point(level, index + 1); ++k) {
        const RoundSegment& segment = made->segments[k];
        made->box[place].add(segment.begin);
        made->box[place].add(segment.end);
        made->thickest[place] = std::max({made->thickest[place], segment.begin_radius, segment.end_radius});
      }
    }
    progress.check();
  }
  boxes_ = std::move(made);
}

SegmentTree::~SegmentTree() = default;
SegmentTree::SegmentTree(SegmentTree&&) noexcept = default;

std::uint32_t SegmentTree::nearest(Vec3 position) const {
  if (boxes_->segments.empty()) return kNoSegment;
  struct Step {
    int level;
    std::uint32_t index;
    float bound;
  };
  const PointTree& tree = *boxes_->tree;
  const float extent = std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z)});
  const auto bound_of = [&](int level, std::uint32_t index) {
    const std::uint32_t place = PointTree::place(level, index);
    const float bound = std::sqrt(distance2(boxes_->box[place], position)) - boxes_->thickest[place];
    return bound - kSlack * (extent + std::abs(bound) + boxes_->thickest[place]);
  };
  float best = std::numeric_limits<float>::infinity();
  std::uint32_t number = kNoSegment;
  std::array<Step, kDeepestStack> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0, bound_of(0, 0)};
  while (depth > 0) {
    const auto [level, index, bound] = stack[--depth];
    if (bound > best) continue;
    if (level < tree.leaf_level()) {
      Step near{level + 1, 2 * index, bound_of(level + 1, 2 * index)};
      Step far{level + 1, 2 * index + 1, bound_of(level + 1, 2 * index + 1)};
      if (far.bound < near.bound) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
      continue;
    }
    for (std::uint32_t k = tree.first_point(level, index); k < tree.first_point(level, index + 1); ++k) {
      const RoundSegment& segment = boxes_->segments[k];
      const float distance = segment.distance(position);
      if (distance > best || (distance == best && segment.number >= number)) continue;
      best = distance;
      number = segment.number;
    }
  }
  return number;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/nearest_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meristem/base/point_tree.h"

namespace meristem {

namespace {

constexpr std::uint32_t kSegmentsTogether = 8;
constexpr std::size_t kDeepest = 64;  // halving 2^32 segments takes half as many steps

}  // namespace

NearestAxis::NearestAxis(const Plant& plant) {
  // A segment leads from a node's parent to the node, on the axis of the node. A root is a segment without length.
  for (std::size_t s = 0; s < plant.stems.size(); ++s) {
    const Skeleton& skeleton = plant.stems[s].skeleton;
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      const NodeIndex from = skeleton.is_root(node) ? node : skeleton.parent[node];
      segments_.push_back({skeleton.position[from],
                           skeleton.position[node],
                           std::min(skeleton.radius[from], 2 * skeleton.radius[node]),
                           skeleton.radius[node],
                           {static_cast<std::uint32_t>(s), skeleton.axis[node]},
                           static_cast<std::uint32_t>(segments_.size())});
    }
  }
  if (segments_.empty()) return;

  // Halve them along the longest extent of their middles, the first half right behind its whole.
  struct Waiting {
    std::uint32_t first, last;
    std::uint32_t parent;  // whose second half it is, or none
  };
  constexpr std::uint32_t kNone = 0xffffffffU;
  std::vector<Waiting> waiting{{0, static_cast<std::uint32_t>(segments_.size()), kNone}};
  while (!waiting.empty()) {
    const Waiting range = waiting.back();
    waiting.pop_back();
    const auto index = static_cast<std::uint32_t>(branches_.size());
    if (range.parent != kNone) branches_[range.parent].second = index;
    Branch& branch = branches_.emplace_back();
    branch.first = range.first;
    branch.last = range.last;
    Box middles;
    for (std::uint32_t k = range.first; k < range.last; ++k) {
      const Segment& segment = segments_[k];
      branch.box.add(segment.begin);
      branch.box.add(segment.end);
      branch.radius = std::max({branch.radius, segment.begin_radius, segment.end_radius});
      middles.add(0.5F * (segment.begin + segment.end));
    }
    if (range.last - range.first <= kSegmentsTogether) continue;
    const Vec3 size = middles.size();
    const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = range.first + (range.last - range.first) / 2;
    std::nth_element(segments_.begin() + range.first, segments_.begin() + half, segments_.begin() + range.last,
                     [along](const Segment& a, const Segment& b) {
                       const float one = a.begin[along] + a.end[along];
                       const float other = b.begin[along] + b.end[along];
                       return one != other ? one < other : a.number < b.number;
                     });
    waiting.push_back({half, range.last, index});
    waiting.push_back({range.first, half, kNone});
  }
}

float NearestAxis::distance(const Segment& segment, Vec3 position, bool counts_within) {
  const Vec3 along = segment.end - segment.begin;
  const float length2 = squared_length(along);
  const float share = length2 > 0 ? std::clamp(glm::dot(position - segment.begin, along) / length2, 0.0F, 1.0F) : 0;
  const float from_centre = glm::length(position - (segment.begin + share * along));
  const float from_surface = from_centre - glm::mix(segment.begin_radius, segment.end_radius, share);
  return counts_within ? std::abs(from_surface) : std::max(0.0F, from_surface);
}

std::optional<StemAxis> NearestAxis::find(Vec3 position, bool counts_within) const {
  if (segments_.empty()) return std::nullopt;
  const Segment* best = nullptr;
  float nearest = std::numeric_limits<float>::infinity();
  const auto least = [&](const Branch& branch) { return std::sqrt(distance2(branch.box, position)) - branch.radius; };
  std::uint32_t open[kDeepest] = {0};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = open[--count];
    const Branch& branch = branches_[index];
    if (least(branch) > nearest) continue;
    if (branch.second == 0) {
      for (std::uint32_t k = branch.first; k < branch.last; ++k) {
        const float away = distance(segments_[k], position, counts_within);
        if (away > nearest || (away == nearest && best != nullptr && best->number < segments_[k].number)) continue;
        nearest = away;
        best = &segments_[k];
      }
      continue;
    }
    // The nearer half comes first.
    const std::uint32_t halves[2] = {index + 1, branch.second};
    const int nearer = least(branches_[halves[0]]) <= least(branches_[halves[1]]) ? 0 : 1;
    open[count++] = halves[1 - nearer];
    open[count++] = halves[nearer];
  }
  return best->axis;
}

}  // namespace meristem

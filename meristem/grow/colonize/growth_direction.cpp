// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/growth_direction.h"

#include <algorithm>
#include <cmath>

namespace meristem {
namespace {

constexpr double kUnit = 274'877'906'944;  // 2^38: sums of up to 2^25 unit vectors fit into 64 bits
constexpr double kVanishing = 1e-5;        // shorter sums are what rounding leaves of balanced points

std::int64_t in_units(double component) { return static_cast<std::int64_t>(component * kUnit); }

std::optional<DVec3> unit(DVec3 vector) {
  const double length = std::sqrt(glm::dot(vector, vector));
  if (!(length > kVanishing)) return std::nullopt;
  return vector / length;
}

}  // namespace

std::span<const Pull> PullSums::gather(const NearestNodes& nearest, std::span<const Vec3> node_positions) {
  slot_.resize(node_positions.size(), 0);
  sums_.clear();
  nearest.for_each_influenced([&](Vec3 point, NodeIndex node) {
    if (slot_[node] == 0) {
      sums_.push_back({node, 0, 0, 0});
      slot_[node] = static_cast<std::uint32_t>(sums_.size());
    }
    // A point exactly on its node pulls nowhere.
    const DVec3 offset = DVec3(point) - DVec3(node_positions[node]);
    const double length2 = glm::dot(offset, offset);
    if (length2 == 0) return;
    const double scale = 1 / std::sqrt(length2);
    Sum& sum = sums_[slot_[node] - 1];
    sum.x += in_units(offset.x * scale);
    sum.y += in_units(offset.y * scale);
    sum.z += in_units(offset.z * scale);
  });
  // Leave the slots empty for the next call, and put the nodes in order.
  for (const Sum& sum : sums_) slot_[sum.node] = 0;
  std::sort(sums_.begin(), sums_.end(), [](const Sum& a, const Sum& b) { return a.node < b.node; });
  pulls_.clear();
  for (const Sum& sum : sums_) {
    const DVec3 units(static_cast<double>(sum.x), static_cast<double>(sum.y), static_cast<double>(sum.z));
    pulls_.push_back({sum.node, units / kUnit});
  }
  return pulls_;
}

std::optional<DVec3> growth_direction(const Pull& pull, DVec3 bias) {
  const std::optional<DVec3> toward_points = unit(pull.sum);
  if (!toward_points) return std::nullopt;
  return unit(*toward_points + bias);
}

}  // namespace meristem

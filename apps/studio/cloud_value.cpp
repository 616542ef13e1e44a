// SPDX-License-Identifier: Apache-2.0
#include "cloud_value.h"

#include <vector>

#include "meristem/components/crown_cloud.h"

namespace meristem::studio {

namespace {

constexpr std::size_t kMaxToldPoints = 4000;  // more points would look the same behind an outline

/// Returns an even choice of the points, equal for equal points, in which each part of the crown keeps its share.
std::vector<Vec3> some_of(const std::vector<Vec3>& points) {
  if (points.size() <= kMaxToldPoints) return points;
  std::vector<Vec3> some;
  some.reserve(kMaxToldPoints);
  for (std::size_t k = 0; k < kMaxToldPoints; ++k) some.push_back(points[k * points.size() / kMaxToldPoints]);
  return some;
}

}  // namespace

Value cloud_value(const LastGrown& last, const std::string& component, Progress& progress, PacketArrays& arrays) {
  const Document& document = *last.grown.document;
  const auto points =
      crown_cloud(document.graph, document.scene, component, last.grown.time, progress, &last.cache, last.grown.view);
  if (!points) return {};
  const Value positions = arrays.add(packed_vectors(some_of(*points)));
  return Value::Object{{"positions", positions}, {"count", static_cast<double>(points->size())}};
}

}  // namespace meristem::studio

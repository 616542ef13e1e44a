// SPDX-License-Identifier: Apache-2.0
// Checks the sections of lofts for points from which no surface can be made.
#include <cmath>

#include "meristem/shape/flat/cut_polygon.h"
#include "meristem/shape/flat/flat_ring.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxSectionPoints = 1000;
constexpr double kSameSectionPoint = 1e-6;  // share of a section's extent

/// Returns the first point of a row or ring that repeats the point before.
std::optional<std::size_t> repeated_point(const LoftSection& section) {
  const std::vector<Vec3>& points = section.points;
  const double nearest = kSameSectionPoint * extent_of(points);
  const auto repeats = [&](std::size_t a, std::size_t b) {
    return glm::distance(DVec3(points[a]), DVec3(points[b])) <= nearest;
  };
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (repeats(k - 1, k)) return k;
  }
  if (section.is_closed && points.size() > 1 && repeats(points.size() - 1, 0)) return points.size() - 1;
  return {};
}

}  // namespace

std::optional<LoftError> find_error(const LoftSection& section) {
  const std::vector<Vec3>& points = section.points;
  const std::string wanted = section.is_closed ? "at least 3 points, or 1 for a tip" : "at least 2, or 1 for a tip";
  if (points.empty()) return LoftError{"it has no points", wanted, {}};
  if (section.is_closed && points.size() == 2) return LoftError{"a ring of 2 points encloses nothing", wanted, {}};
  if (points.size() > kMaxSectionPoints) return LoftError{"it has too many points", "at most 1000", kMaxSectionPoints};
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (std::isfinite(points[k].x) && std::isfinite(points[k].y) && std::isfinite(points[k].z)) continue;
    return LoftError{"this point is not finite", "finite numbers", k};
  }
  if (const auto repeated = repeated_point(section)) {
    const bool is_end = section.is_closed && *repeated + 1 == points.size();
    return LoftError{is_end ? "this point coincides with its neighbour or with the first point"
                            : "this point coincides with the one before",
                     section.is_closed ? "points that differ; a ring closes by itself" : "points that differ",
                     repeated};
  }
  if (!section.is_closed || section.is_point()) return {};
  const DVec3 area = area_vector(points);
  const double extent = extent_of(points);
  if (!(glm::length(area) > kSameSectionPoint * extent * extent)) {
    return LoftError{"the ring encloses nothing", "points that are not all on a line", {}};
  }
  if (crosses_itself(flattened(points, area))) {
    return LoftError{"the ring crosses or touches itself", "points in their order around an area", {}};
  }
  return {};
}

}  // namespace meristem

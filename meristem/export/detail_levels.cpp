// SPDX-License-Identifier: Apache-2.0
// Makes levels of detail and checks that each one is worth a file. A level must have clearly fewer triangles than the
// level before, and its outline in a small picture must match that of the whole plant from all sides.
#include "meristem/export/detail_levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/shape/detail/small_detail.h"
#include "meristem/shape/outline/outline.h"

namespace meristem {

namespace {

constexpr int kPixelsOfTheWhole = 256;
constexpr int kFewestPixels = 16;
constexpr int kMaxDirections = 26;
constexpr int kFewestDirections = 4;
constexpr double kMaxDrawn = 3e7;  // maximum number of triangles times directions: a second of drawing

/// Returns the number of directions from which two scenes are compared that have `triangles` together.
int directions_for(std::uint64_t triangles) {
  const double directions = kMaxDrawn / std::max(1.0, static_cast<double>(triangles));
  return std::clamp(static_cast<int>(std::min(directions, 1e3)), kFewestDirections, kMaxDirections);
}

}  // namespace

int pixels_of_level(int number) { return std::max(kPixelsOfTheWhole >> number, kFewestPixels); }

std::string error_of_level(const MeshScene& whole, std::uint64_t before, const MeshScene& level, int number,
                           Progress& progress) {
  const std::uint64_t triangles = level.triangle_count();
  if (static_cast<double>(triangles) > kMostOfTheLevelBefore * static_cast<double>(before)) {
    return fmt::format("it would have {} triangles, too near to the {} of the level before", triangles, before);
  }
  const OutlineOptions outlines{.directions = directions_for(whole.triangle_count() + triangles),
                                .size = pixels_of_level(number)};
  const double shared = outline_overlap(whole, level, outlines, progress).min();
  const double wanted = whole.triangle_count() <= kSmallPlant ? kMinOutlineShared : kMinCrownShared;
  if (shared < wanted) {
    return fmt::format(
        "with {} triangles it would share {:.0f} % of the plant's outline from some side; {:.0f} % are wanted",
        triangles, std::floor(100 * shared), 100 * wanted);
  }
  return {};
}

std::optional<WorthlessLevel> make_levels(const Document& document, const Plant& plant, const MeshScene& whole,
                                          int count, const std::function<void(int, MeshScene)>& take,
                                          Progress& progress) {
  std::uint64_t before = whole.triangle_count();
  for (int number = 1; number <= count; ++number) {
    MeshScene level = mesh_detail(document, plant, {.level = number}, progress);
    std::string reason = error_of_level(whole, before, level, number, progress);
    if (!reason.empty()) return WorthlessLevel{number, std::move(reason)};
    before = level.triangle_count();
    take(number, std::move(level));
  }
  return std::nullopt;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Tabulates the dome of the sky over directions. A direction is mapped to the upper half of an octahedron and
// interpolated between table entries, which avoids the sky model in every lookup.
#include "meristem/output/picture/daylight.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/colour.h"

namespace meristem {

namespace {

constexpr int kCells = 128;
constexpr std::size_t kRow = kCells + 1;
// Share of colour that is removed from the light of the dome on surfaces.
constexpr float kPaleness = 0.45F;

}  // namespace

Daylight::Daylight(const Sky& sky, Vec3 ground_colour)
    : sun_direction_(sky.sun_direction()),
      sun_irradiance_(sky.sun_irradiance()),
      sun_angular_radius_(sky.sun_angular_radius()) {
  seen_ = tabulated([&](Vec3 direction) { return sky.radiance(direction); });
  falling_ = seen_;
  for (Vec3& light : falling_) light = glm::mix(light, Vec3(luminance(light)), kPaleness);
  const Vec3 level_sun = std::max(0.0F, sun_direction_.y) * sun_irradiance_;
  below_ = ground_colour * (level_sun + sky.dome_irradiance()) / static_cast<float>(kPi);
}

Daylight::Daylight(FunctionRef<Vec3(Vec3)> dome, Vec3 below) : seen_(tabulated(dome)), falling_(seen_), below_(below) {}

std::vector<Vec3> Daylight::tabulated(FunctionRef<Vec3(Vec3)> dome) {
  std::vector<Vec3> table;
  table.reserve(kRow * kRow);
  for (int row = 0; row <= kCells; ++row) {
    for (int column = 0; column <= kCells; ++column) {
      // The upper half of the octahedron, turned by 45° so that it fills the square.
      const float s = 2.0F * static_cast<float>(column) / kCells - 1;
      const float t = 2.0F * static_cast<float>(row) / kCells - 1;
      const float x = (s + t) / 2;
      const float z = (s - t) / 2;
      table.push_back(dome(glm::normalize(Vec3(x, 1 - std::abs(x) - std::abs(z), z))));
    }
  }
  return table;
}

Vec3 Daylight::looked_up(const std::vector<Vec3>& table, Vec3 direction) {
  const float height = std::max(direction.y, 0.0F);
  const float sum = std::abs(direction.x) + std::abs(direction.z) + height;
  const float scale = sum > 0 ? 1 / sum : 0;
  const float x = direction.x * scale;
  const float z = direction.z * scale;
  const float s = std::clamp((x + z + 1) / 2 * kCells, 0.0F, static_cast<float>(kCells));
  const float t = std::clamp((x - z + 1) / 2 * kCells, 0.0F, static_cast<float>(kCells));
  const int column = std::min(static_cast<int>(s), kCells - 1);
  const int row = std::min(static_cast<int>(t), kCells - 1);
  const Vec3* corner = table.data() + row * kRow + column;
  const float across = s - static_cast<float>(column);
  return glm::mix(glm::mix(corner[0], corner[1], across), glm::mix(corner[kRow], corner[kRow + 1], across),
                  t - static_cast<float>(row));
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Overlays of the place: the sun over the plants, a compass rose, a scale bar and the axes. They depend on the scene
// and the box around the plants.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/frame.h"
#include "meristem/export/overlay/overlay_makers.h"

namespace meristem {

namespace {

constexpr Vec3 kSun{0.96F, 0.76F, 0.1F};
constexpr Vec3 kNorth{0.75F, 0.16F, 0.12F};
constexpr Vec3 kSouth{0.3F, 0.32F, 0.34F};
constexpr Vec3 kBar{0.1F, 0.1F, 0.1F};

float longest_of(const Box& box) {
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z, 1e-3F});
}

/// Returns 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double share = length / power;
  return power * (share >= 5 ? 5 : (share >= 2 ? 2 : 1));
}

std::string length_text(double metres) {
  if (metres < 0.00995) return fmt::format("{:.3g} mm", 1000 * metres);
  return metres < 0.995 ? fmt::format("{:.3g} cm", 100 * metres) : fmt::format("{:.3g} m", metres);
}

}  // namespace

/// Draws parallel arrows of the strongest light onto the plant, and a disc for each position of the sun.
void show_sun(const OverlaySubject& subject, OverlayLayer& layer) {
  const std::vector<DirectionalLight>& sun = subject.scene.light.sun;
  if (sun.empty()) return;
  const Box box = subject.bounds;
  if (box.is_empty()) return;
  const float size = longest_of(box);
  const float reach = 0.5F * glm::length(box.size()) + 0.12F * size;
  const auto strongest = std::ranges::max_element(sun, {}, &DirectionalLight::strength);
  const Vec3 toward = strongest->toward;
  const Vec3 side = normalized_or(glm::cross(toward, kUp), Vec3(1, 0, 0));
  const Vec3 rise = glm::cross(side, toward);
  for (int k = -1; k <= 1; ++k) {
    for (int row = -1; row <= 1; ++row) {
      if (std::abs(k) + std::abs(row) > 1) continue;
      const Vec3 middle = box.centre() + 0.28F * size * (static_cast<float>(k) * side + static_cast<float>(row) * rise);
      layer.arrows.push_back({middle + (reach + 0.3F * size) * toward, middle + reach * toward, kSun});
    }
  }
  if (sun.size() > 1) {
    const float far = reach + 0.35F * size;
    for (std::size_t k = 0; k < sun.size(); ++k) {
      const Vec3 at = box.centre() + far * sun[k].toward;
      layer.points.push_back({at, kSun});
      const bool follows = k > 0 && glm::distance(sun[k].toward, sun[k - 1].toward) < 0.5F;
      if (follows) layer.lines.push_back({box.centre() + far * sun[k - 1].toward, at, kSun});
    }
  }
  const double altitude = std::asin(std::clamp(static_cast<double>(toward.y), -1.0, 1.0)) * 180 / kPi;
  layer.legend.push_back({kSun, sun.size() > 1 ? fmt::format("sun, {} positions", sun.size())
                                               : fmt::format("sun, {:.0f} degrees high", altitude)});
}

void show_compass(const OverlaySubject& subject, OverlayLayer& layer) {
  const Box box = subject.bounds;
  if (box.is_empty()) return;
  const float size = 0.16F * longest_of(box);
  const Vec3 centre = Vec3(box.centre().x, 0, box.centre().z) +
                      (0.5F * glm::length(Vec3(box.size().x, 0, box.size().z)) + 1.3F * size) * subject.right;
  const struct {
    const char* letter;
    Vec3 way;
  } sides[] = {{"N", {0, 0, -1}}, {"E", {1, 0, 0}}, {"S", {0, 0, 1}}, {"W", {-1, 0, 0}}};
  for (const auto& [letter, way] : sides) {
    const Vec3 colour = *letter == 'N' ? kNorth : kSouth;
    const Vec3 tip = centre + size * way;
    if (*letter == 'N') {
      layer.arrows.push_back({centre, tip, colour});
    } else {
      layer.lines.push_back({centre, centre + 0.7F * size * way, colour});
    }
    layer.labels.push_back({centre + 1.2F * size * way, letter});
  }
}

void show_scale(const OverlaySubject& subject, OverlayLayer& layer) {
  const Box box = subject.bounds;
  if (box.is_empty()) return;
  const float size = longest_of(box);
  const auto length = static_cast<float>(round_length(0.5 * static_cast<double>(size)));
  const Vec3 toward_eye = glm::cross(subject.right, kUp);
  const Vec3 middle =
      Vec3(box.centre().x, 0, box.centre().z) + (0.5F * glm::length(Vec3(box.size().x, 0, box.size().z))) * toward_eye;
  const Vec3 from = middle - 0.5F * length * subject.right;
  const Vec3 to = middle + 0.5F * length * subject.right;
  const Vec3 tick = 0.02F * size * kUp;
  layer.lines.push_back({from, to, kBar});
  layer.lines.push_back({from, from + tick, kBar});
  layer.lines.push_back({to, to + tick, kBar});
  layer.labels.push_back({middle + 1.5F * tick, length_text(static_cast<double>(length))});
}

/// Draws the axes from the origin over the extent of the plants, with ticks at multiples of a round length.
void show_axes(const OverlaySubject& subject, OverlayLayer& layer) {
  const Box box = subject.bounds;
  if (box.is_empty()) return;
  const Vec3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
  const float reach = 1.1F * std::max({far.x, far.y, far.z, 1e-3F});
  const auto unit = static_cast<float>(round_length(0.34 * static_cast<double>(reach)));
  const struct {
    const char* name;
    Vec3 way;
    Vec3 across;
    Vec3 colour;
  } axes[] = {{"x", {1, 0, 0}, kUp, {0.78F, 0.15F, 0.12F}},
              {"y", kUp, {1, 0, 0}, {0.15F, 0.55F, 0.18F}},
              {"z", {0, 0, 1}, kUp, {0.15F, 0.3F, 0.78F}}};
  for (const auto& [name, way, across, colour] : axes) {
    layer.arrows.push_back({Vec3(0), reach * way, colour});
    layer.labels.push_back({1.06F * reach * way, name});
    for (float at = unit; at < 0.97F * reach; at += unit) {
      layer.lines.push_back({at * way, at * way + 0.02F * reach * across, colour});
    }
    layer.legend.push_back({colour, fmt::format("{}, a mark each {}", name, length_text(static_cast<double>(unit)))});
  }
}

}  // namespace meristem

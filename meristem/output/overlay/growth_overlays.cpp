// SPDX-License-Identifier: Apache-2.0
// What plants grew by, at a step of their growth.
#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "meristem/base/counted.h"
#include "meristem/output/overlay/overlay_makers.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/scene/brighter_way.h"

namespace meristem {

namespace {

constexpr Vec3 kFree{0.12F, 0.32F, 0.82F};
constexpr Vec3 kUsed{0.66F, 0.67F, 0.7F};
constexpr Vec3 kRemoved{0.82F, 0.16F, 0.12F};
constexpr Vec3 kPull{0.45F, 0.62F, 0.93F};
constexpr Vec3 kWay{0.93F, 0.62F, 0.08F};
constexpr Vec3 kRoom{0.18F, 0.62F, 0.3F};
constexpr Vec3 kShed{0.62F, 0.4F, 0.16F};
constexpr Vec3 kCut{0.82F, 0.16F, 0.12F};

constexpr std::size_t kMostWays = 90;  // more could not be told apart
constexpr double kWayShare = 0.06;     // length of an arrow, of the longest side of the plant

void show_places(const std::vector<TracedPlace>& places, const std::array<Vec3, 3>& colours,
                 const std::array<const char*, 3>& texts, const char* what, OverlayLayer& layer) {
  std::array<std::size_t, 3> counts{};
  for (const TracedPlace& place : places) {
    const auto state = static_cast<std::size_t>(place.state);
    ++counts[state];
    layer.points.push_back({place.position, colours[state]});
  }
  for (std::size_t state = 0; state < counts.size(); ++state) {
    if (counts[state] == 0) continue;
    layer.legend.push_back({colours[state], fmt::format("{} {}", counted(counts[state], what), texts[state])});
  }
}

/// Where some of the nodes of plants find more light, all over the plants.
std::vector<TracedWay> ways_past_obstacles(const OverlaySubject& subject, double length) {
  std::vector<TracedWay> ways;
  std::size_t nodes = 0;
  for (const Stem& stem : subject.plant.stems) nodes += stem.skeleton.node_count();
  const std::size_t every = 1 + nodes / kMostWays;
  for (const Stem& stem : subject.plant.stems) {
    for (std::size_t node = every / 2; node < stem.skeleton.node_count(); node += every) {
      subject.progress.check();
      const Vec3 from = stem.skeleton.position[node];
      const DVec3 way = brighter_way(subject.scene, from, 1);
      const double size = std::sqrt(glm::dot(way, way));
      if (size > 1e-12) ways.push_back({from, from + Vec3(way * (length / size))});
    }
  }
  return ways;
}

}  // namespace

void show_points(const OverlaySubject& subject, OverlayLayer& layer) {
  show_places(subject.marks.points, {kFree, kUsed, kRemoved}, {"left", "used up", "removed"}, "point", layer);
}

void show_pulls(const OverlaySubject& subject, OverlayLayer& layer) {
  for (const TracedWay& pull : subject.marks.pulls) layer.lines.push_back({pull.from, pull.to, kPull});
  if (!layer.lines.empty()) layer.legend.push_back({kPull, "pull of the points"});
}

void show_ways(const OverlaySubject& subject, OverlayLayer& layer) {
  const Vec3 size = subject.bounds.size();
  const double length = kWayShare * std::max({size.x, size.y, size.z});
  if (subject.marks.ways.empty()) {
    for (const TracedWay& way : ways_past_obstacles(subject, length)) layer.arrows.push_back({way.from, way.to, kWay});
  }
  const std::size_t every = 1 + subject.marks.ways.size() / kMostWays;
  for (std::size_t k = 0; k < subject.marks.ways.size(); k += every) {
    const TracedWay& way = subject.marks.ways[k];
    layer.arrows.push_back({way.from, way.from + static_cast<float>(length) * (way.to - way.from), kWay});
  }
  if (layer.arrows.empty()) return;
  const bool is_room = !subject.marks.markers.empty();
  layer.legend.push_back({kWay, is_room ? "ways to more room" : "ways to more light"});
}

void show_markers(const OverlaySubject& subject, OverlayLayer& layer) {
  show_places(subject.marks.markers, {kRoom, kUsed, kRemoved}, {"free", "taken", "removed"}, "marker", layer);
}

void show_losses(const OverlaySubject& subject, OverlayLayer& layer) {
  std::map<std::string, std::size_t> counts;
  for (const TracedLoss& loss : subject.marks.losses) {
    const bool is_shed = loss.why.ends_with(".shedding");
    ++counts[loss.why];
    for (const TracedWay& segment : loss.segments) {
      layer.lines.push_back({segment.from, segment.to, is_shed ? kShed : kCut});
    }
  }
  for (const auto& [why, count] : counts) {
    const bool is_shed = why.ends_with(".shedding");
    const std::string what = count == 1 ? "branch" : "branches";
    layer.legend.push_back({is_shed ? kShed : kCut, is_shed ? fmt::format("{} {} shed", count, what)
                                                            : fmt::format("{} {} cut by {}", count, what, why)});
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Overlays that explain the growth of plants in one step: attraction points and their pull, ways to the light, markers
// and losses. The data come from the growth traces of the plants.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/counted.h"
#include "meristem/export/overlay/overlay_makers.h"
#include "meristem/scene/brighter_way.h"

namespace meristem {

namespace {

constexpr Vec3 kFree{0.12F, 0.32F, 0.82F};
constexpr Vec3 kUsed{0.66F, 0.67F, 0.7F};
constexpr Vec3 kRemoved{0.82F, 0.16F, 0.12F};
constexpr Vec3 kPull{0.45F, 0.62F, 0.93F};
constexpr Vec3 kWay{0.93F, 0.62F, 0.08F};
constexpr Vec3 kRoomWay{0.1F, 0.55F, 0.55F};
constexpr Vec3 kRoom{0.18F, 0.62F, 0.3F};
constexpr Vec3 kShed{0.62F, 0.4F, 0.16F};
constexpr Vec3 kCut{0.82F, 0.16F, 0.12F};

constexpr std::size_t kMaxWays = 90;  // maximum number of arrows; more would not be distinguishable
constexpr double kWayShare = 0.06;    // length of an arrow, as a share of the plant's longest side

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

/// Returns the ways to more light past obstacles, at some nodes of plants without buds, spread over all plants.
std::vector<TracedWay> ways_past_obstacles(const OverlaySubject& subject, double length) {
  std::vector<TracedWay> ways;
  std::size_t nodes = 0;
  for (const Stem& stem : subject.plant.stems) nodes += has_buds(stem.skeleton) ? 0 : stem.skeleton.node_count();
  const std::size_t every = 1 + nodes / kMaxWays;
  std::size_t next = every / 2;  // index among all nodes of all these stems
  for (const Stem& stem : subject.plant.stems) {
    if (has_buds(stem.skeleton)) continue;
    const std::size_t count = stem.skeleton.node_count();
    for (; next < count; next += every) {
      subject.progress.check();
      const Vec3 from = stem.skeleton.position[next];
      const DVec3 way = brighter_way(subject.scene, from, 1);
      const double size = std::sqrt(glm::dot(way, way));
      if (size > 1e-12) ways.push_back({from, from + Vec3(way * (length / size))});
    }
    next -= count;
  }
  return ways;
}

/// Adds some of the ways of buds, scaled to the length of arrows.
void add_bud_ways(const std::vector<TracedWay>& ways, double length, Vec3 colour, OverlayLayer& layer) {
  const std::size_t every = 1 + ways.size() / kMaxWays;
  for (std::size_t k = 0; k < ways.size(); k += every) {
    const Vec3 from = ways[k].from;
    layer.arrows.push_back({from, from + static_cast<float>(length) * (ways[k].to - from), colour});
  }
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
  for (const TracedWay& way : ways_past_obstacles(subject, length)) layer.arrows.push_back({way.from, way.to, kWay});
  add_bud_ways(subject.marks.ways, length, kWay, layer);
  const std::size_t to_light = layer.arrows.size();
  add_bud_ways(subject.marks.room_ways, length, kRoomWay, layer);
  if (to_light > 0) layer.legend.push_back({kWay, "ways to more light"});
  if (layer.arrows.size() > to_light) layer.legend.push_back({kRoomWay, "ways to more room"});
}

void show_markers(const OverlaySubject& subject, OverlayLayer& layer) {
  show_places(subject.marks.markers, {kRoom, kUsed, kRemoved}, {"free", "taken", "removed"}, "marker", layer);
}

void show_losses(const OverlaySubject& subject, OverlayLayer& layer) {
  std::map<std::pair<LossCause, std::string>, std::size_t> counts;
  const auto colour_of = [](LossCause cause) { return cause == LossCause::shed ? kShed : kCut; };
  for (const TracedLoss& loss : subject.marks.losses) {
    ++counts[{loss.why.cause, loss.why.path}];
    for (const TracedWay& segment : loss.segments) {
      layer.lines.push_back({segment.from, segment.to, colour_of(loss.why.cause)});
    }
  }
  for (const auto& [why, count] : counts) {
    const std::string what = fmt::format("{} {}", count, count == 1 ? "branch" : "branches");
    const bool is_shed = why.first == LossCause::shed;
    layer.legend.push_back(
        {colour_of(why.first), is_shed ? what + " shed" : fmt::format("{} cut by {}", what, why.second)});
  }
}

}  // namespace meristem

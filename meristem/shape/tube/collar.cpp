// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/tube/collar.h"

namespace meristem {
namespace {

constexpr float kLeastSine = 0.2F;  // of the angle between branch and bark: 11.5 degrees
constexpr float kGap = 0.3F;        // radii between the first free ring and the next
constexpr float kThickest = 0.95F;  // of the parent's radius
constexpr float kLeastFillet = 0.2F;
constexpr int kBisections = 10;
constexpr int kTraceSteps = 32;

/// A position on a path: at a share of the way from a point to the next.
struct Stop {
  std::size_t point = 0;
  float share = 0;
};

float gap_after(const AxisPath& path, std::size_t point) {
  return glm::distance(path.position(point), path.position(point + 1));
}

Vec3 place_at(const AxisPath& path, Stop stop) {
  return glm::mix(path.position(stop.point), path.position(stop.point + 1), stop.share);
}

/// Metres from a position to the path's end.
float way_left(const AxisPath& path, Stop from) {
  float way = (1 - from.share) * gap_after(path, from.point);
  for (std::size_t i = from.point + 1; i + 1 < path.size(); ++i) way += gap_after(path, i);
  return way;
}

/// The position so many metres on; the path goes at least that far.
Stop walk(const AxisPath& path, Stop from, float metres) {
  metres += from.share * gap_after(path, from.point);
  while (from.point + 2 < path.size() && metres > gap_after(path, from.point)) {
    metres -= gap_after(path, from.point);
    ++from.point;
  }
  from.share = std::min(1.0F, metres / std::max(gap_after(path, from.point), kThinnestTube));
  return from;
}

}  // namespace

Bark::Bark(const AxisPath& parent, std::size_t point, float reach) : radius_(parent.radius(point)) {
  const auto add = [&](std::size_t from) {
    Cone& cone = cones_[count_++];
    cone.base = parent.position(from);
    cone.axis = parent.position(from + 1) - cone.base;
    const float length2 = glm::dot(cone.axis, cone.axis);
    cone.inverse_length2 = length2 > 0 ? 1 / length2 : 0;
    cone.base_radius = parent.radius(from);
    cone.widening = parent.radius(from + 1) - cone.base_radius;
  };
  // Half of the cones before the point, half after it.
  float way = 0;
  for (std::size_t i = point; i > 0 && way < reach && count_ < kMostCones / 2; --i) {
    add(i - 1);
    way += glm::distance(parent.position(i - 1), parent.position(i));
  }
  way = 0;
  for (std::size_t i = point; i + 1 < parent.size() && way < reach && count_ < kMostCones; ++i) {
    add(i);
    way += glm::distance(parent.position(i), parent.position(i + 1));
  }
}

Bark::Nearest Bark::nearest(Vec3 position) const {
  Nearest best{1e30F, kUp};
  for (std::size_t k = 0; k < count_; ++k) {
    const Cone& cone = cones_[k];
    const Vec3 offset = position - cone.base;
    const float share = glm::clamp(glm::dot(offset, cone.axis) * cone.inverse_length2, 0.0F, 1.0F);
    const Vec3 outward = offset - share * cone.axis;
    const float distance = std::sqrt(glm::dot(outward, outward)) - (cone.base_radius + share * cone.widening);
    if (distance < best.distance) best = {distance, outward};
  }
  return best;
}

float Bark::distance(Vec3 position) const { return nearest(position).distance; }

Vec3 Bark::normal(Vec3 position) const { return unit_or(nearest(position).outward, Vec3(0, 1, 0)); }

float Bark::trace(Vec3 from, Vec3 direction, float farthest) const {
  float way = 0;
  float nearest_way = 0;
  float least = distance(from);
  for (int step = 0; step < kTraceSteps && way < farthest && least > 1e-4F * farthest; ++step) {
    const float gap = distance(from + way * direction);
    if (gap < least) {
      least = gap;
      nearest_way = way;
    }
    way += std::max(gap, 1e-3F * farthest);
  }
  return nearest_way;
}

std::optional<Collar> plan_collar(const AxisPath& path, const Bark& bark, float size) {
  // Find where the branch's middle leaves the bark.
  std::size_t point = 0;
  while (point + 1 < path.size() && bark.distance(path.position(point + 1)) < 0) ++point;
  if (point + 1 >= path.size()) return std::nullopt;
  float low = 0;
  float high = 1;
  for (int k = 0; k < kBisections; ++k) {
    const float middle = 0.5F * (low + high);
    (bark.distance(place_at(path, {point, middle})) < 0 ? low : high) = middle;
  }
  const Stop exit{point, high};
  const Vec3 direction = path.direction(point, kUp);
  const float sine = std::abs(glm::dot(direction, bark.normal(place_at(path, exit))));
  if (sine < kLeastSine) return std::nullopt;
  // Its side toward the crotch leaves later; there it is free, and a fillet's height on.
  const float radius = path.radius(point + 1);
  if (radius > kThickest * bark.radius()) return std::nullopt;
  const float crotch = radius * std::sqrt(std::max(0.0F, 1 - sine * sine)) / sine;
  const float fillet = std::min(size * radius, way_left(path, exit) - crotch - kGap * radius);
  if (fillet < kLeastFillet * size * radius) return std::nullopt;
  const Stop free = walk(path, exit, crotch + fillet);
  Collar collar;
  collar.fillet = fillet;
  collar.centre = place_at(path, free);
  collar.radius = glm::mix(path.radius(free.point), path.radius(free.point + 1), free.share);
  // The next ring stands far enough from this one.
  collar.next_point = free.point + 1;
  while (collar.next_point + 1 < path.size() &&
         glm::distance(collar.centre, path.position(collar.next_point)) < kGap * radius) {
    ++collar.next_point;
  }
  collar.direction = unit_or(path.position(collar.next_point) - collar.centre, direction);
  return collar;
}

}  // namespace meristem

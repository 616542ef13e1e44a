// SPDX-License-Identifier: Apache-2.0
// Plans the collar of a branch. The parent's bark is a row of cones around the branch's node, and the branch is
// followed outward until a full ring lies outside the bark. The fillet fills the corner between both.
#include "meristem/shape/tube/collar.h"

namespace meristem {
namespace {

constexpr float kMinSine = 0.2F;    // of the angle between branch and bark: 11.5 degrees
constexpr float kGap = 0.3F;        // radii between the first free ring and the next
constexpr float kThickest = 0.95F;  // share of the parent's radius
constexpr float kMinFillet = 0.2F;
constexpr int kBisections = 10;
constexpr int kTraceSteps = 32;

/// A position on a path: at a share of the distance from a point to the next.
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

/// Returns the distance from a position to the path's end, metres.
float way_left(const AxisPath& path, Stop from) {
  float way = (1 - from.share) * gap_after(path, from.point);
  for (std::size_t i = from.point + 1; i + 1 < path.size(); ++i) way += gap_after(path, i);
  return way;
}

/// Returns the position a number of metres further along the path, which must be at least that long.
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
  base_radius_.fill(-kNever);
  const auto add_from = [&](std::size_t from) {
    add(parent.position(from), parent.position(from + 1), parent.radius(from), parent.radius(from + 1));
  };
  // Use half of the cones before the point, half after it.
  float way = 0;
  for (std::size_t i = point; i > 0 && way < reach && count_ < kMaxCones / 2; --i) {
    add_from(i - 1);
    way += glm::distance(parent.position(i - 1), parent.position(i));
  }
  way = 0;
  for (std::size_t i = point; i + 1 < parent.size() && way < reach && count_ < kMaxCones; ++i) {
    add_from(i);
    way += glm::distance(parent.position(i), parent.position(i + 1));
  }
}

void Bark::add(Vec3 base, Vec3 end, float base_radius, float end_radius) {
  const Vec3 axis = end - base;
  const float length2 = glm::dot(axis, axis);
  for (int k = 0; k < 3; ++k) {
    base_[k][count_] = base[k];
    axis_[k][count_] = axis[k];
  }
  inverse_length2_[count_] = length2 > 0 ? 1 / length2 : 0;
  base_radius_[count_] = base_radius;
  widening_[count_] = end_radius - base_radius;
  ++count_;
}

Bark::Column Bark::shares(Vec3 position) const {
  Column shares;
  for (std::size_t k = 0; k < kMaxCones; ++k) shares[k] = glm::dot(offset(position, k), axis(k)) * inverse_length2_[k];
  for (float& share : shares) share = std::max(share, 0.0F);
  for (float& share : shares) share = std::min(share, 1.0F);
  return shares;
}

Bark::Column Bark::distances(Vec3 position, const Column& shares) const {
  Column distances;
  for (std::size_t k = 0; k < kMaxCones; ++k) {
    const Vec3 outward = offset(position, k) - shares[k] * axis(k);
    distances[k] = std::sqrt(glm::dot(outward, outward)) - (base_radius_[k] + shares[k] * widening_[k]);
  }
  return distances;
}

float Bark::distance(Vec3 position) const {
  Column min = distances(position, shares(position));
  // Compare one half with the other, as processors do.
  for (std::size_t k = 0; k < kMaxCones / 2; ++k) min[k] = std::min(min[k], min[k + kMaxCones / 2]);
  for (std::size_t k = 0; k < kMaxCones / 4; ++k) min[k] = std::min(min[k], min[k + kMaxCones / 4]);
  return std::min(std::min(min[0], min[1]), std::min(min[2], kNever));
}

Bark::Nearest Bark::nearest(Vec3 position) const {
  const Column along = shares(position);
  const Column all = distances(position, along);
  const auto* const min = std::min_element(all.begin(), all.end());
  if (!(*min < kNever)) return {kNever, kUp};
  const auto k = static_cast<std::size_t>(min - all.begin());
  return {*min, offset(position, k) - along[k] * axis(k)};
}

float Bark::trace(Vec3 from, Vec3 direction, float farthest) const {
  float way = 0;
  float nearest_way = 0;
  float gap = distance(from);
  float min = gap;
  for (int step = 1; step < kTraceSteps && min > 1e-4F * farthest; ++step) {
    way += std::max(gap, 1e-3F * farthest);
    if (!(way < farthest)) break;
    gap = distance(from + way * direction);
    if (gap < min) {
      min = gap;
      nearest_way = way;
    }
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
  const float sine = std::abs(glm::dot(direction, bark.nearest(place_at(path, exit)).normal()));
  if (sine < kMinSine) return std::nullopt;
  // Its side toward the crotch leaves later. The ring is placed there, plus the height of the fillet.
  const float radius = path.radius(point + 1);
  if (radius > kThickest * bark.radius()) return std::nullopt;
  const float crotch = radius * std::sqrt(std::max(0.0F, 1 - sine * sine)) / sine;
  const float fillet = std::min(size * radius, way_left(path, exit) - crotch - kGap * radius);
  if (fillet < kMinFillet * size * radius) return std::nullopt;
  const Stop free = walk(path, exit, crotch + fillet);
  Collar collar;
  collar.fillet = fillet;
  collar.centre = place_at(path, free);
  collar.radius = glm::mix(path.radius(free.point), path.radius(free.point + 1), free.share);
  // Find the next ring at a sufficient distance from this one.
  collar.next_point = free.point + 1;
  while (collar.next_point + 1 < path.size() &&
         glm::distance(collar.centre, path.position(collar.next_point)) < kGap * radius) {
    ++collar.next_point;
  }
  collar.direction = unit_or(path.position(collar.next_point) - collar.centre, direction);
  return collar;
}

}  // namespace meristem

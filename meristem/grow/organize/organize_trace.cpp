// SPDX-License-Identifier: Apache-2.0
// Returns recorded steps, and reconstructs the markers of a step from the positions of its shoots.
#include "meristem/grow/organize/organize_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "meristem/base/point_tree.h"
#include "meristem/grow/colonize/node_forest.h"
#include "meristem/plant/split_trees.h"

namespace meristem {

namespace {

constexpr auto kByPosition = [](const TracedPlace& place) {
  return std::tuple(place.position.x, place.position.y, place.position.z);
};

std::vector<NumberedPoint> numbered(const std::vector<Vec3>& positions) {
  std::vector<NumberedPoint> points;
  points.reserve(positions.size());
  for (const Vec3 position : positions) points.push_back({position, static_cast<std::uint32_t>(points.size())});
  return points;
}

constexpr double kFewestVoxels = 4;  // along a block's side
constexpr NodeIndex kNodesPerCheck = 1024;

/// Returns the box of a block: a cube of side `side`, numbered along x, y and z. Markers are searched block by block
/// around shoots.
using Block = std::array<std::int32_t, 3>;

Box box_of(const Block& block, double side) {
  const auto corner = [&](std::int32_t more) {
    return Vec3(DVec3(block[0] + more, block[1] + more, block[2] + more) * side);
  };
  return {corner(0), corner(1)};
}

/// Returns the sorted blocks within `reach` metres of one of the positions. `side` must be at least 2 `reach`.
std::vector<Block> blocks_about(const std::vector<Vec3>& positions, double reach, double side,
                                const Progress& progress) {
  std::vector<Block> blocks;
  const auto number = [&](float at, double by) {
    return static_cast<std::int32_t>(std::floor((static_cast<double>(at) + by) / side));
  };
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (k % kNodesPerCheck == 0) progress.check();
    const Vec3 at = positions[k];
    for (std::int32_t z = number(at.z, -reach); z <= number(at.z, reach); ++z) {
      for (std::int32_t y = number(at.y, -reach); y <= number(at.y, reach); ++y) {
        for (std::int32_t x = number(at.x, -reach); x <= number(at.x, reach); ++x) blocks.push_back({x, y, z});
      }
    }
  }
  std::ranges::sort(blocks);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

bool in_order(const DVec3& a, const DVec3& b) { return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z); }

}  // namespace

void OrganizeTrace::lose(std::vector<TracedLoss> losses) {
  losses_ = std::move(losses);
  std::ranges::stable_sort(losses_, {}, &TracedLoss::step);
}

Skeleton OrganizeTrace::standing_after(int step, const Scene&, Progress&) const {
  return steps_[static_cast<std::size_t>(step)].skeleton;
}

StepMarks OrganizeTrace::marks_of(int step, TraceRequest request, const Progress& progress) const {
  const Step& now = steps_[static_cast<std::size_t>(step)];
  StepMarks marks;
  if (request.has(TracePart::ways)) (seeks_room_ ? marks.room_ways : marks.ways) = now.ways;
  if (request.has(TracePart::losses)) {
    marks.losses.assign(std::ranges::lower_bound(losses_, step, {}, &TracedLoss::step),
                        std::ranges::upper_bound(losses_, step, {}, &TracedLoss::step));
  }
  if (request.has(TracePart::markers)) marks.markers = markers(now.skeleton, progress);
  return marks;
}

/// Returns the markers that buds could see and the markers that shoots have occupied.
std::vector<TracedPlace> OrganizeTrace::markers(const Skeleton& skeleton, const Progress& progress) const {
  std::vector<TracedPlace> found;
  if (!room_ || skeleton.node_count() == 0) return found;
  const std::vector<Skeleton> trees = split_trees(skeleton);
  const std::size_t count = std::min(trees.size(), room_->volumes.size());
  const double spacing = room_->vacant.form().spacing;
  const double side = std::max(2 * room_->perception, kFewestVoxels * spacing);
  std::vector<std::vector<Block>> blocks(count);
  double markers = 0;
  for (std::size_t k = 0; k < count; ++k) {
    blocks[k] = blocks_about(trees[k].position, room_->perception, side, progress);
    markers += static_cast<double>(blocks[k].size()) * std::pow(side / spacing, 3);
  }
  if (markers > static_cast<double>(room_->max_markers)) {
    throw_limit("markers of room to be shown", markers, room_->max_markers, "points", room_->path);
  }

  // Occupy the markers of all shoots in a copy of the vacant field.
  MarkerField taken = room_->vacant;
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (node % kNodesPerCheck == 0) progress.check();
    if (!skeleton.is_root(node)) taken.occupy(skeleton.position[node]);
  }
  const double reach2 = room_->perception * room_->perception;
  for (std::size_t k = 0; k < count; ++k) {
    const NodeTree shoots(numbered(trees[k].position), progress);
    for (const Block& block : blocks[k]) {
      progress.check();
      const Box box = box_of(block, side);
      std::vector<DVec3> free = taken.free_markers(box, room_->volumes[k]);
      std::ranges::sort(free, in_order);
      for (const DVec3& marker : room_->vacant.free_markers(box, room_->volumes[k])) {
        NearestFew nearest;
        shoots.search(Vec3(marker), nearest);
        if (static_cast<double>(nearest.distance2(0)) > reach2) continue;
        const bool is_free = std::ranges::binary_search(free, marker, in_order);
        found.push_back({Vec3(marker), is_free ? PlaceState::free : PlaceState::used, 0});
      }
    }
  }
  // Remove duplicates: trees may share a crown, and blocks share the markers on their common faces.
  std::ranges::stable_sort(found, {}, kByPosition);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::uint64_t OrganizeTrace::bytes() const {
  std::uint64_t sum = steps_.capacity() * sizeof(Step) + losses_.capacity() * sizeof(TracedLoss);
  if (outcome_) sum += outcome_->bytes();
  for (const Step& step : steps_) sum += step.skeleton.bytes() + step.ways.capacity() * sizeof(TracedWay);
  for (const TracedLoss& loss : losses_) sum += loss.segments.capacity() * sizeof(TracedWay) + loss.why.path.capacity();
  return sum;
}

}  // namespace meristem

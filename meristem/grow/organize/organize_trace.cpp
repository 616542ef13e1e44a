// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/organize/organize_trace.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

}  // namespace

void OrganizeTrace::lose(std::vector<TracedLoss> losses) {
  losses_.insert(losses_.end(), std::make_move_iterator(losses.begin()), std::make_move_iterator(losses.end()));
  std::ranges::stable_sort(losses_, {}, &TracedLoss::step);
}

void OrganizeTrace::show_room(std::shared_ptr<const MarkerField> vacant, double perception) {
  if (vacant != nullptr) rooms_.push_back(std::move(vacant));
  perception_ = perception;
}

Skeleton OrganizeTrace::standing(int step, const Scene&, Progress&) const {
  return steps_[static_cast<std::size_t>(std::clamp(step, 0, last_step()))].skeleton;
}

StepMarks OrganizeTrace::marks(int step, const TraceWish& wish) const {
  step = std::clamp(step, 0, last_step());
  const Step& now = steps_[static_cast<std::size_t>(step)];
  StepMarks marks;
  if (wish.ways) marks.ways = now.ways;
  if (wish.losses) {
    marks.losses.assign(std::ranges::lower_bound(losses_, step, {}, &TracedLoss::step),
                        std::ranges::upper_bound(losses_, step, {}, &TracedLoss::step));
  }
  if (wish.markers) marks.markers = markers(now.skeleton);
  return marks;
}

/// The markers that buds could see, and those that shoots have taken.
std::vector<TracedPlace> OrganizeTrace::markers(const Skeleton& skeleton) const {
  std::vector<TracedPlace> found;
  if (rooms_.empty() || skeleton.node_count() == 0) return found;
  const std::vector<Skeleton> trees = split_trees(skeleton);
  for (std::size_t k = 0; k < std::min(trees.size(), rooms_.size()); ++k) {
    MarkerField field = *rooms_[k];
    Box box;
    for (const Vec3 position : trees[k].position) {
      box.add(position - Vec3(static_cast<float>(perception_)));
      box.add(position + Vec3(static_cast<float>(perception_)));
    }
    // What all trees have taken is what their shoots leave of the vacant room.
    std::vector<DVec3> all = field.free_markers(box, 0);
    for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
      if (!skeleton.is_root(node)) field.occupy(skeleton.position[node]);
    }
    std::vector<DVec3> free = field.free_markers(box, 0);
    const auto order = [](const DVec3& a, const DVec3& b) {
      return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
    };
    std::ranges::sort(all, order);
    std::ranges::sort(free, order);
    const NodeTree shoots(numbered(trees[k].position), Progress());
    for (const DVec3& marker : all) {
      NearestFew nearest;
      shoots.search(Vec3(marker), nearest);
      if (static_cast<double>(nearest.distance2(0)) > perception_ * perception_) continue;
      const bool is_free = std::ranges::binary_search(free, marker, order);
      found.push_back({Vec3(marker), is_free ? PlaceState::free : PlaceState::used, 0});
    }
  }
  // Trees that share a crown share its markers.
  std::ranges::stable_sort(found, {}, kByPosition);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::uint64_t OrganizeTrace::bytes() const {
  std::uint64_t sum = steps_.capacity() * sizeof(Step) + losses_.capacity() * sizeof(TracedLoss);
  if (outcome_) sum += outcome_->bytes();
  for (const Step& step : steps_) sum += step.skeleton.bytes() + step.ways.capacity() * sizeof(TracedWay);
  for (const TracedLoss& loss : losses_) sum += loss.segments.capacity() * sizeof(TracedWay) + loss.why.capacity();
  return sum;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/colonize/cloud_record.h"

#include <algorithm>
#include <tuple>

namespace meristem {

namespace {

constexpr std::size_t kHistoriesPerCheck = 4096;

/// Sort key of positions, to find equal ones.
std::tuple<float, float, float> ordered(Vec3 position) { return {position.x, position.y, position.z}; }

}  // namespace

std::vector<TracedPlace> PointHistory::at(int step, Vec3 origin) const {
  std::vector<TracedPlace> places;
  places.reserve(points.size());
  for (const Point& point : points) {
    const bool is_used = point.used_in <= step;
    Vec3 position = point.position;
    if (step > 0 && !point.path.empty()) {
      const auto last = static_cast<std::size_t>(is_used ? point.used_in : step);
      position = point.path[std::min(last, point.path.size()) - 1];
    }
    const PlaceState state = point.is_removed ? PlaceState::removed : (is_used ? PlaceState::used : PlaceState::free);
    places.push_back({origin + position, state, is_used ? point.used_in : 0});
  }
  return places;
}

std::uint64_t PointHistory::bytes() const {
  std::uint64_t sum = points.capacity() * sizeof(Point);
  for (const Point& point : points) sum += point.path.capacity() * sizeof(Vec3);
  return sum;
}

std::uint64_t CloudRecord::bytes() const {
  std::uint64_t sum = brought_.capacity() * sizeof(Brought) + used_.capacity() * sizeof(Used);
  for (const std::vector<Vec3>& positions : places_) sum += positions.capacity() * sizeof(Vec3);
  return sum;
}

std::vector<PointHistory> CloudRecord::histories(std::size_t trees, const Progress& progress) const {
  std::vector<PointHistory::Point> points;
  points.reserve(brought_.size());
  for (const Brought& one : brought_) points.push_back({.position = one.position, .is_removed = one.is_removed});

  if (places_.empty()) {
    // Points at rest are found by their positions.
    std::vector<Used> used = used_;
    std::ranges::stable_sort(used, {}, [](const Used& one) { return ordered(one.position); });
    std::size_t asked = 0;
    for (PointHistory::Point& point : points) {
      if (++asked % kHistoriesPerCheck == 0) progress.check();
      if (point.is_removed) continue;
      const auto found = std::ranges::lower_bound(used, ordered(point.position), {},
                                                  [](const Used& one) { return ordered(one.position); });
      if (found != used.end() && found->position == point.position) point.used_in = found->step;
    }
  } else {
    // Moving points keep their order, so each step lists the positions of the remaining points.
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!points[k].is_removed) left.push_back(k);
    }
    auto next = used_.begin();
    for (std::size_t step = 1; step <= places_.size(); ++step) {
      progress.check();
      const std::vector<Vec3>& places = places_[step - 1];
      std::vector<std::tuple<float, float, float>> gone;
      for (; next != used_.end() && next->step <= static_cast<int>(step); ++next)
        gone.push_back(ordered(next->position));
      std::ranges::sort(gone);
      std::size_t kept = 0;
      for (std::size_t k = 0; k < left.size(); ++k) {
        if (k % kHistoriesPerCheck == 0) progress.check();
        PointHistory::Point& point = points[left[k]];
        point.path.push_back(places[k]);
        const bool is_gone = std::ranges::binary_search(gone, ordered(places[k]));
        if (is_gone) point.used_in = static_cast<int>(step);
        if (!is_gone) left[kept++] = left[k];
      }
      left.resize(kept);
    }
  }

  std::vector<PointHistory> histories(trees);
  for (std::size_t k = 0; k < points.size(); ++k) histories[brought_[k].tree].points.push_back(std::move(points[k]));
  return histories;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/growth_trace.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

namespace meristem {

namespace {

template <class T>
void append_all(std::vector<T>& list, std::vector<T> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

void StepMarks::append(StepMarks more) {
  append_all(points, std::move(more.points));
  append_all(pulls, std::move(more.pulls));
  append_all(ways, std::move(more.ways));
  append_all(room_ways, std::move(more.room_ways));
  append_all(markers, std::move(more.markers));
  append_all(losses, std::move(more.losses));
}

void StepMarks::move(const Frame& frame) {
  for (std::vector<TracedPlace>* places : {&points, &markers}) {
    for (TracedPlace& place : *places) place.position = frame.point(place.position);
  }
  for (TracedWay& pull : pulls) pull = {frame.point(pull.from), frame.point(pull.to)};
  for (std::vector<TracedWay>* metres : {&ways, &room_ways}) {
    for (TracedWay& way : *metres) {
      const Vec3 from = frame.point(way.from);
      way = {from, from + glm::normalize(frame.axes * (way.to - way.from))};
    }
  }
  for (TracedLoss& loss : losses) {
    loss.position = frame.point(loss.position);
    loss.length = 0;
    for (TracedWay& segment : loss.segments) {
      segment = {frame.point(segment.from), frame.point(segment.to)};
      loss.length += glm::distance(segment.from, segment.to);
    }
  }
}

std::size_t StepMarks::count() const {
  std::size_t count = points.size() + pulls.size() + ways.size() + room_ways.size() + markers.size();
  for (const TracedLoss& loss : losses) count += loss.segments.size();
  return count;
}

Skeleton GrowthTrace::standing(int step, const Scene& scene, Progress& progress) const {
  return standing_after(std::clamp(step, 0, last_step()), scene, progress);
}

StepMarks GrowthTrace::marks(int step, TraceRequest request, const Progress& progress) const {
  return marks_of(std::clamp(step, 0, last_step()), request, progress);
}

}  // namespace meristem

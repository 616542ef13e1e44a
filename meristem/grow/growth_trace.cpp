// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/growth_trace.h"

#include <algorithm>
#include <iterator>
#include <utility>

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

Skeleton GrowthTrace::standing(int step, const Scene& scene, Progress& progress) const {
  return standing_after(std::clamp(step, 0, last_step()), scene, progress);
}

StepMarks GrowthTrace::marks(int step, TraceWish wish, const Progress& progress) const {
  return marks_of(std::clamp(step, 0, last_step()), wish, progress);
}

}  // namespace meristem

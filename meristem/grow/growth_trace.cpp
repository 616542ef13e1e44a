// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/growth_trace.h"

#include <iterator>
#include <utility>

namespace meristem {

namespace {

template <class T>
void append_all(std::vector<T>& list, std::vector<T> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::uint64_t TraceWish::bits() const {
  std::uint64_t bits = 0;
  for (const bool part : {steps, points, pulls, ways, losses, markers, outcome}) bits = 2 * bits + (part ? 1 : 0);
  return bits;
}

TraceWish operator|(const TraceWish& a, const TraceWish& b) {
  return {a.steps || b.steps,   a.points || b.points,   a.pulls || b.pulls,    a.ways || b.ways,
          a.losses || b.losses, a.markers || b.markers, a.outcome || b.outcome};
}

void StepMarks::append(StepMarks more) {
  append_all(points, std::move(more.points));
  append_all(pulls, std::move(more.pulls));
  append_all(ways, std::move(more.ways));
  append_all(markers, std::move(more.markers));
  append_all(losses, std::move(more.losses));
}

}  // namespace meristem

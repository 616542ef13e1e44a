// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/growth_traces.h"

#include <algorithm>

namespace meristem {

int GrowthTraces::shown_step() const { return std::clamp(step.value_or(last_step), 0, last_step); }

StepMarks GrowthTraces::marks(int of_step, TraceWish wish, const Progress& progress) const {
  StepMarks marks;
  for (const TracedGrowth& growth : growths) marks.append(growth.trace->marks(of_step, wish, progress));
  return marks;
}

std::uint64_t GrowthTraces::bytes() const {
  std::uint64_t sum = 0;
  for (const TracedGrowth& growth : growths) sum += growth.trace->bytes();
  return sum;
}

}  // namespace meristem

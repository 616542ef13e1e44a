// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/shape/filled.h"

namespace meristem {

/// Vertices by cost, the least first, in steps of under 1 %: a list for each step, what was put last before what was
/// put earlier. Costs of what is put while taking count at least as the step reached; putting and taking take constant
/// time, where a heap of a quarter of a million vertices took as long as all the geometry.
class VertexQueue {
 public:
  /// For vertices below `vertices`. Throws Cancelled.
  VertexQueue(std::size_t vertices, const Progress& progress)
      : first_(kSteps, kNone), next_(filled(vertices, kNone, progress)) {}

  /// Costs (0 or above) of one step count as equal.
  static std::uint32_t step(float cost) { return std::bit_cast<std::uint32_t>(cost) >> 16; }
  /// The step of the vertex taken last.
  std::uint32_t current_step() const { return step_; }

  /// Puts a vertex that is not in the queue.
  void put(std::uint32_t vertex, std::uint32_t step) {
    step = step < step_ ? step_ : step;
    next_[vertex] = first_[step];
    first_[step] = vertex;
  }

  /// Takes a vertex of the lowest step; kNone if there is none.
  std::uint32_t take() {
    while (step_ < kSteps && first_[step_] == kNone) ++step_;
    if (step_ == kSteps) return kNone;
    const std::uint32_t vertex = first_[step_];
    first_[step_] = next_[vertex];
    return vertex;
  }

  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

 private:
  // A positive float's bits rise with it: 8 of exponent, 7 of mantissa.
  static constexpr std::uint32_t kSteps = 1 << 15;

  std::uint32_t step_ = 0;
  std::vector<std::uint32_t> first_;  // of each step
  std::vector<std::uint32_t> next_;   // of each vertex
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/shape/mesh/filled.h"

namespace meristem {

/// A queue of vertices by cost, the cheapest first, in steps of 3 %. Each step has a list, from which the last inserted
/// vertex is taken first. Vertices inserted while taking count at least as the current step. Inserting and taking need
/// constant time. A heap of a quarter of a million vertices took as long as all the geometry.
class VertexQueue {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  /// Creates a queue for vertices below `vertices`. Throws Cancelled.
  VertexQueue(std::size_t vertices, const Progress& progress)
      : first_(kSteps, kNone), next_(filled(vertices, kNone, progress)) {}

  /// Returns the step of a cost (0 or above). Costs of one step count as equal.
  static std::uint32_t step(float cost) { return std::bit_cast<std::uint32_t>(cost) >> 18; }
  /// Returns the step of the vertex taken last.
  std::uint32_t current_step() const { return step_; }

  /// Empties the queue. From now on, vertices that cost more than `limit` are not inserted.
  void restart(float limit) {
    std::fill(first_.begin(), first_.end(), kNone);
    step_ = 0;
    end_ = step(limit) + 1;
  }

  /// Inserts a vertex that is not in the queue.
  void put(std::uint32_t vertex, std::uint32_t step) {
    step = std::max(step, step_);
    if (step >= end_) return;
    next_[vertex] = first_[step];
    first_[step] = vertex;
  }

  /// Takes a vertex of the lowest step, or returns kNone if the queue is empty.
  std::uint32_t take() {
    while (step_ < end_ && first_[step_] == kNone) ++step_;
    if (step_ == end_) return kNone;
    const std::uint32_t vertex = first_[step_];
    first_[step_] = next_[vertex];
    return vertex;
  }

 private:
  // A positive float's bits rise with its value: 8 bits of exponent, 5 of mantissa.
  static constexpr std::uint32_t kSteps = 1 << 13;

  std::uint32_t step_ = 0;
  std::uint32_t end_ = kSteps;
  std::vector<std::uint32_t> first_;  // for each step
  std::vector<std::uint32_t> next_;   // for each vertex
};

}  // namespace meristem

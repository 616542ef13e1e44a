// SPDX-License-Identifier: Apache-2.0
// Stops readers of files and the checks of their contents. Many layers lie between the reading of a document and the
// loops over the bytes of its files: tables of parameters, stores of earlier reads, functions of components. So the
// loops find their Progress by the thread on which they run.
#pragma once

#include <cstddef>
#include <cstdint>

#include "meristem/base/progress.h"

namespace meristem {

/// During its lifetime, readers on this thread throw Cancelled soon after `progress` was asked to stop. Null: a stop
/// that was set before stays in force.
class ReadingStop {
 public:
  /// Begins to stop readers. The progress must outlive the object.
  explicit ReadingStop(const Progress* progress);
  ~ReadingStop();
  ReadingStop(const ReadingStop&) = delete;
  ReadingStop& operator=(const ReadingStop&) = delete;

  /// Throws Cancelled if the readers of this thread were asked to stop.
  static void check();
  /// Returns the progress that stops the readers of this thread, or null.
  static const Progress* progress();
  /// Returns the number of calls of check() on this thread so far, for tests.
  static std::uint64_t check_count();

 private:
  const Progress* before_;
};

/// Calls ReadingStop::check() after some steps of a loop. A step is one line, row, number or triangle.
class StopCounter {
 public:
  /// Counts a step. Throws Cancelled if the readers of this thread were asked to stop.
  void step() {
    if (++steps_ % kStepsBetweenChecks == 0) ReadingStop::check();
  }

 private:
  static constexpr std::uint32_t kStepsBetweenChecks = 256;
  std::uint32_t steps_ = 0;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Stops a job that takes too long or too much memory.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "host.h"
#include "meristem/base/progress.h"
#include "refusal.h"

namespace meristem::studio {

/// The time that a job may take, and the name of this limit.
struct TimeLimit {
  double seconds = 0;
  const char* name = "";
};

/// Watches one job during its lifetime, and cancels its progress when the job reaches a limit.
class JobWatch {
 public:
  /// Without `time`, the job may take `job_seconds`.
  JobWatch(Progress& progress, const StudioLimits& limits, std::optional<TimeLimit> time = {});
  ~JobWatch();
  JobWatch(const JobWatch&) = delete;
  JobWatch& operator=(const JobWatch&) = delete;

  /// Returns the limit for which the job was cancelled. Returns nothing if the job was not cancelled, or for another
  /// reason.
  std::optional<Refusal> reached() const;
  /// Returns true if the job reached its time limit. With this time again, the job may finish.
  bool has_reached_time() const { return reached_.load() == Limit::time; }

 private:
  enum class Limit { none, time, memory };
  void run();

  Progress& progress_;
  const StudioLimits limits_;
  const TimeLimit time_;
  std::atomic<Limit> reached_{Limit::none};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ends_ = false;
  std::thread thread_;
};

/// Returns the memory that the program uses now, bytes. Returns 0 if unknown.
std::uint64_t memory_in_use();
/// Returns the memory of the machine, bytes. Returns 0 if unknown.
std::uint64_t memory_of_machine();

}  // namespace meristem::studio

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

/// How long a job may take, and the limit that says so.
struct TimeLimit {
  double seconds = 0;
  const char* name = "";
};

/// Watches one job while it lives, and cancels its progress where a limit is reached.
class JobWatch {
 public:
  /// Without a time limit of its own a job may take `job_seconds`.
  JobWatch(Progress& progress, const StudioLimits& limits, std::optional<TimeLimit> time = {});
  ~JobWatch();
  JobWatch(const JobWatch&) = delete;
  JobWatch& operator=(const JobWatch&) = delete;

  /// The limit for which the job was cancelled; nullopt if it was not, or by others.
  std::optional<Refusal> reached() const;
  /// Returns true if the job was cancelled for its time, so that another such time may finish it.
  bool has_reached_time() const { return reached_.load() == Limit::time; }

 private:
  enum class Limit { none, time, memory };
  void run();

  Progress& progress_;
  const StudioLimits limits_;
  const TimeLimit time_;
  std::atomic<Limit> reached_{Limit::none};
  std::mutex mutex_;
  std::condition_variable news_;
  bool ends_ = false;
  std::thread thread_;
};

/// Bytes of memory that the program has in use now; 0 where that is not known.
std::uint64_t memory_in_use();
/// The memory of the machine, bytes; 0 where it is not known.
std::uint64_t memory_of_machine();

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// The requests of a page that jobs answer later, and their cancellation.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem::studio {

/// A request, from its arrival until its answer.
struct AskedJob {
  double request = 0;           ///< number of the request
  Progress* running = nullptr;  ///< progress of the job while a worker runs it; else null
  bool is_over = false;         ///< true: answered, or cancelled before a worker began
};

/// The jobs of one kind. May be called from any thread.
class AskedJobs {
 public:
  using Job = std::shared_ptr<AskedJob>;

  Job ask(double request);
  /// Returns true if a worker may begin the job, and must call end() later. Returns false if the job was cancelled
  /// while it waited.
  bool begin(const Job& job, Progress& progress);
  void end(const Job& job);
  /// Cancels the job of a request, or all jobs. Running jobs stop at their next check of the progress, and their
  /// workers answer them. Returns the requests of waiting jobs, which the caller must answer.
  std::vector<double> cancel(std::optional<double> request = {});
  /// Cancels all jobs and lets no job begin later. No answers are needed.
  void close();

 private:
  std::mutex mutex_;
  std::multimap<double, Job> jobs_;  // by request; a page may use a number twice
  bool is_closed_ = false;
};

}  // namespace meristem::studio

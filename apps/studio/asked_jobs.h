// SPDX-License-Identifier: Apache-2.0
// The requests of a page that jobs will answer, and how they are called off.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "meristem/base/progress.h"

namespace meristem::studio {

/// A request from when it is asked until it is answered.
struct AskedJob {
  double request = 0;           ///< its number
  Progress* running = nullptr;  ///< while a worker has it in hand
  bool is_over = false;         ///< answered, or called off before a worker took it
};

/// The jobs of one kind. Calls from any thread.
class AskedJobs {
 public:
  using Job = std::shared_ptr<AskedJob>;

  Job ask(double request);
  /// Whether a worker may take the job, which it then ends; false where it was called off while it waited.
  bool begin(const Job& job, Progress& progress);
  void end(const Job& job);
  /// Calls the job of a request off, or all. Those in hand end as soon as they look at their progress, and are answered
  /// by their workers; gives the requests of those that waited, which nobody else answers.
  std::vector<double> cancel(std::optional<double> request = {});
  /// Calls all off and lets none begin any more; nobody waits for answers.
  void close();

 private:
  std::mutex mutex_;
  std::multimap<double, Job> jobs_;  // a page may say a number twice
  bool is_closed_ = false;
};

}  // namespace meristem::studio

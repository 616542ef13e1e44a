// SPDX-License-Identifier: Apache-2.0
// Messages to the page about the progress of a job.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host.h"
#include "meristem/base/progress.h"

namespace meristem::studio {

/// A progress that sends `working` at most ten times a second, and records the times of its stages.
class JobMessages {
 public:
  /// `request` is the number of the request that began the job, if there is one.
  JobMessages(std::shared_ptr<Outbox> outbox, std::string job, std::optional<double> request = {});
  /// Reports the end of the job if anything was reported before.
  ~JobMessages();
  JobMessages(const JobMessages&) = delete;
  JobMessages& operator=(const JobMessages&) = delete;

  Progress& progress() { return progress_; }
  /// Begins one of several parts, such as "frame", counted from 0. The reported share then refers to all parts.
  void begin_part(std::string what, std::size_t part, std::size_t parts);
  /// Returns the milliseconds of each stage up to now.
  std::vector<std::pair<std::string, double>> stages() const;

 private:
  using Clock = std::chrono::steady_clock;

  void look(std::string_view stage, double share);
  void send(std::optional<std::string_view> stage, double share);

  std::shared_ptr<Outbox> outbox_;
  std::string job_;
  std::optional<double> request_;
  std::string part_;       // text that is reported instead of stages: "frame 3 of 100"; empty: stages are reported
  double part_share_ = 0;  // share of all parts that is finished
  std::vector<std::pair<std::string, Clock::time_point>> begins_;
  Clock::time_point sent_ = Clock::now();
  bool has_sent_ = false;
  Progress progress_;
};

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// Tells the page how far a job has come.
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

/// A progress that sends `working`, at most ten times a second, and takes the times of its stages.
class JobNews {
 public:
  /// `request` is the number of the request that asked for it, if one did.
  JobNews(std::shared_ptr<Outbox> outbox, std::string job, std::optional<double> request = {});
  /// Says that it is over, if it has said anything.
  ~JobNews();
  JobNews(const JobNews&) = delete;
  JobNews& operator=(const JobNews&) = delete;

  Progress& progress() { return progress_; }
  /// What follows is the given one of several parts, such as "frame", from 0; of all of them the share is told.
  void begin_part(std::string what, std::size_t part, std::size_t parts);
  /// Milliseconds of each stage up to now.
  std::vector<std::pair<std::string, double>> stages() const;

 private:
  using Clock = std::chrono::steady_clock;

  void look(std::string_view stage, double share);
  void send(std::optional<std::string_view> stage, double share);

  std::shared_ptr<Outbox> outbox_;
  std::string job_;
  std::optional<double> request_;
  std::string part_;       // what is told in place of stages: "frame 3 of 100"; empty: stages are told
  double part_share_ = 0;  // of all parts, that is over
  std::vector<std::pair<std::string, Clock::time_point>> begins_;
  Clock::time_point sent_ = Clock::now();
  bool has_told_ = false;
  Progress progress_;
};

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// Watches a job on a thread of its own, which checks the time and the memory in use at short intervals.
#include "job_watch.h"

#include <chrono>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

namespace meristem::studio {

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{50};

}  // namespace

JobWatch::JobWatch(Progress& progress, const StudioLimits& limits, std::optional<TimeLimit> time)
    : progress_(progress),
      limits_(limits),
      time_(time.value_or(TimeLimit{.seconds = limits.job_seconds, .name = "job_seconds"})),
      thread_([this] { run(); }) {
  if (time_.seconds > 0) return;
  reached_ = Limit::time;
  progress_.cancel();
}

JobWatch::~JobWatch() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void JobWatch::run() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(time_.seconds);
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, kBetweenLooks, [this] { return ends_; })) {
    if (std::chrono::steady_clock::now() >= end) {
      reached_ = Limit::time;
    } else if (memory_in_use() > limits_.memory_bytes) {
      reached_ = Limit::memory;
    } else {
      continue;
    }
    progress_.cancel();
    return;
  }
}

std::optional<Refusal> JobWatch::reached() const {
  switch (reached_.load()) {
    case Limit::time:
      return limit_refusal(fmt::format("stopped after {} seconds ({})", time_.seconds, time_.name), time_.name);
    case Limit::memory:
      return limit_refusal(fmt::format("stopped, because the program used more than {:.1f} GB (memory_bytes)",
                                       static_cast<double>(limits_.memory_bytes) / 1e9),
                           "memory_bytes");
    case Limit::none:
      break;
  }
  return std::nullopt;
}

std::uint64_t memory_in_use() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0;
  std::uint64_t resident = 0;
  file >> all >> resident;
  return file ? resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

std::uint64_t memory_of_machine() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long bytes = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && bytes > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes) : 0;
}

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
// A thread that runs one job after another. A job can be postponed.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

namespace meristem::studio {

class Worker {
 public:
  using Clock = std::chrono::steady_clock;
  using Job = std::function<void()>;

  Worker() : thread_([this] { run(); }) {}
  ~Worker() { stop(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Posts a job. Jobs of one time run in the order of their posting. They must not throw. After stop(), posting does
  /// nothing.
  void post(Job job) { post_at(Clock::now(), std::move(job)); }
  void post_at(Clock::time_point time, Job job);
  /// Waits for the running job and forgets all others. Must not be called by a job.
  void stop();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::pair<Clock::time_point, std::uint64_t>, Job> jobs_;
  std::uint64_t count_ = 0;
  bool stops_ = false;
  std::thread thread_;  // last member, because the thread uses the others
};

}  // namespace meristem::studio

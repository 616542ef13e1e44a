// SPDX-License-Identifier: Apache-2.0
// A thread that does one job after another, some of them later.
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

  /// Jobs of one time are done in the order in which they came. They must not throw. Nothing happens once it stops.
  void post(Job job) { post_at(Clock::now(), std::move(job)); }
  void post_at(Clock::time_point time, Job job);
  /// Lets the job in hand end and forgets the others. Not called by a job.
  void stop();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable news_;
  std::map<std::pair<Clock::time_point, std::uint64_t>, Job> jobs_;
  std::uint64_t count_ = 0;
  bool stops_ = false;
  std::thread thread_;  // the last, as it uses the others
};

}  // namespace meristem::studio

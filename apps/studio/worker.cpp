// SPDX-License-Identifier: Apache-2.0
#include "worker.h"

namespace meristem::studio {

void Worker::post_at(Clock::time_point time, Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (stops_) return;
    jobs_.emplace(std::pair(time, count_++), std::move(job));
  }
  changed_.notify_one();
}

void Worker::stop() {
  {
    const std::lock_guard lock(mutex_);
    stops_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
  jobs_.clear();
}

void Worker::run() {
  std::unique_lock lock(mutex_);
  while (!stops_) {
    if (jobs_.empty()) {
      changed_.wait(lock);
      continue;
    }
    const Clock::time_point due = jobs_.begin()->first.first;
    if (due > Clock::now()) {
      changed_.wait_until(lock, due);
      continue;
    }
    Job job = std::move(jobs_.begin()->second);
    jobs_.erase(jobs_.begin());
    lock.unlock();
    job();
    job = nullptr;  // the job's data is destroyed before the next job is examined
    lock.lock();
  }
}

}  // namespace meristem::studio

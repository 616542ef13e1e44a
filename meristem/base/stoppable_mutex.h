// SPDX-License-Identifier: Apache-2.0
// A mutex whose waiting threads can be asked to stop.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "meristem/base/progress.h"

namespace meristem {

/// A mutex. A thread waits until the mutex is free, or until the thread is asked to stop.
class StoppableMutex {
 public:
  /// Waits until no other thread holds the mutex. The returned lock releases the mutex when it is destroyed. Throws
  /// Cancelled within 10 ms after `progress` was asked to stop. If `progress` is null, the wait cannot be stopped.
  [[nodiscard]] std::unique_lock<StoppableMutex> wait(const Progress* progress) {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_free_.wait_for(lock, std::chrono::milliseconds(10), [this] { return !is_held_; })) {
      if (progress != nullptr) progress->check();
    }
    is_held_ = true;
    return {*this, std::adopt_lock};
  }

  /// Waits like wait(), but cannot be stopped.
  void lock() { wait(nullptr).release(); }

  /// Releases the mutex. The thread that holds the mutex must call this once.
  void unlock() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_held_ = false;
    }
    is_free_.notify_one();
  }

 private:
  // A std::timed_mutex would do, but the thread sanitizer of GCC 12 does not see its locking.
  std::mutex mutex_;  // protects is_held_
  std::condition_variable is_free_;
  bool is_held_ = false;
};

}  // namespace meristem

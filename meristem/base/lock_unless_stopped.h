// SPDX-License-Identifier: Apache-2.0
// Waits for a lock without missing a request to stop.
#pragma once

#include <chrono>
#include <mutex>

#include "meristem/base/progress.h"

namespace meristem {

/// Locks `mutex` as soon as it is free. Throws Cancelled within 10 ms after `progress` was asked to stop; null: it
/// cannot be stopped.
inline std::unique_lock<std::timed_mutex> lock_unless_stopped(std::timed_mutex& mutex, const Progress* progress) {
  std::unique_lock<std::timed_mutex> lock(mutex, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(10))) {
    if (progress != nullptr) progress->check();
  }
  return lock;
}

}  // namespace meristem

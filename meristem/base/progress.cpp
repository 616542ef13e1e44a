// SPDX-License-Identifier: Apache-2.0
// Reports progress to an observer, one call at a time and only after each hundredth. Workers count with atomics and
// never wait for the observer.
#include "meristem/base/progress.h"

#include <algorithm>

namespace meristem {

namespace {

/// Returns the completed hundredths of a stage, 0 to 100.
std::uint64_t hundredths(std::uint64_t done, std::uint64_t total) {
  if (total == 0) return 0;
  return static_cast<std::uint64_t>(100 * std::min(1.0, static_cast<double>(done) / static_cast<double>(total)));
}

/// Releases the observer, also if it throws.
struct Release {
  std::atomic<bool>& reporting;
  ~Release() { reporting = false; }
};

}  // namespace

void Progress::begin(std::string_view stage, std::uint64_t total) {
  stage_ = stage;
  total_ = total;
  done_ = 0;
  reported_ = 0;
  if (observer_) report();
}

void Progress::advance(std::uint64_t units) {
  check();
  if (!observer_) return;
  done_ += units;
  report();
}

void Progress::report() {
  // A thread returns if another thread is in the observer. That thread checks the count again before it returns, so no
  // report is lost. One thread counts and then reads the flag, the other clears the flag and then reads the count. Both
  // need sequential consistency.
  while (hundredths(done_, total_) + 1 > reported_) {
    if (reporting_.exchange(true)) return;
    const Release release{reporting_};
    const std::uint64_t now = hundredths(done_, total_);
    if (now + 1 <= reported_) continue;
    reported_ = now + 1;
    observer_(stage_, static_cast<double>(now) / 100);
  }
}

}  // namespace meristem

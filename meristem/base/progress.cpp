// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/progress.h"

#include <algorithm>

namespace meristem {

namespace {

/// Done hundredths of a stage, 0 to 100.
std::uint64_t hundredths(std::uint64_t done, std::uint64_t total) {
  if (total == 0) return 0;
  return static_cast<std::uint64_t>(100 * std::min(1.0, static_cast<double>(done) / static_cast<double>(total)));
}

/// Gives the observer free again, also when it throws.
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
  // Whoever finds the observer busy leaves; the one that is there looks again before it goes, so nothing stays unsaid.
  // Both orders, count then look for busy and free then look at the count, need sequential consistency.
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

// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/reading_stop.h"

#include <utility>

namespace meristem {

namespace {

thread_local const Progress* reading_progress = nullptr;
thread_local std::uint64_t checks = 0;

}  // namespace

ReadingStop::ReadingStop(const Progress* progress)
    : before_(progress == nullptr ? reading_progress : std::exchange(reading_progress, progress)) {}

ReadingStop::~ReadingStop() { reading_progress = before_; }

void ReadingStop::check() {
  ++checks;
  if (reading_progress != nullptr) reading_progress->check();
}

const Progress* ReadingStop::progress() { return reading_progress; }

std::uint64_t ReadingStop::check_count() { return checks; }

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"

namespace meristem::cli {

/// Warnings and errors, one per line, on standard error.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

/// A line for the user on standard error, past any progress bar.
void print_status(const std::string& line);

/// Progress on standard error while it lives: a bar on a terminal, elsewhere a plain line every few seconds; nothing if
/// quiet. Ctrl-C and SIGTERM cancel it; a second Ctrl-C ends the program at once. One at a time.
class TerminalProgress {
 public:
  explicit TerminalProgress(bool quiet);
  ~TerminalProgress();
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  Progress& progress() { return progress_; }

 private:
  void show(std::string_view stage, double fraction);

  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool bar_shown_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  Progress progress_;
};

/// The signal that cancelled, or 0.
int received_signal();

}  // namespace meristem::cli

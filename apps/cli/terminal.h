// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/progress.h"

namespace meristem::cli {

/// Warnings and errors, one per line, on standard error.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

/// A line for the user on standard error, past any progress bar. Names in it are escaped as by visible_text().
void print_status(const std::string& line);

/// A line that the user asked for on standard output, escaped as by visible_text(). Data, such as JSON, is not printed
/// by it.
void print_line(const std::string& line);

/// Progress on standard error while it lives: a bar on a terminal, elsewhere a plain line every few seconds; nothing if
/// quiet. Ctrl-C and SIGTERM cancel it; a second Ctrl-C ends the program at once. One at a time.
class TerminalProgress {
 public:
  explicit TerminalProgress(bool quiet);
  ~TerminalProgress();
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  Progress& progress() { return progress_; }
  /// Says that the work is that many parts, such as frames, of which `done` are made: from then on the bar is over all
  /// of them and tells the time left. Parts that were there before, `found` of them, took no time. `what` is a literal
  /// and calls one of them: "frame".
  void tell_parts(const char* what, std::size_t done, std::size_t found, std::size_t all);

 private:
  void show(std::string_view stage, double fraction);

  using Clock = std::chrono::steady_clock;
  bool is_terminal_;
  bool bar_shown_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  std::atomic<const char*> part_{nullptr};
  std::atomic<std::size_t> parts_done_{0};
  std::atomic<std::size_t> parts_found_{0};
  std::atomic<std::size_t> parts_{0};
  Progress progress_;
};

/// The signal that cancelled, or 0.
int received_signal();

}  // namespace meristem::cli

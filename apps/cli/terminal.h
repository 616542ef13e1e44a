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

/// Prints warnings and errors on standard error, one per line.
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

/// Prints a line for the user on standard error, clear of any progress bar. Names in it are escaped as by
/// visible_text().
void print_status(const std::string& line);

/// Prints a line that the user requested on standard output, escaped as by visible_text(). Data, such as JSON, must not
/// be printed with this function.
void print_line(const std::string& line);

/// Shows progress on standard error during its lifetime: a bar on a terminal, elsewhere a plain line every few seconds,
/// and nothing if quiet. Ctrl-C and SIGTERM cancel the progress; a second Ctrl-C ends the program at once. Only one
/// object may exist at a time.
class TerminalProgress {
 public:
  explicit TerminalProgress(bool quiet);
  ~TerminalProgress();
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;

  Progress& progress() { return progress_; }
  /// Splits the work into `all` parts, such as frames; `done` parts are finished. From then on the bar covers all parts
  /// and shows the remaining time. `found` of the parts existed before and took no time. `what` is a string literal
  /// that names one part: "frame".
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

/// Returns the signal that cancelled the progress, or 0.
int received_signal();

}  // namespace meristem::cli

// SPDX-License-Identifier: Apache-2.0
#include "terminal.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "meristem/base/visible_text.h"

namespace meristem::cli {

namespace {

std::atomic<Progress*> active_progress{nullptr};
std::atomic<int> last_signal{0};

extern "C" void cancel_on_signal(int signal) {
  last_signal.store(signal);
  if (Progress* progress = active_progress.load()) progress->cancel();
}

/// Handles a signal. A signal that is ignored, for example under nohup, stays ignored.
void handle(int signal) {
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = cancel_on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // a second signal has its default effect
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

/// Writes a text to standard error. A failure is ignored, because no other channel could report it.
void write_error(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// Returns a text that is cut to the length of a screen.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMax = 2000;
  std::string out = text.substr(0, kMax);
  if (text.size() > kMax) {
    while (!out.empty() && (static_cast<unsigned char>(text[out.size()]) & 0xC0U) == 0x80U) out.pop_back();
    out += " ...";
  }
  return out;
}

/// Returns a duration as text: "3 min 20 s", "45 s".
std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

constexpr const char* kEraseLine = "\r\033[K";

}  // namespace

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) {
    const char* const kind = diagnostic.severity == Severity::warning ? "warning: " : "";
    const char* const origin = diagnostic.file.empty() ? "meristem: " : "";
    print_status(kind + shortened(origin + diagnostic.text()));
  }
}

void print_status(const std::string& line) { write_error(visible_text(line) + "\n"); }

void print_line(const std::string& line) { fmt::print("{}\n", visible_text(line)); }

TerminalProgress::TerminalProgress(bool quiet)
    : is_terminal_(isatty(STDERR_FILENO) != 0),
      progress_(quiet ? Progress::Observer()
                      : [this](std::string_view stage, double fraction) { show(stage, fraction); }) {
  active_progress.store(&progress_);
  handle(SIGINT);
  handle(SIGTERM);
  // A signal between two long calls stops the second one.
  if (last_signal.load() != 0) progress_.cancel();
}

TerminalProgress::~TerminalProgress() {
  active_progress.store(nullptr);
  if (bar_shown_) write_error(kEraseLine);
}

void TerminalProgress::tell_parts(const char* what, std::size_t done, std::size_t found, std::size_t all) {
  part_ = what;
  parts_done_ = done;
  parts_found_ = found;
  parts_ = all;
}

void TerminalProgress::show(std::string_view stage, double fraction) {
  constexpr auto kFirst = std::chrono::milliseconds(300);  // quick work shows no progress
  constexpr auto kBarEvery = std::chrono::milliseconds(50);
  constexpr auto kLineEvery = std::chrono::seconds(3);
  const Clock::time_point now = Clock::now();
  if (now - begin_ < kFirst) return;
  std::string parts;
  if (const std::size_t all = parts_; all > 0) {
    const std::size_t done = parts_done_;
    const std::size_t made = done - std::min(done, parts_found_.load());
    const double spent = std::chrono::duration<double>(now - begin_).count();
    parts = fmt::format("{} {} of {}", part_.load(), std::min(done + 1, all), all);
    if (made > 0) parts += fmt::format(", {} left", duration_text(spent / made * static_cast<double>(all - done)));
    stage = parts;
    fraction = static_cast<double>(done) / static_cast<double>(all);
  }
  if (is_terminal_) {
    if (bar_shown_ && now - shown_ < kBarEvery) return;
    constexpr int kWidth = 40;
    const int full = static_cast<int>(fraction * kWidth);
    write_error(fmt::format("{}{:<12} [{:=<{}}{: <{}}] {:3.0f} %", kEraseLine, stage, "", full, "", kWidth - full,
                            100 * fraction));
    bar_shown_ = true;
  } else {
    if (now - shown_ < kLineEvery) return;
    print_status(fmt::format("{} {:.0f} %", stage, 100 * fraction));
  }
  shown_ = now;
}

int received_signal() { return last_signal.load(); }

}  // namespace meristem::cli

// SPDX-License-Identifier: Apache-2.0
#include "terminal.h"

#include <atomic>
#include <csignal>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace meristem::cli {

namespace {

std::atomic<Progress*> active_progress{nullptr};
std::atomic<int> last_signal{0};

extern "C" void cancel_on_signal(int signal) {
  last_signal.store(signal);
  if (Progress* progress = active_progress.load()) progress->cancel();
}

void install_handlers(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // a second signal does what signals do
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

constexpr const char* kEraseLine = "\r\033[K";

}  // namespace

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) print_status(diagnostic.text());
}

void print_status(const std::string& line) { fmt::print(stderr, "{}\n", line); }

TerminalProgress::TerminalProgress(bool quiet)
    : is_terminal_(isatty(STDERR_FILENO) != 0),
      progress_(quiet ? Progress::Observer()
                      : [this](std::string_view stage, double fraction) { show(stage, fraction); }) {
  active_progress.store(&progress_);
  install_handlers(cancel_on_signal);
}

TerminalProgress::~TerminalProgress() {
  active_progress.store(nullptr);
  if (bar_shown_) fmt::print(stderr, "{}", kEraseLine);
  std::fflush(stderr);
}

void TerminalProgress::show(std::string_view stage, double fraction) {
  constexpr auto kFirst = std::chrono::milliseconds(300);  // quick work shows nothing
  constexpr auto kBarEvery = std::chrono::milliseconds(50);
  constexpr auto kLineEvery = std::chrono::seconds(3);
  const Clock::time_point now = Clock::now();
  if (now - begin_ < kFirst) return;
  if (is_terminal_) {
    if (bar_shown_ && now - shown_ < kBarEvery) return;
    constexpr int kWidth = 40;
    const int full = static_cast<int>(fraction * kWidth);
    fmt::print(stderr, "{}{:<12} [{:=<{}}{: <{}}] {:3.0f} %", kEraseLine, stage, "", full, "", kWidth - full,
               100 * fraction);
    std::fflush(stderr);
    bar_shown_ = true;
  } else {
    if (now - shown_ < kLineEvery) return;
    print_status(fmt::format("{} {:.0f} %", stage, 100 * fraction));
  }
  shown_ = now;
}

int received_signal() { return last_signal.load(); }

}  // namespace meristem::cli

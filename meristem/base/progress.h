// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <string_view>

namespace meristem {

/// Thrown by a long call that was asked to stop. Whatever it had begun is undone.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// The one thing that a long call reports to and asks whether to go on.
///
/// A caller makes one, passes it down, and may call `cancel()` from any thread or from a signal handler. Workers call
/// `advance()` or `check()` often enough that cancelling answers within 50 ms. Without an observer it costs one
/// relaxed atomic load a call.
class Progress {
 public:
  /// Told the stage ("growing") and its done share in [0, 1]; called from worker threads, one at a time, only when the
  /// share has moved by at least a hundredth or the stage is new.
  using Observer = std::function<void(std::string_view stage, double fraction)>;

  Progress() = default;
  explicit Progress(Observer observer) : observer_(std::move(observer)) {}
  /// A part of `whole`, which must outlive it: it reports nothing and stops when the whole does. For calls with stages
  /// of their own that run on many threads within one stage of the whole.
  explicit Progress(const Progress* whole) : whole_(whole) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a stage of `total` units of work; the one before it is over. `stage` must outlive the stage (a literal).
  void begin(std::string_view stage, std::uint64_t total);
  /// Counts `units` as done. Throws Cancelled if asked to stop.
  void advance(std::uint64_t units = 1);
  /// Throws Cancelled if asked to stop.
  void check() const {
    if (is_cancelled()) throw Cancelled();
  }

  /// Asks the call to stop, which then throws Cancelled. Any thread and a signal handler may call it.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  /// True after cancel(), of this progress or of the whole that it is a part of.
  bool is_cancelled() const noexcept {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->is_cancelled());
  }

 private:
  void report();

  std::atomic<bool> cancelled_{false};
  std::atomic<std::uint64_t> done_{0};
  std::atomic<std::uint64_t> reported_{0};  // hundredths, plus one once the stage was announced
  std::atomic<bool> reporting_{false};
  std::uint64_t total_ = 0;
  std::string_view stage_;
  Observer observer_;
  const Progress* whole_ = nullptr;
};

}  // namespace meristem

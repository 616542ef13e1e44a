// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <string_view>

namespace meristem {

/// Thrown by a long call that was asked to stop. Everything that the call had begun is undone.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Progress of a long call, and the way to cancel the call.
///
/// A caller creates the object, passes it down, and may call `cancel()` from any thread or from a signal handler.
/// Workers call `advance()` or `check()` often enough that a call stops within 50 ms. Without an observer, each call
/// costs one relaxed atomic load.
class Progress {
 public:
  /// Receives the stage ("growing") and its completed share in [0, 1]. Called from worker threads, one at a time, and
  /// only if the stage is new or the share has grown by at least a hundredth.
  using Observer = std::function<void(std::string_view stage, double fraction)>;

  Progress() = default;
  explicit Progress(Observer observer) : observer_(std::move(observer)) {}  ///< calls `observer`
  /// Progress of a part of `whole`, which must outlive this object. It reports nothing and is cancelled together with
  /// the whole. For calls with their own stages that run on many threads within one stage of the whole.
  explicit Progress(const Progress* whole) : whole_(whole) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a stage of `total` units of work and ends the stage before. `stage` must outlive the stage (a literal).
  void begin(std::string_view stage, std::uint64_t total);
  /// Counts `units` as done. Throws Cancelled if asked to stop.
  void advance(std::uint64_t units = 1);
  /// Throws Cancelled if asked to stop.
  void check() const {
    if (is_cancelled()) throw Cancelled();
  }

  /// Asks the call to stop, which then throws Cancelled. May be called from any thread and from a signal handler.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  /// Returns true after cancel() of this progress or of its whole.
  bool is_cancelled() const noexcept {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->is_cancelled());
  }

 private:
  void report();

  std::atomic<bool> cancelled_{false};
  std::atomic<std::uint64_t> done_{0};
  std::atomic<std::uint64_t> reported_{0};  // reported hundredths plus one; 0 if the stage has not been announced
  std::atomic<bool> reporting_{false};
  std::uint64_t total_ = 0;
  std::string_view stage_;
  Observer observer_;
  const Progress* whole_ = nullptr;
};

}  // namespace meristem

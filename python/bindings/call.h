// SPDX-License-Identifier: Apache-2.0
// Long calls from Python: they let other Python threads run, tell a Progress, and stop for Ctrl-C.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include <pybind11/pybind11.h>

#include "meristem/base/progress.h"

namespace meristem::python {

namespace py = pybind11;

/// What Python watches and cancels a call by. It watches one call at a time.
class Watch {
 public:
  /// `callback` is called with stage and fraction, or None.
  explicit Watch(py::object callback);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  void cancel() noexcept;
  bool is_cancelled() const noexcept { return cancelled_; }
  std::string stage() const;
  double fraction() const;

  /// Runs `body` on a thread of its own, bounded to `threads` (0: all cores), while this one, without the GIL, looks
  /// for signals. Rethrows what `body`, the callback or a signal's handler threw; the callback and the handler cancel
  /// `body`.
  void run(int threads, const std::function<void(Progress&)>& body);

 private:
  void tell(std::string_view stage, double fraction);

  py::object callback_;
  mutable std::mutex mutex_;  // guards what follows
  std::string stage_;
  double fraction_ = 0;
  Progress* running_ = nullptr;
  std::unique_ptr<py::error_already_set> callback_error_;
  std::atomic<bool> cancelled_{false};
};

/// The Watch that an argument `progress` means: a Progress, something to call, or None.
std::shared_ptr<Watch> watch_of(const py::object& progress);

/// What `body(progress)` gives, called as Watch::run does.
template <class Body>
auto run_call(const py::object& progress, int threads, Body body) {
  std::optional<decltype(body(std::declval<Progress&>()))> result;
  watch_of(progress)->run(threads, [&](Progress& inner) { result.emplace(body(inner)); });
  return std::move(*result);
}

void bind_progress(py::module_& module);

}  // namespace meristem::python

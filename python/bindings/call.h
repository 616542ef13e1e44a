// SPDX-License-Identifier: Apache-2.0
// Long calls from Python. Other Python threads run during a call. A call reports to a Progress and stops for Ctrl-C.
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

/// Lets Python watch and cancel a call. Watches one call at a time.
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

  /// Runs `body` on a thread of its own, bounded to `threads` (0: all cores). Meanwhile the calling thread checks for
  /// signals, without the GIL. Rethrows exceptions of `body`, of the callback and of signal handlers. Exceptions of the
  /// callback and of handlers cancel `body`.
  void run(int threads, const std::function<void(Progress&)>& body);

 private:
  void tell(std::string_view stage, double fraction);

  py::object callback_;
  mutable std::mutex mutex_;  // guards the members below
  std::string stage_;
  double fraction_ = 0;
  Progress* running_ = nullptr;
  std::unique_ptr<py::error_already_set> callback_error_;
  std::atomic<bool> cancelled_{false};
};

/// Returns the Watch for an argument `progress`: a Progress, a callable, or None.
std::shared_ptr<Watch> watch_of(const py::object& progress);

/// Returns the result of `body(progress)`, called by Watch::run.
template <class Body>
auto run_call(const py::object& progress, int threads, Body body) {
  std::optional<decltype(body(std::declval<Progress&>()))> result;
  watch_of(progress)->run(threads, [&](Progress& inner) { result.emplace(body(inner)); });
  return std::move(*result);
}

void bind_progress(py::module_& module);

}  // namespace meristem::python

// SPDX-License-Identifier: Apache-2.0
// A long call runs on a thread of its own. Meanwhile the caller's thread checks for signals, without the interpreter's
// lock. Ctrl-C and callbacks can therefore stop the call, and other Python threads continue. Objects that Python sees
// never change, and arrays keep their memory alive.
#include "call.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <set>
#include <stdexcept>
#include <thread>

#include "meristem/base/parallel.h"

namespace meristem::python {

namespace {

constexpr auto kSignalPause = std::chrono::milliseconds(20);

/// Runs a body on its own thread and knows whether it has ended.
class Worker {
 public:
  explicit Worker(std::function<void()> body) : thread_([this, body = std::move(body)] { run(body); }) {}

  /// Waits a short time. Returns true if the body has ended.
  bool has_ended_within(std::chrono::milliseconds pause) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, pause, [this] { return has_ended_; });
  }
  std::exception_ptr join() {
    thread_.join();
    return error_;
  }

 private:
  void run(const std::function<void()>& body) {
    try {
      body();
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // last: it uses the other members
};

/// The running calls. No call may outlive the interpreter, because the interpreter ends Python threads that wait for a
/// call in the middle of the call.
class RunningCalls {
 public:
  void enter(Watch* watch) {
    const std::lock_guard lock(mutex_);
    if (is_closed_) throw std::runtime_error("Python is ending");
    watches_.insert(watch);
  }
  void leave(Watch* watch) {
    const std::lock_guard lock(mutex_);
    watches_.erase(watches_.find(watch));
    changed_.notify_all();
  }
  /// Cancels all calls, refuses new calls, and returns when all have ended. Must be called without the GIL.
  void close() {
    std::unique_lock lock(mutex_);
    is_closed_ = true;
    for (Watch* const watch : watches_) watch->cancel();
    changed_.wait(lock, [this] { return watches_.empty(); });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::multiset<Watch*> watches_;
  bool is_closed_ = false;
};

RunningCalls& running_calls() {
  static RunningCalls calls;
  return calls;
}

/// Registers a running call during its lifetime.
class RunningCall {
 public:
  explicit RunningCall(Watch* watch) : watch_(watch) { running_calls().enter(watch); }
  ~RunningCall() { running_calls().leave(watch_); }
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;

 private:
  Watch* watch_;
};

}  // namespace

Watch::Watch(py::object callback) : callback_(std::move(callback)) {}
Watch::~Watch() = default;

void Watch::cancel() noexcept {
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  if (running_ != nullptr) running_->cancel();
}

std::string Watch::stage() const {
  const std::lock_guard lock(mutex_);
  return stage_;
}

double Watch::fraction() const {
  const std::lock_guard lock(mutex_);
  return fraction_;
}

void Watch::tell(std::string_view stage, double fraction) {
  {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    fraction_ = fraction;
    if (callback_error_) return;
  }
  if (callback_.is_none()) return;
  const py::gil_scoped_acquire gil;
  try {
    callback_(py::str(stage.data(), stage.size()), fraction);
  } catch (py::error_already_set& error) {
    const std::lock_guard lock(mutex_);
    callback_error_ = std::make_unique<py::error_already_set>(std::move(error));
    if (running_ != nullptr) running_->cancel();
  }
}

void Watch::run(int threads, const std::function<void(Progress&)>& body) {
  if (threads < 0 || threads > 1024) throw py::value_error("threads must be 0 (all cores) to 1024");
  Progress progress([this](std::string_view stage, double fraction) { tell(stage, fraction); });
  const RunningCall running(this);
  {
    const std::lock_guard lock(mutex_);
    if (running_ != nullptr) throw py::value_error("this Progress watches another call; make one for each call");
    running_ = &progress;
    if (cancelled_) progress.cancel();
  }
  std::unique_ptr<py::error_already_set> signal_error;
  std::exception_ptr body_error;
  {
    const py::gil_scoped_release no_gil;
    Worker worker([&] {
      const ThreadLimit limit(threads);
      progress.check();
      body(progress);
    });
    while (!worker.has_ended_within(kSignalPause)) {
      const py::gil_scoped_acquire gil;
      if (signal_error || PyErr_CheckSignals() == 0) continue;
      signal_error = std::make_unique<py::error_already_set>();
      progress.cancel();
    }
    body_error = worker.join();
    const std::lock_guard lock(mutex_);
    running_ = nullptr;
  }
  const std::unique_ptr<py::error_already_set> callback_error = std::move(callback_error_);
  if (signal_error) throw std::move(*signal_error);
  if (callback_error) throw std::move(*callback_error);
  if (body_error) std::rethrow_exception(body_error);
}

std::shared_ptr<Watch> watch_of(const py::object& progress) {
  if (py::isinstance<Watch>(progress)) return progress.cast<std::shared_ptr<Watch>>();
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0) {
    throw py::type_error("progress must be a Progress, something to call with stage and fraction, or None");
  }
  return std::make_shared<Watch>(progress);
}

void bind_progress(py::module_& module) {
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    const py::gil_scoped_release no_gil;
    running_calls().close();
  }));
  using WatchPointer = std::shared_ptr<Watch>;
  py::class_<Watch, WatchPointer>(module, "Progress", R"(Watches a long call and cancels it.

Use it for one call at a time. `callback`, if given, is called with the stage (a str) and its finished share in [0, 1],
whenever the share has grown by a hundredth. It is called from other threads than the caller's thread. An exception of
`callback` cancels the call, and the call raises it.

    progress = meristem.Progress(lambda stage, share: print(f"{stage} {share:.0%}"))
    plant = meristem.read("tulip").grow(progress=progress)
    assert not progress.cancelled)")
      .def(py::init<py::object>(), py::arg("callback") = py::none())
      .def(
          "cancel", [](const WatchPointer& w) { w->cancel(); },
          "Makes the call raise Cancelled within 50 ms, and further calls with this Progress, too. May be called from "
          "any thread.")
      .def_property_readonly(
          "cancelled", [](const WatchPointer& w) { return w->is_cancelled(); }, "Whether cancel() was called.")
      .def_property_readonly(
          "stage", [](const WatchPointer& w) { return w->stage(); }, "What the call is doing, such as 'growing'.")
      .def_property_readonly(
          "fraction", [](const WatchPointer& w) { return w->fraction(); }, "The stage's done share, 0 to 1.");
}

}  // namespace meristem::python

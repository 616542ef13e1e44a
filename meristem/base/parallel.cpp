// SPDX-License-Identifier: Apache-2.0
// Runs the blocks of a loop on several threads. Blocks go to oneTBB. ThreadSanitizer misreads the synchronisation of
// TBB, so under this sanitizer the blocks go to threads that count through them.
#include "meristem/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifdef MERISTEM_THREADS_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

namespace meristem {

namespace {

// Maximum number of threads of a loop that this thread begins; 0 for no limit.
thread_local int thread_limit = 0;

/// Returns how many of `wanted` threads the system can start. Twice as many must start, since other parts of the
/// program later use memory too. Each thread allocates its stack and its share of the allocator before the next thread
/// starts, so that a busy machine gives the count of an idle one. TBB does not survive a thread that cannot be started.
int startable_threads(int wanted) {
  std::atomic<bool> all_asked{false};
  std::atomic<int> ready{0};
  std::vector<std::jthread> started;
  const auto stay = [&all_asked, &ready] {
    const auto taken = std::make_unique<std::atomic<int>>(1);
    taken->fetch_add(1);
    ready.fetch_add(1);
    ready.notify_one();
    all_asked.wait(false);
  };
  try {
    while (static_cast<int>(started.size()) + 1 < 2 * wanted) {
      started.emplace_back(stay);
      for (int count = ready; count < static_cast<int>(started.size()); count = ready) ready.wait(count);
    }
  } catch (const std::system_error&) {
    // The system cannot start more threads.
  } catch (const std::bad_alloc&) {
  }
  all_asked = true;
  all_asked.notify_all();
  return std::max(1, (static_cast<int>(started.size()) + 1) / 2);
}

int machine_cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

int core_count() {
  static const int count = startable_threads(machine_cores());
  return count;
}

/// Returns how many of `wanted` threads can be started. Tests this once for each higher number.
int available_threads(int wanted) {
  if (wanted <= core_count()) return wanted;
  static std::mutex mutex;
  static int max_wanted = 0, max = 0;
  const std::lock_guard lock(mutex);
  if (wanted > max_wanted) {
    max = startable_threads(wanted);
    max_wanted = wanted;
  }
  return std::min(wanted, max);
}

/// Applies the limit of a loop to the loops inside its blocks, on whichever thread the block runs.
class InheritedLimit {
 public:
  explicit InheritedLimit(int limit) : previous_(std::exchange(thread_limit, limit)) {}
  ~InheritedLimit() { thread_limit = previous_; }
  InheritedLimit(const InheritedLimit&) = delete;
  InheritedLimit& operator=(const InheritedLimit&) = delete;

 private:
  int previous_;
};

/// The blocks of one loop, and the exception of the lowest block that threw.
class Blocks {
 public:
  Blocks(std::size_t count, std::size_t grain, FunctionRef<void(std::size_t, std::size_t)> body)
      : count_(count), grain_(grain), body_(body), limit_(thread_limit) {}

  std::size_t size() const { return count_ / grain_ + (count_ % grain_ == 0 ? 0 : 1); }

  /// Runs a block, unless a lower block has thrown. Lower blocks still run, so the exception does not depend on timing.
  void run(std::size_t block) noexcept {
    if (block > lowest_thrown_.load(std::memory_order_relaxed)) return;
    const InheritedLimit inherited(limit_);
    try {
      const std::size_t begin = block * grain_;
      body_(begin, begin + std::min(grain_, count_ - begin));
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (block >= lowest_thrown_.load(std::memory_order_relaxed)) return;
      lowest_thrown_.store(block, std::memory_order_relaxed);
      exception_ = std::current_exception();
    }
  }

  void rethrow() {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::size_t count_;
  std::size_t grain_;
  FunctionRef<void(std::size_t, std::size_t)> body_;
  int limit_;
  std::atomic<std::size_t> lowest_thrown_{std::numeric_limits<std::size_t>::max()};
  std::mutex mutex_;
  std::exception_ptr exception_;
};

void run_alone(Blocks& blocks) {
  for (std::size_t block = 0; block < blocks.size(); ++block) blocks.run(block);
}

#ifdef MERISTEM_THREADS_TBB

/// Allows TBB to start more threads than there are cores. Set once, because TBB uses the lowest of all values that are
/// set.
void allow_more_than_cores() {
  static const tbb::global_control max(tbb::global_control::max_allowed_parallelism, 1024);
}

/// An arena for a limited number of threads.
struct Crew {
  explicit Crew(int size) : threads(size), arena(size) {
    if (size > machine_cores()) allow_more_than_cores();
  }

  int threads;
  tbb::task_arena arena;
};

// Kept from loop to loop. A new crew for each loop took 0.3 ms instead of 3 us for 64 empty blocks on 3 threads.
thread_local std::shared_ptr<Crew> kept_crew;

Crew& crew_of(int threads) {
  if (!kept_crew || kept_crew->threads != threads) kept_crew = std::make_shared<Crew>(threads);
  return *kept_crew;
}

std::shared_ptr<void> exchange_crew(const std::shared_ptr<void>& crew) {
  return std::exchange(kept_crew, std::static_pointer_cast<Crew>(crew));
}

// All threads use the caller's floating-point settings. TBB's own context flushes the smallest numbers to zero if
// Embree was the first user of TBB, while a single thread does not.
using Context = tbb::task_group_context;
constexpr auto kTraits = Context::default_traits | Context::fp_settings;

/// Returns true if this thread computes like a new program: rounds to the nearest number and keeps the smallest
/// numbers.
bool rounds_as_usual() {
  const volatile float smallest_normal = std::numeric_limits<float>::min();
  return std::fegetround() == FE_TONEAREST && smallest_normal / 2 > 0;
}

/// Returns the context for the loops of all threads with usual settings. Blocks do not throw, so this context is never
/// cancelled. It outlives all loops: objects that Embree builds in a block may outlive the loop, and TBB reads the
/// context of their construction whenever anything is cancelled.
Context& lasting_context() {
  static Context& context = *new Context(Context::isolated, kTraits);
  return context;
}

void run_together(Blocks& blocks, int threads) {
  const auto run_range = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t block = range.begin(); block < range.end(); ++block) blocks.run(block);
  };
  // Isolated: a thread that waits for an inner loop never begins a block of the outer loop in the middle of another
  // block.
  const auto run_in = [&](Context& context) {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size(), 1), run_range, tbb::simple_partitioner(),
                        context);
    });
  };
  const auto run_all = [&] {
    if (rounds_as_usual()) return run_in(lasting_context());
    Context own(Context::isolated, kTraits);
    run_in(own);
  };
  const bool is_whole_machine = thread_limit == 0 && threads == machine_cores();
  if (is_whole_machine || tbb::this_task_arena::max_concurrency() == threads) return run_all();
  crew_of(threads).arena.execute(run_all);
}

#else

std::shared_ptr<void> exchange_crew(const std::shared_ptr<void>&) { return nullptr; }

// Loops within a block run on one thread, because the outer loop already uses the threads.
thread_local bool is_in_block = false;

void run_together(Blocks& blocks, int threads) {
  if (is_in_block) return run_alone(blocks);
  std::atomic<std::size_t> next{0};
  const auto pull = [&] {
    is_in_block = true;
    for (std::size_t block = next++; block < blocks.size(); block = next++) blocks.run(block);
    is_in_block = false;
  };
  std::vector<std::jthread> others;
  try {
    while (others.size() + 1 < std::min(static_cast<std::size_t>(threads), blocks.size())) others.emplace_back(pull);
  } catch (const std::system_error&) {
    // If no more threads can be started, the existing threads do all the work.
  }
  pull();
}

#endif

}  // namespace

void parallel_for(std::size_t count, std::size_t grain, FunctionRef<void(std::size_t, std::size_t)> body) {
  if (grain == 0) throw std::invalid_argument("a parallel loop's grain must be at least 1");
  Blocks blocks(count, grain, body);
  const int threads = thread_count();
  if (threads == 1 || blocks.size() <= 1) {
    run_alone(blocks);
  } else {
    run_together(blocks, threads);
  }
  blocks.rethrow();
}

int thread_count() { return thread_limit > 0 ? available_threads(thread_limit) : core_count(); }

ThreadLimit::ThreadLimit(int threads) : previous_(thread_limit) {
  if (threads < 0) throw std::invalid_argument("a thread limit must be at least 1, or 0 for all cores");
  thread_limit = threads;
  // Set the crew aside instead of destroying it, because this thread may be working for it.
  previous_crew_ = exchange_crew(nullptr);
}

ThreadLimit::~ThreadLimit() {
  thread_limit = previous_;
  exchange_crew(previous_crew_);
}

}  // namespace meristem

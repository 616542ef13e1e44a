// SPDX-License-Identifier: Apache-2.0
// The project's only parallel loop. Its blocks depend only on the count and the grain, never on the number of threads.
// A body that writes to fixed positions, or whose block results are combined in block order, gives equal bytes on 1 or
// 64 threads.
#pragma once

#include <cstddef>
#include <memory>

#include "meristem/base/function_ref.h"

namespace meristem {

/// Calls `body(begin, end)` for every block [k*grain, (k+1)*grain) of [0, count), on up to thread_count() threads.
/// Returns after all blocks are done. If a body throws, higher blocks that have not begun are skipped, and lower blocks
/// still run. Then the exception of the lowest block that threw is rethrown, which is equal on any number of threads.
/// `grain` must be at least 1. Calls may nest: a thread begins no other block before its current block has returned.
void parallel_for(std::size_t count, std::size_t grain, FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// Returns the number of threads that parallel_for may use. This is the number of cores unless a ThreadLimit is set, or
/// less if the system cannot start as many.
int thread_count();

/// While this object exists, limits the threads of loops that the current thread begins, and of loops nested in them.
/// Loops of other threads are not affected. The limit may exceed the number of cores. The limits of one thread must end
/// in the reverse order of their construction.
class ThreadLimit {
 public:
  /// `threads` must be at least 1, or 0 for the number of cores.
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int previous_;
  std::shared_ptr<void> previous_crew_;
};

}  // namespace meristem

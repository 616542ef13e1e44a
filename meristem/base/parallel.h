// SPDX-License-Identifier: Apache-2.0
// The one parallel loop. Its blocks depend only on the count and the grain, never on the number of threads, so a body
// that writes to fixed places, or per-block results combined in block order, gives the same bytes on 1 or 64 threads.
#pragma once

#include <cstddef>
#include <memory>

#include "meristem/base/function_ref.h"

namespace meristem {

/// Calls `body(begin, end)` for every block [k*grain, (k+1)*grain) of [0, count), on up to thread_count() threads.
/// Returns when all are done. If a body throws, higher blocks not yet begun are left out, lower ones still run, and the
/// exception of the lowest block that threw is rethrown: the same one on any number of threads. `grain` is at least 1.
/// Calls may nest; no thread begins another block before the one it is in has returned.
void parallel_for(std::size_t count, std::size_t grain, FunctionRef<void(std::size_t begin, std::size_t end)> body);

/// How many threads parallel_for may use: the machine's cores unless a ThreadLimit says otherwise; fewer where the
/// system does not start that many.
int thread_count();

/// While it lives, bounds the threads of the loops that this thread begins and of those within them; other threads'
/// loops are not touched. More threads than cores are allowed. Limits of one thread end in the reverse order of their
/// making.
class ThreadLimit {
 public:
  /// `threads` is at least 1; 0 means the machine's cores.
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int previous_;
  std::shared_ptr<void> previous_crew_;
};

}  // namespace meristem

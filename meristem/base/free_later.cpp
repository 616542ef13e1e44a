// SPDX-License-Identifier: Apache-2.0
// A thread per call: no state is shared, so that programs may fork, and end while the thread runs.
#include "meristem/base/free_later.h"

#include <system_error>
#include <thread>

namespace meristem {

void run_apart(std::function<void()> function) {
  try {
    std::thread(std::move(function)).detach();
  } catch (const std::system_error&) {
    // The function has been destroyed, and its objects with it.
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/free_later.h"

#include <future>
#include <thread>

#include <gtest/gtest.h>

namespace meristem::free_later_test {

/// Reports the thread on which it is freed, if it was not moved from.
struct Reporter {
  std::unique_ptr<std::promise<std::thread::id>> freed = std::make_unique<std::promise<std::thread::id>>();

  Reporter() = default;
  Reporter(Reporter&&) = default;
  ~Reporter() {
    if (freed != nullptr) freed->set_value(std::this_thread::get_id());
  }
};

TEST(FreeLater, ObjectsAreFreedOnceOnAnotherThread) {
  Reporter reporter;
  std::future<std::thread::id> freed = reporter.freed->get_future();
  free_later(std::move(reporter));
  EXPECT_NE(freed.get(), std::this_thread::get_id());
}

}  // namespace meristem::free_later_test

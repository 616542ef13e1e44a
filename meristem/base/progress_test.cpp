// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/progress.h"

#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/parallel.h"
#include "meristem/base/stoppable_mutex.h"

namespace meristem::progress_test {

struct Report {
  std::string stage;
  double fraction;
};

/// Collects the reports to an observer.
struct Listener {
  std::vector<Report> reports;
  Progress progress{[this](std::string_view stage, double fraction) {
    reports.push_back({std::string(stage), fraction});
  }};
};

/// Counts calls from many threads: [0, 100'000) in blocks of 10.
void advance_in_parallel(Progress& progress) {
  progress.begin("growing", 100'000);
  parallel_for(100'000, 10, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) progress.advance();
  });
}

TEST(Progress, AnnouncesEachStageThenEachHundredth) {
  Listener listener;
  listener.progress.begin("growing", 1000);
  for (int k = 0; k < 1000; ++k) listener.progress.advance();
  listener.progress.begin("meshing", 3);
  ASSERT_EQ(listener.reports.size(), 102U);
  for (std::size_t k = 0; k <= 100; ++k) {
    EXPECT_EQ(listener.reports[k].stage, "growing");
    EXPECT_DOUBLE_EQ(listener.reports[k].fraction, static_cast<double>(k) / 100);
  }
  EXPECT_EQ(listener.reports.back().stage, "meshing");
  EXPECT_EQ(listener.reports.back().fraction, 0);
}

TEST(Progress, SaysNothingBelowAHundredthAndNeverMoreThanAll) {
  Listener listener;
  listener.progress.begin("growing", 1'000'000);
  listener.progress.advance(9'999);
  EXPECT_EQ(listener.reports.size(), 1U);
  listener.progress.advance(5'000'000);
  listener.progress.advance();
  ASSERT_EQ(listener.reports.size(), 2U);
  EXPECT_EQ(listener.reports.back().fraction, 1);
}

TEST(Progress, TakesAStageWithoutUnits) {
  Listener listener;
  listener.progress.begin("growing", 0);
  listener.progress.advance();
  ASSERT_EQ(listener.reports.size(), 1U);
  EXPECT_EQ(listener.reports[0].fraction, 0);
}

TEST(Progress, ReportsRiseAndReachTheEndFromAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    Listener listener;
    advance_in_parallel(listener.progress);
    ASSERT_GE(listener.reports.size(), 2U);
    for (std::size_t k = 1; k < listener.reports.size(); ++k) {
      EXPECT_GE(listener.reports[k].fraction, listener.reports[k - 1].fraction + 0.0099);
    }
    EXPECT_EQ(listener.reports.back().fraction, 1);
  }
}

TEST(Progress, ThrowsCancelledOnceAskedToStop) {
  Progress progress;
  progress.begin("growing", 10);
  EXPECT_NO_THROW(progress.advance());
  EXPECT_NO_THROW(progress.check());
  progress.cancel();
  EXPECT_TRUE(progress.is_cancelled());
  EXPECT_THROW(progress.advance(), Cancelled);
  EXPECT_THROW(progress.check(), Cancelled);
}

TEST(Progress, CancellingWithinAnObserverStopsEveryThread) {
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    std::atomic<Progress*> self = nullptr;
    Progress progress([&](std::string_view, double fraction) {
      if (fraction >= 0.1) self.load()->cancel();
    });
    self = &progress;
    EXPECT_THROW(advance_in_parallel(progress), Cancelled);
  }
}

TEST(Progress, GoesOnAfterAnObserverThatThrows) {
  int calls = 0;
  Progress progress([&](std::string_view, double) {
    if (++calls == 2) throw std::runtime_error("no terminal");
  });
  progress.begin("growing", 10);
  EXPECT_THROW(progress.advance(), std::runtime_error);
  EXPECT_NO_THROW(progress.advance());
  EXPECT_EQ(calls, 3);
}

TEST(ProgressPart, StopsWithTheWholeAndTellsNobody) {
  int told = 0;
  Progress whole([&](std::string_view, double) { ++told; });
  Progress part(&whole);
  part.begin("a part", 10);
  part.advance(10);
  EXPECT_EQ(told, 0);
  whole.cancel();
  EXPECT_THROW(part.advance(), Cancelled);
  EXPECT_THROW(part.check(), Cancelled);
}

TEST(ProgressPart, StopsAlone) {
  Progress whole;
  Progress part(&whole);
  part.cancel();
  EXPECT_TRUE(part.is_cancelled());
  EXPECT_FALSE(whole.is_cancelled());
}

TEST(StoppableMutex, WaitsUntilItIsFreeOrUntilTheStop) {
  StoppableMutex mutex;
  Progress progress;
  EXPECT_TRUE(mutex.wait(&progress).owns_lock());
  const std::unique_lock<StoppableMutex> held(mutex);
  bool is_stopped = false;
  std::thread waiting([&] {
    try {
      const auto lock = mutex.wait(&progress);
    } catch (const Cancelled&) {
      is_stopped = true;
    }
  });
  progress.cancel();
  waiting.join();
  EXPECT_TRUE(is_stopped);
}

TEST(StoppableMutex, IsHeldByOneOfManyThreads) {
  StoppableMutex mutex;
  int count = 0;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (int step = 0; step < 1000; ++step) {
        const auto lock = mutex.wait(nullptr);
        ++count;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(count, 4000);
}

}  // namespace meristem::progress_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/parallel.h"

#include <atomic>
#include <chrono>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/progress.h"
#include "meristem/base/random.h"

namespace meristem::parallel_test {

constexpr int kThreadCounts[] = {1, 2, 3, 8};

using Range = std::pair<std::size_t, std::size_t>;

std::vector<Range> blocks_of(std::size_t count, std::size_t grain) {
  std::vector<Range> blocks(count / grain + 1, Range(0, 0));
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) { blocks.at(begin / grain) = {begin, end}; });
  if (blocks.back() == Range(0, 0)) blocks.pop_back();
  return blocks;
}

/// Returns a sum whose last bits depend on the order of additions: per block, then over blocks.
double ordered_sum() {
  std::vector<double> sums(101);
  parallel_for(10'050, 100, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) sums[begin / 100] += 1 / (1e-3 + RandomKey(1).uniform(k));
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    std::vector<std::atomic<int>> visits(10'007);
    parallel_for(visits.size(), 10, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) ++visits[k];
    });
    for (const auto& count : visits) ASSERT_EQ(count, 1);
  }
}

TEST(ParallelFor, BlocksDependOnCountAndGrainOnly) {
  const std::vector<Range> expected = {{0, 4}, {4, 8}, {8, 10}};
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(blocks_of(10, 4), expected);
    EXPECT_EQ(blocks_of(8, 4), (std::vector<Range>{{0, 4}, {4, 8}}));
    EXPECT_EQ(blocks_of(3, 100), (std::vector<Range>{{0, 3}}));
    EXPECT_TRUE(blocks_of(0, 4).empty());
  }
}

TEST(ParallelFor, CountsUpToTheLargestNumber) {
  const std::size_t max = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ(blocks_of(max, max / 2), (std::vector<Range>{{0, max / 2}, {max / 2, max - 1}, {max - 1, max}}));
}

TEST(ParallelFor, SumsInBlockOrderHaveTheSameBytesOnAnyNumberOfThreads) {
  std::vector<double> sums;
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    sums.push_back(ordered_sum());
  }
  sums.push_back(ordered_sum());
  for (const double sum : sums) EXPECT_EQ(sum, sums[0]);
}

TEST(ParallelFor, Nests) {
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    std::vector<std::size_t> cells(60 * 70);
    parallel_for(60, 1, [&](std::size_t row, std::size_t) {
      parallel_for(70, 3, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) cells[row * 70 + k] += row * 70 + k;
      });
    });
    for (std::size_t k = 0; k < cells.size(); ++k) ASSERT_EQ(cells[k], k);
  }
}

TEST(ParallelFor, NeverBeginsABlockInTheMiddleOfAnother) {
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    std::atomic<bool> has_interrupted = false;
    parallel_for(200, 1, [&](std::size_t, std::size_t) {
      thread_local bool is_inside = false;
      if (is_inside) has_interrupted = true;
      is_inside = true;
      parallel_for(50, 1, [](std::size_t, std::size_t) { std::this_thread::yield(); });
      is_inside = false;
    });
    EXPECT_FALSE(has_interrupted);
  }
}

TEST(ParallelFor, RethrowsTheExceptionOfTheLowestBlock) {
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    for (int repetition = 0; repetition < 50; ++repetition) {
      std::atomic<int> lower_blocks = 0;
      try {
        parallel_for(1000, 1, [&](std::size_t begin, std::size_t) {
          if (begin < 300) ++lower_blocks;
          if (begin >= 300) throw std::runtime_error(std::to_string(begin));
        });
        FAIL() << "no exception";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "300");
      }
      EXPECT_EQ(lower_blocks, 300);
    }
  }
}

TEST(ParallelFor, LeavesOutBlocksAboveAnException) {
  const ThreadLimit limit(1);
  std::size_t last = 0;
  EXPECT_THROW(parallel_for(1000, 10,
                            [&](std::size_t begin, std::size_t) {
                              last = begin;
                              if (begin == 50) throw std::runtime_error("stop");
                            }),
               std::runtime_error);
  EXPECT_EQ(last, 50U);
}

TEST(ParallelFor, PassesExceptionsThroughNestedLoopsAndWorksAfterwards) {
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(parallel_for(100, 1,
                              [&](std::size_t, std::size_t) {
                                parallel_for(100, 1, [&](std::size_t, std::size_t) { progress.check(); });
                              }),
                 Cancelled);
    EXPECT_EQ(blocks_of(10, 5).size(), 2U);
  }
}

TEST(ParallelFor, RejectsAGrainOfZero) {
  EXPECT_THROW(parallel_for(1, 0, [](std::size_t, std::size_t) {}), std::invalid_argument);
}

TEST(ThreadLimit, AllowsMoreThreadsThanCores) {
  // Each block waits until all blocks have begun. The deadline only ends a failing test.
  const ThreadLimit limit(8);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  std::atomic<int> present = 0;
  parallel_for(8, 1, [&](std::size_t, std::size_t) {
    ++present;
    while (present < 8 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  });
  EXPECT_LT(std::chrono::steady_clock::now(), deadline);
}

TEST(ThreadLimit, BoundsTheThreadsThatRun) {
  for (const int threads : kThreadCounts) {
    const ThreadLimit limit(threads);
    std::atomic<int> running = 0;
    std::atomic<int> max = 0;
    parallel_for(2000, 1, [&](std::size_t, std::size_t) {
      const int now = ++running;
      for (int seen = max; now > seen && !max.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::yield();
      --running;
    });
    EXPECT_LE(max, threads);
  }
}

TEST(ThreadLimit, EndsWithItsScope) {
  const int before = thread_count();
  EXPECT_GE(before, 1);
  {
    const ThreadLimit outer(3);
    EXPECT_EQ(thread_count(), 3);
    {
      const ThreadLimit inner(8);
      EXPECT_EQ(thread_count(), 8);
      const ThreadLimit all(0);
      EXPECT_EQ(thread_count(), before);
    }
    EXPECT_EQ(thread_count(), 3);
  }
  EXPECT_EQ(thread_count(), before);
}

TEST(ThreadLimit, BoundsLoopsWithinLoops) {
  const ThreadLimit limit(2);
  std::atomic<int> others = 0;
  parallel_for(16, 1, [&](std::size_t, std::size_t) {
    parallel_for(16, 1, [&](std::size_t, std::size_t) { others += thread_count() == 2 ? 0 : 1; });
  });
  EXPECT_EQ(others, 0);
}

TEST(ThreadLimit, MayBeMadeWithinALoop) {
  const ThreadLimit outer(3);
  std::atomic<int> blocks = 0;
  for (int round = 0; round < 50; ++round) {
    parallel_for(16, 1, [&](std::size_t, std::size_t) {
      const ThreadLimit inner(2);
      parallel_for(8, 1, [&](std::size_t, std::size_t) { ++blocks; });
    });
  }
  EXPECT_EQ(blocks, 50 * 16 * 8);
}

TEST(ThreadLimit, IsOfOneThreadOnly) {
  const int before = thread_count();
  std::atomic<int> step = 0;
  int within = 0;
  int after = 0;
  std::thread other([&] {
    std::optional<ThreadLimit> limit(std::in_place, 3);
    step = 1;
    while (step != 2) std::this_thread::yield();
    within = thread_count();
    limit.reset();
    after = thread_count();
  });
  while (step != 1) std::this_thread::yield();
  {
    // Created later and destroyed earlier than the limit of the other thread.
    const ThreadLimit limit(5);
    EXPECT_EQ(thread_count(), 5);
  }
  step = 2;
  other.join();
  EXPECT_EQ(within, 3);
  EXPECT_EQ(after, before);
  EXPECT_EQ(thread_count(), before);
}

TEST(ThreadLimit, RejectsANegativeNumber) { EXPECT_THROW(ThreadLimit(-1), std::invalid_argument); }

}  // namespace meristem::parallel_test

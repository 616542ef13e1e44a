// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/cache.h"

#include <gtest/gtest.h>

namespace meristem::cache_test {

struct Words {
  std::uint64_t size = 1;
  std::uint64_t bytes() const { return size; }
};

struct Numbers {
  std::uint64_t bytes() const { return 1000; }
};

CacheRun run_on(Cache& cache) { return CacheRun(&cache, {typeid(Words), typeid(Numbers)}); }

/// Makes a complete run that uses one result, which it computes if necessary.
std::shared_ptr<const Words> use(Cache& cache, std::uint64_t key) {
  CacheRun run = run_on(cache);
  std::shared_ptr<const Words> words = run.find<const Words>(key);
  run.count<Words>(words != nullptr);
  if (words == nullptr) run.store(key, words = std::make_shared<const Words>());
  run.end();
  return words;
}

TEST(Cache, FindsAResultByItsTypeAndKey) {
  Cache cache;
  const auto first = use(cache, 7);
  EXPECT_EQ(cache.reuse<Words>().made, 1U);
  EXPECT_EQ(use(cache, 7), first);
  EXPECT_EQ(cache.reuse<Words>().made, 0U);
  EXPECT_EQ(cache.reuse<Words>().reused, 1U);
  CacheRun run = run_on(cache);
  EXPECT_EQ(run.find<const Numbers>(7), nullptr);
  EXPECT_EQ(run.find<const Words>(8), nullptr);
  EXPECT_EQ(run.find<const Words>(std::nullopt), nullptr);
}

TEST(Cache, HoldsWhatTheLastRunUsed) {
  Cache cache;
  const auto first = use(cache, 7);
  use(cache, 8);
  EXPECT_EQ(cache.bytes(), 1U);
  EXPECT_NE(use(cache, 7), first);
}

TEST(Cache, ARunLeavesOtherTypesAlone) {
  Cache cache;
  CacheRun run = run_on(cache);
  run.store(1, std::make_shared<const Numbers>());
  run.end();
  CacheRun other(&cache, {typeid(Words)});
  other.store(1, std::make_shared<const Words>());
  other.end();
  EXPECT_EQ(cache.bytes(), 1001U);
}

TEST(Cache, ARunThatFailsLeavesWhatWasThereAndWhatItMadeUntilTheNextHasEnded) {
  Cache cache;
  const auto first = use(cache, 7);
  std::shared_ptr<const Words> second;
  {
    CacheRun failed = run_on(cache);
    failed.store(8, second = std::make_shared<const Words>());
  }
  EXPECT_EQ(cache.bytes(), 2U);
  {
    CacheRun next = run_on(cache);
    EXPECT_EQ(next.find<const Words>(7), first);
    EXPECT_EQ(next.find<const Words>(8), second);
    next.end();
  }
  EXPECT_EQ(cache.bytes(), 2U);
}

TEST(Cache, HoldsWhatAnyRunOfASeriesUsed) {
  Cache cache;
  const auto before = use(cache, 6);
  std::shared_ptr<const Words> first, second;
  {
    CacheSeries series(cache);
    first = use(cache, 7);
    second = use(cache, 8);
    EXPECT_EQ(cache.bytes(), 3U) << "what there was stays until its end";
    series.end();
  }
  EXPECT_EQ(cache.bytes(), 2U);
  {
    CacheSeries series(cache);
    EXPECT_EQ(use(cache, 7), first);
    EXPECT_EQ(use(cache, 8), second);
    EXPECT_EQ(cache.reuse<Words>().reused, 1U) << "of the last run";
    series.end();
  }
  EXPECT_EQ(use(cache, 8), second);
  EXPECT_EQ(cache.bytes(), 1U) << "a run by itself is a series of one";
}

TEST(Cache, ASeriesThatFailsLeavesWhatItMadeUntilTheNextHasEnded) {
  Cache cache;
  const auto before = use(cache, 6);
  {
    const CacheSeries failed(cache);
    use(cache, 7);
    use(cache, 8);
  }
  EXPECT_EQ(cache.bytes(), 3U);
  CacheSeries next(cache);
  use(cache, 8);
  EXPECT_EQ(cache.bytes(), 3U);
  next.end();
  EXPECT_EQ(cache.bytes(), 1U);
}

TEST(Cache, WhatRunsThatFailMakeDoesNotPileUp) {
  Cache cache;
  use(cache, 7);
  for (std::uint64_t key = 100; key < 120; ++key) {
    CacheRun failed = run_on(cache);
    failed.store(key, std::make_shared<const Words>());
  }
  EXPECT_LE(cache.bytes(), 3U);
  EXPECT_EQ((use(cache, 7), cache.reuse<Words>().reused), 1U);
}

TEST(Cache, WithoutOneNothingIsFoundAndNoKeyIsMade) {
  CacheRun run(nullptr, {typeid(Words)});
  int asked = 0;
  const auto make = [&] { return std::uint64_t{1} + static_cast<std::uint64_t>(asked++); };
  EXPECT_EQ(run.key(make), std::nullopt);
  EXPECT_EQ(asked, 0);
  run.store(1, std::make_shared<const Words>());
  EXPECT_EQ(run.find<const Words>(1), nullptr);
  run.count<Words>(true);
  run.end();
}

TEST(Cache, ClearedItHoldsNothing) {
  Cache cache;
  const auto first = use(cache, 7);
  cache.clear();
  EXPECT_EQ(cache.bytes(), 0U);
  EXPECT_NE(use(cache, 7), first);
}

}  // namespace meristem::cache_test

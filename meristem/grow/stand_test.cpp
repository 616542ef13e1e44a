// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace meristem::stand_test {

// Grows for a number of steps and appends its name to the log at each step.
class Counting : public Grower {
 public:
  Counting(char name, int steps, int limit, std::string& log) : name_(name), steps_(steps), limit_(limit), log_(log) {}
  int step_limit() const override { return limit_; }
  bool step(Progress& progress) override {
    progress.check();
    return --steps_ > 0;
  }
  void tell() override { log_ += name_; }
  Skeleton take_skeleton(Progress&) override { return {}; }

 private:
  char name_;
  int steps_;
  int limit_;
  std::string& log_;
};

TEST(Stand, MembersTellInTurnUntilEachIsDone) {
  std::string log;
  Stand stand;
  stand.add(std::make_unique<Counting>('a', 3, 10, log));
  stand.add(std::make_unique<Counting>('b', 1, 10, log));
  stand.add(std::make_unique<Counting>('c', 2, 10, log));
  Progress progress;
  stand.grow(progress);
  EXPECT_EQ(log, "abcaca");
}

// Writes a bar to the log before each round.
class Bars : public StandCommons {
 public:
  void begin_round(Progress&) override { *log += '|'; }
  std::string* log = nullptr;
};

TEST(Stand, BringsItsCommonsUpToDateBeforeEachRound) {
  std::string log;
  Stand stand;
  stand.commons<Bars>().log = &log;
  EXPECT_EQ(&stand.commons<Bars>(), &stand.commons<Bars>());
  stand.add(std::make_unique<Counting>('a', 2, 10, log));
  stand.add(std::make_unique<Counting>('b', 3, 10, log));
  Progress progress;
  stand.grow(progress);
  EXPECT_EQ(log, "|ab|ab|b");
}

TEST(Stand, StopsMembersAtTheirLimits) {
  std::string log;
  Stand stand;
  stand.add(std::make_unique<Counting>('a', 100, 2, log));
  stand.add(std::make_unique<Counting>('b', 100, 0, log));
  Progress progress;
  stand.grow(progress);
  EXPECT_EQ(log, "aa");
}

TEST(Stand, ReportsTheShareOfStepsDoneUpToAll) {
  std::string log;
  Stand stand;
  stand.add(std::make_unique<Counting>('a', 5, 10, log));
  stand.add(std::make_unique<Counting>('b', 10, 10, log));
  std::vector<double> shares;
  Progress progress([&](std::string_view stage, double share) {
    EXPECT_EQ(stage, "growing");
    shares.push_back(share);
  });
  stand.grow(progress);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_DOUBLE_EQ(shares.back(), 1);
}

TEST(Stand, CancelledByItsObserverStopsGrowing) {
  std::string log;
  Stand stand;
  stand.add(std::make_unique<Counting>('a', 1000, 1000, log));
  Progress* asked = nullptr;
  Progress progress([&](std::string_view, double share) {
    if (share >= 0.25) asked->cancel();
  });
  asked = &progress;
  EXPECT_THROW(stand.grow(progress), Cancelled);
  EXPECT_GE(log.size(), 250U);
  EXPECT_LT(log.size(), 300U);
}

TEST(Stand, WithoutMembersIsDoneAtOnce) {
  Stand stand;
  Progress progress;
  stand.grow(progress);
  EXPECT_TRUE(stand.take_skeletons(progress).empty());
}

}  // namespace meristem::stand_test

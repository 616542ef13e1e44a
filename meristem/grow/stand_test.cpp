// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/stand.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace meristem {
namespace {

// Grows for a number of steps and writes its name at each.
class Counting : public Grower {
 public:
  Counting(char name, int steps, int limit, std::string& log) : name_(name), steps_(steps), limit_(limit), log_(log) {}
  int step_limit() const override { return limit_; }
  bool step(Progress& progress) override {
    progress.check();
    log_ += name_;
    return --steps_ > 0;
  }
  Skeleton take_skeleton(Progress&) override { return {}; }

 private:
  char name_;
  int steps_;
  int limit_;
  std::string& log_;
};

using Members = std::vector<std::unique_ptr<Grower>>;

TEST(Stand, MembersStepInTurnUntilEachIsDone) {
  std::string log;
  Members members;
  members.push_back(std::make_unique<Counting>('a', 3, 10, log));
  members.push_back(std::make_unique<Counting>('b', 1, 10, log));
  members.push_back(std::make_unique<Counting>('c', 2, 10, log));
  Progress progress;
  grow_stand(members, progress);
  EXPECT_EQ(log, "abcaca");
}

TEST(Stand, StopsMembersAtTheirLimits) {
  std::string log;
  Members members;
  members.push_back(std::make_unique<Counting>('a', 100, 2, log));
  members.push_back(std::make_unique<Counting>('b', 100, 0, log));
  Progress progress;
  grow_stand(members, progress);
  EXPECT_EQ(log, "aa");
}

TEST(Stand, ReportsTheShareOfStepsDoneUpToAll) {
  std::string log;
  Members members;
  members.push_back(std::make_unique<Counting>('a', 5, 10, log));
  members.push_back(std::make_unique<Counting>('b', 10, 10, log));
  std::vector<double> shares;
  Progress progress([&](std::string_view stage, double share) {
    EXPECT_EQ(stage, "growing");
    shares.push_back(share);
  });
  grow_stand(members, progress);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_DOUBLE_EQ(shares.back(), 1);
}

TEST(Stand, CancelledByItsObserverStopsGrowing) {
  std::string log;
  Members members;
  members.push_back(std::make_unique<Counting>('a', 1000, 1000, log));
  Progress* asked = nullptr;
  Progress progress([&](std::string_view, double share) {
    if (share >= 0.25) asked->cancel();
  });
  asked = &progress;
  EXPECT_THROW(grow_stand(members, progress), Cancelled);
  EXPECT_GE(log.size(), 250U);
  EXPECT_LT(log.size(), 300U);
}

TEST(Stand, WithoutMembersIsDoneAtOnce) {
  Progress progress;
  EXPECT_NO_THROW(grow_stand({}, progress));
}

}  // namespace
}  // namespace meristem

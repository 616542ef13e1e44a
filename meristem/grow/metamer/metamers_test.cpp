// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/metamer/metamers.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/plant/pipe_radii.h"
#include "tests/support/plain_metamers.h"
#include "tests/support/random_metamers.h"

namespace meristem::metamers_test {

Metamers seed() { return {kUp, Vec3(1, 0, 0), RandomKey(1)}; }

/// Grows a chain of metamers, the first from the given bud. Returns the last one.
MetamerIndex grow_chain(Metamers& metamers, MetamerIndex from, bool is_lateral, int count) {
  for (int k = 0; k < count; ++k) from = metamers.grow(from, is_lateral && k == 0, k + 1);
  return from;
}

/// A stem of six metamers, on its second a shoot of three, and on the first of that shoot one of two.
Metamers two_shoots() {
  Metamers metamers = seed();
  grow_chain(metamers, 0, false, 6);
  const MetamerIndex first = metamers.grow(2, true, 7);
  grow_chain(metamers, first, false, 2);
  grow_chain(metamers, first, true, 2);
  return metamers;
}

std::vector<std::uint8_t> marks(const Metamers& metamers, std::initializer_list<MetamerIndex> marked) {
  std::vector<std::uint8_t> gone(metamers.count(), 0);
  for (const MetamerIndex metamer : marked) gone[metamer] = 1;
  return gone;
}

void remove(Metamers& metamers, MetamerIndex metamer, Bud after) {
  auto gone = marks(metamers, {metamer});
  metamers.remove(gone, after);
}

TEST(Metamers, ASeedIsAPlaceWithATerminalBudOnly) {
  const Metamers metamers({0, 0, 1}, {1, 0, 0}, RandomKey(1));
  EXPECT_EQ(metamers.count(), 1U);
  EXPECT_TRUE(metamers.terminal[0].is_open());
  EXPECT_EQ(metamers.lateral[0].state(), Bud::State::dead);
  EXPECT_EQ(metamers.heading(0), Vec3(0, 0, 1));
  EXPECT_EQ(metamers.length(0), 0);
  EXPECT_FALSE(metamers.begins_shoot(0));
}

TEST(Metamers, LateralBudsPointAsideByTheBranchingAngle) {
  Metamers metamers({0, 1, 0}, {1, 0, 0}, RandomKey(1));
  metamers.tip[metamers.grow(0, false, 1)] = {0, 2, 0};
  EXPECT_EQ(metamers.bud_heading(1, false, radians(30)), Vec3(0, 1, 0));
  EXPECT_LT(glm::distance(metamers.bud_heading(1, true, radians(30)), Vec3(0.5F, std::sqrt(0.75F), 0)), 1e-6F);
}

TEST(Metamers, OpenBudsAndDamagedTerminalsCompete) {
  Metamers metamers = seed();
  metamers.grow(0, false, 1);
  EXPECT_FALSE(metamers.competes(0, false));
  EXPECT_FALSE(metamers.competes(0, true));
  for (const bool is_lateral : {false, true}) {
    Bud& bud = bud_of(metamers, 1, is_lateral);
    EXPECT_TRUE(metamers.competes(1, is_lateral));
    bud = Bud::damaged();
    EXPECT_EQ(metamers.competes(1, is_lateral), !is_lateral);
    bud = Bud::dead();
    EXPECT_FALSE(metamers.competes(1, is_lateral));
  }
}

TEST(Metamers, BudsTellTheirStates) {
  for (const auto& [bud, state] :
       {std::pair(Bud(), Bud::State::open), std::pair(Bud::grown(7), Bud::State::grown),
        std::pair(Bud::damaged(), Bud::State::damaged), std::pair(Bud::dead(), Bud::State::dead)}) {
    EXPECT_EQ(bud.state(), state);
    EXPECT_EQ(bud.is_open(), state == Bud::State::open);
    EXPECT_EQ(bud.is_grown(), state == Bud::State::grown);
    EXPECT_EQ(bud.is_damaged(), state == Bud::State::damaged);
  }
  EXPECT_EQ(Bud::grown(7).metamer(), 7U);
}

TEST(Metamers, ShootsAreNamedByTheNumbersWhereTheyBranchOff) {
  const Metamers metamers = two_shoots();
  ASSERT_EQ(metamers.axes.size(), 3U);
  EXPECT_EQ(metamers.name_of(0), "main");
  EXPECT_EQ(metamers.name_of(1), "main.2");
  EXPECT_EQ(metamers.name_of(2), "main.2.1");
  EXPECT_EQ(metamers.shoots_on(0), std::vector<std::string>{"main.2"});
  EXPECT_EQ(metamers.shoots_on(1), std::vector<std::string>{"main.2.1"});
  EXPECT_TRUE(metamers.shoots_on(2).empty());
}

TEST(Metamers, ShootsAreFoundByTheirNames) {
  const Metamers metamers = two_shoots();
  EXPECT_EQ(metamers.find_shoot("main"), 0U);
  EXPECT_EQ(metamers.find_shoot("main.2"), 1U);
  EXPECT_EQ(metamers.find_shoot("main.2.1"), 2U);
  for (const char* none : {"", "mai", "mains", "stem", "main.", "main.2.", "main.0", "main.1", "main.9", "main.2.1.1",
                           "main.-2", "main.+2", "main. 2", "main.2,1", "main.99999999999999999999"}) {
    EXPECT_FALSE(metamers.find_shoot(none)) << none;
  }
}

TEST(Metamers, AreFoundByTheirNumbersOnAnAxis) {
  const Metamers metamers = two_shoots();
  for (std::uint32_t number = 0; number <= 6; ++number) EXPECT_EQ(metamers.find(0, number), number);
  EXPECT_FALSE(metamers.find(0, 7));
  EXPECT_FALSE(metamers.find(1, 0));
  EXPECT_EQ(metamers.find(1, 1), 7U);
  EXPECT_EQ(metamers.find(1, 3), 9U);
  EXPECT_FALSE(metamers.find(1, 4));
}

TEST(Metamers, NamesStayWhenOtherShootsGo) {
  Metamers metamers = seed();
  grow_chain(metamers, 0, false, 8);
  for (const MetamerIndex from : {2U, 5U, 7U}) grow_chain(metamers, from, true, 2);
  grow_chain(metamers, *metamers.find(*metamers.find_shoot("main.5"), 1), true, 3);
  remove(metamers, *metamers.find(*metamers.find_shoot("main.2"), 1), Bud::dead());
  EXPECT_FALSE(metamers.find_shoot("main.2"));
  for (const char* name : {"main", "main.5", "main.5.1", "main.7"}) {
    const auto axis = metamers.find_shoot(name);
    ASSERT_TRUE(axis) << name;
    EXPECT_EQ(metamers.name_of(*axis), name);
  }
  EXPECT_EQ(metamers.shoots_on(0), (std::vector<std::string>{"main.5", "main.7"}));
}

TEST(Metamers, OneIsGivenWithAllThatItBearsNearerOnesFirst) {
  const Metamers metamers = two_shoots();
  EXPECT_EQ(metamers.with_borne(6), (std::vector<MetamerIndex>{6}));
  EXPECT_EQ(metamers.with_borne(7), (std::vector<MetamerIndex>{7, 8, 10, 9, 11}));
  EXPECT_EQ(metamers.with_borne(2), (std::vector<MetamerIndex>{2, 3, 7, 4, 8, 10, 5, 9, 11, 6}));
}

TEST(Metamers, RemovedOnesTakeWhatTheyBearAndLeaveABud) {
  Metamers metamers = two_shoots();
  auto gone = marks(metamers, {7});  // the shoot main.2
  metamers.remove(gone, Bud::damaged());
  EXPECT_EQ(std::ranges::count(gone, 1), 5);
  EXPECT_EQ(metamers.count(), 7U);
  EXPECT_EQ(metamers.axes.size(), 1U);
  EXPECT_TRUE(metamers.lateral[2].is_damaged());
  EXPECT_EQ(metamers.lost_tips[2], 2);
}

TEST(Metamers, ACutAxisEndsWhereItWasCut) {
  Metamers metamers = two_shoots();
  remove(metamers, 4, Bud::damaged());
  EXPECT_EQ(metamers.axes[0].last, 3U);
  EXPECT_TRUE(metamers.terminal[3].is_damaged());
  EXPECT_EQ(metamers.lost_tips[3], 1);
  EXPECT_EQ(metamers.find_shoot("main.2.1"), 2U);
}

RC_GTEST_PROP(Metamers, LostTipsKeepTheCountOfTheWood, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  Metamers metamers = random_metamers(key, 120);
  const double tips = count_tips(metamers.parent, metamers.lost_tips)[0];
  for (std::uint64_t k = 0; k < 8 && metamers.count() > 2; ++k) {
    const auto cut = static_cast<MetamerIndex>(key.child("cut").uniform(k, 1, static_cast<double>(metamers.count())));
    remove(metamers, cut, Bud::damaged());
    RC_ASSERT(count_tips(metamers.parent, metamers.lost_tips)[0] == tips);
  }
}

RC_GTEST_PROP(Metamers, GrowAndGoAsInATreeOfPointers, ()) {
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  const int steps = *rc::gen::inRange(1, 200);
  Metamers metamers = seed();
  PlainMetamers plain;
  for (int step = 1; step <= steps; ++step) {
    const RandomKey draw = key.child(static_cast<std::uint64_t>(step));
    const auto chosen = static_cast<MetamerIndex>(draw.uniform(0, 0, static_cast<double>(metamers.count())));
    if (draw.uniform(1) < 0.9) {
      const bool is_lateral = draw.uniform(2) < 0.4;
      if (!bud_of(metamers, chosen, is_lateral).is_open()) continue;
      plain.grow(metamers.birth[chosen], is_lateral, step);
      metamers.grow(chosen, is_lateral, step);
    } else {
      const Bud after = draw.uniform(2) < 0.5 ? Bud::damaged() : (draw.uniform(3) < 0.7 ? Bud::dead() : Bud());
      std::vector<std::uint8_t> gone(metamers.count(), 0);
      std::vector<int> births;
      for (MetamerIndex metamer = std::max(chosen, 1U); metamer < metamers.count(); metamer += 1 + metamer % 7) {
        if (draw.child("also").uniform(metamer) < 0.8) continue;
        gone[metamer] = 1;
        births.push_back(metamers.birth[metamer]);
      }
      plain.remove(births, after.state());
      metamers.remove(gone, after);
    }
    RC_ASSERT(plain.is_like(metamers));
  }
}

RC_GTEST_PROP(Metamers, NamesOfShootsAreNeverUsedAgain, ()) {
  // For cut buds that do not grow again.
  const RandomKey key(*rc::gen::arbitrary<std::uint64_t>());
  Metamers metamers = seed();
  std::set<std::string> used;
  for (std::uint64_t step = 0; step < 300; ++step) {
    const RandomKey draw = key.child(step);
    const auto chosen = static_cast<MetamerIndex>(draw.uniform(0, 0, static_cast<double>(metamers.count())));
    if (draw.uniform(1) < 0.05 && chosen != 0) {
      remove(metamers, chosen, draw.uniform(2) < 0.5 ? Bud::damaged() : Bud::dead());
    } else if (const bool is_lateral = draw.uniform(2) < 0.4; bud_of(metamers, chosen, is_lateral).is_open()) {
      const MetamerIndex made = metamers.grow(chosen, is_lateral, 1);
      if (is_lateral) RC_ASSERT(used.insert(metamers.name_of(metamers.axis[made])).second);
    }
  }
}

}  // namespace meristem::metamers_test

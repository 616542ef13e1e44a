// SPDX-License-Identifier: Apache-2.0
// The effect of each operation on small trees made by hand.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/grow/prune/choose_shoots.h"
#include "meristem/grow/prune/draw.h"
#include "meristem/grow/prune/layers.h"
#include "meristem/grow/prune/support_line.h"
#include "meristem/grow/prune/work.h"
#include "meristem/grow/prune/work_recorder.h"
#include "meristem/plant/operation_record.h"
#include "meristem/scene/crown/solid_crowns.h"

namespace meristem::prune_test {

/// A vertical stem with one metre per metamer; its lateral buds point to +x and -x alternately.
class HandMade {
 public:
  explicit HandMade(int stem) : metamers(kUp, Vec3(1, 0, 0), RandomKey(1)) { grow(0, false, stem, kUp); }

  /// Grows metamers from a bud. Returns the last one.
  MetamerIndex grow(MetamerIndex from, bool is_lateral, int count, Vec3 way) {
    for (int k = 0; k < count; ++k) {
      const MetamerIndex made = metamers.grow(from, is_lateral && k == 0, 1);
      metamers.tip[made] = metamers.tip[from] + way;
      const Vec3 across = way.y != 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
      metamers.side[made] = metamers.number[made] % 2 == 0 ? across : -across;
      from = made;
    }
    return from;
  }
  MetamerIndex branch(MetamerIndex from, int count, Vec3 way = Vec3(1, 0, 0)) { return grow(from, true, count, way); }
  /// Cuts the stem above a metamer and removes everything there.
  void cut_above(MetamerIndex metamer) {
    std::vector<std::uint8_t> gone(metamers.count(), 0);
    gone[metamers.terminal[metamer].metamer()] = 1;
    metamers.remove(gone, Bud::damaged());
  }

  TreeLeads leads() const { return find_leads(metamers); }
  AxisIndex axis(const char* name) const { return metamers.find_shoot(name).value(); }
  OperationWork work(const TreeOperation& operation) const {
    const TreeLeads found = leads();
    return find_work({metamers, found, flow, radii, 5, RandomKey(7), in_pairs, marks}, operation);
  }
  std::vector<OperationRecord> records(const TreeOperation& operation) const {
    const TreeLeads found = leads();
    std::vector<OperationRecord> told;
    const TreeState state{metamers, found, flow, radii, 5, RandomKey(7)};
    const std::vector<float> radius = pipe_radii(metamers.parent, metamers.lost_tips, radii);
    const auto radius_of = [&](MetamerIndex metamer) { return static_cast<double>(radius[metamer]); };
    for (WorkRecorder::Noted& noted : WorkRecorder(state, operation, 3, radius_of).note(work(operation))) {
      told.push_back(std::move(noted.record));
    }
    return told;
  }
  /// Returns the shoots and numbers of the first metamers that an operation removes, in order.
  std::string taken(const TreeOperation& operation) const {
    std::vector<MetamerIndex> gone = work(operation).gone;
    std::ranges::sort(gone);
    std::string text;
    for (const MetamerIndex metamer : gone) {
      text += (text.empty() ? "" : " ") + metamers.name_of(metamers.axis[metamer]) + ":" +
              std::to_string(metamers.number[metamer]);
    }
    return text;
  }

  Metamers metamers;
  ResourceFlow flow;
  PipeModel radii;
  bool in_pairs = false;
  std::size_t marks = 0;
};

ShootChoice condition(const std::string& text) {
  return {ShootChoice::Kind::condition, text, Expression::compile(text, {shoot_variables(), {}})};
}

template <class What>
TreeOperation operation(ShootChoice shoots, What what) {
  TreeOperation made;
  made.shoots = std::move(shoots);
  made.path = "components.tree.operations[0]";
  made.what = std::move(what);
  return made;
}

CutOperation above(int metamers) {
  CutOperation cut;
  cut.above = metamers;
  return cut;
}

CutOperation to_bud(CutOperation::Toward toward, int window = 0) {
  CutOperation cut;
  cut.place = CutOperation::Place::to_bud;
  cut.toward = toward;
  cut.window = window;
  return cut;
}

TEST(Leads, RanksCountFromTheStem) {
  HandMade tree(4);
  tree.branch(2, 2);
  tree.branch(6, 1, kUp);
  const TreeLeads leads = tree.leads();
  EXPECT_EQ(leads.leader, 0U);
  EXPECT_EQ(leads.rank, (std::vector<std::uint16_t>{0, 1, 2}));
}

TEST(Leads, TheShootAtTheCutLeadsOn) {
  HandMade tree(6);
  tree.branch(2, 3);
  tree.branch(4, 3);
  tree.cut_above(4);
  const TreeLeads leads = tree.leads();
  EXPECT_EQ(leads.leader, tree.axis("main.4"));
  EXPECT_EQ(leads.rank[tree.axis("main.4")], 0);
  EXPECT_EQ(leads.rank[tree.axis("main.2")], 1);
  EXPECT_EQ(lead_path(tree.metamers, leads, 0).size(), 7U);
}

TEST(Leads, WhileTheBudAtTheCutSleepsNobodyLeads) {
  HandMade tree(6);
  tree.branch(2, 3);
  tree.cut_above(4);
  const TreeLeads leads = tree.leads();
  EXPECT_EQ(leads.leader, kNoAxis);
  EXPECT_EQ(leads.rank_of_bud(tree.metamers, 4, true), 0);
  EXPECT_EQ(leads.rank_of_bud(tree.metamers, 3, true), 1);
}

TEST(Leads, WhereNothingIsLeftAtTheCutTheNextBelowLeads) {
  HandMade tree(6);
  tree.branch(2, 3);
  tree.metamers.lateral[4] = Bud::damaged();
  tree.metamers.lateral[3] = Bud::dead();
  tree.cut_above(4);
  EXPECT_EQ(tree.leads().leader, tree.axis("main.2"));
  // This also holds if a successor has lost everything.
  HandMade other(6);
  other.branch(2, 3);
  other.branch(4, 1);
  other.cut_above(4);
  const MetamerIndex end = other.metamers.axes[other.axis("main.4")].last;
  other.metamers.terminal[end] = Bud::damaged();
  other.metamers.lateral[end] = Bud::dead();
  other.metamers.lateral[3] = Bud::dead();
  EXPECT_EQ(other.leads().leader, other.axis("main.2"));
}

TEST(Leads, AShootWithoutHeirsIsNotSucceeded) {
  HandMade tree(6);
  tree.branch(4, 3);
  tree.cut_above(4);
  tree.metamers.axes[0].has_no_heir = true;
  const TreeLeads leads = tree.leads();
  EXPECT_EQ(leads.leader, kNoAxis);
  EXPECT_EQ(leads.rank[tree.axis("main.4")], 1);
}

TEST(Prune, ALabelIsOneShootAndALeaderAllThatLed) {
  HandMade tree(6);
  tree.branch(4, 3);
  tree.cut_above(4);
  EXPECT_EQ(tree.taken(operation(ShootChoice::leader(), above(5))), "main.4:2");
  EXPECT_EQ(tree.taken(operation(ShootChoice::label("main.4"), above(2))), "main.4:3");
  EXPECT_EQ(tree.taken(operation(ShootChoice::label("main"), above(3))), "main:4");
}

TEST(Prune, AConditionFindsShootsByWhatTheyAre) {
  HandMade tree(6);
  tree.branch(2, 4);
  tree.branch(4, 1, Vec3(0, 0, -1));
  tree.metamers.axes[tree.axis("main.4")].marks = 1;
  const auto found = [&](const char* text) { return tree.taken(operation(condition(text), above(0))); };
  EXPECT_EQ(found("rank == 1 && length > 2"), "main.2:1");
  EXPECT_EQ(found("rank == 1 && length < 2"), "main.4:1");
  EXPECT_EQ(found("rank == 1 && abs(azimuth - 90) < 1"), "main.2:1");
  EXPECT_EQ(found("rank == 1 && azimuth < 1"), "main.4:1");
  EXPECT_EQ(found("marked"), "main.4:1");
  EXPECT_EQ(found("rank == 1 && height > 3"), "main.4:1");
  EXPECT_EQ(found("rank == 1 && inclination > 10"), "");
  EXPECT_EQ(found("rank == 1 && age == 4 && radius > 0 && light == 0 && resource == 0 && inward == 0"),
            "main.2:1 main.4:1");
  // The middles of the branches are at (3, 2, 0) and (0, 4, -1), the middle of the stem at (0, 4, 0).
  EXPECT_EQ(found("rank == 1 && clearance < 1.5"), "main.4:1");
}

TEST(Prune, ATreeWithoutShootsHasNoneToChoose) {
  const HandMade seed(0);
  EXPECT_EQ(seed.taken(operation(condition("rank == 0 && clearance > 1"), above(1))), "");
  EXPECT_EQ(seed.taken(operation(ShootChoice::leader(), to_bud(CutOperation::Toward::up))), "");
  EXPECT_EQ(seed.taken(operation(ShootChoice::leader(), LayersOperation{})), "");
}

TEST(Prune, ACutMovesDownToALivingBud) {
  HandMade tree(6);
  tree.metamers.lateral[4] = Bud::damaged();
  tree.metamers.lateral[3] = Bud::dead();
  EXPECT_EQ(tree.taken(operation(ShootChoice::leader(), above(5))), "main:6");
  EXPECT_EQ(tree.taken(operation(ShootChoice::leader(), above(4))), "main:3");
  EXPECT_EQ(tree.taken(operation(ShootChoice::leader(), above(6))), "");
  EXPECT_EQ(tree.taken(operation(condition("rank == 0"), above(0))), "") << "something must stay";
}

TEST(Prune, ACutKeepsPairsWhole) {
  HandMade tree(6);
  tree.in_pairs = true;
  EXPECT_EQ(tree.taken(operation(ShootChoice::leader(), above(3))), "main:5");
  EXPECT_EQ(tree.taken(operation(ShootChoice::leader(), above(4))), "main:5");
}

TEST(Prune, ACutAboveALateralCountsThemFromTheBase) {
  HandMade tree(8);
  for (const MetamerIndex at : {2U, 4U, 5U}) tree.branch(at, 2);
  CutOperation cut;
  cut.place = CutOperation::Place::above_lateral;
  const auto taken = [&](const char* number) {
    cut.lateral = Expression::compile(number, {});
    return tree.taken(operation(ShootChoice::leader(), cut));
  };
  EXPECT_EQ(taken("1"), "main:3");
  EXPECT_EQ(taken("3"), "main:6");
  EXPECT_EQ(taken("4"), "");
  cut.lateral = Expression::compile("4", {});
  EXPECT_THROW(tree.taken(operation(ShootChoice::label("main"), cut)), InputError);
}

TEST(Prune, ACutToABudTakesTheNearestToTheMiddleThatFacesThere) {
  HandMade tree(3);
  tree.branch(3, 9);
  const auto taken = [&](const CutOperation& cut) { return tree.taken(operation(condition("rank == 1"), cut)); };
  // Buds with odd numbers face down; the middle is the fifth.
  EXPECT_EQ(taken(to_bud(CutOperation::Toward::down)), "main.3:6");
  EXPECT_EQ(taken(to_bud(CutOperation::Toward::up)), "main.3:7");
  const MetamerIndex fifth = tree.metamers.find(1, 5).value();
  tree.metamers.lateral[fifth] = Bud::damaged();
  EXPECT_EQ(taken(to_bud(CutOperation::Toward::down)), "main.3:8");
  // Within a window, the best-facing bud is chosen.
  tree.metamers.side[tree.metamers.find(1, 7).value()] = Vec3(0, -0.6F, 0.8F);
  EXPECT_EQ(taken(to_bud(CutOperation::Toward::down, 2)), "main.3:4");
}

TEST(Prune, ACutOutsideABodyFollowsItsSurface) {
  HandMade tree(6);
  tree.branch(2, 4);
  tree.branch(3, 1);
  CutOperation cut;
  cut.place = CutOperation::Place::outside;
  cut.outside = std::make_shared<BoxCrown>(Box{Vec3(-2.5F, -1, -1), Vec3(2.5F, 4.5F, 1)});
  EXPECT_EQ(tree.taken(operation(condition("rank >= 0"), cut)), "main:5 main.2:3");
  // Pairs are removed completely, also the last pair of a shoot.
  tree.in_pairs = true;
  cut.outside = std::make_shared<BoxCrown>(Box{Vec3(-9, -1, -1), Vec3(9, 5.5F, 1)});
  EXPECT_EQ(tree.taken(operation(condition("rank >= 0"), cut)), "main:5");
}

TEST(Prune, SpursKeepSoManyMetamersAndNoBranches) {
  HandMade tree(3);
  tree.branch(2, 4);
  tree.branch(4, 3, kUp);
  tree.branch(8, 1);
  const TreeOperation rule = operation(condition("rank >= 2"), SpurOperation{2});
  EXPECT_EQ(tree.taken(rule), "main.2.1:3 main.2.1.1:1");
  EXPECT_TRUE(tree.work(rule).renews);
}

TEST(Prune, ALimitHoldsOverSuccessions) {
  HandMade tree(6);
  tree.branch(4, 3);
  tree.cut_above(4);
  EXPECT_EQ(tree.taken(operation(condition("rank == 0"), LimitOperation{5})), "main.4:2");
  EXPECT_EQ(tree.taken(operation(condition("rank == 0"), LimitOperation{7})), "");
}

TEST(Prune, ALimitShortensTheLateralThatTakesTheLead) {
  // A stem of 8 with a lateral of 3 at the fifth metamer: cut to 5, the lateral would make it 8 again.
  HandMade tree(8);
  tree.branch(5, 3);
  EXPECT_EQ(tree.taken(operation(condition("rank == 0"), LimitOperation{5})), "main:6 main.5:1");
  EXPECT_EQ(tree.taken(operation(condition("rank == 0"), LimitOperation{4})), "main:5");
  // Without a living bud at the cut, the stem is cut above the next one, which may grow no longer either.
  tree.metamers.lateral[6] = Bud::dead();
  EXPECT_EQ(tree.taken(operation(condition("rank == 0"), LimitOperation{6})), "main:6 main.5:2");
}

TEST(Prune, LayersKeepTwoArmsAndALeader) {
  HandMade tree(8);
  for (const MetamerIndex at : {1U, 3U, 4U, 5U}) tree.branch(at, 2);
  const TreeOperation rule = operation(ShootChoice::leader(), LayersOperation{.count = 2});
  EXPECT_EQ(tree.taken(rule), "main:7 main.1:1 main.3:1");
  const std::vector<ArmBud> arms = find_arms(tree.metamers, tree.leads(), {});
  ASSERT_EQ(arms.size(), 2U);
  EXPECT_EQ(arms[0].metamer, 4U);
  EXPECT_EQ(arms[1].wire, 1U);
  const auto wires = arm_wires({.count = 2}, 0.5);
  ASSERT_EQ(wires.size(), 4U);
  EXPECT_FLOAT_EQ(wires[2][0].y, 5.25F);
  EXPECT_LT(wires[2][1].x, 0);
  EXPECT_GT(wires[3][1].x, 0);
}

TEST(Prune, TheTopLayerEndsTheLeader) {
  HandMade tree(6);
  const OperationWork work = tree.work(operation(ShootChoice::leader(), LayersOperation{.count = 1}));
  EXPECT_EQ(work.pinched, std::vector<MetamerIndex>{6});
  EXPECT_EQ(work.lifted, std::vector<MetamerIndex>{6});
  EXPECT_EQ(work.headless, std::vector<AxisIndex>{0});
}

TEST(Prune, RingsStandWhereTheyAreAskedFor) {
  HandMade tree(3);
  tree.branch(2, 4);
  tree.branch(3, 1);
  const std::vector<Ring> rings = tree.work(operation(condition("rank == 1"), GirdleOperation{1, 0.5, 3})).rings;
  ASSERT_EQ(rings.size(), 1U) << "the short shoot has nothing above a metamer";
  EXPECT_EQ(rings[0].metamer, tree.metamers.find(tree.axis("main.2"), 2));
  EXPECT_EQ(rings[0].share, 0.5);
  EXPECT_EQ(rings[0].iterations, 3);
  const auto named = [&](int below) {
    return tree.work(operation(ShootChoice::label("main.3"), GirdleOperation{below}));
  };
  EXPECT_EQ(named(0).rings.size(), 1U);
  try {
    named(1);
    ADD_FAILURE() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.operations[0].below");
    EXPECT_EQ(error.diagnostics()[0].message, "'main.3' has 1 metamers, and none above that");
  }
}

TEST(Prune, ABendGoesOverItsMetamers) {
  HandMade tree(3);
  tree.branch(2, 6);
  const std::vector<Bow> bows = tree.work(operation(condition("rank == 1"), BendOperation{1, 3, -0.5, 4})).bows;
  ASSERT_EQ(bows.size(), 1U);
  const AxisIndex axis = tree.axis("main.2");
  EXPECT_EQ(bows[0].first, tree.metamers.find(axis, 2));
  EXPECT_EQ(bows[0].last, tree.metamers.find(axis, 4));
  EXPECT_EQ(bows[0].tip, tree.metamers.find(axis, 6));
  EXPECT_EQ(bows[0].iterations, 4);
  // It ends at the end of the shoot.
  EXPECT_EQ(tree.work(operation(condition("rank == 1"), BendOperation{1, 9})).bows[0].last, bows[0].tip);
}

TEST(Prune, ThickWoodDoesNotBend) {
  HandMade tree(3);
  tree.branch(2, 6);
  tree.radii.tip_radius = 2;
  const BendOperation down{0, 1, -kPi / 2, 1};
  EXPECT_TRUE(tree.work(operation(condition("rank == 1"), down)).bows.empty());
  try {
    tree.work(operation(ShootChoice::label("main.2"), down));
    ADD_FAILURE() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics()[0].path, "components.tree.operations[0].metamers");
    EXPECT_NE(error.diagnostics()[0].message.find("radius of 2 m"), std::string::npos);
  }
  EXPECT_EQ(tree.work(operation(ShootChoice::label("main.2"), BendOperation{0, 4, -kPi / 2})).bows.size(), 1U);
}

TEST(Prune, MarksAreByChance) {
  HandMade tree(60);
  for (MetamerIndex at = 1; at <= 50; ++at) tree.branch(at, 1);
  const auto marked = [&](double chance) {
    return tree.work(operation(condition("rank == 1"), MarkOperation{chance})).marked;
  };
  EXPECT_EQ(marked(1).size(), 50U);
  EXPECT_EQ(marked(0).size(), 0U);
  EXPECT_NEAR(static_cast<double>(marked(0.5).size()), 25, 14);  // four standard deviations
}

TEST(Prune, ConditionsKnowMarksByTheirWords) {
  HandMade tree(6);
  for (const MetamerIndex at : {2U, 3U, 4U}) tree.branch(at, 1);
  tree.marks = 2;
  tree.metamers.axes[tree.axis("main.2")].marks = 1;
  tree.metamers.axes[tree.axis("main.3")].marks = 2;
  std::vector<std::string> names = shoot_variables();
  names.insert(names.end(), {"dead", "diseased"});
  const auto found = [&](const std::string& text) {
    return tree.taken(
        operation({ShootChoice::Kind::condition, text, Expression::compile(text, {names, {}})}, above(0)));
  };
  EXPECT_EQ(found("dead"), "main.2:1");
  EXPECT_EQ(found("diseased"), "main.3:1");
  EXPECT_EQ(found("marked"), "main.2:1 main.3:1");
  EXPECT_EQ(found("rank == 1 && !dead && !diseased"), "main.4:1");
  const OperationWork marked = tree.work(operation(condition("rank == 1"), MarkOperation{1, 5}));
  EXPECT_EQ(marked.mark, 5U);
  EXPECT_EQ(marked.marked.size(), 3U);
}

TEST(Prune, AStringDrawsShootsToTheGroundOrToEachOther) {
  HandMade tree(6);
  tree.branch(3, 4);
  tree.branch(5, 4);
  const std::vector<Bow> down = tree.work(operation(ShootChoice::label("main.3"), TieOperation{.length = 0.5})).bows;
  ASSERT_EQ(down.size(), 1U);
  const AxisIndex lower = tree.axis("main.3");
  EXPECT_EQ(down[0].first, tree.metamers.find(lower, 1));
  EXPECT_EQ(down[0].last, tree.metamers.find(lower, 4));
  EXPECT_EQ(down[0].toward, Vec3(4, 0, 0));
  EXPECT_EQ(down[0].gap, 0.5);
  // Tied lower down, to the nearest point of another shoot.
  const TreeOperation other =
      operation(ShootChoice::label("main.5"), TieOperation{.below = 2, .to = ShootChoice::label("main.3")});
  const std::vector<Bow> together = tree.work(other).bows;
  ASSERT_EQ(together.size(), 1U);
  EXPECT_EQ(together[0].last, tree.metamers.find(tree.axis("main.5"), 2));
  EXPECT_EQ(together[0].tip, tree.metamers.find(tree.axis("main.5"), 4));
  EXPECT_EQ(together[0].toward, Vec3(2, 3, 0));
  // Neither the stem, nor a shoot to itself.
  EXPECT_TRUE(tree.work(operation(condition("rank == 0"), TieOperation{})).bows.empty());
  const TreeOperation itself =
      operation(ShootChoice::label("main.5"), TieOperation{.to = ShootChoice::label("main.5")});
  EXPECT_TRUE(tree.work(itself).bows.empty());
  EXPECT_THROW(tree.work(operation(ShootChoice::label("main.5"), TieOperation{.to = ShootChoice::label("main.9")})),
               InputError);
  EXPECT_THROW(tree.work(operation(ShootChoice::label("main.5"), TieOperation{.below = 5})), InputError);
}

TEST(Prune, ThickWoodIsNotDrawn) {
  HandMade tree(6);
  tree.branch(3, 4);
  tree.radii.tip_radius = 9;
  EXPECT_TRUE(tree.work(operation(condition("rank == 1"), TieOperation{})).bows.empty());
  EXPECT_THROW(tree.work(operation(ShootChoice::label("main.3"), TieOperation{})), InputError);
}

TEST(Draw, BringsTheEndAsNearAsItIsAsked) {
  const std::vector<Vec3> level{Vec3(0, 2, 0), Vec3(1, 2, 0), Vec3(2, 2, 0), Vec3(3, 2, 0)};
  const auto end = [&](const Draw& draw) {
    Vec3 at = level[0];
    for (int k = 1; k <= 3; ++k) {
      at += rotation(draw.axis, draw.angle * k / 3) *
            (level[static_cast<std::size_t>(k)] - level[static_cast<std::size_t>(k - 1)]);
    }
    return at;
  };
  for (const double gap : {1.5, 1.0, 0.7}) {
    EXPECT_NEAR(glm::distance(end(draw_toward(level, Vec3(3, 0, 0), gap)), Vec3(3, 0, 0)), gap, 1e-3);
  }
  EXPECT_EQ(draw_toward(level, Vec3(3, 0, 0), 2.5).angle, 0) << "near enough";
  EXPECT_EQ(draw_toward(level, Vec3(9, 2, 0), 0).angle, 0) << "on its own line";
  // If the target is out of reach, no other angle brings the end nearer.
  const Draw max = draw_toward(level, Vec3(3, -9, 0), 0);
  const float nearest = glm::distance(end(max), Vec3(3, -9, 0));
  for (const double turn : {-0.1, 0.1}) {
    EXPECT_LE(nearest, glm::distance(end({max.axis, max.angle + turn}), Vec3(3, -9, 0)));
  }
}

TEST(WorkRecorder, TellsWhereACutIsAndWhatItTakes) {
  HandMade tree(6);
  tree.branch(3, 4);
  tree.branch(9, 2, Vec3(0, 1, 0));
  tree.radii = {.tip_radius = 0.1, .exponent = 2};
  tree.flow.light.assign(tree.metamers.count(), 0);
  tree.flow.light[*tree.metamers.find(tree.axis("main.3"), 3)] = 2.5;
  const std::vector<OperationRecord> records = tree.records(operation(ShootChoice::label("main.3"), above(2)));
  ASSERT_EQ(records.size(), 1U);
  const OperationRecord& cut = records[0];
  EXPECT_EQ(cut.operation, "components.tree.operations[0]");
  EXPECT_EQ(cut.act, "cut");
  EXPECT_EQ(cut.iteration, 5);
  EXPECT_EQ(cut.tree, 3U);
  EXPECT_EQ(cut.shoot, "main.3");
  EXPECT_EQ(cut.rank, 1);
  EXPECT_EQ(cut.metamer, 2U);
  EXPECT_EQ(cut.position, Vec3(2, 3, 0));
  EXPECT_EQ(cut.bud, Vec3(0, 1, 0));
  // The bud is on the bark of the second metamer, and the cut goes through the third: both bear two tips.
  const double radius = 0.1 * std::sqrt(2);
  EXPECT_NEAR(cut.bud_position.y, 3 + radius, 1e-6);
  EXPECT_NEAR(cut.diameter, 2 * radius, 1e-6);
  EXPECT_EQ(cut.metamers, 4U) << "two of the branch and the two that stand on it";
  EXPECT_DOUBLE_EQ(cut.length, 4);
  // By da Vinci's rule, the third metamer has the cross-section of the two tips beyond it.
  EXPECT_NEAR(cut.wood, kPi * 0.01 * (2 + 1 + 1 + 1), 1e-7);
  EXPECT_EQ(cut.light, 2.5);
}

TEST(WorkRecorder, TellsAWholeShootByItsOwnName) {
  HandMade tree(6);
  tree.branch(3, 4);
  const std::vector<OperationRecord> records = tree.records(operation(condition("rank == 1"), above(0)));
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].shoot, "main.3");
  EXPECT_EQ(records[0].metamer, 0U);
  EXPECT_EQ(records[0].position, Vec3(0, 3, 0));
  EXPECT_EQ(records[0].bud, Vec3(0));
  EXPECT_EQ(records[0].bud_position, records[0].position);
}

TEST(WorkRecorder, TellsNothingTwice) {
  HandMade tree(6);
  tree.branch(3, 4);
  tree.branch(8, 2, Vec3(0, 1, 0));
  std::uint32_t metamers = 0;
  for (const OperationRecord& record : tree.records(operation(condition("rank >= 1"), above(0)))) {
    metamers += record.metamers;
  }
  EXPECT_EQ(metamers, 6U);
}

TEST(WorkRecorder, TellsWhatElseIsDone) {
  HandMade tree(6);
  tree.branch(3, 4);
  const auto acts = [&](const TreeOperation& operation) {
    std::string all;
    for (const OperationRecord& record : tree.records(operation)) all += record.act + " " + record.shoot + " ";
    return all;
  };
  EXPECT_EQ(acts(operation(condition("rank == 1"), GirdleOperation{1})), "ring main.3 ");
  EXPECT_EQ(acts(operation(condition("rank == 1"), BendOperation{})), "bend main.3 ");
  EXPECT_EQ(acts(operation(condition("rank == 1"), TieOperation{})), "tie main.3 ");
  EXPECT_EQ(acts(operation(condition("rank == 1"), MarkOperation{})), "mark main.3 ");
  EXPECT_EQ(acts(operation(ShootChoice::leader(), LayersOperation{.count = 1})), "disbud main disbud main cut main.3 ");
}

TEST(Prune, ASchedulesConditionSeesTheTree) {
  HandMade tree(6);
  tree.branch(2, 3);
  const TreeLeads leads = tree.leads();
  const TreeState state{tree.metamers, leads, tree.flow, tree.radii, 5, RandomKey(7)};
  const auto met = [&](const char* text) {
    OperationSchedule when;
    when.when = Expression::compile(text, {tree_variables(), {}});
    return holds(state, when);
  };
  EXPECT_TRUE(met("iteration == 5 && height == 6 && width == 3 && metamers == 9 && laterals == 1"));
  EXPECT_TRUE(met("leader_length == 6"));
  EXPECT_FALSE(met("height > 6"));
  for (const char* const no_answer : {"1 / 0", "-1 / 0", "0 / 0"}) EXPECT_FALSE(met(no_answer)) << no_answer;
  EXPECT_TRUE((OperationSchedule{3, 4, 12}.is_in_turn(11)));
  EXPECT_FALSE((OperationSchedule{3, 4, 12}.is_in_turn(12)));
  EXPECT_FALSE((OperationSchedule{3, 4, 10}.is_in_turn(11)));
}

TEST(SupportLine, LeadsBackToItsPole) {
  const std::vector<Vec3> pole{Vec3(0), Vec3(0, 2, 0)};
  EXPECT_LT(glm::distance(way_along(pole, Vec3(0, 1, 0), 1), kUp), 1e-6F);
  EXPECT_LT(glm::distance(way_along(pole, Vec3(1, 0.5F, 0), 1), glm::normalize(Vec3(-1, 1, 0))), 1e-6F);
  // The line continues beyond its end and around its corners.
  EXPECT_LT(glm::distance(way_along(pole, Vec3(0, 9, 0), 1), kUp), 1e-6F);
  const std::vector<Vec3> bent{Vec3(0), Vec3(0, 2, 0), Vec3(5, 2, 0)};
  EXPECT_LT(glm::distance(way_along(bent, Vec3(0, 1, 0), 2), glm::normalize(Vec3(1, 1, 0))), 1e-6F);
}

}  // namespace meristem::prune_test

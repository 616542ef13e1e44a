// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/phiball.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::phiball_test {

GraphBuilder ball_of(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("ball", "phiball", parameters).component("seed", "simple");
  return builder.link("view", "ball").link("ball", "seed");
}

std::vector<Organ> seeds(const Value::Object& parameters) { return organs_of(ball_of(parameters).grow(), "seed"); }

/// Returns the distance from each child to the nearest other child.
std::vector<double> gaps(const std::vector<Organ>& organs) {
  std::vector<double> nearest;
  for (const Organ& one : organs) {
    double best = std::numeric_limits<double>::infinity();
    for (const Organ& other : organs) {
      if (&one != &other) best = std::min(best, double{glm::distance(one.frame.origin, other.frame.origin)});
    }
    nearest.push_back(best);
  }
  return nearest;
}

TEST(Phiball, StandsOnTheSphereHeadingOutwardWithinItsZone) {
  const std::vector<Organ> organs = seeds({{"number", 300}, {"radius", 2}, {"theta1", 30}, {"theta2", 120}});
  ASSERT_EQ(organs.size(), 300U);
  for (std::size_t k = 0; k < organs.size(); ++k) {
    const Frame& frame = organs[k].frame;
    EXPECT_NEAR(glm::length(frame.origin), 2, 1e-5);
    EXPECT_LT(glm::distance(glm::normalize(frame.heading()), 0.5F * frame.origin), 1e-5F);
    EXPECT_GT(frame.upper().y, 0);
    // Equal areas give equal steps in height.
    const double top = std::cos(radians(30)), bottom = std::cos(radians(120));
    EXPECT_NEAR(frame.origin.y / 2, top - (static_cast<double>(k) + 0.5) / 300 * (top - bottom), 1e-5);
  }
}

TEST(Phiball, SuccessiveChildrenTurnByTheGoldenAngle) {
  const std::vector<Organ> organs = seeds({{"number", 5000}, {"radius", 1}});
  const auto azimuth = [&](std::size_t k) {
    return degrees(std::atan2(organs[k].frame.origin.z, organs[k].frame.origin.x));
  };
  for (const std::size_t k : {1U, 100U, 2500U, 4900U}) {
    const double turn = std::remainder(azimuth(k) - azimuth(k - 1), 360);
    EXPECT_NEAR(std::abs(turn), 137.508, 0.05) << k;
  }
}

TEST(Phiball, NeighboursKeepTheDistanceOfAnEqualAreaPacking) {
  // In a hexagonal packing of equal area, the distance of neighbours would be sqrt(2 A / sqrt(3)).
  for (const double theta2 : {20.0, 90.0, 180.0}) {
    const double area = 1e-3;
    const std::vector<Organ> organs = seeds({{"number", 800}, {"area", area}, {"theta2", theta2}});
    const std::vector<double> nearest = gaps(organs);
    double sum = 0, squares = 0;
    for (const double gap : nearest) {
      sum += gap;
      squares += gap * gap;
    }
    const double mean = sum / static_cast<double>(nearest.size());
    const double variance = squares / static_cast<double>(nearest.size()) - mean * mean;
    EXPECT_LT(variance / (mean * mean), 0.02) << theta2;
    EXPECT_GT(mean / std::sqrt(2 * area / std::sqrt(3)), 0.8) << theta2;
    EXPECT_LT(mean / std::sqrt(2 * area / std::sqrt(3)), 1) << theta2;
  }
}

TEST(Phiball, AreasOfOneToFourGiveDensitiesOfFourToOne) {
  // 400 children of size 1, then 400 of size 2: they take 1/5 and 4/5 of the sphere.
  const std::vector<Organ> organs = seeds({{"number", 800}, {"radius", 1}, {"size", "i < 400 ? 1 : 2"}});
  const double border = 1 - 2.0 / 5;  // height of the border between the two
  for (std::size_t k = 0; k < 800; ++k) EXPECT_EQ(organs[k].frame.origin.y > border, k < 400);
  const std::vector<double> nearest = gaps(organs);
  double small = 0, large = 0;
  for (std::size_t k = 50; k < 350; ++k) small += nearest[k];
  for (std::size_t k = 450; k < 750; ++k) large += nearest[k];
  EXPECT_NEAR(large / small, 2, 0.1);
}

TEST(Phiball, AreasGiveTheRadius) {
  const std::vector<Organ> organs = seeds({{"number", 100}, {"area", 0.01}, {"theta2", 90}, {"size", 2}});
  // 100 * 0.01 * 4 = 2 pi R^2.
  EXPECT_NEAR(glm::length(organs[0].frame.origin), std::sqrt(4 / (2 * kPi)), 1e-5);
}

TEST(Phiball, ThePoleOfALargeSphereIsAFlatHead) {
  const std::vector<Organ> organs =
      seeds({{"number", 200}, {"radius", 10}, {"theta2", 1}, {"pole", true}, {"roll", 40}});
  for (const Organ& organ : organs) {
    EXPECT_LE(organ.frame.origin.y, 0);
    EXPECT_GT(organ.frame.origin.y, -10 * (1 - std::cos(radians(1.001))));
    EXPECT_LT(glm::length(organ.frame.origin), 10 * std::sin(radians(1.001)));
  }
}

TEST(Phiball, ChildrenOfNoSizeTakeNoPlace) {
  EXPECT_TRUE(seeds({{"number", 40}, {"size", 0}}).empty());
  EXPECT_TRUE(seeds({{"number", 0}}).empty());
  EXPECT_EQ(seeds({{"number", 40}, {"size", "i % 2"}}).size(), 20U);
}

TEST(Phiball, FaultsAreLocated) {
  const auto error = [](const Value::Object& parameters) {
    const std::vector<Diagnostic> errors = errors_of([&] { ball_of(parameters).grow(); });
    return errors.size() == 1 ? errors[0].path : std::to_string(errors.size()) + " faults";
  };
  EXPECT_EQ(error({{"theta1", 90}, {"theta2", 90}}), "components.ball.theta1");
  EXPECT_EQ(error({{"theta1", "90 + i"}, {"theta2", 90}}), "components.ball.theta1");
  EXPECT_EQ(error({{"radius", 1}, {"area", 1}}), "components.ball.area");
  EXPECT_EQ(error({{"area", 0}}), "components.ball.area");
  EXPECT_EQ(error({{"size", "1/(i - 3)"}}), "components.ball.size");
  EXPECT_EQ(error({{"number", 2e9}}), "components.seed");  // the component with the largest share
}

}  // namespace meristem::phiball_test

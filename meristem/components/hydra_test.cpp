// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/hydra.h"

#include <set>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::hydra_test {

std::vector<Organ> rays(const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("star", "hydra", parameters).component("ray", "simple");
  return organs_of(builder.link("view", "star").link("star", "ray").grow(), "ray");
}

TEST(Hydra, SpreadsItsChildrenEvenlyAboutItsHeading) {
  const std::vector<Organ> organs = rays({{"number", 5}, {"angle", 60}, {"radius", 0.5}});
  ASSERT_EQ(organs.size(), 5U);
  Vec3 sum(0);
  for (std::size_t k = 0; k < organs.size(); ++k) {
    const Vec3 heading = glm::normalize(organs[k].frame.heading());
    EXPECT_NEAR(heading.y, 0.5F, 1e-5F);
    EXPECT_LT(glm::distance(organs[k].frame.origin, 0.5F * heading), 1e-5F);
    EXPECT_GT(organs[k].frame.upper().y, 0);  // upper faces look in the star's heading
    const Vec3 next = glm::normalize(organs[(k + 1) % 5].frame.heading());
    EXPECT_NEAR(glm::dot(heading - Vec3(0, 0.5F, 0), next - Vec3(0, 0.5F, 0)), 0.75F * std::cos(radians(72)), 1e-5F);
    sum += heading;
  }
  EXPECT_LT(glm::distance(sum, Vec3(0, 2.5F, 0)), 1e-5F);
}

TEST(Hydra, AnArcBelowAFullTurnIsAFanWithChildrenAtBothEnds) {
  const std::vector<Organ> organs = rays({{"number", 3}, {"arc", 180}});
  ASSERT_EQ(organs.size(), 3U);
  EXPECT_LT(glm::distance(glm::normalize(organs[0].frame.heading()), -glm::normalize(organs[2].frame.heading())),
            1e-5F);
  EXPECT_LT(glm::distance(glm::normalize(organs[1].frame.heading()), Vec3(0, 0, -1)), 1e-5F);
}

TEST(Hydra, NumbersDifferPerChild) {
  const Value::List tilt{0, 80};
  const std::vector<Organ> organs =
      rays({{"number", 5}, {"angle", tilt}, {"size", "1 + i"}, {"radius", "0.1*n"}, {"roll", "-72*i"}});
  ASSERT_EQ(organs.size(), 5U);
  const float scale = glm::length(organs[0].frame.heading());
  for (std::size_t k = 0; k < 5; ++k) {
    const Vec3 heading = glm::normalize(organs[k].frame.heading());
    EXPECT_NEAR(degrees(std::acos(heading.y)), 20.0 * static_cast<double>(k), 0.05);
    EXPECT_NEAR(glm::length(organs[k].frame.heading()) / scale, static_cast<float>(k + 1), 1e-5F);
    EXPECT_NEAR(glm::length(organs[k].frame.origin), 0.5F, 1e-6F);
    EXPECT_NEAR(heading.x, 0, 1e-5F);  // the roll cancels the even rotation
  }
}

TEST(Hydra, ARandomNumberIsEachChildsOwn) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("stars", "hydra", {{"number", 2}, {"radius", 1}});
  builder.component("star", "hydra", {{"number", 3}, {"size", "rand(0.5, 1)"}}).component("ray", "simple");
  const auto organs = organs_of(builder.link("view", "stars").link("stars", "star").link("star", "ray").grow(), "ray");
  std::set<float> sizes;
  for (const Organ& organ : organs) sizes.insert(glm::length(organ.frame.heading()));
  EXPECT_EQ(sizes.size(), 6U);
}

TEST(Hydra, FaultsInAPerChildNumberAreLocated) {
  const auto error = [](const Value& angle) {
    const std::vector<Diagnostic> errors = errors_of([&] { rays({{"angle", angle}}); });
    return errors.size() == 1 ? errors[0].text() : std::to_string(errors.size()) + " faults";
  };
  EXPECT_NE(error("angel").find("components.star.angle: "), std::string::npos) << error("angel");
  EXPECT_NE(error(200).find("components.star.angle: the value 200 is out of range"), std::string::npos);
  EXPECT_NE(error("190").find("components.star.angle: the expression's value 190"), std::string::npos) << error("190");
  EXPECT_NE(error(Value::List{1, 2, 3}).find("a list of 3"), std::string::npos);
  EXPECT_NE(error("log(-i)").find("components.star.angle: the expression 'log(-i)' gives"), std::string::npos)
      << error("log(-i)");
}

TEST(Hydra, AThousandMillionChildrenAreStopped) {
  const std::vector<Diagnostic> errors = errors_of([] { rays({{"number", 1e9}}); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].text(),
            "components.ray: 1e+09 instances, of which ray 1e+09 (100 %), are too many; expected at most 20000000 "
            "(limits.instances)");
}

TEST(Hydra, TheProductThatExplodedIsNamed) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("stars", "hydra", {{"number", 30}});
  builder.component("star", "hydra", {{"number", 3000}}).component("ray", "simple");
  builder.instance_limit(20000).link("view", "stars").link("stars", "star").link("star", "ray");
  const std::vector<Diagnostic> errors = errors_of([&] { builder.grow(); });
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].text(),
            "components.ray: 90032 instances, of which ray 90000 (100 %), are too many; expected at most 20000 "
            "(limits.instances)");
}

TEST(Hydra, WithoutANumberHasNoChildren) {
  EXPECT_TRUE(rays({{"number", 0}}).empty());
  EXPECT_TRUE(rays({{"number", 0}, {"angle", "40 + 10 * rand()"}, {"radius", Value::List{0, 1}}}).empty());
}

}  // namespace meristem::hydra_test

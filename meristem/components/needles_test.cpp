// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/needles.h"

#include <cmath>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::needles_test {

// `copies` shoots in a row.
Plant shoots(int copies, const Value::Object& parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("needles", "needles", parameters);
  for (int k = 0; k < copies; ++k) builder.link("view", "needles");
  return builder.grow();
}

TEST(NeedlesComponent, ManyShootsAreOfFewVariantsAndEachOccurs) {
  const Plant plant = shoots(200, {{"variants", 3}});
  EXPECT_EQ(plant.organs.size(), 200U);
  EXPECT_EQ(plant.prototypes.size(), 3U);
}

TEST(NeedlesComponent, VariedLengthsShareShapes) {
  const Plant plant = shoots(200, {{"length", "rand(0.03, 0.06)"}, {"along", "rand(0.06, 0.08)"}, {"variants", 1}});
  // Ratios of shoot to needle from 1 to 8/3 in eighths of an octave; ratios of width to length over one octave, in
  // quarters.
  EXPECT_LE(plant.prototypes.size(), 60U);
  for (const Organ& organ : plant.organs) {
    const float stretch = glm::length(organ.frame.heading()) / glm::length(organ.frame.right());
    EXPECT_NEAR(stretch, 1, 0.045);
  }
}

TEST(NeedlesComponent, AnglesThatVaryAreRoundedToFiveDegreesAndOthersAreExact) {
  const auto mesh = [](const Value& angle) {
    return shoots(1, {{"base_angle", angle}, {"variants", 1}}).prototypes.at(0).mesh->positions;
  };
  EXPECT_EQ(mesh("48 + i"), mesh(50));
  EXPECT_NE(mesh(48), mesh(50));
}

TEST(NeedlesComponent, ChildrenStandAtTheTip) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera")
      .component("needles", "needles", {{"along", 0.25}})
      .component("bud", "simple", {{"size", Value::List{0.01, 0.01, 0.01}}});
  builder.link("view", "needles").link("needles", "bud");
  const Plant plant = builder.grow();
  EXPECT_NEAR(organs_of(plant, "bud").at(0).frame.origin.y, 0.25F, 1e-6F);
}

TEST(NeedlesComponent, FaultyOnesAreRejected) {
  const auto path_of = [](const Value::Object& parameters) {
    const auto errors = errors_of([&] { shoots(1, parameters); });
    return errors.size() == 1 ? errors[0].path : "not one fault";
  };
  EXPECT_EQ(path_of({{"sides", 4}}), "components.needles.sides");
  EXPECT_EQ(path_of({{"flatten", 2}}), "components.needles.flatten");
  EXPECT_EQ(path_of({{"count", "i"}}), "components.needles.count");
}

}  // namespace meristem::needles_test

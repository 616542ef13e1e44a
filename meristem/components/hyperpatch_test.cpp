// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/hyperpatch.h"

#include <string>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"

namespace meristem::hyperpatch_test {

const Value::List kBox{Value::List{-1, 0, -1}, Value::List{1, 3, 1}};
const Value::List kLinear{1, 1, 1};

/// Control points of a patch of degree 1 over the box, with the upper four moved.
Value::List corners(double lift, const Value& side = 0.0) {
  Value::List points;
  for (const double y : {0.0, 3.0 + lift}) {
    for (const double z : {-1.0, 1.0}) {
      for (const double x : {-1.0, 1.0}) {
        const double shift = y > 0 && side.number() != nullptr ? *side.number() : 0;
        const bool is_text = y > 0 && side.text() != nullptr;
        points.emplace_back(
            Value::List{is_text ? Value(std::to_string(x) + " + " + *side.text()) : Value(x + shift), y, z});
      }
    }
  }
  return points;
}

Value::Object patch(Value::Object more = {}) {
  more.emplace_back("box", kBox);
  return more;
}

GraphBuilder stack_under(const Value::Object& patch_parameters) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("patch", "hyperpatch", patch_parameters);
  builder.component("trunk", "tree", {{"length", 3}, {"radius", 0.05}});
  builder.component("leaf", "leaf");
  builder.link("view", "patch").link("patch", "trunk");
  return builder.link("trunk", "leaf", LinkKind::branch, {{"count", 9}});
}

Diagnostic error_of(const Value::Object& parameters) {
  const auto errors = errors_of([&] { stack_under(parameters).grow(); });
  return errors.empty() ? Diagnostic{.message = "none"} : errors[0];
}

TEST(Hyperpatch, WithoutPointsChangesNoByte) {
  GraphBuilder plain(builtin_components());
  const std::string at_rest = hash_of(stack_under(patch({{"degree", kLinear}, {"points", corners(0)}})).grow());
  EXPECT_EQ(hash_of(stack_under(patch()).grow()), at_rest);
  EXPECT_EQ(hash_of(stack_under(patch({{"dx", "x"}, {"dy", "y"}})).grow()), at_rest);
}

TEST(Hyperpatch, OfDegree1TakesPointsBetweenItsCorners) {
  const Plant before = stack_under(patch()).grow();
  const Plant plant = stack_under(patch({{"degree", kLinear}, {"points", corners(0.6, 0.3)}, {"on", "axes"}})).grow();
  for (std::size_t k = 0; k < plant.stems[0].skeleton.node_count(); ++k) {
    const Vec3 was = before.stems[0].skeleton.position[k];
    const Vec3 expected = was + was.y / 3 * Vec3(0.3F, 0.6F, 0);
    EXPECT_LT(glm::distance(plant.stems[0].skeleton.position[k], expected), 1e-5F);
  }
}

TEST(Hyperpatch, PointsMayBeExpressions) {
  const Value::List moved = corners(0, "0.1*t + 0.5");
  const Plant plant = stack_under(patch({{"degree", kLinear}, {"points", moved}, {"on", "axes"}})).grow(5);
  const std::vector<Vec3>& positions = plant.stems[0].skeleton.position;
  EXPECT_NEAR(positions.back().x, positions.back().y / 3, 1e-4F);
}

TEST(Hyperpatch, FunctionsMoveControlPointsFromRest) {
  // The function is quadratic, but only its values at the control points matter.
  const Plant plant = stack_under(patch({{"degree", kLinear}, {"dx", "x + 0.1*y^2"}, {"on", "axes"}})).grow();
  const std::vector<Vec3>& positions = plant.stems[0].skeleton.position;
  for (const Vec3 position : positions) EXPECT_NEAR(position.x, 0.3F * position.y, 0.05F);
}

TEST(Hyperpatch, TellsHowManyPointsItNeedsAndInWhatOrder) {
  const Diagnostic error = error_of(patch({{"points", corners(0)}, {"degree", Value::List{1, 3, 2}}}));
  EXPECT_EQ(error.path, "components.patch.points");
  EXPECT_EQ(error.message, "a hyperpatch of degree [1, 3, 2] has 24 control points, and here are 8");
  EXPECT_EQ(error.expected,
            "2 x 4 x 3 of them: layer by layer from the lowest y up, in each layer row by row toward +z, in each row "
            "toward +x");
}

TEST(Hyperpatch, RefusesWhatIsNoPatch) {
  EXPECT_NE(error_of({}).message.find("box"), std::string::npos);
  EXPECT_EQ(error_of({{"box", Value::List{Value::List{0, 0, 0}, Value::List{1, 0, 1}}}}).message, "the box is flat");
  EXPECT_EQ(error_of(patch({{"degree", Value::List{1, 4, 1}}})).path, "components.patch.degree[1]");
  EXPECT_EQ(error_of(patch({{"degree", kLinear}, {"points", corners(0)}, {"dx", "x"}})).path, "components.patch.dx");
  EXPECT_EQ(error_of(patch({{"degree", kLinear}, {"points", Value::List{Value::List{0, 1}}}})).path,
            "components.patch.points[0]");
}

TEST(Hyperpatch, ThatFoldsIsTold) {
  const Diagnostic error = error_of(patch({{"degree", kLinear}, {"points", corners(-7)}}));
  EXPECT_EQ(error.path, "components.patch");
  EXPECT_NE(error.message.find("folds space over where 'trunk' stands"), std::string::npos) << error.message;
}

}  // namespace meristem::hyperpatch_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/field/expression_field.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"

namespace meristem::expression_field_test {

ExpressionField field_of(std::array<const char*, 3> texts, ExpressionField::Options options = {}) {
  const auto compile = [](const char* text) { return Expression::compile(text, {field_variables(), {}}); };
  return ExpressionField({compile(texts[0]), compile(texts[1]), compile(texts[2])}, std::move(options));
}

Diagnostic error_at(const ExpressionField& field, Vec3 position) {
  try {
    field.at(position);
  } catch (const InputError& error) {
    return error.diagnostics().at(0);
  }
  return {};
}

TEST(ExpressionField, SeesPositionAndTime) {
  const ExpressionField field = field_of({"-x", "2*t", "z*y"}, {.time = 3});
  EXPECT_EQ(field.at({1, 2, 3}), Vec3(-1, 6, 6));
  EXPECT_FALSE(field.is_uniform());
  EXPECT_TRUE(field_of({"1", "2*t", "sin(30)"}).is_uniform());
}

TEST(ExpressionField, TellsWhereItIsNotFinite) {
  const ExpressionField field =
      field_of({"1", "1/(y - 2)", "0"}, {.path = "components.w.light", .what = "light field"});
  const Diagnostic error = error_at(field, {1, 2, 0.5F});
  EXPECT_EQ(error.path, "components.w.light.y");
  EXPECT_EQ(error.message, "the y of the light field is inf at (1, 2, 0.5)");
  EXPECT_FALSE(error_at(field_of({"log(x)", "0", "0"}), {-1, 0, 0}).message.empty());
  EXPECT_FALSE(error_at(field_of({"10^9", "0", "0"}), {0, 0, 0}).message.empty());
}

TEST(ExpressionField, TellsWhereItVanishesUnlessItAdds) {
  const ExpressionField::Options options{.path = "components.w.gravity", .what = "gravity field"};
  const Diagnostic error = error_at(field_of({"-x", "0", "-z"}, options), {0, 3, 0});
  EXPECT_EQ(error.path, "components.w.gravity");
  EXPECT_EQ(error.message, "the gravity field vanishes at (0, 3, 0)");
  EXPECT_NE(error.expected.find("\"add\""), std::string::npos);
  EXPECT_EQ(field_of({"-x", "0", "-z"}, {.must_point = false}).at({0, 3, 0}), Vec3(0));
}

}  // namespace meristem::expression_field_test

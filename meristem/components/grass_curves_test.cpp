// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/grass_curves.h"

#include <fstream>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::grass_curves_test {

std::optional<GrassCurves> curves_of(const Value::Object& parameters, std::optional<int> rank = {},
                                     std::optional<int> leaf = {}) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("leaf", "grassleaf", parameters).link("view", "leaf");
  const Graph graph = builder.sound_graph();
  return grass_curves(graph.components[1], rank, leaf);
}

TEST(GrassCurves, AreThoseOfTheDocument) {
  const auto curves =
      curves_of({{"midrib_points", Value::List{Value::List{1, 1}, Value::List{2, 5}, Value::List{5, 6}}}});
  ASSERT_TRUE(curves);
  EXPECT_FALSE(curves->has_midrib_file);
  // Relative to the collar.
  EXPECT_EQ(curves->midrib_points, (std::vector<Vec2>{{0, 0}, {1, 4}, {4, 5}}));
  EXPECT_EQ(curves->midrib.front(), Vec2(0));
  EXPECT_NEAR(curves->midrib.back().x, 4, 0.1);
  EXPECT_EQ(curves->leaves, (std::vector<GrassCurves::Name>{{}}));
  EXPECT_EQ(curves->length, 0);
  EXPECT_EQ(curves->widths.front().x, 0);
  EXPECT_EQ(curves->widths.back().x, 1);
}

TEST(GrassCurves, OfOtherComponentsAreNone) {
  GraphBuilder builder(builtin_components());
  builder.component("view", "camera").component("stem", "tree", {}).link("view", "stem");
  EXPECT_FALSE(grass_curves(builder.sound_graph().components[1], {}, {}));
}

}  // namespace meristem::grass_curves_test

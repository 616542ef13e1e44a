// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/measure_report.h"

#include <gtest/gtest.h>

#include "meristem/document/json.h"

namespace meristem::measure_report_test {

StandMeasures two_trees() {
  StandMeasures stand;
  stand.whole.trees = 2;
  stand.whole.height = 12.34567;
  stand.whole.length_by_order = {1, 2.5};
  stand.whole.inclination_altitude = kPi / 4;
  stand.whole.leaf_count = 7;
  stand.trees.resize(2);
  stand.origins = {{}, {.skeleton = 1, .position = {1, 0, -2.5F}, .component = "lime", .instance = 4, .row = 9}};
  stand.trees[1].height = 3;
  return stand;
}

TEST(MeasureReport, ValueHasAKeyForEachRowAndNullForTheUnknown) {
  const Value value = measures_value(two_trees(), {});
  EXPECT_EQ(value.object()->size(), measure_rows().size());
  EXPECT_EQ(*value.find("height"), Value(12.34567));
  EXPECT_EQ(*value.find("length_by_order"), Value(Value::List{1, 2.5}));
  EXPECT_EQ(*value.find("leaf_count"), Value(7));
  EXPECT_TRUE(value.find("stem_diameter")->is_null());
  EXPECT_EQ(value.find("each"), nullptr);
  EXPECT_EQ(parse_json(write_json(value)), value);
}

TEST(MeasureReport, EachTreeFollowsWithoutWhatOnlyTheWholeHas) {
  const Value value = measures_value(two_trees(), {.each = true});
  const Value::List& trees = *value.find("each")->list();
  ASSERT_EQ(trees.size(), 2U);
  EXPECT_EQ(*trees[1].find("height"), Value(3));
  EXPECT_EQ(trees[1].find("triangles"), nullptr);
  EXPECT_TRUE(trees[1].find("leaf_count")->is_null());
  EXPECT_NE(trees[1].find("nodes"), nullptr);
  EXPECT_EQ(*trees[1].find("component"), Value("lime"));
  EXPECT_EQ(*trees[1].find("instance"), Value(4));
  EXPECT_EQ(*trees[1].find("position"), Value(Value::List{1, 0, -2.5}));
  EXPECT_EQ(*trees[1].find("row"), Value(9));
  EXPECT_TRUE(trees[0].find("component")->is_null());
  EXPECT_TRUE(trees[0].find("row")->is_null());
}

TEST(MeasureReport, TextHasALineForEachRow) {
  const std::string text = measures_text(two_trees(), {});
  EXPECT_TRUE(text.starts_with("trees                    2\n")) << text;
  EXPECT_NE(text.find("\nheight                   12.35 m\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nlength_by_order          1, 2.5 m\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nstem_diameter            -\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\ninclination_altitude     45 °\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("\ntree 1"), std::string::npos);
  const std::string each = measures_text(two_trees(), {.each = true});
  EXPECT_NE(each.find("\n\ntree 1, at 0, 0, 0\n"), std::string::npos) << each;
  EXPECT_NE(each.find("\n\ntree 2: lime 4, row 9, at 1, 0, -2.5\n"), std::string::npos) << each;
}

TEST(MeasureReport, LayersFollowTheMeasures) {
  StandMeasures stand = two_trees();
  stand.layers = LeafLayers{.height = 0.5, .first = -1, .area = {0.25, 2}};
  const Value value = measures_value(stand, {});
  const Value::List& layers = *value.find("layers")->list();
  ASSERT_EQ(layers.size(), 2U);
  EXPECT_EQ(*layers[0].find("low"), Value(-0.5));
  EXPECT_EQ(*layers[1].find("high"), Value(0.5));
  EXPECT_EQ(*layers[1].find("leaf_area"), Value(2));
  const std::string text = measures_text(stand, {});
  EXPECT_TRUE(
      text.ends_with("\nleaf area by height\n0 to 0.5 m               2 m²\n-0.5 to 0 m              0.25 m²\n"))
      << text;
}

TEST(MeasureReport, ReferenceNamesEveryMeasure) {
  const std::string page = measures_reference();
  for (const MeasureRow& row : measure_rows())
    EXPECT_NE(page.find("| `" + std::string(row.name) + "` |"), std::string::npos);
}

TEST(MeasureReport, ShowsTheNamedRowsOnly) {
  const MeasureReport report{.each = true, .only = {"height", "triangles"}};
  const Value value = measures_value(two_trees(), report);
  const Value::Object& object = *value.object();
  ASSERT_EQ(object.size(), 3U);
  EXPECT_EQ(object[0].first, "height");
  EXPECT_EQ(object[1].first, "triangles");
  const Value::Object& tree = *value.find("each")->list()->front().object();
  EXPECT_EQ(tree.back().first, "height");
  const std::string text = measures_text(two_trees(), report);
  EXPECT_TRUE(text.starts_with("height "));
  EXPECT_EQ(text.find("nodes"), std::string::npos);
}

}  // namespace meristem::measure_report_test

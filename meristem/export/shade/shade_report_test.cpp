// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/shade/shade_report.h"

#include <gtest/gtest.h>

#include "meristem/document/json.h"
#include "meristem/output/write/small_text.h"

namespace meristem::shade_report_test {

struct Case {
  ShadePlan plan;
  ShadeOfSurface shade;
};

/// Returns ground of two by two cells at midnight and at noon. An obstacle occupies one cell.
Case small_case() {
  Scene scene;
  scene.latitude = radians(50);
  scene.obstacles = Obstacles({{.mesh = box_mesh({0, -1, 0}, {1, 5, 1})}});
  Case made;
  made.plan =
      plan_shade({.ground = parse_json("[[-1, -1], [1, 1]]"), .spacing = 1, .days = "172", .hours = "0,12"}, scene);
  Progress progress;
  made.shade = measure_shade(made.plan.surface, made.plan.sun, {}, scene.obstacles, progress);
  return made;
}

TEST(ShadeReport, CsvHasARowPerMomentAndNothingByNight) {
  const Case made = small_case();
  const std::string csv = shade_csv(made.plan, made.shade);
  EXPECT_TRUE(
      csv.starts_with("day,hour,solar_hour,azimuth,altitude,cosine,direct,shade,shade_without_plants\n172,0,0,"))
      << csv;
  EXPECT_NE(csv.find(",,,\n172,12,12,180,"), std::string::npos) << csv;
  // At noon the shadow falls on the cell north of the obstacle.
  EXPECT_TRUE(csv.ends_with(",0.33333334,0.33333334\n")) << csv;
}

TEST(ShadeReport, JsonHasTheGridFromSouthToNorth) {
  const Case made = small_case();
  const Value value = shade_value(made.plan, made.shade);
  EXPECT_EQ(*value.find("points"), Value(3));
  EXPECT_NEAR(*value.find("area")->number(), 3, 1e-6);
  EXPECT_TRUE((*value.find("moments")->list())[0].find("shade")->is_null());
  const Value* grid = value.find("grid");
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(*grid->find("shade"), parse_json("[[0, null], [0, 1]]"));
}

TEST(ShadeReport, PointsTellWhereTheyAre) {
  const Case made = small_case();
  EXPECT_EQ(shade_points_csv(made.plan, made.shade),
            "x,y,z,shade,shade_without_plants\n-0.5,0,0.5,0,0\n-0.5,0,-0.5,0,0\n0.5,0,-0.5,1,1\n");
}

TEST(ShadeReport, TheMapHasNorthAboveAndGreyObstacles) {
  const Case made = small_case();
  const Image map = shade_picture(made.plan, made.shade, true);
  const auto brightness = [&](double x, double y) {
    const std::uint8_t* pixel = map.pixel(static_cast<int>(20 + 720 * x), static_cast<int>(20 + 720 * y));
    return pixel[0] + pixel[1] + pixel[2];
  };
  EXPECT_GT(brightness(0.25, 0.25), 550);  // sun in the northwest
  EXPECT_LT(brightness(0.75, 0.25), 160);  // shade in the northeast
  EXPECT_EQ(brightness(0.75, 0.75), 3 * 190);
}

TEST(ShadeReport, HoursByDaysHaveNightInGrey) {
  const Case made = small_case();
  const Image map = shade_picture(made.plan, made.shade, false);
  ASSERT_GT(map.width, 100);
  const std::uint8_t* night = map.pixel(map.width / 2, 20 + 70);
  EXPECT_EQ(night[0], 190);
}

TEST(SmallText, DrawsDotsAndLeavesOutWhatIsOutside) {
  Image image{20, 9, std::vector<std::uint8_t>(20 * 9 * 4, 255)};
  draw_small_text(image, 1, 1, 1, {0, 0, 0}, "1");
  EXPECT_EQ(image.pixel(3, 1)[0], 0);
  EXPECT_EQ(image.pixel(1, 1)[0], 255);
  EXPECT_EQ(image.pixel(2, 7)[0], 0);
  draw_small_text(image, 15, 5, 3, {0, 0, 0}, "888");
  draw_small_text(image, -4, -4, 3, {0, 0, 0}, "8?8");
  EXPECT_EQ(small_text_width("100 %", 2), 2 * 29);
  EXPECT_EQ(small_text_width("", 2), 0);
}

}  // namespace meristem::shade_report_test

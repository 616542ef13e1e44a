// SPDX-License-Identifier: Apache-2.0
#include "meristem/export/shade/shade_request.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/json.h"

namespace meristem::shade_request_test {

Scene street() {
  Scene scene;
  scene.latitude = radians(51.5);
  scene.obstacles = Obstacles({{.mesh = box_mesh({-8, 0, -9}, {8, 9, -3}), .name = "house"},
                               {.mesh = box_mesh({-8, 0, 9}, {8, 4, 12})},
                               {.mesh = box_mesh({20, 0, -9}, {28, 9, -3}), .name = "house"}});
  return scene;
}

std::string error_of(const ShadeRequest& request, const Scene& scene = street()) {
  try {
    plan_shade(request, scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

ShadeRequest facade(const std::string& json) {
  return {.facade = parse_json(json), .spacing = 1, .days = "172", .hours = "12"};
}

std::string days_of(const std::string& text) {
  std::string days;
  for (const ShadeDay& day : parse_shade_days(text)) days += day.text() + " ";
  return days;
}

TEST(ShadeRequest, ReadsDays) {
  EXPECT_EQ(days_of("172"), "172 ");
  EXPECT_EQ(days_of("80:100:10, 355"), "80 90 100 355 ");
  EXPECT_EQ(days_of("2026-12-31:2027-01-02:1"), "2026-12-31 2027-01-01 2027-01-02 ");
  EXPECT_EQ(parse_shade_days("2024-12-31")[0].day, 366);
  for (const char* wrong : {"", "0", "367", "1.5", "1:10", "10:1:1", "1:10:0", "1:10:0.5", "2026-02-30",
                            "1:2026-02-03:1", "june", "1,,2", "1:10:1:1", "nan", "1:366:-1"}) {
    EXPECT_THROW(parse_shade_days(wrong), InputError) << wrong;
  }
}

TEST(ShadeRequest, ReadsHours) {
  EXPECT_EQ(parse_shade_hours("6:8:0.5,15:30"), (std::vector<double>{6, 6.5, 7, 7.5, 8, 15.5}));
  EXPECT_EQ(parse_shade_hours("0:24:0.1").size(), 241U);
  for (const char* wrong :
       {"", "25", "-1", "15:61", "20:6:1", "6:20:0", "6:25:1", "noon", "6:20:1e-9", "inf", "6:20:1:1"}) {
    EXPECT_THROW(parse_shade_hours(wrong), InputError) << wrong;
  }
}

TEST(ShadeRequest, FindsObstaclesByNameAndNumber) {
  EXPECT_NEAR(plan_shade(facade(R"({"obstacle": "house", "side": "south"})"), street()).surface.area, 144 + 72, 1e-3);
  EXPECT_NEAR(plan_shade(facade(R"({"obstacle": "0", "side": "south"})"), street()).surface.area, 144, 1e-3);
  EXPECT_NEAR(plan_shade(facade("1"), street()).surface.area, 2 * 64 + 2 * 12, 1e-3);
  EXPECT_NEAR(plan_shade(facade(R"("1")"), street()).surface.area, 2 * 64 + 2 * 12, 1e-3);
}

TEST(ShadeRequest, SaysWhatIsWrongWithASurface) {
  EXPECT_EQ(error_of(facade(R"("hous")")),
            "facade.obstacle: no obstacle is called 'hous'; expected one of house, 1, house; did you mean 'house'?");
  EXPECT_NE(error_of(facade(R"({"side": "south"})")).find("obstacle"), std::string::npos);
  EXPECT_NE(error_of(facade(R"({"obstacle": 0, "sid": "south"})")).find("did you mean 'side'?"), std::string::npos);
  EXPECT_NE(error_of(facade(R"({"obstacle": 0, "side": "sout"})")).find("did you mean 'south'?"), std::string::npos);
  EXPECT_NE(error_of(facade(R"({"obstacle": 0, "side": "south", "azimuth": 3})")).find("facade.azimuth"),
            std::string::npos);
  EXPECT_NE(error_of(facade("0"),
                     [] {
                       Scene scene;
                       scene.latitude = 0;
                       return scene;
                     }())
                .find("the scene has no obstacles"),
            std::string::npos);
  ShadeRequest none{.days = "1"};
  EXPECT_NE(error_of(none).find("no surface is given"), std::string::npos);
  none.ground = parse_json("[[0, 0], [1, 1]]");
  EXPECT_EQ(error_of(none), "no fault");
  none.panels = parse_json(R"({"position": [0, 0, 0]})");
  EXPECT_NE(error_of(none).find("more than one surface"), std::string::npos);
}

TEST(ShadeRequest, SaysWhatIsWrongWithAnArea) {
  const auto error = [](const std::string& area) {
    return error_of({.ground = parse_json(area), .days = "1", .hours = "12"});
  };
  EXPECT_NE(error("[[0, 0]]").find("ground.area: the area has 1 corners"), std::string::npos) << error("[[0, 0]]");
  EXPECT_NE(error("[[0, 0], [0, 4]]").find("the area has no width"), std::string::npos);
  EXPECT_NE(error("[[0, 0], [1e5, 1e5]]").find("too many; expected at most"), std::string::npos);
  EXPECT_NE(error("[[-1, -8], [1, -4]]").find("obstacles stand on all of this ground"), std::string::npos);
  const auto panels = [](const std::string& field) {
    return error_of({.panels = parse_json(field), .days = "1", .hours = "12"});
  };
  EXPECT_NE(panels(R"({"position": [0, 1, 0], "tilt": 95})").find("panels.tilt"), std::string::npos);
  EXPECT_NE(panels(R"({"tilt": 30})").find("position"), std::string::npos);
}

TEST(ShadeRequest, SolarHoursAreTheDocumentsOwn) {
  const ShadePlan plan =
      plan_shade({.ground = parse_json("[[0, 0], [1, 1]]"), .days = "105,172", .hours = "9,12"}, street());
  EXPECT_FALSE(plan.is_clock_time);
  ASSERT_EQ(plan.sun.size(), 4U);
  const SkyDirection expected = sun_position(radians(51.5), 172, 9);
  EXPECT_EQ(plan.sun[2].altitude, expected.altitude);
  EXPECT_EQ(plan.sun[2].azimuth, expected.azimuth);
}

TEST(ShadeRequest, ClockHoursNeedDatesAndAZone) {
  ShadeRequest request{.ground = parse_json("[[0, 0], [1, 1]]"), .days = "2026-06-21", .hours = "15:30"};
  request.longitude = 13.4;
  EXPECT_NE(error_of(request).find("utc_offset: clock time needs both"), std::string::npos) << error_of(request);
  request.utc_offset = 2;
  const ShadePlan plan = plan_shade(request, street());
  EXPECT_TRUE(plan.is_clock_time);
  EXPECT_NEAR(plan.solar_hours[0], 14.36, 0.01);
  request.days = "172";
  EXPECT_NE(error_of(request).find("day 172 has no year"), std::string::npos);
  request.longitude = 181;
  EXPECT_NE(error_of(request).find("longitude: it cannot be 181"), std::string::npos);
  // The document's settings of the sun apply if the request does not set them.
  Scene scene = street();
  scene.clock = ClockZone{radians(13.4), 2};
  const ShadePlan same =
      plan_shade({.ground = parse_json("[[0, 0], [1, 1]]"), .days = "2026-06-21", .hours = "15:30"}, scene);
  EXPECT_EQ(same.sun[0].altitude, plan.sun[0].altitude);
}

TEST(ShadeRequest, ALatitudeIsNeededAndTheRequestsGoesFirst) {
  Scene scene;
  ShadeRequest request{.ground = parse_json("[[0, 0], [1, 1]]"), .days = "172", .hours = "12"};
  EXPECT_NE(error_of(request, scene).find("latitude: the scene has no latitude"), std::string::npos);
  request.latitude = -30;
  EXPECT_NEAR(degrees(plan_shade(request, street()).sun[0].altitude), 90 - 30 - 23.44, 0.1);
}

TEST(ShadeRequest, BoundsRays) {
  ShadeRequest request{.ground = parse_json("[[0, 0], [200, 200]]"), .spacing = 0.25, .days = "1:365:1"};
  EXPECT_NE(error_of(request).find("too many; expected at most 200000000 rays"), std::string::npos)
      << error_of(request);
  request.spacing = 0;
  EXPECT_NE(error_of(request).find("spacing: the spacing cannot be 0"), std::string::npos);
}

}  // namespace meristem::shade_request_test

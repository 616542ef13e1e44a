// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/places.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "meristem/components/registry.h"
#include "tests/support/build_graph.h"
#include "tests/support/temporary_folder.h"

namespace meristem::places_test {

std::vector<Organ> stones_of(const Value::Object& places, std::uint64_t seed = 1, const Scene& scene = {}) {
  GraphBuilder builder(builtin_components());
  builder.seed(seed).component("view", "camera").component("sites", "places", places).component("stone", "simple");
  builder.link("view", "sites").link("sites", "stone");
  return organs_of(builder.grow(0, scene), "stone");
}

Value pairs(std::initializer_list<std::pair<double, double>> points) {
  Value::List list;
  for (const auto& [x, z] : points) list.push_back(Value::List{x, z});
  return list;
}

Value::Object area(double density, const Value& polygon) {
  return {{"area", Value::Object{{"polygon", polygon}, {"density", density}}}};
}

const Value kSquare = pairs({{0, 0}, {10, 0}, {10, 10}, {0, 10}});

TEST(Places, AnAreaHasItsDensityAndItsSitesKeepTheirDistance) {
  const std::vector<Organ> stones = stones_of(area(4, kSquare));
  EXPECT_EQ(stones.size(), 400U);
  for (std::size_t a = 0; a < stones.size(); ++a) {
    const Vec3 here = stones[a].frame.origin;
    EXPECT_TRUE(here.x >= 0 && here.x <= 10 && here.z >= 0 && here.z <= 10 && here.y == 0);
    for (std::size_t b = 0; b < a; ++b) EXPECT_GE(glm::distance(here, stones[b].frame.origin), 0.35F - 1e-5F);
  }
}

TEST(Places, AnAreaWithANotchStaysOutOfIt) {
  // An L: the upper right quarter is missing, so the area is three quarters.
  const auto stones = stones_of(area(4, pairs({{0, 0}, {10, 0}, {10, 5}, {5, 5}, {5, 10}, {0, 10}})));
  EXPECT_EQ(stones.size(), 300U);
  for (const Organ& stone : stones) EXPECT_FALSE(stone.frame.origin.x > 5 && stone.frame.origin.z > 5);
}

TEST(Places, AnAreaThatIsTooDenseForItsDistanceHasFewer) {
  Value::Object places = area(4, kSquare);
  places[0].second.object()->emplace_back("distance", 1.0);
  const std::size_t count = stones_of(places).size();
  // Random packing ends when discs of half the distance cover 0.547 of the plane: 70 discs. At the edge, discs may
  // extend outside, so there are slightly more.
  EXPECT_GT(count, 60U);
  EXPECT_LT(count, 95U);
}

TEST(Places, SeedsGiveOtherSitesAndTheSameSeedTheSame) {
  const auto first = stones_of(area(1, kSquare)), again = stones_of(area(1, kSquare)),
             other = stones_of(area(1, kSquare), 2);
  EXPECT_EQ(first[0].frame.origin, again[0].frame.origin);
  EXPECT_NE(first[0].frame.origin, other[0].frame.origin);
}

TEST(Places, ALineHasASiteAtEachStepOfItsLength) {
  const auto stones = stones_of(
      {{"line", Value::Object{{"points", pairs({{0, 0}, {10, 0}, {10, 5}})}, {"spacing", 2.5}, {"offset", 1}}}});
  ASSERT_EQ(stones.size(), 7U);
  EXPECT_NEAR(glm::distance(stones[0].frame.origin, Vec3(0, 0, 1)), 0, 1e-6) << "to the right of the way to the east";
  EXPECT_NEAR(glm::distance(stones[6].frame.origin, Vec3(9, 0, 5)), 0, 1e-6) << "to the right of the way to the south";
  EXPECT_NEAR(glm::distance(glm::normalize(stones[6].frame.axes[0]), Vec3(0, 0, 1)), 0, 1e-6)
      << "x runs along the line";
}

TEST(Places, ALineThatIsAWholeNumberOfStepsLongHasItsLastSite) {
  // Lengths that floats cannot represent: after rounding, some are shorter than the step and some longer.
  for (const double step : {12.4, 0.1, 0.7, 3.3, 12.39}) {
    for (const int steps : {1, 3, 10}) {
      const auto stones =
          stones_of({{"line", Value::Object{{"points", pairs({{0, 0}, {step * steps, 0}})}, {"spacing", step}}}});
      ASSERT_EQ(stones.size(), static_cast<std::size_t>(steps) + 1) << steps << " steps of " << step << " m";
      EXPECT_NEAR(stones.back().frame.origin.x, step * steps, 1e-5 * step * steps);
    }
  }
  // From x = -6.2 to 6.2, like both sides of a street. A line that ends before the step has no last site.
  const auto count = [](double from, double to, double step) {
    return stones_of({{"line", Value::Object{{"points", pairs({{from, 0}, {to, 0}})}, {"spacing", step}}}}).size();
  };
  EXPECT_EQ(count(-6.2, 6.2, 12.4), 2U);
  EXPECT_EQ(count(-6.2, 6.19, 12.4), 1U);
}

TEST(Places, NothingIsPlantedIntoAnObstacle) {
  const auto inside = [](const Organ& stone) {
    const Vec3 at = stone.frame.origin;
    return at.x > 2 && at.x < 6 && at.z > 2 && at.z < 6;
  };
  Scene scene;
  scene.obstacles = Obstacles({Obstacle{.mesh = box_mesh({2, -1, 2}, {6, 3, 6})}});
  const auto open = stones_of(area(4, kSquare)), built = stones_of(area(4, kSquare), 1, scene);
  EXPECT_GT(std::ranges::count_if(open, inside), 40);
  EXPECT_EQ(std::ranges::count_if(built, inside), 0);
  EXPECT_EQ(built.size(), open.size() - static_cast<std::size_t>(std::ranges::count_if(open, inside)));
}

/// Returns the sites of a table's rows.
std::vector<Organ> stones_of_table(const std::string& text, Value::Object more = {}) {
  TemporaryFolder folder;
  const std::string file = (folder / "table.csv").string();
  std::ofstream(file) << text;
  more.emplace_back("table", file);
  return stones_of(more);
}

std::vector<Diagnostic> table_errors(const std::string& text, const Value::Object& more = {}) {
  return errors_of([&] { stones_of_table(text, more); });
}

TEST(Places, PlanTablesStandAsInTheScene) {
  const auto stones = stones_of_table("x,z,y,scale,rotation\n1,2,3,2,90\n");
  ASSERT_EQ(stones.size(), 1U);
  EXPECT_EQ(stones[0].frame.origin, Vec3(1, 3, 2));
  EXPECT_NEAR(glm::length(stones[0].frame.heading()) / glm::length(stones_of_table("x,z\n1,2\n")[0].frame.heading()), 2,
              1e-5);
  EXPECT_NEAR(glm::distance(glm::normalize(stones[0].frame.axes[0]), Vec3(0, 0, -1)), 0, 1e-6);
}

TEST(Places, MapTablesLookToTheNorth) {
  const auto stones =
      stones_of_table("x;y;height\n532001,5;181004;7\n", {{"origin_x", 532000.0}, {"origin_y", 181000.0}});
  EXPECT_EQ(stones.at(0).frame.origin, Vec3(1.5, 7, -4));
}

TEST(Places, DegreesAreMetresOnTheGround) {
  // A minute of arc on a meridian is a nautical mile, about 1853 m. At 60° of latitude, a minute of longitude is half
  // of that.
  const auto stones =
      stones_of_table("lon,lat\n10,60\n10.0166667,60.0166667\n", {{"origin_x", 10.0}, {"origin_y", 60.0}});
  EXPECT_NEAR(stones.at(1).frame.origin.z, -1853, 1);
  EXPECT_NEAR(stones.at(1).frame.origin.x, 926.6, 1);
}

TEST(Places, RejectsATableWithoutPlacesAndSaysTheNearestName) {
  const auto found = table_errors("lon,latt\n1,2\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "latt") << found[0].text();
}

TEST(Places, RejectsATextForANumberWithItsLineAndColumn) {
  const auto found = table_errors("x,y,species\n1,2,oak\n3,east,oak\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].message.find("table.csv:3:3"), std::string::npos) << found[0].message;
  EXPECT_NE(found[0].message.find("'east'"), std::string::npos) << found[0].message;
}

TEST(Places, RejectsNumbersThatAreOutOfRangeWithLineAndColumn) {
  for (const char* row : {"0,1e8,1", "0,1e308,1", "0,-2e7,1"}) {
    const auto found = table_errors(std::string("x,y,scale\n1,2,1\n") + row + "\n");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].message.find("table.csv:3:3"), std::string::npos) << found[0].message;
  }
  EXPECT_EQ(table_errors("x,y,years\n1,2,1e308\n").size(), 1U) << "a column that expressions may use";
}

TEST(Places, RejectsAnEmptyCellOfAPlace) {
  const auto found = table_errors("x,y\n1,2\n3,\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].message.find("table.csv:3"), std::string::npos) << found[0].message;
}

TEST(Places, RejectsAColumnToChooseByThatIsNotThere) {
  const auto found = table_errors("x,y,species\n1,2,oak\n", {{"choose", "specie"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].nearest, "species");
}

TEST(Places, RejectsMoreRowsThanMayBeBeforeTheyAreRead) {
  std::string text = "x,y\n";
  for (int k = 0; k < 1'002'000; ++k) text += "1,2\n";
  const auto found = table_errors(text);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].text().find("at most 1000000"), std::string::npos) << found[0].text();
}

TEST(Places, RejectsAPolygonThatEnclosesNothing) {
  const auto found = errors_of([] { stones_of(area(1, pairs({{0, 0}, {1, 1}}))); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, "components.sites.area.polygon");
}

TEST(Places, RejectsAnAreaWithTooManySites) {
  const auto found = errors_of([] { stones_of(area(1e6, kSquare)); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].message.find("100000000 sites"), std::string::npos) << found[0].message;
}

}  // namespace meristem::places_test

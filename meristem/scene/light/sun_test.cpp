// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/sun.h"

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/test_data.h"

namespace meristem::sun_test {

constexpr double kDortmund = 51.51494;  // degrees north
constexpr double kTolerance = 0.001;    // degrees; hours for times

struct Place {
  double altitude;
  double azimuth;
};

// A day's declination, the sun's positions at 6, 9, 12 and 15 hours, and sunrise, computed by another program with the
// formulas of the source.
struct Day {
  int day;
  double declination;
  std::array<Place, 4> places;
  double sunrise;
  double latitude = kDortmund;
};

constexpr std::array<Day, 8> kDays{{
    {15, -21.1340, {{{-16.393, 103.526}, {7.366, 138.315}, {17.351, 180}, {7.366, 221.685}}}, 7.9395},
    {80, 0.2427, {{{0.190, 89.849}, {26.318, 127.920}, {38.728, 180}, {26.318, 232.080}}}, 5.9797},
    {105, 9.7790, {{{7.640, 83.878}, {34.513, 122.255}, {48.264, 180}, {34.513, 237.745}}}, 5.1653},
    {172, 23.4405, {{{18.143, 74.900}, {45.652, 111.860}, {61.926, 180}, {45.652, 248.140}}}, 3.7966},
    {213, 18.0614, {{{14.045, 78.528}, {41.380, 116.371}, {56.546, 180}, {41.380, 243.629}}}, 4.3856},
    {265, 0.4040, {{{0.316, 89.749}, {26.458, 127.832}, {38.889, 180}, {26.458, 232.168}}}, 5.9661},
    {307, -15.0060, {{{-11.693, 99.471}, {12.848, 135.530}, {23.479, 180}, {12.848, 224.470}}}, 7.3137},
    {355, -23.4385, {{{-18.141, 105.099}, {5.300, 139.342}, {15.047, 180}, {5.300, 220.658}}}, 8.2031},
}};

Place sun_deg(double latitude_deg, double day, double hour) {
  const SkyDirection sun = sun_position(radians(latitude_deg), day, hour);
  return {degrees(sun.altitude), degrees(sun.azimuth)};
}

void expect_agrees(const Day& day) {
  SCOPED_TRACE(day.day);
  EXPECT_NEAR(degrees(declination(day.day)), day.declination, kTolerance);
  for (std::size_t k = 0; k < day.places.size(); ++k) {
    const Place sun = sun_deg(day.latitude, day.day, 6 + 3.0 * static_cast<double>(k));
    EXPECT_NEAR(sun.altitude, day.places[k].altitude, kTolerance);
    EXPECT_NEAR(sun.azimuth, day.places[k].azimuth, kTolerance);
  }
  const auto light = daylight(radians(day.latitude), day.day);
  ASSERT_TRUE(light.has_value());
  EXPECT_NEAR(light->first, day.sunrise, kTolerance);
  EXPECT_NEAR(light->second, 24 - day.sunrise, kTolerance);
}

/// Parses a row "| day | declination | altitude azimuth | ... | sunrise |" with four positions.
/// If `has_latitude`, the latitude is the first cell. Returns nothing for other lines.
std::optional<Day> day_in(std::string line, bool has_latitude) {
  for (char& c : line) {
    if (c == '|') c = ' ';
  }
  std::istringstream words(line);
  Day day{};
  if (has_latitude) words >> day.latitude;
  words >> day.day >> day.declination;
  for (Place& place : day.places) words >> place.altitude >> place.azimuth;
  words >> day.sunrise;
  return words.fail() ? std::nullopt : std::optional(day);
}

TEST(Sun, AgreesWithReferenceDaysInDortmund) {
  for (const Day& day : kDays) expect_agrees(day);
}

struct TableFacts {
  int days;
  bool has_latitudes;
};

TEST(Sun, AgreesWithTablesOfOtherPrograms) {
  for (const auto& [file, facts] :
       data_sets<TableFacts>({{"tests/data/reference/sun.md", {24, true}}}, {{"reference/sun.md", {8, false}}})) {
    SCOPED_TRACE(file);
    std::ifstream table(file);
    int days = 0;
    for (std::string line; std::getline(table, line);) {
      const std::optional<Day> day = line.starts_with("|") ? day_in(line, facts.has_latitudes) : std::nullopt;
      if (!day) continue;
      ++days;
      expect_agrees(*day);
    }
    EXPECT_EQ(days, facts.days);
  }
}

TEST(Sun, StandsAt55DegreesAtNoonOnDay126) { EXPECT_NEAR(sun_deg(kDortmund, 126, 12).altitude, 55.03, 0.005); }

TEST(Sun, IsWithinHalfADegreeOfAnEphemeris) {
  // Reda and Andreas, Solar Position Algorithm for Solar Radiation Applications (NREL 2008), example: 17 October 2003,
  // 12:30:30 at UTC-7, 39.742476 N, 105.1786 W: elevation without refraction 39.872, azimuth 194.340 degrees. True
  // solar time adds 4 minutes per degree east of the zone's meridian, and the equation of time of that day, 14.6
  // minutes.
  const double hour = 12 + 30.5 / 60 + (105 - 105.1786) / 15 + 14.6 / 60;
  const Place sun = sun_deg(39.742476, 290, hour);
  EXPECT_NEAR(sun.altitude, 39.872, 0.5);
  EXPECT_NEAR(sun.azimuth, 194.340, 0.5);
  EXPECT_NEAR(degrees(declination(290)), -9.31434, 0.5);
  // With clock time instead, without the equation of time, the azimuth is up to 4 degrees off.
  const Place by_clock = sun_deg(39.742476, 290, hour - 14.6 / 60);
  EXPECT_NEAR(by_clock.azimuth, 194.340, 5);
  EXPECT_GT(std::abs(by_clock.azimuth - 194.340), 2);
}

TEST(Sun, IsOnTheHorizonAtSunriseAndSunset) {
  for (const double latitude : {-40.0, 0.0, 30.0, 60.0}) {
    const auto light = daylight(radians(latitude), 130);
    ASSERT_TRUE(light.has_value());
    EXPECT_NEAR(sun_deg(latitude, 130, light->first).altitude, 0, 1e-9);
    EXPECT_NEAR(sun_deg(latitude, 130, light->second).altitude, 0, 1e-9);
    EXPECT_LT(sun_deg(latitude, 130, light->first).azimuth, 180);
    EXPECT_GT(sun_deg(latitude, 130, light->second).azimuth, 180);
  }
}

TEST(Sun, StandsInTheNorthAtNoonInTheSouth) {
  const Place noon = sun_deg(-35, 172, 12);
  EXPECT_NEAR(std::remainder(noon.azimuth, 360), 0, kTolerance);
  EXPECT_NEAR(noon.altitude, 90 - 35 - 23.4405, kTolerance);
  // The sun still rises in the east and passes the north-east before noon.
  EXPECT_NEAR(sun_deg(-35, 172, 9).azimuth, 360 - sun_deg(-35, 172, 15).azimuth, 1e-9);
  EXPECT_LT(sun_deg(-35, 172, 9).azimuth, 90);
}

/// Returns the day between the northern midsummer and midwinter with this declination.
double day_of(double sun_declination) {
  double early = 173;
  double late = 355;
  for (int k = 0; k < 60; ++k) {
    const double middle = (early + late) / 2;
    (declination(middle) > sun_declination ? early : late) = middle;
  }
  return early;
}

TEST(Sun, SeasonsOfTheSouthMirrorThoseOfTheNorth) {
  for (const double day : {15.0, 105.0, 160.0, 300.0}) {
    const double opposite = day_of(-declination(day));
    ASSERT_NEAR(declination(opposite), -declination(day), 1e-12);
    for (const double latitude : {0.0, 35.0, 51.5, 75.0, 90.0}) {
      for (const double hour : {1.0, 6.5, 9.0, 16.25}) {
        const Place north = sun_deg(latitude, day, hour);
        const Place south = sun_deg(-latitude, opposite, hour);
        EXPECT_NEAR(north.altitude, south.altitude, 1e-9);
        EXPECT_NEAR(std::remainder(north.azimuth - (180 - south.azimuth), 360), 0, 1e-9);
      }
      const auto in_north = daylight(radians(latitude), day);
      const auto in_south = daylight(radians(-latitude), opposite);
      ASSERT_EQ(in_north.has_value(), in_south.has_value());
      EXPECT_NEAR(in_north.value_or(std::pair(0.0, 0.0)).first, in_south.value_or(std::pair(0.0, 0.0)).first, 1e-9);
    }
  }
}

TEST(Sun, NeverSetsOnPolarDays) {
  const auto light = daylight(radians(75), 172);
  ASSERT_TRUE(light.has_value());
  EXPECT_EQ(*light, std::pair(0.0, 24.0));
  EXPECT_GT(sun_deg(75, 172, 0).altitude, 0);
  EXPECT_EQ(daylight(radians(90), 172), std::pair(0.0, 24.0));
}

TEST(Sun, NeverRisesInPolarNights) {
  EXPECT_FALSE(daylight(radians(75), 355).has_value());
  EXPECT_LT(sun_deg(75, 355, 12).altitude, 0);
  EXPECT_FALSE(daylight(radians(-75), 172).has_value());
  EXPECT_FALSE(daylight(radians(-90), 172).has_value());
}

TEST(Sun, CirclesThePoleAtTheAltitudeOfItsDeclination) {
  for (const double hour : {3.0, 9.0, 12.0, 20.0}) {
    const Place sun = sun_deg(90, 172, hour);
    EXPECT_NEAR(sun.altitude, 23.4405, kTolerance);
    EXPECT_NEAR(sun.azimuth, 15 * hour, 1e-9);
  }
}

TEST(Sun, VectorsPointNorthEastAndUp) {
  const auto vector = [](double azimuth, double altitude) {
    return unit_vector({radians(azimuth), radians(altitude)});
  };
  EXPECT_LT(glm::distance(vector(0, 0), Vec3(0, 0, -1)), 1e-6F);
  EXPECT_LT(glm::distance(vector(90, 0), Vec3(1, 0, 0)), 1e-6F);
  EXPECT_LT(glm::distance(vector(180, 0), Vec3(0, 0, 1)), 1e-6F);
  EXPECT_LT(glm::distance(vector(17, 90), Vec3(0, 1, 0)), 1e-6F);
}

TEST(Sun, DirectionsOfVectorsReturn) {
  for (double azimuth = 5; azimuth < 360; azimuth += 50) {
    for (double altitude = -85; altitude < 90; altitude += 34) {
      const SkyDirection there = sky_direction(3.0F * unit_vector({radians(azimuth), radians(altitude)}));
      EXPECT_NEAR(degrees(there.azimuth), azimuth, 1e-4);
      EXPECT_NEAR(degrees(there.altitude), altitude, 1e-4);
    }
  }
  EXPECT_EQ(sky_direction({0, 2, 0}).azimuth, 0);
  EXPECT_NEAR(sky_direction({0, -2, 0}).altitude, -kPi / 2, 1e-12);
}

}  // namespace meristem::sun_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/light/clock.h"

#include <gtest/gtest.h>

namespace meristem::clock_test {

constexpr double kAngleError = 0.012;  // degrees: accuracy of the Almanac, plus the rounding of published figures

TEST(Clock, ReadsDatesAndRefusesDaysThatAreNone) {
  EXPECT_EQ(parse_date("2026-06-21"), (CalendarDate{2026, 6, 21}));
  EXPECT_EQ(parse_date("2024-02-29"), (CalendarDate{2024, 2, 29}));
  for (const char* wrong :
       {"", "2026-6-21", "2026-06-31", "2025-02-29", "2100-02-29", "2026-13-01", "2026-00-01", "2026-06-00",
        "1899-12-31", "2101-01-01", "2026/06/21", "2026-06-21 ", "26-06-21", "+026-06-21", "2026-0x-21"}) {
    EXPECT_FALSE(parse_date(wrong)) << wrong;
  }
}

TEST(Clock, CountsDaysThroughTheCalendar) {
  EXPECT_EQ(day_of_year({2026, 1, 1}), 1);
  EXPECT_EQ(day_of_year({2026, 6, 21}), 172);
  EXPECT_EQ(day_of_year({2024, 12, 31}), 366);
  EXPECT_EQ(date_text({2026, 6, 1}), "2026-06-01");
  // Each day of two centuries follows the previous one.
  CalendarDate date{1900, 1, 1};
  for (int k = 1; k <= 73413; ++k) {
    const CalendarDate next = later(date, 1);
    ASSERT_EQ(days_between(date, next), 1) << date_text(date);
    ASSERT_EQ(parse_date(date_text(next)).has_value(), true) << date_text(next);
    date = next;
  }
  EXPECT_EQ(date, (CalendarDate{2100, 12, 31}));
  EXPECT_EQ(later({2100, 12, 31}, -73413), (CalendarDate{1900, 1, 1}));
}

TEST(Clock, ReadsHoursAndRefusesWhatNoClockShows) {
  EXPECT_EQ(parse_clock_hour("15:30"), 15.5);
  EXPECT_EQ(parse_clock_hour("0:00"), 0.0);
  EXPECT_EQ(parse_clock_hour("24:00"), 24.0);
  EXPECT_DOUBLE_EQ(*parse_clock_hour("12:30:36"), 12.51);
  for (const char* wrong : {"", "15", ":30", "15:", "15:3", "15:60", "24:01", "115:30", "-1:30", "15:30:", "15:30:60",
                            "15:30:1", "1e:30", "15:30 "}) {
    EXPECT_FALSE(parse_clock_hour(wrong)) << wrong;
  }
  EXPECT_EQ(clock_hour_text(15.5), "15:30");
  EXPECT_EQ(clock_hour_text(9 - 1e-9), "09:00");
}

// I. Reda and A. Andreas: Solar position algorithm for solar radiation applications, NREL 2003, the example of table
// A5.
TEST(Clock, AgreesWithThePublishedSolarPosition) {
  const ClockZone golden{.longitude = radians(-105.1786), .utc_offset = -7};
  const ClockSun sun = sun_by_clock(radians(39.742476), golden, {2003, 10, 17}, 12 + 30 / 60.0 + 30 / 3600.0);
  EXPECT_NEAR(degrees(sun.position.altitude), 39.872, kAngleError);
  EXPECT_NEAR(degrees(sun.position.azimuth), 194.340, kAngleError);
  EXPECT_NEAR(degrees(sun.declination), -9.31434, kAngleError);
}

// Extremes and zeros of the equation of time, as listed in almanacs, to the day.
TEST(Clock, EquationOfTimeHasTheKnownExtremes) {
  const auto minutes = [](const CalendarDate& date) { return sun_by_clock(0, {}, date, 12).equation_of_time; };
  EXPECT_NEAR(minutes({2026, 2, 11}), -14.2, 0.1);
  EXPECT_NEAR(minutes({2026, 5, 14}), 3.65, 0.1);
  EXPECT_NEAR(minutes({2026, 7, 26}), -6.5, 0.1);
  EXPECT_NEAR(minutes({2026, 11, 3}), 16.45, 0.1);
  for (const CalendarDate& zero :
       {CalendarDate{2026, 4, 15}, CalendarDate{2026, 6, 13}, CalendarDate{2026, 9, 1}, CalendarDate{2026, 12, 25}}) {
    EXPECT_NEAR(minutes(zero), 0, 0.35) << date_text(zero);
  }
}

TEST(Clock, TheSunIsHighestAtSolarNoon) {
  const ClockZone berlin{.longitude = radians(13.4), .utc_offset = 2};
  const double latitude = radians(52.5);
  const ClockSun sun = sun_by_clock(latitude, berlin, {2026, 6, 21}, 12);
  // Summer time is one hour ahead, and Berlin lies 1.6° west of the meridian of its zone, so noon is after 13 h.
  EXPECT_NEAR(sun.solar_hour, 12 - 1 - 1.6 / 15 - 1.8 / 60, 0.01);
  const double noon = 12 + (12 - sun.solar_hour);
  const ClockSun high = sun_by_clock(latitude, berlin, {2026, 6, 21}, noon);
  EXPECT_NEAR(degrees(high.position.azimuth), 180, 0.01);
  EXPECT_NEAR(degrees(high.position.altitude), 90 - 52.5 + 23.437, kAngleError);
}

// Time zone and date only name the moment: equal moments give equal suns.
TEST(Clock, OneMomentIsOneSun) {
  const double latitude = radians(-33.9);
  const ClockSun a = sun_by_clock(latitude, {.longitude = radians(151.2), .utc_offset = 10}, {2026, 3, 1}, 9.5);
  const ClockSun b = sun_by_clock(latitude, {.longitude = radians(151.2), .utc_offset = 0}, {2026, 2, 28}, 23.5);
  EXPECT_NEAR(a.position.altitude, b.position.altitude, 1e-12);
  EXPECT_NEAR(a.position.azimuth, b.position.azimuth, 1e-12);
}

// The simpler formula for solar time must be within half a degree.
TEST(Clock, TheSolarFormulaIsWithinHalfADegree) {
  const double latitude = radians(51.51494);
  for (int k = 0; k < 365; k += 5) {
    const CalendarDate date = later({2026, 1, 1}, k);
    const ClockSun clock = sun_by_clock(latitude, {}, date, 13);
    const SkyDirection solar = sun_position(latitude, day_of_year(date), clock.solar_hour);
    EXPECT_NEAR(degrees(solar.altitude), degrees(clock.position.altitude), 0.5) << date_text(date);
    EXPECT_NEAR(degrees(solar.azimuth), degrees(clock.position.azimuth), 0.7) << date_text(date);
  }
}

}  // namespace meristem::clock_test

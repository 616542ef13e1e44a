// SPDX-License-Identifier: Apache-2.0
// Calendar arithmetic, and the sun's position from clock time by the low-precision formulas of clock.h.
#include "meristem/scene/light/clock.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/math.h"

namespace meristem {
namespace {

constexpr int kFirstYear = 1900;
constexpr int kLastYear = 2100;

bool is_leap(int year) { return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0); }

int days_of_month(int year, int month) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return kDays[static_cast<std::size_t>(month - 1)] + (month == 2 && is_leap(year) ? 1 : 0);
}

/// Returns the whole number with `min` to `max` digits that a text contains, or nothing for other texts.
std::optional<int> whole_number(std::string_view text, std::size_t min, std::size_t max) {
  if (text.size() < min || text.size() > max) return std::nullopt;
  int number = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return number;
}

/// Returns the number of days since 1 January 2000.
int day_number(const CalendarDate& date) {
  const int years = date.year - 2000;
  // Leap days from 2000 up to the previous year. 2000 is itself a leap year.
  const auto leaps_before = [](int year) {
    const int y = year - 1;
    return y / 4 - y / 100 + y / 400;
  };
  return 365 * years + leaps_before(date.year) - leaps_before(2000) + day_of_year(date) - 1;
}

/// Returns the equivalent angle in (-pi, pi].
double half_turn(double angle) {
  const double turns = angle / (2 * kPi);
  return 2 * kPi * (turns - std::ceil(turns - 0.5));
}

}  // namespace

std::optional<CalendarDate> parse_date(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto year = whole_number(text.substr(0, 4), 4, 4);
  const auto month = whole_number(text.substr(5, 2), 2, 2);
  const auto day = whole_number(text.substr(8, 2), 2, 2);
  if (!year || !month || !day || *year < kFirstYear || *year > kLastYear) return std::nullopt;
  if (*month < 1 || *month > 12 || *day < 1 || *day > days_of_month(*year, *month)) return std::nullopt;
  return CalendarDate{*year, *month, *day};
}

std::string date_text(const CalendarDate& date) {
  return fmt::format("{:04}-{:02}-{:02}", date.year, date.month, date.day);
}

int day_of_year(const CalendarDate& date) {
  int day = date.day;
  for (int month = 1; month < date.month; ++month) day += days_of_month(date.year, month);
  return day;
}

CalendarDate later(const CalendarDate& date, int days) {
  CalendarDate to = date;
  int left = day_of_year(date) + days;
  while (left < 1) left += is_leap(--to.year) ? 366 : 365;
  while (left > (is_leap(to.year) ? 366 : 365)) left -= is_leap(to.year++) ? 366 : 365;
  to.month = 1;
  while (left > days_of_month(to.year, to.month)) left -= days_of_month(to.year, to.month++);
  to.day = left;
  return to;
}

int days_between(const CalendarDate& from, const CalendarDate& to) { return day_number(to) - day_number(from); }

std::optional<double> parse_clock_hour(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::string_view rest = text.substr(colon + 1);
  const std::size_t second_colon = rest.find(':');
  const auto hour = whole_number(text.substr(0, colon), 1, 2);
  const auto minute = whole_number(rest.substr(0, second_colon), 2, 2);
  std::optional<int> second = 0;
  if (second_colon != std::string_view::npos) second = whole_number(rest.substr(second_colon + 1), 2, 2);
  if (!hour || !minute || !second || *minute > 59 || *second > 59) return std::nullopt;
  const double hours = *hour + *minute / 60.0 + *second / 3600.0;
  return hours <= 24 ? std::optional(hours) : std::nullopt;
}

std::string clock_hour_text(double hour) {
  const auto minutes = static_cast<int>(std::lround(hour * 60));
  return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
}

ClockSun sun_by_clock(double latitude, const ClockZone& zone, const CalendarDate& date, double hour) {
  const double universal = hour - zone.utc_offset;
  // Days since noon of 1 January 2000.
  const double n = day_number(date) + universal / 24 - 0.5;
  const double mean_longitude = half_turn(radians(280.460 + 0.9856474 * n));
  const double anomaly = half_turn(radians(357.528 + 0.9856003 * n));
  const double longitude =
      mean_longitude + radians(1.915) * math::sin(anomaly) + radians(0.020) * math::sin(2 * anomaly);
  const double obliquity = radians(23.439 - 0.0000004 * n);
  const double ascension = math::atan2(math::cos(obliquity) * math::sin(longitude), math::cos(longitude));

  ClockSun sun;
  sun.declination = math::asin(math::sin(obliquity) * math::sin(longitude));
  sun.equation_of_time = degrees(half_turn(mean_longitude - ascension)) * 4;
  const double solar = universal + degrees(zone.longitude) / 15 + sun.equation_of_time / 60;
  sun.solar_hour = solar - 24 * std::floor(solar / 24);
  sun.position = sun_at_hour(latitude, sun.declination, sun.solar_hour);
  return sun;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Derives the range of an editor's slider from a row: its default, its hard range and its unit. Ends are rounded up to
// 1, 2 or 5 times a power of ten.
#include "meristem/graph/table/usual_range.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace meristem {

namespace {

/// Widens `span` by all numbers of a value, at any depth of lists.
void include_numbers(const Value& value, std::optional<UsualSpan>& span) {
  if (const double* number = value.number(); number != nullptr && std::isfinite(*number)) {
    if (!span) span = UsualSpan{*number, *number};
    span = UsualSpan{std::min(span->low, *number), std::max(span->high, *number)};
  } else if (const Value::List* list = value.list()) {
    for (const Value& element : *list) include_numbers(element, span);
  }
}

/// Returns the least of 1, 2 and 5 times a power of ten that is at least `size`. `size` must be above 0.
double round_up(double size) {
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  double rounded = size;
  for (const int step : std::array<int, 4>{1, 2, 5, 10}) {
    // Parsed from digits, because powers of ten below 1 are not exact.
    const std::string digits = fmt::format("{}e{}", step, exponent);
    std::from_chars(digits.data(), digits.data() + digits.size(), rounded);
    if (size <= rounded * (1 + 1e-9)) break;
  }
  return rounded;
}

/// Returns a common size of numbers with this unit, used if nothing else is known.
double common_size(const Parameter& row) {
  switch (row.form.unit) {
    case Unit::metre:
      return 1;
    case Unit::degree:
      return 180;
    case Unit::per_metre:
    case Unit::step:
      return 100;
    case Unit::per_cubic_metre:
      return 1000;
    case Unit::second:
      return 10;
    case Unit::hour:
      return 24;
    case Unit::day:
      return 365;
    case Unit::none:
      break;
  }
  return row.kind == ParameterKind::integer || row.kind == ParameterKind::integers ? 10 : 1;
}

/// Returns the derived range before rounding to whole numbers. `held` is the span of the default.
UsualSpan derived(const Parameter& row, const std::optional<UsualSpan>& held) {
  const NumberRange& form = row.form;
  const double size = held ? std::max(std::abs(held->low), std::abs(held->high)) : 0;
  if (form.max - form.min <= std::max(2.0, 10 * size)) return {form.min, form.max};
  if (form.unit == Unit::degree) {
    return form.min < 0 ? UsualSpan{std::max(form.min, -180.0), std::min(form.max, 180.0)}
                        : UsualSpan{form.min, std::min(form.max, 360.0)};
  }
  double reach = size > 0 ? round_up(4 * size) : common_size(row);
  // The hard range may begin beyond this range.
  if (form.min >= reach) reach = round_up(2 * form.min);
  if (form.max <= -reach) reach = round_up(-2 * form.max);
  return {form.min < 0 ? std::max(form.min, -reach) : form.min, form.max > 0 ? std::min(form.max, reach) : form.max};
}

/// Returns the numbers at one index of all pairs of a list; null if there is no list.
Value numbers_of_points(const Value& points, std::size_t index) {
  if (points.list() == nullptr) return {};
  Value::List numbers;
  for (const Value& point : *points.list()) {
    if (point.list() != nullptr && index < point.list()->size()) numbers.push_back((*point.list())[index]);
  }
  return numbers;
}

}  // namespace

bool has_numbers(const Parameter& row) {
  switch (row.kind) {
    case ParameterKind::number:
    case ParameterKind::integer:
    case ParameterKind::integers:
    case ParameterKind::vector:
    case ParameterKind::box:
    case ParameterKind::points:
    case ParameterKind::positions:
      return true;
    default:
      return false;
  }
}

UsualSpan usual_range(const Parameter& row, const Value& fallback) {
  const NumberRange& form = row.form;
  std::optional<UsualSpan> held;
  include_numbers(fallback, held);

  UsualSpan span = derived(row, held);
  if (!std::isnan(form.usual.low)) span.low = form.usual.low;
  if (!std::isnan(form.usual.high)) span.high = form.usual.high;
  if (held) span = {std::min(span.low, held->low), std::max(span.high, held->high)};

  // The given end may lie beyond the derived one.
  const double size = std::max({std::abs(span.low), std::abs(span.high), common_size(row)});
  if (span.low >= span.high && std::isnan(form.usual.high)) span.high = std::min(form.max, span.low + size);
  if (span.low >= span.high && std::isnan(form.usual.low)) span.low = std::max(form.min, span.high - size);
  const bool is_whole = row.kind == ParameterKind::integer || row.kind == ParameterKind::integers;
  if (form.above_min && span.low <= form.min) {
    // Moves up by a tenth of the way to the default. Without a default, as for required rows, moves up by a hundredth
    // of the range.
    const double way = held && held->low > form.min ? (held->low - form.min) / 10 : (span.high - form.min) / 100;
    span.low = is_whole ? std::floor(form.min) + 1 : form.min + way;
  }
  if (is_whole) span = {std::ceil(span.low), std::floor(span.high)};
  return span;
}

std::pair<UsualSpan, UsualSpan> usual_ranges_of_points(const Parameter& row, const Value& fallback) {
  if (!row.second) return {usual_range(row, fallback), usual_range(row, fallback)};
  Parameter second = row;
  second.form = *row.second;
  return {usual_range(row, numbers_of_points(fallback, 0)), usual_range(second, numbers_of_points(fallback, 1))};
}

}  // namespace meristem

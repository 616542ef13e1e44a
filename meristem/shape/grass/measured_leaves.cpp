// SPDX-License-Identifier: Apache-2.0
// Reads digitised midribs and widths from tables and checks them. Rows are grouped into curves by rank, leaf and age.
// The narrow end of a list of widths is taken as the tip.
#include "meristem/shape/grass/measured_leaves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "meristem/base/read_columns.h"

namespace meristem {

namespace {

constexpr std::size_t kMinPoints = 3;
constexpr double kEnd = 0.1;             // share of the rows at either end whose mean widths distinguish base and tip
constexpr double kTipOverBase = 0.5;     // maximum width of a tip relative to the base
constexpr double kMaxNumber = 1e6;       // maximum rank or lindex
constexpr std::size_t kMaxErrors = 100;  // maximum number of errors per curve
constexpr double kMaxCoordinate = 1e9;   // maximum coordinate, in any unit
constexpr double kSamePoint = 1e-6;      // share of a curve's length: points nearer to one another count as equal

/// Collects the errors of one curve.
class CurveErrors {
 public:
  explicit CurveErrors(const MeasuredCurve& curve) : curve_(curve) {}

  void add(std::size_t point, std::string message, std::string expected) {
    if (errors_.size() >= kMaxErrors) return;
    Diagnostic found{.message = std::move(message), .expected = std::move(expected)};
    if (point < curve_.lines.size()) found.line = curve_.lines[point];
    if (curve_.lines.empty()) found.message = fmt::format("row {}: {}", point, found.message);
    errors_.push_back(std::move(found));
  }
  void throw_if_any() {
    if (!errors_.empty()) throw InputError(std::move(errors_));
  }

 private:
  const MeasuredCurve& curve_;
  std::vector<Diagnostic> errors_;
};

void check_points(const MeasuredCurve& curve, const char* what, CurveErrors& errors) {
  if (curve.points.size() < kMinPoints) {
    errors.add(0, fmt::format("{} have {} points", what, curve.points.size()), fmt::format("at least {}", kMinPoints));
  }
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const glm::dvec2 point = curve.points[k];
    if (!std::isfinite(point.x + point.y)) {
      errors.add(k, fmt::format("a point of {} is not finite", what), "two finite numbers");
    } else if (std::max(std::abs(point.x), std::abs(point.y)) > kMaxCoordinate) {
      errors.add(k, fmt::format("a point of {} is too far from 0", what), "numbers up to 1e9");
    }
  }
  errors.throw_if_any();
}

/// What distinguishes the curves of one file.
using CurveName = std::tuple<std::optional<int>, std::optional<int>, std::optional<double>>;

struct CurveColumns {
  std::size_t rank, lindex, age, first, second;
};

std::string shown(const CurveName& name) {
  std::string text;
  const auto add = [&](const char* word, const auto& number) {
    if (number) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word, *number);
  };
  add("rank", std::get<0>(name));
  add("lindex", std::get<1>(name));
  add("age", std::get<2>(name));
  return text;
}

std::optional<int> whole(const Columns& columns, std::size_t column, std::size_t row, std::vector<Diagnostic>& errors) {
  if (!columns.has(column)) return std::nullopt;
  const double number = columns.numbers[column][row];
  if (number == std::floor(number) && std::abs(number) <= kMaxNumber) return static_cast<int>(number);
  errors.push_back({.message = fmt::format("{} is not a whole number", number),
                    .expected = "the number of a rank or leaf",
                    .line = columns.lines[row]});
  return 0;
}

/// Splits the rows into curves.
std::vector<MeasuredCurve> curves_of(const Columns& columns, const CurveColumns& at, std::vector<Diagnostic>& errors) {
  std::vector<MeasuredCurve> curves;
  std::set<CurveName> known;
  CurveName last;
  for (std::size_t row = 0; row < columns.row_count() && errors.size() < kMaxErrors; ++row) {
    const CurveName name{whole(columns, at.rank, row, errors), whole(columns, at.lindex, row, errors),
                         columns.has(at.age) ? std::optional(columns.numbers[at.age][row]) : std::nullopt};
    if (curves.empty() || name != last) {
      if (!known.insert(name).second) {
        errors.push_back({.message = fmt::format("{} appears a second time", shown(name)),
                          .expected = "all rows of a leaf together",
                          .line = columns.lines[row]});
      }
      curves.push_back({std::get<0>(name), std::get<1>(name), std::get<2>(name), {}, {}});
      last = name;
    }
    curves.back().points.emplace_back(columns.numbers[at.first][row], columns.numbers[at.second][row]);
    curves.back().lines.push_back(columns.lines[row]);
  }
  return curves;
}

/// Calls `check` for each curve and collects the errors that it throws.
template <class Check>
void check_all(std::vector<MeasuredCurve>& curves, const SizeLimits& limits, std::vector<Diagnostic>& errors,
               Check check) {
  for (MeasuredCurve& curve : curves) {
    if (errors.size() >= limits.diagnostics) break;
    try {
      check(curve);
    } catch (const InputError& error) {
      errors.insert(errors.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
  }
  if (errors.size() > limits.diagnostics) errors.resize(limits.diagnostics);
  if (!errors.empty()) throw InputError(std::move(errors));
}

/// Returns the distance below which points count as equal. Also computes the distance of each point from the point
/// before.
double nearest_of_midrib(const MeasuredCurve& midrib) {
  double length = 0;
  for (std::size_t k = 1; k < midrib.points.size(); ++k) {
    length += glm::distance(midrib.points[k - 1], midrib.points[k]);
  }
  return kSamePoint * length;
}
double nearest_of_widths(const MeasuredCurve& widths) {
  return kSamePoint * std::max(std::abs(widths.points.front().x), std::abs(widths.points.back().x));
}

/// Removes the points whose `distance` from the point before is at most `nearest`, with a warning each. A curve that
/// would have too few points left stays unchanged, so that its errors are reported.
template <class Distance>
void leave_out_repeats(MeasuredCurve& curve, double nearest, Distance distance, const char* what,
                       const SizeLimits& limits, std::vector<Diagnostic>& warnings) {
  if (!std::isfinite(nearest)) return;
  MeasuredCurve kept{curve.rank, curve.lindex, curve.age, {}, {}};
  std::vector<Diagnostic> found;
  const std::string name = shown({curve.rank, curve.lindex, curve.age});
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    if (!kept.points.empty() && distance(kept.points.back(), curve.points[k]) <= nearest) {
      found.push_back({.severity = Severity::warning,
                       .message = fmt::format("{}{} repeats the one before it and is left out",
                                              name.empty() ? name : name + ": ", what),
                       .line = curve.lines[k]});
      continue;
    }
    kept.points.push_back(curve.points[k]);
    kept.lines.push_back(curve.lines[k]);
  }
  if (found.empty() || kept.points.size() < kMinPoints) return;
  curve = std::move(kept);
  for (Diagnostic& each : found) {
    if (warnings.size() < limits.diagnostics) warnings.push_back(std::move(each));
  }
}

double mean_width(const std::vector<glm::dvec2>& points, std::size_t first, std::size_t count) {
  double sum = 0;
  for (std::size_t k = first; k < first + count; ++k) sum += points[k].y;
  return sum / static_cast<double>(count);
}

}  // namespace

void check_midrib(const MeasuredCurve& midrib) {
  CurveErrors errors(midrib);
  check_points(midrib, "midribs", errors);
  const double nearest = nearest_of_midrib(midrib);
  for (std::size_t k = 1; k < midrib.points.size(); ++k) {
    if (glm::distance(midrib.points[k - 1], midrib.points[k]) <= nearest) {
      errors.add(k, "the point of the midrib repeats the one in the row before", "another one");
    }
  }
  errors.throw_if_any();
}

void check_widths(const MeasuredCurve& widths) {
  CurveErrors errors(widths);
  check_points(widths, "widths", errors);
  const std::vector<glm::dvec2>& points = widths.points;
  const double length = points.back().x - points.front().x;
  const double direction = length > 0 ? 1 : -1;
  const double nearest = nearest_of_widths(widths);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double step = k == 0 ? length : points[k].x - points[k - 1].x;
    if (k > 0 && std::abs(step) <= nearest) {
      errors.add(k, fmt::format("the position s = {} repeats the one in the row before", points[k].x), "another one");
    } else if (step * direction < 0) {
      errors.add(k, fmt::format("the positions s are not sorted: {} after {}", points[k].x, points[k - 1].x),
                 "positions that rise from base to tip");
    }
    if (points[k].x < 0) errors.add(k, fmt::format("the position s = {} is negative", points[k].x), "0 or more");
    if (points[k].y < 0) errors.add(k, fmt::format("the width {} is negative", points[k].y), "0 or more");
  }
  const bool has_width = std::ranges::any_of(points, [](glm::dvec2 point) { return point.y > 0; });
  if (!has_width) errors.add(0, "no width is above 0", "a blade");
  errors.throw_if_any();
}

bool turn_to_base(MeasuredCurve& widths) {
  std::vector<glm::dvec2>& points = widths.points;
  const bool falls = points.front().x > points.back().x;
  if (falls) {
    std::ranges::reverse(points);
    std::ranges::reverse(widths.lines);
  }
  const auto count = std::max<std::size_t>(1, static_cast<std::size_t>(kEnd * static_cast<double>(points.size())));
  if (mean_width(points, 0, count) >= kTipOverBase * mean_width(points, points.size() - count, count)) return falls;
  const double ends = points.front().x + points.back().x;
  for (glm::dvec2& point : points) point.x = ends - point.x;
  std::ranges::reverse(points);
  std::ranges::reverse(widths.lines);
  return true;
}

std::vector<MeasuredCurve> read_midribs(std::string_view text, const SizeLimits& limits,
                                        std::vector<Diagnostic>& warnings) {
  const Columns columns = read_columns(text,
                                       {{"rank", false},
                                        {"lindex", false},
                                        {"age", false},
                                        {.name = "x", .limit = kFileCoordinate},
                                        {.name = "y", .limit = kFileCoordinate}},
                                       limits);
  std::vector<Diagnostic> errors;
  std::vector<MeasuredCurve> midribs =
      curves_of(columns, {.rank = 0, .lindex = 1, .age = 2, .first = 3, .second = 4}, errors);
  const auto distance = [](glm::dvec2 a, glm::dvec2 b) { return glm::distance(a, b); };
  check_all(midribs, limits, errors, [&](MeasuredCurve& midrib) {
    leave_out_repeats(midrib, nearest_of_midrib(midrib), distance, "the point of the midrib", limits, warnings);
    check_midrib(midrib);
  });
  return midribs;
}

std::vector<MeasuredCurve> read_widths(std::string_view text, const SizeLimits& limits,
                                       std::vector<Diagnostic>& warnings) {
  Columns columns = read_columns(text,
                                 {{"rank", false},
                                  {"rankclass", false},
                                  {"lindex", false},
                                  {"age", false},
                                  {.name = "s", .limit = kFileCoordinate},
                                  {.name = "r", .limit = kFileCoordinate}},
                                 limits);
  const std::size_t rank = columns.has(0) ? 0 : 1;
  std::vector<Diagnostic> errors;
  std::vector<MeasuredCurve> all =
      curves_of(columns, {.rank = rank, .lindex = 2, .age = 3, .first = 4, .second = 5}, errors);
  const auto distance = [](glm::dvec2 a, glm::dvec2 b) { return std::abs(a.x - b.x); };
  check_all(all, limits, errors, [&](MeasuredCurve& widths) {
    leave_out_repeats(widths, nearest_of_widths(widths), distance, "the position s", limits, warnings);
    check_widths(widths);
    const int line = widths.lines.front();
    if (turn_to_base(widths)) {
      warnings.push_back({.severity = Severity::warning,
                          .message = "the widths run from the tip to the base; they are turned about",
                          .line = line});
    }
  });
  return all;
}

}  // namespace meristem

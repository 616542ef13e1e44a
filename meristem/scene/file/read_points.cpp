// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/file/read_points.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/number_limit.h"
#include "meristem/base/read_file.h"
#include "meristem/scene/file/ply_file.h"
#include "meristem/scene/file/text_scanner.h"

namespace meristem {

namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

[[noreturn]] void throw_too_many(double count, const SizeLimits& limits, const std::string& file) {
  Diagnostic diagnostic = limit_diagnostic("points of a file", count, limits.points, "points", "");
  diagnostic.file = file;
  throw InputError(std::move(diagnostic));
}

PointCloud parse_ply_points(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  const PlyFile ply(bytes, file);
  const PlyElement* vertices = ply.find("vertex");
  if (vertices == nullptr) {
    std::vector<std::string> names;
    for (const PlyElement& element : ply.elements()) names.push_back(element.name);
    throw InputError(Diagnostic{.message = "the file has no element 'vertex'",
                                .expected = "an element 'vertex' with the properties x, y and z",
                                .nearest = nearest_name("vertex", names),
                                .file = file});
  }
  std::array<std::size_t, 3> columns{};
  for (std::size_t k = 0; k < 3; ++k) columns[k] = ply.need(*vertices, kAxes[k]);
  if (vertices->count > limits.points) throw_too_many(static_cast<double>(vertices->count), limits, file);
  PointCloud points;
  ply.read([&](const PlyElement& element, const PlyRow& row) {
    if (&element != vertices) return;
    DVec3& point = points.emplace_back();
    for (int k = 0; k < 3; ++k) {
      point[k] = row.values[columns[static_cast<std::size_t>(k)]];
      if (kFileCoordinate.holds(point[k])) continue;
      const char* const axis = kAxes[static_cast<std::size_t>(k)];
      if (!std::isfinite(point[k]))
        ply.fail(element, row, fmt::format("{} is not a finite number", axis), "a number (m)");
      const Diagnostic error = number_error(fmt::format("{} = {:.6g}", axis, point[k]), kFileCoordinate);
      ply.fail(element, row, error.message, error.expected);
    }
  });
  return points;
}

bool is_comment(std::string_view word) { return word.starts_with('#') || word.starts_with("//"); }

PointCloud parse_text(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  TextScanner text(bytes, file, ",;");
  PointCloud points;
  bool may_be_heading = true;
  do {
    std::string_view word = text.word();
    if (word.empty() || is_comment(word)) continue;
    const bool is_first = std::exchange(may_be_heading, false);
    if (is_first && !parse_number(word)) continue;
    DVec3 point(0);
    for (int k = 0; k < 3; ++k) {
      const char* const axis = kAxes[static_cast<std::size_t>(k)];
      if (k > 0) word = text.word();
      if (word.empty() || is_comment(word)) text.fail(fmt::format("the line has no {}", axis), "three numbers x, y, z");
      const std::optional<double> number = parse_number(word);
      if (!number) text.fail(fmt::format("{} is not a number", in_quotes(word)), fmt::format("{} (m)", axis));
      if (!std::isfinite(*number)) text.fail(fmt::format("{} is not a finite number", axis), "a number (m)");
      if (!kFileCoordinate.holds(*number)) text.fail(number_error(in_quotes(word), kFileCoordinate));
      point[k] = *number;
    }
    if (points.size() >= limits.points) throw_too_many(static_cast<double>(points.size()) + 1, limits, file);
    points.push_back(point);
  } while (text.next_line());
  return points;
}

}  // namespace

PointCloud parse_points(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  PointCloud points = PlyFile::begins(bytes) ? parse_ply_points(bytes, file, limits) : parse_text(bytes, file, limits);
  if (points.empty()) {
    throw InputError(Diagnostic{.message = "the file has no points", .expected = "a point or more", .file = file});
  }
  return points;
}

PointCloud read_points(const std::string& path, const SizeLimits& limits) {
  return parse_points(read_file(path, limits.file_bytes), path, limits);
}

}  // namespace meristem

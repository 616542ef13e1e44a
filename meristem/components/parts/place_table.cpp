// SPDX-License-Identifier: Apache-2.0
// Reads tables of plant positions and converts their coordinates to the scene.
#include "meristem/components/parts/place_table.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/in_quotes.h"
#include "meristem/base/math.h"

namespace meristem {

namespace {

constexpr double kEarthRadius = 6371008.8;  // mean radius, metres
// The permitted range of a column, equal to the range of the document's keys.
struct ColumnRange {
  double low = 0;
  double high = 0;
};
constexpr ColumnRange kMetres{-1e7, 1e7}, kLongitudes{-360, 360}, kLatitudes{-90, 90}, kTurns{-1e6, 1e6},
    kScales{1e-4, 1e4};

/// Finds the columns with positions and checks that they contain numbers.
class PlaceColumns {
 public:
  PlaceColumns(PlaceTable& places, std::string_view text, const SizeLimits& limits)
      : places_(places), text_(text), limits_(limits) {}

  void find() {
    find_ground();
    if (places_.ground == PlaceTable::Ground::plan) places_.height = optional("y");
    if (places_.height == nullptr) places_.height = optional("height");
    places_.rotation = optional("rotation");
    places_.scale = optional("scale");
    const bool is_on_globe = places_.ground == PlaceTable::Ground::degrees;
    check_numbers(places_.east, is_on_globe ? kLongitudes : kMetres);
    check_numbers(places_.north, is_on_globe ? kLatitudes : kMetres);
    check_numbers(places_.height, kMetres);
    check_numbers(places_.rotation, kTurns);
    check_numbers(places_.scale, kScales);
    if (!errors_.empty()) throw InputError(std::move(errors_));
  }

 private:
  const TextTable::Column* optional(const char* name) const { return places_.table.find(name); }

  void find_ground() {
    using Ground = PlaceTable::Ground;
    struct Pair {
      const char* east;
      const char* north;
      Ground ground;
    };
    for (const Pair& pair :
         {Pair{"x", "z", Ground::plan}, Pair{"x", "y", Ground::map}, Pair{"lon", "lat", Ground::degrees}}) {
      places_.east = optional(pair.east);
      places_.north = optional(pair.north);
      places_.ground = pair.ground;
      if (places_.east != nullptr && places_.north != nullptr) return;
    }
    const std::vector<std::string> names = places_.table.names();
    // Suggest the nearest name for a probable typing error: for the first missing name that has one.
    std::string nearest;
    for (const char* wanted : {"lon", "lat", "x", "z", "y"}) {
      if (nearest.empty() && optional(wanted) == nullptr) nearest = nearest_name(wanted, names);
    }
    std::string has;
    for (const char* one : {"x", "y", "z", "lon", "lat"}) {
      if (optional(one) != nullptr) has += fmt::format("{}'{}'", has.empty() ? "" : " and ", one);
    }
    throw InputError(
        Diagnostic{.message = fmt::format("the table does not say where its rows stand: it has {}",
                                          has.empty() ? "no such columns" : has + " alone"),
                   .expected = "the columns 'x' and 'z' (scene), 'x' and 'y' (map, y to the north), or 'lon' and 'lat'",
                   .nearest = nearest,
                   .line = 1});
  }

  /// Checks that a column, which may be null, contains numbers in a range.
  void check_numbers(const TextTable::Column* found, ColumnRange range) {
    if (found == nullptr) return;
    const TextTable::Column& column = *found;
    if (!column.has_numbers()) {
      const std::string_view cell = std::string_view(column.text(column.odd_row)).substr(0, 40);
      return tell(column.odd_row, column.odd_column,
                  fmt::format("{} in the column '{}' is not a number", in_quotes(cell), column.name),
                  "a finite number");
    }
    for (std::size_t row = 0; row < column.numbers.size(); ++row) {
      const double number = column.numbers[row];
      if (number >= range.low && number <= range.high) continue;
      if (errors_.size() >= limits_.diagnostics) return;
      tell(row, column_of_cell(text_, places_.table.lines[row], column.name),
           fmt::format("{:.6g} in the column '{}' is out of its range", number, column.name),
           fmt::format("a number from {:.6g} to {:.6g}", range.low, range.high));
    }
  }

  void tell(std::size_t row, int column, std::string message, std::string expected) {
    if (errors_.size() >= limits_.diagnostics) return;
    errors_.push_back({.message = std::move(message),
                       .expected = std::move(expected),
                       .line = places_.table.lines[row],
                       .column = column});
  }

  PlaceTable& places_;
  std::string_view text_;
  const SizeLimits& limits_;
  std::vector<Diagnostic> errors_;
};

double middle_of(const std::vector<double>& numbers) {
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  return *low + (*high - *low) / 2;
}

}  // namespace

PlaceTable::PlaceTable(PlaceTable&& other) noexcept
    : file(std::move(other.file)),
      table(std::move(other.table)),  // moving the table does not move its columns in memory
      ground(other.ground),
      east(other.east),
      north(other.north),
      height(other.height),
      rotation(other.rotation),
      scale(other.scale),
      middle(other.middle) {}

Vec3 PlaceTable::position(std::size_t row, DVec3 origin) const {
  const double right = east->numbers[row] - origin.x;
  const double ahead = north->numbers[row] - origin.y;
  const double up = height == nullptr ? 0 : height->numbers[row];
  switch (ground) {
    case Ground::plan:
      return Vec3(DVec3(right, up, ahead));
    case Ground::map:
      return Vec3(DVec3(right, up, -ahead));
    case Ground::degrees:
      break;
  }
  const double metres = kEarthRadius * kPi / 180;  // metres per degree along a meridian
  return Vec3(DVec3(right * metres * math::cos(origin.y * kPi / 180), up, -ahead * metres));
}

PlaceTable read_place_table(const std::string& text, const std::string& file_path, ParameterReader& reader,
                            std::vector<Diagnostic>&) {
  PlaceTable places;
  places.file = std::filesystem::path(file_path).filename().string();
  places.table = read_text_table(text, reader.limits());
  PlaceColumns(places, text, reader.limits()).find();
  places.middle = {middle_of(places.east->numbers), middle_of(places.north->numbers), 0};
  return places;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Reports shade as CSV, JSON values or a picture with axes. The picture is a grid of coloured cells with labels in
// small letters.
#include "meristem/export/shade/shade_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "meristem/output/write/csv.h"
#include "meristem/output/write/small_text.h"

namespace meristem {
namespace {

constexpr int kMapSize = 720;  // approximate size of a map's longer side, pixels
constexpr int kMapMargin = 20;
constexpr int kScale = 2;  // size of a dot of the letters, pixels
constexpr Pixel kInk = {40, 40, 40};
constexpr Pixel kNone = {190, 190, 190};  // night, and cells with an obstacle

/// Returns the colour of a share, from full sun (0) to full shade (1).
Pixel colour_of(double share) {
  constexpr std::array<std::array<double, 3>, 4> kStops = {
      {{255, 243, 176}, {244, 178, 86}, {125, 95, 136}, {24, 40, 78}}};
  const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  Pixel pixel{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double mixed = kStops[low][k] + (place - static_cast<double>(low)) * (kStops[low + 1][k] - kStops[low][k]);
    pixel[k] = static_cast<std::uint8_t>(std::lround(mixed));
  }
  return pixel;
}

/// Shares in cells, row 0 at the bottom.
struct Cells {
  int columns = 0;
  int rows = 0;
  std::vector<std::optional<double>> shares;

  const std::optional<double>& at(int column, int row) const {
    return shares[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
};

Cells cells_of_grid(const ShadeSurface& surface, const std::vector<double>& of_point) {
  Cells cells{surface.columns, surface.rows, {}};
  std::size_t next = 0;
  for (const std::uint8_t has_point : surface.has_point) {
    cells.shares.push_back(has_point != 0 ? std::optional(of_point[next++]) : std::nullopt);
  }
  return cells;
}

Cells cells_of_moments(const ShadePlan& plan, const ShadeOfSurface& shade) {
  Cells cells{static_cast<int>(plan.days.size()), static_cast<int>(plan.hours.size()), {}};
  for (std::size_t hour = 0; hour < plan.hours.size(); ++hour) {
    for (std::size_t day = 0; day < plan.days.size(); ++day) {
      const std::size_t k = day * plan.hours.size() + hour;
      const bool is_day = plan.sun[k].altitude > 0;
      cells.shares.push_back(is_day ? std::optional(shade.moments[k].shade) : std::nullopt);
    }
  }
  return cells;
}

/// A picture with white margins around square cells.
class MapPicture {
 public:
  MapPicture(const Cells& cells, int cell_width, int cell_height, int left, int below)
      : width_(cells.columns * cell_width), height_(cells.rows * cell_height), left_(left) {
    const int whole_width = left + std::max(width_, kLegendWidth) + 3 * kMapMargin;
    const int whole_height = kMapMargin + height_ + below + kLegendHeight + kMapMargin;
    image_ = {whole_width, whole_height, std::vector<std::uint8_t>(std::size_t{4} * whole_width * whole_height, 255)};
    for (int row = 0; row < cells.rows; ++row) {
      for (int column = 0; column < cells.columns; ++column) {
        const std::optional<double>& share = cells.at(column, row);
        fill(left + column * cell_width, kMapMargin + height_ - (row + 1) * cell_height, cell_width, cell_height,
             share ? colour_of(*share) : kNone);
      }
    }
    add_legend(kMapMargin + height_ + below);
  }

  int top() const { return kMapMargin; }
  int bottom() const { return kMapMargin + height_; }
  int left() const { return left_; }
  int width() const { return width_; }

  void fill(int x, int y, int width, int height, Pixel colour) {
    for (int row = std::max(y, 0); row < std::min(y + height, image_.height); ++row) {
      for (int column = std::max(x, 0); column < std::min(x + width, image_.width); ++column) {
        std::copy(colour.begin(), colour.end(), image_.pixel(column, row));
      }
    }
  }
  void text(int x, int y, std::string_view words) { draw_small_text(image_, x, y, kScale, kInk, words); }

  Image take() { return std::move(image_); }

 private:
  static constexpr int kLegendWidth = 240;
  static constexpr int kLegendHeight = 16 + 4 + kSmallTextHeight * kScale;

  void add_legend(int y) {
    for (int k = 0; k < kLegendWidth; ++k) {
      fill(left_ + k, y, 1, 16, colour_of(static_cast<double>(k) / (kLegendWidth - 1)));
    }
    text(left_, y + 20, "0 %");
    text(left_ + kLegendWidth - small_text_width("100 %", kScale), y + 20, "100 %");
  }

  Image image_;
  int width_;
  int height_;
  int left_;
};

/// Returns a length of 1, 2 or 5 times a power of ten, about a fifth of the map.
double scale_length(double width) {
  const double decade = std::pow(10, std::floor(std::log10(width / 5)));
  for (const double times : {5.0, 2.0}) {
    if (times * decade <= width / 5) return times * decade;
  }
  return decade;
}

Image ground_picture(const ShadePlan& plan, const ShadeOfSurface& shade) {
  const ShadeSurface& surface = plan.surface;
  const Cells cells = cells_of_grid(surface, shade.of_point);
  const int cell = std::max(1, kMapSize / std::max(cells.columns, cells.rows));
  constexpr int kBelow = kMapMargin + kSmallTextHeight * kScale + kMapMargin;
  MapPicture map(cells, cell, cell, kMapMargin, kBelow);
  // Cells have equal widths, and the cells with points have the total area of the surface.
  const double cell_area = surface.area / static_cast<double>(surface.positions.size());
  const double width = cells.columns * std::sqrt(cell_area);
  const double length = scale_length(width);
  map.fill(map.left(), map.bottom() + 10, static_cast<int>(std::lround(length / width * map.width())), 3, kInk);
  map.text(map.left(), map.bottom() + kMapMargin, fmt::format("{:.6g} m", length));
  return map.take();
}

Image moments_picture(const ShadePlan& plan, const ShadeOfSurface& shade) {
  const Cells cells = cells_of_moments(plan, shade);
  const int width = std::clamp(kMapSize / std::max(cells.columns, 1), 1, 120);
  const int height = std::clamp(480 / std::max(cells.rows, 1), 1, 40);
  const int letters = kSmallTextHeight * kScale;
  const int left = kMapMargin + small_text_width("00:00", kScale) + 8;
  MapPicture map(cells, width, height, left, kMapMargin + letters);
  // Label as many hours and days as there is room for.
  const auto hours = static_cast<int>(plan.hours.size());
  const int every_hours = std::max(1, (letters + 6 + height - 1) / height);
  for (int k = 0; k < hours; k += every_hours) {
    const int y = map.bottom() - k * height - height / 2 - letters / 2;
    map.text(kMapMargin, y, clock_hour_text(plan.hours[static_cast<std::size_t>(k)]));
  }
  const auto label = [](const ShadeDay& day) { return day.date ? date_text(*day.date).substr(5) : day.text(); };
  const int room = small_text_width(label(plan.days[0]), kScale) + 12;
  const int every_days = std::max(1, (room + width - 1) / width);
  for (int k = 0; k < cells.columns; k += every_days) {
    map.text(left + k * width + 2, map.bottom() + 6, label(plan.days[static_cast<std::size_t>(k)]));
  }
  return map.take();
}

/// Appends a number and the following character. The number is left out at night.
void append(double number, char after, std::string& out) {
  if (std::isfinite(number)) append_csv_number(static_cast<float>(number), out);
  out += after;
}

Value number_or_null(bool is_there, double number) { return is_there ? Value(number) : Value(); }

Value rows_of(const Cells& cells) {
  Value::List rows;
  for (int row = 0; row < cells.rows; ++row) {
    Value::List values;
    for (int column = 0; column < cells.columns; ++column) {
      const std::optional<double>& share = cells.at(column, row);
      values.push_back(number_or_null(share.has_value(), share.value_or(0)));
    }
    rows.emplace_back(std::move(values));
  }
  return rows;
}

}  // namespace

std::string shade_csv(const ShadePlan& plan, const ShadeOfSurface& shade) {
  std::string text = "day,hour,solar_hour,azimuth,altitude,cosine,direct,shade,shade_without_plants\n";
  for (std::size_t k = 0; k < plan.sun.size(); ++k) {
    const ShadeMoment& moment = shade.moments[k];
    text += plan.days[k / plan.hours.size()].text() + ',';
    append(plan.hours[k % plan.hours.size()], ',', text);
    append(plan.solar_hours[k], ',', text);
    append(degrees(plan.sun[k].azimuth), ',', text);
    append(degrees(plan.sun[k].altitude), ',', text);
    if (!(plan.sun[k].altitude > 0)) {
      text += ",,,\n";
      continue;
    }
    append(moment.cosine, ',', text);
    append(moment.direct, ',', text);
    append(moment.shade, ',', text);
    append(moment.shade_without_plants, '\n', text);
  }
  return text;
}

Value shade_value(const ShadePlan& plan, const ShadeOfSurface& shade) {
  Value::List moments;
  for (std::size_t k = 0; k < plan.sun.size(); ++k) {
    const ShadeMoment& moment = shade.moments[k];
    const ShadeDay& day = plan.days[k / plan.hours.size()];
    const bool is_day = plan.sun[k].altitude > 0;
    Value::Object row;
    row.emplace_back("day", day.date ? Value(date_text(*day.date)) : Value(static_cast<double>(day.day)));
    row.emplace_back("hour", plan.hours[k % plan.hours.size()]);
    row.emplace_back("solar_hour", plan.solar_hours[k]);
    row.emplace_back("azimuth", degrees(plan.sun[k].azimuth));
    row.emplace_back("altitude", degrees(plan.sun[k].altitude));
    row.emplace_back("cosine", number_or_null(is_day, moment.cosine));
    row.emplace_back("direct", number_or_null(is_day, moment.direct));
    row.emplace_back("shade", number_or_null(is_day, moment.shade));
    row.emplace_back("shade_without_plants", number_or_null(is_day, moment.shade_without_plants));
    moments.emplace_back(std::move(row));
  }
  Value::Object object{{"area", plan.surface.area},
                       {"points", static_cast<double>(plan.surface.positions.size())},
                       {"clock_time", plan.is_clock_time},
                       {"moments", std::move(moments)}};
  if (plan.surface.columns > 0) {
    object.emplace_back("grid", Value::Object{{"columns", static_cast<double>(plan.surface.columns)},
                                              {"rows", static_cast<double>(plan.surface.rows)},
                                              {"shade", rows_of(cells_of_grid(plan.surface, shade.of_point))},
                                              {"shade_without_plants",
                                               rows_of(cells_of_grid(plan.surface, shade.of_point_without_plants))}});
  }
  return object;
}

std::string shade_points_csv(const ShadePlan& plan, const ShadeOfSurface& shade) {
  std::string text = "x,y,z,shade,shade_without_plants\n";
  for (std::size_t k = 0; k < plan.surface.positions.size(); ++k) {
    const Vec3 position = plan.surface.positions[k];
    append(position.x, ',', text);
    append(position.y, ',', text);
    append(position.z, ',', text);
    append(shade.of_point[k], ',', text);
    append(shade.of_point_without_plants[k], '\n', text);
  }
  return text;
}

Image shade_picture(const ShadePlan& plan, const ShadeOfSurface& shade, bool as_map) {
  return as_map ? ground_picture(plan, shade) : moments_picture(plan, shade);
}

}  // namespace meristem

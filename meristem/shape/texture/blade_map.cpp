// SPDX-License-Identifier: Apache-2.0
// Draws an outline into pixels. Coverage is exact along rows and sampled at four heights of each row. Distances are
// measured between the middles of pixels.
//
// Based on: Felzenszwalb, Huttenlocher: Distance transforms of sampled functions (2012), the lower envelope.
#include "meristem/shape/texture/blade_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meristem/base/parallel.h"

namespace meristem {

namespace {

constexpr int kHeights = 4;  // heights at which a row of pixels is sampled
constexpr std::size_t kMapRowsPerBlock = 8;

const std::vector<Vec2> kUnitSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// Adds the part of each pixel that lies in [from, to), in pixels, times `weight`.
void add_span(float from, float to, float weight, float* row, int pixels) {
  from = std::clamp(from, 0.0F, static_cast<float>(pixels));
  to = std::clamp(to, 0.0F, static_cast<float>(pixels));
  for (int x = static_cast<int>(from); x < pixels && static_cast<float>(x) < to; ++x) {
    const float left = std::max(from, static_cast<float>(x));
    const float right = std::min(to, static_cast<float>(x + 1));
    row[x] += weight * std::max(0.0F, right - left);
  }
}

/// Draws one row's coverage and extent. Returns true if the outline meets the row.
bool draw_row(const std::vector<Vec2>& outline, int y, int pixels, float* cover, BladeMap::Reach& reach) {
  const auto size = static_cast<float>(pixels);
  BladeMap::Reach found{1, 0};
  for (int k = 0; k < kHeights; ++k) {
    const float down = static_cast<float>(y) + (static_cast<float>(k) + 0.5F) / kHeights;
    const std::vector<float> crossed = crossings(outline, 1, 1 - down / size);
    for (std::size_t c = 0; c + 1 < crossed.size(); c += 2) {
      add_span(crossed[c] * size, crossed[c + 1] * size, 1.0F / kHeights, cover, pixels);
    }
    if (crossed.empty()) continue;
    found.low = std::min(found.low, crossed.front());
    found.high = std::max(found.high, crossed.back());
  }
  if (found.low >= found.high) return false;
  reach = found;
  return true;
}

/// Gives rows without an extent the extent of the nearest row with one.
void fill_rows(std::vector<BladeMap::Reach>& rows, const std::vector<bool>& is_met) {
  const auto first = std::find(is_met.begin(), is_met.end(), true);
  if (first == is_met.end()) return;
  auto nearest = static_cast<std::size_t>(first - is_met.begin());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (is_met[y]) nearest = y;
    rows[y] = rows[nearest];
  }
}

/// The squared distances of a row's pixels from the outside, computed from the distances along their columns. A pixel
/// is `step` wide. Positions beyond the row are outside.
class RowEnvelope {
 public:
  explicit RowEnvelope(std::size_t size) : sites_(size + 2), heights_(size + 2), starts_(size + 3) {}

  void run(const float* squares, std::size_t size, float step, float* out) {
    count_ = 0;
    add(-1, 0);
    for (std::size_t x = 0; x < size; ++x) add(static_cast<float>(x), squares[x] / (step * step));
    add(static_cast<float>(size), 0);
    std::size_t k = 0;
    for (std::size_t x = 0; x < size; ++x) {
      const auto place = static_cast<float>(x);
      while (k + 1 < count_ && starts_[k + 1] < place) ++k;
      out[x] = step * step * ((place - sites_[k]) * (place - sites_[k]) + heights_[k]);
    }
  }

 private:
  /// Adds a parabola to the right of all others.
  void add(float site, float height) {
    float start = -std::numeric_limits<float>::infinity();
    while (count_ > 0) {
      const float last = sites_[count_ - 1];
      start = ((height + site * site) - (heights_[count_ - 1] + last * last)) / (2 * (site - last));
      if (start > starts_[count_ - 1]) break;
      --count_;
      start = -std::numeric_limits<float>::infinity();
    }
    sites_[count_] = site;
    heights_[count_] = height;
    starts_[count_] = start;
    ++count_;
  }

  std::size_t count_ = 0;
  std::vector<float> sites_;
  std::vector<float> heights_;
  std::vector<float> starts_;
};

/// Returns the distance of each pixel from the nearest pixel that is mostly outside. The border of the picture counts
/// as outside.
std::vector<float> margin_distances(const std::vector<float>& cover, std::size_t size, float aspect) {
  const float step = 1 / static_cast<float>(size);
  std::vector<float> squares(size * size);
  // Along the columns, down and then up.
  for (std::size_t x = 0; x < size; ++x) {
    float distance = 0;
    for (std::size_t y = 0; y < size; ++y) {
      distance = cover[y * size + x] < 0.5F ? 0 : distance + step;
      squares[y * size + x] = distance;
    }
    distance = 0;
    for (std::size_t y = size; y-- > 0;) {
      float& value = squares[y * size + x];
      distance = value == 0 ? 0 : distance + step;
      value = std::min(value, distance) * std::min(value, distance);
    }
  }
  // Along the rows.
  std::vector<float> distances(size * size);
  parallel_for(size, kMapRowsPerBlock, [&](std::size_t begin, std::size_t end) {
    RowEnvelope envelope(size);
    for (std::size_t y = begin; y < end; ++y) {
      float* row = distances.data() + y * size;
      envelope.run(squares.data() + y * size, size, aspect * step, row);
      for (std::size_t x = 0; x < size; ++x) row[x] = std::sqrt(row[x]);
    }
  });
  return distances;
}

}  // namespace

std::vector<float> crossings(const std::vector<Vec2>& outline, int axis, float level) {
  std::vector<float> found;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2 from = outline[k];
    const Vec2 to = outline[k + 1 < outline.size() ? k + 1 : 0];
    if ((from[axis] <= level) == (to[axis] <= level)) continue;
    const float share = (level - from[axis]) / (to[axis] - from[axis]);
    found.push_back(from[1 - axis] + share * (to[1 - axis] - from[1 - axis]));
  }
  std::sort(found.begin(), found.end());
  return found;
}

BladeMap::BladeMap(const TextureShape& shape, int pixels)
    : cover(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels)),
      rows(static_cast<std::size_t>(pixels)) {
  const std::vector<Vec2>& outline = shape.outline.empty() ? kUnitSquare : shape.outline;
  const auto size = static_cast<std::size_t>(pixels);
  std::vector<bool> is_met(size);
  for (std::size_t y = 0; y < size; ++y) {
    is_met[y] = draw_row(outline, static_cast<int>(y), pixels, cover.data() + y * size, rows[y]);
  }
  fill_rows(rows, is_met);
  margin = margin_distances(cover, size, static_cast<float>(shape.aspect));
  widest = *std::max_element(margin.begin(), margin.end());
  const std::vector<float> middle = crossings(outline, 0, 0.5F);
  if (middle.size() > 1) midrib = {middle.front(), middle.back()};
}

}  // namespace meristem

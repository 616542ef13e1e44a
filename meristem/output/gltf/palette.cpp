// SPDX-License-Identifier: Apache-2.0
// Reduces colours to a palette. The colours begin as one group. In each step, the group with the largest squared error
// is split along the channel with the largest spread, at the position with the least remaining error. Each group is
// represented by its mean.
//
// Based on: X. Wu: Efficient statistical computations for optimal color quantization, Graphics Gems II (1991), on
// sorted colours instead of a histogram.
#include "meristem/output/gltf/palette.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace meristem {

namespace {

/// Sums over some colours.
struct Moments {
  double count = 0;
  DVec3 sum{0};
  DVec3 squares{0};

  void add(Vec3 colour) {
    const DVec3 c(colour);
    count += 1;
    sum += c;
    squares += c * c;
  }
  DVec3 mean() const { return sum / count; }
  /// Returns the squared errors of the mean per channel. Errors below the rounding of the sums count as 0.
  DVec3 errors() const {
    const DVec3 errors = squares - sum * sum / count;
    return glm::max(errors - 1e-12 * squares, DVec3(0));
  }
  double error() const {
    const DVec3 e = errors();
    return e.x + e.y + e.z;
  }
  Moments operator-(const Moments& part) const { return {count - part.count, sum - part.sum, squares - part.squares}; }
};

struct Group {
  std::size_t begin = 0;  // index in the order of colours
  std::size_t end = 0;
  Moments moments;
};

class Parting {
 public:
  explicit Parting(std::span<const Vec3> colours) : colours_(colours), order_(colours.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    groups_.push_back({0, colours.size(), moments_of(0, colours.size())});
  }

  Palette part(std::size_t max) {
    while (groups_.size() < max) {
      const auto worst = std::max_element(groups_.begin(), groups_.end(), [](const Group& a, const Group& b) {
        return a.moments.error() < b.moments.error();
      });
      if (worst->moments.error() <= 0) break;
      split(static_cast<std::size_t>(worst - groups_.begin()));
    }
    Palette palette;
    palette.of.resize(colours_.size());
    for (const Group& group : groups_) {
      for (std::size_t k = group.begin; k < group.end; ++k) {
        palette.of[order_[k]] = static_cast<std::uint8_t>(palette.colours.size());
      }
      // The mean of equal colours may differ from them in the last digit.
      const bool is_one = group.moments.error() <= 0;
      palette.colours.push_back(is_one ? colours_[order_[group.begin]] : Vec3(group.moments.mean()));
    }
    return palette;
  }

 private:
  Moments moments_of(std::size_t begin, std::size_t end) const {
    Moments moments;
    for (std::size_t k = begin; k < end; ++k) moments.add(colours_[order_[k]]);
    return moments;
  }

  void split(std::size_t index) {
    Group& group = groups_[index];
    const DVec3 errors = group.moments.errors();
    const int channel = errors.x >= errors.y && errors.x >= errors.z ? 0 : errors.y >= errors.z ? 1 : 2;
    const auto value = [&](std::uint32_t k) { return colours_[k][channel]; };
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(group.begin),
              order_.begin() + static_cast<std::ptrdiff_t>(group.end),
              [&](std::uint32_t a, std::uint32_t b) { return value(a) != value(b) ? value(a) < value(b) : a < b; });

    // Find the cut between two values that leaves the least error.
    Moments low;
    Moments best;
    std::size_t cut = 0;
    for (std::size_t k = group.begin; k + 1 < group.end; ++k) {
      low.add(colours_[order_[k]]);
      if (value(order_[k]) == value(order_[k + 1])) continue;
      if (cut == 0 || low.error() + (group.moments - low).error() < best.error() + (group.moments - best).error()) {
        best = low;
        cut = k + 1;
      }
    }
    if (cut == 0) {  // the values differ only by rounding
      group.moments.squares = group.moments.sum * group.moments.sum / group.moments.count;
      return;
    }
    const Group high{cut, group.end, moments_of(cut, group.end)};
    group.end = cut;
    group.moments = best;
    groups_.push_back(high);
  }

  std::span<const Vec3> colours_;
  std::vector<std::uint32_t> order_;
  std::vector<Group> groups_;
};

}  // namespace

Palette make_palette(std::span<const Vec3> colours, std::size_t max) {
  if (max < 1 || max > 256) throw std::invalid_argument("a palette must have 1 to 256 colours");
  return colours.empty() ? Palette{} : Parting(colours).part(max);
}

}  // namespace meristem

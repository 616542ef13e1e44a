// SPDX-License-Identifier: Apache-2.0
// Computes the veins of a leaf. Positions are in heights of the leaf, from the middle of its base. A side vein that
// leaves its main vein at y0 passes, at distance s from it, through y0 + lean s + arch s^2. Solved for y0, this gives
// at any position the neighbouring side veins and their distances, without following any vein.
#include "meristem/shape/texture/leaf_veins.h"

#include <algorithm>
#include <cmath>

#include "meristem/base/math.h"
#include "meristem/shape/texture/texture_canvas.h"

namespace meristem {

namespace {

constexpr float kMidribWidth = 0.011F;  // half width at the base
constexpr float kSideWidth = 0.0042F;
constexpr float kCrossWidth = 0.0012F;
constexpr float kCrossSpacing = 0.032F;
constexpr float kSidesOfPalm = 0.11F;    // spacing along the main veins of a palmate leaf
constexpr float kArch = 0.5F;            // curvature of side veins toward the tip
constexpr float kShortestVein = 1e-3F;   // minimum length of a fanned vein, which may lie outside of the outline
constexpr std::uint64_t kMaxSides = 64;  // side veins on one side of a main vein
constexpr double kPalmSpread = 105;      // degrees to each side, for main veins that follow no lobes

float angle_between(Vec2 a, Vec2 b) {
  return static_cast<float>(math::acos(glm::dot(a, b) / std::sqrt(glm::dot(a, a) * glm::dot(b, b))));
}

/// Returns the largest distance of the outline from `base` along `heading`.
float ray_length(const std::vector<Vec2>& outline, Vec2 base, Vec2 heading) {
  // Turn the outline so that the heading is the second axis.
  std::vector<Vec2> turned;
  for (const Vec2 point : outline) {
    const Vec2 from = point - base;
    turned.emplace_back(from.x * heading.y - from.y * heading.x, glm::dot(from, heading));
  }
  const std::vector<float> crossed = crossings(turned, 0, 0);
  return crossed.empty() ? 0 : std::max(0.0F, crossed.back());
}

/// Returns the lobes' tips: points of the outline that are farther from `base` than all others within an angle, the
/// farthest first.
std::vector<Vec2> lobe_tips(const std::vector<Vec2>& outline, Vec2 base, std::size_t max) {
  const float apart = 0.5F * static_cast<float>(kPi) / static_cast<float>(max);
  std::vector<Vec2> points;
  for (const Vec2 point : outline) {
    if (glm::distance(point, base) > 0.05F) points.push_back(point - base);
  }
  std::stable_sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return glm::dot(a, a) > glm::dot(b, b); });
  std::vector<Vec2> tips;
  for (std::size_t k = 0; k < points.size() && tips.size() < max; ++k) {
    // A farther point nearby means that this point is on the flank of a lobe.
    const bool is_tip = std::none_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(k),
                                     [&](Vec2 farther) { return angle_between(farther, points[k]) < apart; });
    if (is_tip) tips.push_back(points[k]);
  }
  return tips;
}

}  // namespace

LeafVeins::LeafVeins(const LeafRecipe& recipe, const TextureShape& shape, const BladeMap& map, int pixels)
    : recipe_(recipe),
      map_(map),
      aspect_(static_cast<float>(shape.aspect)),
      pixel_(1 / static_cast<float>(pixels)),
      lean_(static_cast<float>(math::cos(recipe.angle) / math::sin(recipe.angle))) {
  if (recipe.veins == LeafRecipe::Veins::palmate) {
    find_palm(shape);
  } else {
    mains_.push_back({{0, 1}, map.midrib.high - map.midrib.low, {}});
  }
  const RandomKey key = RandomKey(recipe.seed).child("veins");
  for (std::size_t k = 0; k < mains_.size(); ++k) {
    mains_[k].length = std::max(mains_[k].length, kShortestVein);
    for (std::uint64_t side = 0; side < 2 * kMaxSides; ++side) {
      mains_[k].shifts.push_back(0.3F * static_cast<float>(key.child(k).uniform(side) - 0.5));
    }
  }
}

/// Places main veins toward the lobes of the outline, or fans them out if it has no lobes.
void LeafVeins::find_palm(const TextureShape& shape) {
  std::vector<Vec2> outline;
  for (const Vec2 point : shape.outline) outline.emplace_back((point.x - 0.5F) * aspect_, point.y);
  if (outline.empty()) outline = {{-0.5F * aspect_, 0}, {0.5F * aspect_, 0}, {0.5F * aspect_, 1}, {-0.5F * aspect_, 1}};
  const Vec2 base(0, map_.midrib.low);
  const auto max = 2 * static_cast<std::size_t>(recipe_.pairs) + 1;
  const std::vector<Vec2> tips = lobe_tips(outline, base, max);
  if (tips.size() == max && !shape.outline.empty()) {
    for (const Vec2 tip : tips) mains_.push_back({glm::normalize(tip), glm::length(tip), {}});
    return;
  }
  for (int k = -recipe_.pairs; k <= recipe_.pairs; ++k) {
    const double angle = radians(kPalmSpread) * k / recipe_.pairs;
    const Vec2 heading(math::sin(angle), math::cos(angle));
    mains_.push_back({heading, ray_length(outline, base, heading), {}});
  }
}

float LeafVeins::line(float distance, float half_width) const {
  const float drawn = std::max(half_width, 0.5F * pixel_);
  return (half_width / drawn) * std::clamp((drawn - distance) / pixel_ + 0.5F, 0.0F, 1.0F);
}

/// Adds side veins on both sides of a main vein, and the cross veins between them.
void LeafVeins::add_sides(const MainVein& vein, const SideVeins& form, float along, float across, float wobble,
                          Spot& spot) const {
  const float s = std::abs(across);
  const std::size_t side = across < 0 ? 1 : 0;
  const float start = along - lean_ * s - kArch * s * s + 0.09F * form.spacing * wobble;
  const float slope = lean_ + 2 * kArch * s;
  const float upright = 1 / std::sqrt(1 + slope * slope);

  // Check the nearest side veins before and after, each shifted a little. Toward the tip they stand closer.
  const float closer = start / vein.length;
  const float spacing = form.spacing / (0.75F + 0.8F * std::max(closer, 0.0F));
  const float position = (start * (0.75F + 0.4F * closer) - form.first) / form.spacing + (side == 1 ? 0.25F : 0.0F);
  const float below = std::floor(position);
  float nearest = spacing;
  for (int step = -1; step <= 2; ++step) {
    const float k = below + static_cast<float>(step);
    if (k < 0 || k >= std::min(form.count, static_cast<float>(kMaxSides))) continue;
    const float shifted = k + vein.shifts[2 * static_cast<std::size_t>(k) + side];
    nearest = std::min(nearest, std::abs(position - shifted) * spacing);
  }
  const float out = std::clamp(s / std::max(form.reach, 1e-3F), 0.0F, 1.0F);
  const float along_share = std::clamp(along / vein.length, 0.0F, 1.0F);
  spot.side = std::max(spot.side, line(nearest * upright, kSideWidth * (1 - 0.7F * out) * (1 - 0.5F * along_share)));
  const float share = std::clamp(2 * nearest / spacing, 0.0F, 1.0F);
  spot.swell = share * (2 - share) * rise(0, 0.3F * form.spacing, s);

  // Cross veins run across the gaps between side veins, displaced from gap to gap.
  const float step = s / (upright * kCrossSpacing) + 0.37F * below + 0.5F * wobble;
  const float to_cross = std::abs(step - std::floor(step) - 0.5F) * kCrossSpacing;
  spot.cross = line(to_cross * 0.8F, kCrossWidth);
}

LeafVeins::Spot LeafVeins::pinnate_at(Vec2 position, std::size_t row, float wobble) const {
  const MainVein& midrib = mains_.front();
  const float across = position.x + 0.003F * wobble;
  const float along = position.y - map_.midrib.low;
  const float share = std::clamp(along / midrib.length, 0.0F, 1.0F);
  Spot spot;
  if (along >= 0 && along <= midrib.length) spot.main = line(std::abs(across), kMidribWidth * (1 - 0.8F * share));
  const auto count = static_cast<float>(recipe_.pairs);
  const BladeMap::Reach& reach = map_.rows[row];
  const float half_width = aspect_ * (position.x < 0 ? 0.5F - reach.low : reach.high - 0.5F);
  const SideVeins sides{0.02F * midrib.length, 0.86F * midrib.length / count, count, half_width};
  add_sides(midrib, sides, along, across, wobble, spot);
  return spot;
}

LeafVeins::Spot LeafVeins::palmate_at(Vec2 position, float wobble) const {
  // The position belongs to the main vein whose line is nearest.
  const Vec2 from = position - Vec2(0, map_.midrib.low);
  const MainVein* own = &mains_.front();
  float nearest = 1e9F;
  float second = 1e9F;
  for (const MainVein& vein : mains_) {
    const float along = std::clamp(glm::dot(from, vein.heading), 0.0F, vein.length);
    const Vec2 off = from - along * vein.heading;
    const float square = glm::dot(off, off);
    second = std::min(second, std::max(square, nearest));
    if (square < nearest) {
      nearest = square;
      own = &vein;
    }
  }
  const float border = std::sqrt(second) - std::sqrt(nearest);
  const float along = glm::dot(from, own->heading);
  const float across = from.x * own->heading.y - from.y * own->heading.x;
  const float share = std::clamp(along / std::max(own->length, 1e-3F), 0.0F, 1.0F);
  Spot spot;
  spot.main = line(std::abs(std::sqrt(nearest) + 0.002F * wobble), kMidribWidth * (0.9F - 0.7F * share));
  const float count = std::floor(0.9F * own->length / kSidesOfPalm);
  add_sides(*own, {0.15F * own->length, kSidesOfPalm, count, 0.3F * own->length}, along, across, wobble, spot);
  // Where the areas of two main veins meet, neither swells.
  spot.swell *= rise(0, 0.06F, border);
  return spot;
}

LeafVeins::Spot LeafVeins::parallel_at(float u, float v, std::size_t row) const {
  const BladeMap::Reach& reach = map_.rows[row];
  const float half_width = std::max(u < 0.5F ? 0.5F - reach.low : reach.high - 0.5F, 1e-3F);
  const float across = std::abs(u - 0.5F) / half_width;
  const float share = std::clamp((v - map_.midrib.low) / mains_.front().length, 0.0F, 1.0F);
  const float width = aspect_ * half_width;

  Spot spot;
  spot.main = line(across * width, 0.8F * kMidribWidth * (1 - 0.7F * share));
  const auto count = static_cast<float>(recipe_.pairs);
  const float position = across * (count + 1);
  const float nearest = std::abs(position - std::floor(position + 0.5F));
  // The outermost line is the margin.
  const float to_side = nearest / (count + 1) * width;
  if (position > 0.5F && position < count + 0.5F) spot.side = line(to_side, 0.6F * kSideWidth);
  spot.swell = 8 * nearest * (1 - nearest) * width / (count + 1);
  const float fine = std::abs(4 * position - std::floor(4 * position + 0.5F)) / (4 * count + 4) * width;
  spot.cross = 0.6F * line(fine, kCrossWidth);
  return spot;
}

LeafVeins::Spot LeafVeins::at(float u, float v, std::size_t row, float wobble) const {
  const Vec2 position((u - 0.5F) * aspect_, v);
  switch (recipe_.veins) {
    case LeafRecipe::Veins::pinnate:
      return pinnate_at(position, row, wobble);
    case LeafRecipe::Veins::palmate:
      return palmate_at(position, wobble);
    case LeafRecipe::Veins::parallel:
      break;
  }
  return parallel_at(u, v, row);
}

}  // namespace meristem

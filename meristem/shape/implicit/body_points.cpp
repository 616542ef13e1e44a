// SPDX-License-Identifier: Apache-2.0
// Finds points inside a body, one per cell of a grid. Cubes of cells around the body are halved again and again, with
// fewer of the body's solids at each step. Cubes that lie entirely outside or too deep are skipped.
#include "meristem/shape/implicit/body_points.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "meristem/base/frame.h"
#include "meristem/shape/implicit/field_part.h"

namespace meristem {

namespace {

constexpr int kMaxHalvings = 40;        // halvings
constexpr double kPointError = 1e-3;    // share of a cell
constexpr double kSlopeStep = 0.05;     // share of a cell
constexpr double kGradientReach = 0.2;  // in cells: distance outside the surface up to which values must be exact, for
                                        // gradients
constexpr std::array<Vec3, 4> kCorners{Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, 1, 1)};

glm::ivec3 corner_of(int k) { return {k & 1, k >> 1 & 1, k >> 2}; }

/// Descends from a cube of cells around the body to single cells.
class BodyFiller {
 public:
  BodyFiller(const ImplicitBody& body, const BodyGrid& grid, RandomKey key, Progress& progress)
      : body_(body),
        grid_(grid),
        key_(key),
        progress_(progress),
        gaps_(blend_gaps(body, kPointError * grid.spacing)),
        pruner_(body, gaps_, kGradientReach * grid.spacing),
        sampler_(body),
        levels_(kMaxHalvings) {}

  std::vector<BodyPoint> run() {
    const DVec3 first = glm::floor((body_.low() - body_.reach() - grid_.origin) / grid_.spacing);
    const DVec3 last = glm::ceil((body_.high() + body_.reach() - grid_.origin) / grid_.spacing);
    const DVec3 farthest = glm::max(glm::abs(first), glm::abs(last));
    if (!(std::max({farthest.x, farthest.y, farthest.z}) <= 2 * kMaxBodyCells)) {
      throw std::invalid_argument("a body has too many cells for sites");
    }
    const glm::ivec3 low(first);
    const glm::ivec3 size = glm::ivec3(last) - low;
    int side = 2;
    while (side < std::max({size.x, size.y, size.z})) side *= 2;
    fill(low, side, all_steps(body_), 0);
    return std::move(places_);
  }

 private:
  // The recursion depth is the number of halvings of a cube.
  void fill(glm::ivec3 at, int side, std::span<const FieldStep> steps, int depth) {
    progress_.check();
    const double half = 0.5 * side * grid_.spacing;
    const DVec3 middle = grid_.origin + grid_.spacing * (DVec3(at) + 0.5 * side);
    near_.rebase(body_, steps, middle);
    pruner_.bound(steps, near_, {0.5 * half, half});
    std::uint32_t open = 0;
    for (int k = 0; k < 8; ++k) {
      const ValueRange range = pruner_.range(k);
      if (range.low < 0 && range.high > -grid_.depth) open |= 1U << k;
    }
    if (open == 0) return;
    std::array<std::vector<FieldStep>, 8>& kept = levels_[depth];
    pruner_.keep(open, 0, kept);
    for (int k = 0; k < 8; ++k) {
      if ((open >> k & 1) == 0 || places_.size() > grid_.max) continue;
      const glm::ivec3 corner = at + side / 2 * corner_of(k);
      if (side == 2) {
        place(corner, kept[k], middle);
      } else {
        fill(corner, side / 2, kept[k], depth + 1);
      }
    }
  }

  /// Adds the position of a cell, whose solids are near `origin`, if it lies in the body.
  void place(glm::ivec3 cell, std::span<const FieldStep> steps, DVec3 origin) {
    const RandomKey key = key_of(cell);
    const DVec3 share(key.uniform(0), key.uniform(1), key.uniform(2));
    const DVec3 position = grid_.origin + grid_.spacing * (DVec3(cell) + share);
    // Evaluate the position itself, and four around it for the gradient.
    const Vec3 local(position - origin);
    std::array<float, 5> x, y, z, values;
    x.fill(local.x);
    y.fill(local.y);
    z.fill(local.z);
    const auto step = static_cast<float>(kSlopeStep * grid_.spacing);
    for (std::size_t k = 0; k < kCorners.size(); ++k) {
      x[k + 1] += step * kCorners[k].x;
      y[k + 1] += step * kCorners[k].y;
      z[k + 1] += step * kCorners[k].z;
    }
    sampler_.sample(steps, near_, x.data(), y.data(), z.data(), values.size(), values.data());
    if (!(values[0] < 0) || values[0] < -grid_.depth) return;
    Vec3 gradient{0};
    for (std::size_t k = 0; k < kCorners.size(); ++k) gradient += kCorners[k] * values[k + 1];
    places_.push_back({Vec3(position), normalized_or(gradient, kUp), cell});
  }

  RandomKey key_of(glm::ivec3 cell) const {
    const auto number = [](int k) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(k)); };
    return key_.child(number(cell.x)).child(number(cell.y)).child(number(cell.z));
  }

  const ImplicitBody& body_;
  const BodyGrid& grid_;
  RandomKey key_;
  Progress& progress_;
  std::vector<float> gaps_;
  NearSolids near_;
  FieldPruner pruner_;
  FieldSampler sampler_;
  std::vector<std::array<std::vector<FieldStep>, 8>> levels_;
  std::vector<BodyPoint> places_;
};

}  // namespace

std::vector<BodyPoint> places_in(const ImplicitBody& body, const BodyGrid& grid, RandomKey key, Progress& progress) {
  if (body.is_empty()) return {};
  return BodyFiller(body, grid, key, progress).run();
}

}  // namespace meristem

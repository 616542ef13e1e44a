// SPDX-License-Identifier: Apache-2.0
// Every point of the integer lattice has a random slope. Between the points, the linear functions of the corners are
// blended by a quintic with zero first and second derivative at both ends. Slopes come from a hash of the lattice point
// and not from a table, so the noise does not repeat.
//
// Based on: Perlin: Improving noise (SIGGRAPH 2002). Deviations: the lattice is hashed, and the plane has 16
// directions. In space, the 12 edge directions have equal weight. In the source there are 16 directions, four of them
// twice.
#include "meristem/base/noise.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace meristem {

namespace {

/// A coordinate as lattice cell, position in the cell, and blend weight.
struct LatticeCell {
  explicit LatticeCell(double x)
      : lattice(static_cast<std::int64_t>(std::floor(x))),
        t(x - std::floor(x)),
        weight(t * t * t * (t * (t * 6 - 15) + 10)) {}
  std::int64_t lattice;
  double t;
  double weight;
};

/// Returns true if all coordinates are so small that cells can be numbered and have an inside.
template <typename... Coordinates>
bool has_cell(Coordinates... x) {
  return (... && (std::abs(x) < 0x1p52));
}

/// Returns the value for coordinates that are too large or not finite.
template <typename... Coordinates>
double value_without_cell(Coordinates... x) {
  return (... && std::isfinite(x)) ? 0 : std::numeric_limits<double>::quiet_NaN();
}

/// The finaliser of splitmix64 (Steele, Lea, Flood 2014) over the key and lattice point. The high half of the result is
/// the best.
std::uint64_t lattice_hash(RandomKey key, std::int64_t x, std::int64_t y, std::int64_t z) {
  std::uint64_t h = key.bits() + static_cast<std::uint64_t>(x);
  h = h * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(y);
  h = h * 0xd1342543de82ef95U + static_cast<std::uint64_t>(z);
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
  return h ^ (h >> 31);
}

double blend(double from, double to, double weight) { return from + weight * (to - from); }

/// Returns the corner's linear function at distance `x` from the corner. Slopes are uniform in [-1, 1).
double slope_line(std::uint64_t hash, double x) { return (static_cast<double>(hash >> 11) * 0x1p-52 - 1) * x; }

/// Returns the linear function of one of 16 unit slopes in the plane.
double slope_plane(std::uint64_t hash, double x, double y) {
  constexpr double kA = 0.92387953251128674;  // cos 22.5°
  constexpr double kB = 0.70710678118654752;  // cos 45°
  constexpr double kC = 0.38268343236508977;  // cos 67.5°
  constexpr std::array<std::array<double, 2>, 16> kDirections = {{{1, 0},
                                                                  {kA, kC},
                                                                  {kB, kB},
                                                                  {kC, kA},
                                                                  {0, 1},
                                                                  {-kC, kA},
                                                                  {-kB, kB},
                                                                  {-kA, kC},
                                                                  {-1, 0},
                                                                  {-kA, -kC},
                                                                  {-kB, -kB},
                                                                  {-kC, -kA},
                                                                  {0, -1},
                                                                  {kC, -kA},
                                                                  {kB, -kB},
                                                                  {kA, -kC}}};
  const auto& direction = kDirections[hash >> 60];
  return direction[0] * x + direction[1] * y;
}

/// Returns the linear function of a slope in space, toward one of the 12 edges of a cube.
double slope_space(std::uint64_t hash, double x, double y, double z) {
  const std::uint64_t edge = ((hash >> 32) * 12) >> 32;
  const double first = edge < 8 ? x : y;
  const double second = edge < 4 ? y : z;
  return ((edge & 1) != 0 ? -first : first) + ((edge & 2) != 0 ? -second : second);
}

double plane_noise(RandomKey key, const LatticeCell& x, const LatticeCell& y) {
  const auto corner = [&](int dx, int dy) {
    return slope_plane(lattice_hash(key, x.lattice + dx, y.lattice + dy, 0), x.t - dx, y.t - dy);
  };
  return blend(blend(corner(0, 0), corner(1, 0), x.weight), blend(corner(0, 1), corner(1, 1), x.weight), y.weight);
}

/// Returns the blend in one of the two layers of lattice points, above or below a point in space.
double space_layer(RandomKey key, const LatticeCell& x, const LatticeCell& y, const LatticeCell& z, int dz) {
  const auto corner = [&](int dx, int dy) {
    return slope_space(lattice_hash(key, x.lattice + dx, y.lattice + dy, z.lattice + dz), x.t - dx, y.t - dy, z.t - dz);
  };
  return blend(blend(corner(0, 0), corner(1, 0), x.weight), blend(corner(0, 1), corner(1, 1), x.weight), y.weight);
}

}  // namespace

double gradient_noise(RandomKey key, double x) {
  if (!has_cell(x)) return value_without_cell(x);
  const LatticeCell cell(x);
  const double below = slope_line(lattice_hash(key, cell.lattice, 0, 0), cell.t);
  const double above = slope_line(lattice_hash(key, cell.lattice + 1, 0, 0), cell.t - 1);
  // Doubled, because two opposite slopes meet at half their height in the middle.
  return 2 * blend(below, above, cell.weight);
}

double gradient_noise(RandomKey key, double x, double y) {
  if (!has_cell(x, y)) return value_without_cell(x, y);
  // Four unit slopes toward the middle meet at sqrt(1/2).
  return std::sqrt(2.0) * plane_noise(key, LatticeCell(x), LatticeCell(y));
}

double gradient_noise(RandomKey key, double x, double y, double z) {
  if (!has_cell(x, y, z)) return value_without_cell(x, y, z);
  const LatticeCell cell_x(x);
  const LatticeCell cell_y(y);
  const LatticeCell cell_z(z);
  return blend(space_layer(key, cell_x, cell_y, cell_z, 0), space_layer(key, cell_x, cell_y, cell_z, 1), cell_z.weight);
}

}  // namespace meristem

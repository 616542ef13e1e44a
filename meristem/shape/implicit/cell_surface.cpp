// SPDX-License-Identifier: Apache-2.0
// Selects a cell's surface from a table by its corner values. Mostly the signs decide. On a face whose inside corners
// are opposite, the product of the inside values is compared with the product of the outside values. This is the sign
// of the bilinear function at its saddle, and decides if the inside corners are joined. Inside the cell, each slice
// along z is such a face. Its corners change linearly, and the difference of products is a quadratic of the height. If
// it has two roots while opposite corners keep equal signs, two sheets meet at the first root and separate at the
// second, and form a tunnel. One axis is sufficient, because slices along all axes give the same topology.
//
// Based on: W. Lorensen, H. Cline: Marching cubes (SIGGRAPH 1987); G. Nielson, B. Hamann: The asymptotic decider
// (Visualization 1991); E. Chernyaev: Marching cubes 33 (CERN CN/95-17, 1995), whose interior test uses some slices,
// while all relevant slices are tested here; A. Lopes, K. Brodlie: Improving the robustness and accuracy of the
// marching cubes algorithm for isosurfacing (IEEE TVCG 9, 2003), for the topologies of the trilinear function.
#include "meristem/shape/implicit/cell_surface.h"

#include <algorithm>
#include <limits>

#include "meristem/shape/implicit/cell_geometry.h"
#include "meristem/shape/implicit/cell_table.h"

namespace meristem {
namespace {

using Values = std::array<double, 8>;

/// Replaces infinite values, whose products would have no value.
Values finite(std::span<const float, 8> values) {
  constexpr float kMax = std::numeric_limits<float>::max();
  Values result;
  for (int c = 0; c < 8; ++c) result[c] = std::clamp(values[c], -kMax, kMax);
  return result;
}

/// Returns the ambiguous faces on which inside corners are joined. Products of two floats are exact in doubles, so both
/// cells of a face agree. If the products are equal, the inside is separated.
std::uint8_t joined_faces(std::uint8_t ambiguous, const Values& values) {
  std::uint8_t joined = 0;
  for (int face = 0; face < kCellFaces; ++face) {
    if ((ambiguous >> face & 1) == 0) continue;
    const auto [a, b, c, d] = face_corners(face);
    const double even = values[a] * values[c], odd = values[b] * values[d];
    const bool is_joined = values[a] < 0 ? even > odd : odd > even;
    if (is_joined) joined |= static_cast<std::uint8_t>(1 << face);
  }
  return joined;
}

/// A value that changes linearly from the lower face to the upper.
struct Column {
  double low, high;
  double at(double t) const { return low + t * (high - low); }
};

/// The interval of heights at which the corners of a slice have given signs.
struct Heights {
  double from = 0, to = 1;
  /// If the interval ends within the cell, a corner is 0 there, and the difference of products has a known sign.
  int sign_from = 0, sign_to = 0;

  void cut(Column column, bool inside, int sign_at_zero) {
    const bool low = column.low < 0, high = column.high < 0;
    if (low != inside && high != inside) to = -1;
    if (low == high) return;
    const double zero = column.low / (column.low - column.high);
    if (low == inside && zero < to) to = zero, sign_to = sign_at_zero;
    if (high == inside && zero >= from) from = zero, sign_from = sign_at_zero;
  }
};

/// a c - b d of the four columns is a quadratic of the height. Returns true if its two roots lie where columns a and c
/// are inside, and b and d are not.
bool has_two_roots(const Column& a, const Column& b, const Column& c, const Column& d) {
  Heights heights;
  heights.cut(a, true, -1);
  heights.cut(c, true, -1);
  heights.cut(b, false, 1);
  heights.cut(d, false, 1);
  if (!(heights.from < heights.to)) return false;

  const double da = a.high - a.low, db = b.high - b.low, dc = c.high - c.low, dd = d.high - d.low;
  const double square = da * dc - db * dd;
  const double linear = a.low * dc + c.low * da - b.low * dd - d.low * db;
  const double extreme = -linear / (2 * square);
  if (!(heights.from < extreme && extreme < heights.to)) return false;

  const auto is_positive = [&](double t) { return a.at(t) * c.at(t) > b.at(t) * d.at(t); };
  const bool from = heights.sign_from != 0 ? heights.sign_from > 0 : a.low * c.low > b.low * d.low;
  const bool to = heights.sign_to != 0 ? heights.sign_to > 0 : a.high * c.high > b.high * d.high;
  const bool between = is_positive(extreme);
  return from == to && from != between;
}

Tunnel find_tunnel(const Values& v) {
  const Column a{v[0], v[4]}, b{v[1], v[5]}, c{v[3], v[7]}, d{v[2], v[6]};
  if (has_two_roots(a, b, c, d)) return Tunnel::between_even_columns;
  if (has_two_roots(b, a, d, c)) return Tunnel::between_odd_columns;
  return Tunnel::none;
}

}  // namespace

const CellSurface& cell_surface(std::uint8_t pattern, std::span<const float, 8> values) {
  const CellTable& table = CellTable::instance();
  if (!table.is_ambiguous(pattern)) return table.surface(pattern);
  const Values v = finite(values);
  return table.surface(pattern, joined_faces(table.ambiguous_faces(pattern), v), find_tunnel(v));
}

const CellSurface& cell_surface(std::span<const float, 8> values) { return cell_surface(cell_pattern(values), values); }

std::uint8_t cell_pattern(std::span<const float, 8> values) {
  unsigned pattern = 0;
  for (unsigned c = 0; c < 8; ++c) pattern |= (values[c] < 0 ? 1U : 0U) << c;
  return static_cast<std::uint8_t>(pattern);
}

bool is_ambiguous(std::uint8_t pattern) { return CellTable::instance().is_ambiguous(pattern); }

const CellSurface& simple_surface(std::uint8_t pattern) { return CellTable::instance().surface(pattern); }

std::uint16_t crossed_edges(std::uint8_t pattern) { return CellTable::instance().crossed_edges(pattern); }

}  // namespace meristem

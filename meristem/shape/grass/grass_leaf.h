// SPDX-License-Identifier: Apache-2.0
// The common form of all stages of a grass leaf: its midrib in a plane, and its width along the midrib.
//
//   measured points --fit_leaf--> leaf --aged / live--> leaf --turned / loaded--> leaf --reduced--> leaf
//                                                                  --make_grass_blade--> mesh
//
// Based on: C. Fournier, C. Pradal: A plastic, dynamic and reducible 3D geometric model for simulating gramineous
// leaves (PMA 2012), equations 1 to 8.
#pragma once

#include <cstddef>
#include <vector>

namespace meristem {

/// A leaf seen from its side: x leads away from the stem, y along it, toward the stem's tip. The four lists have one
/// number per point of the midrib, at least two points, from the collar at (0, 0) to the tip.
struct GrassLeaf {
  double length = 1;      ///< length of the midrib, metres
  double width = 0.1;     ///< width at the widest position, metres
  std::vector<double> s;  ///< position along the midrib, ascending from 0 to 1
  std::vector<double> x;  ///< in lengths
  std::vector<double> y;  ///< in lengths
  std::vector<double> r;  ///< width at the point as a share of the widest, 0 to 1

  std::size_t point_count() const { return s.size(); }  ///< number of points of the midrib
};

/// Throws std::invalid_argument with the problem if lists or numbers violate the description above. Does not check that
/// the collar is at (0, 0), and that widths are at most 1.
void check_grass_leaf(const GrassLeaf& leaf);

/// Returns the area of a blade with this midrib and these widths, in square metres. Each piece of the midrib is a
/// trapezium.
double area(const GrassLeaf& leaf);

/// Returns the widths as shares of their mean along the leaf, instead of the largest. Over s from 0 to 1 they integrate
/// to 1. Widths that are all 0 stay 0. Based on: Fournier and Pradal (2012), section 2.2, where widths are normalised
/// by the area.
std::vector<double> widths_by_area(const GrassLeaf& leaf);

/// Returns the angle of each piece of the midrib, radians away from the stem: 0 along it, half pi level, pi straight
/// down. Steps from piece to piece are at most pi, so a midrib that rolls up continues beyond pi.
std::vector<double> piece_angles(const GrassLeaf& leaf);

/// Rebuilds the midrib from the angles of its pieces. Each piece keeps its length.
void set_piece_angles(GrassLeaf& leaf, const std::vector<double>& angles);

/// Sets a midrib of equal pieces with these angles. Positions and widths stay unchanged.
void lay_even_pieces(GrassLeaf& leaf, const std::vector<double>& angles);

/// Returns the leaf with `pieces` pieces of equal length along the midrib. Each piece gets the direction of the midrib
/// over its middle, so length and shape are kept. A leaf that already has as many equal pieces stays unchanged.
/// `pieces` must be at least 1.
GrassLeaf resampled(const GrassLeaf& leaf, std::size_t pieces);

/// Returns the value at `place` along the leaf (0 at the collar, 1 at the tip) from a list with one number per point.
/// It is linear between points. Places below 0 and above 1 have the value of the nearest end.
double along_leaf(const GrassLeaf& leaf, const std::vector<double>& list, double place);

/// Returns the direction at `place` from the angles of the pieces, linear between their middles and constant beyond the
/// outermost middles.
double angle_along(const GrassLeaf& leaf, const std::vector<double>& angles, double place);

}  // namespace meristem

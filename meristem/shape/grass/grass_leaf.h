// SPDX-License-Identifier: Apache-2.0
// What all stages of a grass leaf hand on to one another: its midrib in a plane, and its width along it.
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

/// A leaf as seen from its side: x leads away from the stem, y along it, toward the stem's tip. The four lists have one
/// number per point of the midrib, at least two points, from the collar at (0, 0) to the tip.
struct GrassLeaf {
  double length = 1;      ///< length of the midrib, metres
  double width = 0.1;     ///< across at the widest, metres
  std::vector<double> s;  ///< position along the midrib, rising from 0 to 1
  std::vector<double> x;  ///< in lengths
  std::vector<double> y;  ///< in lengths
  std::vector<double> r;  ///< width there as a share of the widest, 0 to 1

  std::size_t point_count() const { return s.size(); }  ///< number of points of the midrib
};

/// Throws std::invalid_argument, naming the fault, if lists or numbers are not as said above.
void check_grass_leaf(const GrassLeaf& leaf);

/// Square metres of a blade with this midrib and these widths, each piece of the midrib with a trapezium.
double area(const GrassLeaf& leaf);

/// The widths as shares of their mean along the leaf, in place of the largest: over s from 0 to 1 they integrate to 1.
/// Based on: Fournier and Pradal (2012), section 2.2, where widths are normalised by the area.
std::vector<double> widths_by_area(const GrassLeaf& leaf);

/// The angle of each piece of the midrib, radians away from the stem: 0 along it, half pi level, pi straight down.
/// Steps from one piece to the next are at most pi, so a midrib that rolls up goes on beyond pi.
std::vector<double> piece_angles(const GrassLeaf& leaf);

/// Puts the midrib together anew from the angles of its pieces; each keeps its length.
void set_piece_angles(GrassLeaf& leaf, const std::vector<double>& angles);

/// Gives the leaf a midrib of equal pieces with these angles; its positions and widths are not changed.
void lay_even_pieces(GrassLeaf& leaf, const std::vector<double>& angles);

/// The leaf with `pieces` pieces of equal length along the midrib. Each takes the direction that the midrib has over
/// its middle, so length and shape are kept, and a leaf of that many equal pieces stays as it is.
GrassLeaf resampled(const GrassLeaf& leaf, std::size_t pieces);

/// The number at `place` along the leaf in a list of one per point, linear between points.
double along_leaf(const GrassLeaf& leaf, const std::vector<double>& list, double place);

/// The direction at `place`, from the angles of the pieces, linear between their middles and the same beyond the
/// outermost ones.
double angle_along(const GrassLeaf& leaf, const std::vector<double>& angles, double place);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Solids given by functions: negative inside, 0 on the surface, positive outside. Simple solids are signed distances in
// metres. They are joined by set operations and blends, in the order of the calls.
//
//   ImplicitBody tree = ImplicitBody::round_cone({0, 0, 0}, 0.2, {0, 3, 0}, 0.1);
//   tree.blend(ImplicitBody::sphere({0, 3.5, 0}, 1), BlendKind::poly, 0.3);
//   Mesh mesh = extract_isosurface(tree, {.resolution = 60}, SizeLimits{}, "tree", progress);  // isosurface.h
//
// Smooth minima of more than two bodies depend on the order: a.blend(b).blend(c) is not a.blend(c).blend(b).
//
// Based on: F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022), 2.4.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/vec.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/implicit/distance.h"

namespace meristem {

/// Any simple solid, in double precision.
using ImplicitSolid = std::variant<distance::RoundCone<double>, distance::FlatCone<double>, distance::Box<double>,
                                   distance::Ellipsoid<double>>;

/// One step of a body's function, in postfix order: a solid pushes a value, and an operation replaces the last two.
struct BodyClause {
  /// A solid, a set operation, or a kind of blend.
  enum class Kind : std::uint8_t { solid, unite, intersect, subtract, poly, root, pasko };
  Kind kind = Kind::solid;  ///< solid or operation
  std::uint32_t solid = 0;  ///< number of the solid
  std::uint32_t size = 1;   ///< number of clauses of this one and everything that it uses
  double width = 0;         ///< width of blends, metres
};

/// A body as a function. Lengths are in metres, in doubles, so that bodies can stand far from the origin.
class ImplicitBody {
 public:
  /// The empty body, which is outside everywhere.
  ImplicitBody() = default;
  /// Creates a ball. This and all functions below throw std::invalid_argument for sizes that are not above 0 and for
  /// numbers that are not finite.
  static ImplicitBody sphere(DVec3 centre, double radius);
  /// Creates the union of all balls of one radius around the points of a segment.
  static ImplicitBody capsule(DVec3 from, DVec3 to, double radius);
  /// Creates a cone between two balls, which includes all balls between them. One of the radii may be 0.
  static ImplicitBody round_cone(DVec3 from, double from_radius, DVec3 to, double to_radius);
  /// Creates a cone between two discs.
  static ImplicitBody flat_cone(DVec3 from, double from_radius, DVec3 to, double to_radius);
  /// Creates a box. `frame` gives its centre and rotation (its scale counts), and `half` the half lengths along its
  /// axes.
  static ImplicitBody box(const Frame& frame, Vec3 half);
  /// Creates an ellipsoid. `frame` gives its centre and rotation (its scale counts), and `radii` the half axes.
  static ImplicitBody ellipsoid(const Frame& frame, Vec3 radii);

  /// Adds the space of another body.
  ImplicitBody& unite(const ImplicitBody& other);
  /// Keeps only the space that both bodies share.
  ImplicitBody& intersect(const ImplicitBody& other);
  /// Removes the space of another body.
  ImplicitBody& subtract(const ImplicitBody& other);
  /// Unites two bodies with a transition of `width` metres. Width 0 is a plain union.
  ImplicitBody& blend(const ImplicitBody& other, BlendKind kind, double width);

  bool is_empty() const { return clauses_.empty(); }  ///< true if the body has no solid
  /// Returns the value at a position from all clauses, or +infinity for an empty body. The cost is linear in solids.
  double value(DVec3 position) const;
  /// Returns the low corner of a box that contains the solids. For an intersection, the box contains what both may
  /// share.
  DVec3 low() const { return low_; }
  DVec3 high() const { return high_; }  ///< high corner of this box
  /// Returns how far blends may extend the body beyond this box.
  double reach() const { return reach_; }

  std::span<const BodyClause> clauses() const { return clauses_; }   ///< solids and operations, in postfix order
  std::span<const ImplicitSolid> solids() const { return solids_; }  ///< solids by number

 private:
  ImplicitBody(ImplicitSolid solid, DVec3 low, DVec3 high);
  ImplicitBody& append(const ImplicitBody& other, BodyClause::Kind kind, double width);

  std::vector<BodyClause> clauses_;
  std::vector<ImplicitSolid> solids_;
  DVec3 low_{std::numeric_limits<double>::infinity()};
  DVec3 high_{-std::numeric_limits<double>::infinity()};
  double reach_ = 0;
};

/// Returns the value of an operation from the values of its two sides.
template <class T>
T apply(BodyClause::Kind kind, T a, T b, T width) {
  switch (kind) {
    case BodyClause::Kind::intersect:
      return std::max(a, b);
    case BodyClause::Kind::subtract:
      return std::max(a, -b);
    case BodyClause::Kind::poly:
      return distance::blend_poly(a, b, width, T(0.25) / width);
    case BodyClause::Kind::root:
      return distance::blend_root(a, b, width);
    case BodyClause::Kind::pasko:
      return distance::blend_pasko(a, b, width);
    default:
      return std::min(a, b);
  }
}

}  // namespace meristem

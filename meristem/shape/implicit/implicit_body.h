// SPDX-License-Identifier: Apache-2.0
// Solids given by functions: negative inside, 0 on the surface, positive outside. Simple ones are signed distances in
// metres; they are joined by set operations and blends, in the order in which that is written.
//
//   ImplicitBody tree = ImplicitBody::round_cone({0, 0, 0}, 0.2, {0, 3, 0}, 0.1);
//   tree.blend(ImplicitBody::sphere({0, 3.5, 0}, 1), BlendKind::poly, 0.3);
//   Mesh mesh = extract_isosurface(tree, {.resolution = 60}, Limits{}, "tree", progress);  // isosurface.h
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

/// Any simple body, in double precision.
using Solid = std::variant<distance::RoundCone<double>, distance::FlatCone<double>, distance::Box<double>,
                           distance::Ellipsoid<double>>;

/// One step of a body's function, in postfix order: a solid gives a value, an operation takes the last two.
struct BodyClause {
  /// A solid, a set operation, or a kind of blend.
  enum class Kind : std::uint8_t { solid, unite, intersect, subtract, poly, root, pasko };
  Kind kind = Kind::solid;  ///< solid or operation
  std::uint32_t solid = 0;  ///< number of the solid
  std::uint32_t size = 1;   ///< clauses of this one with all that it takes
  double width = 0;         ///< width of blends, metres
};

/// Lengths in metres, in double, so that bodies may stand far from the origin.
class ImplicitBody {
 public:
  /// Nothing: outside everywhere.
  ImplicitBody() = default;
  /// All that follow throw std::invalid_argument for sizes that are not above 0 and for what is not finite.
  static ImplicitBody sphere(DVec3 centre, double radius);
  /// All balls of one radius about the points of a segment.
  static ImplicitBody capsule(DVec3 from, DVec3 to, double radius);
  /// A cone between two balls, all balls between them included; radii may be 0 on one side.
  static ImplicitBody round_cone(DVec3 from, double from_radius, DVec3 to, double to_radius);
  /// A cone between two discs.
  static ImplicitBody flat_cone(DVec3 from, double from_radius, DVec3 to, double to_radius);
  /// Centre and rotation from `frame` (its scale counts), `half` along its axes.
  static ImplicitBody box(const Frame& frame, Vec3 half);
  /// Centre and rotation from `frame` (its scale counts), half axes `radii`.
  static ImplicitBody ellipsoid(const Frame& frame, Vec3 radii);

  /// Adds the space of another body.
  ImplicitBody& unite(const ImplicitBody& other);
  /// Keeps only the space shared with another body.
  ImplicitBody& intersect(const ImplicitBody& other);
  /// Removes the space of another body.
  ImplicitBody& subtract(const ImplicitBody& other);
  /// A union with a transition of `width` metres; 0 is a union.
  ImplicitBody& blend(const ImplicitBody& other, BlendKind kind, double width);

  bool is_empty() const { return clauses_.empty(); }  ///< true if the body has no solid
  /// The value at a position, of everything; +infinity for no body. Cost linear in solids.
  double value(DVec3 position) const;
  /// A box that holds the solids (of an intersection what both may share).
  DVec3 low() const { return low_; }
  DVec3 high() const { return high_; }  ///< high corner of that box
  /// How far blends may swell the body beyond that.
  double reach() const { return reach_; }

  std::span<const BodyClause> clauses() const { return clauses_; }  ///< solids and operations, in postfix order
  std::span<const Solid> solids() const { return solids_; }         ///< solids by number

 private:
  ImplicitBody(Solid solid, DVec3 low, DVec3 high);
  ImplicitBody& append(const ImplicitBody& other, BodyClause::Kind kind, double width);

  std::vector<BodyClause> clauses_;
  std::vector<Solid> solids_;
  DVec3 low_{std::numeric_limits<double>::infinity()};
  DVec3 high_{-std::numeric_limits<double>::infinity()};
  double reach_ = 0;
};

/// The value of an operation, given the values of its two sides.
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

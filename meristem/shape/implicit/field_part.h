// SPDX-License-Identifier: Apache-2.0
// The clauses of a body's function that have an effect in a region. A clause is dropped if its solids are too far away
// to change the surface there. Clauses are dropped from coarse regions to fine ones, so that the cost of each region
// depends on its nearby solids.
//
// The value of a solid changes by at most the distance between two positions. Operations (except pasko, which has its
// own bounds) do not fall where their sides rise. Values at a region's centre therefore bound all values in it. A side
// of a union has no effect if it is surely larger than the whole may be. A side of a blend must be larger by a gap,
// because it could still lower later blends. This effect fades with each step down: for poly by a factor e for every
// width / 2.455 at least, whatever the steps. root and pasko reach everywhere, and are dropped if their contribution is
// small enough for all of them together. Regions well outside need only the sign of the function, so a side has no
// effect if it is surely larger than that limit, however far everything else is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// One remaining clause. `size` counts the clause and the remaining clauses of its parts.
struct FieldStep {
  std::uint32_t clause = 0;
  std::uint32_t size = 1;
};

/// Lower and upper bound of a value.
struct ValueRange {
  float low = 0;
  float high = 0;
};

/// A solid relative to a nearby origin.
using NearSolid = std::variant<distance::RoundCone<float>, distance::FlatCone<float>, distance::Box<float>,
                               distance::Ellipsoid<float>>;

/// The solids of some steps, relative to an origin.
class NearSolids {
 public:
  struct Entry {
    std::uint32_t clause = 0;
    NearSolid solid;
  };

  void rebase(const ImplicitBody& body, std::span<const FieldStep> steps, DVec3 origin);
  /// Returns the solids in the order of the steps.
  std::span<const Entry> entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// Returns all clauses of a body.
std::vector<FieldStep> all_steps(const ImplicitBody& body);

/// Returns, for each clause, how much one of its sides must exceed the whole to have no effect. Values near the surface
/// are then at most `error` metres from the values of the whole body. An infinite gap means that a side always has an
/// effect.
std::vector<float> blend_gaps(const ImplicitBody& body, double error);

/// The eight cubes that share a corner, the origin. Each is `side` metres wide, and its centre is at plus or minus
/// `offset` along each axis. Cube k lies on the upper side in x, y, z for its bits 1, 2, 4.
struct Eighths {
  double offset = 0;
  double side = 0;
};

/// Drops clauses. Each thread uses its own object.
class FieldPruner {
 public:
  static constexpr int kParts = 8;

  /// `gaps` must be the result of blend_gaps. Both arguments must outlive the pruner. Positions more than `near` metres
  /// outside need only the sign.
  FieldPruner(const ImplicitBody& body, std::span<const float> gaps, double near);

  /// Bounds the values of `steps` in eight cubes around the origin of `near`, which has their solids. `steps` must not
  /// change before the last query.
  void bound(std::span<const FieldStep> steps, const NearSolids& near, const Eighths& cubes);
  /// Returns the values of the whole function in one of the cubes.
  ValueRange range(int part) const;
  /// Returns the steps that have an effect in some of the cubes (one bit per cube), at least `inset` metres inside
  /// them.
  void keep(std::uint32_t parts, double inset, std::array<std::vector<FieldStep>, kParts>& kept);

 private:
  using Lanes = std::array<float, kParts>;  // one value per cube
  struct Ranges {
    Lanes low, high;
  };
  struct Cutoffs {
    Lanes high;               // upper bound of the whole where values matter
    Lanes gap;                // a side that exceeds the bound by the gap has no effect
    std::uint32_t parts = 0;  // cubes in which the step itself has an effect, one bit per cube
  };

  static void bound_solid(const NearSolid& solid, const Eighths& cubes, Ranges& ranges);
  void bound_operation(const BodyClause& clause, const Ranges& a, const Ranges& b, Ranges& ranges) const;
  std::uint32_t drop_sides(std::size_t step, float inset);

  const ImplicitBody& body_;
  std::span<const float> gaps_;
  float near_;
  std::span<const FieldStep> steps_;
  std::vector<Ranges> ranges_;
  std::vector<Cutoffs> cutoffs_;    // for each step
  std::vector<std::uint8_t> left_;  // for each step, one bit per cube in which it remains
  bool has_pasko_ = false;          // pasko alone does not rise by the rise of both its sides
};

/// Computes values at many positions at once, in floats relative to a nearby origin. Each thread uses its own object.
class FieldSampler {
 public:
  explicit FieldSampler(const ImplicitBody& body) : body_(body) {}

  /// Computes the function of `steps` at `count` positions relative to the origin of `near`, which must contain their
  /// solids.
  void sample(std::span<const FieldStep> steps, const NearSolids& near, const float* x, const float* y, const float* z,
              std::size_t count, float* values);

 private:
  const ImplicitBody& body_;
  std::vector<float> stack_;
};

}  // namespace meristem

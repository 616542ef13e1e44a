// SPDX-License-Identifier: Apache-2.0
// What of a body's function matters in a region: the clauses that are left when all that lies too far away to change
// the surface there is dropped. Found from coarse regions to fine ones, so that the cost of each is that of what is
// near.
//
// Solids change by at most the way that one goes, and operations (but pasko, whose bounds are its own) do not fall
// where their sides rise; so values at a region's centre bound all values in it. A side of a union counts for nothing
// where it is surely larger than the whole may be. A side of a blend must be larger by a gap: how it might still lower
// what is blended later fades with each step down (poly: by a factor e for every width / 2.455 at least, whatever the
// steps; root and pasko reach everywhere, and are left out where what they add is small enough for all of them
// together). What lies well outside needs no more than its sign, so nothing counts where it is surely larger than that,
// however far off all else is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "meristem/shape/implicit/implicit_body.h"

namespace meristem {

/// One clause that is left; `size` counts what is left of its parts and itself.
struct FieldStep {
  std::uint32_t clause = 0;
  std::uint32_t size = 1;
};

/// Bounds of a value.
struct ValueRange {
  float low = 0;
  float high = 0;
};

/// A solid near an origin, relative to it.
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
  /// In the order of the steps.
  std::span<const Entry> entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// All clauses of a body.
std::vector<FieldStep> all_steps(const ImplicitBody& body);

/// For each clause by how much one of its sides must exceed the whole to count for nothing: values near the surface are
/// then at most `error` metres from those of the whole body. Infinite values mean that none ever does.
std::vector<float> blend_gaps(const ImplicitBody& body, double error);

/// The eight cubes that share a corner, the origin: each is `side` metres wide and about plus or minus `offset` along
/// each axis; cube k lies above in x, y, z for its bits 1, 2, 4.
struct Eighths {
  double offset = 0;
  double side = 0;
};

/// Drops clauses. One thread uses one.
class FieldPruner {
 public:
  static constexpr int kParts = 8;

  /// `gaps` as blend_gaps gives them; both outlive the pruner. What is more than `near` metres outside needs no more
  /// than its sign.
  FieldPruner(const ImplicitBody& body, std::span<const float> gaps, double near);

  /// Bounds the values of `steps` in eight cubes about the origin of `near`, which has their solids. `steps` must stay
  /// as they are until all is asked.
  void bound(std::span<const FieldStep> steps, const NearSolids& near, const Eighths& cubes);
  /// The values of the whole function in one of the cubes.
  ValueRange range(int part) const;
  /// The steps that matter in some of the cubes (one bit per cube), at least `inset` metres within them.
  void keep(std::uint32_t parts, double inset, std::array<std::vector<FieldStep>, kParts>& kept);

 private:
  using Lanes = std::array<float, kParts>;  // a value for each part
  struct Ranges {
    Lanes low, high;
  };
  struct Cutoffs {
    Lanes high;               // where values matter, the whole is at most so large
    Lanes gap;                // and what is larger by that does not count
    std::uint32_t parts = 0;  // cubes in which the step itself counts, one bit per cube
  };

  static void bound_solid(const NearSolid& solid, const Eighths& cubes, Ranges& ranges);
  void bound_operation(const BodyClause& clause, const Ranges& a, const Ranges& b, Ranges& ranges) const;
  std::uint32_t drop_sides(std::size_t step, float inset);

  const ImplicitBody& body_;
  std::span<const float> gaps_;
  float near_;
  std::span<const FieldStep> steps_;
  std::vector<Ranges> ranges_;
  std::vector<Cutoffs> cutoffs_;    // by step
  std::vector<std::uint8_t> left_;  // by step, a bit for each part where it is
  bool has_pasko_ = false;          // alone, it does not rise by what both its sides rise
};

/// Computes values at many positions at once, in float relative to an origin near them. One thread uses one.
class FieldSampler {
 public:
  explicit FieldSampler(const ImplicitBody& body) : body_(body) {}

  /// The values of the function of `steps` at `count` positions relative to the origin of `near`, which has their
  /// solids among others.
  void sample(std::span<const FieldStep> steps, const NearSolids& near, const float* x, const float* y, const float* z,
              std::size_t count, float* values);

 private:
  const ImplicitBody& body_;
  std::vector<float> stack_;
};

}  // namespace meristem

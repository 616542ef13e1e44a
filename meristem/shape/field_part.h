// SPDX-License-Identifier: Apache-2.0
// What of a body's function matters in a region: the clauses that are left when all that lies too far away to change
// the surface there is dropped. Found from coarse regions to fine ones, so that the cost of each is that of what is
// near.
//
// Solids change by at most the way that one goes, and operations (but pasko, whose bounds are its own) do not fall
// where their sides rise; so values at a region's centre bound all values in it. A side of a union counts for nothing
// where it is surely larger than the whole may be. A side of a blend must be larger by a gap: how it might still lower
// what is blended later fades with each step down (poly: by a factor e for every width / 2.4574 at least, whatever the
// steps; root and pasko reach everywhere, and are left out where what they add is small enough for all of them
// together).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "meristem/shape/implicit_body.h"

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

NearSolid rebased(const Solid& solid, DVec3 origin);

/// All clauses of a body.
std::vector<FieldStep> all_steps(const ImplicitBody& body);

/// For each clause by how much one of its sides must exceed the whole to count for nothing: values near the surface are
/// then at most `error` metres from those of the whole body. Infinite values mean that none ever does.
std::vector<float> blend_gaps(const ImplicitBody& body, double error);

/// The eight cubes that share a corner: each is `side` metres wide and about `centre` plus or minus `offset` along each
/// axis; cube k lies above in x, y, z for its bits 1, 2, 4.
struct Eighths {
  DVec3 centre{0};
  double offset = 0;
  double side = 0;
};

/// Drops clauses. One thread uses one.
class FieldPruner {
 public:
  static constexpr int kParts = 8;

  /// `gaps` as blend_gaps gives them; both outlive the pruner.
  FieldPruner(const ImplicitBody& body, std::span<const float> gaps);

  /// Bounds the values of `steps` in eight cubes. `steps` must stay as they are until all is asked.
  void bound(std::span<const FieldStep> steps, const Eighths& cubes);
  /// Those of the whole function in one of them.
  ValueRange range(int part) const;
  /// The steps that matter there, at least `inset` metres within the cube.
  void keep(int part, double inset, std::vector<FieldStep>& kept);

 private:
  struct Ranges {  // of a step's values in each part
    std::array<float, kParts> low, high;
  };
  struct Cutoff {
    float high;  // the whole is at most so large
    float gap;   // and what is larger by that does not count
    float value() const { return high + gap; }
  };

  void bound_solid(const Solid& solid, const Eighths& cubes, Ranges& ranges) const;
  void bound_operation(const BodyClause& clause, const Ranges& a, const Ranges& b, Ranges& ranges) const;
  void drop_sides(std::size_t step, int part, float inset);

  const ImplicitBody& body_;
  std::span<const float> gaps_;
  std::span<const FieldStep> steps_;
  std::vector<Ranges> ranges_;
  std::vector<Cutoff> cutoff_;  // by step
  std::vector<std::uint8_t> emits_;
  std::vector<std::uint32_t> stack_;
  bool has_pasko_ = false;  // alone, it does not rise by what both its sides rise
};

/// Computes values at many places at once, in float relative to an origin near them. One thread uses one.
class FieldSampler {
 public:
  explicit FieldSampler(const ImplicitBody& body) : body_(body) {}

  /// The function of `steps`, for places relative to `origin`.
  void aim(std::span<const FieldStep> steps, DVec3 origin);
  /// Its values at `count` places.
  void sample(const float* x, const float* y, const float* z, std::size_t count, float* values);

 private:
  struct Step {
    BodyClause::Kind kind;
    float width = 0;
    NearSolid solid;
  };

  const ImplicitBody& body_;
  std::vector<Step> steps_;
  std::size_t depth_ = 0;
  std::vector<float> stack_;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Bounds the values of a body's function in eight cubes at once and drops clauses without effect. Bounds are computed
// from the first step to the last, and the decisions run back from the last step to the first. The header explains the
// rules.
#include "meristem/shape/implicit/field_part.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "meristem/base/math.h"

namespace meristem {

namespace {

using Kind = BodyClause::Kind;

constexpr double kPolyFading = 2.455;          // natural logarithms per width
constexpr double kOuterHalfDiagonal = 0.8661;  // of a cube of side 1, slightly more than sqrt(3) / 2
constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool is_union(Kind kind) { return kind != Kind::intersect && kind != Kind::subtract; }

distance::RoundCone<float> moved(const distance::RoundCone<double>& cone, DVec3 origin) {
  // Relative to the position on the axis nearest to the origin, because positions far along the axis would lose digits.
  const double shift = std::clamp(glm::dot(origin - cone.origin, cone.axis), cone.low, cone.high);
  const DVec3 at = cone.origin + shift * cone.axis - origin;
  return {.origin = glm::vec3(at),
          .axis = glm::vec3(cone.axis),
          .low = static_cast<float>(cone.low - shift),
          .high = static_cast<float>(cone.high - shift),
          .radius = static_cast<float>(cone.radius - cone.slope * shift),
          .slope = static_cast<float>(cone.slope),
          .tangent = static_cast<float>(cone.tangent)};
}

distance::FlatCone<float> moved(const distance::FlatCone<double>& cone, DVec3 origin) {
  return {glm::vec3(cone.origin - origin), glm::vec3(cone.axis), static_cast<float>(cone.half),
          static_cast<float>(cone.low_radius), static_cast<float>(cone.high_radius)};
}

distance::Box<float> moved(const distance::Box<double>& box, DVec3 origin) {
  return {glm::vec3(box.origin - origin), glm::mat3(box.axes), glm::vec3(box.half)};
}

distance::Ellipsoid<float> moved(const distance::Ellipsoid<double>& ellipsoid, DVec3 origin) {
  return {glm::vec3(ellipsoid.origin - origin), glm::mat3(ellipsoid.axes), glm::vec3(ellipsoid.radii)};
}

/// Replaces `a` by the result of the operation on `a` and `b`, for all positions at once.
void combine(Kind kind, float width, std::size_t count, float* a, const float* b) {
  const auto each = [&](auto operation) {
    for (std::size_t k = 0; k < count; ++k) a[k] = operation(a[k], b[k]);
  };
  const float over = width > 0 ? 0.25F / width : 0;
  switch (kind) {
    case Kind::intersect:
      return each([](float x, float y) { return std::max(x, y); });
    case Kind::subtract:
      return each([](float x, float y) { return std::max(x, -y); });
    case Kind::poly:
      return each([width, over](float x, float y) { return distance::blend_poly(x, y, width, over); });
    case Kind::root:
      return each([width](float x, float y) { return distance::blend_root(x, y, width); });
    case Kind::pasko:
      return each([width](float x, float y) { return distance::blend_pasko(x, y, width); });
    default:
      return each([](float x, float y) { return std::min(x, y); });
  }
}

}  // namespace

void NearSolids::rebase(const ImplicitBody& body, std::span<const FieldStep> steps, DVec3 origin) {
  entries_.clear();
  for (const FieldStep& step : steps) {
    const BodyClause& clause = body.clauses()[step.clause];
    if (clause.kind != Kind::solid) continue;
    std::visit(
        [&](const auto& solid) {
          entries_.push_back({step.clause, moved(solid, origin)});
        },
        body.solids()[clause.solid]);
  }
}

std::vector<FieldStep> all_steps(const ImplicitBody& body) {
  std::vector<FieldStep> steps;
  steps.reserve(body.clauses().size());
  for (const BodyClause& clause : body.clauses()) {
    steps.push_back({static_cast<std::uint32_t>(steps.size()), clause.size});
  }
  return steps;
}

FieldPruner::FieldPruner(const ImplicitBody& body, std::span<const float> gaps, double near)
    : body_(body), gaps_(gaps), near_(static_cast<float>(near)) {
  const auto is_pasko = [](const BodyClause& clause) { return clause.kind == Kind::pasko; };
  has_pasko_ = std::any_of(body.clauses().begin(), body.clauses().end(), is_pasko);
}

std::vector<float> blend_gaps(const ImplicitBody& body, double error) {
  double far_blends = 0;  // number of blends that reach everywhere
  for (const BodyClause& clause : body.clauses()) {
    if (clause.kind == Kind::root || clause.kind == Kind::pasko) ++far_blends;
  }
  const auto gap = [&](const BodyClause& clause) {
    const double width = clause.width;
    switch (clause.kind) {
      case Kind::poly:
        return width * (1 + log(std::max(1.0, 0.25 * width / error)) / kPolyFading);
      case Kind::root:
        return 0.25 * width * width * far_blends / error;
      case Kind::pasko:
        return std::sqrt(0.25 * width * width * width * far_blends / error);
      default:
        return 0.0;
    }
  };
  std::vector<float> gaps;
  gaps.reserve(body.clauses().size());
  for (const BodyClause& clause : body.clauses()) gaps.push_back(static_cast<float>(gap(clause)));
  return gaps;
}

void FieldPruner::bound(std::span<const FieldStep> steps, const NearSolids& near, const Eighths& cubes) {
  steps_ = steps;
  ranges_.resize(steps.size());
  auto entry = near.entries().begin();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const BodyClause& clause = body_.clauses()[steps[k].clause];
    if (clause.kind == Kind::solid) {
      bound_solid((entry++)->solid, cubes, ranges_[k]);
    } else {
      bound_operation(clause, ranges_[k - 1 - steps[k - 1].size], ranges_[k - 1], ranges_[k]);
    }
  }
}

void FieldPruner::bound_solid(const NearSolid& solid, const Eighths& cubes, Ranges& ranges) {
  const auto radius = static_cast<float>(kOuterHalfDiagonal * cubes.side);
  const auto offset = static_cast<float>(cubes.offset);
  constexpr Lanes x{-1, 1, -1, 1, -1, 1, -1, 1};
  constexpr Lanes y{-1, -1, 1, 1, -1, -1, 1, 1};
  constexpr Lanes z{-1, -1, -1, -1, 1, 1, 1, 1};
  Lanes value;
  std::visit(
      [&](const auto& near) {
        for (int k = 0; k < kParts; ++k) value[k] = near.distance(offset * x[k], offset * y[k], offset * z[k]);
      },
      solid);
  for (int k = 0; k < kParts; ++k) {
    ranges.low[k] = value[k] - radius;
    ranges.high[k] = value[k] + radius;
  }
}

void FieldPruner::bound_operation(const BodyClause& clause, const Ranges& a, const Ranges& b, Ranges& ranges) const {
  if (clause.kind == Kind::subtract) {
    for (int k = 0; k < kParts; ++k) {
      ranges.low[k] = std::max(a.low[k], -b.high[k]);
      ranges.high[k] = std::max(a.high[k], -b.low[k]);
    }
    return;
  }
  if (clause.kind == Kind::pasko) {
    // The function falls where a side rises from below to 0: the smallest displacement belongs to the largest sizes.
    const auto width = static_cast<float>(clause.width);
    const auto min = [](float low, float high) { return low > 0 ? low : high < 0 ? high : 0.0F; };
    for (int k = 0; k < kParts; ++k) {
      const auto displacement = [&](float x, float y) {
        return 0.25F * width * width * width / (width * width + x * x + y * y);
      };
      const float max_a = std::max(std::abs(a.low[k]), std::abs(a.high[k]));
      const float max_b = std::max(std::abs(b.low[k]), std::abs(b.high[k]));
      ranges.low[k] = std::min(a.low[k], b.low[k]) - displacement(min(a.low[k], a.high[k]), min(b.low[k], b.high[k]));
      ranges.high[k] = std::min(a.high[k], b.high[k]) - displacement(max_a, max_b);
    }
    return;
  }
  ranges = a;
  combine(clause.kind, static_cast<float>(clause.width), kParts, ranges.low.data(), b.low.data());
  combine(clause.kind, static_cast<float>(clause.width), kParts, ranges.high.data(), b.high.data());
}

ValueRange FieldPruner::range(int part) const {
  if (steps_.empty()) return {kInfinity, kInfinity};
  return {ranges_[steps_.size() - 1].low[part], ranges_[steps_.size() - 1].high[part]};
}

void FieldPruner::keep(std::uint32_t parts, double inset, std::array<std::vector<FieldStep>, kParts>& kept) {
  for (std::vector<FieldStep>& steps : kept) steps.clear();
  if (steps_.empty()) return;
  if (has_pasko_) inset = 0;
  // From the last step to the first, each operation decides where its sides have an effect.
  left_.assign(steps_.size(), 0);
  cutoffs_.resize(steps_.size());
  cutoffs_.back().high.fill(near_);
  cutoffs_.back().gap.fill(0);
  cutoffs_.back().parts = parts;
  for (std::size_t step = steps_.size(); step-- > 0;) {
    if (cutoffs_[step].parts == 0) {
      step -= steps_[step].size - 1;
    } else {
      const bool is_solid = body_.clauses()[steps_[step].clause].kind == Kind::solid;
      left_[step] =
          static_cast<std::uint8_t>(is_solid ? cutoffs_[step].parts : drop_sides(step, static_cast<float>(inset)));
    }
  }
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const bool is_solid = body_.clauses()[steps_[k].clause].kind == Kind::solid;
    for (std::uint32_t left = left_[k]; left != 0; left &= left - 1) {
      std::vector<FieldStep>& steps = kept[std::countr_zero(left)];
      FieldStep step{.clause = steps_[k].clause};
      if (!is_solid) {
        const std::uint32_t right = steps.back().size;
        step.size += right + steps[steps.size() - 1 - right].size;
      }
      steps.push_back(step);
    }
  }
}

/// Decides in which cubes the sides of a step have an effect. Returns the cubes where both do, in which the step itself
/// remains.
std::uint32_t FieldPruner::drop_sides(std::size_t step, float inset) {
  const BodyClause& clause = body_.clauses()[steps_[step].clause];
  const Cutoffs& cutoffs = cutoffs_[step];
  Cutoffs& right = cutoffs_[step - 1];
  Cutoffs& left = cutoffs_[step - 1 - steps_[step - 1].size];
  const Ranges& a = ranges_[step - 1 - steps_[step - 1].size];
  const Ranges& b = ranges_[step - 1];
  const Lanes& max = ranges_[step].high;
  using Bits = std::array<std::int32_t, kParts>;
  constexpr Bits kBit{1, 2, 4, 8, 16, 32, 64, 128};
  Bits has_left, has_right;
  if (is_union(clause.kind)) {
    const float own = gaps_[steps_[step].clause];
    Lanes highs, gaps;
    // Written without branches, so that compilers process several cubes at once.
    for (int k = 0; k < kParts; ++k) {
      const float a_low = a.low[k], b_low = b.low[k];
      const float high_before = cutoffs.high[k], gap_before = cutoffs.gap[k];
      const float high = max[k] - inset;
      const float gap = gap_before > own ? gap_before : own;
      const bool is_lower = high + own < high_before + gap;
      highs[k] = is_lower ? high : high_before;
      gaps[k] = is_lower ? own : gap;
      const float cutoff = highs[k] + gaps[k] - inset;
      has_left[k] = -static_cast<std::int32_t>((a_low < cutoff) | (a_low <= b_low)) & kBit[k];
      has_right[k] = -static_cast<std::int32_t>((b_low < cutoff) | (b_low < a_low)) & kBit[k];
    }
    left.high = right.high = highs;
    left.gap = right.gap = gaps;
  } else {
    for (int k = 0; k < kParts; ++k) {
      const float inner = a.low[k] + inset;
      const bool is_met = clause.kind == Kind::intersect ? inner < b.high[k] - inset : inner < -b.low[k] - inset;
      const bool is_lower = clause.kind == Kind::intersect && !(b.low[k] + inset < a.high[k] - inset);
      has_right[k] = is_met ? kBit[k] : 0;
      has_left[k] = is_met && is_lower ? 0 : kBit[k];
    }
    left.high.fill(kInfinity);
    left.gap.fill(0);
    right.high = left.high;
    right.gap = left.gap;
  }
  left.parts = cutoffs.parts & static_cast<std::uint32_t>(std::accumulate(has_left.begin(), has_left.end(), 0));
  right.parts = cutoffs.parts & static_cast<std::uint32_t>(std::accumulate(has_right.begin(), has_right.end(), 0));
  return left.parts & right.parts;
}

void FieldSampler::sample(std::span<const FieldStep> steps, const NearSolids& near, const float* x, const float* y,
                          const float* z, std::size_t count, float* values) {
  if (steps.empty()) std::fill(values, values + count, kInfinity);
  auto entry = near.entries().begin();
  std::size_t depth = 0;
  for (const FieldStep& step : steps) {
    const BodyClause& clause = body_.clauses()[step.clause];
    // The lowest level of the stack is the output.
    const auto level = [&](std::size_t k) { return k == 0 ? values : stack_.data() + (k - 1) * count; };
    if (clause.kind != Kind::solid) {
      --depth;
      combine(clause.kind, static_cast<float>(clause.width), count, level(depth - 1), level(depth));
      continue;
    }
    if (stack_.size() < depth * count) stack_.resize(depth * count);
    float* const out = level(depth++);
    while (entry->clause != step.clause) ++entry;
    std::visit(
        [&](const auto& solid) {
          for (std::size_t k = 0; k < count; ++k) out[k] = solid.distance(x[k], y[k], z[k]);
        },
        entry->solid);
  }
}

}  // namespace meristem

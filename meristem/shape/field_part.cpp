// SPDX-License-Identifier: Apache-2.0
#include "meristem/shape/field_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meristem/base/math.h"

namespace meristem {

namespace {

using Kind = BodyClause::Kind;

constexpr double kPolyFading = 2.457;     // natural logarithms a width
constexpr double kHalfDiagonal = 0.8661;  // of a cube, a little more than sqrt(3) / 2
constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool is_union(Kind kind) { return kind != Kind::intersect && kind != Kind::subtract; }

distance::RoundCone<float> moved(const distance::RoundCone<double>& cone, DVec3 origin) {
  // From the place on the axis that is nearest to the origin, as what lies far along the axis would lose digits.
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

/// `a` becomes the operation's value for `a` and `b`, all places at once.
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

NearSolid rebased(const Solid& solid, DVec3 origin) {
  return std::visit([&](const auto& of_kind) { return NearSolid(moved(of_kind, origin)); }, solid);
}

std::vector<FieldStep> all_steps(const ImplicitBody& body) {
  std::vector<FieldStep> steps;
  steps.reserve(body.clauses().size());
  for (const BodyClause& clause : body.clauses()) {
    steps.push_back({static_cast<std::uint32_t>(steps.size()), clause.size});
  }
  return steps;
}

FieldPruner::FieldPruner(const ImplicitBody& body, std::span<const float> gaps) : body_(body), gaps_(gaps) {
  const auto is_pasko = [](const BodyClause& clause) { return clause.kind == Kind::pasko; };
  has_pasko_ = std::any_of(body.clauses().begin(), body.clauses().end(), is_pasko);
}

std::vector<float> blend_gaps(const ImplicitBody& body, double error) {
  double far_blends = 0;  // that reach everywhere
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

void FieldPruner::bound(std::span<const FieldStep> steps, const Eighths& cubes) {
  steps_ = steps;
  ranges_.resize(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const BodyClause& clause = body_.clauses()[steps[k].clause];
    if (clause.kind == Kind::solid) {
      bound_solid(body_.solids()[clause.solid], cubes, ranges_[k]);
    } else {
      bound_operation(clause, ranges_[k - 1 - steps[k - 1].size], ranges_[k - 1], ranges_[k]);
    }
  }
}

void FieldPruner::bound_solid(const Solid& solid, const Eighths& cubes, Ranges& ranges) const {
  const auto radius = static_cast<float>(kHalfDiagonal * cubes.side);
  const auto offset = static_cast<float>(cubes.offset);
  std::array<float, kParts> value;
  std::visit(
      [&](const auto& near) {
        for (int k = 0; k < kParts; ++k) {
          value[k] = near.distance((k & 1) != 0 ? offset : -offset, (k & 2) != 0 ? offset : -offset,
                                   (k & 4) != 0 ? offset : -offset);
        }
      },
      rebased(solid, cubes.centre));
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
    // It falls where a side rises from below to 0: the least displacement goes with the largest sizes.
    const auto width = static_cast<float>(clause.width);
    const auto least = [](float low, float high) { return low > 0 ? low : high < 0 ? high : 0.0F; };
    for (int k = 0; k < kParts; ++k) {
      const auto displacement = [&](float x, float y) {
        return 0.25F * width * width * width / (width * width + x * x + y * y);
      };
      const float most_a = std::max(std::abs(a.low[k]), std::abs(a.high[k]));
      const float most_b = std::max(std::abs(b.low[k]), std::abs(b.high[k]));
      ranges.low[k] =
          std::min(a.low[k], b.low[k]) - displacement(least(a.low[k], a.high[k]), least(b.low[k], b.high[k]));
      ranges.high[k] = std::min(a.high[k], b.high[k]) - displacement(most_a, most_b);
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

void FieldPruner::keep(int part, double inset, std::vector<FieldStep>& kept) {
  kept.clear();
  if (steps_.empty()) return;
  if (has_pasko_) inset = 0;
  // Decide from the last step to the first which are left.
  emits_.assign(steps_.size(), 0);
  cutoff_.resize(steps_.size());
  stack_.assign(1, static_cast<std::uint32_t>(steps_.size() - 1));
  cutoff_.back() = {kInfinity, 0};
  while (!stack_.empty()) {
    const std::uint32_t step = stack_.back();
    stack_.pop_back();
    if (body_.clauses()[steps_[step].clause].kind == Kind::solid) {
      emits_[step] = 1;
    } else {
      drop_sides(step, part, static_cast<float>(inset));
    }
  }
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    if (emits_[k] == 0) continue;
    FieldStep step{.clause = steps_[k].clause};
    if (body_.clauses()[step.clause].kind != Kind::solid) {
      const std::uint32_t right = kept.back().size;
      step.size += right + kept[kept.size() - 1 - right].size;
    }
    kept.push_back(step);
  }
}

/// Puts the sides of a step that count on the stack; the step itself is left if both do.
void FieldPruner::drop_sides(std::size_t step, int part, float inset) {
  const BodyClause& clause = body_.clauses()[steps_[step].clause];
  const std::size_t right = step - 1;
  const std::size_t left = right - steps_[right].size;
  const ValueRange a{ranges_[left].low[part] + inset, ranges_[left].high[part] - inset};
  const ValueRange b{ranges_[right].low[part] + inset, ranges_[right].high[part] - inset};
  bool has_left = true;
  bool has_right = true;
  Cutoff cutoff{kInfinity, 0};
  if (is_union(clause.kind)) {
    const float own = gaps_[steps_[step].clause];
    const float high = ranges_[step].high[part] - inset;
    cutoff = {cutoff_[step].high, std::max(cutoff_[step].gap, own)};
    if (high + own < cutoff.value()) cutoff = {high, own};
    has_left = a.low < cutoff.value() || a.low <= b.low;
    has_right = b.low < cutoff.value() || b.low < a.low;
  } else if (clause.kind == Kind::intersect) {
    has_right = a.low < b.high;
    has_left = !has_right || b.low < a.high;
  } else {
    has_right = a.low < -b.low;
  }
  if (has_left && has_right) emits_[step] = 1;
  for (const auto& [side, counts] : {std::pair(left, has_left), std::pair(right, has_right)}) {
    if (!counts) continue;
    cutoff_[side] = cutoff;
    stack_.push_back(static_cast<std::uint32_t>(side));
  }
}

void FieldSampler::aim(std::span<const FieldStep> steps, DVec3 origin) {
  steps_.clear();
  depth_ = 0;
  std::size_t depth = 0;
  for (const FieldStep& step : steps) {
    const BodyClause& clause = body_.clauses()[step.clause];
    steps_.push_back({.kind = clause.kind, .width = static_cast<float>(clause.width)});
    Step& made = steps_.back();
    if (clause.kind != Kind::solid) {
      --depth;
      continue;
    }
    made.solid = rebased(body_.solids()[clause.solid], origin);
    depth_ = std::max(depth_, ++depth);
  }
}

void FieldSampler::sample(const float* x, const float* y, const float* z, std::size_t count, float* values) {
  if (steps_.empty()) {
    std::fill(values, values + count, kInfinity);
    return;
  }
  // The stack's lowest level is where the values are wanted.
  stack_.resize(std::max(stack_.size(), (depth_ - 1) * count));
  const auto level = [&](std::size_t depth) { return depth == 0 ? values : stack_.data() + (depth - 1) * count; };
  std::size_t depth = 0;
  for (const Step& step : steps_) {
    if (step.kind != Kind::solid) {
      --depth;
      combine(step.kind, step.width, count, level(depth - 1), level(depth));
      continue;
    }
    float* const out = level(depth++);
    std::visit(
        [&](const auto& solid) {
          for (std::size_t k = 0; k < count; ++k) out[k] = solid.distance(x[k], y[k], z[k]);
        },
        step.solid);
  }
}

}  // namespace meristem

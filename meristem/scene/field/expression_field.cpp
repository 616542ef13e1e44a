// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/field/expression_field.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

constexpr double kLongest = 1e6;     // beyond this length, squares lose precision
constexpr double kNoLength = 1e-12;  // lengths below this are rounding errors of 0

std::string told(Vec3 position) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", position.x, position.y, position.z); }

}  // namespace

const std::vector<std::string>& field_variables() {
  static const std::vector<std::string> names = {"x", "y", "z", "t"};
  return names;
}

Vec3 ExpressionField::at(Vec3 position) const {
  const std::array<double, 4> variables = {position.x, position.y, position.z, options_.time};
  DVec3 vector(0);
  for (int k = 0; k < 3; ++k) {
    const double value = components_[static_cast<std::size_t>(k)].evaluate(variables);
    vector[k] = value;
    if (std::abs(value) <= kLongest) continue;
    throw InputError(Diagnostic{
        .message = fmt::format("the {} of the {} is {:.4g} at {}", "xyz"[k], options_.what, value, told(position)),
        .expected = fmt::format("finite numbers of at most {:.0f} wherever something asks", kLongest),
        .path = fmt::format("{}.{}", options_.path, "xyz"[k])});
  }
  const bool points = squared_length(vector) > kNoLength * kNoLength;
  if (points || !options_.must_point) return Vec3(vector);
  throw InputError(Diagnostic{.message = fmt::format("the {} vanishes at {}", options_.what, told(position)),
                              .expected = "a direction wherever something asks, or \"add\" to what is there",
                              .path = options_.path});
}

bool ExpressionField::is_uniform() const {
  return std::ranges::none_of(components_, [](const Expression& component) {
    return component.uses(0) || component.uses(1) || component.uses(2);
  });
}

}  // namespace meristem

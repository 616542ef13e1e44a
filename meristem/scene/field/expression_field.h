// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/scene/field/vector_field.h"

namespace meristem {

/// The names that a field's expressions may use: x, y, z (metres) and t (seconds).
const std::vector<std::string>& field_variables();

/// A field by three expressions over them.
class ExpressionField : public VectorField {
 public:
  struct Options {
    double time = 0;             ///< t
    bool must_point = true;      ///< a position where it vanishes is a fault
    std::string path{};          ///< of the three in the document, for errors: "components.world.light"
    std::string what = "field";  ///< what it is called there
  };
  /// Compiled over field_variables(); they draw nothing.
  ExpressionField(std::array<Expression, 3> components, Options options)
      : components_(std::move(components)), options_(std::move(options)) {}

  /// Throws InputError at the component that is not finite, or where all three vanish, with the position.
  Vec3 at(Vec3 position) const override;
  bool is_uniform() const override;

 private:
  std::array<Expression, 3> components_;
  Options options_;
};

}  // namespace meristem

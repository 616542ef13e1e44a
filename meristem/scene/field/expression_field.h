// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "meristem/scene/field/vector_field.h"

namespace meristem {

/// Returns the names that a field's expressions may use: x, y, z (metres) and t (seconds).
const std::vector<std::string>& field_variables();

/// A vector field given by three expressions in the variables of field_variables().
class ExpressionField : public VectorField {
 public:
  /// How the expressions are evaluated and named.
  struct Options {
    double time = 0;         ///< value of t, seconds
    bool must_point = true;  ///< true: a position where the field vanishes is an error
    /// Path of the three expressions in the document, for error messages: "components.world.light".
    std::string path{};
    std::string what = "field";  ///< name of the field in messages
  };
  /// The expressions must be compiled with field_variables() and draw no random numbers.
  ExpressionField(std::array<Expression, 3> components, Options options)
      : components_(std::move(components)), options_(std::move(options)) {}

  /// Throws InputError with the position if a component is not finite, or if all three vanish and Options::must_point
  /// is set.
  Vec3 at(Vec3 position) const override;
  bool is_uniform() const override;

 private:
  std::array<Expression, 3> components_;
  Options options_;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/deform/space_map.h"
#include "meristem/base/expression/expression.h"

namespace meristem {

/// A free-form deformation by functions: each of the three coordinates is an expression of the coordinates of the
/// point.
class FunctionMap : public SpaceMap {
 public:
  /// Returns the names of the first variables of the expressions: x y z.
  static const std::vector<std::string>& coordinate_names();

  /// `functions` compute the new x, y and z. A coordinate without a function stays unchanged. `others` are the values
  /// of the variables after x y z. `key` is the key of random functions, equal at all points.
  explicit FunctionMap(std::array<std::optional<Expression>, 3> functions, std::vector<double> others = {},
                       RandomKey key = RandomKey());

  void map(std::span<DVec3> points, std::span<DMat3> jacobians) const override;
  void add_to(Fingerprint& fingerprint) const override;

 private:
  std::array<std::optional<Expression>, 3> functions_;
  std::vector<double> others_;
  RandomKey key_;
};

}  // namespace meristem

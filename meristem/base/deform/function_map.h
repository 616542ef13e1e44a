// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/deform/space_map.h"
#include "meristem/base/expression/expression.h"

namespace meristem {

/// A map whose three coordinates are expressions of the point's: a free-form deformation by functions.
class FunctionMap : public SpaceMap {
 public:
  /// The first names that its expressions have for variables: x y z.
  static const std::vector<std::string>& coordinate_names();

  /// `functions` give the new x, y and z; what is missing stays as it is. Their variables after x y z have `others` for
  /// values; `key` is what random functions draw from, the same at all points.
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

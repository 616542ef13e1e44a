// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/fingerprint.h"
#include "meristem/base/vec.h"

namespace meristem {

/// A map of points in space, with its derivatives.
class SpaceMap {
 public:
  virtual ~SpaceMap() = default;
  /// Moves the points (metres) in place, and writes the map's Jacobian at each original point into `jacobians`: column
  /// k is the derivative by the k-th coordinate. Both spans must have equal lengths. The result for a point depends
  /// only on the point. Where the map has no value, numbers are not finite.
  virtual void map(std::span<DVec3> points, std::span<DMat3> jacobians) const = 0;
  /// Adds everything on which the map depends to the fingerprint.
  virtual void add_to(Fingerprint& fingerprint) const = 0;
};

}  // namespace meristem

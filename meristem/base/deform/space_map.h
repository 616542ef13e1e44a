// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "meristem/base/fingerprint.h"
#include "meristem/base/vec.h"

namespace meristem {

/// Takes points of space to others, and knows its derivatives there.
class SpaceMap {
 public:
  virtual ~SpaceMap() = default;
  /// Moves the points (metres) in place, and writes the map's Jacobian at each of them, as it was, into `jacobians`:
  /// column k is the derivative by the k-th coordinate. As many jacobians as points. What a point becomes depends on
  /// nothing but the point. Numbers that are not finite come out where the map has no value.
  virtual void map(std::span<DVec3> points, std::span<DMat3> jacobians) const = 0;
  /// Adds all that the map depends on.
  virtual void add_to(Fingerprint& fingerprint) const = 0;
};

}  // namespace meristem

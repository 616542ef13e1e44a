// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "meristem/base/vec.h"

namespace meristem {

/// The direction and strength of a pull at each position of the world. A length of 1 is as strong as a scene's own
/// light or gravity; 0 is no pull.
class VectorField {
 public:
  virtual ~VectorField() = default;

  /// Returns the finite vector at a position. Thread-safe, and allocates nothing. Throws InputError if the definition
  /// of the field gives no usable value there.
  virtual Vec3 at(Vec3 position) const = 0;
  /// Returns true if the field is equal at all positions.
  virtual bool is_uniform() const { return false; }
};

using FieldPointer = std::shared_ptr<const VectorField>;  ///< fields are shared and never change

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "meristem/base/vec.h"

namespace meristem {

/// Which way something pulls at a position of the world, and by its length how strongly: 1 is as strong as a scene's
/// own light or gravity, 0 not at all.
class VectorField {
 public:
  virtual ~VectorField() = default;

  /// Finite. May be called from many threads at once, and allocates nothing. Throws InputError where what it was made
  /// of gives nothing that can be used there.
  virtual Vec3 at(Vec3 position) const = 0;
  /// Whether it is the same everywhere.
  virtual bool is_uniform() const { return false; }
};

using FieldPointer = std::shared_ptr<const VectorField>;

}  // namespace meristem

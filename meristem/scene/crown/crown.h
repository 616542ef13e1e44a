// SPDX-License-Identifier: Apache-2.0
// Crown envelopes: the space that a tree's attraction points fill. Points in them are placed by crown_points.h.
#pragma once

#include <memory>

#include "meristem/base/vec.h"

namespace meristem {

/// A part of space, relative to the root of a tree, y up, metres.
class Crown {
 public:
  virtual ~Crown() = default;

  /// Whether the position is in the crown: the same answer on every machine. May be called from many threads at once.
  virtual bool contains(Vec3 point) const = 0;
  /// A box that holds all of it; empty only where the crown is.
  virtual Box bounds() const = 0;
  /// Metres from the crown's surface, negative inside. Exact near the surface of the project's own bodies; of others,
  /// it is measured toward the middle of their bounds.
  virtual double distance(Vec3 point) const;
  /// Where (x and z) its vertical axis stands, from which zones measure what is outer: the middle of the bounds, and
  /// the root for profiles.
  virtual Vec2 axis() const {
    const Vec3 middle = bounds().is_empty() ? Vec3(0) : bounds().centre();
    return {middle.x, middle.z};
  }
};

using CrownPointer = std::shared_ptr<const Crown>;

}  // namespace meristem

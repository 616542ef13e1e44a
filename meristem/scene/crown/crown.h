// SPDX-License-Identifier: Apache-2.0
// Crown envelopes: regions of space that attraction points fill, that growth keeps to, or that stems are trimmed to.
// crown_points.h places points in them.
#pragma once

#include <memory>

#include "meristem/base/vec.h"

namespace meristem {

/// A region of space relative to the root of a tree, y up, metres.
class Crown {
 public:
  virtual ~Crown() = default;

  /// Returns true if the position is in the crown. The result is the same on every machine. Thread-safe.
  virtual bool contains(Vec3 point) const = 0;
  /// Returns a box that contains the whole crown. It is empty only if the crown is empty.
  virtual Box bounds() const = 0;
  /// Returns the distance to the crown's surface in metres, negative inside. It is exact near the surface for the
  /// built-in crowns. For others, it is measured toward the centre of the bounds.
  virtual double distance(Vec3 point) const;
  /// Returns x and z of the vertical axis from which zones measure the outer part. This is the centre of the bounds, or
  /// the root for profiles.
  virtual Vec2 axis() const {
    const Vec3 middle = bounds().is_empty() ? Vec3(0) : bounds().centre();
    return {middle.x, middle.z};
  }
  /// Returns true if the crown is convex. Returns false if this is unknown.
  virtual bool is_convex() const { return false; }

  /// Returns the share of the straight way from `from` to `to` before it first leaves the crown. Returns 1 if it does
  /// not leave, and 0 if `from` is outside. The position at that share is in the crown. It is before the boundary by at
  /// most 1/65,536 of the way or of 1/64 of the crown's size, whichever is less. In a crown that is not convex, gaps
  /// thinner than 1/64 of its size may be missed.
  float reach(Vec3 from, Vec3 to) const;
};

/// Extent of the bounds of infinite crowns from their root, metres.
inline constexpr float kEndlessReach = 1e6F;

/// Returns true if a crown is infinite, such as a half space.
bool is_endless(const Crown& crown);

using CrownPointer = std::shared_ptr<const Crown>;  ///< crowns are shared and never change

}  // namespace meristem

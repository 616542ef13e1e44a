// SPDX-License-Identifier: Apache-2.0
// Crown envelopes: parts of space that a tree's attraction points fill, that growth keeps to, or that stems are trimmed
// to. Points in them are placed by crown_points.h.
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
  /// Whether every straight way between two positions in the crown lies in it; false also where that is not known.
  virtual bool is_convex() const { return false; }

  /// Share of the straight way from `from` to `to` before it first leaves the crown: 1 where it does not, 0 where
  /// `from` is not in the crown. The position at that share is in the crown, and at most a 65,536th of the way (or of a
  /// 64th of the crown's size, where that is less) before the boundary. In crowns that are not convex, gaps thinner
  /// than that 64th may be passed over.
  float reach(Vec3 from, Vec3 to) const;
};

/// How far the bounds of crowns without an end reach from their root, metres.
inline constexpr float kEndlessReach = 1e6F;

/// Whether a crown goes on without an end, as a half space does.
bool is_endless(const Crown& crown);

using CrownPointer = std::shared_ptr<const Crown>;

}  // namespace meristem

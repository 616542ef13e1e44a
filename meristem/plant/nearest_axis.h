// SPDX-License-Identifier: Apache-2.0
// Which axis of a plant lies at a position: what labels of pixels and points are made of.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meristem/plant/plant.h"

namespace meristem {

/// An axis of a plant.
struct StemAxis {
  std::uint32_t stem = 0;  ///< index into Plant::stems
  AxisIndex axis = 0;      ///< axis of the stem's skeleton

  auto operator<=>(const StemAxis&) const = default;
};

/// All segments of a plant's stems as round cones in a tree of boxes. Builds in n log n, asks in about log n.
class NearestAxis {
 public:
  /// Copies what it needs of the plant; plantings are left out (expanded(), plant_variant.h, has them as stems).
  explicit NearestAxis(const Plant& plant);

  /// The axis whose surface is nearest to a position on wood: the distance counts from the outside and from within.
  /// Among equal ones the first in the plant's order. Nothing where the plant has no stems. May be called from many
  /// threads.
  std::optional<StemAxis> find(Vec3 position) const { return find(position, true); }
  /// The axis that an organ stands on whose base lies at a position: the nearest one, and where the base lies within
  /// wood the first of those that hold it. Otherwise as find().
  std::optional<StemAxis> find_bearer(Vec3 base) const { return find(base, false); }

 private:
  struct Segment {
    Vec3 begin{0};
    Vec3 end{0};
    float begin_radius = 0;
    float end_radius = 0;
    StemAxis axis;
    std::uint32_t number = 0;  // in the plant's order
  };
  /// The segments [first, last), or two halves of them.
  struct Branch {
    Box box;  // about the centre lines
    float radius = 0;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t second = 0;  // index of the second half, 0 where it is not halved; the first half follows at once
  };

  std::optional<StemAxis> find(Vec3 position, bool counts_within) const;
  static float distance(const Segment& segment, Vec3 position, bool counts_within);

  std::vector<Segment> segments_;
  std::vector<Branch> branches_;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/scene/obstacle/obstacles.h"

namespace meristem {

/// Returns true if no obstacle is at `to` or on the way from `from` to `to`. Both are relative to `root`. A root may be
/// on an obstacle's surface.
inline bool is_way_open(const Obstacles& obstacles, Vec3 root, Vec3 from, Vec3 to) {
  if (obstacles.empty()) return true;
  const Vec3 begin = from == Vec3(0) ? 0.001F * to : from;
  return !(obstacles.cross(root + begin, root + to) || obstacles.contain(root + to));
}

}  // namespace meristem

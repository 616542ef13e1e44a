// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "meristem/components/parts/skeleton_source.h"
#include "meristem/graph/component.h"
#include "meristem/plant/plant.h"
#include "meristem/plant/skeleton.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// Post-processing of a skeleton from a file, in this order.
struct SkeletonFinish {
  double decimate = 0;   ///< metres; 0 keeps all nodes
  bool relax = false;    ///< softens the angles of forks
  double subdivide = 0;  ///< metres; 0 keeps the nodes as they are
};

/// A plant that was measured or grown elsewhere.
struct SkeletonFromFile : ComponentBase {
  SkeletonSource source;
  double tip_radius = 0.002;
  double pipe_exponent = 2.4;
  SkeletonFinish finish;
  SurfaceOptions surface;
  TrimMode trim = TrimMode::cut;               ///< effect of a body around its stems
  std::shared_ptr<const Skeleton> skeleton{};  ///< the finished skeleton
};

ComponentType skeleton_component();

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/base/curve.h"
#include "meristem/graph/component.h"

namespace meristem {

/// A stem along a curve that bends and wanders. What hangs on it by branch links stands along it, stems among that join
/// it as its branches.
struct Tree : ComponentBase {
  double length = 1;                                              ///< metres
  double radius = 0.02;                                           ///< metres, at the base
  Curve taper{{{0.0F, 1.0F}, {1.0F, 0.15F}}, CurveKind::linear};  ///< share of the radius over u
  int segments = 16;
  double curl = 0;          ///< radians that it bends from base to tip; positive: away from its upper side
  double gnarl = 0;         ///< radians by which its direction wanders
  double gnarl_waves = 3;   ///< how often it does so from base to tip
  double gravitropism = 0;  ///< share of the angle to straight down that its tip has closed; negative: to straight up
  double phototropism = 0;  ///< the same for the direction of the light; negative: away from it
  Surface surface;
};

ComponentType tree_component();

}  // namespace meristem

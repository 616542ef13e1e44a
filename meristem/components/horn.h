// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/stem_path.h"
#include "meristem/graph/component.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// A cross-section or a primitive carried along a curve. What hangs on it by branch links stands on its ribs, unless
/// the links say where.
struct Horn : ComponentBase {
  enum class Section { ring, outline, box, sphere, cylinder, cone, torus };
  StemParameters stem;
  double twist = 0;  ///< radians: turn of the section about the curve from base to tip
  Section section = Section::ring;
  std::vector<Vec2> outline;      ///< x and z, shares of the radius
  Count ribs = 12;                ///< sites evenly along the curve, both ends included; the last may be coming to be
  int around = 24;                ///< corners around primitives
  Surface surface;                ///< of a ring's stem
  TrimMode trim = TrimMode::cut;  ///< what a body around its stems does to them
};

ComponentType horn_component();

}  // namespace meristem

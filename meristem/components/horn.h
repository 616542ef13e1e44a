// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/components/parts/stem_path.h"
#include "meristem/graph/component.h"
#include "meristem/plant/trim.h"

namespace meristem {

/// A cross-section or a primitive along a curve. Children of branch links are placed on its ribs, unless the links
/// define other positions.
struct Horn : ComponentBase {
  enum class Section { ring, outline, line, area, box, sphere, cylinder, cone, torus };
  StemParameters stem;
  double twist = 0;  ///< rotation of the section about the curve from base to tip, radians
  Section section = Section::ring;
  std::vector<Vec2> outline;  ///< x and z, shares of the radius; closed unless the section is a line
  PartCount ribs =
      12;           ///< number of evenly spaced sites on the curve, including both ends; the last one may be appearing
  int around = 24;  ///< corners around primitives; larger: rounder
  SurfaceOptions surface;         ///< surface of the stem of a ring
  TrimMode trim = TrimMode::cut;  ///< effect of a body around its stems
};

ComponentType horn_component();

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Sites in rows on a level plain: a crop, an orchard, an avenue.
struct Field : ComponentBase {
  int rows = 10;
  int plants = 10;            ///< number in each row
  double row_spacing = 0.75;  ///< metres
  double spacing = 0.15;      ///< metres, within a row
  double scatter = 0;         ///< largest offset of a site in each direction, as a share of the spacings
  bool stagger = false;       ///< true: every other row is shifted by half of the spacing
  double gaps = 0;            ///< share of sites that stay empty
  bool turned = true;         ///< true: each plant has a random azimuth
};

ComponentType field_component();

}  // namespace meristem

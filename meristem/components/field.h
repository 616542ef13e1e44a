// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/graph/component.h"

namespace meristem {

/// Sites in rows on a level plain, as plants are sown: a crop, an orchard, an avenue.
struct Field : ComponentBase {
  int rows = 10;
  int plants = 10;            ///< in each row
  double row_spacing = 0.75;  ///< metres
  double spacing = 0.15;      ///< metres, within a row
  double scatter = 0;         ///< largest offset of a site to either side, as a share of the spacings
  bool stagger = false;       ///< every other row is moved by half of the spacing
  double gaps = 0;            ///< share of sites that stay empty
  bool turned = true;         ///< each plant faces anywhere
};

ComponentType field_component();

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/surface_table.h"

#include "meristem/graph/table.h"
#include "meristem/plant/plant.h"

namespace meristem {

const ParameterTable& surface_table() {
  static const ParameterTable table =
      Table<Surface>("a surface", "How stems are clothed.")
          .choice("style", &Surface::style, {"tubes"}, "tubes: continuous tubes along the axes.")
          .integer("sides", &Surface::sides, {.min = 3, .max = 64, .fixed = true},
                   "Sides of the thickest stem, thinner ones have fewer; raised, rounder and heavier.")
          .number("uv_scale", &Surface::uv_scale, {.unit = Unit::metre, .min = 0.001, .max = 100, .fixed = true},
                  "Bark that one tile of a texture covers.");
  return table;
}

}  // namespace meristem

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
          .number("error", &Surface::error, {.min = 0, .max = 1, .fixed = true},
                  "How far a tube may stray from its skeleton, in its radii; raised, fewer rings along straight stems.")
          .choice("cap", &Surface::cap, {"pointed", "round", "flat"}, "How tips end.")
          .number("uv_scale", &Surface::uv_scale, {.unit = Unit::metre, .min = 0.001, .max = 100, .fixed = true},
                  "Bark that one tile of a texture covers.")
          .number("smooth", &Surface::smooth, {.min = 0, .max = 20, .fixed = true},
                  "Over how many radii along a stem the step in thickness at a fork is spread; 0 leaves it.")
          .number("collar", &Surface::collar, {.min = 0, .max = 3, .fixed = true},
                  "How far branches swell where they grow out of their mother, in their radii; 0: they start with a "
                  "crease.")
          .number("flare", &Surface::flare, {.min = 0, .max = 5, .fixed = true},
                  "How much wider a root is at the ground than above it; 1 doubles it.");
  return table;
}

}  // namespace meristem

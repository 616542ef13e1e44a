// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/pipe_table.h"

#include "meristem/graph/table/table.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

const ParameterTable& pipe_table() {
  static const ParameterTable table =
      Table<PipeModel>("radii", "The pipe model.")
          .number("tip_radius", &PipeModel::tip_radius, {.unit = Unit::metre, .min = 0, .max = 10, .above_min = true},
                  "Of the finest twigs; raised, all wood gets thicker.")
          .number(
              "pipe_exponent", &PipeModel::exponent, {.min = 1, .max = 10},
              "A fork's radius to this power is the sum of its branches'; raised, thinner trunks. 2 to 3.5 in nature.")
          .number("memory", &PipeModel::memory, {.min = 0, .max = 1},
                  "How far wood keeps the thickness that shed branches gave it; 0 forgets them.");
  return table;
}

}  // namespace meristem

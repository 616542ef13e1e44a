// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/pipe_table.h"

#include "meristem/graph/table/table.h"
#include "meristem/plant/pipe_radii.h"

namespace meristem {

const ParameterTable& pipe_table() {
  static const ParameterTable table =
      Table<PipeModel>("radii", "The pipe model.")
          .number("tip_radius", &PipeModel::tip_radius, {.unit = Unit::metre, .min = 0, .max = 10, .above_min = true},
                  "Radius of the finest twigs; raised, all wood is thicker in proportion.")
          .number("pipe_exponent", &PipeModel::exponent, {.min = 1, .max = 10, .usual = {1.5, 4}},
                  "Pipe exponent: the radius below a fork to this power is the sum of those above it; raised, thinner "
                  "trunks. 2 to 3.5 in nature.")
          .number("memory", &PipeModel::memory, {.min = 0, .max = 1},
                  "Share of the thickness that wood keeps from branches that are shed; raised, thicker trunks.");
  return table;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/finish_table.h"

#include "meristem/plant/finish.h"

namespace meristem {

const ParameterTable& finish_table() {
  static const ParameterTable table =
      Table<FinishOptions>("a finish", "What is done to the skeleton after growth, in this order.")
          .number(
              "decimate", &FinishOptions::decimate, {.unit = Unit::step, .min = 0, .max = 1000, .usual = {0, 20}},
              "Spacing to which the nodes along branches are thinned; 4 keeps about every fourth node, 0 keeps all.")
          .boolean("relax", &FinishOptions::relax,
                   "Whether each node moves half way to its parent, which softens the angles of forks.")
          .number(
              "subdivide", &FinishOptions::subdivide, {.unit = Unit::step, .min = 0, .max = 1000, .usual = {0, 20}},
              "Spacing of the final nodes along smooth curves through the branches; 0 keeps the nodes as they are.");
  return table;
}

}  // namespace meristem

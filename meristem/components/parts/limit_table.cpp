// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/limit_table.h"

#include "meristem/graph/table/table.h"

namespace meristem {

const ParameterTable& limit_table() {
  static const ParameterTable table =
      Table<LightLimit>("a limit", "Which points are too dark to grow to.")
          .number("share", &LightLimit::share, {.min = 0, .max = 0.99},
                  "Of the points, the darkest first, that are left out; 0 leaves out none.")
          .number("radius", &LightLimit::radius, {.unit = Unit::metre, .min = 0.001, .max = 1000},
                  "Points so near to the way of the light dim it.")
          .number("k", &LightLimit::k, {.min = 0, .max = 100}, "How much each of them dims it: by exp(-k).")
          .only_with("share", {"radius", "k"});
  return table;
}

}  // namespace meristem

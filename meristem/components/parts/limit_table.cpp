// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/limit_table.h"

#include "meristem/graph/table/table.h"

namespace meristem {

const ParameterTable& limit_table() {
  static const ParameterTable table =
      Table<LightLimit>("a limit", "Limit of light below which attraction points are removed.")
          .number("share", &LightLimit::share, {.min = 0, .max = 0.99},
                  "Share of the attraction points, the darkest first, that is removed; raised, a hollower crown.")
          .number(
              "radius", &LightLimit::radius, {.unit = Unit::metre, .min = 0.001, .max = 1000},
              "Distance from a ray of light within which other points dim it; raised, the shade is wider and softer.")
          .number("k", &LightLimit::k, {.min = 0, .max = 100},
                  "Extinction per point: each point near a ray of light dims it by exp(-k); raised, darker shade.")
          .only_with("share", {"radius", "k"});
  return table;
}

}  // namespace meristem

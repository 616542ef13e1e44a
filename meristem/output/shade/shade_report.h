// SPDX-License-Identifier: Apache-2.0
// Shade as tables and as a picture.
#pragma once

#include <string>

#include "meristem/base/image.h"
#include "meristem/graph/table/value.h"
#include "meristem/measure/shade.h"
#include "meristem/output/shade/shade_request.h"

namespace meristem {

/// A table in CSV, a row per moment: `day` (of the year, or a date), `hour`, `solar_hour`, `azimuth`, `altitude`
/// (degrees), `cosine`, `direct`, `shade`, `shade_without_plants` (shade.h); the last four are empty by night.
std::string shade_csv(const ShadePlan& plan, const ShadeOfSurface& shade);

/// The table as an object: `area` (square metres), `points`, `clock_time`, and `moments`, a list of objects with null
/// by night. A grid also has `grid` with `columns`, `rows`, and `shade` and `shade_without_plants` as lists of rows,
/// null where an obstacle stands.
Value shade_value(const ShadePlan& plan, const ShadeOfSurface& shade);

/// A table in CSV, a row per point: `x`, `y`, `z`, `shade`, `shade_without_plants` over all moments with the sun above
/// the horizon.
std::string shade_points_csv(const ShadePlan& plan, const ShadeOfSurface& shade);

/// For the ground, a map of each cell's share of shade, north up. For other surfaces, the share in shade by days from
/// left to right and hours from below. Light is sun, dark is shade, grey is night or an obstacle.
Image shade_picture(const ShadePlan& plan, const ShadeOfSurface& shade, bool as_map);

}  // namespace meristem

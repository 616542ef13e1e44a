// SPDX-License-Identifier: Apache-2.0
// Shade as tables and as a picture.
#pragma once

#include <string>

#include "meristem/base/image.h"
#include "meristem/export/shade/shade_request.h"
#include "meristem/graph/table/value.h"
#include "meristem/measure/shade.h"

namespace meristem {

/// Returns a table in CSV, one row per moment: `day` (of the year, or a date), `hour`, `solar_hour`, `azimuth`,
/// `altitude` (degrees), `cosine`, `direct`, `shade`, `shade_without_plants` (shade.h). The last four are empty at
/// night.
std::string shade_csv(const ShadePlan& plan, const ShadeOfSurface& shade);

/// Returns the table as an object: `area` (square metres), `points`, `clock_time`, and `moments`, a list of objects
/// with null at night. A grid also has `grid` with `columns`, `rows`, and `shade` and `shade_without_plants` as lists
/// of rows, null where an obstacle stands.
Value shade_value(const ShadePlan& plan, const ShadeOfSurface& shade);

/// Returns a table in CSV, one row per point: `x`, `y`, `z`, `shade`, `shade_without_plants` over all moments with the
/// sun above the horizon.
std::string shade_points_csv(const ShadePlan& plan, const ShadeOfSurface& shade);

/// Returns a picture. With `as_map`, which needs ground, it is a map of each cell's share of shade, north up. Otherwise
/// it shows the share in shade, with days from left to right and hours from below. Light is sun, dark is shade, grey is
/// night or an obstacle.
Image shade_picture(const ShadePlan& plan, const ShadeOfSurface& shade, bool as_map);

}  // namespace meristem

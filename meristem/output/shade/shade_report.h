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

/// The same as an object: `area` (square metres), `points`, `clock_time`, `moments`, a list of objects with null by
/// night, and of a grid `grid` with `columns`, `rows`, and `shade` and `shade_without_plants` as lists of rows, null
/// where an obstacle stands.
Value shade_value(const ShadePlan& plan, const ShadeOfSurface& shade);

/// A table in CSV, a row per point: `x`, `y`, `z`, `shade`, `shade_without_plants` over all moments with the sun above
/// the horizon.
std::string shade_points_csv(const ShadePlan& plan, const ShadeOfSurface& shade);

/// Of the ground the map of each cell's share of shade, north up; of other surfaces days from left to right, hours from
/// below, and the share in shade. Light is sun, dark is shade, grey is night or an obstacle.
Image shade_picture(const ShadePlan& plan, const ShadeOfSurface& shade, bool as_map);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/components/parts/place_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// An area that is planted evenly at random.
struct PlantedArea {
  std::vector<Vec2> polygon;       ///< metres, x and z
  double density = 1;              ///< per square metre
  std::optional<double> distance;  ///< least, metres; unset: 0.7 of what each would have in a square grid
};

/// A way along which things stand.
struct PlantedLine {
  std::vector<Vec2> points;  ///< metres, x and z
  double spacing = 5;        ///< metres
  double offset = 0;         ///< metres to the right of the way
  double jitter = 0;         ///< metres to all sides
};

/// What a text of a table's column stands for.
struct PlacedName {
  std::string component;
};

/// Where things stand: by a table, in an area, or along a line.
struct Places : ComponentBase {
  Asset<PlaceTable> table;
  std::optional<PlantedArea> area;
  std::optional<PlantedLine> line;
  std::optional<double> origin_x, origin_y;
  std::string choose;
  std::vector<std::pair<std::string, PlacedName>> names;
  PerChild turn = 0.0;  ///< radians
  PerChild size = 1.0;
};

ComponentType places_component();

}  // namespace meristem

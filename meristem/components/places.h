// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/components/parts/place_table.h"
#include "meristem/graph/component.h"

namespace meristem {

/// An area with evenly distributed random sites.
struct PlantedArea {
  std::vector<Vec2> polygon;       ///< metres, x and z
  double density = 1;              ///< per square metre
  std::optional<double> distance;  ///< minimum distance, metres; unset: 0.7 of the distance in a square grid
};

/// A line with evenly spaced sites.
struct PlantedLine {
  std::vector<Vec2> points;  ///< metres, x and z
  double spacing = 5;        ///< metres
  double offset = 0;         ///< metres to the right of the line
  double jitter = 0;         ///< largest random offset in all directions, metres
};

/// The component that a text of a table's column selects.
struct PlacedName {
  std::string component;
};

/// Sites for children: by a table, in an area, or along a line.
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

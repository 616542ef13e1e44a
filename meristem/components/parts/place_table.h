// SPDX-License-Identifier: Apache-2.0
// Tables of plant positions, with one row per plant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_columns.h"
#include "meristem/base/vec.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// A table with its position columns.
struct PlaceTable {
  /// The coordinate system of a table.
  enum class Ground {
    plan,     ///< x to the east and z to the south, as in the scene; y is the height
    map,      ///< x to the east and y to the north
    degrees,  ///< lon and lat
  };

  std::string file;  ///< name of the file in messages
  TextTable table;
  Ground ground = Ground::plan;
  const TextTable::Column *east = nullptr, *north = nullptr;  ///< pointers into `table`, like the following ones
  const TextTable::Column *height = nullptr, *rotation = nullptr, *scale = nullptr;
  DVec3 middle{0};  ///< centre of the rows' bounding box: x and y in the table's unit

  PlaceTable() = default;
  PlaceTable(const PlaceTable&) = delete;  // columns point into the table
  PlaceTable(PlaceTable&& other) noexcept;

  /// Returns the position of a row in the scene, in metres. `origin` (in the table's unit) is mapped to the scene's
  /// origin.
  Vec3 position(std::size_t row, DVec3 origin) const;
};

/// Reads a table of places. Throws InputError with all errors by line and column.
PlaceTable read_place_table(const std::string& text, const std::string& file_path, ParameterReader& reader,
                            std::vector<Diagnostic>& warnings);

}  // namespace meristem

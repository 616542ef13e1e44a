// SPDX-License-Identifier: Apache-2.0
// Tables that say where plants stand, one row per plant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meristem/base/diagnostic.h"
#include "meristem/base/read_columns.h"
#include "meristem/base/vec.h"
#include "meristem/graph/table/reader.h"

namespace meristem {

/// The rows of a table, with the columns that say where they are.
struct PlaceTable {
  /// How the table says where things stand.
  enum class Ground {
    plan,     ///< x to the east and z to the south, as in the scene; y is the height
    map,      ///< x to the east and y to the north
    degrees,  ///< lon and lat
  };

  std::string file;  ///< its name in messages
  TextTable table;
  Ground ground = Ground::plan;
  const TextTable::Column *east = nullptr, *north = nullptr;  ///< of the table, as are the others
  const TextTable::Column *height = nullptr, *rotation = nullptr, *scale = nullptr;
  DVec3 middle{0};  ///< of the rows' box: x and y in the table's unit

  PlaceTable() = default;
  PlaceTable(const PlaceTable&) = delete;  // columns point into it
  PlaceTable(PlaceTable&& other) noexcept;

  /// Where a row stands in the scene, metres, where `origin` (in the table's unit) lies at its origin.
  Vec3 position(std::size_t row, DVec3 origin) const;
};

/// Reads a table of places. Throws InputError with all faults by line and column.
PlaceTable read_place_table(const std::string& text, const std::string& file_path, ParameterReader& reader,
                            std::vector<Diagnostic>& warnings);

}  // namespace meristem

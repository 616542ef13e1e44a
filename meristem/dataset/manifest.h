// SPDX-License-Identifier: Apache-2.0
// The manifest of a data set: tables in CSV with a row for each plant. The columns are:
//
// key, document, seed, a column for each value that differs, files, bytes, hashes (of each file, with spaces between),
// version (of the program that grew it), error (empty, or why the plant is missing), a column for each measure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/dataset/dataset_plan.h"
#include "meristem/measure/measures.h"

namespace meristem {

/// A file of a plant.
struct PlantFile {
  std::string path;         ///< below the folder of the data set, without spaces
  std::uint64_t bytes = 0;  ///< size of the file
  std::string hash;         ///< 128-bit XXH3 as 32 hexadecimal digits

  bool operator==(const PlantFile&) const = default;
};

/// The result of making a plant.
struct MadePlant {
  PlannedPlant plant;                  ///< the plant, as the plan draws it
  std::vector<PlantFile> files;        ///< files that were written
  std::vector<MeasureValue> measures;  ///< in the order of the plan; empty after an error
  std::string error;                   ///< reason why the plant is missing, in one line
};

/// Returns the names of the columns.
std::vector<std::string> manifest_columns(const DatasetPlan& plan);
/// Returns the first line of a table, with the names of the columns and a line end.
std::string manifest_header(const DatasetPlan& plan);
/// Returns the first fields of a plant's row, which the plan determines: key, document, seed and the values that
/// differ.
std::vector<std::string> planned_fields(const DatasetPlan& plan, const PlannedPlant& plant);
/// Returns the row of a plant, with a line end. The row contains no other line end.
std::string manifest_row(const DatasetPlan& plan, const MadePlant& made);

/// Returns the fields of a line of CSV without its line end. Returns nothing if a quote is not closed.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

/// The fields of a row that show whether its plant exists.
struct ManifestEntry {
  std::uint64_t number = 0;      ///< number of the plant in the plan
  std::vector<PlantFile> files;  ///< files of the plant
  std::string error;             ///< reason why the plant is missing; empty if it exists
};

/// The positions of the columns in a manifest.
struct ManifestLayout {
  std::size_t count = 0;   ///< number of columns
  std::size_t files = 0;   ///< column of the files
  std::size_t bytes = 0;   ///< column of their sizes
  std::size_t hashes = 0;  ///< column of their hashes
  std::size_t error = 0;   ///< column of the error

  /// Reads the first line of a manifest. Returns nothing for any other line.
  static std::optional<ManifestLayout> of_header(std::string_view line);
  /// Reads a row. Returns nothing if the line is not a row.
  std::optional<ManifestEntry> entry(std::string_view line) const;
  std::optional<ManifestEntry> entry(const std::vector<std::string>& fields) const;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The manifest of a data set: tables in CSV with a row for each plant.
//
// key, document, seed, a column for each value that differs, files, bytes, hashes (of each file, with spaces between),
// version (of the program that grew it), error (empty, or why there is no plant), a column for each measure.
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

/// What became of a plant.
struct MadePlant {
  PlannedPlant plant;                  ///< the plant, as the plan draws it
  std::vector<PlantFile> files;        ///< files that were written
  std::vector<MeasureValue> measures;  ///< in the order of the plan; none after an error
  std::string error;                   ///< why there is no plant, in one line
};

/// The names of the columns.
std::vector<std::string> manifest_columns(const DatasetPlan& plan);
/// The names of the columns as the first line of a table, with its line end.
std::string manifest_header(const DatasetPlan& plan);
/// The first fields of the row of a plant, as the plan draws them: key, document, seed and the values that differ.
std::vector<std::string> planned_fields(const DatasetPlan& plan, const PlannedPlant& plant);
/// The row of a plant, with its line end; it holds no other one.
std::string manifest_row(const DatasetPlan& plan, const MadePlant& made);

/// The fields of a line of CSV without its line end; nothing where quotes do not close.
std::optional<std::vector<std::string>> csv_fields(std::string_view line);

/// What of a row tells whether its plant is there.
struct ManifestEntry {
  std::uint64_t number = 0;      ///< number of the plant in the plan
  std::vector<PlantFile> files;  ///< files of the plant
  std::string error;             ///< why there is no plant; empty if there is one
};

/// Where the columns of a manifest stand.
struct ManifestLayout {
  std::size_t count = 0;   ///< number of columns
  std::size_t files = 0;   ///< column of the files
  std::size_t bytes = 0;   ///< column of their sizes
  std::size_t hashes = 0;  ///< column of their hashes
  std::size_t error = 0;   ///< column of the error

  /// Nothing where the line is not the first one of a manifest.
  static std::optional<ManifestLayout> of_header(std::string_view line);
  /// Nothing where the line is no row.
  std::optional<ManifestEntry> entry(std::string_view line) const;
  std::optional<ManifestEntry> entry(const std::vector<std::string>& fields) const;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Checks whether the folder of a data set contains what its manifest lists, and whether the manifest is unchanged.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/progress.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/manifest.h"
#include "meristem/dataset/table_check.h"

namespace meristem {

class Registry;

/// Returns the reason why the files of a row are missing or wrong, or nothing if they are right. Compares sizes and, if
/// `reads_all`, hashes of all bytes. Throws Cancelled.
std::optional<std::string> error_of_files(const ManifestEntry& entry, const std::string& folder, bool reads_all,
                                          const Progress& progress);

/// Returns the faults of all rows, in their order. The progress counts a unit per row. Throws Cancelled.
std::vector<std::optional<std::string>> errors_of_rows(const std::vector<TableRow>& rows, const std::string& folder,
                                                       bool reads_all, Progress& progress);

/// Calls `take` with the path of each file below a folder, relative to the folder. `is_left_over` is true for
/// incomplete files of a program that was ended. Files must not be removed during the call.
void each_file_below(const std::string& folder, FunctionRef<void(const std::string& path, bool is_left_over)> take);

/// Returns the faults of the documents in the folder, one line for each file. Format 1 has one hash for each document.
std::vector<std::string> document_errors(const DatasetInfo& info, const std::string& folder);

/// Returns the files below manifest/ and checks/ that belong to no table, in order.
std::vector<std::string> strange_tables(const DatasetInfo& info, const std::string& folder);

/// The result of a check.
struct DatasetCheck {
  std::uint64_t plants = 0;           ///< number of plants in the plan
  std::uint64_t rows = 0;             ///< plants with a row in a table
  std::uint64_t failed = 0;           ///< number of these plants with an error
  std::uint64_t files = 0;            ///< files of plants that were read
  std::uint64_t bytes = 0;            ///< bytes of these files
  std::vector<std::string> errors;    ///< one line each: faults of the whole set first, then faults in the order of the
                                      ///< tables
  std::vector<std::string> warnings;  ///< checks that were impossible, one line each
  bool is_old = false;                ///< true if the tables have no hashes, so that they could not be checked
};

/// Options of a check.
struct DatasetCheckOptions {
  std::string root{};      ///< no file outside this folder is read, even through links; empty allows every file
  bool allow_old = false;  ///< true makes missing hashes of a data set of format 1 a warning, and not a fault
};

/// Checks the data set in a folder. Reads every file of each plant and compares sizes and hashes with the manifest.
/// Compares each table with its hash, and draws the values of each row again from plan and seed. Compares plan,
/// documents, data card and arrays with dataset.json. Finds files in the folder that do not belong to the data set.
/// Tables of format 1 have no hashes and cannot be checked: this is a fault unless `allow_old` is set. `models` is the
/// folder of shipped models. Throws InputError if the folder holds no data set, lies outside the root, or has a link
/// that leads outside. Throws Cancelled.
DatasetCheck verify_dataset(const std::string& folder, const Registry& registry, const std::string& models,
                            Progress& progress, const DatasetCheckOptions& options = {});

}  // namespace meristem

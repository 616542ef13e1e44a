// SPDX-License-Identifier: Apache-2.0
// Whether what lies in the folder of a data set is what its manifest says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meristem/base/function_ref.h"
#include "meristem/base/progress.h"
#include "meristem/dataset/manifest.h"

namespace meristem {

/// The rows of a file of the manifest, and what is wrong with it.
struct RowsOfFile {
  std::vector<std::pair<ManifestEntry, std::string>> rows;  ///< with their lines, without line ends
  std::vector<std::string> faults;                          ///< one line each, with the file
};

/// Reads a table of a manifest, or rows of one. Empty with a fault where its first line is not `header`; an empty
/// `header` takes any that a manifest may have.
RowsOfFile read_manifest_rows(const std::string& path, const std::string& header = {});

/// Why the files of a row are not there and right; nothing where they are. Sizes are looked at, and the hashes of all
/// bytes where `reads_all`. Throws Cancelled.
std::optional<std::string> fault_of_files(const ManifestEntry& entry, const std::string& folder, bool reads_all,
                                          const Progress& progress);

/// The faults of all rows, in their order. The progress counts a unit per row. Throws Cancelled.
std::vector<std::optional<std::string>> faults_of_rows(const RowsOfFile& rows, const std::string& folder,
                                                       bool reads_all, Progress& progress);

/// Calls `take` with each file below a folder: its path from there, and whether a program that was ended has left it
/// half written. Files may not be removed meanwhile.
void each_file_below(const std::string& folder, FunctionRef<void(const std::string& path, bool is_left_over)> take);

/// What a folder holds.
struct DatasetCheck {
  std::uint64_t plants = 0;  ///< that the plan asks for
  std::uint64_t rows = 0;    ///< plants with a row in a table
  std::uint64_t failed = 0;  ///< of them, plants that have an error
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
  std::vector<std::string> faults;  ///< one line each, in the order of the tables
};

/// Reads every file of the data set in a folder and compares sizes and hashes with the manifest, the documents with
/// dataset.json, and the files that are there with those that have a row. Throws InputError where the folder holds no
/// data set, Cancelled.
DatasetCheck verify_dataset(const std::string& folder, Progress& progress);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Checks whether the rows of a table of the manifest are unchanged. Random values are drawn again from plan and seed.
// Everything else is compared with hashes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/manifest.h"

namespace meristem {

/// A row of a table, or of a part of one.
struct TableRow {
  ManifestEntry entry;   ///< fields of the row
  std::string line;      ///< without its line end
  bool is_right = true;  ///< false if the row has changed since it was written, or if this is unknown
};

/// The rows of a file, and its faults.
struct TableRows {
  std::vector<TableRow> rows;       ///< in the order of the file
  std::vector<std::string> errors;  ///< one line each, with file, line, row and column
  std::string hash;                 ///< hash of the whole file; empty if the file does not exist
};

/// The data with which the rows of a table are compared.
struct TableKnowledge {
  const DatasetInfo& info;            ///< dataset.json of the folder
  const DatasetPlan* plan = nullptr;  ///< null if it cannot be read: then random values are not compared
  std::string folder;                 ///< folder of the data set
};

/// Returns the hash that a table had when it was written: from dataset.json, or else from checks/. Returns an empty
/// text if neither has one.
std::string known_table_hash(const DatasetInfo& info, const std::string& folder, std::uint64_t table);

/// Reads and checks a table of the manifest. A missing file has no rows and a fault.
TableRows check_table_rows(const TableKnowledge& knowledge, std::uint64_t table);

/// Reads and checks a file of rows below partial/, of a table that is not complete.
TableRows check_part_rows(const TableKnowledge& knowledge, const std::string& path, std::uint64_t table);

}  // namespace meristem

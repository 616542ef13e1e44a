// SPDX-License-Identifier: Apache-2.0
// Whether the rows of a table of the manifest are as they were written. Drawn values are drawn again from plan and
// seed; everything else is compared with hashes.
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
  bool is_right = true;  ///< false if the row has changed since it was written, or if nothing can tell
};

/// The rows of a file, and what is wrong with them.
struct TableRows {
  std::vector<TableRow> rows;       ///< in the order of the file
  std::vector<std::string> faults;  ///< one line each, with file, line, row and column
  std::string hash;                 ///< of the whole file; empty if there is none
};

/// What the rows of a table are compared with.
struct TableKnowledge {
  const DatasetInfo& info;            ///< dataset.json of the folder
  const DatasetPlan* plan = nullptr;  ///< null if it cannot be read: drawn values are not compared
  std::string folder;                 ///< folder of the data set
};

/// Returns the hash that a table had when it was written: that of dataset.json, or else that of checks/. Empty if
/// neither has one.
std::string known_table_hash(const DatasetInfo& info, const std::string& folder, std::uint64_t table);

/// Reads and checks a table of the manifest. A missing file has no rows and a fault.
TableRows check_table_rows(const TableKnowledge& knowledge, std::uint64_t table);

/// Reads and checks a file of rows below partial/ for a table that is not whole.
TableRows check_part_rows(const TableKnowledge& knowledge, const std::string& path, std::uint64_t table);

}  // namespace meristem

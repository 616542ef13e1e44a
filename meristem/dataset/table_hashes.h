// SPDX-License-Identifier: Apache-2.0
// Hashes of a table of the manifest, in a separate file: checks/00000.csv. dataset.json holds one hash of the whole
// table. The hashes of rows and columns show which row and which column has changed, so that only this plant is made
// again. The file also repeats the hashes of plan and documents, so that dataset.json can be restored.
//
// Each line has a kind, a name and a hash: plan, document, table, column, row. The last line, end, has the hash of all
// lines before it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meristem/dataset/dataset_info.h"

namespace meristem {

/// The content of checks/00000.csv.
struct TableHashes {
  std::string plan;
  std::vector<std::pair<std::string, std::string>> documents;  ///< name and hash
  std::string table;                                           ///< hash of all bytes of the table
  std::vector<std::pair<std::string, std::string>> columns;    ///< name and hash of the fields of all rows
  std::vector<std::string> rows;                               ///< hash of each row, without its line end
};

/// Returns the hash of a text as 32 hexadecimal digits.
std::string text_hash(std::string_view text);
/// Returns the hash of a row without its line end.
std::string row_hash(std::string_view line);
/// Returns the hash of the fields of each column, over all rows in their order. A line that is not a row of CSV counts
/// as empty fields.
std::vector<std::string> column_hashes(const std::vector<std::string_view>& lines, std::size_t columns);

/// Returns the hashes of a complete table.
TableHashes hashes_of_table(const DatasetInfo& info, std::string_view table);
std::string table_hashes_text(const TableHashes& hashes);
/// Reads the hashes of a table. Returns nothing if the file does not exist or has changed since it was written.
std::optional<TableHashes> read_table_hashes(const std::string& folder, std::uint64_t table);
/// Returns the path of the hashes of a table in the folder.
std::string table_hashes_path(const std::string& folder, std::uint64_t table);

/// Removes the first line from `text` and returns it without its line end.
std::string_view take_line(std::string_view& text);
/// Returns the text with a last line that has the hash of all of `text`.
std::string with_end_line(std::string text);
/// Removes the last line. Sets `is_right` to true if the line has the hash of the rest. Returns false if `text` ends
/// with another kind of line.
bool take_end_line(std::string_view& text, bool& is_right);

}  // namespace meristem

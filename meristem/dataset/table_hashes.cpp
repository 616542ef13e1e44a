// SPDX-License-Identifier: Apache-2.0
// Writes and reads the hashes of a table's rows and columns. The last line has the hash of all other lines, so an
// edited file is recognised and ignored.
#include "meristem/dataset/table_hashes.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/manifest.h"
#include "meristem/output/write/csv.h"

namespace meristem {

namespace {

constexpr std::string_view kEnd = "end,,";

std::string line_of(const char* kind, const std::string& name, const std::string& hash) {
  return fmt::format("{},{},{}\n", kind, csv_field(name), hash);
}

}  // namespace

std::string text_hash(std::string_view text) { return hash128_hex(std::as_bytes(std::span(text.data(), text.size()))); }

std::string row_hash(std::string_view line) { return fmt::format("{:016x}", hash64(line)); }

std::vector<std::string> column_hashes(const std::vector<std::string_view>& lines, std::size_t columns) {
  std::vector<std::string> texts(columns);
  for (const std::string_view line : lines) {
    const auto fields = csv_fields(line);
    for (std::size_t column = 0; column < columns; ++column) {
      if (fields && column < fields->size()) texts[column] += (*fields)[column];
      texts[column] += '\n';
    }
  }
  for (std::string& text : texts) text = row_hash(text);
  return texts;
}

TableHashes hashes_of_table(const DatasetInfo& info, std::string_view table) {
  TableHashes hashes{.plan = info.plan, .documents = {}, .table = text_hash(table), .columns = {}, .rows = {}};
  for (const DatasetDocument& document : info.documents) hashes.documents.emplace_back(document.name, document.hash);
  const auto labels = csv_fields(take_line(table)).value_or(std::vector<std::string>());
  std::vector<std::string_view> lines;
  while (!table.empty()) lines.push_back(take_line(table));
  for (const std::string_view line : lines) hashes.rows.push_back(row_hash(line));
  const std::vector<std::string> columns = column_hashes(lines, labels.size());
  for (std::size_t k = 0; k < labels.size(); ++k) hashes.columns.emplace_back(labels[k], columns[k]);
  return hashes;
}

std::string table_hashes_text(const TableHashes& hashes) {
  std::string text = "kind,name,hash\n" + line_of("plan", "", hashes.plan);
  for (const auto& [name, hash] : hashes.documents) text += line_of("document", name, hash);
  text += line_of("table", "", hashes.table);
  for (const auto& [name, hash] : hashes.columns) text += line_of("column", name, hash);
  for (const std::string& hash : hashes.rows) text += line_of("row", "", hash);
  return with_end_line(std::move(text));
}

std::optional<TableHashes> read_table_hashes(const std::string& folder, std::uint64_t table) {
  const std::optional<std::string> content = whole_file(table_hashes_path(folder, table));
  if (!content) return std::nullopt;
  std::string_view rest = *content;
  bool is_right = false;
  if (!take_end_line(rest, is_right) || !is_right) return std::nullopt;
  TableHashes hashes;
  take_line(rest);
  while (!rest.empty()) {
    const auto fields = csv_fields(take_line(rest));
    if (!fields || fields->size() != 3) return std::nullopt;
    const std::string& kind = (*fields)[0];
    const std::string& hash = (*fields)[2];
    if (kind == "plan") hashes.plan = hash;
    if (kind == "document") hashes.documents.emplace_back((*fields)[1], hash);
    if (kind == "table") hashes.table = hash;
    if (kind == "column") hashes.columns.emplace_back((*fields)[1], hash);
    if (kind == "row") hashes.rows.push_back(hash);
  }
  return hashes;
}

std::string table_hashes_path(const std::string& folder, std::uint64_t table) {
  return (std::filesystem::path(folder) / kChecksName / fmt::format("{:05}.csv", table)).string();
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string with_end_line(std::string text) {
  text += fmt::format("{}{}\n", kEnd, text_hash(text));
  return text;
}

bool take_end_line(std::string_view& text, bool& is_right) {
  if (!text.ends_with('\n')) return false;
  const std::size_t begin = text.substr(0, text.size() - 1).rfind('\n') + 1;
  std::string_view last = text.substr(begin, text.size() - 1 - begin);
  if (!last.starts_with(kEnd)) return false;
  text = text.substr(0, begin);
  is_right = last.substr(kEnd.size()) == text_hash(text);
  return true;
}

}  // namespace meristem

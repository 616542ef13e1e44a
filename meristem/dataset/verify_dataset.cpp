// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/verify_dataset.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/dataset/dataset_info.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

std::optional<std::string> whole_content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream content;
  content << file.rdbuf();
  if (file.bad()) return std::nullopt;
  return std::move(content).str();
}

/// The document as it lies in the folder.
std::string hash_of_unpacked(const DatasetDocument& document, const fs::path& folder) {
  DocumentBundle bundle{.document = document.document, .files = {}};
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error)) continue;
    const auto content = whole_content(entry.path());
    bundle.files.emplace_back(entry.path().lexically_relative(folder).generic_string(), content.value_or(""));
  }
  std::sort(bundle.files.begin(), bundle.files.end());
  return bundle.hash();
}

/// What one table tells, and its plants' files below `plants/`.
struct TableCheck {
  DatasetCheck sums;
  std::set<std::string> paths;
};

TableCheck check_table(const DatasetInfo& info, const std::string& folder, std::uint64_t table) {
  TableCheck check;
  const std::string path = manifest_path(folder, table);
  const std::uint64_t begin = table * info.rows;
  const std::uint64_t end = std::min(info.plants, begin + info.rows);
  std::error_code error;
  if (!fs::exists(path, error)) {
    check.sums.faults.push_back(fmt::format("{} is missing: {} plants", path, end - begin));
    return check;
  }
  RowsOfFile rows = read_manifest_rows(path);
  check.sums.faults = std::move(rows.faults);
  std::uint64_t next = begin;
  for (const auto& [entry, line] : rows.rows) {
    if (entry.number != next) {
      check.sums.faults.push_back(
          fmt::format("{}: the row of the plant {} stands where that of {} should", path, entry.number, next));
    }
    next = entry.number + 1;
    ++check.sums.rows;
    check.sums.failed += entry.has_failed ? 1 : 0;
    for (const PlantFile& file : entry.files) {
      ++check.sums.files;
      check.sums.bytes += file.bytes;
      check.paths.insert(file.path);
    }
    if (auto fault = fault_of_files(entry, folder, true)) check.sums.faults.push_back(std::move(*fault));
  }
  if (next != end) check.sums.faults.push_back(fmt::format("{}: rows are missing from {} on", path, next));
  return check;
}

}  // namespace

RowsOfFile read_manifest_rows(const std::string& path, const std::string& header) {
  RowsOfFile all;
  const auto content = whole_content(path);
  if (!content) {
    all.faults.push_back(fmt::format("{} cannot be read", path));
    return all;
  }
  std::string_view rest = *content;
  const auto next_line = [&rest] {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end == std::string_view::npos ? rest.size() : end + 1));
    return line;
  };
  const std::string_view first = next_line();
  const auto layout = ManifestLayout::of_header(first);
  if (!layout || (!header.empty() && std::string(first) + "\n" != header)) {
    all.faults.push_back(fmt::format("{}: its first line is not that of this manifest", path));
    return all;
  }
  for (std::size_t number = 2; !rest.empty(); ++number) {
    const bool is_ended = rest.find('\n') != std::string_view::npos;
    const std::string_view line = next_line();
    auto entry = layout->entry(line);
    if (!entry || !is_ended) {
      all.faults.push_back(fmt::format("{}:{}: this is no row", path, number));
      continue;
    }
    all.rows.emplace_back(std::move(*entry), line);
  }
  return all;
}

std::optional<std::string> fault_of_files(const ManifestEntry& entry, const std::string& folder, bool reads_all) {
  for (const PlantFile& file : entry.files) {
    const fs::path path = fs::path(folder) / file.path;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return fmt::format("{} is missing", path.string());
    if (size != file.bytes) return fmt::format("{} has {} bytes instead of {}", path.string(), size, file.bytes);
    if (!reads_all) continue;
    const auto content = whole_content(path);
    if (!content) return fmt::format("{} cannot be read", path.string());
    const auto bytes = std::as_bytes(std::span(content->data(), content->size()));
    if (hash128_hex(bytes) != file.hash) return fmt::format("{} has other bytes than were written", path.string());
  }
  return std::nullopt;
}

DatasetCheck verify_dataset(const std::string& folder, Progress& progress) {
  const std::optional<DatasetInfo> info = read_dataset_info(folder);
  if (!info) {
    throw InputError(Diagnostic{
        .message = "the folder holds no data set", .expected = "a folder with dataset.json", .file = folder});
  }
  const std::uint64_t tables = info->table_count();
  std::vector<TableCheck> checks(tables);
  progress.begin("reading all files", tables);
  parallel_for(tables, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t table = begin; table < end; ++table) {
      progress.check();
      checks[table] = check_table(*info, folder, table);
      progress.advance();
    }
  });

  DatasetCheck all{.plants = info->plants, .faults = {}};
  const fs::path root(folder);
  for (const DatasetDocument& document : info->documents) {
    if (hash_of_unpacked(document, root / "documents" / document.name) == document.hash) continue;
    all.faults.push_back(fmt::format("{} has changed", (root / "documents" / document.name).string()));
  }
  std::set<std::string> paths;
  for (TableCheck& check : checks) {
    all.rows += check.sums.rows;
    all.failed += check.sums.failed;
    all.files += check.sums.files;
    all.bytes += check.sums.bytes;
    for (std::string& fault : check.sums.faults) all.faults.push_back(std::move(fault));
    paths.merge(check.paths);
  }
  std::vector<std::string> strangers;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "plants", error)) {
    const std::string path = entry.path().lexically_relative(root).generic_string();
    if (entry.is_regular_file(error) && !paths.contains(path)) {
      strangers.push_back(fmt::format("{} belongs to no row", entry.path().string()));
    }
  }
  std::sort(strangers.begin(), strangers.end());
  all.faults.insert(all.faults.end(), strangers.begin(), strangers.end());
  return all;
}

}  // namespace meristem

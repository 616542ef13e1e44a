// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/verify_dataset.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/dataset_info.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

/// The document as it lies in the folder.
std::string hash_of_unpacked(const DatasetDocument& document, const std::string& folder) {
  DocumentBundle bundle{.document = document.document, .files = {}};
  each_file_below(folder, [&](const std::string& path, bool is_left_over) {
    if (is_left_over) return;
    bundle.files.emplace_back(path, whole_file((fs::path(folder) / path).string()).value_or(""));
  });
  std::sort(bundle.files.begin(), bundle.files.end());
  return bundle.hash();
}

/// What one table tells, and its plants' files below `plants/`.
struct TableCheck {
  DatasetCheck sums;
  std::set<std::string> paths;
};

TableCheck check_table(const DatasetInfo& info, const std::string& folder, std::uint64_t table, Progress& progress) {
  TableCheck check;
  const std::string path = manifest_path(folder, table);
  const std::uint64_t begin = table * info.rows;
  const std::uint64_t end = std::min(info.plants, begin + info.rows);
  std::error_code error;
  if (!fs::exists(path, error)) {
    check.sums.faults.push_back(fmt::format("{} is missing: {} plants", path, end - begin));
    progress.advance(end - begin);
    return check;
  }
  RowsOfFile rows = read_manifest_rows(path);
  check.sums.faults = std::move(rows.faults);
  std::vector<std::optional<std::string>> faults = faults_of_rows(rows, folder, true, progress);
  std::uint64_t next = begin;
  for (std::size_t row = 0; row < rows.rows.size(); ++row) {
    const ManifestEntry& entry = rows.rows[row].first;
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
    if (faults[row]) check.sums.faults.push_back(std::move(*faults[row]));
  }
  if (next != end) check.sums.faults.push_back(fmt::format("{}: rows are missing from {} on", path, next));
  return check;
}

}  // namespace

RowsOfFile read_manifest_rows(const std::string& path, const std::string& header) {
  RowsOfFile all;
  const auto content = whole_file(path);
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

std::optional<std::string> fault_of_files(const ManifestEntry& entry, const std::string& folder, bool reads_all,
                                          const Progress& progress) {
  for (const PlantFile& file : entry.files) {
    progress.check();
    const fs::path path = fs::path(folder) / file.path;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return fmt::format("{} is missing", path.string());
    if (size != file.bytes) return fmt::format("{} has {} bytes instead of {}", path.string(), size, file.bytes);
    if (!reads_all) continue;
    const auto content = whole_file(path.string());
    if (!content) return fmt::format("{} cannot be read", path.string());
    const auto bytes = std::as_bytes(std::span(content->data(), content->size()));
    if (hash128_hex(bytes) != file.hash) return fmt::format("{} has other bytes than were written", path.string());
  }
  return std::nullopt;
}

std::vector<std::optional<std::string>> faults_of_rows(const RowsOfFile& rows, const std::string& folder,
                                                       bool reads_all, Progress& progress) {
  constexpr std::size_t kRowsAtOnce = 8;
  std::vector<std::optional<std::string>> faults(rows.rows.size());
  parallel_for(rows.rows.size(), kRowsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      faults[row] = fault_of_files(rows.rows[row].first, folder, reads_all, progress);
      progress.advance();
    }
  });
  return faults;
}

void each_file_below(const std::string& folder, FunctionRef<void(const std::string& path, bool is_left_over)> take) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error)) continue;
    const std::string name = entry.path().filename().string();
    take(entry.path().lexically_relative(folder).generic_string(), name.starts_with('.') && name.ends_with(".part"));
  }
}

DatasetCheck verify_dataset(const std::string& folder, Progress& progress) {
  const std::optional<DatasetInfo> info = read_dataset_info(folder);
  if (!info) throw no_dataset(folder);
  const std::uint64_t tables = info->table_count();
  std::vector<TableCheck> checks(tables);
  progress.begin("reading all files", info->plants);
  parallel_for(tables, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t table = begin; table < end; ++table) {
      progress.check();
      checks[table] = check_table(*info, folder, table, progress);
    }
  });

  DatasetCheck all{.plants = info->plants, .faults = {}};
  const fs::path root(folder);
  for (const DatasetDocument& document : info->documents) {
    if (hash_of_unpacked(document, (fs::path(documents_path(folder)) / document.name).string()) == document.hash)
      continue;
    all.faults.push_back(fmt::format("{} has changed", (fs::path(documents_path(folder)) / document.name).string()));
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
  const std::string plants = (root / "plants").string();
  each_file_below(plants, [&](const std::string& path, bool is_left_over) {
    if (is_left_over || paths.contains("plants/" + path)) return;
    strangers.push_back(fmt::format("{} belongs to no row", (fs::path(plants) / path).string()));
  });
  std::sort(strangers.begin(), strangers.end());
  all.faults.insert(all.faults.end(), strangers.begin(), strangers.end());
  return all;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Makes ranges of plants. A plant is made in a scratch folder, and its files are moved once all of them are complete.
// The rows of a range are one file that appears last and ends with a hash, so an interrupted range leaves no rows.
#include "meristem/dataset/plant_range.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/whole_file.h"
#include "meristem/dataset/dataset_info.h"
#include "meristem/dataset/table_hashes.h"

namespace meristem {

namespace fs = std::filesystem;

std::string rows_path(const std::string& folder, PlantRange range) {
  return (fs::path(folder) / "partial" / "rows" / fmt::format("{:010}-{:010}.csv", range.begin, range.end)).string();
}

std::map<std::uint64_t, std::vector<std::string>> row_parts(const DatasetInfo& info, const std::string& folder) {
  std::map<std::uint64_t, std::vector<std::string>> parts;
  std::error_code ignored;
  for (const fs::directory_entry& part : fs::directory_iterator(fs::path(folder) / "partial" / "rows", ignored)) {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    const std::string name = part.path().filename().string();
    if (std::sscanf(name.c_str(), "%10lu-%10lu.csv", &begin, &end) != 2 || begin >= info.plants) continue;
    parts[begin / info.rows].push_back(part.path().string());
  }
  for (auto& [table, files] : parts) std::sort(files.begin(), files.end());
  return parts;
}

bool sees_dataset(const DatasetPlan& plan, const std::string& folder) {
  try {
    const auto info = read_dataset_info(folder);
    return info && info->plan == plan.hash;
  } catch (const std::exception&) {
    return false;
  }
}

void make_range(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& folder,
                Progress& progress) {
  const fs::path root(folder);
  const ScratchFolder scratch((root / "partial" / "plants").string(), "plant-");
  std::string rows = manifest_header(plan);
  for (std::uint64_t number = range.begin; number < range.end; ++number) {
    const MadePlant made = maker.make(number, scratch.path(), progress);
    if (!made.files.empty()) make_folders((root / plant_folder(made.plant)).string());
    for (const PlantFile& file : made.files) {
      const fs::path from = fs::path(scratch.path()) / fs::path(file.path).filename();
      std::error_code error;
      fs::rename(from, root / file.path, error);
      if (error) throw MachineError(fmt::format("cannot write '{}': {}", (root / file.path).string(), error.message()));
    }
    rows += manifest_row(plan, made);
  }
  make_folders((root / "partial" / "rows").string());
  write_whole_file(rows_path(folder, range), with_end_line(std::move(rows)));
}

MadeRange make_range_apart(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& scratch,
                           Progress& progress) {
  const ScratchFolder folder(scratch, "plant-");
  MadeRange all{.range = range, .rows = manifest_header(plan), .files = {}};
  for (std::uint64_t number = range.begin; number < range.end; ++number) {
    const MadePlant made = maker.make(number, folder.path(), progress);
    for (const PlantFile& file : made.files) {
      const fs::path path = fs::path(folder.path()) / fs::path(file.path).filename();
      std::optional<std::string> content = whole_file(path.string());
      if (!content || content->size() != file.bytes) {
        throw MachineError(fmt::format("cannot read '{}' again", path.string()));
      }
      all.files.emplace_back(file.path, std::move(*content));
      fs::remove(path);
    }
    all.rows += manifest_row(plan, made);
  }
  return all;
}

void put_range(const MadeRange& made, const DatasetPlan& plan, const std::string& folder) {
  const fs::path root(folder);
  for (std::uint64_t number = made.range.begin; number < made.range.end; ++number) {
    if (!made.files.empty()) make_folders((root / plant_folder(plan.plant(number))).string());
  }
  for (const auto& [path, content] : made.files) write_whole_file((root / path).string(), content);
  make_folders((root / "partial" / "rows").string());
  write_whole_file(rows_path(folder, made.range), with_end_line(made.rows));
}

}  // namespace meristem

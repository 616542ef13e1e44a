// SPDX-License-Identifier: Apache-2.0
#include "meristem/dataset/plant_range.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "meristem/base/atomic_file.h"
#include "meristem/base/diagnostic.h"
#include "meristem/dataset/dataset_info.h"

namespace meristem {

namespace {

namespace fs = std::filesystem;

/// Makes a folder and those above it. Throws MachineError.
void make_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw MachineError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
}

/// A new folder that goes with its owner.
class ScratchFolder {
 public:
  explicit ScratchFolder(const fs::path& parent) {
    make_folders(parent);
    std::string name = (parent / "plant-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw MachineError(fmt::format("cannot make a folder in '{}': {}", parent.string(), std::strerror(errno)));
    }
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void write_whole(const std::string& path, const std::string& content) {
  AtomicFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace

std::string rows_path(const std::string& folder, PlantRange range) {
  return (fs::path(folder) / "partial" / "rows" / fmt::format("{:010}-{:010}.csv", range.begin, range.end)).string();
}

bool sees_dataset(const DatasetPlan& plan, const std::string& folder) {
  try {
    const auto info = read_dataset_info(folder);
    return info && info->plan == plan.hash();
  } catch (const std::exception&) {
    return false;
  }
}

void make_range(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& folder,
                Progress& progress) {
  const fs::path root(folder);
  const ScratchFolder scratch(root / "partial" / "plants");
  std::string rows = manifest_header(plan);
  for (std::uint64_t number = range.begin; number < range.end; ++number) {
    const MadePlant made = maker.make(number, scratch.path().string(), progress);
    if (!made.files.empty()) make_folders(root / plant_folder(made.plant));
    for (const PlantFile& file : made.files) {
      const fs::path from = scratch.path() / fs::path(file.path).filename();
      std::error_code error;
      fs::rename(from, root / file.path, error);
      if (error) throw MachineError(fmt::format("cannot write '{}': {}", (root / file.path).string(), error.message()));
    }
    rows += manifest_row(plan, made);
  }
  make_folders(root / "partial" / "rows");
  write_whole(rows_path(folder, range), rows);
}

MadeRange make_range_apart(PlantMaker& maker, const DatasetPlan& plan, PlantRange range, const std::string& scratch,
                           Progress& progress) {
  const ScratchFolder folder(scratch);
  MadeRange all{.range = range, .rows = manifest_header(plan), .files = {}};
  for (std::uint64_t number = range.begin; number < range.end; ++number) {
    const MadePlant made = maker.make(number, folder.path().string(), progress);
    for (const PlantFile& file : made.files) {
      const fs::path path = folder.path() / fs::path(file.path).filename();
      std::ifstream opened(path, std::ios::binary);
      std::ostringstream content;
      content << opened.rdbuf();
      all.files.emplace_back(file.path, std::move(content).str());
      if (all.files.back().second.size() != file.bytes) {
        throw MachineError(fmt::format("cannot read '{}' again", path.string()));
      }
      fs::remove(path);
    }
    all.rows += manifest_row(plan, made);
  }
  return all;
}

void put_range(const MadeRange& made, const DatasetPlan& plan, const std::string& folder) {
  const fs::path root(folder);
  for (std::uint64_t number = made.range.begin; number < made.range.end; ++number) {
    if (!made.files.empty()) make_folders(root / plant_folder(plan.plant(number)));
  }
  for (const auto& [path, content] : made.files) write_whole((root / path).string(), content);
  make_folders(root / "partial" / "rows");
  write_whole(rows_path(folder, made.range), made.rows);
}

}  // namespace meristem

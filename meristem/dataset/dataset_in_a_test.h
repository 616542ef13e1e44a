// SPDX-License-Identifier: Apache-2.0
// A small data set for tests, with rods that grow quickly.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "meristem/base/progress.h"
#include "meristem/components/registry.h"
#include "meristem/dataset/dataset_folder.h"
#include "meristem/dataset/dataset_plan.h"
#include "meristem/dataset/plant_maker.h"
#include "meristem/dataset/plant_range.h"

namespace meristem {

/// A wooden rod whose length is a variable. Its component refuses a length of 0.
inline constexpr const char* kRod = R"({"meristem": 1, "name": "Rod", "licence": "CC0-1.0",
  "variables": {"tall": {"value": 1, "min": 0.5, "max": 2}},
  "components": {"rod": {"type": "simple", "shape": "box", "size": [0.1, "tall", 0.1]}}})";

inline DatasetPlan rod_plan(const std::string& text, const std::string& document = kRod) {
  return read_dataset_plan(text, "plan.json", builtin_components(),
                           {.documents = {{.name = "rod", .text = document, .file = "rod.json", .set = {}}}});
}

inline std::string file_content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void write_content(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Returns all files below a folder except partial ones, by their paths.
inline std::map<std::string, std::string> files_below(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    if (entry.is_regular_file() && !path.starts_with("partial")) files[path] = file_content(entry.path());
  }
  return files;
}

/// Makes up to `max` missing plants, as a program does, and writes the data card once all exist. Returns the number of
/// plants made.
inline std::uint64_t make_plants(const DatasetPlan& plan, const std::string& path, std::uint64_t max = kMaxPlants,
                                 DatasetOpening opening = DatasetOpening::resume) {
  Progress progress;
  DatasetFolder folder(plan, path, opening, progress);
  PlantMaker maker(plan, builtin_components(), {.documents = path + "/documents"});
  std::uint64_t made = 0;
  while (made < max) {
    const auto range = folder.next();
    if (!range) break;
    make_range(maker, plan, *range, path, progress);
    folder.add(*range, 0.01 * static_cast<double>(range->count()));
    made += range->count();
  }
  if (folder.done() == folder.total()) folder.finish(progress);
  return made;
}

}  // namespace meristem

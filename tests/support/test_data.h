// SPDX-License-Identifier: Apache-2.0
// Paths of the project's own test data, and of published data sets, which only some machines have.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace meristem {

/// Returns the path of a file of the project, such as "models/house.obj". The data that only tests need are in
/// "tests/data", whose README.md lists them.
std::string project_file(const std::string& name);

/// Returns the path of a published data set, such as "trees/noylum2.mtg". Returns nothing if this machine does not have
/// the file. The published data are not part of the project. They are in the folder shared/data beside the project, or
/// in the folder that the environment variable MERISTEM_SHARED_DATA names. Tests use them in addition to the project's
/// own data, through `data_sets` or `data_files`, so that no test skips itself without them.
std::optional<std::string> find_shared_data(const std::string& name);

/// A file and what is known of its contents.
template <class Facts>
struct DataSet {
  std::string file;
  Facts facts;
};

/// Returns the project's own data sets, and after them the published ones that are on this machine, with their paths.
/// Tests make the same claims about all of them:
///
///   for (const auto& [file, facts] : data_sets<TreeFacts>({{"tests/data/trees/sapling.mtg", {.segments = 874}}},
///                                                         {{"trees/noylum2.mtg", {.segments = 6427}}})) {
template <class Facts>
std::vector<DataSet<Facts>> data_sets(const std::vector<DataSet<Facts>>& own,
                                      const std::vector<DataSet<Facts>>& published) {
  std::vector<DataSet<Facts>> sets;
  for (const auto& [file, facts] : own) sets.push_back({project_file(file), facts});
  for (const auto& [file, facts] : published) {
    if (auto path = find_shared_data(file)) sets.push_back({std::move(*path), facts});
  }
  return sets;
}

/// Like `data_sets`, for tests that make equal claims about all files.
std::vector<std::string> data_files(const std::vector<std::string>& own, const std::vector<std::string>& published);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace meristem {

/// Returns the path of a measured data set, such as "trees/noylum2.mtg". Returns nothing if the data do not exist,
/// because they are not part of the project. They are in the folder shared/data beside the project, or in the folder
/// that the environment variable MERISTEM_SHARED_DATA names. A test that needs the data skips itself:
///
///   const auto path = find_shared_data("trees/noylum2.mtg");
///   if (!path) GTEST_SKIP() << kNoSharedData;
std::optional<std::string> find_shared_data(const std::string& name);

inline constexpr const char* kNoSharedData = "the measured data is not here; MERISTEM_SHARED_DATA may name its folder";

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace meristem {

/// The path of a measured data set, such as "trees/noylum2.mtg", or nothing where the data is not there: it is not part
/// of the project. It lies in the folder shared/data beside the project's, or where the environment variable
/// MERISTEM_SHARED_DATA says. A test that needs it skips itself:
///
///   const auto path = find_shared_data("trees/noylum2.mtg");
///   if (!path) GTEST_SKIP() << kNoSharedData;
std::optional<std::string> find_shared_data(const std::string& name);

inline constexpr const char* kNoSharedData = "the measured data is not here; MERISTEM_SHARED_DATA may name its folder";

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace meristem {

/// Returns true if a path lies in the folder `root` after links and dots are resolved, or if `root` is empty. Does not
/// check that the file exists.
bool is_within_root(const std::string& path, const std::string& root);

}  // namespace meristem

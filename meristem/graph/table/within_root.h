// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace meristem {

/// Returns true if a path lies in the folder `root`, wherever its links and dots lead, or if `root` is empty. Does not
/// tell whether there is a file.
bool is_within_root(const std::string& path, const std::string& root);

}  // namespace meristem

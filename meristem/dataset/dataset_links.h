// SPDX-License-Identifier: Apache-2.0
// A check of the links in the folder of a data set.
#pragma once

#include <string>

namespace meristem {

/// Throws InputError for the first link in `folder` whose target is neither in `root` nor in `folder`, after all links
/// and dots are resolved. The message does not disclose whether the target exists. Does nothing if `root` is empty or
/// if the folder does not exist.
void require_links_within(const std::string& folder, const std::string& root);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Where the links in the folder of a data set may lead.
#pragma once

#include <string>

namespace meristem {

/// Throws InputError for the first link in `folder` that leads neither into `root` nor into `folder`, wherever its
/// links and dots lead. The message does not tell whether something is there. Does nothing if `root` is empty or if
/// there is no such folder.
void require_links_within(const std::string& folder, const std::string& root);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace meristem::studio {

/// A file of the page's source.
struct PageSource {
  std::string name;  ///< name in apps/studio/page/src/server/types
  std::string text;
};

/// Returns the types of all messages for the page: a file for each subject, and `messages.ts` with the tables of
/// requests, answers and messages by name.
std::vector<PageSource> typescript_files();

}  // namespace meristem::studio

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// The origin of a file, with everything that is needed to grow its plant again.
struct Provenance {
  std::string name;                 ///< name of the document
  std::string author;               ///< author of the document, or empty
  std::string licence;              ///< licence of the document, or empty
  std::uint64_t seed = 0;           ///< seed of the plant
  std::string version;              ///< version of the program
  std::vector<std::string> sets{};  ///< values that were set for the document, in the form of `--set`: "age=20"
};

/// Returns the provenance and the units as comments for people: one line each, without the comment mark of the file.
/// Leaves out name, author and licence if they are empty. Adds a line with the command that grows the plant again.
std::vector<std::string> provenance_lines(const Provenance& provenance, std::string_view units = "metres, y up");

}  // namespace meristem

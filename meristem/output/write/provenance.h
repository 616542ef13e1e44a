// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meristem {

/// The origin of a file: enough to grow its plant again.
struct Provenance {
  std::string name;                 ///< the document's
  std::string author;               ///< author of the document, or empty
  std::string licence;              ///< licence of the document, or empty
  std::uint64_t seed = 0;           ///< seed of the plant
  std::string version;              ///< version of the program
  std::vector<std::string> sets{};  ///< the values that were set for it, each as `--set` takes it: "age=20"
};

/// The provenance and the units as comments of a file, for people: one line each, without the mark of a comment.
std::vector<std::string> provenance_lines(const Provenance& provenance, std::string_view units = "metres, y up");

}  // namespace meristem

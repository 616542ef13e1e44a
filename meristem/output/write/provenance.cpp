// SPDX-License-Identifier: Apache-2.0
#include "meristem/output/write/provenance.h"

#include <fmt/format.h>

#include "meristem/output/write/names.h"

namespace meristem {

std::vector<std::string> provenance_lines(const Provenance& provenance, std::string_view units) {
  std::vector<std::string> lines{single_line("Meristem " + provenance.version)};
  const auto add = [&](std::string_view what, const std::string& text) {
    if (!text.empty()) lines.push_back(fmt::format("{}: {}", what, single_line(text)));
  };
  add("name", provenance.name);
  add("author", provenance.author);
  add("licence", provenance.licence);
  lines.push_back(fmt::format("seed: {}", provenance.seed));
  lines.push_back(fmt::format("to grow it again: meristem grow DOCUMENT -o FILE --seed {}", provenance.seed));
  lines.push_back(fmt::format("units: {}", units));
  return lines;
}

}  // namespace meristem

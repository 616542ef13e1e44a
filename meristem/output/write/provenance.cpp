// SPDX-License-Identifier: Apache-2.0
// Writes the origin of a plant as comment lines, including the command that grows it again.
#include "meristem/output/write/provenance.h"

#include <algorithm>

#include <fmt/format.h>

#include "meristem/output/write/names.h"

namespace meristem {

namespace {

/// Returns a text for a shell: in single quotes if it contains characters other than letters, digits and similar marks.
std::string quoted(const std::string& text) {
  const auto is_plain = [](char c) {
    return ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') ||
           std::string_view("_=.,:+-/").find(c) != std::string_view::npos;
  };
  if (std::ranges::all_of(text, is_plain)) return text;
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  return result + "'";
}

}  // namespace

std::vector<std::string> provenance_lines(const Provenance& provenance, std::string_view units) {
  std::vector<std::string> lines{single_line("Meristem " + provenance.version)};
  const auto add = [&](std::string_view what, const std::string& text) {
    if (!text.empty()) lines.push_back(fmt::format("{}: {}", what, single_line(text)));
  };
  add("name", provenance.name);
  add("author", provenance.author);
  add("licence", provenance.licence);
  lines.push_back(fmt::format("seed: {}", provenance.seed));
  std::string again = fmt::format("meristem grow DOCUMENT -o FILE --seed {}", provenance.seed);
  for (const std::string& set : provenance.sets) again += " --set " + quoted(set);
  lines.push_back("to grow it again: " + again);  // never shortened
  lines.push_back(fmt::format("units: {}", units));
  return lines;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/grow/lsystem/module_reader.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "meristem/base/counted.h"

namespace meristem {

namespace {

bool is_structural(std::string_view symbol) {
  return symbol == "(" || symbol == ")" || symbol == "<" || symbol == ">" || symbol == ":" || symbol == kArrow;
}

}  // namespace

void ModuleReader::declare(std::string_view name) {
  if (noted_ != nullptr) noted_->push_back(name);
  if (!symbols_.insert(name).second) return;
  const auto place = std::lower_bound(symbol_sizes_.begin(), symbol_sizes_.end(), name.size(), std::greater<>());
  if (place == symbol_sizes_.end() || *place != name.size()) symbol_sizes_.insert(place, name.size());
}

std::string_view ModuleReader::symbol_of(std::string_view text) const {
  for (const std::size_t size : symbol_sizes_) {
    if (size <= text.size() && symbols_.count(text.substr(0, size)) > 0) return text.substr(0, size);
  }
  return text.substr(0, character_bytes(text));
}

std::optional<ModuleText> ModuleReader::next(std::string_view& rest) {
  const auto fail = [&](std::string_view at, std::string message, std::string expected) {
    errors_.add(at, std::move(message), std::move(expected));
    rest = {};
    return std::nullopt;
  };
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  if (rest.empty()) return std::nullopt;

  ModuleText module;
  module.all = rest;
  module.symbol = symbol_of(rest);
  const auto first_byte = static_cast<unsigned char>(rest.front());
  if (first_byte < 0x20 || first_byte == 0x7F) {
    return fail(rest, fmt::format("control character 0x{:02x} is not a symbol", first_byte), "a printable character");
  }
  if (module.symbol == "(") return fail(rest, "'(' follows no symbol", "a symbol before its parameters");
  if (module.symbol == ")") return fail(rest, "')' closes no '('", "a symbol");
  if (is_structural(module.symbol)) return fail(rest, fmt::format("'{}' is not a symbol", module.symbol), "a symbol");
  rest.remove_prefix(module.symbol.size());
  if (noted_ != nullptr) noted_->push_back(module.symbol);

  // Split the parameters at commas outside inner parentheses.
  std::size_t at = 0;
  while (at < rest.size() && is_blank(rest[at])) ++at;
  if (at == rest.size() || rest[at] != '(') {
    module.all = module.all.substr(0, module.symbol.size());
    return module;
  }
  const std::string_view opening = rest.substr(at);
  std::size_t begin = at + 1;
  int depth = 0;
  for (; at < rest.size(); ++at) {
    if (rest[at] == '(') ++depth;
    const bool ends = rest[at] == ')' && --depth == 0;
    if (!ends && !(rest[at] == ',' && depth == 1)) continue;
    module.arguments.push_back(trimmed(rest.substr(begin, at - begin)));
    begin = at + 1;
    if (ends) break;
  }
  if (at == rest.size()) return fail(opening, "'(' is not closed", "')' after the parameters");
  if (module.arguments.size() == 1 && module.arguments.front().empty()) module.arguments.clear();
  rest.remove_prefix(at + 1);
  module.all = module.all.substr(0, static_cast<std::size_t>(rest.data() - module.all.data()));
  return module;
}

LetterIndex ModuleReader::letter_of(const ModuleText& module) {
  const std::size_t arity = module.arguments.size();
  const bool is_fixed = module.symbol == "[" || module.symbol == "]" || module.symbol == "%";
  if (is_fixed && arity > 0) {
    errors_.add(module.all, fmt::format("'{}' has {}", module.symbol, counted(arity, "parameter")), "no parameters");
    return kNoLetter;
  }
  if (arity > kMaxVariables) {
    errors_.add(module.all, fmt::format("'{}' has {} parameters", module.symbol, arity),
                fmt::format("at most {}", kMaxVariables));
    return kNoLetter;
  }
  try {
    return alphabet_.add(module.symbol, static_cast<std::uint16_t>(arity));
  } catch (const std::length_error&) {
    errors_.add(module.all, "the grammar has more than 65534 letters", "fewer");
    return kNoLetter;
  }
}

bool ModuleReader::match_bracket(const ModuleText& module, std::vector<std::string_view>& open) {
  if (module.symbol == "[") open.push_back(module.all);
  if (module.symbol != "]") return true;
  if (open.empty()) {
    errors_.add(module.all, "']' closes no '['", "'[' before it");
    return false;
  }
  open.pop_back();
  return true;
}

void ModuleReader::report_unclosed(const std::vector<std::string_view>& open) {
  for (const std::string_view bracket : open) errors_.add(bracket, "'[' is not closed", "']'");
}

}  // namespace meristem

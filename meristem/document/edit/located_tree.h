// SPDX-License-Identifier: Apache-2.0
// A JSON text with its tree, and the positions of all values in the text. All edits of the text use it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// A value of the text; all offsets are bytes.
struct TextNode {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t begin = 0;             ///< beginning of the value itself
  std::size_t end = 0;               ///< behind its last byte
  std::size_t name_begin = kNone;    ///< beginning of a member's name, at its quote
  std::size_t name_end = kNone;      ///< end of the name, after the closing quote
  std::size_t comma = kNone;         ///< comma after it; kNone for the last part of its container
  std::vector<std::uint32_t> parts;  ///< parts of a list or object, in order

  std::size_t first() const { return name_begin == kNone ? begin : name_begin; }
};

/// A value with its position.
struct LocatedValue {
  const Value* value = nullptr;
  std::uint32_t node = 0;
};

class LocatedTree {
 public:
  /// Throws what parse_json throws.
  explicit LocatedTree(std::string text, const Progress* progress = nullptr);

  const std::string& text() const { return text_; }
  LocatedValue root() const { return {&value_, 0}; }
  const TextNode& at(LocatedValue value) const { return nodes_[value.node]; }
  /// Returns an element of a list or the value of a member.
  LocatedValue part(LocatedValue container, std::size_t index) const;

 private:
  std::string text_;
  Value value_;
  std::vector<TextNode> nodes_;  // in the order of the text
};

/// Returns the number of parts of a list or object, or 0 for other values.
std::size_t part_count(const Value& value);

/// Returns the end of the spaces and comments that begin at `at`: the next token or the end of the text.
std::size_t skip_blanks_and_comments(std::string_view text, std::size_t at);

}  // namespace meristem

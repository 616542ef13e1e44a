// SPDX-License-Identifier: Apache-2.0
// A JSON text with its tree, and the positions of all values in the text. All edits of the text use it. After an edit,
// only the changed parts are read again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/document/edit/patch.h"
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
  const TextNode& at(LocatedValue value) const { return node(value.node); }
  /// Returns an element of a list or the value of a member.
  LocatedValue part(LocatedValue container, std::size_t index) const;
  /// Returns the index of a member of an object, or TextNode::kNone if it has no such member or is not an object. Takes
  /// constant time on average.
  std::size_t index_of(LocatedValue object, std::string_view name) const;

  /// Applies a patch to the text and the tree. The new text must be JSON without repeated names. Reads only the parts
  /// of the innermost list or object that the patch touches, so the time is nearly independent of the size of the
  /// text. Invalidates all located values. Throws what parse_json throws, and std::invalid_argument if the patch is not
  /// sound; the tree must not be used then.
  void apply(const TextPatch& patch, const Progress* progress = nullptr);

  /// Returns the number of bytes that were parsed so far. Shows the work of edits.
  std::size_t parsed_bytes() const { return parsed_bytes_; }

 private:
  /// A splice that has moved the text after it.
  struct Shift {
    std::size_t offset = 0;   // in the text before the splice
    std::size_t removed = 0;  // bytes
    std::size_t added = 0;    // bytes
  };
  /// The members of a large object by name.
  struct MemberNames {
    std::unordered_map<std::string, std::size_t> positions;  // when the member was entered
    std::size_t moves = 0;                                   // most places that a member has moved since
  };
  /// The list or object that a patch touches.
  struct Touched {
    Value* value = nullptr;
    std::uint32_t node = 0;
    std::size_t depth = 0;
  };
  struct PartRange;

  const TextNode& node(std::uint32_t index) const;
  void move_all() const;
  Touched innermost(std::size_t begin, std::size_t end);
  std::vector<TextPatch> split(const Touched& touched, const TextPatch& patch) const;
  PartRange read_parts(const Touched& touched, const TextPatch& patch, const Progress* progress) const;
  void note_names(const Touched& touched, const PartRange& range);

  std::string text_;
  Value value_;
  std::size_t parsed_bytes_ = 0;
  // Positions are moved when they are needed: a node has seen the first `seen_` of all shifts.
  mutable std::vector<TextNode> nodes_;
  mutable std::vector<std::uint32_t> seen_;
  mutable std::vector<Shift> shifts_;
  mutable std::unordered_map<std::uint32_t, MemberNames> names_;  // by the object's node
};

/// Returns the number of parts of a list or object, or 0 for other values.
std::size_t part_count(const Value& value);

/// Returns the end of the spaces and comments that begin at `at`: the next token or the end of the text.
std::size_t skip_blanks_and_comments(std::string_view text, std::size_t at);

}  // namespace meristem

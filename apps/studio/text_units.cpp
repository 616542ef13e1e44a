// SPDX-License-Identifier: Apache-2.0
// Counts UTF-16 code units in UTF-8 texts. All positions are converted in one pass over the text, in sorted order; a
// character beyond U+FFFF counts as two units.
#include "text_units.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace meristem::studio {

namespace {

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

/// Returns the number of bytes of the character at `at`. A byte that begins no character counts as one.
std::size_t character_size(std::string_view text, std::size_t at) {
  std::size_t size = 1;
  while (size < 4 && at + size < text.size() && continues(text[at + size])) ++size;
  return size;
}

std::uint32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first;
  std::uint32_t code = first & (0x7fU >> character.size());
  for (const char byte : character.substr(1)) code = code << 6U | (static_cast<unsigned char>(byte) & 0x3fU);
  return code;
}

/// Walks over a text and counts bytes and units.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::size_t byte() const { return byte_; }
  std::size_t unit() const { return unit_; }
  bool is_at_end() const { return byte_ == text_.size(); }
  std::string_view character() const { return text_.substr(byte_, character_size(text_, byte_)); }
  void step() {
    const std::size_t size = character_size(text_, byte_);
    byte_ += size;
    unit_ += size == 4 ? 2 : 1;
  }
  void to_unit(std::size_t unit) {
    while (unit_ < unit && !is_at_end()) step();
    if (unit_ != unit) throw std::invalid_argument("a splice lies outside the text or within a character");
  }
  void to_byte(std::size_t byte) {
    while (byte_ < byte && !is_at_end()) step();
  }

 private:
  std::string_view text_;
  std::size_t byte_ = 0;
  std::size_t unit_ = 0;
};

}  // namespace

// Based on: bryc: cyrb53 (2018, public domain); here with all 64 bits.
std::string text_hash(std::string_view text) {
  std::uint32_t a = 0xdeadbeefU;
  std::uint32_t b = 0x41c6ce57U;
  const auto add = [&](std::uint32_t unit) {
    a = (a ^ unit) * 2654435761U;
    b = (b ^ unit) * 1597334677U;
  };
  for (Walk walk(text); !walk.is_at_end(); walk.step()) {
    const std::uint32_t code = code_point(walk.character());
    if (code < 0x10000U) {
      add(code);
    } else {
      add(0xd800U + ((code - 0x10000U) >> 10U));
      add(0xdc00U + ((code - 0x10000U) & 0x3ffU));
    }
  }
  a = ((a ^ a >> 16U) * 2246822507U) ^ ((b ^ b >> 13U) * 3266489909U);
  b = ((b ^ b >> 16U) * 2246822507U) ^ ((a ^ a >> 13U) * 3266489909U);
  return fmt::format("{:08x}{:08x}", b, a);
}

std::size_t unit_count(std::string_view text) {
  Walk walk(text);
  walk.to_byte(text.size());
  return walk.unit();
}

std::vector<std::size_t> units_of(std::string_view text, const std::vector<LineColumn>& places) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  constexpr std::string_view kMark = "\xef\xbb\xbf";  // a byte order mark belongs to no column
  Walk walk(text);
  if (text.substr(0, kMark.size()) == kMark) walk.step();
  std::vector<std::size_t> units(places.size());
  LineColumn at{1, 1};
  for (const std::size_t k : order) {
    const LineColumn wanted = places[k];
    while (at.line < wanted.line && !walk.is_at_end()) {
      const bool ends_line = walk.character() == "\n";
      walk.step();
      at = ends_line ? LineColumn{at.line + 1, 1} : LineColumn{at.line, at.column + 1};
    }
    while (at.line == wanted.line && at.column < wanted.column && !walk.is_at_end() && walk.character() != "\n") {
      walk.step();
      ++at.column;
    }
    units[k] = walk.unit();
  }
  return units;
}

TextPatch in_bytes(std::string_view text, const std::vector<UnitSplice>& splices) {
  TextPatch patch;
  Walk walk(text);
  for (const UnitSplice& splice : splices) {
    if (splice.offset < walk.unit()) throw std::invalid_argument("splices overlap or are not in order");
    walk.to_unit(splice.offset);
    const std::size_t begin = walk.byte();
    if (splice.length > text.size()) throw std::invalid_argument("a splice lies outside the text");
    walk.to_unit(splice.offset + splice.length);
    patch.push_back({begin, walk.byte() - begin, splice.replacement});
  }
  if (!is_sound(patch, text.size())) throw std::invalid_argument("splices overlap or are not in order");
  return patch;
}

std::vector<UnitSplice> in_units(std::string_view text, const TextPatch& patch) {
  std::vector<UnitSplice> splices;
  Walk walk(text);
  for (const TextSplice& splice : patch) {
    walk.to_byte(splice.offset);
    const std::size_t begin = walk.unit();
    walk.to_byte(splice.offset + splice.length);
    splices.push_back({begin, walk.unit() - begin, splice.replacement});
  }
  return splices;
}

}  // namespace meristem::studio

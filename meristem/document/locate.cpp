// SPDX-License-Identifier: Apache-2.0
// A scanner that knows just enough JSON (with comments) to say where the value at a document path begins. The parser
// proper gives no positions; scanning again costs nothing where there are no faults.
#include "meristem/document/locate.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

namespace meristem {

namespace {

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

struct Found {
  std::optional<std::size_t> name;   // offset of the member's name
  std::optional<std::size_t> value;  // offset of the value
};

class Scanner {
 public:
  Scanner(std::string_view text, std::unordered_map<std::string, Found>& wanted) : text_(text), wanted_(wanted) {}

  void run() {
    skip_blanks();
    begin_value(at_);
    while (at_ < text_.size() && !open_.empty()) {
      skip_blanks();
      if (at_ >= text_.size()) return;
      step();
    }
  }

 private:
  struct Container {
    bool is_object = false;
    std::size_t path_length = 0;  // of its own path
    std::size_t index = 0;        // of the next element
    bool awaits_value = false;    // after an object's colon, or anywhere in a list
  };

  /// One token inside a container.
  void step() {
    Container& top = open_.back();
    const char c = text_[at_];
    if (c == ',' || c == ':') {
      ++at_;
    } else if (c == '}' || c == ']') {
      path_.resize(top.path_length);
      open_.pop_back();
      ++at_;
    } else if (top.is_object && !top.awaits_value) {
      const std::size_t begin = at_;
      const std::string name = read_string();
      path_.resize(top.path_length);
      if (!path_.empty()) path_ += '.';
      path_ += name;
      if (const auto found = wanted_.find(path_); found != wanted_.end()) found->second.name = begin;
      top.awaits_value = true;
    } else {
      if (top.is_object) {
        top.awaits_value = false;
      } else {
        path_.resize(top.path_length);
        path_ += fmt::format("[{}]", top.index++);
      }
      begin_value(at_);
    }
  }

  void begin_value(std::size_t offset) {
    if (offset >= text_.size()) return;
    if (const auto found = wanted_.find(path_); found != wanted_.end()) found->second.value = offset;
    const char c = text_[offset];
    if (c == '{' || c == '[') {
      open_.push_back({.is_object = c == '{', .path_length = path_.size()});
      ++at_;
    } else if (c == '"') {
      read_string();
    } else {
      while (at_ < text_.size() && std::string_view(",:]}[{\" \t\r\n/").find(text_[at_]) == std::string_view::npos)
        ++at_;
      if (at_ == offset) ++at_;
    }
  }

  /// Reads the text at the present quote; anything else is passed over byte by byte.
  std::string read_string() {
    std::string read;
    if (text_[at_++] != '"') return read;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_] == '\\') ++at_;
      if (at_ < text_.size()) read += text_[at_++];
    }
    ++at_;
    return read;
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (std::string_view(" \t\r\n\xEF\xBB\xBF").find(rest[0]) != std::string_view::npos) {
        ++at_;
      } else if (rest.starts_with("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (rest.starts_with("/*")) {
        const std::size_t end = text_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::unordered_map<std::string, Found>& wanted_;
  std::size_t at_ = 0;
  std::string path_;
  std::vector<Container> open_;
};

/// The path without its last element, "a.b[2]" -> "a.b" -> "a".
std::string parent_path(const std::string& path) {
  const std::size_t cut = path.find_last_of(".[");
  return cut == std::string::npos ? std::string() : path.substr(0, cut);
}

/// The byte of the document at which byte `offset` of the text value at `begin` stands, escapes counted.
std::size_t offset_in_text(std::string_view text, std::size_t begin, int offset) {
  std::size_t at = begin + 1;
  for (int k = 0; k < offset && at < text.size() && text[at] != '"'; ++k) {
    if (text[at] == '\\') at += at + 1 < text.size() && text[at + 1] == 'u' ? 5 : 1;
    ++at;
  }
  return at;
}

}  // namespace

TextPosition text_position(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  TextPosition position;
  position.line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_begin = before.find_last_of('\n') + 1;
  for (const char byte : before.substr(line_begin)) {
    if (!continues_character(byte)) ++position.column;
  }
  return position;
}

void locate_diagnostics(std::string_view text, std::span<Diagnostic> diagnostics) {
  // Every path is wanted, and its ancestors in case it is not in the text.
  std::unordered_map<std::string, Found> wanted;
  for (const Diagnostic& diagnostic : diagnostics) {
    std::string path = diagnostic.path;
    while (wanted.try_emplace(path).second && !path.empty()) path = parent_path(path);
  }
  Scanner(text, wanted).run();

  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.line != 0) continue;
    std::string path = diagnostic.path;
    const bool at_name = diagnostic.text_offset == kAtName && wanted[path].name.has_value();
    while (!wanted[path].value && !path.empty()) path = parent_path(path);
    const Found& found = wanted[path];
    if (!found.value && !at_name) continue;
    std::size_t offset = at_name ? *wanted[diagnostic.path].name : *found.value;
    if (diagnostic.text_offset >= 0 && path == diagnostic.path && text[offset] == '"') {
      offset = offset_in_text(text, offset, diagnostic.text_offset);
    }
    const TextPosition position = text_position(text, offset);
    diagnostic.line = position.line;
    diagnostic.column = position.column;
  }
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// A scanner that reads just enough JSON (with comments) to find where the value at a document path begins. The parser
// itself gives no positions. The text is scanned again only if there are faults.
#include "meristem/document/locate.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "meristem/document/json.h"

namespace meristem {

namespace {

constexpr std::size_t kTokensBetweenChecks = 4096;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Returns the value of four hexadecimal digits at `at`, or 0 if there are no such digits.
unsigned hexadecimal(std::string_view text, std::size_t at) {
  unsigned value = 0;
  if (at + 4 <= text.size()) std::from_chars(text.data() + at, text.data() + at + 4, value, 16);
  return value;
}

void append_utf8(unsigned character, std::string& out) {
  const auto put = [&out](unsigned byte) { out += static_cast<char>(byte); };
  if (character < 0x80) return put(character);
  if (character < 0x800) {
    put(0xC0U | character >> 6U);
  } else {
    if (character < 0x10000) {
      put(0xE0U | character >> 12U);
    } else {
      put(0xF0U | character >> 18U);
      put(0x80U | (character >> 12U & 0x3FU));
    }
    put(0x80U | (character >> 6U & 0x3FU));
  }
  put(0x80U | (character & 0x3FU));
}

/// Appends the character of the byte or escape at `at` of a JSON text. Returns the position of the next one.
std::size_t decode(std::string_view text, std::size_t at, std::string& out) {
  if (text[at] != '\\' || at + 1 == text.size()) {
    out += text[at];
    return at + 1;
  }
  const char kind = text[at + 1];
  if (kind != 'u') {
    constexpr std::string_view kLetters = "bfnrt";
    constexpr std::string_view kMeant = "\b\f\n\r\t";
    const std::size_t letter = kLetters.find(kind);
    out += letter == std::string_view::npos ? kind : kMeant[letter];
    return at + 2;
  }
  unsigned character = hexadecimal(text, at + 2);
  std::size_t end = std::min(at + 6, text.size());
  const bool is_high = 0xD800 <= character && character < 0xDC00;
  if (is_high && text.substr(end).starts_with("\\u")) {
    character = 0x10000 + ((character - 0xD800) << 10U) + (hexadecimal(text, end + 2) - 0xDC00);
    end = std::min(end + 6, text.size());
  }
  append_utf8(character, out);
  return end;
}

struct Found {
  std::optional<std::size_t> name;   // offset of the member's name
  std::optional<std::size_t> value;  // offset of the value
};

class Scanner {
 public:
  Scanner(std::string_view text, std::unordered_map<std::string, Found>& wanted, const Progress* progress)
      : text_(text), wanted_(wanted), progress_(progress) {
    for (const auto& [path, found] : wanted) longest_ = std::max(longest_, path.size());
  }

  void run() {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
    skip_blanks();
    begin_value(at_);
    for (std::size_t token = 0; at_ < text_.size() && !open_.empty(); ++token) {
      if (progress_ != nullptr && token % kTokensBetweenChecks == 0) progress_->check();
      skip_blanks();
      if (at_ >= text_.size()) return;
      step();
    }
  }

 private:
  struct Container {
    bool is_object = false;
    std::size_t path_length = 0;  // length of the container's own path
    std::size_t index = 0;        // index of the next element
    bool awaits_value = false;    // true after an object's colon, and anywhere in a list
  };

  /// Reads one token inside a container.
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
      if (Found* found = find()) found->name = begin;
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

  /// Returns the entry of the present path if it is wanted, else null. Longer paths are not even hashed: in a text of
  /// only brackets that would take quadratic time.
  Found* find() {
    if (path_.size() > longest_) return nullptr;
    const auto found = wanted_.find(path_);
    return found == wanted_.end() ? nullptr : &found->second;
  }

  void begin_value(std::size_t offset) {
    if (offset >= text_.size()) return;
    if (Found* found = find()) found->value = offset;
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

  /// Reads the text at the present quote. Steps over any other byte.
  std::string read_string() {
    std::string read;
    if (text_[at_++] != '"') return read;
    while (at_ < text_.size() && text_[at_] != '"') at_ = decode(text_, at_, read);
    at_ = std::min(at_ + 1, text_.size());
    return read;
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (std::string_view(" \t\r\n").find(rest[0]) != std::string_view::npos) {
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
  const Progress* progress_;
  std::size_t longest_ = 0;
  std::size_t at_ = 0;
  std::string path_;
  std::vector<Container> open_;
};

/// Returns the path without its last element: "a.b[2]" gives "a.b", which gives "a".
std::string parent_path(const std::string& path) {
  const std::size_t cut = path.find_last_of(".[");
  return cut == std::string::npos ? std::string() : path.substr(0, cut);
}

/// Returns the byte of the document at which byte `offset` of the text value at `begin` stands. Escapes are counted.
std::size_t offset_in_text(std::string_view text, std::size_t begin, int offset) {
  std::size_t at = begin + 1;
  std::string read;
  while (at < text.size() && text[at] != '"') {
    const std::size_t next = decode(text, at, read);
    if (read.size() > static_cast<std::size_t>(offset)) break;
    at = next;
  }
  return at;
}

/// Computes line and column of rising offsets in one pass over the text.
class PositionCounter {
 public:
  explicit PositionCounter(std::string_view text) : text_(text) {
    if (text.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  TextPosition at(std::size_t offset) {
    for (const std::size_t end = std::min(offset, text_.size()); at_ < end; ++at_) {
      if (text_[at_] == '\n') {
        ++position_.line;
        position_.column = 1;
      } else if (at_ + 1 >= text_.size() || !continues_character(text_[at_ + 1])) {
        ++position_.column;
      }
    }
    return position_;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  TextPosition position_;
};

/// Returns the byte of a diagnostic's fault. Returns nothing if neither its path nor the beginning of its path is in
/// the text.
std::optional<std::size_t> offset_of(const Diagnostic& diagnostic, std::string_view text,
                                     const std::unordered_map<std::string, Found>& wanted) {
  std::string path = diagnostic.path;
  if (diagnostic.text_offset == kAtName && wanted.at(path).name) return wanted.at(path).name;
  while (!wanted.at(path).value && !path.empty()) path = parent_path(path);
  const std::optional<std::size_t> value = wanted.at(path).value;
  if (value && diagnostic.text_offset >= 0 && path == diagnostic.path && text[*value] == '"') {
    return offset_in_text(text, *value, diagnostic.text_offset);
  }
  return value;
}

}  // namespace

std::vector<std::size_t> places_of_bytes(std::string_view text, std::size_t begin) {
  std::vector<std::size_t> places;
  std::string read;
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != '"') {
    const std::size_t next = decode(text, at, read);
    places.resize(read.size(), at);
    at = next;
  }
  places.push_back(at);
  return places;
}

TextPosition text_position(std::string_view text, std::size_t offset) { return PositionCounter(text).at(offset); }

void locate_diagnostics(std::string_view text, std::span<Diagnostic> diagnostics, const Progress* progress) {
  // Every path is wanted. Its ancestors are wanted too, in case it is not in the text.
  std::unordered_map<std::string, Found> wanted;
  for (const Diagnostic& diagnostic : diagnostics) {
    std::string path = diagnostic.path;
    while (wanted.try_emplace(path).second && !path.empty()) path = parent_path(path);
  }
  Scanner(text, wanted, progress).run();

  // Lines are counted in one pass from the first fault to the last.
  std::vector<std::pair<std::size_t, Diagnostic*>> found;
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.line != 0) continue;
    if (const auto offset = offset_of(diagnostic, text, wanted)) found.emplace_back(*offset, &diagnostic);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  PositionCounter counter(text);
  for (const auto& [offset, diagnostic] : found) {
    if (progress != nullptr) progress->check();
    const TextPosition position = counter.at(offset);
    diagnostic->line = position.line;
    diagnostic->column = position.column;
  }
}

Value parse_json_of(const std::string& text, const std::string& file) {
  try {
    return parse_json(text);
  } catch (const InputError& error) {
    std::vector<Diagnostic> errors = error.diagnostics();
    for (Diagnostic& diagnostic : errors) diagnostic.file = file;
    throw InputError(std::move(errors));
  }
}

}  // namespace meristem

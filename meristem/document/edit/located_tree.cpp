// SPDX-License-Identifier: Apache-2.0
// Parses a JSON text and scans it a second time for the positions of its values. The scanner knows that the text is
// valid, so it only follows brackets, quotes and commas, without recursion.
#include "meristem/document/edit/located_tree.h"

#include <algorithm>

#include "meristem/document/json.h"
#include "meristem/document/locate.h"

namespace meristem {

namespace {

constexpr std::size_t kLocatedTokensBetweenChecks = 4096;

/// Finds the positions of the values of a valid JSON text, without recursion.
class NodeScanner {
 public:
  NodeScanner(std::string_view text, const Progress* progress) : text_(text), progress_(progress) {}

  std::vector<TextNode> run() {
    at_ = text_.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    skip();
    begin_value();
    for (std::size_t token = 0; !open_.empty() && at_ < text_.size(); ++token) {
      if (progress_ != nullptr && token % kLocatedTokensBetweenChecks == 0) progress_->check();
      skip();
      step();
    }
    return std::move(nodes_);
  }

 private:
  void skip() { at_ = skip_blanks_and_comments(text_, at_); }

  /// Reads one token within a container.
  void step() {
    TextNode& container = nodes_[open_.back()];
    const char c = text_[at_];
    if (c == '}' || c == ']') {
      container.end = ++at_;
      open_.pop_back();
    } else if (c == ',') {
      nodes_[container.parts.back()].comma = at_++;
    } else if (text_[container.begin] == '{') {
      const std::size_t name_begin = at_;
      skip_string();
      const std::size_t name_end = at_;
      skip();
      ++at_;  // skips the colon
      skip();
      begin_value();
      nodes_[last_begun_].name_begin = name_begin;
      nodes_[last_begun_].name_end = name_end;
    } else {
      begin_value();
    }
  }

  void begin_value() {
    last_begun_ = static_cast<std::uint32_t>(nodes_.size());
    if (!open_.empty()) nodes_[open_.back()].parts.push_back(last_begun_);
    nodes_.emplace_back().begin = at_;
    const char c = text_[at_];
    if (c == '{' || c == '[') {
      open_.push_back(last_begun_);
      ++at_;
      return;
    }
    if (c == '"') {
      skip_string();
    } else {
      at_ = std::min(text_.find_first_of(",:]} \t\r\n/", at_), text_.size());
    }
    nodes_.back().end = at_;
  }

  void skip_string() {
    for (++at_; text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
  }

  std::string_view text_;
  const Progress* progress_;
  std::size_t at_ = 0;
  std::vector<TextNode> nodes_;
  std::vector<std::uint32_t> open_;
  std::uint32_t last_begun_ = 0;
};

}  // namespace

LocatedTree::LocatedTree(std::string text, const Progress* progress)
    : text_(std::move(text)), value_(parse_json(text_, {}, progress)), nodes_(NodeScanner(text_, progress).run()) {}

LocatedValue LocatedTree::part(LocatedValue container, std::size_t index) const {
  const std::uint32_t node = nodes_[container.node].parts[index];
  if (const Value::List* list = container.value->list()) return {&(*list)[index], node};
  return {&(*container.value->object())[index].second, node};
}

std::size_t part_count(const Value& value) {
  if (const Value::List* list = value.list()) return list->size();
  return value.object() != nullptr ? value.object()->size() : 0;
}

std::size_t skip_blanks_and_comments(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    const std::string_view rest = text.substr(at);
    if (std::string_view(" \t\r\n").find(rest[0]) != std::string_view::npos) {
      ++at;
    } else if (rest.starts_with("//")) {
      at = std::min(text.find_first_of("\r\n", at), text.size());
    } else if (rest.starts_with("/*")) {
      const std::size_t end = text.find("*/", at + 2);
      at = end == std::string_view::npos ? text.size() : end + 2;
    } else {
      break;
    }
  }
  return at;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Reads paths and follows them in a tree. Names may contain dots and brackets, so at each step the longest existing
// name is tried first; names in quotes are unambiguous.
#include "meristem/document/edit/path.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

[[noreturn]] void throw_malformed(std::string_view path) {
  throw InputError(Diagnostic{.message = fmt::format("'{}' is not a path", path),
                              .expected = "one such as components.stem.length or links[1].density",
                              .path = std::string(path)});
}

/// Returns true if a step may end here.
bool ends_step(std::string_view rest) { return rest.empty() || rest[0] == '.' || rest[0] == '['; }

/// Reads the steps of a path one by one. Names with dots are recognised by the existing members.
class PathReader {
 public:
  explicit PathReader(std::string_view path) : path_(path), rest_(path) {
    if (path.empty()) throw_malformed(path);
  }

  bool is_done() const { return rest_.empty(); }

  /// Returns the next step. `at` is the value at the end of the previous steps; its value may be null.
  PathStep next(const LocatedTree& tree, LocatedValue at) {
    const bool is_first = rest_.size() == path_.size();
    if (rest_[0] == '[') return bracket();
    if (!is_first) {
      if (rest_[0] != '.') throw_malformed(path_);
      rest_.remove_prefix(1);
    }
    std::size_t length = longest_member(tree, at);
    if (length == 0) length = std::min(rest_.find_first_of(".["), rest_.size());
    if (length == 0) throw_malformed(path_);
    PathStep step{.name = std::string(rest_.substr(0, length))};
    rest_.remove_prefix(length);
    return step;
  }

 private:
  /// Returns the length of the longest name of a member with which the rest begins, or 0.
  std::size_t longest_member(const LocatedTree& tree, LocatedValue at) const {
    if (at.value == nullptr || at.value->object() == nullptr) return 0;
    for (std::size_t length = rest_.size(); length > 0; --length) {
      if (!ends_step(rest_.substr(length))) continue;
      if (tree.index_of(at, rest_.substr(0, length)) != TextNode::kNone) return length;
    }
    return 0;
  }

  PathStep bracket() {
    PathStep step;
    if (rest_.starts_with("[]")) {
      step = {.index = PathStep::kBehindLast, .is_index = true};
      rest_.remove_prefix(2);
    } else if (rest_.starts_with("[\"")) {
      step.name = quoted();
    } else {
      const char* const begin = rest_.data() + 1;
      const char* const end = rest_.data() + rest_.size();
      const auto read = std::from_chars(begin, end, step.index);
      if (read.ec != std::errc() || read.ptr == end || *read.ptr != ']') throw_malformed(path_);
      step.is_index = true;
      rest_.remove_prefix(static_cast<std::size_t>(read.ptr + 1 - rest_.data()));
    }
    if (!ends_step(rest_)) throw_malformed(path_);
    return step;
  }

  std::string quoted() {
    std::size_t end = 2;
    while (end < rest_.size() && rest_[end] != '"') end += rest_[end] == '\\' ? 2 : 1;
    if (end + 1 >= rest_.size() || rest_[end + 1] != ']') throw_malformed(path_);
    std::string name;
    try {
      name = *parse_json(rest_.substr(1, end)).text();
    } catch (const InputError&) {
      throw_malformed(path_);
    }
    rest_.remove_prefix(end + 2);
    return name;
  }

  std::string_view path_;
  std::string_view rest_;
};

/// Returns the index of the part at a step.
std::size_t find_part(const LocatedTree& tree, LocatedValue at, const PathStep& step) {
  if (!step.is_index) return tree.index_of(at, step.name);
  const Value::List* const list = at.value->list();
  return list != nullptr && step.index < list->size() ? step.index : TextNode::kNone;
}

}  // namespace

PathTarget follow_path(const LocatedTree& tree, std::string_view path) {
  PathTarget target;
  target.way.push_back(tree.root());
  PathReader reader(path);
  while (!reader.is_done()) {
    const bool is_there = target.missing.empty();
    PathStep step = reader.next(tree, is_there ? target.last() : LocatedValue());
    const std::size_t place = is_there ? find_part(tree, target.last(), step) : TextNode::kNone;
    if (place == TextNode::kNone) {
      target.missing.push_back(std::move(step));
    } else {
      target.places.push_back(place);
      target.way.push_back(tree.part(target.last(), place));
    }
  }
  return target;
}

PathTarget find_path(const LocatedTree& tree, std::string_view path) {
  PathTarget target = follow_path(tree, path);
  if (!target.missing.empty()) throw_missing(target, path);
  return target;
}

LocatedValue value_at(const LocatedTree& tree, const std::vector<std::size_t>& places) {
  LocatedValue at = tree.root();
  for (const std::size_t place : places) at = tree.part(at, place);
  return at;
}

void throw_missing(const PathTarget& target, std::string_view path) {
  const Value& at = *target.last().value;
  const PathStep& step = target.missing.front();
  Diagnostic error{.path = std::string(path)};
  if (step.is_index) {
    const std::string written =
        step.index == PathStep::kBehindLast ? std::string("[]") : fmt::format("[{}]", step.index);
    error.message = fmt::format("there is no element {} in {}", written, at.description());
    if (at.list() != nullptr && !at.list()->empty()) error.expected = fmt::format("[0] to [{}]", at.list()->size() - 1);
  } else if (at.object() == nullptr) {
    error.message = fmt::format("{} has no member '{}'", at.description(), step.name);
  } else {
    std::vector<std::string> names;
    for (const auto& [name, member] : *at.object()) names.push_back(name);
    error.message = fmt::format("there is no '{}'", step.name);
    error.nearest = nearest_name(step.name, names);
    if (error.nearest.empty() && !names.empty()) error.expected = fmt::format("one of {}", fmt::join(names, ", "));
  }
  throw InputError(std::move(error));
}

std::string path_below(std::string_view path, std::string_view name) {
  const bool is_plain = !name.empty() && name.find_first_of(".[") == std::string_view::npos;
  if (!is_plain) return fmt::format("{}[{}]", path, write_json_line(Value(std::string(name))));
  return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
}

}  // namespace meristem

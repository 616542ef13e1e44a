// SPDX-License-Identifier: Apache-2.0
// Translates edits at paths into patches of the text. Parts of lists and objects are inserted or removed by
// part_edit.h; other values are replaced.
#include "meristem/document/edit/text_edit.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/document/edit/layout.h"
#include "meristem/document/edit/note.h"
#include "meristem/document/edit/part_edit.h"
#include "meristem/document/edit/path.h"
#include "meristem/document/edit/value_difference.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

// Maximum number of insertions and removals that change a list or object; beyond that it is rewritten
constexpr int kMaxSteps = 64;

[[noreturn]] void refuse(std::string_view path, std::string message, std::string expected = {}) {
  throw InputError(
      Diagnostic{.message = std::move(message), .expected = std::move(expected), .path = std::string(path)});
}

/// Throws an InputError for values that JSON cannot represent: infinite numbers, texts that are not UTF-8, repeated
/// names.
void check_value(const Value& value, std::string_view path) {
  if (value.boolean() != nullptr || value.is_null()) return;
  try {
    if (parse_json(write_json_line(value)) == value) return;
  } catch (const InputError& error) {
    refuse(path, fmt::format("the value cannot be written: {}", error.diagnostics()[0].message),
           error.diagnostics()[0].expected);
  }
  refuse(path, "the value has a number that is not finite", "finite numbers");
}

TextSplice written_over(const LocatedTree& tree, LocatedValue old, const Value& value) {
  const TextNode& node = tree.at(old);
  const std::string& text = tree.text();
  return {.offset = node.begin,
          .length = node.end - node.begin,
          .replacement = written_value(value, {indent_at(text, node.begin), indent_unit_of(text), line_end_of(text),
                                               node.begin - line_begin(text, node.begin)})};
}

/// Rewrites all values that differ, if old and new have the same parts.
void write_over_differences(const LocatedTree& tree, LocatedValue old, const Value& value, TextPatch& patch) {
  if (*old.value == value) return;
  if (!have_same_parts(*old.value, value)) {
    patch.push_back(written_over(tree, old, value));
    return;
  }
  for (std::size_t k = 0; k < part_count(value); ++k) {
    const Value& part = value.list() != nullptr ? (*value.list())[k] : (*value.object())[k].second;
    write_over_differences(tree, tree.part(old, k), part, patch);
  }
}

/// Changes the existing value at `path` to `value`: first parts are inserted and removed one by one, then numbers and
/// texts are replaced.
void rewrite(TreeEdit& edit, std::string_view path, const Value& value) {
  for (int step = 0; step < kMaxSteps; ++step) {
    const LocatedTree& present = edit.tree();
    const LocatedValue old = find_path(present, path).last();
    const std::optional<PartDifference> found = first_part_difference(present, old, value);
    if (!found) {
      TextPatch rest;
      write_over_differences(present, old, value, rest);
      edit.take(std::move(rest));
      return;
    }
    edit.take(found->added != nullptr
                  ? insert_part(present, found->container, found->index, {found->name, found->added})
                  : remove_part(present, found->container, found->index).patch);
  }
  edit.take({written_over(edit.tree(), find_path(edit.tree(), path).last(), value)});
}

/// Returns the value for the first missing step so that the last missing step has `value`.
Value with_steps(const PathTarget& target, const Value& value, std::string_view path) {
  Value made = value;
  for (std::size_t k = target.missing.size(); k-- > 1;) {
    if (target.missing[k].is_index) refuse(path, "there is no list to put the element into", "a list that exists");
    Value::Object around;
    around.emplace_back(target.missing[k].name, std::move(made));
    made = Value(std::move(around));
  }
  return made;
}

}  // namespace

TextPatch set_value(const LocatedTree& tree, std::string_view path, const Value& value) {
  TreeEdit edit(tree);
  set_value(edit, path, value);
  return edit.patch();
}

void set_value(TreeEdit& edit, std::string_view path, const Value& value) {
  check_value(value, path);
  const LocatedTree& tree = edit.tree();
  const PathTarget target = follow_path(tree, path);
  if (target.missing.empty()) return rewrite(edit, path, value);
  const PathStep& step = target.missing.front();
  if (step.is_index) throw_missing(target, path);
  const Value made = with_steps(target, value, path);
  const LocatedValue last = target.last();
  if (last.value->is_null()) {
    Value::Object around;
    around.emplace_back(step.name, made);
    return edit.take({written_over(tree, last, Value(std::move(around)))});
  }
  if (last.value->object() == nullptr) throw_missing(target, path);
  edit.take(insert_part(tree, last, part_count(*last.value), {&step.name, &made}));
}

TextPatch insert_value(const LocatedTree& tree, std::string_view path, const Value& value,
                       std::optional<std::size_t> index) {
  check_value(value, path);
  const PathTarget target = follow_path(tree, path);
  const bool is_there = target.missing.empty();
  const LocatedValue container = is_there ? target.container() : target.last();
  const std::size_t count = part_count(*container.value);
  if (container.value->list() != nullptr) {
    std::size_t at = is_there ? target.places.back() : target.missing[0].index;
    if (!is_there && at == PathStep::kBehindLast) at = count;
    const bool is_element = is_there || (target.missing.size() == 1 && target.missing[0].is_index);
    if (!is_element || at > count) throw_missing(target, path);
    return insert_part(tree, container, at, {nullptr, &value});
  }
  if (is_there) refuse(path, fmt::format("'{}' exists already", path), "a name that is free");
  const bool is_first = target.missing.size() == 2 && !target.missing[0].is_index && target.missing[1].is_index &&
                        (target.missing[1].index == 0 || target.missing[1].index == PathStep::kBehindLast);
  if (is_first && container.value->object() != nullptr) {
    const Value list(Value::List{value});
    return insert_part(tree, container, count, {&target.missing[0].name, &list});
  }
  const bool is_member = target.missing.size() == 1 && !target.missing[0].is_index;
  if (container.value->object() == nullptr || !is_member) throw_missing(target, path);
  if (index && *index > count) refuse(path, fmt::format("there are {} members", count), "an index up to that number");
  return insert_part(tree, container, index.value_or(count), {&target.missing[0].name, &value});
}

TextPatch remove_value(const LocatedTree& tree, std::string_view path) {
  const PathTarget target = find_path(tree, path);
  return remove_part(tree, target.container(), target.places.back()).patch;
}

TextPatch rename_member(const LocatedTree& tree, std::string_view path, std::string_view name) {
  const PathTarget target = find_path(tree, path);
  const LocatedValue container = target.container();
  if (container.value->object() == nullptr) refuse(path, "elements of lists have no names", "the path of a member");
  const std::string& old = (*container.value->object())[target.places.back()].first;
  if (old == name) return {};
  Value::Object named;
  named.emplace_back(std::string(name), Value());
  check_value(Value(std::move(named)), path);
  if (tree.index_of(container, name) != TextNode::kNone) {
    refuse(path, fmt::format("there is a '{}' already", name), "a name that is free");
  }
  const TextNode& node = tree.at(target.last());
  return {{.offset = node.name_begin,
           .length = node.name_end - node.name_begin,
           .replacement = write_json_line(Value(std::string(name)))}};
}

namespace {

/// Removes the note above a part together with the part, if the part has lines of its own.
void take_note_along(const LocatedTree& tree, LocatedValue container, std::size_t index, RemovedPart& removed) {
  const std::optional<TextRange> note = note_lines_above(tree, container, index);
  if (!note) return;
  const auto own = std::ranges::find(removed.patch, note->end, &TextSplice::offset);
  if (own == removed.patch.end()) return;
  own->offset = note->begin;
  own->length += note->end - note->begin;
  const std::string_view text = tree.text();
  const std::string_view indent = indent_at(text, note->begin);
  const std::string_view lines = text.substr(note->begin, note->end - note->begin);
  removed.written.text = std::string(lines.substr(indent.size())) + std::string(indent) + removed.written.text;
}

}  // namespace

TextPatch move_value(const LocatedTree& tree, std::string_view path, std::size_t index) {
  TreeEdit edit(tree);
  move_value(edit, path, index);
  return edit.patch();
}

void move_value(TreeEdit& edit, std::string_view path, std::size_t index) {
  const LocatedTree& tree = edit.tree();
  const PathTarget target = find_path(tree, path);
  const LocatedValue container = target.container();
  const std::size_t count = part_count(*container.value);
  if (index >= count) {
    refuse(path, fmt::format("there is no element {} among {}", index, count), fmt::format("0 to {}", count - 1));
  }
  if (index == target.places.back()) return;
  RemovedPart removed = remove_part(tree, container, target.places.back());
  take_note_along(tree, container, target.places.back(), removed);
  edit.take(std::move(removed.patch));
  const std::vector<std::size_t> above(target.places.begin(), target.places.end() - 1);
  const LocatedTree& without = edit.tree();
  edit.take(insert_part(without, value_at(without, above), index, {.written = &removed.written}));
}

}  // namespace meristem

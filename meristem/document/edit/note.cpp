// SPDX-License-Identifier: Apache-2.0
// Finds, reads and writes notes. A comment belongs to a member if it is on the lines directly above or at the end of
// the member's last line. Each line of a new note becomes a comment with //.
#include "meristem/document/edit/note.h"

#include <algorithm>
#include <optional>

#include "meristem/document/edit/layout.h"
#include "meristem/document/edit/path.h"

namespace meristem {

namespace {

constexpr std::string_view kBlankSigns = " \t\r\n";

/// The position of a note in the text.
struct NotePlace {
  std::vector<Comment> comments;
  bool is_above = false;  ///< true: on lines of its own; false: after the member
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlankSigns);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlankSigns) - begin + 1);
}

/// Returns true if exactly one line ends between both positions.
bool are_neighbouring_lines(std::string_view text, std::size_t begin, std::size_t end) {
  const std::string_view between = text.substr(begin, end - begin);
  return trimmed(between).empty() && std::count(between.begin(), between.end(), '\n') == 1;
}

std::optional<NotePlace> find_note(const LocatedTree& tree, LocatedValue container, std::size_t index) {
  const std::string_view text = tree.text();
  const TextNode& around = tree.at(container);
  const TextNode& part = tree.at(tree.part(container, index));
  // Text after the previous part in its line belongs to that part.
  const std::size_t before = index > 0 ? tree.at(tree.part(container, index - 1)).comma + 1 : around.begin + 1;
  NotePlace above{.comments = {}, .is_above = true};
  std::size_t below = part.first();
  std::vector<Comment> comments = comments_between(text, behind_comments(text, before), part.first());
  for (; !comments.empty(); comments.pop_back()) {
    const Comment& comment = comments.back();
    if (!begins_line(text, comment.begin) || !are_neighbouring_lines(text, comment.end, below)) break;
    below = comment.begin;
    above.comments.push_back(comment);
  }
  std::reverse(above.comments.begin(), above.comments.end());
  if (!above.comments.empty()) return above;
  const std::size_t end = part.comma == TextNode::kNone ? part.end : part.comma + 1;
  const std::size_t behind = behind_comments(text, end);
  if (behind == end || !ends_line(text, behind)) return std::nullopt;
  return NotePlace{.comments = comments_between(text, end, behind), .is_above = false};
}

std::string_view without_star(std::string_view line) {
  if (line.starts_with("* ")) return line.substr(2);
  return line == "*" ? std::string_view() : line;
}

/// Returns the content of a comment, line by line.
std::string said_by(std::string_view comment) {
  if (comment.starts_with("//")) return std::string(trimmed(comment.substr(2)));
  std::string_view rest = trimmed(comment.substr(2, comment.size() - std::min<std::size_t>(comment.size(), 4)));
  std::string said;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (!said.empty()) said += '\n';
    said += without_star(trimmed(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return said;
}

std::string text_of(const LocatedTree& tree, const NotePlace& place) {
  std::string note;
  for (const Comment& comment : place.comments) {
    if (!note.empty()) note += '\n';
    note += said_by(std::string_view(tree.text()).substr(comment.begin, comment.end - comment.begin));
  }
  return note;
}

/// Returns a comment per line; each one except the first is on a line that begins with `indent`.
std::string as_comments(std::string_view note, std::string_view indent, std::string_view line_end) {
  std::string made;
  while (!note.empty()) {
    const std::size_t end = std::min(note.find('\n'), note.size());
    if (!made.empty()) made += std::string(line_end) + std::string(indent);
    const std::string_view line = note.substr(0, end);
    const std::string_view plain = line.substr(0, std::min(line.find_last_not_of(kBlankSigns) + 1, line.size()));
    made += plain.empty() ? "//" : "// " + std::string(plain);
    note.remove_prefix(std::min(end + 1, note.size()));
  }
  return made;
}

/// Removes a note with its lines, or with the spaces before it.
TextPatch without_note(std::string_view text, const NotePlace& place, std::size_t member) {
  std::size_t begin = place.comments.front().begin;
  if (place.is_above) {
    begin = line_begin(text, begin);
    return {{begin, line_begin(text, member) - begin, ""}};
  }
  while (text[begin - 1] == ' ' || text[begin - 1] == '\t') --begin;
  return {{begin, place.comments.back().end - begin, ""}};
}

/// Adds a note above the member that begins at byte `member`. A member that shares its line with others gets a line of
/// its own.
TextPatch with_note_above(std::string_view text, std::size_t container, std::size_t member, std::string_view note) {
  const std::string end(line_end_of(text));
  if (begins_line(text, member)) {
    const std::string indent(indent_at(text, member));
    return {{line_begin(text, member), 0, indent + as_comments(note, indent, end) + end}};
  }
  std::size_t begin = member;
  while (text[begin - 1] == ' ' || text[begin - 1] == '\t') --begin;
  std::string indent(indent_at(text, member));
  if (line_begin(text, member) <= container) indent += indent_unit_of(text);
  return {{begin, member - begin, end + indent + as_comments(note, indent, end) + end + indent}};
}

}  // namespace

std::optional<TextRange> note_lines_above(const LocatedTree& tree, LocatedValue container, std::size_t index) {
  const std::optional<NotePlace> note = find_note(tree, container, index);
  if (!note || !note->is_above) return std::nullopt;
  const std::size_t first = tree.at(tree.part(container, index)).first();
  return TextRange{line_begin(tree.text(), note->comments.front().begin), line_begin(tree.text(), first)};
}

std::string note_on(const LocatedTree& tree, LocatedValue container, std::size_t index) {
  const std::optional<NotePlace> place = find_note(tree, container, index);
  return place ? text_of(tree, *place) : std::string();
}

std::vector<std::pair<std::string, std::string>> notes_on_members(const LocatedTree& tree, std::string_view object,
                                                                  const Progress* progress) {
  std::vector<std::pair<std::string, std::string>> notes;
  const Value* members = tree.root().value->find(object);
  if (members == nullptr || members->object() == nullptr) return notes;
  const LocatedValue container = follow_path(tree, object).last();
  for (std::size_t k = 0; k < part_count(*members); ++k) {
    if (progress != nullptr) progress->check();
    std::string note = note_on(tree, container, k);
    if (!note.empty()) notes.emplace_back((*members->object())[k].first, std::move(note));
  }
  return notes;
}

TextPatch set_note(const LocatedTree& tree, std::string_view path, std::string_view note) {
  const PathTarget target = find_path(tree, path);
  const std::string_view text = tree.text();
  const std::size_t member = tree.at(target.last()).first();
  const std::size_t container = tree.at(target.container()).begin;
  const std::string_view said = trimmed(note);
  const std::optional<NotePlace> place = find_note(tree, target.container(), target.places.back());
  if (!place) return said.empty() ? TextPatch() : with_note_above(text, container, member, said);
  if (said == text_of(tree, *place)) return {};
  if (said.empty()) return without_note(text, *place, member);
  const std::size_t begin = place->comments.front().begin;
  const std::size_t length = place->comments.back().end - begin;
  if (place->is_above) return {{begin, length, as_comments(said, indent_at(text, begin), line_end_of(text))}};
  if (said.find('\n') == std::string_view::npos) return {{begin, length, as_comments(said, "", "")}};
  // A note with several lines stands above the member.
  const TextPatch without = without_note(text, *place, member);
  return joined_patches(without, with_note_above(apply_patch(text, without), container, member, said));
}

}  // namespace meristem

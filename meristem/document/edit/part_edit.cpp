// SPDX-License-Identifier: Apache-2.0
// Inserts and removes parts of a list or object as text. The layout of the neighbours decides where a new part stands:
// in their line or on its own. Removal also takes the separating comma and the comments that belong to the part.
#include "meristem/document/edit/part_edit.h"

#include <algorithm>
#include <string_view>

#include "meristem/document/edit/layout.h"
#include "meristem/document/json.h"

namespace meristem {

namespace {

/// A list or object with its text.
class Container {
 public:
  Container(const LocatedTree& tree, LocatedValue container)
      : text_(tree.text()), tree_(tree), container_(container), node_(tree.at(container)), count_(node_.parts.size()) {}

  RemovedPart remove(std::size_t index) const {
    const TextNode& part = this->part(index);
    const bool is_last = index + 1 == count_;
    const std::size_t behind = is_last ? part.end : part.comma + 1;
    std::size_t cut_end = behind_comments(text_, behind);
    std::size_t next_line = 0;
    const bool owns_lines = begins_line(text_, part.first()) && ends_line(text_, cut_end, &next_line);
    std::size_t cut_begin = part.first();
    if (owns_lines) {
      cut_begin = line_begin(text_, part.first());
    } else if (!is_last) {
      cut_end = behind;
    }
    RemovedPart removed{.patch = {}, .written = written(part, cut_end)};
    if (count_ == 1 && is_bare(part.first(), cut_end)) {
      removed.patch.push_back({node_.begin + 1, node_.end - node_.begin - 2, ""});
      return removed;
    }
    if (owns_lines) {
      if (is_last && count_ > 1) removed.patch.push_back({this->part(index - 1).comma, 1, ""});
      removed.patch.push_back({cut_begin, next_line - cut_begin, ""});
    } else if (is_last) {
      cut_last(index, cut_end, removed.patch);
    } else {
      cut_with_blanks(part.first(), cut_end, removed.patch);
    }
    return removed;
  }

  TextPatch insert(std::size_t index, const NewPart& part) const {
    if (count_ == 0) return insert_alone(part);
    return index == count_ ? append(part) : insert_before(index, part);
  }

 private:
  const TextNode& part(std::size_t index) const { return tree_.at(tree_.part(container_, index)); }

  /// Returns true if the container has only spaces outside of the range from `begin` to `end`.
  bool is_bare(std::size_t begin, std::size_t end) const {
    const std::string_view before = text_.substr(node_.begin + 1, begin - node_.begin - 1);
    const std::string_view after = text_.substr(end, node_.end - 1 - end);
    constexpr std::string_view kBlanks = " \t\r\n";
    return before.find_first_not_of(kBlanks) == std::string_view::npos &&
           after.find_first_not_of(kBlanks) == std::string_view::npos;
  }

  /// Returns the part as written, with the comments after it up to `end`.
  WrittenPart written(const TextNode& part, std::size_t end) const {
    WrittenPart made;
    made.text = text_.substr(part.first(), part.end - part.first());
    const std::size_t comma = part.comma == TextNode::kNone ? end : part.comma;
    for (const auto& [begin, stop] :
         {std::pair(part.end, std::min(comma, end)), std::pair(std::min(comma, end), end)}) {
      for (const Comment& comment : comments_between(text_, begin, stop)) {
        if (made.ends_in_line_comment) made.comments += line_end_of(text_);
        made.comments += (made.comments.empty() || made.ends_in_line_comment ? "" : " ");
        made.comments += text_.substr(comment.begin, comment.end - comment.begin);
        made.ends_in_line_comment = comment.to_line_end;
      }
    }
    return made;
  }

  /// Removes the last part and the comma before it, if it shares its lines with others.
  void cut_last(std::size_t index, std::size_t cut_end, TextPatch& patch) const {
    const std::size_t first = part(index).first();
    const std::size_t separator = index > 0 ? part(index - 1).comma : node_.begin;
    const std::vector<Comment> comments = comments_between(text_, separator + 1, first);
    if (index == 0) {
      patch.push_back({first, cut_end - first, ""});
    } else if (comments.empty()) {
      patch.push_back({separator, cut_end - separator, ""});
    } else {
      // A comment with // ends at the end of its line, which must stay.
      const std::size_t begin = comments.back().to_line_end ? first : comments.back().end;
      patch.push_back({separator, 1, ""});
      patch.push_back({begin, cut_end - begin, ""});
    }
  }

  /// Removes a range with the spaces up to the next part in the line, or the spaces before it at the end of a line.
  void cut_with_blanks(std::size_t begin, std::size_t end, TextPatch& patch) const {
    const auto is_blank = [&](std::size_t at) { return text_[at] == ' ' || text_[at] == '\t'; };
    if (ends_line(text_, end)) {
      while (is_blank(begin - 1)) --begin;
    } else {
      while (is_blank(end)) ++end;
    }
    patch.push_back({begin, end - begin, ""});
  }

  std::string new_line(std::string_view indent) const { return std::string(line_end_of(text_)) + std::string(indent); }

  /// Returns the part for a line that begins with `indent`, from a column of that line, followed by `comma`. If a
  /// comment that ends with its line follows, the next text must start on another line.
  std::string written(const NewPart& part, std::string_view indent, std::size_t column, std::string_view comma) const {
    if (part.written != nullptr) {
      std::string made = part.written->text + std::string(comma);
      if (!part.written->comments.empty()) made += ' ' + part.written->comments;
      return made;
    }
    std::string made;
    if (part.name != nullptr) made = write_json_line(Value(*part.name)) + std::string(colon());
    made += written_value(*part.value, {indent, indent_unit_of(text_), line_end_of(text_), column + made.size() + 1});
    return made + std::string(comma);
  }
  static bool ends_in_line_comment(const NewPart& part) {
    return part.written != nullptr && part.written->ends_in_line_comment;
  }

  /// Returns the text between name and value in this container.
  std::string_view colon() const {
    if (count_ == 0) return ": ";
    const TextNode& neighbour = part(0);
    const std::string_view between = text_.substr(neighbour.name_end, neighbour.begin - neighbour.name_end);
    return between == ":" ? ":" : ": ";
  }

  /// Returns the indentation of the part's line if that begins within the container. Otherwise returns one more level.
  std::string indent_like(const TextNode& part) const {
    if (line_begin(text_, part.first()) > node_.begin) return std::string(indent_at(text_, part.first()));
    return deeper();
  }
  std::string deeper() const { return std::string(indent_at(text_, node_.begin)) + std::string(indent_unit_of(text_)); }

  /// Inserts a part into an empty container. Components and other objects of the upper levels get lines of their own.
  TextPatch insert_alone(const NewPart& part) const {
    const std::size_t close = node_.end - 1;
    const bool has_comments = !is_bare(close, close);
    const bool is_upper = container_.node == 0 || indent_at(text_, node_.begin).size() <= indent_unit_of(text_).size();
    const bool is_object =
        part.written != nullptr ? part.written->text.ends_with('}') : part.value->object() != nullptr;
    const bool in_lines = container_.node == 0 || (is_upper && is_object) || ends_in_line_comment(part);
    const std::size_t column = node_.begin + 1 - line_begin(text_, node_.begin);
    if (!has_comments) {
      const std::string made = in_lines ? new_line(deeper()) + written(part, deeper(), deeper().size(), "") +
                                              new_line(indent_at(text_, node_.begin))
                                        : written(part, indent_at(text_, node_.begin), column, "");
      return {{node_.begin + 1, close - node_.begin - 1, made}};
    }
    if (begins_line(text_, close)) {
      const std::size_t begin = line_begin(text_, close);
      return {{begin, 0, deeper() + written(part, deeper(), deeper().size(), "") + std::string(line_end_of(text_))}};
    }
    const std::string_view blank = text_[close - 1] == ' ' ? "" : " ";
    const std::string tail = ends_in_line_comment(part) ? new_line(indent_at(text_, node_.begin)) : "";
    return {{close, 0, std::string(blank) + written(part, indent_at(text_, node_.begin), column, "") + tail}};
  }

  TextPatch append(const NewPart& part) const {
    const TextNode& last = this->part(count_ - 1);
    const std::size_t behind = behind_comments(text_, last.end);
    const std::vector<Comment> comments = comments_between(text_, last.end, behind);
    const bool follows_line_comment = !comments.empty() && comments.back().to_line_end;
    const std::size_t column = behind + 2 - line_begin(text_, behind);
    const std::string indent = indent_like(last);
    const std::string_view own_indent = indent_at(text_, last.end);
    const std::string in_line = written(part, own_indent, column, "");
    const std::size_t line = std::min(in_line.find('\n'), in_line.size());
    const bool is_too_long = column + line > kLongestLine && indent.size() < column;
    const bool in_lines = begins_line(text_, last.first()) || follows_line_comment || is_too_long;
    std::string made = in_lines ? new_line(indent) + written(part, indent, indent.size(), "") : " " + in_line;
    if (ends_in_line_comment(part) && !ends_line(text_, behind)) made += new_line(indent_at(text_, node_.begin));
    if (behind == last.end) return {{behind, 0, "," + made}};
    return {{last.end, 0, ","}, {behind, 0, made}};
  }

  TextPatch insert_before(std::size_t index, const NewPart& part) const {
    const TextNode& next = this->part(index);
    if (begins_line(text_, next.first())) {
      // The part is inserted after the previous line, so that comments above the next part stay with it.
      const std::size_t separator = index > 0 ? this->part(index - 1).comma : node_.begin;
      const std::size_t behind = behind_comments(text_, separator + 1);
      const std::string indent(indent_at(text_, next.first()));
      std::string made = new_line(indent) + written(part, indent, indent.size(), ",");
      if (ends_in_line_comment(part) && !ends_line(text_, behind)) made += line_end_of(text_);
      return {{behind, 0, made}};
    }
    const std::size_t column = next.first() - line_begin(text_, next.first());
    const std::string_view indent = indent_at(text_, next.first());
    const std::size_t line = std::min(text_.find('\n', next.first()), text_.size()) - line_begin(text_, next.first());
    const std::string own = indent_like(next);
    const std::string alone = written(part, own, own.size(), ",");
    const bool is_too_long = line + alone.size() > kLongestLine && own.size() < column;
    if (is_too_long && alone.find('\n') == std::string::npos && !ends_in_line_comment(part)) {
      std::size_t begin = next.first();
      while (text_[begin - 1] == ' ' || text_[begin - 1] == '\t') --begin;
      return {{begin, next.first() - begin, new_line(own) + alone + " "}};
    }
    const std::string tail = ends_in_line_comment(part) ? new_line(indent_like(next)) : std::string(" ");
    return {{next.first(), 0, written(part, indent, column, ",") + tail}};
  }

  std::string_view text_;
  const LocatedTree& tree_;
  LocatedValue container_;
  const TextNode& node_;
  std::size_t count_;
};

}  // namespace

RemovedPart remove_part(const LocatedTree& tree, LocatedValue container, std::size_t index) {
  return Container(tree, container).remove(index);
}

TextPatch insert_part(const LocatedTree& tree, LocatedValue container, std::size_t index, const NewPart& part) {
  return Container(tree, container).insert(index, part);
}

}  // namespace meristem

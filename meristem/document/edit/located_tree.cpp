// SPDX-License-Identifier: Apache-2.0
// Parses a JSON text and scans it a second time for the positions of its values. The scanner knows that the text is
// valid, so it only follows brackets, quotes and commas, without recursion.
//
// A patch is applied to the innermost list or object around its splices. Parts that end before the first splice, with
// their comma, and parts that begin after the last splice stay. The text between them is parsed as a list or object of
// its own. Positions of all nodes after a splice change. They are moved when they are needed, or all together after
// many patches: each patch costs a small part of a pass over the tree.
#include "meristem/document/edit/located_tree.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "meristem/base/diagnostic.h"
#include "meristem/base/limits.h"
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

constexpr std::size_t kFewMembers = 32;   // are searched one by one
constexpr std::size_t kMaxMoves = 256;    // of a member's place, after which all members are entered again
constexpr std::size_t kMaxShifts = 1024;  // after which all nodes are moved

// End of a list or object, after the parts that are read again. No document has this name.
constexpr std::string_view kLastMember = R"( "\u0001 last": 0})";
constexpr std::string_view kLastElement = " 0]";

template <class Part>
void replace_parts(std::vector<Part>& parts, std::size_t begin, std::size_t end, std::vector<Part> fresh) {
  const std::size_t both = std::min(end - begin, fresh.size());
  const auto at = [&](std::size_t index) { return parts.begin() + static_cast<std::ptrdiff_t>(index); };
  const auto fresh_end = fresh.begin() + static_cast<std::ptrdiff_t>(both);
  std::move(fresh.begin(), fresh_end, at(begin));
  if (fresh.size() > both) {
    parts.insert(at(begin + both), std::make_move_iterator(fresh_end), std::make_move_iterator(fresh.end()));
  } else {
    parts.erase(at(begin + both), at(end));
  }
}

}  // namespace

/// New parts of a list or object, and the range of old parts that they replace.
struct LocatedTree::PartRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  Value values;                      // a list or object with the new parts
  std::vector<TextNode> nodes;       // below the new parts, which refer to each other by their places in this list
  std::vector<std::uint32_t> parts;  // places of the new parts among `nodes`
  std::size_t bytes = 0;             // parsed
};

LocatedTree::LocatedTree(std::string text, const Progress* progress)
    : text_(std::move(text)),
      value_(parse_json(text_, {}, progress)),
      parsed_bytes_(text_.size()),
      nodes_(NodeScanner(text_, progress).run()),
      seen_(nodes_.size()) {}

LocatedValue LocatedTree::part(LocatedValue container, std::size_t index) const {
  const std::uint32_t node = nodes_[container.node].parts[index];
  if (const Value::List* list = container.value->list()) return {&(*list)[index], node};
  return {&(*container.value->object())[index].second, node};
}

/// Returns a node with positions in the present text.
const TextNode& LocatedTree::node(std::uint32_t index) const {
  TextNode& node = nodes_[index];
  for (std::uint32_t& seen = seen_[index]; seen < shifts_.size(); ++seen) {
    const Shift& shift = shifts_[seen];
    // A position moves if the byte there is kept and follows the splice. The byte of an end is the one before it.
    const auto move = [&](std::size_t& at, std::size_t byte) {
      if (at != TextNode::kNone && byte >= shift.offset + shift.removed) at += shift.added - shift.removed;
    };
    move(node.end, node.end - 1);
    move(node.name_end, node.name_end - 1);
    move(node.begin, node.begin);
    move(node.name_begin, node.name_begin);
    move(node.comma, node.comma);
  }
  return node;
}

/// Moves all nodes, and forgets the shifts.
void LocatedTree::move_all() const {
  for (std::uint32_t index = 0; index < nodes_.size(); ++index) node(index);
  std::fill(seen_.begin(), seen_.end(), 0U);
  shifts_.clear();
}

std::size_t LocatedTree::index_of(LocatedValue object, std::string_view name) const {
  if (object.value == nullptr || object.value->object() == nullptr) return TextNode::kNone;
  const Value::Object& members = *object.value->object();
  if (members.size() <= kFewMembers) {
    const auto found = std::ranges::find(members, name, &Value::Member::first);
    return found == members.end() ? TextNode::kNone : static_cast<std::size_t>(found - members.begin());
  }
  MemberNames& names = names_[object.node];
  if (names.positions.empty() || names.moves > kMaxMoves) {
    names = {};
    names.positions.reserve(members.size());
    for (std::size_t k = 0; k < members.size(); ++k) names.positions.emplace(members[k].first, k);
  }
  const auto entered = names.positions.find(std::string(name));
  if (entered == names.positions.end()) return TextNode::kNone;
  // Insertions and removals have moved the member by a few places.
  const std::size_t begin = entered->second - std::min(entered->second, names.moves);
  const std::size_t end = std::min(entered->second + names.moves + 1, members.size());
  for (std::size_t k = begin; k < end; ++k) {
    if (members[k].first == name) return k;
  }
  return TextNode::kNone;
}

/// Returns the innermost list or object that has all bytes of a range between its brackets. Its value is null if the
/// range is not within the root.
LocatedTree::Touched LocatedTree::innermost(std::size_t begin, std::size_t end) {
  const auto is_within = [&](const TextNode& node) { return node.begin < begin && end < node.end; };
  Touched found{.value = &value_};
  if (part_count(value_) == 0 || !is_within(node(0))) return {};
  for (;;) {
    const std::vector<std::uint32_t>& parts = nodes_[found.node].parts;
    const auto behind =
        std::partition_point(parts.begin(), parts.end(), [&](std::uint32_t part) { return node(part).begin < begin; });
    if (behind == parts.begin()) return found;
    const auto index = static_cast<std::size_t>(behind - parts.begin()) - 1;
    Value& value =
        found.value->list() != nullptr ? (*found.value->list())[index] : (*found.value->object())[index].second;
    const bool is_container = value.list() != nullptr || value.object() != nullptr;
    if (!is_container || !is_within(node(parts[index]))) return found;
    found = {.value = &value, .node = parts[index], .depth = found.depth + 1};
  }
}

/// Returns the patch in pieces, each for one part of a list or object. Returns nothing if a splice is not within the
/// brackets of a part.
std::vector<TextPatch> LocatedTree::split(const Touched& touched, const TextPatch& patch) const {
  std::vector<TextPatch> groups;
  if (touched.value == nullptr || patch.size() < 2) return groups;
  const std::vector<std::uint32_t>& parts = nodes_[touched.node].parts;
  std::size_t last = parts.size();
  for (const TextSplice& splice : patch) {
    const auto behind = std::partition_point(parts.begin(), parts.end(),
                                             [&](std::uint32_t part) { return node(part).begin < splice.offset; });
    if (behind == parts.begin()) return {};
    const auto index = static_cast<std::size_t>(behind - parts.begin()) - 1;
    const TextNode& around = node(parts[index]);
    const bool is_container = text_[around.begin] == '{' || text_[around.begin] == '[';
    if (!is_container || splice.offset + splice.length >= around.end) return {};
    if (index != last) groups.emplace_back();
    groups.back().push_back(splice);
    last = index;
  }
  return groups;
}

/// Reads the parts of a list or object again that a patch changes or adds.
LocatedTree::PartRange LocatedTree::read_parts(const Touched& touched, const TextPatch& patch,
                                               const Progress* progress) const {
  const std::vector<std::uint32_t>& parts = nodes_[touched.node].parts;
  const std::size_t first = patch.front().offset;
  const std::size_t last = patch.back().offset + patch.back().length;
  const auto count_while = [&](const auto& is_before) {
    return static_cast<std::size_t>(std::partition_point(parts.begin(), parts.end(), is_before) - parts.begin());
  };
  // A comma of kNone is behind everything.
  PartRange range;
  range.begin = count_while([&](std::uint32_t part) { return node(part).comma < first; });
  range.end = count_while([&](std::uint32_t part) { return node(part).first() < last; });
  const bool is_list = touched.value->list() != nullptr;
  const bool has_next = range.end < parts.size();
  const std::size_t begin = range.begin > 0 ? node(parts[range.begin - 1]).comma + 1 : node(touched.node).begin + 1;
  const std::size_t end = has_next ? node(parts[range.end]).first() : node(touched.node).end - 1;
  TextPatch within = patch;
  for (TextSplice& splice : within) splice.offset -= begin;
  std::string text(is_list ? "[" : "{");
  text += apply_patch(std::string_view(text_).substr(begin, end - begin), within);
  text += is_list ? (has_next ? kLastElement : "]") : (has_next ? kLastMember : "}");
  SizeLimits limits;
  limits.nesting -= std::min(limits.nesting - 1, static_cast<std::uint64_t>(touched.depth));
  range.values = parse_json(text, limits, progress);
  range.bytes = text.size();
  range.nodes = NodeScanner(text, progress).run();
  range.parts = range.nodes[0].parts;
  if (has_next) {
    range.parts.pop_back();
    range.nodes.pop_back();
    if (is_list) {
      range.values.list()->pop_back();
    } else {
      range.values.object()->pop_back();
    }
  }
  for (TextNode& node : range.nodes) {
    for (std::size_t* const at : {&node.begin, &node.end, &node.name_begin, &node.name_end, &node.comma}) {
      if (*at != TextNode::kNone) *at += begin - 1;
    }
  }
  return range;
}

/// Enters the names of new members.
void LocatedTree::note_names(const Touched& touched, const PartRange& range) {
  const auto known = names_.find(touched.node);
  if (known == names_.end() || range.values.object() == nullptr) return;
  MemberNames& names = known->second;
  const Value::Object& members = *range.values.object();
  const std::size_t replaced = range.end - range.begin;
  const bool has_next = range.end < touched.value->object()->size();
  if (has_next) names.moves += std::max(members.size(), replaced) - std::min(members.size(), replaced);
  for (std::size_t k = 0; k < members.size(); ++k) {
    names.positions.insert_or_assign(members[k].first, range.begin + k);
  }
}

void LocatedTree::apply(const TextPatch& patch, const Progress* progress) {
  if (patch.empty()) return;
  if (!is_sound(patch, text_.size())) throw std::invalid_argument("the patch does not fit the text");
  const Touched touched = innermost(patch.front().offset, patch.back().offset + patch.back().length);
  if (const std::vector<TextPatch> groups = split(touched, patch); groups.size() > 1) {
    for (auto group = groups.rbegin(); group != groups.rend(); ++group) apply(*group, progress);
    return;
  }
  std::size_t size = text_.size();
  for (const TextSplice& splice : patch) size += splice.replacement.size() - splice.length;
  std::optional<PartRange> range;
  if (touched.value != nullptr && size <= SizeLimits().document_bytes) {
    try {
      range = read_parts(touched, patch, progress);
    } catch (const InputError&) {
      // The whole text has the fault at another place, or it has none.
    }
  }
  if (!range) {
    LocatedTree whole(apply_patch(text_, patch), progress);
    whole.parsed_bytes_ += parsed_bytes_;
    *this = std::move(whole);
    return;
  }

  // Only a lack of memory can throw from here on.
  note_names(touched, *range);
  parsed_bytes_ += range->bytes;
  for (auto splice = patch.rbegin(); splice != patch.rend(); ++splice) {
    text_.replace(splice->offset, splice->length, splice->replacement);
    shifts_.push_back({splice->offset, splice->length, splice->replacement.size()});
  }
  if (shifts_.size() > kMaxShifts) move_all();
  // Node 0 of the range stands for the list or object itself.
  const auto base = static_cast<std::uint32_t>(nodes_.size()) - 1;
  for (std::size_t k = 1; k < range->nodes.size(); ++k) {
    for (std::uint32_t& part : range->nodes[k].parts) part += base;
    nodes_.push_back(std::move(range->nodes[k]));
  }
  seen_.resize(nodes_.size(), static_cast<std::uint32_t>(shifts_.size()));
  for (std::uint32_t& part : range->parts) part += base;
  replace_parts(nodes_[touched.node].parts, range->begin, range->end, std::move(range->parts));
  if (Value::List* list = touched.value->list()) {
    replace_parts(*list, range->begin, range->end, std::move(*range->values.list()));
  } else {
    replace_parts(*touched.value->object(), range->begin, range->end, std::move(*range->values.object()));
  }
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

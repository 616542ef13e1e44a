// SPDX-License-Identifier: Apache-2.0
// Turns the lines of a table into rows with numbers. Rows refer to their parents by number, and errors in these numbers
// are reported by line. The rows are then sorted so that parents come before children: a walk from the roots, level by
// level, keeps the order of lines within each level.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/in_quotes.h"
#include "meristem/base/read_columns.h"
#include "meristem/base/reading_stop.h"
#include "meristem/plant/file/node_table.h"

namespace meristem {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t kMaxLetters = 100;

/// A line of a table. A cylinder has both ends; a node has only `begin`.
struct Row {
  double number = 0;  ///< the number that refers to this row
  double parent = kNan;
  DVec3 begin{0};
  DVec3 end{0};
  double radius = kNan;
  double branch = kNan;
  double birth = kNan;
  int line = 0;
};

[[noreturn]] void fail(const std::string& file, int line, std::string message, std::string expected,
                       std::string nearest = {}, int column = 0) {
  throw InputError(Diagnostic{.message = std::move(message),
                              .expected = std::move(expected),
                              .nearest = std::move(nearest),
                              .file = file,
                              .line = line,
                              .column = column});
}

/// Returns the name of a column without capitals, units and signs: "Radius (m)" -> "radius", "start_X" -> "startx".
std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name.substr(0, name.find('('))) {
    const bool is_letter = ('a' <= c && c <= 'z') || ('0' <= c && c <= '9');
    if (is_letter) plain += c;
    if ('A' <= c && c <= 'Z') plain += static_cast<char>(c - 'A' + 'a');
  }
  return plain;
}

/// The names of one column in different programs. Messages use the first name.
struct ColumnNames {
  std::vector<std::string> names;

  /// Returns the name of this column in the head line.
  std::optional<std::string> in(const std::vector<std::string>& head) const {
    for (const std::string& name : names) {
      for (const std::string& given : head) {
        if (plain_name(given) == plain_name(name)) return given;
      }
    }
    return std::nullopt;
  }
};

const ColumnNames kNumber{{"node", "id", "cyl_id", "cylinder_id"}};
const ColumnNames kParent{{"parent", "parent_id", "parent_cylinder"}};
const ColumnNames kRadius{{"radius", "radius_cyl"}};
const ColumnNames kDiameter{{"diameter", "diam"}};
const ColumnNames kBirth{{"birth"}};
const ColumnNames kNodeBranch{{"axis"}};
const ColumnNames kCylinderBranch{{"branch", "branch_id", "axis_id"}};
const ColumnNames kLength{{"length"}};
const std::array<ColumnNames, 3> kPosition{{{{"x"}}, {{"y"}}, {{"z"}}}};
const std::array<ColumnNames, 3> kStart{
    {{{"start_x", "start_point_x", "sx"}}, {{"start_y", "start_point_y", "sy"}}, {{"start_z", "start_point_z", "sz"}}}};
const std::array<ColumnNames, 3> kDirection{{{{"axis_x", "axis_direction_x", "ax"}},
                                             {{"axis_y", "axis_direction_y", "ay"}},
                                             {{"axis_z", "axis_direction_z", "az"}}}};
const std::array<ColumnNames, 3> kEnd{
    {{{"end_x", "end_point_x", "ex"}}, {{"end_y", "end_point_y", "ey"}}, {{"end_z", "end_point_z", "ez"}}}};

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\"");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

/// The part before the head line: comments, blank lines and the byte order mark.
struct Beginning {
  std::size_t offset = 0;
  int lines = 0;
};

Beginning beginning_of(std::string_view text) {
  Beginning before;
  if (text.starts_with("\xEF\xBB\xBF")) before.offset = 3;
  while (before.offset < text.size()) {
    const std::size_t end = std::min(text.find('\n', before.offset), text.size());
    const std::string_view line = without_blanks(text.substr(before.offset, end - before.offset));
    if (!line.empty() && line[0] != '#') break;
    before.offset = std::min(end + 1, text.size());
    ++before.lines;
  }
  return before;
}

std::string_view separator_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ";";
  return line.find('\t') != std::string_view::npos ? "\t" : ",";
}

std::vector<std::string> names_of_head(std::string_view line) {
  std::vector<std::string> names;
  const std::string_view separators = separator_of(line);
  while (names.size() < 1000) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    names.emplace_back(without_blanks(line.substr(0, std::min<std::size_t>(end, kMaxLetters))));
    if (end == line.size()) break;
    line.remove_prefix(end + 1);
  }
  return names;
}

/// Returns the head line of a TreeQSM text file with three names for each point or direction, which TreeQSM names once
/// over three columns. Returns an empty text for all other head lines.
std::string expanded_head(std::string_view line, const std::vector<std::string>& names) {
  std::string head;
  bool is_expanded = false;
  for (const std::string& name : names) {
    const std::string plain = plain_name(name);
    const bool is_triple = plain == "startpoint" || plain == "axisdirection";
    is_expanded = is_expanded || is_triple;
    for (const std::string_view letter : {"_x", "_y", "_z"}) {
      if (!head.empty()) head += separator_of(line);
      head += name;
      if (!is_triple) break;
      head += letter;
    }
  }
  return is_expanded ? head : std::string();
}

/// Reads the rows of a table of nodes or cylinders.
class TableReader {
 public:
  TableReader(std::string_view text, const std::string& file, const SizeLimits& limits)
      : text_(text), file_(file), limits_(limits), before_(beginning_of(text)) {
    const std::string_view rest = text_.substr(before_.offset);
    const std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
    head_ = names_of_head(line);
    const std::string expanded = expanded_head(line, head_);
    if (expanded.empty()) return;
    rewritten_ = std::string(text_.substr(0, before_.offset)) + expanded + std::string(rest.substr(line.size()));
    text_ = rewritten_;
    head_ = names_of_head(expanded);
  }
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  NodeTableForm form() const {
    return kStart[0].in(head_) || kStart[1].in(head_) || kStart[2].in(head_) ? NodeTableForm::cylinders
                                                                             : NodeTableForm::nodes;
  }
  bool is_own() const { return kNumber.in(head_) && kNodeBranch.in(head_) && kBirth.in(head_); }

  std::vector<Row> rows() {
    const NodeTableForm own_form = form();
    own_form == NodeTableForm::nodes ? ask_for_nodes() : ask_for_cylinders();
    const Columns columns = read();
    std::vector<Row> rows(columns.row_count());
    StopCounter stop;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      stop.step();
      const auto value = [&](std::size_t at) { return at == kNone ? kNan : columns.numbers[at][k]; };
      Row& row = rows[k];
      row.line = columns.lines[k] + before_.lines;
      // Without a column of numbers, cylinders are counted from 1, so that 0 means no parent. Nodes are counted from 0.
      const double counted = static_cast<double>(k) + (own_form == NodeTableForm::cylinders ? 1 : 0);
      row.number = number_ == kNone ? counted : value(number_);
      row.parent = value(parent_);
      row.radius = value(radius_) * (is_diameter_ ? 0.5 : 1);
      row.branch = value(branch_);
      row.birth = value(birth_);
      row.begin = {value(begin_[0]), value(begin_[1]), value(begin_[2])};
      row.end = row.begin;
      if (own_form == NodeTableForm::nodes) continue;
      const DVec3 other(value(other_[0]), value(other_[1]), value(other_[2]));
      const double length = glm::length(other);
      row.end = length_ == kNone ? other : row.begin + (length > 0 ? value(length_) / length : 0) * other;
    }
    return rows;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t ask(const ColumnNames& column, bool is_needed, bool may_be_empty = false,
                  const NumberLimit& limit = kFileNumber) {
    const std::optional<std::string> name = column.in(head_);
    if (!name && !is_needed) return kNone;
    requests_.push_back({name.value_or(column.names[0]), true, may_be_empty, limit});
    return requests_.size() - 1;
  }
  std::array<std::size_t, 3> ask(const std::array<ColumnNames, 3>& columns) {
    const auto ask_for = [this](const ColumnNames& column) { return ask(column, true, false, kFileCoordinate); };
    return {ask_for(columns[0]), ask_for(columns[1]), ask_for(columns[2])};
  }

  void ask_for_nodes() {
    begin_ = ask(kPosition);
    parent_ = ask(kParent, true, true);
    ask_for_radius(false);
    number_ = ask(kNumber, false);
    branch_ = ask(kNodeBranch, false);
    birth_ = ask(kBirth, false);
  }
  void ask_for_cylinders() {
    begin_ = ask(kStart);
    parent_ = ask(kParent, true, true);
    ask_for_radius(true);
    const bool has_end = kEnd[0].in(head_).has_value();
    other_ = ask(has_end ? kEnd : kDirection);
    if (!has_end) length_ = ask(kLength, true, false, kFileCoordinate);
    number_ = ask(kNumber, false);
    branch_ = ask(kCylinderBranch, false);
  }
  void ask_for_radius(bool is_needed) {
    is_diameter_ = !kRadius.in(head_) && kDiameter.in(head_);
    radius_ = ask(is_diameter_ ? kDiameter : kRadius, is_needed, true, kFileRadius);
  }

  Columns read() {
    try {
      return read_columns(text_.substr(before_.offset), requests_, limits_, RowLimit::nodes);
    } catch (const InputError& error) {
      std::vector<Diagnostic> errors = error.diagnostics();
      for (Diagnostic& diagnostic : errors) {
        diagnostic.file = file_;
        if (diagnostic.line > 0) diagnostic.line += before_.lines;
      }
      throw InputError(std::move(errors));
    }
  }

  std::string_view text_;
  std::string rewritten_;  // the text with an expanded head line
  const std::string& file_;
  const SizeLimits& limits_;
  Beginning before_;
  std::vector<std::string> head_;
  std::vector<ColumnRequest> requests_;
  std::array<std::size_t, 3> begin_{kNone, kNone, kNone};
  std::array<std::size_t, 3> other_{kNone, kNone, kNone};  // columns of a cylinder's end or direction
  std::size_t length_ = kNone, number_ = kNone, parent_ = kNone, radius_ = kNone, branch_ = kNone, birth_ = kNone;
  bool is_diameter_ = false;
};

/// Sorts rows into the order of a NodeTable.
class Sorter {
 public:
  Sorter(std::vector<Row> rows, NodeTableForm form, const std::string& file, const SizeLimits& limits)
      : rows_(std::move(rows)), form_(form), file_(file), limits_(limits) {}

  NodeTable run() {
    table_.form = form_;
    find_parents();
    find_order();
    add_nodes();
    return std::move(table_);
  }

 private:
  static constexpr std::uint32_t kNoRow = 0xffffffffU;

  /// Finds the row of each parent. A row has no parent if its cell is empty, negative, or 0 when no row has the number
  /// 0.
  void find_parents() {
    // Sorted numbers, because a map of millions of numbers takes too long to free when the reading is stopped.
    std::vector<std::pair<double, std::uint32_t>> row_of(rows_.size());
    for (std::uint32_t k = 0; k < rows_.size(); ++k) row_of[k] = {rows_[k].number, k};
    std::sort(row_of.begin(), row_of.end(), [this](const auto& a, const auto& b) {
      stop_.step();
      return a < b;
    });
    require_own_numbers(row_of);
    parent_.assign(rows_.size(), kNoRow);
    for (std::uint32_t k = 0; k < rows_.size(); ++k) {
      stop_.step();
      const double named = rows_[k].parent;
      if (std::isnan(named) || named < 0) continue;
      const auto found = std::lower_bound(row_of.begin(), row_of.end(), std::pair(named, std::uint32_t{0}));
      if (found != row_of.end() && found->first == named) {
        parent_[k] = found->second;
      } else if (named != 0) {
        fail(file_, rows_[k].line, fmt::format("there is no parent {:.12g}", named),
             fmt::format("the number of another row; of roots -1{}, or nothing",
                         form_ == NodeTableForm::cylinders ? " or 0" : ""));
      }
    }
  }

  /// Reports the first row whose number an earlier row has. The rows are sorted by number.
  void require_own_numbers(const std::vector<std::pair<double, std::uint32_t>>& row_of) {
    std::uint32_t first = kNoRow;  // of the rows that repeat a number
    std::uint32_t before = 0;
    for (std::size_t k = 1; k < row_of.size(); ++k) {
      if (row_of[k].first != row_of[k - 1].first || row_of[k].second >= first) continue;
      // A third row with this number comes later.
      first = row_of[k].second;
      before = row_of[k - 1].second;
    }
    if (first == kNoRow) return;
    fail(file_, rows_[first].line,
         fmt::format("the number {:.12g} is that of line {} already", rows_[first].number, rows_[before].line),
         "a number of its own for each row");
  }

  /// Orders the rows level by level from the roots. Reports rows that are never reached: their parents form a circle.
  void find_order() {
    std::vector<std::uint32_t> first(rows_.size() + 1, 0);
    for (const std::uint32_t parent : parent_) {
      if (parent != kNoRow) ++first[parent + 1];
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) first[k + 1] += first[k];
    std::vector<std::uint32_t> child(first.back());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    bool is_sorted = true;
    for (std::uint32_t k = 0; k < rows_.size(); ++k) {
      if (parent_[k] == kNoRow) {
        order_.push_back(k);
      } else {
        child[next[parent_[k]]++] = k;
        is_sorted = is_sorted && parent_[k] < k;
      }
    }
    if (is_sorted) {
      // Keep the order of lines if parents already come first.
      order_.clear();
      for (std::uint32_t k = 0; k < rows_.size(); ++k) order_.push_back(k);
      return;
    }
    for (std::size_t k = 0; k < order_.size(); ++k) {
      stop_.step();
      for (std::uint32_t c = first[order_[k]]; c < first[order_[k] + 1]; ++c) order_.push_back(child[c]);
    }
    if (order_.size() == rows_.size()) return;
    std::vector<bool> is_met(rows_.size());
    for (const std::uint32_t row : order_) is_met[row] = true;
    const auto lost = static_cast<std::size_t>(std::find(is_met.begin(), is_met.end(), false) - is_met.begin());
    fail(file_, rows_[lost].line, "the row's parents lead in a circle", "parents that lead to a root");
  }

  void add_nodes() {
    const auto roots = static_cast<std::size_t>(std::ranges::count(parent_, kNoRow));
    const std::size_t count = rows_.size() + (form_ == NodeTableForm::cylinders ? roots : 0);
    if (count > limits_.nodes) {
      Diagnostic diagnostic =
          limit_diagnostic("nodes of a file", static_cast<double>(count), limits_.nodes, "nodes", "");
      diagnostic.file = file_;
      throw InputError(std::move(diagnostic));
    }
    const bool has_branches = std::ranges::none_of(rows_, [](const Row& row) { return std::isnan(row.branch); });
    const bool has_births = std::ranges::none_of(rows_, [](const Row& row) { return std::isnan(row.birth); });
    std::unordered_map<double, std::uint32_t> branches;
    std::vector<NodeIndex> node_of(rows_.size(), kNoNode);
    std::map<std::array<double, 3>, NodeIndex> roots_at;  // begins of cylinders without a parent
    for (const std::uint32_t k : order_) {
      stop_.step();
      const Row& row = rows_[k];
      NodeIndex parent = parent_[k] == kNoRow ? kNoNode : node_of[parent_[k]];
      // NaN equals nothing, so rows without a branch would all be entries of their own.
      const std::uint32_t branch =
          has_branches ? branches.emplace(row.branch, static_cast<std::uint32_t>(branches.size())).first->second : 0;
      const auto add = [&](DVec3 position) {
        table_.parent.push_back(parent);
        table_.position.push_back(position);
        table_.radius.push_back(row.radius);
        if (has_branches) table_.branch.push_back(branch);
        if (has_births) table_.birth.push_back(static_cast<float>(row.birth));
        table_.line.push_back(row.line);
        return static_cast<NodeIndex>(table_.node_count() - 1);
      };
      // A cylinder ends in its node. A root cylinder also begins in a node, shared by all root cylinders that begin
      // there.
      if (form_ == NodeTableForm::cylinders && parent == kNoNode) {
        const auto [root, is_new] = roots_at.try_emplace({row.begin.x, row.begin.y, row.begin.z}, kNoNode);
        if (is_new) root->second = add(row.begin);
        parent = root->second;
      }
      node_of[k] = add(row.end);
    }
  }

  StopCounter stop_;
  std::vector<Row> rows_;
  NodeTableForm form_;
  const std::string& file_;
  const SizeLimits& limits_;
  std::vector<std::uint32_t> parent_;  // row of each row's parent
  std::vector<std::uint32_t> order_;   // sorted row indices
  NodeTable table_;
};

/// Returns true if the first line below the head contains several segments, separated by a comma and a blank.
bool has_trees(std::string_view text) {
  const Beginning before = beginning_of(text);
  const std::string_view rest = text.substr(before.offset);
  const std::size_t head_end = std::min(rest.find('\n'), rest.size());
  const std::string_view head = rest.substr(0, head_end);
  const bool has_names = head.find("x,y,z,radius") != std::string_view::npos;
  const std::string_view below = rest.substr(std::min(head_end + 1, rest.size()));
  const std::string_view line = below.substr(0, std::min(below.find('\n'), below.size()));
  return has_names && line.find(", ") != std::string_view::npos;
}

/// Reads a tree file into rows. Row numbers continue from tree to tree.
class TreeFileReader {
 public:
  TreeFileReader(std::string_view text, const std::string& file, const SizeLimits& limits)
      : rest_(text), file_(file), limits_(limits) {
    const Beginning before = beginning_of(text);
    rest_.remove_prefix(before.offset);
    line_ = before.lines;
  }

  std::vector<Row> rows() {
    read_head();
    while (!rest_.empty()) {
      const std::string_view line = take_line();
      if (!without_blanks(line).empty()) read_tree(line);
    }
    if (rows_.empty()) fail(file_, 0, "the file has no trees below its head line", "a line per tree");
    return std::move(rows_);
  }

 private:
  std::string_view take_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return line;
  }

  /// Reads the head line. Names of values of whole trees come first, separated by a blank from the names of segments'
  /// values.
  void read_head() {
    std::string_view head = take_line();
    const std::size_t segments = head.find("x,y,z,radius");
    skipped_ = segments > 0 ? 1 : 0;
    const std::vector<std::string> names = names_of_head(head.substr(segments));
    width_ = names.size();
    const auto parent = std::ranges::find(names, "parent_id");
    if (parent == names.end()) {
      fail(file_, line_, "there is no column 'parent_id'", "a head line that names it",
           nearest_name("parent_id", names));
    }
    parent_ = static_cast<std::size_t>(parent - names.begin());
    const auto branch = std::ranges::find(names, "branch_id");
    if (branch != names.end()) branch_ = static_cast<std::size_t>(branch - names.begin());
  }

  /// Reads a number. `text` must be a part of the current line.
  double number(std::string_view text, std::string_view what, const NumberLimit& limit = kFileNumber) {
    const std::string_view bare = without_blanks(text);
    double value = 0;
    const auto [end, error] = std::from_chars(bare.data(), bare.data() + bare.size(), value);
    const std::string place = fmt::format("{} in the segment {} of the tree", in_quotes(bare), segment_);
    const int column = 1 + static_cast<int>(text.data() - line_begin_);
    if (error != std::errc() || end != bare.data() + bare.size() || !std::isfinite(value)) {
      fail(file_, line_, place + " is not a number", fmt::format("{}, a finite number", what), {}, column);
    }
    if (!limit.holds(value)) {
      const Diagnostic outside = number_error(place, limit);
      fail(file_, line_, outside.message, outside.expected, {}, column);
    }
    return value;
  }

  void read_tree(std::string_view line) {
    const double base = static_cast<double>(rows_.size());
    line_begin_ = line.data();
    segment_ = 0;
    std::size_t skip = skipped_;
    std::vector<std::string_view> cells;
    while (!line.empty()) {
      stop_.step();
      const std::size_t end = std::min(line.find(", "), line.size());
      std::string_view part = line.substr(0, end);
      line.remove_prefix(std::min(end + 2, line.size()));
      if (skip > 0) {
        --skip;
        continue;
      }
      if (without_blanks(part).empty()) continue;
      cells.clear();
      while (cells.size() <= width_) {
        const std::size_t comma = std::min(part.find(','), part.size());
        cells.push_back(part.substr(0, comma));
        if (comma == part.size()) break;
        part.remove_prefix(comma + 1);
      }
      if (cells.size() != width_) {
        fail(file_, line_, fmt::format("the segment {} of the tree has {} numbers", segment_, cells.size()),
             fmt::format("{}, as the head line", width_));
      }
      if (rows_.size() >= limits_.nodes) {
        Diagnostic diagnostic =
            limit_diagnostic("nodes of a file", static_cast<double>(rows_.size()) + 1, limits_.nodes, "nodes", "");
        diagnostic.file = file_;
        throw InputError(std::move(diagnostic));
      }
      Row& row = rows_.emplace_back();
      row.number = base + static_cast<double>(segment_);
      row.end = {number(cells[0], "x", kFileCoordinate), number(cells[1], "y", kFileCoordinate),
                 number(cells[2], "z", kFileCoordinate)};
      row.radius = number(cells[3], "radius", kFileRadius);
      const double parent = number(cells[parent_], "parent_id");
      row.parent = parent < 0 ? -1 : base + parent;
      if (branch_ != kNoColumn) row.branch = number(cells[branch_], "branch_id");
      row.line = line_;
      ++segment_;
    }
  }

  StopCounter stop_;
  std::string_view rest_;
  const std::string& file_;
  const SizeLimits& limits_;
  int line_ = 0;
  const char* line_begin_ = nullptr;  // begin of the current line
  std::size_t skipped_ = 0;           // parts of a line before its segments
  std::size_t width_ = 0;
  static constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);
  std::size_t parent_ = 0;
  std::size_t branch_ = kNoColumn;
  std::size_t segment_ = 0;
  std::vector<Row> rows_;
};

}  // namespace

NodeTable read_node_table(std::string_view text, const std::string& file, const SizeLimits& limits) {
  if (has_trees(text)) {
    return Sorter(TreeFileReader(text, file, limits).rows(), NodeTableForm::trees, file, limits).run();
  }
  TableReader reader(text, file, limits);
  const bool is_own = reader.is_own();
  NodeTable table = Sorter(reader.rows(), reader.form(), file, limits).run();
  table.is_y_up = is_own;
  return table;
}

}  // namespace meristem

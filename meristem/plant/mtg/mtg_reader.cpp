// SPDX-License-Identifier: Apache-2.0
// Reads the entities of an MTG in one pass. A code is walked from its start (the scene, the entity above in the same
// column or in the previous column, or an alias) and makes one entity per label. An entity that begins a part of
// another (`/`) is joined to the parent of that other entity. A branch that starts a new axis therefore also starts its
// first internode.
//
// A successor or branch may have a finer scale than the current entity. The walk then continues from the finer entity
// on which the current one was set. Example: in `S3`, `^+B31`, `^<S4` in one column, with B an axis without further
// codes, S4 follows S3.
//
// Codes that start from the scene or an alias may repeat the names of entities on the way; only their last label is
// always new. Codes that start from a column always make new entities, because digitised plants use equal names for
// twins.
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/base/number_limit.h"
#include "meristem/plant/mtg/mtg.h"
#include "meristem/plant/mtg/mtg_header.h"
#include "meristem/plant/mtg/mtg_text.h"

namespace meristem {
namespace {

enum class Relation : std::uint8_t { part, successor, branch };

/// A relation sign: a single step, or a run of entities given by its ends.
struct Sign {
  std::string_view text;
  Relation relation;
  bool is_run = false;
  bool shares_values = false;
};

// Longer signs come before their prefixes.
constexpr std::array<Sign, 7> kSigns{{{"<.<", Relation::successor, true, true},
                                      {"+.+", Relation::branch, true, true},
                                      {"<<", Relation::successor, true},
                                      {"++", Relation::branch, true},
                                      {"<", Relation::successor},
                                      {"+", Relation::branch},
                                      {"/", Relation::part}}};

struct Label {
  std::uint32_t type = 0;
  std::int32_t index = -1;
};

/// Finds entities by name. The table is filled on first use, because most files never need it.
class Names {
 public:
  /// Adds a name. `from` is the entity at which the code was before the label.
  void add(MtgVertex from, Relation relation, Label label) { keys_.push_back(key(from, relation, label)); }

  MtgVertex find(MtgVertex from, Relation relation, Label label) {
    for (; known_ < keys_.size(); ++known_) {
      by_name_.try_emplace(keys_[known_], static_cast<MtgVertex>(known_));
    }
    const auto found = by_name_.find(key(from, relation, label));
    return found == by_name_.end() ? kNoVertex : found->second;
  }

 private:
  using Key = std::array<std::uint32_t, 4>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      return hash64(std::string_view(reinterpret_cast<const char*>(key.data()), sizeof(Key)));
    }
  };
  static Key key(MtgVertex from, Relation relation, Label label) {
    return {from, static_cast<std::uint32_t>(relation), label.type, static_cast<std::uint32_t>(label.index)};
  }

  std::vector<Key> keys_;
  std::size_t known_ = 0;
  std::unordered_map<Key, MtgVertex, KeyHash> by_name_;
};

class TreeReader {
 public:
  TreeReader(std::string_view text, const std::string& file, const SizeLimits& limits)
      : lines_(text), errors_(file, std::max<std::uint64_t>(limits.diagnostics, 1)), limits_(limits) {}

  MtgTree read() {
    header_ = read_mtg_header(lines_, errors_);
    tree_.classes = header_.classes;
    tree_.features = header_.features;
    add_vertex({}, kNoVertex, kNoVertex, MtgEdge::none, {});
    names_.add(kNoVertex, Relation::part, {});
    read_columns();
    while (lines_.next(line_)) read_line();
    errors_.throw_if_any();
    return std::move(tree_);
  }

 private:
  // --- the table ---

  /// Reads the line with the names of the columns.
  void read_columns() {
    if (!lines_.next(line_)) {
      line_ = {{}, lines_.last_number()};
      errors_.fail(line_, 0, {.message = "the file ends before its entities", .expected = kColumnsExpected});
    }
    const std::vector<MtgWord> cells = line_.cells();
    if (cells[0].text != "ENTITY-CODE" && cells[0].text != "TOPO") {
      errors_.fail(line_, cells[0].offset,
                   {.message = fmt::format("{} does not begin a line of columns", shown(cells[0].text)),
                    .expected = kColumnsExpected,
                    .nearest = nearest_name(cells[0].text, std::vector<std::string>{"ENTITY-CODE", "TOPO"})});
    }
    feature_of_column_.assign(cells.size(), kNone);
    code_columns_ = std::numeric_limits<std::size_t>::max();
    for (std::size_t k = 1; k < cells.size(); ++k) {
      if (cells[k].text.empty()) continue;
      code_columns_ = std::min(code_columns_, k);
      const auto found = header_.feature_by_name.find(cells[k].text);
      if (found != header_.feature_by_name.end()) {
        feature_of_column_[k] = found->second;
      } else {
        errors_.add(line_, cells[k].offset,
                    {.message = fmt::format("{} is not a feature", shown(cells[k].text)),
                     .expected = "one that FEATURES declares",
                     .nearest = nearest_known(cells[k].text, header_.feature_by_name)});
      }
    }
  }

  void read_line() {
    const std::vector<MtgWord> cells = line_.cells();
    named_ = {kNoVertex, kNoVertex};
    bool has_code = false;
    for (std::size_t k = 0; k < std::min(cells.size(), code_columns_); ++k) {
      if (cells[k].text.empty()) continue;
      has_code = true;
      read_code(cells[k], k);
    }
    if (!has_code) {
      errors_.add(line_, line_.text.find_first_not_of(" \t"),
                  {.message = "values without an entity",
                   .expected = fmt::format("the code of an entity in one of the first {} columns", code_columns_)});
    } else if (named_.last != kNoVertex) {
      read_values(cells);
    }
  }

  void read_values(const std::vector<MtgWord>& cells) {
    MtgValues& values = tree_.values;
    const std::size_t begin = values.cells.size();
    for (std::size_t k = code_columns_; k < std::min(cells.size(), feature_of_column_.size()); ++k) {
      const std::uint32_t feature = feature_of_column_[k];
      if (cells[k].text.empty() || feature == kNone) continue;
      const MtgFeature& declared = tree_.features[feature];
      if (declared.is_number && !to_number(cells[k].text)) {
        errors_.add(line_, cells[k].offset,
                    {.message = fmt::format("{} cannot be the {} of {}", shown(cells[k].text), declared.name,
                                            tree_.label(named_.last)),
                     .expected = "a number or nothing"});
        continue;
      }
      if (declared.is_number && !kFileNumber.holds(*to_number(cells[k].text))) {
        errors_.add(line_, cells[k].offset,
                    number_error(
                        fmt::format("{}, the {} of {},", shown(cells[k].text), declared.name, tree_.label(named_.last)),
                        kFileNumber));
        continue;
      }
      if (declared.name == "Alias") aliases_.insert_or_assign(std::string(cells[k].text), named_.last);
      values.cells.push_back(
          {feature, static_cast<std::uint32_t>(values.text.size()), static_cast<std::uint32_t>(cells[k].text.size())});
      values.text += cells[k].text;
    }
    if (values.cells.size() > begin) values.rows.push_back({named_.first, named_.last, begin, values.cells.size()});
  }

  // --- codes ---

  /// The state of reading one code.
  struct Code {
    MtgWord cell;
    std::size_t at = 0;       ///< bytes read
    MtgVertex position = 0;   ///< the current entity
    bool may_repeat = false;  ///< true: labels may name existing entities

    std::string_view rest() const { return cell.text.substr(at); }
    std::size_t offset() const { return cell.offset + at; }
  };

  void read_code(const MtgWord& cell, std::size_t column) {
    if (latest_.size() <= column) latest_.resize(column + 1, kNoVertex);
    Code code{.cell = cell};
    if (!find_start(code, column)) return;
    if (code.rest() == "*") {
      named_ = {code.position, code.position};
      return;
    }
    while (!code.rest().empty()) {
      if (!read_step(code)) break;
    }
    latest_[column] = code.position;
  }

  /// Sets the start of a code. Reports an error and returns false if it is unknown.
  bool find_start(Code& code, std::size_t column) {
    const std::string_view text = code.cell.text;
    if (text[0] == '^' || text == "*") {
      if (text[0] == '^') ++code.at;
      code.position = latest_[column];
      if (code.position != kNoVertex) return true;
      errors_.add(line_, code.cell.offset,
                  {.message = "there is no entity above in this column", .expected = "a code before it"});
      return false;
    }
    if (text[0] == '(') return find_alias(code);
    // Start from the nearest column on the left that has an entity, or from the scene.
    code.position = 0;
    code.may_repeat = column == 0;
    for (std::size_t k = column; k-- > 0;) {
      if (latest_[k] == kNoVertex) continue;
      code.position = latest_[k];
      break;
    }
    return true;
  }

  bool find_alias(Code& code) {
    const std::string_view text = code.cell.text;
    const std::size_t end = text.find(')');
    const std::string_view name = text.substr(1, end == std::string_view::npos ? end : end - 1);
    const auto found = aliases_.find(name);
    if (end == std::string_view::npos || found == aliases_.end()) {
      errors_.add(line_, code.cell.offset,
                  {.message = fmt::format("{} is not an alias", shown(name)),
                   .expected = "the value of a feature Alias before it",
                   .nearest = nearest_known(name, aliases_)});
      return false;
    }
    code.at = end + 1;
    code.position = found->second;
    code.may_repeat = true;
    return true;
  }

  /// Reads a sign and a label and moves there. Reports an error and returns false if it cannot.
  bool read_step(Code& code) {
    const std::string_view rest = code.rest();
    const auto sign = std::find_if(kSigns.begin(), kSigns.end(),
                                   [&](const Sign& candidate) { return rest.starts_with(candidate.text); });
    if (sign == kSigns.end()) {
      errors_.add(line_, code.offset(),
                  {.message = fmt::format("{} does not say how it is joined", shown(rest)),
                   .expected = "one of '/', '<', '+', '<<', '++'"});
      return false;
    }
    const std::size_t sign_offset = code.offset();
    code.at += sign->text.size();
    const auto label = read_label(code, *sign);
    if (!label) return false;
    if (tree_.classes[label->type].scale == 0) {
      code.position = 0;
      return true;
    }
    if (sign->is_run) return make_run(code, *sign, *label, sign_offset);
    if (code.may_repeat && !code.rest().empty()) {
      const MtgVertex known = names_.find(code.position, sign->relation, *label);
      if (known != kNoVertex) {
        code.position = known;
        return true;
      }
    }
    return make_entity(code, sign->relation, *label, sign_offset);
  }

  std::optional<Label> read_label(Code& code, const Sign& sign) {
    const std::string_view rest = code.rest();
    const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
    const std::size_t digits =
        std::min(rest.size(), std::min(rest.find_first_of("0123456789"), rest.find_first_of("/<+*^()")));
    const std::string_view name = rest.substr(0, digits);
    const std::size_t offset = code.offset();
    std::size_t end = digits;
    while (end < rest.size() && is_digit(rest[end])) ++end;
    code.at += end;
    if (name.empty()) {
      errors_.add(line_, offset,
                  {.message = fmt::format("a label is missing behind '{}'", sign.text),
                   .expected = "a class and a number, such as S1"});
      return {};
    }
    Label label;
    const auto found = header_.class_by_name.find(name);
    if (found == header_.class_by_name.end()) {
      // Some programs name the scene without declaring its class.
      if (tree_.vertex_count() == 1 && sign.relation == Relation::part) return label;
      errors_.add(line_, offset,
                  {.message = fmt::format("{} is not a class", shown(name)),
                   .expected = "one that CLASSES declares",
                   .nearest = nearest_known(name, header_.class_by_name)});
      return {};
    }
    label.type = found->second;
    if (end == digits) return label;
    const std::string_view number = rest.substr(digits, end - digits);
    if (std::from_chars(number.data(), number.data() + number.size(), label.index).ec != std::errc()) {
      errors_.add(line_, offset + digits,
                  {.message = fmt::format("the number {} is too large", shown(number)),
                   .expected = fmt::format("at most {}", std::numeric_limits<std::int32_t>::max())});
      return {};
    }
    return label;
  }

  // --- entities ---

  /// The entity of an equal or finer scale on which another entity was set, and the kind of joint.
  struct Setting {
    MtgVertex base = kNoVertex;
    MtgEdge edge = MtgEdge::none;
  };
  struct VertexRange {
    MtgVertex first = kNoVertex;
    MtgVertex last = kNoVertex;
  };

  MtgVertex ancestor(MtgVertex vertex, int scale) const {
    while (tree_.scale(vertex) > scale) vertex = tree_.complex[vertex];
    return vertex;
  }

  /// Follows the bases of `vertex` to an entity of at least `scale`. Returns `vertex` if no such entity exists.
  MtgVertex finer_base(MtgVertex vertex, int scale) const {
    MtgVertex base = vertex;
    while (base != kNoVertex && tree_.scale(base) < scale) base = finer_base_[base];
    return base == kNoVertex ? vertex : base;
  }

  /// Makes the entities after the current one, up to `label`.
  bool make_run(Code& code, const Sign& sign, Label label, std::size_t offset) {
    code.position = finer_base(code.position, tree_.classes[label.type].scale);
    const Label from{tree_.type[code.position], tree_.index[code.position]};
    if (from.type != label.type || from.index < 0 || from.index >= label.index) {
      errors_.add(line_, offset,
                  {.message = fmt::format("'{}' cannot lead from {} to {}{}", sign.text, tree_.label(code.position),
                                          tree_.classes[label.type].name, label.index),
                   .expected = "two labels of one class with rising numbers"});
      return false;
    }
    check_count(static_cast<std::uint64_t>(label.index - from.index), offset);
    const MtgVertex first = code.position;
    const auto next = static_cast<MtgVertex>(tree_.vertex_count());
    for (std::int32_t index = from.index; index < label.index; ++index) {
      if (!make_entity(code, sign.relation, {label.type, index + 1}, offset)) return false;
    }
    // Shared values also belong to the first entity if this code made it.
    if (sign.shares_values) named_.first = first + 1 == next ? first : next;
    return true;
  }

  bool make_entity(Code& code, Relation relation, Label label, std::size_t offset) {
    const int scale = tree_.classes[label.type].scale;
    const bool is_part = relation == Relation::part;
    const MtgVertex named_from = code.position;
    if (!is_part) code.position = finer_base(code.position, scale);
    const int from_scale = tree_.scale(code.position);
    if (is_part ? scale > from_scale + 1 : scale > from_scale) {
      errors_.add(line_, offset,
                  {.message = fmt::format("{} of scale {} cannot follow {} of scale {}", tree_.classes[label.type].name,
                                          scale, tree_.label(code.position), from_scale),
                   .expected = fmt::format("'/' and an entity of scale {}", from_scale + 1)});
      return false;
    }
    check_count(1, offset);
    names_.add(named_from, relation, label);
    if (is_part) {
      code.position = add_part(label, ancestor(code.position, scale - 1));
    } else {
      const MtgVertex bearer = ancestor(code.position, scale);
      const MtgEdge edge = relation == Relation::branch ? MtgEdge::branch : MtgEdge::successor;
      code.position = add_vertex(label, tree_.complex[bearer], bearer, edge, {code.position, edge});
    }
    named_ = {code.position, code.position};
    return true;
  }

  /// Adds a part. The first part of an entity is joined to the base of that entity; further parts are joined to
  /// nothing.
  MtgVertex add_part(Label label, MtgVertex whole) {
    const Setting setting = has_parts_[whole] ? Setting{} : settings_[whole];
    has_parts_[whole] = true;
    const int scale = tree_.classes[label.type].scale;
    if (setting.base == kNoVertex || tree_.scale(setting.base) < scale) {
      return add_vertex(label, whole, kNoVertex, MtgEdge::none, setting);
    }
    return add_vertex(label, whole, ancestor(setting.base, scale), setting.edge, setting);
  }

  MtgVertex add_vertex(Label label, MtgVertex whole, MtgVertex parent, MtgEdge edge, Setting setting) {
    tree_.type.push_back(label.type);
    tree_.index.push_back(label.index);
    tree_.complex.push_back(whole);
    tree_.parent.push_back(parent);
    tree_.edge.push_back(edge);
    tree_.line.push_back(line_.number);
    const MtgVertex base = setting.base;
    const bool is_finer = base != kNoVertex && tree_.scale(base) > tree_.classes[label.type].scale;
    finer_base_.push_back(base == kNoVertex || is_finer ? base : finer_base_[base]);
    settings_.push_back(setting);
    has_parts_.push_back(false);
    return static_cast<MtgVertex>(tree_.vertex_count() - 1);
  }

  void check_count(std::uint64_t more, std::size_t offset) {
    const std::uint64_t wanted = tree_.vertex_count() + more;
    if (wanted <= limits_.nodes) return;
    errors_.fail(line_, offset, limit_diagnostic("entities", static_cast<double>(wanted), limits_.nodes, "nodes", ""));
  }

  static constexpr const char* kColumnsExpected = "ENTITY-CODE or TOPO, and the names of features";
  static constexpr std::uint32_t kNone = 0xffffffffU;

  MtgLines lines_;
  MtgErrors errors_;
  SizeLimits limits_;
  MtgHeader header_;
  MtgTree tree_;
  MtgLine line_;
  std::size_t code_columns_ = 0;                  // columns before the first feature's column
  std::vector<std::uint32_t> feature_of_column_;  // kNone for columns without a feature
  std::vector<MtgVertex> latest_;                 // latest entity of each column
  std::map<std::string, MtgVertex, std::less<>> aliases_;
  Names names_;
  std::vector<Setting> settings_;      // by vertex
  std::vector<MtgVertex> finer_base_;  // the nearest entity of a finer scale along these, or kNoVertex
  std::vector<bool> has_parts_;        // by vertex
  VertexRange named_;                  // entities that get the values of this line
};

}  // namespace

MtgTree read_mtg(std::string_view text, const std::string& file, const SizeLimits& limits) {
  return TreeReader(text, file, limits).read();
}

}  // namespace meristem

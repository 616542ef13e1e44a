// SPDX-License-Identifier: Apache-2.0
// Tables of all kinds of operations, checks of their parameters, and conversion to the form that growth uses.
#include "meristem/components/parts/operation_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/frame.h"
#include "meristem/base/math.h"
#include "meristem/components/parts/check_line.h"
#include "meristem/grow/prune/layers.h"
#include "meristem/scene/crown/placed_crown.h"

namespace meristem {

namespace {

constexpr NumberRange kIteration{.min = 1, .max = kLastIteration, .usual = {1, 40}};
constexpr NumberRange kWeight{.min = 0, .max = 1000, .usual = {0, 10}};
constexpr const char* kShootForms =
    "leader, a label such as main.4.2, or a condition such as \"rank >= 2 && length > 0.3\"";

const ParameterTable& common_table() {
  static const ParameterTable table =
      Table<OperationParameters>("an operation", "Times of an operation, and the shoots that it acts on.")
          .integer("at", &OperationParameters::at, kIteration, "Iteration after which the operation acts, once.")
          .integer("from", &OperationParameters::from, kIteration, "First iteration after which the operation acts.")
          .integer(
              "every", &OperationParameters::every, {.min = 1, .max = kLastIteration, .usual = {1, 10}},
              "Number of iterations from one time that the operation acts to the next; raised, it acts less often.")
          .integer("to", &OperationParameters::to, kIteration,
                   "Last iteration after which the operation acts; a support holds until then.")
          .condition("when", &OperationParameters::when, tree_variables(),
                     "Condition on the tree for the operation to act, over iteration, height, width, metamers, "
                     "laterals and leader_length.")
          .boolean("once", &OperationParameters::once, "Whether the operation acts on each tree only once.")
          .choice("season", &OperationParameters::season, {"winter", "summer"},
                  "Season in which the operation acts: 'winter', after all growth of the iteration; 'summer', after a "
                  "share of the growth, before the rest.")
          .text("shoots", &OperationParameters::shoots,
                "Shoots that the operation acts on: 'leader', a label (main.4.2) or a condition over rank, length, "
                "age, light, resource, radius, height, inclination, azimuth, clearance, inward, marked or states.")
          .integer("tree", &OperationParameters::tree, {.min = 0, .max = 1e6, .usual = {0, 10}},
                   "Number of the root whose tree the operation is for, from 0; by default, it is for all trees.")
          .boolean("off", &OperationParameters::off,
                   "Whether the operation is switched off: it stays in the list, and never acts.")
          .never_with("at", {"from", "every", "to", "once"});
  return table;
}

void check_common(const OperationParameters& common, const DocumentPath& path, ParameterReader& reader) {
  if (common.to && *common.to < common.from) {
    reader.add_error(DocumentPath(path, "to"), fmt::format("'to' {} lies before 'from' {}", *common.to, common.from),
                     fmt::format("a whole number of at least {}", common.from));
  }
}

/// Parses the choice of shoots. `names` are the variables of conditions.
ShootChoice choice_of(const std::string& text, const std::vector<std::string>& names, const DocumentPath& place,
                      ParameterReader& reader) {
  if (text == "leader") return ShootChoice::leader();
  if (is_shoot_name(text)) return ShootChoice::label(text);
  const bool is_known =
      std::ranges::find(names, text) != names.end() || reader.expressions().constant_table().names().contains(text);
  static const std::vector<std::string> words{"leader", "main"};
  const std::string nearest = is_identifier(text) && !is_known ? reader.nearest(text, words) : "";
  if (text.empty() || text.starts_with("main") || !nearest.empty()) {
    reader.add_error(place, fmt::format("'{}' names no shoot", text), kShootForms, nearest);
  } else if (auto condition = reader.expressions().read(text, place, names)) {
    return {ShootChoice::Kind::condition, text, std::move(*condition)};
  }
  return {};
}

/// Stores the document path of an operation for errors during growth.
template <class Kind>
void prepare(Kind& operation, const DocumentPath& path, ParameterReader&) {
  operation.path = path.text();
}

template <class Kind>
void check_only_common(const Kind& operation, const DocumentPath& path, ParameterReader& reader) {
  check_common(operation, path, reader);
}

const ParameterTable& bud_table() {
  static const ParameterTable table =
      Table<BudParameters>("a bud to cut to", "The sleeping bud that a shoot is cut back to.")
          .choice("toward", &BudParameters::toward, {"down", "up", "out", "direction"},
                  "Side that the bud faces: 'down', 'up', 'out' from the stem, or the given 'direction'.")
          .vector("direction", &BudParameters::direction, {.min = -1e3, .max = 1e3, .usual = {-1, 1}},
                  "Direction [x, y, z] that the bud faces.")
          .in_space(InSpace::direction)
          .integer("window", &BudParameters::window, {.min = 0, .max = 1e6, .usual = {0, 10}},
                   "Number of metamers to each side of the middle, among whose buds the one that faces best is chosen; "
                   "0 takes the nearest bud that faces that side.")
          .only_where({{"toward", {"direction"}}}, {"direction"})
          .shorthand("toward");
  return table;
}

void check_cut(const CutParameters& cut, const DocumentPath& path, ParameterReader& reader) {
  check_common(cut, path, reader);
  if (cut.above == 0 && (cut.shoots == "main" || cut.shoots == "leader")) {
    reader.add_error(DocumentPath(path, "above"), "nothing would be left of the tree", "a whole number of at least 1");
  }
  if (cut.above_lateral && cut.above_lateral->expression.is_constant()) {
    const double number = cut.above_lateral->expression.evaluate();
    if (!(number >= 1) || !std::isfinite(number)) {
      reader.add_error(DocumentPath(path, "above_lateral"),
                       fmt::format("no lateral shoot has the number {:.6g}", number), "a number of at least 1");
    }
  }
  if (cut.to_bud && cut.to_bud->toward == CutOperation::Toward::direction && cut.to_bud->direction == Vec3(0)) {
    const DocumentPath bud(path, "to_bud");
    reader.add_error(DocumentPath(bud, "direction"), "the direction has no length", "a direction such as [1, 0, 0]");
  }
}

const ParameterTable& cut_table() {
  static const ParameterTable table =
      Table<CutParameters>("a cut", "A cut, which removes shoots, or parts of them, just above a bud.")
          .include<OperationParameters>(common_table())
          .integer("above", &CutParameters::above, {.min = 0, .max = 1e9, .usual = {0, 20}},
                   "Number of metamers that stay of a cut shoot, from its base; 0 removes the whole shoot.")
          .formula("above_lateral", &CutParameters::above_lateral, {},
                   "Number of the lateral shoot, from the base, above which the cut is made, such as "
                   "\"floor(rand(3, 5))\".")
          .object("to_bud", &CutParameters::to_bud, bud_table,
                  "Bud that the shoot is cut back to: a sleeping bud near the middle of the youngest stretch, which "
                  "faces 'down', 'up', 'out' or a direction.")
          .object("outside", &CutParameters::outside, crown_table,
                  "Body, relative to the root, outside which everything is cut off.")
          .boolean("leader", &CutParameters::leader,
                   "Whether another shoot takes the lead where the leader is cut; false makes an open tree.")
          .number("stub", &CutParameters::stub, {.min = 0, .max = 1},
                  "Length of the dead stub that the cut leaves above the bud, in metamers; 0 cuts just above the bud.")
          .one_of({"above", "above_lateral", "to_bud", "outside"})
          .elsewhere({operation_kinds().key})
          .check(check_cut)
          .prepare(prepare<CutParameters>);
  return table;
}

const ParameterTable& spur_table() {
  static const ParameterTable table =
      Table<SpurParameters>("a spur", "A rule that keeps shoots short and without branches.")
          .include<OperationParameters>(common_table())
          .integer("metamers", &SpurParameters::metamers, {.min = 0, .max = 1e6, .usual = {0, 20}},
                   "Number of metamers that a shoot keeps ('spur', 'limit'), that the leader has from layer to layer "
                   "('layers'), or that the bend extends over ('bend').")
          .elsewhere({operation_kinds().key})
          .check(check_only_common<SpurParameters>)
          .prepare(prepare<SpurParameters>);
  return table;
}

const ParameterTable& length_limit_table() {
  static const ParameterTable table =
      Table<LimitParameters>("a limit", "A length that shoots do not pass.")
          .include<OperationParameters>(common_table())
          .integer("metamers", &LimitParameters::metamers, {.min = 1, .max = 1e6, .usual = {1, 40}},
                   "Number of metamers that a shoot keeps; raised, longer shoots.")
          .elsewhere({operation_kinds().key})
          .check(check_only_common<LimitParameters>)
          .prepare(prepare<LimitParameters>);
  return table;
}

const ParameterTable& layers_table() {
  static const ParameterTable table =
      Table<LayersParameters>("layers", "The rule of the espalier: arms in layers on both sides of the leader.")
          .include<OperationParameters>(common_table())
          .integer("count", &LayersParameters::count, {.min = 1, .max = 1000, .usual = {1, 8}}, "Number of layers.")
          .integer("metamers", &LayersParameters::metamers, {.min = 3, .max = 1000, .usual = {3, 12}},
                   "Number of metamers of the leader from layer to layer; raised, layers stand farther apart.")
          .number("azimuth", &LayersParameters::azimuth,
                  {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 180}},
                  "Azimuth of the right arms, from north (0) over east (90); the left arms point the other way.")
          .number("angle", &LayersParameters::angle, {.unit = Unit::degree, .min = -60, .max = 80, .usual = {0, 60}},
                  "Angle of the arms above the horizontal.")
          .number("angle_last", &LayersParameters::angle_last,
                  {.unit = Unit::degree, .min = -60, .max = 80, .usual = {0, 70}},
                  "Angle of the topmost layer's arms above the horizontal; layers between change evenly. By default, "
                  "all layers have the angle 'angle'.")
          .number("weight", &LayersParameters::weight, kWeight,
                  "Weight of the support's direction in the growth of tied shoots; raised, shoots follow the support "
                  "more closely.")
          .number("wires", &LayersParameters::wires, {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 3}},
                  "Length of the visible wires to each side of the stem; 0 shows none.")
          .without({"shoots"}, "layers stand on the leader")
          .elsewhere({operation_kinds().key})
          .check(check_only_common<LayersParameters>)
          .prepare(prepare<LayersParameters>);
  return table;
}

void check_support(const SupportParameters& support, const DocumentPath& path, ParameterReader& reader) {
  check_common(support, path, reader);
  if (support.named.empty()) check_line(support.line, DocumentPath(path, "line"), reader);
}

const ParameterTable& support_table() {
  static const ParameterTable table =
      Table<SupportParameters>("a support", "A pole, rod or wire that shoots are tied to and grow along.")
          .include<OperationParameters>(common_table())
          .positions("line", &SupportParameters::line, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-3, 3}},
                     "Points of the support's line, relative to the root of each tree; shoots grow along the line from "
                     "the first point to the last.")
          .together(PointsForm::line)
          .text("named", &SupportParameters::named,
                "Name of a line of the scene, one of scene.supports, that all trees are tied to.")
          .number("weight", &SupportParameters::weight, kWeight,
                  "Weight of the support's direction in the growth of tied shoots; raised, shoots follow the support "
                  "more closely.")
          .number("thickness", &SupportParameters::thickness,
                  {.unit = Unit::metre, .min = 0, .max = 10, .usual = {0, 0.1}},
                  "Diameter of the visible pole or wire; 0 shows none.")
          .one_of({"line", "named"})
          .without({"season"}, "supports are set before all growth")
          .elsewhere({operation_kinds().key})
          .check(check_support)
          .prepare(prepare<SupportParameters>);
  return table;
}

void check_mark(const MarkParameters& mark, const DocumentPath& path, ParameterReader& reader) {
  check_common(mark, path, reader);
  const bool is_own = mark.state == "marked" || std::ranges::count(shoot_variables(), mark.state) == 0;
  if (is_identifier(mark.state) && !is_builtin_name(mark.state) && mark.state != "leader" && is_own) return;
  reader.add_error(DocumentPath(path, "state"), fmt::format("'{}' cannot be the word for a state", mark.state),
                   "a word of letters, digits and _ that has no other meaning in conditions, such as dead");
}

const ParameterTable& mark_table() {
  static const ParameterTable table =
      Table<MarkParameters>("a mark", "A mark on shoots, which other operations ask for by 'marked'.")
          .include<OperationParameters>(common_table())
          .number("chance", &MarkParameters::chance, {.min = 0, .max = 1},
                  "Probability that a shoot is marked; raised, more marked shoots.")
          .text("state", &MarkParameters::state,
                "Word for the state, such as dead or diseased; conditions of other operations ask for it.")
          .elsewhere({operation_kinds().key})
          .check(check_mark)
          .prepare(prepare<MarkParameters>);
  return table;
}

constexpr NumberRange kBelow{.min = 0, .max = 1e6, .usual = {0, 20}};
constexpr const char* kBelowDoc =
    "Number of metamers of the shoot below the ring, the bend or the string; by default, a string is tied at the tip. "
    "Raised, farther from the shoot's base.";
constexpr NumberRange kDuration{.min = 1, .max = kLastIteration, .usual = {1, 10}};
constexpr const char* kDurationDoc = "Number of iterations until a ring has healed, or until a shoot is fully bent.";

const ParameterTable& girdle_table() {
  static const ParameterTable table =
      Table<GirdleParameters>("a girdle",
                              "A ring of bark that is taken off, so that the resource made above it stays above it.")
          .include<OperationParameters>(common_table())
          .integer("below", &GirdleParameters::below, kBelow, kBelowDoc)
          .number("share", &GirdleParameters::share, {.min = 0, .max = 1},
                  "Share of the resource made above the ring that stays there instead of passing the ring toward the "
                  "root; raised, the shoot grows more.")
          .integer("iterations", &GirdleParameters::iterations, kDuration, kDurationDoc)
          .elsewhere({operation_kinds().key})
          .check(check_only_common<GirdleParameters>)
          .prepare(prepare<GirdleParameters>);
  return table;
}

const ParameterTable& bend_table() {
  static const ParameterTable table =
      Table<BendParameters>("a bend", "Shoots that are bent by wires and held: they no longer sag.")
          .include<OperationParameters>(common_table())
          .integer("below", &BendParameters::below, kBelow, kBelowDoc)
          .integer("metamers", &BendParameters::metamers, {.min = 1, .max = 1e6, .usual = {1, 12}},
                   "Number of metamers that the bend extends over; raised, a wider bend.")
          .number("inclination", &BendParameters::inclination,
                  {.unit = Unit::degree, .min = -90, .max = 90, .usual = {-60, 60}},
                  "Angle above the horizontal to which the shoot is bent; negative, the shoot points down.")
          .integer("iterations", &BendParameters::iterations, kDuration, kDurationDoc)
          .elsewhere({operation_kinds().key})
          .check(check_only_common<BendParameters>)
          .prepare(prepare<BendParameters>);
  return table;
}

void check_tie(const TieParameters& tie, const DocumentPath& path, ParameterReader& reader) {
  check_common(tie, path, reader);
  if (tie.shoots == "main" || tie.shoots == "leader") {
    reader.add_error(DocumentPath(path, "shoots"), "a stem cannot be tied down", "branches, such as \"rank == 1\"");
  }
}

const ParameterTable& tie_table() {
  static const ParameterTable table =
      Table<TieParameters>("a tie", "Strings that draw shoots to others or to the ground, and hold them there.")
          .include<OperationParameters>(common_table())
          .integer("below", &TieParameters::below, {.min = 1, .max = 1e6, .usual = {1, 20}}, kBelowDoc)
          .text("anchor", &TieParameters::anchor,
                "Place that the string leads to: 'ground' straight below, or the nearest of other shoots: 'leader', a "
                "label, or a condition.")
          .number("length", &TieParameters::length, {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 2}},
                  "Length of the string that is left; raised, shoots are drawn less far.")
          .integer("iterations", &TieParameters::iterations, kDuration, kDurationDoc)
          .elsewhere({operation_kinds().key})
          .check(check_tie)
          .prepare(prepare<TieParameters>);
  return table;
}

Vec3 level_way(double azimuth) {
  return {static_cast<float>(math::sin(azimuth)), 0, static_cast<float>(-math::cos(azimuth))};
}

LayersOperation rule_of(const LayersParameters& form, Vec3 right) {
  return {form.count, form.metamers, right, form.angle, form.angle_last.value_or(form.angle), form.weight};
}

/// Converts the parameters of each kind of operation to the form that growth uses.
struct OperationBuilder {
  const Mat3& axes;

  CutOperation operator()(const CutParameters& form) const {
    CutOperation cut;
    cut.has_successor = form.leader;
    cut.stub = form.stub;
    if (form.above) {
      cut.place = CutOperation::Place::above;
      cut.above = *form.above;
    } else if (form.above_lateral) {
      cut.place = CutOperation::Place::above_lateral;
      cut.lateral = form.above_lateral->expression;
    } else if (form.to_bud) {
      cut.place = CutOperation::Place::to_bud;
      cut.toward = form.to_bud->toward;
      cut.direction = normalized_or(axes * form.to_bud->direction, kUp);
      cut.window = form.to_bud->window;
    } else {
      cut.place = CutOperation::Place::outside;
      cut.outside = build_crown(*form.outside);
      if (axes != Mat3(1)) cut.outside = std::make_shared<PlacedCrown>(std::move(cut.outside), Frame{axes});
    }
    return cut;
  }
  SpurOperation operator()(const SpurParameters& form) const { return {form.metamers}; }
  LimitOperation operator()(const LimitParameters& form) const { return {form.metamers}; }
  LayersOperation operator()(const LayersParameters& form) const {
    return rule_of(form, normalized_or(axes * level_way(form.azimuth), Vec3(1, 0, 0)));
  }
  TrainingSupport operator()(const SupportParameters& form) const {
    TrainingSupport support{form.line, form.named, form.weight, form.to.value_or(kLastIteration)};
    for (Vec3& point : support.line) point = axes * point;
    return support;
  }
  MarkOperation operator()(const MarkParameters& form) const { return {form.chance, form.number}; }
  GirdleOperation operator()(const GirdleParameters& form) const { return {form.below, form.share, form.iterations}; }
  BendOperation operator()(const BendParameters& form) const {
    return {form.below, form.metamers, form.inclination, form.iterations};
  }
  TieOperation operator()(const TieParameters& form) const {
    return {form.below, form.anchor_shoots, form.length, form.iterations};
  }
};

}  // namespace

const OperationParameters& common_of(const AnyOperation& operation) {
  return std::visit([](const auto& what) -> const OperationParameters& { return what; }, operation);
}

OperationParameters& common_of(AnyOperation& operation) {
  return std::visit([](auto& what) -> OperationParameters& { return what; }, operation);
}

std::vector<std::string> mark_words(const std::vector<AnyOperation>& operations) {
  std::vector<std::string> words;
  for (const AnyOperation& operation : operations) {
    const auto* mark = std::get_if<MarkParameters>(&operation);
    if (mark == nullptr || mark->state == "marked" || std::ranges::count(words, mark->state) != 0) continue;
    if (words.size() + 1 < kMaxMarks) words.push_back(mark->state);
  }
  return words;
}

void prepare_operations(std::vector<AnyOperation>& operations, const std::vector<std::string>& words,
                        const DocumentPath& path, ParameterReader& reader) {
  std::vector<std::string> names = shoot_variables();
  names.insert(names.end(), words.begin(), words.end());
  for (std::size_t k = 0; k < operations.size(); ++k) {
    const DocumentPath place(path, k);
    OperationParameters& common = common_of(operations[k]);
    common.chosen = choice_of(common.shoots, names, DocumentPath(place, "shoots"), reader);
    if (auto* mark = std::get_if<MarkParameters>(&operations[k])) {
      const auto word = std::ranges::find(words, mark->state);
      mark->number = word != words.end() ? static_cast<std::uint32_t>(word - words.begin()) : kMaxMarks - 1;
      if (word != words.end() || mark->state == "marked") continue;
      reader.add_error(DocumentPath(place, "state"), fmt::format("'{}' is one state too many", mark->state),
                       fmt::format("at most {} different states", kMaxMarks - 1));
    }
    if (auto* tie = std::get_if<TieParameters>(&operations[k]); tie != nullptr && tie->anchor != "ground") {
      tie->anchor_shoots = choice_of(tie->anchor, names, DocumentPath(place, "anchor"), reader);
    }
  }
}

TreeOperation build_operation(const AnyOperation& form, const Mat3& axes) {
  const OperationParameters& common = common_of(form);
  TreeOperation operation;
  operation.when = common.at ? OperationSchedule::at(*common.at)
                             : OperationSchedule{common.from, common.every, common.to.value_or(kLastIteration),
                                                 std::nullopt, common.once};
  operation.when.in_summer = common.season == OperationParameters::Season::summer;
  if (common.when) operation.when.when = common.when->expression;
  operation.shoots = common.chosen;
  operation.tree = common.tree;
  operation.path = common.path;
  const OperationBuilder builder{axes};
  std::visit([&](const auto& what) { operation.what = builder(what); }, form);
  return operation;
}

std::vector<SeenLine> seen_lines(const AnyOperation& form, double length) {
  std::vector<SeenLine> lines;
  if (const auto* support = std::get_if<SupportParameters>(&form); support != nullptr && support->thickness > 0) {
    lines.push_back({support->line, 0.5 * support->thickness});
  }
  if (const auto* layers = std::get_if<LayersParameters>(&form); layers != nullptr && layers->wires > 0) {
    for (std::vector<Vec3>& wire : arm_wires(rule_of(*layers, level_way(layers->azimuth)), length)) {
      const Vec3 way = normalized_or(wire[1] - wire[0], kUp);
      wire[1] = wire[0] + static_cast<float>(layers->wires) * way;
      lines.push_back({std::move(wire), 0.002});
    }
  }
  return lines;
}

const ElementKinds& operation_kinds() {
  static const ElementKinds kinds{
      .element = "an operation",
      .doc = "An operation on a tree as it grows.",
      .key = "do",
      .key_doc =
          "Kind of operation: 'cut' removes shoots, 'spur' and 'limit' keep them short, 'layers' trains an espalier, "
          "'support' ties to a line, 'mark' marks, 'girdle' rings, 'bend' bends and 'tie' draws shoots.",
      .kinds = {{"cut", cut_table},
                {"spur", spur_table},
                {"limit", length_limit_table},
                {"layers", layers_table},
                {"support", support_table},
                {"mark", mark_table},
                {"girdle", girdle_table},
                {"bend", bend_table},
                {"tie", tie_table}},
  };
  return kinds;
}

const ParameterTable& operation_table() {
  static const ParameterTable table = table_of_kinds(operation_kinds());
  return table;
}

bool is_shoot_name(std::string_view text) {
  if (!text.starts_with("main")) return false;
  text.remove_prefix(4);
  while (!text.empty()) {
    if (text[0] != '.') return false;
    const std::size_t digits = std::min(text.find('.', 1), text.size()) - 1;
    if (digits == 0 || digits > 9) return false;
    if (!std::ranges::all_of(text.substr(1, digits), [](char c) { return c >= '0' && c <= '9'; })) return false;
    text.remove_prefix(digits + 1);
  }
  return true;
}

}  // namespace meristem

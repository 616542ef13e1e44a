// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/organize_table.h"

#include <algorithm>

#include <fmt/format.h>

namespace meristem {

namespace {

const ParameterTable& direction_table() {
  static const ParameterTable table =
      Table<DirectionWeights>("directions", "What a new metamer's direction is made of, by weight.")
          .number("persistence", &DirectionWeights::persistence, {.min = 0, .max = 100},
                  "Of the direction so far; raised, straighter shoots.")
          .number("light", &DirectionWeights::light, {.min = -100, .max = 100}, "Of the way to light or room.")
          .number("up", &DirectionWeights::up, {.min = -100, .max = 100}, "Of straight up; negative: down.")
          .number("up_later", &DirectionWeights::up_later, {.min = -100, .max = 100},
                  "What 'up' comes to as the tree grows; below 0, new shoots hang.")
          .number("up_fade", &DirectionWeights::up_fade, {.min = 0, .max = 1},
                  "What is left of the difference of both after each iteration or order.")
          .boolean("fades_by_order", &DirectionWeights::fades_by_order,
                   "'up' fades with the branching order, and not with the iterations.")
          .only_where({{"up"}, {"up_later"}}, {"up_fade", "fades_by_order"});
  return table;
}

const ParameterTable& phyllotaxis_table() {
  static const ParameterTable table =
      Table<Phyllotaxis>("a phyllotaxis", "Where lateral buds stand on a shoot.")
          .choice("phyllotaxis", &Phyllotaxis::kind, {"spiral", "alternate", "decussate"},
                  "spiral: each bud turned by 'divergence'; alternate: in two rows; decussate: in crossed pairs.")
          .number("branching_angle", &Phyllotaxis::branching_angle, {.unit = Unit::degree, .min = 0, .max = 180},
                  "Between a shoot and its lateral buds.")
          .number("divergence", &Phyllotaxis::divergence, {.unit = Unit::degree, .min = -360, .max = 360},
                  "Turn of a spiral from bud to bud.")
          .number("jitter", &Phyllotaxis::jitter, {.unit = Unit::degree, .min = 0, .max = 60},
                  "By how much directions stray at random (standard deviation).")
          .only_where({{"phyllotaxis", {"spiral"}}}, {"divergence"});
  return table;
}

const ParameterTable& weights_table() {
  static const ParameterTable table =
      Table<PriorityWeights>("weights", "Over the rank of buds and laterals on an axis; the terminal bud is the first.")
          .number("highest", &PriorityWeights::highest, {.min = 0, .max = 1000, .above_min = true}, "Of the first.")
          .number("lowest", &PriorityWeights::lowest, {.min = 0, .max = 1000},
                  "Of the last; lowered, more goes to the leading shoots.")
          .number("reach", &PriorityWeights::reach, {.min = 0, .max = 1},
                  "Share of all over which weights fall from the one to the other.");
  return table;
}

const ParameterTable& resource_table() {
  static const ParameterTable table =
      Table<ResourceModel>("a resource model", "How light becomes resource and is divided among buds.")
          .choice("model", &ResourceModel::division, {"borchert_honda", "priority"},
                  "borchert_honda: at each fork; priority: along whole axes, by rank.")
          .number("alpha", &ResourceModel::alpha, {.min = 0, .max = 1000},
                  "Resource for each unit of light; raised, all grows faster.")
          .number("alpha0", &ResourceModel::alpha0, {.min = 0, .max = 1e6}, "Resource that needs no light.")
          .number("lambda", &ResourceModel::lambda, {.min = 0, .max = 1},
                  "Apical control: above 0.5 the terminal side of a fork has more, below the lateral one.")
          .curve("lambda_curve", &ResourceModel::lambda_curve,
                 "Factor on lambda over the age, from the seed (0) to 'maturity' (1).")
          .object("weights", &ResourceModel::weights, weights_table, "Of the priority model.")
          .integer("until", &ResourceModel::until, {.min = 0, .max = 65535},
                   "The priority model holds for so many iterations, then the other; 0: for all.")
          .integer("laterals", &ResourceModel::laterals, {.min = 0, .max = 1e6},
                   "It holds on axes with at most so many lateral shoots; 0: on all.")
          .number("pass_back", &ResourceModel::pass_back, {.min = 0, .max = 1},
                  "What each lateral takes of that which a damaged terminal bud passes back down its shoot.")
          .only_where({{"model", {"priority"}}}, {"weights", "until", "laterals"})
          .only_where({{"model", {"borchert_honda"}}, {"until"}, {"laterals"}}, {"lambda", "lambda_curve"});
  return table;
}

const ParameterTable& shedding_table() {
  static const ParameterTable table =
      Table<Shedding>("shedding", "Which shoots die for lack of light.")
          .number("below", &Shedding::below, {.min = 0, .max = 1000},
                  "Light of a shoot, a metamer, below which it is shed; raised, clearer stems. 0: none is.")
          .integer("after", &Shedding::after, {.min = 0, .max = 65535},
                   "Only shoots older than so many iterations are shed.")
          .only_with("below", {"after"});
  return table;
}

const ParameterTable& sag_table() {
  static const ParameterTable table =
      Table<Sag>("a sag", "How branches bend under their weight.")
          .number("stiffness", &Sag::stiffness, {.min = 0.001, .max = 1000},
                  "Modulus of elasticity in gigapascals: green wood has 4 to 12; lowered, branches hang.")
          .number("density", &Sag::density, {.min = 0, .max = 10000}, "Of green wood, kilograms a cubic metre.")
          .number("leaf_mass", &Sag::leaf_mass, {.min = 0, .max = 100},
                  "Kilograms that each metamer of the last iteration carries besides.");
  return table;
}

const ParameterTable& light_model_table() {
  static const ParameterTable table =
      Table<BudLightModel>("a light model", "What light buds have.")
          .choice("model", &BudLightModel::kind, {"shadow", "markers"},
                  "shadow: what the shade of all plants leaves of the light; markers: the free room that a bud sees.")
          .number("full", &BudLightModel::full, {.min = 0, .max = 1000}, "Light of a bud without any shade.")
          .number("voxel", &BudLightModel::voxel, {.unit = Unit::metre, .min = 0, .max = 1000},
                  "Across a cell of shade; 0: the length of a metamer.")
          .number("a", &BudLightModel::a, {.min = 0, .max = 5},
                  "Shade that a metamer as long as a cell casts in its own cell; raised, sparser crowns.")
          .number("b", &BudLightModel::b, {.min = 1, .max = 1000},
                  "By which shade is divided from cell to cell; raised, it fades sooner.")
          .integer("depth", &BudLightModel::depth, {.min = 0, .max = 64}, "How many cells below a metamer are shaded.")
          .integer("reach", &BudLightModel::reach, {.min = 1, .max = 4},
                   "Cells around a bud in which it feels where it gets brighter.")
          .number(
              "lean", &BudLightModel::lean, {.min = 0, .max = 1},
              "Whether shade falls as the light of the scene does (1) or straight down (0); lowered, trees lean less.")
          .number("spacing", &BudLightModel::spacing, {.min = 0.05, .max = 100},
                  "Between markers, in lengths of a metamer; lowered, finer and slower.")
          .number("occupancy", &BudLightModel::occupancy, {.min = 0, .max = 100},
                  "Around a metamer, where it takes the markers, in lengths; raised, sparser crowns.")
          .number("perception", &BudLightModel::perception, {.min = 0.1, .max = 100},
                  "How far buds see markers, in lengths of a metamer.")
          .number("cone", &BudLightModel::cone, {.unit = Unit::degree, .min = 1, .max = 360},
                  "Full angle of what a bud sees.")
          .boolean("counts", &BudLightModel::counts,
                   "Light is 'full' times the markers that a bud has got, and not 'full' for any.");
  return table;
}

const ParameterTable& schedule_table() {
  static const ParameterTable table =
      Table<Schedule>("a schedule", "When an operation acts.")
          .integer("at", &Schedule::at, {.min = 1, .max = 65535}, "The iteration, after whose growth it acts.")
          .required();
  return table;
}

void check_cut(const Cut& cut, const Place& place, ParameterReader& reader) {
  if (!is_shoot_name(cut.shoot)) {
    reader.fault(Place(place, "shoot"), fmt::format("'{}' names no shoot", cut.shoot),
                 "main, or the numbers of metamers at which shoots branch off: main.4.2");
  } else if (cut.shoot == "main" && cut.above == 0) {
    reader.fault(Place(place, "above"), "nothing would be left of the tree", "a whole number of at least 1");
  }
}

/// Growth names the place of what it cannot do.
template <class Kind>
void note_place(Kind& operation, const Place& place, ParameterReader&) {
  operation.path = place.text();
}

const ParameterTable& cut_table() {
  static const ParameterTable table =
      Table<Cut>("a cut", "Takes a shoot away, or what of it is above a metamer.")
          .members(&Cut::when, schedule_table())
          .text("shoot", &Cut::shoot,
                "By the numbers of the metamers at which shoots branch off: main.4.2; the stem is main.")
          .required()
          .integer("above", &Cut::above, {.min = 0, .max = 1e9},
                   "So many metamers of it stay; 0: the shoot goes whole.")
          .elsewhere({operation_kinds().key})
          .check(check_cut)
          .prepare(note_place<Cut>);
  return table;
}

}  // namespace

const ParameterTable& organize_light_table() {
  static const ParameterTable table =
      Table<OrganizeLight>("a light", "What light the buds have.")
          .members(&OrganizeLight::model, light_model_table())
          .object("room", &OrganizeLight::room, crown_table,
                  "Where markers are, over each root; everywhere if not given.")
          .only_where({{"model", {"shadow"}}}, {"voxel", "a", "b", "depth", "reach", "lean"})
          .only_where({{"model", {"markers"}}}, {"spacing", "occupancy", "perception", "cone", "counts", "room"});
  return table;
}

const Kinds& operation_kinds() {
  static const Kinds kinds{
      .element = "an operation",
      .doc = "What is done to a tree after the growth of an iteration.",
      .key = "do",
      .key_doc = "cut: takes a shoot away, or what of it is above a metamer.",
      .kinds = {{"cut", cut_table}},
  };
  return kinds;
}

const ParameterTable& operation_table() {
  static const ParameterTable table = table_of_kinds(operation_kinds());
  return table;
}

const ParameterTable& organize_growth_table() {
  static const ParameterTable table =
      Table<OrganizeParameters>("growth", "How trees organize themselves.")
          .integer("iterations", &OrganizeParameters::iterations, {.min = 0, .max = 65535},
                   "How long they grow; each lets a bud grow one shoot.")
          .integer("every", &OrganizeParameters::every, {.min = 1, .max = 10000},
                   "Steps that other plants of the stand take in one iteration.")
          .number("length", &OrganizeParameters::length, {.unit = Unit::metre, .min = 1e-4, .max = 1000},
                  "Of a metamer.")
          .boolean("stretch", &OrganizeParameters::stretch,
                   "Metamers are longer the more resource their shoot has over whole numbers of them, up to ten times.")
          .integer("longest_shoot", &OrganizeParameters::longest_shoot, {.min = 1, .max = 1000},
                   "Metamers that a bud grows in an iteration at most.")
          .integer("maturity", &OrganizeParameters::maturity, {.min = 1, .max = 65535},
                   "Iterations at which curves over the age end.")
          .object("resource", &OrganizeParameters::resource, resource_table,
                  "How light becomes resource and is divided among buds.")
          .number("terminal_threshold", &OrganizeParameters::terminal_threshold, {.min = 0, .max = 1000},
                  "Resource at which a terminal bud grows.")
          .number("lateral_threshold", &OrganizeParameters::lateral_threshold, {.min = 0, .max = 1000},
                  "The same for lateral buds; raised, fewer branches.")
          .boolean("laterals_wait", &OrganizeParameters::laterals_wait,
                   "A lateral bud opens only with or after the terminal one beside it.")
          .boolean("damage", &OrganizeParameters::damage, "Cut buds are damaged and never grow again; else they may.")
          .number("takeover", &OrganizeParameters::takeover, {.min = 0, .max = 100},
                  "How far a lateral beside a cut terminal bud turns to where that was going.")
          .object("direction", &OrganizeParameters::direction, direction_table,
                  "What a new metamer's direction is made of.")
          .object("stem", &OrganizeParameters::stem, direction_table, "The same for the stem, where it differs.")
          .members(&OrganizeParameters::phyllotaxis, phyllotaxis_table())
          .object("shedding", &OrganizeParameters::shedding, shedding_table, "Which shoots die for lack of light.")
          .object("sag", &OrganizeParameters::sag, sag_table,
                  "Lets branches bend under their weight, also into obstacles; if not given, they do not.");
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

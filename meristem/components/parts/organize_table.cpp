// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/parts/organize_table.h"

namespace meristem {

namespace {

const ParameterTable& direction_table() {
  static const ParameterTable table =
      Table<DirectionWeights>("directions", "Weights of the directions whose sum is the direction of a new metamer.")
          .number("persistence", &DirectionWeights::persistence, {.min = 0, .max = 100, .usual = {0, 2}},
                  "Weight of the direction so far; raised, straighter shoots.")
          .number("light", &DirectionWeights::light, {.min = -100, .max = 100},
                  "Weight of the direction to light or free room; raised, shoots turn to light or room more; negative, "
                  "away from it.")
          .number("up", &DirectionWeights::up, {.min = -100, .max = 100},
                  "Weight of straight up; raised, shoots rise more; negative, they turn down.")
          .number("up_later", &DirectionWeights::up_later, {.min = -100, .max = 100},
                  "Weight that 'up' approaches as the tree grows; below 0, later shoots hang.")
          .number("up_fade", &DirectionWeights::up_fade, {.min = 0, .max = 1},
                  "Share of the difference between 'up' and 'up_later' that remains after each iteration or order; "
                  "raised, a slower change.")
          .boolean("fades_by_order", &DirectionWeights::fades_by_order,
                   "Whether 'up' changes from the leader to branches and twigs instead of with the iterations.")
          .only_where({{"up"}, {"up_later"}}, {"up_fade", "fades_by_order"});
  return table;
}

const ParameterTable& phyllotaxis_table() {
  static const ParameterTable table =
      Table<Phyllotaxis>("a phyllotaxis", "Arrangement of lateral buds on a shoot.")
          .choice("phyllotaxis", &Phyllotaxis::kind, {"spiral", "alternate", "decussate"},
                  "Arrangement of lateral buds: 'spiral' turns each by 'divergence', 'alternate' sets two rows, "
                  "'decussate' crossed pairs.")
          .number("branching_angle", &Phyllotaxis::branching_angle,
                  {.unit = Unit::degree, .min = 0, .max = 180, .usual = {0, 120}},
                  "Branching angle between a shoot and its lateral buds; raised, branches stand off more.")
          .number("divergence", &Phyllotaxis::divergence,
                  {.unit = Unit::degree, .min = -360, .max = 360, .usual = {0, 180}},
                  "Divergence angle of a spiral: the turn about the shoot from bud to bud.")
          .number("jitter", &Phyllotaxis::jitter, {.unit = Unit::degree, .min = 0, .max = 60, .usual = {0, 20}},
                  "Standard deviation of the random turn of each new metamer; raised, more crooked shoots.")
          .only_where({{"phyllotaxis", {"spiral"}}}, {"divergence"});
  return table;
}

const ParameterTable& weights_table() {
  static const ParameterTable table =
      Table<PriorityWeights>("weights",
                             "Weights over the rank of buds and laterals on an axis; the terminal bud ranks first.")
          .number("highest", &PriorityWeights::highest, {.min = 0, .max = 1000, .above_min = true},
                  "Weight of the first rank, the terminal bud; raised, a stronger leading shoot.")
          .number("lowest", &PriorityWeights::lowest, {.min = 0, .max = 1000},
                  "Weight of the last ranks; lowered, more resource goes to the leading shoots.")
          .number("reach", &PriorityWeights::reach, {.min = 0, .max = 1},
                  "Share of the ranks over which the weight falls from highest to lowest; raised, more laterals grow "
                  "well.");
  return table;
}

const ParameterTable& resource_table() {
  static const ParameterTable table =
      Table<ResourceModel>("a resource model", "How light becomes resource and is divided among buds.")
          .choice("model", &ResourceModel::division, {"borchert_honda", "priority"},
                  "How resource is divided: 'borchert_honda' shares it out at each fork, 'priority' along whole axes "
                  "by rank.")
          .number("alpha", &ResourceModel::alpha, {.min = 0, .max = 1000, .usual = {0, 5}},
                  "Resource per unit of light; raised, the whole tree grows faster.")
          .number("alpha0", &ResourceModel::alpha0, {.min = 0, .max = 1e6},
                  "Resource of the whole tree that needs no light; raised, shaded trees still grow.")
          .number("lambda", &ResourceModel::lambda, {.min = 0, .max = 1, .usual = {0.3, 0.7}},
                  "Apical control: above 0.5 the terminal side of a fork is favoured, below it the lateral side.")
          .curve("lambda_curve", &ResourceModel::lambda_curve,
                 "Factor on lambda over the tree's age, from the seed (0) to 'maturity' (1).")
          .object("weights", &ResourceModel::weights, weights_table,
                  "Weights of buds and laterals by rank, for the model 'priority'.")
          .integer("until", &ResourceModel::until, {.min = 0, .max = 65535, .usual = {0, 40}},
                   "Number of iterations, from the first, in which the model 'priority' holds before 'borchert_honda'; "
                   "0 for all.")
          .integer(
              "laterals", &ResourceModel::laterals, {.min = 0, .max = 1e6, .usual = {0, 50}},
              "Largest number of lateral shoots on an axis for which the model 'priority' holds; 0 for any number.")
          .number(
              "pass_back", &ResourceModel::pass_back, {.min = 0, .max = 1},
              "Share that each lateral takes of the resource that a damaged terminal bud passes back down its shoot.")
          .only_where({{"model", {"priority"}}}, {"weights", "until", "laterals"})
          .only_where({{"model", {"borchert_honda"}}, {"until"}, {"laterals"}}, {"lambda", "lambda_curve"});
  return table;
}

const ParameterTable& shedding_table() {
  static const ParameterTable table =
      Table<BranchShedding>("shedding", "Shedding of shoots for lack of light or resource.")
          .number("below", &BranchShedding::below, {.min = 0, .max = 1000},
                  "Mean light per metamer below which a shoot is shed; raised, more bare stem; 0 sheds none.")
          .number("resource", &BranchShedding::resource, {.min = 0, .max = 1000, .usual = {0, 1}},
                  "Resource per metamer below which a shoot is shed; raised, shoots that their tree starves are shed "
                  "sooner; 0 sheds none.")
          .integer("after", &BranchShedding::after, {.min = 0, .max = 65535},
                   "Number of iterations that a shoot must have lived before it can be shed.")
          .only_where({{"below"}, {"resource"}}, {"after"});
  return table;
}

const ParameterTable& bearing_table() {
  static const ParameterTable table =
      Table<FruitBearing>("bearing", "Fruits on dormant lateral buds, and the resource that they take.")
          .number("cost", &FruitBearing::cost, {.min = 0, .max = 1000, .usual = {0, 2}},
                  "Resource that each fruit takes from the tree; raised, less growth, and fewer flowers in the next "
                  "year: the tree bears every other year.")
          .number(
              "threshold", &FruitBearing::threshold, {.min = 0, .max = 1000, .usual = {0, 2}},
              "Resource of a dormant lateral bud from which it flowers in the next iteration; raised, fewer fruits.")
          .integer("age", &FruitBearing::age, {.min = 0, .max = 65535, .usual = {0, 10}},
                   "Number of iterations from the growth of a bud until it may flower.");
  return table;
}

const ParameterTable& water_shoots_table() {
  static const ParameterTable table =
      Table<WaterShoots>("water shoots", "Vigorous shoots from dormant buds below large cuts.")
          .number("threshold", &WaterShoots::threshold, {.min = 0, .max = 1000, .usual = {0, 5}},
                  "Resource from which dormant lateral buds below a cut open; lowered, more water shoots.")
          .integer("cut", &WaterShoots::cut, {.min = 1, .max = 1e9, .usual = {1, 100}},
                   "Smallest number of metamers that a cut must have removed to be large.")
          .integer("within", &WaterShoots::within, {.min = 0, .max = 1e6, .usual = {0, 20}},
                   "Number of metamers below a cut, toward the root, whose buds may become water shoots.")
          .number("up", &WaterShoots::up, {.min = 0, .max = 100, .usual = {0, 3}},
                  "Weight of straight up in the directions of the first shoot that such a bud grows; raised, steeper.");
  return table;
}

const ParameterTable& sag_table() {
  static const ParameterTable table =
      Table<BranchSag>("a sag", "How branches bend under their weight.")
          .number("stiffness", &BranchSag::stiffness, {.min = 0.001, .max = 1000, .usual = {0.5, 20}},
                  "Modulus of elasticity in gigapascals, 4 to 12 in green wood; lowered, branches hang more.")
          .number("density", &BranchSag::density, {.min = 0, .max = 10000, .usual = {300, 1200}},
                  "Density of green wood in kilograms per cubic metre; raised, branches hang more.")
          .number("leaf_mass", &BranchSag::leaf_mass, {.min = 0, .max = 100},
                  "Mass of leaves in kilograms per metamer of the last iteration; raised, shoots hang more.");
  return table;
}

const ParameterTable& light_model_table() {
  static const ParameterTable table =
      Table<BudLightModel>("a light model", "Light or room that buds find.")
          .choice("model", &BudLightModel::kind, {"shadow", "markers"},
                  "What counts as light of a bud: with 'shadow', the light that the shade of all plants leaves; with "
                  "'markers', the free room that the bud sees.")
          .number("full", &BudLightModel::full, {.min = 0, .max = 1000},
                  "Light of a bud without any shade; raised, the tree grows faster.")
          .number("voxel", &BudLightModel::voxel, {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 0.5}},
                  "Edge length of a voxel of the shadow grid; 0 takes the length of a metamer. Raised, coarser and "
                  "farther reaching.")
          .number("a", &BudLightModel::a, {.min = 0, .max = 5},
                  "Shade that a metamer as long as a voxel casts in its own voxel; raised, sparser crowns.")
          .number("b", &BudLightModel::b, {.min = 1, .max = 1000, .usual = {1, 4}},
                  "Divisor of the shade from one layer of voxels to the next below it; raised, shade fades sooner.")
          .integer("depth", &BudLightModel::depth, {.min = 0, .max = 64, .usual = {0, 10}},
                   "Number of layers of voxels that a metamer shades below its own; raised, shade reaches farther and "
                   "costs more.")
          .integer("reach", &BudLightModel::reach, {.min = 1, .max = 4},
                   "Number of voxels around a bud within which it senses the direction of more light.")
          .number(
              "lean", &BudLightModel::lean, {.min = 0, .max = 1},
              "How shade falls: 0 straight down, 1 away from the scene's light; raised, trees lean more to that light.")
          .number("spacing", &BudLightModel::spacing, {.min = 0.05, .max = 100, .usual = {0.3, 2}},
                  "Edge length of the voxels with one marker each, in lengths of a metamer; lowered, finer and slower.")
          .number("occupancy", &BudLightModel::occupancy, {.min = 0, .max = 100, .usual = {0, 5}},
                  "Distance within which a metamer takes the markers, in lengths of a metamer; raised, sparser crowns.")
          .number(
              "perception", &BudLightModel::perception, {.min = 0.1, .max = 100, .usual = {1, 10}},
              "Distance within which a bud sees markers, in lengths of a metamer; raised, shoots turn to room earlier.")
          .number("cone", &BudLightModel::cone, {.unit = Unit::degree, .min = 1, .max = 360, .usual = {30, 180}},
                  "Full opening angle of the perception cone in which a bud sees markers.")
          .boolean("counts", &BudLightModel::counts,
                   "Whether light is 'full' per marker that a bud gets; otherwise 'full' for any number of them.");
  return table;
}

}  // namespace

const ParameterTable& organize_light_table() {
  static const ParameterTable table =
      Table<OrganizeLight>("a light", "Light or room that buds find.")
          .members(&OrganizeLight::model, light_model_table())
          .object("room", &OrganizeLight::room, crown_table,
                  "Envelope that shoots do not leave, relative to each root; markers exist only inside it.")
          .only_where({{"model", {"shadow"}}}, {"voxel", "a", "b", "depth", "reach", "lean"})
          .only_where({{"model", {"markers"}}}, {"spacing", "occupancy", "perception", "cone", "counts"});
  return table;
}

const ParameterTable& organize_growth_table() {
  static const ParameterTable table =
      Table<OrganizeParameters>("growth", "How trees grow from the competition of their buds.")
          .integer("iterations", &OrganizeParameters::iterations, {.min = 0, .max = 65535, .usual = {1, 40}},
                   "Number of iterations of growth; in each one, a bud can grow one shoot. Raised, an older tree.")
          .integer("every", &OrganizeParameters::every, {.min = 1, .max = 10000},
                   "Number of steps that other plants of the stand take per iteration of this tree; raised, the other "
                   "plants grow faster.")
          .number("length", &OrganizeParameters::length,
                  {.unit = Unit::metre, .min = 1e-4, .max = 1000, .usual = {0.02, 0.5}}, "Length of a metamer.")
          .boolean("stretch", &OrganizeParameters::stretch,
                   "Whether the metamers of a shoot lengthen, up to ten times, with the resource that exceeds a whole "
                   "number of them.")
          .integer("longest_shoot", &OrganizeParameters::longest_shoot, {.min = 1, .max = 1000, .usual = {1, 20}},
                   "Largest number of metamers that a bud grows per iteration.")
          .integer("maturity", &OrganizeParameters::maturity, {.min = 1, .max = 65535},
                   "Age of the tree, in iterations, at which the curves over its age end; raised, the tree changes "
                   "more slowly.")
          .object("resource", &OrganizeParameters::resource, resource_table,
                  "How light becomes resource and is divided among the buds.")
          .number("terminal_threshold", &OrganizeParameters::terminal_threshold, {.min = 0, .max = 1000},
                  "Resource from which a terminal bud grows; raised, shoots stop sooner.")
          .number("lateral_threshold", &OrganizeParameters::lateral_threshold, {.min = 0, .max = 1000, .usual = {0, 5}},
                  "Resource from which a lateral bud grows; raised, fewer branches.")
          .boolean("laterals_wait", &OrganizeParameters::laterals_wait,
                   "Whether a lateral bud opens only with or after the terminal bud beside it.")
          .boolean("damage", &OrganizeParameters::damage,
                   "Whether cut buds are damaged and never grow again; otherwise they may.")
          .number("summer", &OrganizeParameters::summer, {.min = 0.05, .max = 0.95},
                  "Share of an iteration's growth that comes before its summer operations; raised, less grows after "
                  "them.")
          .number("callus", &OrganizeParameters::callus, {.min = 0, .max = 100, .usual = {0, 1}},
                  "Swelling of the wood about cuts, as a share of the cross-sections of the cuts; raised, knuckles and "
                  "heads are thicker.")
          .number(
              "closure", &OrganizeParameters::closure, {.unit = Unit::metre, .min = 0, .max = 10, .usual = {0, 0.02}},
              "Decrease of the radius of open wounds per iteration; raised, wounds close sooner. The column 'wound' "
              "then has the radius that is still open.")
          .boolean("plan", &OrganizeParameters::plans,
                   "Whether the last iteration's winter operations are only planned: they are recorded, and the tree "
                   "stays as it was before them.")
          .number("takeover", &OrganizeParameters::takeover, {.min = 0, .max = 100},
                  "Weight of the lost axis's direction in the growth of a lateral beside the cut terminal bud; raised, "
                  "the lateral takes over more upright.")
          .object("direction", &OrganizeParameters::direction, direction_table,
                  "Weights of the directions whose sum is the direction of a new metamer.")
          .object("stem", &OrganizeParameters::stem, direction_table,
                  "Weights of the directions for the stem and for the shoots that lead after it; by default, those of "
                  "'direction'.")
          .members(&OrganizeParameters::phyllotaxis, phyllotaxis_table())
          .object("shedding", &OrganizeParameters::shedding, shedding_table,
                  "Shedding of shoots for lack of light or resource.")
          .object("bearing", &OrganizeParameters::bearing, bearing_table,
                  "Fruits on dormant buds, and the resource that they take; by default, trees bear none.")
          .object("water_shoots", &OrganizeParameters::water_shoots, water_shoots_table,
                  "Vigorous shoots below large cuts; by default, buds there open as others do.")
          .object("sag", &OrganizeParameters::sag, sag_table,
                  "Lets branches bend under their weight, also into obstacles; by default, they do not bend.");
  return table;
}

}  // namespace meristem

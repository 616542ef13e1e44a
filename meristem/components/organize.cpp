// SPDX-License-Identifier: Apache-2.0
// The component of self-organizing trees: makes its growth from its parameters, and emits leaves and supports.
#include "meristem/components/organize.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "meristem/base/math.h"
#include "meristem/components/expanded.h"
#include "meristem/components/parts/growth_scale.h"
#include "meristem/components/parts/organize_table.h"
#include "meristem/components/parts/pipe_table.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/plant/split_trees.h"
#include "meristem/scene/crown/placed_crown.h"
#include "meristem/shape/solid/primitives.h"

namespace meristem {

namespace {

constexpr double kMaxVoxelsAMetamer = 100;
constexpr double kMaxVoxels = 16;  // limit of a bud's range in voxels; memory of a round grows with its cube
constexpr double kEdge = 0.05;     // share of the threshold; within it, small changes decide whether a bud grows
constexpr int kRodSides = 8;       // sides of poles and wires

/// Returns the growth parameters with all lengths multiplied by `scale`. `axes` are the axes of the site's frame.
OrganizeParameters growth_of(const Organize& tree, double scale, const Mat3& axes) {
  OrganizeParameters growth = tree.growth;
  growth.length *= scale;
  growth.radii.tip_radius *= scale;
  growth.light = tree.light.model;
  growth.light.voxel *= scale;
  if (growth.closure) *growth.closure *= scale;
  int number = 0;
  const auto add = [&](const AnyOperation& operation) {
    ++number;
    if (common_of(operation).off) return;
    growth.operations.push_back(build_operation(operation, axes));
    growth.operations.back().number = number;
  };
  if (tree.training) std::ranges::for_each(tree.training->operations, add);
  std::ranges::for_each(tree.operations, add);
  growth.marks = mark_words(tree.operations);
  return growth;
}

/// The position of a tree in the component's frame.
struct RootPlace {
  Vec3 root{0};
  const Skeleton* wood = nullptr;  // existing wood in this frame; null: none
};

std::vector<RootPlace> places_of(const Organize& tree) {
  std::vector<RootPlace> places;
  for (const Vec3 root : tree.roots) {
    if (!tree.standing) places.push_back({root, nullptr});
    if (!tree.standing) continue;
    for (const Skeleton& wood : *tree.standing) places.push_back({root + wood.position[0], &wood});
  }
  return places;
}

/// Returns an existing tree as a seed needs it: with its root at the origin and in world axes.
std::shared_ptr<const Skeleton> standing_in(const Frame& frame, Skeleton wood, double scale) {
  const Vec3 root = wood.position[0];
  for (NodeIndex node = 0; node < wood.node_count(); ++node) {
    wood.position[node] = frame.axes * (wood.position[node] - root);
    wood.radius[node] *= static_cast<float>(scale);
  }
  return std::make_shared<const Skeleton>(std::move(wood));
}

std::unique_ptr<Grower> grow(const Organize& tree, const Site& site, const GrowContext& context) {
  const std::optional<double> scale = growth_scale(site.frame);
  if (!scale) return make_nothing();
  std::vector<OrganizeSeed> seeds;
  CrownPointer room = tree.light.room ? build_crown(*tree.light.room) : nullptr;
  if (room && site.frame.axes != Mat3(1)) room = std::make_shared<PlacedCrown>(std::move(room), Frame{site.frame.axes});
  for (const RootPlace& place : places_of(tree)) {
    OrganizeSeed& seed = seeds.emplace_back();
    seed.frame = site.frame;
    seed.frame.origin = site.frame.point(place.root);
    seed.room = room;
    if (place.wood != nullptr) seed.wood = standing_in(site.frame, *place.wood, *scale);
  }
  OrganizeParameters growth = growth_of(tree, *scale, site.frame.axes);
  growth.directions = context.directions;
  growth.keeps_fallen = context.keeps_fallen;
  growth.request = context.request;
  return make_organizer(context.stand, std::move(seeds), growth, site.key.child("growth"), context.scene,
                        context.limits, context.component);
}

/// Returns the share of its size that a leaf has before it falls: it withers at the pace at which it unfolds.
float share_withered(double left, const InstanceContext& instance) {
  if (!instance.grows_in_time()) return 1;
  const double unfold = instance.animation().unfold * *instance.animation().steps_per_second;
  const double u = unfold > 0 ? std::min(1.0, left / unfold) : 1;
  return static_cast<float>(u * u * (3 - 2 * u));
}

/// Offers a site for a leaf beside each lateral bud of young metamers. A tree that has stopped growing has no such
/// sites.
void offer_leaves(const Organize& tree, const Skeleton& skeleton, float scale, const InstanceContext& instance,
                  StemSink& stems, SiteSink& sites) {
  const std::vector<float>& angle = skeleton.extra.find("bud_angle")->second;
  const std::vector<float>& number = skeleton.extra.find("metamer")->second;
  const double youngest_bare = stems.grown_to(tree.growth.iterations) - tree.leaf_age;
  const auto along = static_cast<float>(math::cos(tree.leaf_angle));
  const auto aside = static_cast<float>(math::sin(tree.leaf_angle));
  std::vector<std::uint32_t> last(skeleton.axis_count(), 1);
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    last[skeleton.axis[node]] = std::max(last[skeleton.axis[node]], static_cast<std::uint32_t>(number[node]));
  }
  for (NodeIndex node = 0; node < skeleton.node_count(); ++node) {
    if (skeleton.is_root(node) || skeleton.birth[node] <= youngest_bare) continue;
    const Vec3 internode = skeleton.position[node] - skeleton.position[skeleton.parent[node]];
    const Vec3 axis = normalized_or(internode, kUp);
    const Vec3 side = bud_side(axis, angle[node]);
    const Vec3 bark = skeleton.position[node] + skeleton.radius[node] * side;
    Frame leaf = frame_along(bark, along * axis + aside * side, axis);
    leaf.axes *= scale * share_withered(skeleton.birth[node] - youngest_bare, instance);
    sites.add_on_stem(leaf, number[node] / static_cast<float>(last[skeleton.axis[node]]), glm::length(internode),
                      skeleton.radius[node], {node, 1});
  }
}

/// Emits a rod from one point to another, in the component's frame.
void show_rod(Vec3 from, Vec3 to, double radius, OrganSink& organs) {
  Frame frame = frame_along(from, normalized_or(to - from, kUp), Vec3(0, 0, 1));
  const auto thick = static_cast<float>(radius);
  frame.axes[0] *= thick;
  frame.axes[1] *= glm::distance(from, to);
  frame.axes[2] *= thick;
  organs.add_blade(frame, shape_key({kRodSides}), [] { return make_cylinder(1, 1, kRodSides); });
}

/// Emits the poles and wires of each tree, and each used support of the scene once.
void show_supports(const Organize& tree, const Frame& frame, const InstanceContext& instance, OrganSink& organs) {
  const Mat3 from_world = glm::inverse(frame.axes);
  const auto show_named = [&](const SupportParameters& support) {
    const auto found = instance.scene().supports.find(support.named);
    if (found == instance.scene().supports.end() || support.thickness <= 0) return;
    std::vector<Vec3> points = found->second;
    for (Vec3& point : points) point = from_world * (point - frame.origin);
    for (std::size_t k = 1; k < points.size(); ++k) {
      show_rod(points[k - 1], points[k], 0.5 * support.thickness, organs);
    }
  };
  const std::vector<RootPlace> places = places_of(tree);
  const auto show = [&](const AnyOperation& operation) {
    if (common_of(operation).off) return;
    if (const auto* support = std::get_if<SupportParameters>(&operation); support && !support->named.empty()) {
      return show_named(*support);
    }
    for (const SeenLine& line : seen_lines(operation, tree.growth.length)) {
      const std::optional<int>& number = common_of(operation).tree;
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (number && static_cast<std::size_t>(*number) != k) continue;
        for (std::size_t end = 1; end < line.points.size(); ++end) {
          show_rod(places[k].root + line.points[end - 1], places[k].root + line.points[end], line.radius, organs);
        }
      }
    }
  };
  if (tree.training) std::ranges::for_each(tree.training->operations, show);
  std::ranges::for_each(tree.operations, show);
}

void expand(const Organize& tree, const Site& site, const InstanceContext& instance, OrganSink& organs, StemSink& stems,
            SiteSink& sites) {
  const Skeleton skeleton = stems.take_grown();
  show_supports(tree, site.frame, instance, organs);
  stems.add(skeleton, tree.surface, {.trim = tree.trim, .pipe_exponent = tree.growth.radii.exponent});
  offer_leaves(tree, skeleton, glm::length(site.frame.heading()), instance, stems, sites);
}

/// Warns if small changes of a number would make a very different tree, or if nothing can grow.
void check_balance(const Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  const OrganizeParameters& growth = tree.growth;
  const BudLightModel& light = tree.light.model;
  if (light.kind == BudLightModel::Kind::markers && light.counts) return;
  const DocumentPath resource(path, "resource");
  const DocumentPath alpha(resource, "alpha");
  const double of_bud = growth.resource.alpha * light.full;
  if (of_bud + growth.resource.alpha0 < growth.terminal_threshold) {
    reader.warn(alpha,
                fmt::format("nothing will grow: a bud in full light makes a resource of {:.4g} and opens at {:.4g}",
                            of_bud + growth.resource.alpha0, growth.terminal_threshold));
    return;
  }
  if (growth.resource.division != ResourceModel::Division::borchert_honda || growth.resource.alpha0 != 0) return;
  if (std::abs(of_bud - growth.lateral_threshold) >= kEdge * growth.lateral_threshold) return;
  reader.warn(
      alpha,
      fmt::format(
          "growth is unstable here: a bud in full light makes a resource of {:.4g}, and lateral buds open at {:.4g}; "
          "small changes make trees with and without branches. Keep 'alpha' at least {:.0f} % away from this value",
          of_bud, growth.lateral_threshold, 100 * kEdge));
}

/// Warns of operations that never act. Does not warn if the number of iterations depends on a variable such as the
/// time.
void check_schedules(const Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  if (reader.numbers().is_worked_out(DocumentPath(path, "iterations"))) return;
  const DocumentPath operations(path, "operations");
  for (std::size_t k = 0; k < tree.operations.size(); ++k) {
    const OperationParameters& common = common_of(tree.operations[k]);
    const int first = common.at.value_or(common.from);
    if (common.off || first <= tree.growth.iterations) continue;
    const DocumentPath operation(operations, k);
    reader.warn(
        DocumentPath(operation, common.at ? "at" : "from"),
        fmt::format(
            "the operation never acts: growth ends after iteration {}, and the operation begins at iteration {}",
            tree.growth.iterations, first));
  }
}

/// Warns of parameters of cuts if no operation cuts.
void check_uncut(const Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  const auto cuts = [](const AnyOperation& operation) {
    return !common_of(operation).off &&
           (std::holds_alternative<CutParameters>(operation) || std::holds_alternative<SpurParameters>(operation) ||
            std::holds_alternative<LimitParameters>(operation) || std::holds_alternative<LayersParameters>(operation));
  };
  if (tree.training || tree.operations.empty() || std::ranges::any_of(tree.operations, cuts)) return;
  const OrganizeParameters plain;
  const auto warn = [&](const DocumentPath& at, const char* name) {
    reader.warn(at, fmt::format("'{}' has no effect: none of the operations cuts a shoot", name));
  };
  if (tree.growth.takeover != plain.takeover) warn(DocumentPath(path, "takeover"), "takeover");
  const DocumentPath resource(path, "resource");
  if (tree.growth.resource.pass_back != plain.resource.pass_back)
    warn(DocumentPath(resource, "pass_back"), "pass_back");
  if (!tree.growth.damage) warn(DocumentPath(path, "damage"), "damage");
  if (tree.growth.callus > 0) warn(DocumentPath(path, "callus"), "callus");
  if (tree.growth.closure) warn(DocumentPath(path, "closure"), "closure");
  if (tree.growth.water_shoots) warn(DocumentPath(path, "water_shoots"), "water_shoots");
}

/// Warns of lateral buds that need not wait but open with or after their terminal buds all the same.
void check_waiting(const Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  const OrganizeParameters& growth = tree.growth;
  const ResourceModel& resource = growth.resource;
  if (growth.laterals_wait || tree.light.model.kind != BudLightModel::Kind::shadow) return;
  if (resource.division != ResourceModel::Division::borchert_honda) return;
  constexpr int kSamples = 64;
  for (int k = 0; k <= kSamples; ++k) {
    if (resource.lambda * resource.lambda_curve(static_cast<double>(k) / kSamples) < 0.5) return;
  }
  if (growth.terminal_threshold > growth.lateral_threshold) return;
  reader.warn(
      DocumentPath(path, "laterals_wait"),
      fmt::format("'laterals_wait' has no effect: with a 'lambda' of at least 0.5, a terminal bud gets at least "
                  "the resource of the lateral bud beside it, and it opens at {:.4g}, the lateral bud at {:.4g}",
                  growth.terminal_threshold, growth.lateral_threshold));
}

/// Reports operations on trees that do not exist.
void check_trees(const Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  const std::size_t trees = places_of(tree).size();
  const DocumentPath operations(path, "operations");
  for (std::size_t k = 0; k < tree.operations.size(); ++k) {
    const std::optional<int>& number = common_of(tree.operations[k]).tree;
    if (!number || static_cast<std::size_t>(*number) < trees) continue;
    const DocumentPath operation(operations, k);
    reader.add_error(DocumentPath(operation, "tree"), fmt::format("there is no tree {}", *number),
                     fmt::format("a number of the trees at 'roots', from 0 to {}", trees - 1));
  }
}

void check_organize(const Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  const BudLightModel& light = tree.light.model;
  const DocumentPath light_place(path, "light");
  if (light.voxel > 0 && light.voxel * kMaxVoxelsAMetamer < tree.growth.length) {
    reader.add_error(DocumentPath(light_place, "voxel"), "the voxels are too small for metamers this long",
                     fmt::format("0, or a number (m) of at least {:.4g}", tree.growth.length / kMaxVoxelsAMetamer));
  }
  const double voxels = (std::max(light.perception, light.occupancy)) / light.spacing;
  if (light.kind == BudLightModel::Kind::markers && voxels > kMaxVoxels) {
    reader.add_error(
        DocumentPath(light_place, "spacing"), fmt::format("buds would look over {:.3g} markers each way", voxels),
        fmt::format("a number of at least {:.4g}", std::max(light.perception, light.occupancy) / kMaxVoxels));
  }
  check_schedules(tree, path, reader);
  check_uncut(tree, path, reader);
  check_waiting(tree, path, reader);
  check_balance(tree, path, reader);
}

void prepare_organize(Organize& tree, const DocumentPath& path, ParameterReader& reader) {
  const std::vector<std::string> words = mark_words(tree.operations);
  prepare_operations(tree.operations, words, DocumentPath(path, "operations"), reader);
  if (tree.training) prepare_training(*tree.training, tree.growth.length, DocumentPath(path, "training"), reader);
  if (tree.skeleton) {
    std::optional<Skeleton> standing = read_skeleton(*tree.skeleton, DocumentPath(path, "skeleton"), reader);
    if (!standing) return;
    fill_radii(*standing, tree.growth.radii);
    tree.standing = std::make_shared<const std::vector<Skeleton>>(split_trees(*standing));
  }
  check_trees(tree, path, reader);
}

}  // namespace

Value expanded_training(const Prototype& component) {
  if (component.type->name != "organize") return {};
  const auto& tree = *static_cast<const Organize*>(component.parameters.get());
  return tree.training ? Value(training_operations(*tree.training, tree.growth.length)) : Value();
}

std::optional<int> last_iteration(const Prototype& component) {
  if (component.type->name != "organize") return std::nullopt;
  return static_cast<const Organize*>(component.parameters.get())->growth.iterations;
}

bool leans_in_vain(const Prototype& component, const Light& light) {
  if (component.type->name != "organize") return false;
  const BudLightModel& model = static_cast<const Organize*>(component.parameters.get())->light.model;
  if (model.kind != BudLightModel::Kind::shadow || model.lean == BudLightModel().lean) return false;
  return glm::distance(light.mean_direction(), kUp) < 1e-6F;
}

ComponentType organize_component() {
  return define_component<Organize>({
      .traits = {.name = "organize",
                 .doc = "Trees whose buds compete for light and room, metamer by metamer (self-organizing).",
                 .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
                 .blades = {.material = {.colour = {0.45F, 0.42F, 0.38F}, .roughness = 0.7F}},
                 .grows_in_time = true,
                 .makes_stems = true,
                 .has_ribs = true,
                 .stance = BranchStance::on_axis,
                 .after_growth = {"surface", "trim", "leaf_age", "leaf_angle"}},
      .parameters =
          Table<Organize>("an organize", "Trees whose buds compete for light and room.")
              .members(&Organize::growth, organize_growth_table())
              .object("light", &Organize::light, organize_light_table, "Light or room that buds find.")
              .positions("roots", &Organize::roots, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-20, 20}},
                         "Positions of the trees; they compete with each other for light and room.")
              .object("skeleton", &Organize::skeleton, skeleton_source_table,
                      "Tree from a file that stands at each of 'roots' already and goes on growing; by default, trees "
                      "begin as seeds.")
              .list_of_kinds("operations", &Organize::operations, operation_kinds, operation_table,
                             "Cuts and other operations on the trees as they grow, in this order.")
              .object("training", &Organize::training, training_table,
                      "Training system: a list of operations before those of 'operations', made of a few parameters.")
              .integer("leaf_age", &Organize::leaf_age, {.min = 0, .max = 1000},
                       "Number of last iterations whose metamers offer a site for a leaf; raised, leaves "
                       "also stand on older wood.")
              .number("leaf_angle", &Organize::leaf_angle, {.unit = Unit::degree, .min = 0, .max = 180},
                      "Angle between a shoot and its leaves.")
              .members(&Organize::growth, &OrganizeParameters::radii, pipe_table())
              .object("surface", &Organize::surface, surface_table, "How the skeleton becomes a surface.")
              .choice("trim", &Organize::trim, trim_modes(), kTrimDoc)
              .only_where({{"surface.style", {"tubes"}}}, {"texture"})
              .without(names_off_stems(), kWhyOffStems)
              .only_where({{"operations"}, {"training"}},
                          {"damage", "takeover", "resource.pass_back", "plan", "callus", "closure", "water_shoots"})
              .only_where({{"operations"}}, {"summer"})
              .only_where({{"damage", {true}}}, {"takeover", "resource.pass_back"})
              .only_where({{"resource.lambda_curve"}}, {"maturity"})
              .only_where({{"shedding"}, {"operations"}, {"training"}}, {"memory"})
              .check(check_organize)
              .prepare(prepare_organize),
      .expand = expand,
      .grow = grow,
  });
}

}  // namespace meristem

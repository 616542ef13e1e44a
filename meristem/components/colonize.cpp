// SPDX-License-Identifier: Apache-2.0
// The component of colonizing trees: makes seedlings and growth from its parameters, and emits the grown stems.
#include "meristem/components/colonize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "meristem/components/parts/finish_table.h"
#include "meristem/components/parts/growth_scale.h"
#include "meristem/components/parts/limit_table.h"
#include "meristem/components/parts/pipe_table.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/graph/table/node_condition.h"
#include "meristem/plant/growth_in_time.h"
#include "meristem/plant/shed.h"

namespace meristem {

namespace {

RootsInCrowns roots_of(const Colonize& tree) { return {tree.crown, tree.points, tree.roots, tree.one_crown}; }

/// Returns the growth parameters with all lengths multiplied by `scale`.
ColonizeParameters growth_of(const Colonize& tree, double scale) {
  ColonizeParameters growth = tree.growth;
  growth.step *= scale;
  growth.influence *= scale;
  growth.kill *= scale;
  growth.radii.tip_radius *= scale;
  growth.light = tree.light.response;
  growth.light.shift = tree.light.shift_m ? scale * *tree.light.shift_m : tree.light.shift * growth.step;
  growth.light.drift = tree.light.drift * growth.step;
  growth.light.field = tree.light.field * growth.step;
  growth.light.limit.radius *= scale;
  if (growth.light.shade) growth.light.shade->form.voxel *= scale;
  return growth;
}

/// Throws InputError if no world above the tree has a field that can carry its points.
void require_field(const GrowContext& context) {
  if (context.directions.light_sense().has_given() || context.directions.gravity_sense().has_given()) return;
  throw InputError(
      Diagnostic{.message = "'field' has no meaning here: no world above the tree has a field of light or gravity",
                 .expected = "a 'world' with a field above the tree, or no 'field'",
                 .path = "components." + context.component + ".light.field"});
}

std::unique_ptr<Grower> grow(const Colonize& tree, const Site& site, const GrowContext& context) {
  const std::optional<double> scale = growth_scale(site.frame);
  if (!scale) return make_nothing();
  std::vector<PointsOfRoot> all = points_of_roots(roots_of(tree), site.key.child("points"), context);
  std::vector<Seedling> seedlings;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Frame crown{site.frame.axes, site.frame.point(all[k].base)};
    for (Vec3& point : all[k].points) point = crown.point(point);
    seedlings.push_back({.root = site.frame.point(tree.roots[k]), .points = std::move(all[k].points)});
  }
  ColonizeParameters growth = growth_of(tree, *scale);
  growth.directions = context.directions;
  if (growth.light.field != 0) require_field(context);
  growth.request = context.request;
  return make_colonizer(context.stand, std::move(seedlings), growth, site.key.child("growth"), context.scene,
                        context.limits, context.component, context.progress);
}

void expand(const Colonize& tree, const Site& site, const InstanceContext& instance, StemSink& stems) {
  Skeleton skeleton = stems.take_grown();
  const bool is_film = instance.grows_in_time();
  std::vector<std::uint8_t> shed;
  if (tree.shed) {
    shed = nodes_where(skeleton, SkeletonAxes(skeleton), *tree.shed, site.key.child("shed"), &instance.scene(),
                       &instance.progress());
  }
  if (tree.shed && is_film) {
    let_fall(skeleton, shed, instance.animation().hold * *instance.animation().steps_per_second);
  } else if (tree.shed) {
    skeleton = shed_branches(skeleton, shed);
    assign_pipe_radii(skeleton, tree.growth.radii);
    assign_axes(skeleton);
  }
  stems.add(std::move(skeleton), tree.surface, {.trim = tree.trim, .pipe_exponent = tree.growth.radii.exponent});
}

MinimumCounts minimum_counts(const Colonize& tree, const KnownMembers& known) {
  // A limit on light removes points before growth.
  if (tree.light.response.limit.share > 0 || known.varies(member_of(tree, &Colonize::light))) return {};
  if (tree.points.file) return {.points = tree.crown ? 0 : static_cast<double>(tree.points.file->size())};
  const double crowns = roots_of(tree).share_points() ? 1 : static_cast<double>(tree.roots.size());
  return {.points = crowns * known.minimum(member_of(tree, &Colonize::points, &PointsParameters::count))};
}

/// Warns if no root can reach its crown within the iterations. Compares with the box around the crown, so it misses
/// crowns that are only just out of reach.
void warn_of_bare_stems(const Colonize& tree, const DocumentPath& path, ParameterReader& reader) {
  if (!tree.crown || tree.points.file || tree.roots.empty()) return;
  if (reader.numbers().is_worked_out(DocumentPath(path, "iterations"))) return;
  const CrownPointer crown = build_crown(*tree.crown);
  if (crown->bounds().is_empty()) return;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3 root : tree.roots) {
    const Vec3 from = roots_of(tree).share_points() ? root : Vec3(0);
    const Vec3 gap = from - glm::clamp(from, crown->bounds().low, crown->bounds().high);
    nearest = std::min(nearest, std::sqrt(squared_length(DVec3(gap))));
  }
  const double reached = tree.growth.iterations * tree.growth.step + tree.growth.influence;
  if (!(nearest > reached)) return;
  reader.warn(DocumentPath(path, "iterations"),
              fmt::format("growth ends in the trunk: the crown begins {:.4g} m from the root, and {} steps of {:.4g} m "
                          "with the influence distance of {:.4g} m reach {:.4g} m",
                          nearest, tree.growth.iterations, tree.growth.step, tree.growth.influence, reached));
}

void check_colonize(const Colonize& tree, const DocumentPath& path, ParameterReader& reader) {
  check_cloud(tree.crown, tree.points, roots_of(tree).share_points() ? 1 : tree.roots.size(), "a colonize", path,
              reader);
  const ColonizeParameters& growth = tree.growth;
  if (growth.kill >= growth.influence) {
    reader.add_error(
        DocumentPath(path, "kill"),
        fmt::format("'kill' {:.7g} m is not below 'influence' {:.7g} m, so points would vanish before they pull",
                    growth.kill, growth.influence),
        fmt::format("a number (m) below {:.7g}", growth.influence));
  }
  if (growth.step > growth.kill) {
    reader.add_error(DocumentPath(path, "step"),
                     fmt::format("'step' {:.7g} m is above 'kill' {:.7g} m, so nodes would jump over the points",
                                 growth.step, growth.kill),
                     fmt::format("a number (m) of at most {:.7g}", growth.kill));
  }
  warn_of_bare_stems(tree, path, reader);
}

const ParameterTable& shade_form_table() {
  static const ParameterTable table =
      Table<ShadowParameters>("a shadow form", "How shade falls.")
          .number("voxel", &ShadowParameters::voxel, {.unit = Unit::metre, .min = 0.02, .max = 1000},
                  "Edge length of a voxel of the shadow grid; raised, shade is coarser and reaches farther.")
          .number("a", &ShadowParameters::amount, {.min = 0, .max = 5},
                  "Shade that a shoot as long as a voxel casts in its own voxel; 1 is darkness.")
          .number("b", &ShadowParameters::base, {.min = 1, .max = 1000, .usual = {1, 3}},
                  "Divisor of the shade from one layer of voxels to the next below it; raised, shade fades sooner.")
          .integer("depth", &ShadowParameters::depth, {.min = 0, .max = 64, .usual = {0, 24}},
                   "Number of layers of voxels that a shoot shades below its own; raised, shade reaches farther and "
                   "costs more.");
  return table;
}

/// Warns of shade to which a tree cannot respond, because the form of the shade then has no effect.
void warn_of_idle_shade(const ShadeResponse& shade, const DocumentPath& path, ParameterReader& reader) {
  if (shade.bears > 0 && shade.form.amount > 0) return;
  const char* const name = shade.bears > 0 ? "a" : "bears";
  reader.warn(DocumentPath(path, name),
              fmt::format("the shade has no effect, and neither have 'voxel', 'a', 'b' and 'depth': '{}' is 0", name));
}

const ParameterTable& shade_table() {
  static const ParameterTable table =
      Table<ShadeResponse>("a shade response",
                           "Response of the tree to the shade that all plants of the stand cast as they grow.")
          .number("bears", &ShadeResponse::bears, {.min = 0, .max = 1},
                  "Light below which points do not pull, from 1 in the open to 0 in darkness; raised, the tree "
                  "tolerates less shade.")
          .members(&ShadeResponse::form, shade_form_table())
          .check(warn_of_idle_shade);
  return table;
}

const ParameterTable& response_table() {
  static const ParameterTable table =
      Table<LightResponse>("a light response", "Response of the tree to the light of the scene.")
          .number("sunlit_weight", &LightResponse::sunlit_weight, {.min = 0, .max = 100, .usual = {0, 2}},
                  "Weight of light that reaches a node, relative to light that an obstacle blocks (1); raised, "
                  "branches turn to the sun more strongly.")
          .boolean("hold_height", &LightResponse::hold_height,
                   "Whether the top of the attraction points keeps its height while they move toward the light.")
          .object("limit", &LightResponse::limit, limit_table,
                  "Removes the attraction points in the deepest shade before growth begins.")
          .object("shade", &LightResponse::shade, shade_table,
                  "Lets the plants of the stand shade each other as they grow; by default, they do not.");
  return table;
}

const ParameterTable& light_table() {
  static const ParameterTable table =
      Table<LightResponseParameters>("a light response", "Response of the tree to the light of the scene.")
          .number("shift", &LightResponseParameters::shift, {.unit = Unit::step, .min = 0, .max = 1, .usual = {0, 0.2}},
                  "Distance that all attraction points together move per step toward more light; raised, the tree "
                  "leans more.")
          .number("shift_m", &LightResponseParameters::shift_m,
                  {.unit = Unit::metre, .min = 0, .max = 1000, .usual = {0, 0.02}},
                  "Distance in metres that all attraction points together move per step toward more light; replaces "
                  "'shift'.")
          .number("drift", &LightResponseParameters::drift, {.unit = Unit::step, .min = 0, .max = 1, .usual = {0, 0.2}},
                  "Distance that each attraction point moves per step, in the direction in which its nearest node "
                  "finds more light; raised, branches turn to the light more.")
          .number("field", &LightResponseParameters::field, {.unit = Unit::step, .min = 0, .max = 1},
                  "Distance that each attraction point moves per step along the fields of the worlds above the tree, "
                  "such as a wind of strength 1; raised, the wind carries the crown farther.")
          .members(&LightResponseParameters::response, response_table())
          .never_with("shift", {"shift_m"})
          .only_where({{"shift"}, {"shift_m"}, {"drift"}}, {"sunlit_weight"})
          .only_where({{"shift"}, {"shift_m"}, {"drift"}, {"field"}}, {"hold_height"});
  return table;
}

const ParameterTable& growth_table() {
  static const ParameterTable table =
      Table<ColonizeParameters>("growth", "How the skeleton grows.")
          .number("step", &ColonizeParameters::step, {.unit = Unit::metre, .min = 0, .max = 1000, .above_min = true},
                  "Distance between nodes, which a branch grows per step; lowered, finer branches and slower growth.")
          .number("influence", &ColonizeParameters::influence,
                  {.unit = Unit::metre, .min = 0, .max = 1e6, .above_min = true},
                  "Influence distance, within which an attraction point pulls the nearest node; raised, smoother and "
                  "fewer branches.")
          .number("kill", &ColonizeParameters::kill, {.unit = Unit::metre, .min = 0, .max = 1e6, .above_min = true},
                  "Kill distance, within which a node uses up an attraction point; lowered, denser twigs.")
          .integer("iterations", &ColonizeParameters::iterations, {.min = 1, .max = 1e6},
                   "Largest number of growth steps; growth ends earlier when no attraction points are left in reach.")
          .vector("bias", &ColonizeParameters::bias, {.min = -100, .max = 100},
                  "Vector added to each growth direction; [0, 0.2, 0] makes all branches grow upward a little.")
          .in_space(InSpace::direction)
          .object("finish", &ColonizeParameters::finish, finish_table,
                  "What is done to the skeleton after growth: nodes removed, forks softened, curves smoothed.");
  return table;
}

}  // namespace

ComponentType colonize_component() {
  return define_component<Colonize>({
      .traits = {.name = "colonize",
                 .doc = "A tree that grows into a cloud of attraction points (space colonization).",
                 .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
                 .grows_in_time = true,
                 .makes_stems = true,
                 .stance = BranchStance::on_axis,
                 .after_growth = {"surface", "trim", "shed"}},
      .parameters =
          Table<Colonize>("a colonize", "A tree that grows into a cloud of attraction points.")
              .object("crown", &Colonize::crown, crown_table,
                      "Envelope that the attraction points fill; required unless the points come from a file.")
              .object("points", &Colonize::points, points_table,
                      "Number, distribution or file of the attraction points.")
              .positions(
                  "roots", &Colonize::roots, {.unit = Unit::metre, .min = -1e5, .max = 1e5, .usual = {-20, 20}},
                  "Positions of the trees; each has its own crown unless 'one_crown' is set, and all compete for "
                  "points.")
              .boolean("one_crown", &Colonize::one_crown,
                       "Whether all roots share one crown, which stands at the component's origin.")
              .members(&Colonize::growth, growth_table())
              .object("light", &Colonize::light, light_table, "Response of the tree to the light of the scene.")
              .members(&Colonize::growth, &ColonizeParameters::radii, pipe_table())
              .condition("shed", &Colonize::shed, node_variables(),
                         "Condition at the base of a branch for shedding it after growth, as in \"height < 2 && radius "
                         "< 0.01\".")
              .object("surface", &Colonize::surface, surface_table, "How the skeleton becomes a surface.")
              .choice("trim", &Colonize::trim, trim_modes(), kTrimDoc)
              .only_where({{"surface.style", {"tubes"}}}, {"texture"})
              .without(names_off_stems(), kWhyOffStems)
              .only_with("roots", {"one_crown"})
              .only_with("shed", {"memory"})
              .check(check_colonize),
      .expand = expand,
      .grow = grow,
      .minimum_counts = minimum_counts,
  });
}

}  // namespace meristem

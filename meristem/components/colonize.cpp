// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/colonize.h"

#include <fmt/format.h>

#include "meristem/components/parts/growth_scale.h"
#include "meristem/components/parts/limit_table.h"
#include "meristem/components/parts/pipe_table.h"
#include "meristem/components/parts/surface_table.h"
#include "meristem/graph/table/node_condition.h"
#include "meristem/plant/shed.h"

namespace meristem {

namespace {

/// Whether all roots grow into the same points.
bool shares_points(const Colonize& tree) { return tree.one_crown || tree.points.file; }

/// The points of one crown or file, moved to the world.
std::vector<Vec3> points_at(const Colonize& tree, const Frame& frame, RandomKey key, const GrowContext& context) {
  std::vector<Vec3> points = make_points(tree.crown, tree.points, key, context);
  for (Vec3& point : points) point = frame.point(point);
  return points;
}

/// With all lengths to `scale`.
ColonizeParameters growth_of(const Colonize& tree, double scale) {
  ColonizeParameters growth = tree.growth;
  growth.step *= scale;
  growth.influence *= scale;
  growth.kill *= scale;
  growth.radii.tip_radius *= scale;
  growth.light = tree.light.response;
  growth.light.shift = tree.light.shift_m ? scale * *tree.light.shift_m : tree.light.shift * growth.step;
  growth.light.drift = tree.light.drift * growth.step;
  growth.light.limit.radius *= scale;
  if (growth.light.shade) growth.light.shade->form.voxel *= scale;
  return growth;
}

std::unique_ptr<Grower> grow(const Colonize& tree, const Site& site, const GrowContext& context) {
  const std::optional<double> scale = growth_scale(site.frame);
  if (!scale) return make_nothing();
  const RandomKey key = site.key.child("points");
  const bool shares = shares_points(tree);
  std::vector<Seedling> seedlings;
  for (const Vec3 root : tree.roots) {
    Seedling& seedling = seedlings.emplace_back();
    seedling.root = site.frame.point(root);
    const std::size_t k = seedlings.size() - 1;
    const Frame crown{site.frame.axes, seedling.root};
    if (!shares) seedling.points = points_at(tree, crown, k == 0 ? key : key.child(k), context);
  }
  if (shares) seedlings[0].points = points_at(tree, site.frame, key, context);
  return make_colonizer(context.stand, std::move(seedlings), growth_of(tree, *scale), site.key.child("growth"),
                        context.scene, context.limits, context.component, context.progress);
}

void expand(const Colonize& tree, const Site& site, Emitter& out) {
  Skeleton skeleton = out.take_grown();
  if (tree.shed) {
    skeleton = shed_branches(skeleton, nodes_where(skeleton, Axes(skeleton), *tree.shed, site.key.child("shed")));
    assign_pipe_radii(skeleton, tree.growth.radii);
    assign_axes(skeleton);
  }
  out.stem(std::move(skeleton), tree.surface);
}

void check_colonize(const Colonize& tree, const Place& place, ParameterReader& reader) {
  check_cloud(tree.crown, tree.points, shares_points(tree) ? 1 : tree.roots.size(), "a colonize", place, reader);
  const ColonizeParameters& growth = tree.growth;
  if (growth.kill >= growth.influence) {
    reader.fault(Place(place, "kill"),
                 fmt::format("'kill' {:.7g} m is not below 'influence' {:.7g} m, so points would go before they pull",
                             growth.kill, growth.influence),
                 fmt::format("a number (m) below {:.7g}", growth.influence));
  }
  if (growth.step > growth.kill) {
    reader.fault(Place(place, "step"),
                 fmt::format("'step' {:.7g} m is above 'kill' {:.7g} m, so nodes would jump over the points",
                             growth.step, growth.kill),
                 fmt::format("a number (m) of at most {:.7g}", growth.kill));
  }
}

const ParameterTable& shade_form_table() {
  static const ParameterTable table =
      Table<ShadowForm>("a shadow form", "How shade falls.")
          .number("voxel", &ShadowForm::voxel, {.unit = Unit::metre, .min = 0.02, .max = 1000},
                  "Across a cell of shade; raised, coarser and farther reaching.")
          .number("a", &ShadowForm::amount, {.min = 0, .max = 5},
                  "Shade that a shoot as long as a cell casts in its own cell; 1 is darkness.")
          .number("b", &ShadowForm::base, {.min = 1, .max = 1000},
                  "By which shade is divided from cell to cell; raised, it fades sooner.")
          .integer("depth", &ShadowForm::depth, {.min = 0, .max = 64}, "How many cells below a shoot are shaded.");
  return table;
}

const ParameterTable& shade_table() {
  static const ParameterTable table =
      Table<ShadeResponse>("a shade response", "The shade of all plants of the stand as they grow.")
          .number("bears", &ShadeResponse::bears, {.min = 0, .max = 1},
                  "Light below which points do not pull, from 1 in the open to 0 in darkness; raised, less tolerant.")
          .members(&ShadeResponse::form, shade_form_table());
  return table;
}

const ParameterTable& response_table() {
  static const ParameterTable table =
      Table<LightResponse>("a light response", "How the tree answers to the light of the scene.")
          .number("sunlit_weight", &LightResponse::sunlit_weight, {.min = 0, .max = 100},
                  "How strongly nodes in the light feel it; those in the shade of obstacles do with strength 1.")
          .boolean("hold_height", &LightResponse::hold_height, "Keeps the points' top at its height while they move.")
          .object("limit", &LightResponse::limit, limit_table, "Leaves out the points that lie in the deepest shade.")
          .object("shade", &LightResponse::shade, shade_table,
                  "Lets the plants of the stand shade each other as they grow.");
  return table;
}

const ParameterTable& light_table() {
  static const ParameterTable table =
      Table<LightForm>("a light response", "How the tree answers to the light of the scene.")
          .number("shift", &LightForm::shift, {.unit = Unit::step, .min = 0, .max = 1},
                  "By how much all points move toward brighter places in a step; raised, a stronger lean.")
          .number("shift_m", &LightForm::shift_m, {.unit = Unit::metre, .min = 0, .max = 1000},
                  "The same in metres, in its stead.")
          .number("drift", &LightForm::drift, {.unit = Unit::step, .min = 0, .max = 1},
                  "By how much each point moves to where it gets brighter for the node that it pulls.")
          .members(&LightForm::response, response_table())
          .never_with("shift", {"shift_m"})
          .only_where({{"shift"}, {"shift_m"}, {"drift"}}, {"sunlit_weight", "hold_height"});
  return table;
}

const ParameterTable& finish_table() {
  static const ParameterTable table =
      Table<Finish>("a finish", "What is done to the skeleton after growth, in this order.")
          .number("decimate", &Finish::decimate, {.unit = Unit::step, .min = 0, .max = 1000},
                  "Removes nodes along branches over this length; 4 keeps about every fourth, 0 all.")
          .boolean("relax", &Finish::relax, "Moves each node half way to its parent, which softens forks.")
          .number("subdivide", &Finish::subdivide, {.unit = Unit::step, .min = 0, .max = 1000},
                  "Spacing of the final nodes along smooth curves; 0 keeps the nodes as they are.");
  return table;
}

const ParameterTable& growth_table() {
  static const ParameterTable table =
      Table<ColonizeParameters>("growth", "How the skeleton grows.")
          .number("step", &ColonizeParameters::step, {.unit = Unit::metre, .min = 0, .max = 1000, .above_min = true},
                  "Between nodes; lowered, finer and slower.")
          .number("influence", &ColonizeParameters::influence,
                  {.unit = Unit::metre, .min = 0, .max = 1e6, .above_min = true},
                  "Within which a point pulls a node; raised, smoother branches.")
          .number("kill", &ColonizeParameters::kill, {.unit = Unit::metre, .min = 0, .max = 1e6, .above_min = true},
                  "Within which a node uses a point up; lowered, denser twigs.")
          .integer("iterations", &ColonizeParameters::iterations, {.min = 1, .max = 1e6}, "At most so many steps.")
          .vector("bias", &ColonizeParameters::bias, {.min = -100, .max = 100},
                  "Added to each growth direction; [0, 0.2, 0] makes all grow upward a little.")
          .object("finish", &ColonizeParameters::finish, finish_table, "What is done to the skeleton after growth.");
  return table;
}

}  // namespace

ComponentType colonize_component() {
  return define_component<Colonize>({
      .traits = {.name = "colonize",
                 .doc = "A tree that grows into a cloud of attraction points (space colonization).",
                 .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
                 .makes_stems = true,
                 .stance = BranchStance::on_axis,
                 .after_growth = {"surface", "shed"}},
      .parameters = Table<Colonize>("a colonize", "A tree that grows into a cloud of attraction points.")
                        .object("crown", &Colonize::crown, crown_table,
                                "The envelope that the points fill; needed unless they come from a file.")
                        .object("points", &Colonize::points, points_table, "The attraction points.")
                        .places("roots", &Colonize::roots, {.unit = Unit::metre, .min = -1e5, .max = 1e5},
                                "Where trees of this kind stand; each has its crown, and they compete.")
                        .boolean("one_crown", &Colonize::one_crown,
                                 "One crown over the component's place, which all roots grow into.")
                        .members(&Colonize::growth, growth_table())
                        .object("light", &Colonize::light, light_table, "How the tree answers to the light.")
                        .members(&Colonize::growth, &ColonizeParameters::radii, pipe_table())
                        .condition("shed", &Colonize::shed, node_variables(),
                                   "Branches that are gone when growth is done: the condition holds where they began, "
                                   "as in \"height < 2 && radius < 0.01\".")
                        .object("surface", &Colonize::surface, surface_table, "How the stems are clothed.")
                        .only_where({{"surface.style", {"tubes"}}}, {"texture"})
                        .without(names_off_stems(), kWhyOffStems)
                        .only_with("roots", {"one_crown"})
                        .only_with("shed", {"memory"})
                        .check(check_colonize),
      .expand = expand,
      .grow = grow,
  });
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/tree.h"

#include "meristem/components/parts/surface_table.h"

namespace meristem {

namespace {

/// Returns the stem without any bends.
Skeleton straight_stem(const StemParameters& form, const Site& site) {
  Skeleton skeleton;
  NodeIndex last = kNoNode;
  for (int k = 0; k <= form.segments; ++k) {
    const auto along = static_cast<float>(form.length * k / form.segments);
    last = skeleton.add_node(last, site.frame.point({0, along, 0}), 0);
  }
  return skeleton;
}

/// Returns the bends of a stem caused by its branches. The branches have the positions of links without their own keys.
/// These depend only on lengths, not on the stem's bends.
std::vector<StemBend> deflections(const Tree& tree, const Site& site, const InstanceContext& instance,
                                  const StemSink& stems) {
  BranchPlacement outward = tree.branching;
  outward.angle = kPi / 2;
  outward.angle_tip.reset();
  outward.face.reset();
  outward.angle_spread = outward.droop = outward.face_light = 0;
  PlacementContext context{.stance = BranchStance::on_axis,
                           .has_twigs = false,
                           .parent = site,
                           .places = stems.places_on_next(),
                           .limits = &instance.limits(),
                           .scene = &instance.scene(),
                           .progress = &instance.progress(),
                           .path = "components." + instance.component()};
  const Mat3 to_stem = glm::transpose(site.frame.axes);
  std::vector<StemBend> bends;
  for (const Site& child : place_along(straight_stem(tree.stem, site), outward, context)) {
    if (tree.branching.size(child.u) <= 0) continue;
    const Vec3 away = normalized_or(to_stem * child.frame.heading(), Vec3(0));
    bends.push_back({child.u, static_cast<float>(tree.deflection) * Vec3(-away.z, 0, away.x)});
  }
  return bends;
}

MinimumCounts minimum_counts(const Tree& tree, const KnownMembers& known) {
  MinimumCounts counts{.children = 1};
  if (!known.varies(member_of(tree, &Tree::stem, &StemParameters::segments))) counts.nodes = tree.stem.segments + 1.0;
  const BranchPlacement& own = tree.branching;
  const BranchPlacement plain;
  const bool varies = known.varies(member_of(tree, &Tree::stem, &StemParameters::length)) ||
                      known.varies(member_of(tree, &Tree::branching));
  counts.bears_along = tree.stem.length > 0 && !varies && !own.where && own.spread == plain.spread &&
                       own.size == plain.size && own.start == 0 && own.end == 1;
  return counts;
}

void expand(const Tree& tree, const Site& site, const InstanceContext& instance, StemSink& stems, SiteSink& sites) {
  const StemTropisms tropisms{&instance.directions(), tree.gravitropism, tree.phototropism};
  std::vector<StemBend> bends;
  if (tree.deflection != 0) bends = deflections(tree, site, instance, stems);
  StemPath path = grow_stem(tree.stem, site, tropisms, bends);
  const float tip_radius = path.skeleton.radius.back();
  stems.add(std::move(path.skeleton), tree.surface, {.branching = &tree.branching, .trim = tree.trim});
  sites.add_at_tip(path.frames.back(), path.length, tip_radius);
}

}  // namespace

ComponentType tree_component() {
  return define_component<Tree>({
      .traits =
          {.name = "tree",
           .doc = "A stem along a curve; branch links set children along it, and stems among them become its branches.",
           .material = {.colour = {0.40F, 0.34F, 0.28F}, .roughness = 0.95F},
           .makes_stems = true,
           .stance = BranchStance::on_axis,
           .tropism = Tropism::none},
      .parameters = Table<Tree>("a tree", "A stem along a curve.")
                        .members(&Tree::stem, stem_form_table())
                        .number("deflection", &Tree::deflection,
                                {.unit = Unit::degree, .min = -180, .max = 180, .usual = {-45, 45}},
                                "Angle that the stem bends away from each of its branches; raised, a zigzag, which "
                                "needs at least one segment per branch.")
                        .members(&Tree::branching, placement_table())
                        .object("surface", &Tree::surface, surface_table, "How the stem becomes a surface.")
                        .choice("trim", &Tree::trim, trim_modes(), kTrimDoc)
                        .only_where({{"surface.style", {"tubes"}}}, {"texture"})
                        .without(names_off_stems(), kWhyOffStems)
                        .check([](const Tree& tree, const DocumentPath& path, ParameterReader& reader) {
                          check_stem_form(tree.stem, path, reader);
                          check_placement(tree.branching, path, reader);
                        }),
      .expand = expand,
      .minimum_counts = minimum_counts,
  });
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The parts that instances emit: stems, organs, sections of surfaces, plants of other documents, and sites of children.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/base/mesh.h"
#include "meristem/graph/organ_list.h"
#include "meristem/graph/placement.h"
#include "meristem/graph/site_list.h"
#include "meristem/graph/table/plant_source.h"
#include "meristem/graph/table/site.h"
#include "meristem/graph/trimmed_stem.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/tube/loft.h"

namespace meristem {

/// A stem, with the facts that its children need.
struct EmittedStem {
  Skeleton skeleton;                                 ///< the grown skeleton, world space
  std::shared_ptr<const SurfaceOptions> surface;     ///< surface options, never null
  std::shared_ptr<const BranchPlacement> branching;  ///< placement of its branches, for keys that links do not give;
                                                     ///< may be null
  Site site;                                ///< site of the instance that made the stem, with a key of the stem's own
  bool visible = true;                      ///< false: only its children are visible
  Vec3 tint{1};                             ///< linear factors on the material's colour
  std::unique_ptr<const Skeleton> moved{};  ///< visible skeleton if `place` moves it; else null
  float moved_scale = 1;                    ///< size of the moved skeleton relative to the original
  /// Number of the root on which each node stands, if each root is a plant of its own. Else empty.
  std::vector<std::uint32_t> root_of_node{};
  std::shared_ptr<const TrimmedStem> trimmed{};  ///< the whole stem, if `skeleton` is its trimmed rest; null: not
                                                 ///< trimmed
  std::shared_ptr<const GrowingStem> growing{};  ///< set if the stem is shown at a step of its growth; `trimmed` is
                                                 ///< then set too

  std::uint64_t id() const { return site.key.bits(); }  ///< Returns the stem's id, which is Site::stem of sites on it.
  /// Returns the deformation of the stem, or null.
  const std::shared_ptr<const Deformation>& deformation() const { return deformation_at(site); }
  /// Returns Site::individual of sites on the root with this number.
  std::uint64_t individual_of_root(std::uint32_t root) const {
    return root == 0 ? site.individual : site.key.child("root").child(root).bits();
  }
  /// Returns Site::individual of sites on this node.
  std::uint64_t individual_at(NodeIndex node) const {
    return root_of_node.empty() ? site.individual : individual_of_root(root_of_node[node]);
  }
  /// Returns the position on `skeleton` for a position of the whole stem, or nothing if it was trimmed away.
  std::optional<StemPosition> left_of(StemPosition whole) const;
  /// Returns the remaining share of the length of the stem, which must be a single axis. Returns 1 if it is whole.
  float length_left() const;
};

/// The points of a section, in its own frame.
struct SectionOutline {
  std::uint64_t key = 0;  ///< outlines of one component with equal keys are equal
  LoftSection section;    ///< points of the section
  float extent = 0;       ///< from the origin to the farthest point, metres
};

/// A section of a surface. Surfaces are joined after all sections have been emitted.
struct EmittedSection {
  std::shared_ptr<const SectionOutline> outline;     ///< not null
  Frame frame;                                       ///< frame of the outline, in world space
  bool is_capped = true;                             ///< true: a flat face closes a ring at the end of its surface
  std::uint64_t id = 0;                              ///< never 0
  std::uint64_t parent = 0;                          ///< id of the section that it continues, or 0
  Vec3 tint{1};                                      ///< linear factors on the material's colour
  float birth = 0;                                   ///< growth step at which it appeared
  std::uint64_t individual = 0;                      ///< as in Site
  std::shared_ptr<const Deformation> deformation{};  ///< deformation of the section, or null
};

/// The parts that the instances of one block have emitted. They depend only on the component, its instances and the
/// scene.
struct Emitted {
  /// A mesh that organs of the block share.
  struct EmittedPrototype {
    std::uint64_t key = 0;             ///< key that the component gave
    std::shared_ptr<const Mesh> mesh;  ///< not null
    bool is_blade = false;             ///< true: has the material of blades
  };
  /// A plant that begins with one of the instances.
  struct Founded {
    std::uint64_t id = 0;                              ///< id of the plant
    Vec3 foot{0};                                      ///< position of its base, metres
    std::shared_ptr<const Deformation> deformation{};  ///< deformation of its base, or null
    std::uint32_t row = kNoRow;                        ///< row of the table that placed it
  };
  /// The deformation of the block's organs, from this organ up to the organ of the next entry.
  struct DeformedFrom {
    std::size_t organ = 0;                           ///< index of the organ in the block
    std::shared_ptr<const Deformation> deformation;  ///< null: not deformed
  };
  std::vector<EmittedPrototype> prototypes;  ///< meshes that organs share
  OrganList organs;                        ///< organs; their prototypes and individuals are numbered within this block
  std::vector<DeformedFrom> deformed;      ///< empty if no organ is deformed
  std::vector<Founded> founded;            ///< plants that begin with instances of the block
  std::vector<std::uint64_t> individuals;  ///< ids of the plants to which organs belong
  std::vector<EmittedSection> sections;    ///< sections of surfaces
  std::vector<EmittedStem> stems;          ///< stems, in the order in which they were emitted
  SiteList child_sites;                    ///< with the key and depth of the parent
  SiteList branch_sites;                   ///< sites for the children of branch links
  SiteList named_sites;                    ///< sites for components that the instances place
  std::vector<std::uint32_t> site_names;   ///< number of the name of each named site
  /// A whole plant of another document.
  struct PlacedPlant {
    Frame frame;                                       ///< from the plant's world to the world
    std::shared_ptr<const PlantSource> source;         ///< not null
    PlantRequest request;                              ///< values and seed
    float birth = 0;                                   ///< growth step at which it appeared
    bool is_visible = true;                            ///< false: not visible
    std::shared_ptr<const Deformation> deformation{};  ///< deformation of the plant, or null
    std::uint32_t row = kNoRow;                        ///< row of the table that placed it
    std::uint64_t name = 0;                            ///< as in Planting::Place
  };
  std::vector<PlacedPlant> plants;  ///< whole plants
  int growth_steps = 0;             ///< largest number of growth steps of an instance
};

}  // namespace meristem

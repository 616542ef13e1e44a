// SPDX-License-Identifier: Apache-2.0
// The plant: the result of the graph's expansion and the input of all later stages. Stems are skeletons, organs are
// instances of shared geometry.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/plant/material.h"
#include "meristem/plant/planting.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

class Deformation;

/// How the surfaces of bodies blend at their joints.
enum class BlendKind {
  poly,   ///< a fillet of limited width
  root,   ///< a fillet of unlimited width that swells all bodies
  pasko,  ///< a sharp union, filled near both surfaces
};

/// A closed crown surface: balls around the ends of branches, blended into one body.
struct CrownBody {
  float diameter = 0.5F;              ///< diameter of the balls, metres
  float offset = 0;                   ///< height of each ball's centre above its branch's end, metres
  float fuse = 0.1F;                  ///< blend width, metres; larger: smoother and fuller; 0: creases
  BlendKind blend = BlendKind::poly;  ///< shape of the blend between balls
  int resolution = 40;                ///< cells along the longest side; larger: finer
  std::optional<int> triangles;       ///< target number of triangles after simplification; holes may prevent it
  Vec3 colour{0.36F, 0.48F, 0.24F};   ///< sRGB
  bool hidden = false;                ///< true: the surface carries leaves but is not drawn

  /// Scales all lengths by `factor`.
  void scale(float factor) {
    diameter *= factor;
    offset *= factor;
    fuse *= factor;
  }

  bool operator==(const CrownBody&) const = default;
};

/// Surface options of a stem; `meristem/shape` makes the surface.
struct SurfaceOptions {
  /// How a stem gets its surface.
  enum class Style {
    tubes,  ///< one tube along each axis
    blend,  ///< one closed body around all axes
  };
  /// The normals of a surface: smooth over edges, or one for each triangle.
  enum class Shading { smooth, flat };
  /// The form of the end of an axis.
  enum class Cap { pointed, round, flat };
  Style style = Style::tubes;         ///< tubes or one blended body
  Shading shading = Shading::smooth;  ///< smooth or flat normals
  std::optional<CrownBody> crown;     ///< a closed crown around the ends of branches; unset: no crown

  // Tubes.
  int sides = 8;        ///< sides of the thickest tube; thinner tubes have fewer; larger: rounder, more triangles
  float error = 0.03F;  ///< tolerance of a tube's shape, in radii; larger: fewer rings; 0: one ring per node
  float uv_scale = 1;   ///< metres of bark that one texture tile covers
  float shift_u = 0;    ///< shift of the texture around tubes, tiles
  float shift_v = 0;    ///< shift of the texture along tubes, tiles
  /// Turn of the texture on the bark, radians. The nearest angle at which the tiles still join around the stem is used.
  float turn = 0;
  bool mirror = false;  ///< true: mirrors the texture around the stem
  /// Radii along the axis, in both directions, over which the radius is smoothed; 0: the skeleton's radii.
  float smooth = 3;
  float collar = 0.8F;     ///< radii over which a branch widens toward its parent; 0: it starts with a crease
  float flare = 0.5F;      ///< relative widening of roots at the ground; 0: none
  Cap cap = Cap::pointed;  ///< shape of the tips

  // Blended bodies.
  int resolution = 100;  ///< cells along the longest side; larger: finer, and triangles grow with its square
  float blend = 0.5F;    ///< blend width at forks, in radii of the branch; 0: creases
  bool thicken = true;   ///< true: thickens twigs that are too thin for the cells; false: they vanish
  /// Target number of triangles after simplification; thin twigs and holes may prevent it.
  std::optional<int> triangles;

  bool operator==(const SurfaceOptions&) const = default;
};

inline constexpr std::uint32_t kNoStem = 0xffffffffU;        ///< marks a missing stem index
inline constexpr std::uint32_t kNoIndividual = 0xffffffffU;  ///< marks a missing individual index

/// One of the plants that a document grows. It stands on one root or, without a root, on one site of the camera or of a
/// field. Each instance directly under the camera or under a component that bears plants
/// (ComponentTraits::bears_plants) is an individual. If its skeleton has several roots, each root is an individual.
struct Individual {
  std::string component;       ///< id of the component of that instance
  std::uint32_t number = 0;    ///< index among the individuals of that component
  Vec3 foot{0};                ///< position of its base, metres
  std::uint32_t row = kNoRow;  ///< row of the table that placed it, from 0; kNoRow: none
};

/// The part of a skeleton that one instance of a component made.
struct StemPart {
  std::string component;                             ///< id of the component in the document
  std::uint32_t instance = 0;                        ///< number among the instances of that component
  std::uint32_t material = 0;                        ///< index into Plant::materials
  SurfaceOptions surface;                            ///< surface options of this part
  Vec3 tint{1};                                      ///< linear factors on the material's colour
  std::shared_ptr<const Deformation> deformation{};  ///< applied to the finished surface; null: none
};

/// One grown skeleton with its surface options. Stems that grow on other stems are joined into one skeleton.
struct Stem {
  std::vector<StemPart> parts{1};           ///< the first one contains the root
  std::vector<std::uint32_t> part_of_axis;  ///< index into `parts`, one per axis; empty if there is one part
  Skeleton skeleton;                        ///< in world space
  /// The skeleton that the surface is made of if parts have a deformation. The deformation moves that surface to
  /// `skeleton`, which differs only in positions and radii. Null: the surface is made of `skeleton`.
  std::shared_ptr<const Skeleton> undeformed{};
  /// Index into Plant::individuals of each root of the skeleton, in the order of nodes. Empty: all roots belong to the
  /// first individual.
  std::vector<std::uint32_t> individual_of_root{};
  /// A unique name of each axis that stays the same at all times of the document. Empty if axes have no names.
  std::vector<std::uint64_t> axis_names{};

  /// Returns the index into `parts` of an axis.
  std::size_t part_index(AxisIndex axis) const { return part_of_axis.empty() ? 0 : part_of_axis[axis]; }
  /// Returns the part that an axis belongs to.
  const StemPart& part(AxisIndex axis) const { return parts[part_index(axis)]; }
  /// Returns the skeleton from which the surface is made, before deformation.
  const Skeleton& skeleton_of_surface() const { return undeformed != nullptr ? *undeformed : skeleton; }
  /// Returns the individual of all roots, or kNoIndividual if they differ.
  std::uint32_t individual() const;
  /// Returns the individual of each axis.
  std::vector<std::uint32_t> individual_of_axis() const;
};

/// Geometry that several organs share.
struct OrganPrototype {
  std::string component;             ///< id of the component in the document
  std::uint32_t material = 0;        ///< index into Plant::materials
  std::shared_ptr<const Mesh> mesh;  ///< in the organ's own frame: y along its heading, z out of its upper face
};

/// One instance of a prototype.
struct Organ {
  Frame frame;                   ///< from the organ's own frame to the world; may scale
  std::uint32_t prototype = 0;   ///< index into Plant::prototypes
  Vec3 tint{1};                  ///< linear factors on the material's colour
  float birth = 0;               ///< growth step at which it appeared
  std::uint32_t individual = 0;  ///< index into Plant::individuals, or kNoIndividual
  std::uint64_t name = 0;        ///< unique, and the same at all times of the document; 0: no name
};

/// Everything that a document has grown. Metres, y up; indices refer to the lists of the same plant.
struct Plant {
  std::vector<Material> materials;         ///< materials of stems and organs
  std::vector<Stem> stems;                 ///< grown skeletons
  std::vector<OrganPrototype> prototypes;  ///< shapes that organs share
  std::vector<Organ> organs;               ///< instances of prototypes: leaves, blossoms, fruits
  std::vector<Individual> individuals;     ///< in the order of placement; empty: the whole plant is one individual
  std::vector<Planting> plantings;  ///< whole plants; to read all stems and organs, use expanded() (plant_variant.h)

  std::uint64_t node_count() const;  ///< nodes of all stems, without plantings
};

}  // namespace meristem

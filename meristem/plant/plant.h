// SPDX-License-Identifier: Apache-2.0
// What the graph's expansion gives and everything downstream reads: stems as skeletons, organs as instances of shared
// geometry.
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

/// How bodies grow together where they meet.
enum class BlendKind {
  poly,   ///< a fillet of bounded reach
  root,   ///< one that reaches everywhere and swells all bodies
  pasko,  ///< a sharp union, filled where both surfaces are near
};

/// A closed body about the ends of branches: balls that grow together.
struct CrownBody {
  float diameter = 0.5F;  ///< diameter of the balls, metres
  float offset = 0;       ///< metres: height of each above its branch's end
  float fuse = 0.1F;  ///< metres over which they grow together; raised, smoother and fuller; 0: they meet in creases
  BlendKind blend = BlendKind::poly;
  int resolution = 40;               ///< cells along its longest side
  std::optional<int> triangles;      ///< simplified to this number, if its holes let it
  Vec3 colour{0.36F, 0.48F, 0.24F};  ///< sRGB
  bool hidden = false;               ///< the stem holds leaves and is not seen itself

  /// As it is in a frame that scales by `factor`.
  void scale(float factor) {
    diameter *= factor;
    offset *= factor;
    fuse *= factor;
  }

  bool operator==(const CrownBody&) const = default;
};

/// How stems want to be clothed; `meristem/shape` does it.
struct Surface {
  enum class Style {
    tubes,  ///< one along each axis
    blend,  ///< one closed body of all axes
  };
  enum class Shading { smooth, flat };
  enum class Cap { pointed, round, flat };
  Style style = Style::tubes;
  Shading shading = Shading::smooth;
  std::optional<CrownBody> crown;

  // Tubes.
  int sides = 8;        ///< sides of the thickest tube; thinner ones have fewer. More: rounder, more triangles
  float error = 0.03F;  ///< tolerance of a tube along its skeleton, in radii; raised, fewer rings; 0: one per node
  float uv_scale = 1;   ///< metres of bark that one texture tile covers
  float smooth = 3;  ///< radii along the axis to both sides over which a tube's radius is levelled; 0: as the skeleton
  float collar = 0.8F;     ///< radii over which branches grow out of their parent; 0: they start with a crease
  float flare = 0.5F;      ///< how much wider roots are at the ground than above it
  Cap cap = Cap::pointed;  ///< how tips end

  // Blended bodies.
  int resolution = 100;  ///< cells along the longest side; raised, finer, and triangles grow with its square
  float blend = 0.5F;    ///< radii of a branch over which it grows together with its parent; 0: they meet in a crease
  bool thicken = true;   ///< twigs thinner than the cells can hold are as thick as they can; else they vanish
  std::optional<int> triangles;  ///< simplified to this number, if its twigs and holes let it

  bool operator==(const Surface&) const = default;
};

inline constexpr std::uint32_t kNoStem = 0xffffffffU;        ///< in place of a stem's number
inline constexpr std::uint32_t kNoIndividual = 0xffffffffU;  ///< in place of an individual's number

/// One of the plants that a document grows: what stands on one root, or, without a root, on one site of the camera or
/// of a field. Each instance directly under the camera or under a component that bears plants
/// (ComponentTraits::bears_plants) is an individual; where its skeleton has several roots, each root is one.
struct Individual {
  std::string component;       ///< id of the instance that stands there
  std::uint32_t number = 0;    ///< among the individuals of that component
  Vec3 foot{0};                ///< where it stands
  std::uint32_t row = kNoRow;  ///< of the table that has placed it, from 0
};

/// What one component's instance has given to a skeleton.
struct StemPart {
  std::string component;       ///< id in the document
  std::uint32_t instance = 0;  ///< which instance of that component
  std::uint32_t material = 0;  ///< index into Plant::materials
  Surface surface;
  Vec3 tint{1};                                      ///< linear factors on the material's colour
  std::shared_ptr<const Deformation> deformation{};  ///< of its surface, once that is made; null: none
};

/// One grown skeleton with its looks. Where stems grow on stems, whatever made them, they are one skeleton.
struct Stem {
  std::vector<StemPart> parts{1};           ///< the first is the root's
  std::vector<std::uint32_t> part_of_axis;  ///< index into parts, one per axis; empty where there is one part
  Skeleton skeleton;                        ///< in world space
  /// What its surface is made of where parts have a deformation, which then takes that to where `skeleton` lies; null:
  /// `skeleton` itself. It differs from that in positions and radii only.
  std::shared_ptr<const Skeleton> undeformed{};
  /// Index into Plant::individuals for each root of the skeleton, in the order of nodes; empty: all stand on the first.
  std::vector<std::uint32_t> individual_of_root{};
  /// What each axis is called at all times of its document, and nothing else is; empty where nobody has named them.
  std::vector<std::uint64_t> axis_names{};

  std::size_t part_index(AxisIndex axis) const { return part_of_axis.empty() ? 0 : part_of_axis[axis]; }
  const StemPart& part(AxisIndex axis) const { return parts[part_index(axis)]; }
  const Skeleton& skeleton_of_surface() const { return undeformed != nullptr ? *undeformed : skeleton; }
  /// The individual of all roots, or kNoIndividual where they differ.
  std::uint32_t individual() const;
  /// The individual of each axis.
  std::vector<std::uint32_t> individual_of_axis() const;
};

/// Geometry that many organs share.
struct OrganPrototype {
  std::string component;
  std::uint32_t material = 0;
  std::shared_ptr<const Mesh> mesh;  ///< in the organ's own frame: y along its heading, z its upper face
};

/// One instance of a prototype.
struct Organ {
  Frame frame;  ///< from the organ's own frame to the world; may scale
  std::uint32_t prototype = 0;
  Vec3 tint{1};                  ///< linear factors on the material's colour
  float birth = 0;               ///< growth step at which it appeared
  std::uint32_t individual = 0;  ///< index into Plant::individuals, or kNoIndividual
  std::uint64_t name = 0;        ///< at all times of its document, and no other organ's; 0 where nobody has named it
};

struct Plant {
  std::vector<Material> materials;
  std::vector<Stem> stems;
  std::vector<OrganPrototype> prototypes;
  std::vector<Organ> organs;
  std::vector<Individual> individuals;  ///< in the order in which they were placed; empty: all is one
  std::vector<Planting>
      plantings;  ///< whole plants; what reads stems and organs alone reads expanded() (plant_variant.h)

  std::uint64_t node_count() const;
};

}  // namespace meristem

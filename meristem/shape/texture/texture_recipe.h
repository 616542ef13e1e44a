// SPDX-License-Identifier: Apache-2.0
// How a texture is made: by a procedure of ours, or from pictures of the user's.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/base/vec.h"
#include "meristem/plant/texture.h"

namespace meristem {

/// Bark as a tile of about a metre. Its mean colour is the material's.
struct BarkRecipe {
  /// smooth: beech; furrowed: oak, ash, poplar; plated: pine; peeling: birch.
  enum class Style { smooth, furrowed, plated, peeling };
  Style style = Style::furrowed;  ///< style of the bark
  double scale = 1;               ///< size of its features; raised, fewer and larger ones on a tile
  double relief = 1;              ///< depth of its normals; 0 is flat
  double contrast = 1;            ///< contrast of colours; 0 is even
  std::optional<Vec3> seams;      ///< sRGB, colour of furrows, gaps and lenticels; dark bark if unset
  std::optional<Vec3> marks;      ///< sRGB, colour of lichen and peeled patches; little of them if unset
  std::uint64_t seed = 1;         ///< another number gives another tile of the kind

  bool operator==(const BarkRecipe&) const = default;
};

/// A leaf with its veins, over u across and v along the blade.
struct LeafRecipe {
  /// The course of the veins.
  enum class Veins { pinnate, palmate, parallel };
  Veins veins = Veins::pinnate;     ///< pinnate, palmate or parallel
  int pairs = 7;                    ///< pairs of side veins (pinnate), else pairs of main veins beside the middle one
  double angle = radians(45);       ///< between main and side veins, radians
  double contrast = 1;              ///< contrast of veins and mottling
  double relief = 1;                ///< depth of its normals; 0 is flat
  std::optional<Vec3> vein_colour;  ///< sRGB; a lighter leaf's if unset
  std::optional<Vec3> edge_colour;  ///< sRGB, toward the margin, as in autumn; unset: no edge colour
  std::uint64_t seed = 1;           ///< another number gives another leaf of the kind

  bool operator==(const LeafRecipe&) const = default;
};

/// A petal, over u across and v from claw to edge.
struct PetalRecipe {
  std::optional<Vec3> throat;   ///< sRGB, colour at the claw; the petal's own if unset
  double throat_length = 0.35;  ///< share of the petal that it fades over
  std::optional<Vec3> stripes;  ///< sRGB, colour of the lines that run along it; faint ones if unset
  double relief = 1;            ///< depth of its normals; 0 is flat
  std::uint64_t seed = 1;       ///< another number gives another petal of the kind

  bool operator==(const PetalRecipe&) const = default;
};

/// What a component's uvs show, for textures that follow a shape.
struct TextureShape {
  std::vector<Vec2> outline;  ///< closed polygon in uv, counter-clockwise; empty: all of the unit square
  bool masked = false;        ///< what lies outside of it is cut out by the texture
  double aspect = 1;          ///< width over height of the unit square as it lies on the surface

  bool operator==(const TextureShape&) const = default;
};

/// The textures themselves: `pixels` a side, the same bytes on every machine and any number of threads. `colour` (sRGB)
/// is the mean that comes out. Bark's opposite edges join. Throws Cancelled.
Texture make_bark_texture(const BarkRecipe& recipe, Vec3 colour, int pixels, const Progress& progress = Progress());
/// Like make_bark_texture(), for a leaf. Pixels outside a masked shape have the colours of the margin.
Texture make_leaf_texture(const LeafRecipe& recipe, const TextureShape& shape, Vec3 colour, int pixels,
                          const Progress& progress = Progress());
/// Like make_leaf_texture(), for a petal.
Texture make_petal_texture(const PetalRecipe& recipe, const TextureShape& shape, Vec3 colour, int pixels,
                           const Progress& progress = Progress());

}  // namespace meristem

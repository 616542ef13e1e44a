// SPDX-License-Identifier: Apache-2.0
// The source of a texture: one of our procedures, or pictures of the user.
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

/// Bark as a tile of about a metre. Its mean colour is the material's colour.
struct BarkRecipe {
  /// smooth: beech; furrowed: oak, ash, poplar; plated: pine; peeling: birch.
  enum class Style { smooth, furrowed, plated, peeling };
  Style style = Style::furrowed;  ///< style of the bark
  double scale = 1;               ///< size of its features; larger values give fewer and larger features per tile
  double relief = 1;              ///< depth of its normals; 0 is flat
  double contrast = 1;            ///< contrast of colours; 0 is even
  std::optional<Vec3> seams;      ///< sRGB colour of furrows, gaps and lenticels; if unset, a dark bark colour
  std::optional<Vec3> marks;      ///< sRGB colour of lichen and peeled patches; if unset, there are few of them
  std::uint64_t seed = 1;         ///< another number gives another tile of the same kind

  bool operator==(const BarkRecipe&) const = default;
};

/// A leaf with its veins, with u across and v along the blade.
struct LeafRecipe {
  /// The course of the veins.
  enum class Veins { pinnate, palmate, parallel };
  Veins veins = Veins::pinnate;     ///< pinnate, palmate or parallel
  int pairs = 7;                    ///< pairs of side veins (pinnate), or pairs of main veins beside the middle one
  double angle = radians(45);       ///< angle between main and side veins, radians
  double contrast = 1;              ///< contrast of veins and mottling
  double relief = 1;                ///< depth of its normals; 0 is flat
  std::optional<Vec3> vein_colour;  ///< sRGB; if unset, a lighter leaf colour
  std::optional<Vec3> edge_colour;  ///< sRGB colour toward the margin, as in autumn; unset: no edge colour
  std::uint64_t seed = 1;           ///< another number gives another leaf of the same kind

  bool operator==(const LeafRecipe&) const = default;
};

/// A petal, with u across and v from claw to edge.
struct PetalRecipe {
  std::optional<Vec3> throat;   ///< sRGB colour at the claw; if unset, the petal's own colour
  double throat_length = 0.35;  ///< share of the petal over which the throat fades
  std::optional<Vec3> stripes;  ///< sRGB colour of the lines along the petal; if unset, faint lines
  double relief = 1;            ///< depth of its normals; 0 is flat
  std::uint64_t seed = 1;       ///< another number gives another petal of the same kind

  bool operator==(const PetalRecipe&) const = default;
};

/// The shape in a component's uvs, for textures that follow it.
struct TextureShape {
  std::vector<Vec2> outline;  ///< closed polygon in uv, counter-clockwise; empty: the whole unit square
  bool masked = false;        ///< if true, the texture cuts out everything outside the outline
  double aspect = 1;          ///< width divided by height of the unit square on the surface

  bool operator==(const TextureShape&) const = default;
};

/// Returns a texture with `pixels` per side, at least 1. Bytes are equal on every machine and on any number of threads.
/// `colour` (sRGB) is the mean of the visible pixels. The mean is darker if too many pixels would be brighter than
/// white. There are no normals if the relief is 0. Opposite edges of bark join. Throws Cancelled.
Texture make_bark_texture(const BarkRecipe& recipe, Vec3 colour, int pixels, const Progress& progress = Progress());
/// Like make_bark_texture(), for a leaf. Pixels outside a masked shape have the colours of the margin.
Texture make_leaf_texture(const LeafRecipe& recipe, const TextureShape& shape, Vec3 colour, int pixels,
                          const Progress& progress = Progress());
/// Like make_leaf_texture(), for a petal.
Texture make_petal_texture(const PetalRecipe& recipe, const TextureShape& shape, Vec3 colour, int pixels,
                           const Progress& progress = Progress());

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// How a document says what texture a component wears.
#pragma once

#include <memory>
#include <optional>

#include "meristem/base/mesh.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// Pictures of the user's.
struct PictureParameters {
  Asset<Image> colour;   ///< picture of the colours
  Asset<Image> normals;  ///< picture of the normals; may be missing
  bool masked = false;   ///< the colour's alpha cuts holes
  double repeat_u = 1;   ///< pictures per unit of u on organs and surfaces; stems have their uv_scale instead
  double repeat_v = 1;   ///< pictures per unit of v on organs and surfaces; stems have their uv_scale instead
  double shift_u = 0;    ///< shift of the texture along u, in pictures
  double shift_v = 0;    ///< shift of the texture along v, in pictures
};

/// At most one of the four kinds is given.
struct TextureParameters {
  std::optional<BarkRecipe> bark;            ///< painted bark
  std::optional<LeafRecipe> leaf;            ///< painted leaf
  std::optional<PetalRecipe> petal;          ///< painted petal
  std::optional<PictureParameters> picture;  ///< pictures from files
  int pixels = 512;                          ///< side length of painted textures

  bool is_empty() const { return !bark && !leaf && !petal && !picture; }  ///< true if no texture is given
};

const ParameterTable& texture_table();  ///< the rows of TextureParameters

/// Lays the picture of a form, if it has one, on a mesh as it says.
void lay_picture(const TextureParameters& form, Mesh& mesh);

/// The texture that a checked form means, null for an empty one. `shape` is what the component's uvs show, `colour`
/// (sRGB) its mean. Throws Cancelled.
std::shared_ptr<const Texture> make_texture(const TextureParameters& form, const TextureShape& shape, Vec3 colour,
                                            const Progress& progress = Progress());

/// A sketch of the texture, which takes no time: sizes and masks, without pixels.
std::shared_ptr<const Texture> sketch_texture(const TextureParameters& form, const TextureShape& shape, Vec3 colour);

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The parameters of a component's texture, as a document gives them.
#pragma once

#include <memory>
#include <optional>

#include "meristem/base/mesh.h"
#include "meristem/graph/table/asset.h"
#include "meristem/graph/table/parameter.h"
#include "meristem/shape/texture/texture_recipe.h"

namespace meristem {

/// Pictures from the user's files.
struct PictureParameters {
  Asset<Image> colour;   ///< picture of the colours
  Asset<Image> normals;  ///< picture of the normals; may be missing
  bool masked = false;   ///< the colour's alpha cuts holes
  double repeat_u = 1;   ///< pictures per unit of u on organs and surfaces; stems have their uv_scale instead
  double repeat_v = 1;   ///< pictures per unit of v on organs and surfaces; stems have their uv_scale instead
  double shift_u = 0;    ///< shift of the texture along u, in pictures
  double shift_v = 0;    ///< shift of the texture along v, in pictures
};

/// Parameters of a texture. At most one of the four kinds is given.
struct TextureParameters {
  std::optional<BarkRecipe> bark;            ///< painted bark
  std::optional<LeafRecipe> leaf;            ///< painted leaf
  std::optional<PetalRecipe> petal;          ///< painted petal
  std::optional<PictureParameters> picture;  ///< pictures from files
  int pixels = 512;                          ///< side length of painted textures

  bool is_empty() const { return !bark && !leaf && !petal && !picture; }  ///< true if no texture is given
};

const ParameterTable& texture_table();  ///< the rows of TextureParameters

/// Transforms the uvs of a mesh for the picture of a form, if the form has one.
void lay_picture(const TextureParameters& form, Mesh& mesh);

/// Returns the texture of a checked form, or null for an empty form. `shape` is the shape that the component's uvs
/// cover, `colour` (sRGB) the mean colour. Throws Cancelled.
std::shared_ptr<const Texture> make_texture(const TextureParameters& form, const TextureShape& shape, Vec3 colour,
                                            const Progress& progress = Progress());

/// Returns a sketch of the texture: sizes and masks, without pixels. Takes almost no time.
std::shared_ptr<const Texture> sketch_texture(const TextureParameters& form, const TextureShape& shape, Vec3 colour);

}  // namespace meristem

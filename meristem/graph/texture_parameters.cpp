// SPDX-License-Identifier: Apache-2.0
// The rows of textures, and the textures that they describe: bark, leaves and petals are painted from recipes, and
// pictures are read from files. Equal parameters, shapes and colours give equal fingerprints, so components share a
// texture.
#include "meristem/graph/texture_parameters.h"

#include <utility>

#include "meristem/base/fingerprint.h"
#include "meristem/base/read_image.h"
#include "meristem/graph/table/table.h"
#include "meristem/shape/texture/mean_light.h"

namespace meristem {

namespace {

constexpr NumberRange kFactor{.min = 0, .max = 4, .usual = {0, 2}, .fixed = true};
constexpr NumberRange kRepeat{.min = -1000, .max = 1000, .usual = {0, 10}, .fixed = true};
constexpr NumberRange kShift{.min = -1000, .max = 1000, .fixed = true};
constexpr NumberRange kSeed{.min = 0, .max = 1e15, .usual = {0, 100}, .fixed = true};

const ParameterTable& bark_table() {
  static const ParameterTable table =
      Table<BarkRecipe>("a bark", "Bark that the program paints, as a tile whose edges join.")
          .choice(
              "style", &BarkRecipe::style, {"smooth", "furrowed", "plated", "peeling"},
              "Kind of bark: 'smooth' as of beech, 'furrowed' as of oak, 'plated' as of pine, 'peeling' as of birch.")
          .number("scale", &BarkRecipe::scale, {.min = 0.1, .max = 10, .usual = {0.2, 4}, .fixed = true},
                  "Size of the bark's features; raised, fewer and larger ones per tile.")
          .number("relief", &BarkRecipe::relief, kFactor,
                  "Depth of furrows and ridges as the light shows it; raised, rougher; 0 is flat.")
          .number("contrast", &BarkRecipe::contrast, kFactor,
                  "Contrast between the bark's colours; 0 is one even colour.")
          .colour("seams", &BarkRecipe::seams, "Colour of furrows, cracks and lenticels; by default, a darker bark.")
          .colour("marks", &BarkRecipe::marks,
                  "Colour of lichen and, on peeling bark, of what lies open; by default, chosen by style.")
          .integer("seed", &BarkRecipe::seed, kSeed,
                   "Seed of the bark's random pattern; another number gives another tile of this kind.")
          .shorthand("style");
  return table;
}

const ParameterTable& leaf_table() {
  static const ParameterTable table =
      Table<LeafRecipe>("a leaf's texture", "A leaf with its veins that the program paints over the blade's outline.")
          .choice("veins", &LeafRecipe::veins, {"pinnate", "palmate", "parallel"},
                  "Venation: 'pinnate' with side veins from a midrib, 'palmate' with main veins to the lobes, "
                  "'parallel' from base to tip.")
          .integer(
              "pairs", &LeafRecipe::pairs, {.min = 1, .max = 40, .usual = {2, 15}, .fixed = true},
              "Number of pairs of side veins (pinnate), or of main veins beside the middle one (palmate and parallel).")
          .number("angle", &LeafRecipe::angle, {.unit = Unit::degree, .min = 15, .max = 90, .fixed = true},
                  "Angle between a main vein and its side veins.")
          .number("contrast", &LeafRecipe::contrast, kFactor, "Contrast of veins and mottling; 0 shows neither.")
          .number("relief", &LeafRecipe::relief, kFactor, "Depth of the veins as the light shows it; 0 is flat.")
          .colour("vein_colour", &LeafRecipe::vein_colour, "Colour of the veins; by default, lighter than the leaf.")
          .colour("edge_colour", &LeafRecipe::edge_colour, "Colour toward the margin, as in autumn; by default, none.")
          .integer("seed", &LeafRecipe::seed, kSeed,
                   "Seed of the leaf's random pattern; another number gives another leaf of this kind.")
          .only_where({{"veins", {"pinnate", "palmate"}}}, {"angle"})
          .shorthand("veins");
  return table;
}

const ParameterTable& petal_table() {
  static const ParameterTable table =
      Table<PetalRecipe>("a petal's texture", "A petal that the program paints over the blade's outline.")
          .colour("throat", &PetalRecipe::throat, "Colour at the petal's base; by default, the petal's own.")
          .number("throat_length", &PetalRecipe::throat_length, {.min = 0.01, .max = 1, .fixed = true},
                  "Share of the petal over which the throat's colour fades.")
          .only_with("throat", {"throat_length"})
          .colour("stripes", &PetalRecipe::stripes,
                  "Colour of the lines that fan out from the petal's base; by default, faint ones.")
          .number("relief", &PetalRecipe::relief, kFactor, "Depth of the lines as the light shows it; 0 is flat.")
          .integer("seed", &PetalRecipe::seed, kSeed,
                   "Seed of the petal's random pattern; another number gives another petal of this kind.");
  return table;
}

const ParameterTable& picture_table() {
  static const ParameterTable table =
      Table<PictureParameters>("a picture", "Pictures of your own (PNG or JPEG) on the surface.")
          .file("colour", &PictureParameters::colour, read_image, "Picture of the surface's colours (PNG or JPEG).")
          .required()
          .file("normals", &PictureParameters::normals, read_image,
                "Normal map of the surface's relief (PNG or JPEG): red to the right, green up, blue outward.")
          .boolean("masked", &PictureParameters::masked,
                   "Whether the surface has holes where the picture's alpha is below one half.")
          .number("repeat_u", &PictureParameters::repeat_u, kRepeat,
                  "Number of pictures across a surface other than a stem's tubes; raised, smaller ones; negative, "
                  "mirrored.")
          .number("repeat_v", &PictureParameters::repeat_v, kRepeat,
                  "Number of pictures from base to tip of a surface other than a stem's tubes; raised, smaller ones; "
                  "negative, mirrored.")
          .number("shift_u", &PictureParameters::shift_u, kShift,
                  "Shift of the pictures across the surface, in widths of a picture.")
          .number("shift_v", &PictureParameters::shift_v, kShift,
                  "Shift of the pictures from base to tip of the surface, in heights of a picture.")
          .shorthand("colour");
  return table;
}

void add_colour(Vec3 colour, Fingerprint& to) { to.add(colour.r).add(colour.g).add(colour.b); }

void add_colour(const std::optional<Vec3>& colour, Fingerprint& to) {
  to.add(colour.has_value());
  add_colour(colour.value_or(Vec3(0)), to);
}

void add(const BarkRecipe& recipe, Fingerprint& to) {
  const auto& [style, scale, relief, contrast, seams, marks, seed] = recipe;
  to.add(style).add(scale).add(relief).add(contrast).add(seed);
  add_colour(seams, to);
  add_colour(marks, to);
}

void add(const LeafRecipe& recipe, Fingerprint& to) {
  const auto& [veins, pairs, angle, contrast, relief, vein_colour, edge_colour, seed] = recipe;
  to.add(veins).add(pairs).add(angle).add(contrast).add(relief).add(seed);
  add_colour(vein_colour, to);
  add_colour(edge_colour, to);
}

void add(const PetalRecipe& recipe, Fingerprint& to) {
  const auto& [throat, throat_length, stripes, relief, seed] = recipe;
  to.add(throat_length).add(relief).add(seed);
  add_colour(throat, to);
  add_colour(stripes, to);
}

/// Adds the content of a picture. Its position on a mesh is not part of the texture.
void add(const PictureParameters& picture, Fingerprint& to) {
  to.add(picture.masked);
  for (const Asset<Image>* image : {&picture.colour, &picture.normals}) {
    to.add(static_cast<bool>(*image));
    if (*image) to.add((*image)->width).add((*image)->height).add_array((*image)->rgba);
  }
}

void add(const TextureShape& shape, Fingerprint& to) {
  const auto& [outline, masked, aspect] = shape;
  to.add_array(outline).add(masked).add(aspect);
}

/// Returns a hash of everything that distinguishes textures.
std::uint64_t fingerprint_of(const TextureParameters& form, const TextureShape& shape, Vec3 colour) {
  Fingerprint key;
  key.add(form.bark.has_value()).add(form.leaf.has_value()).add(form.petal.has_value());
  if (form.picture) {
    add(*form.picture, key);
    return key.hash();
  }
  if (form.bark) add(*form.bark, key);
  if (form.leaf) add(*form.leaf, key);
  if (form.petal) add(*form.petal, key);
  if (!form.bark) add(shape, key);  // bark does not depend on the shape
  add_colour(colour, key);
  return key.add(form.pixels).hash();
}

Texture texture_of(const PictureParameters& picture) {
  Texture texture;
  texture.name = "picture";
  texture.masked = picture.masked;
  texture.colour = *picture.colour;
  if (!picture.masked) {
    for (std::size_t k = 3; k < texture.colour.rgba.size(); k += 4) texture.colour.rgba[k] = 255;
  }
  if (picture.normals) texture.normals = *picture.normals;
  texture.mean = mean_light(texture.colour, picture.masked);
  return texture;
}

Texture painted(const TextureParameters& form, const TextureShape& shape, Vec3 colour, const Progress& progress) {
  if (form.bark) return make_bark_texture(*form.bark, colour, form.pixels, progress);
  if (form.leaf) return make_leaf_texture(*form.leaf, shape, colour, form.pixels, progress);
  if (form.petal) return make_petal_texture(*form.petal, shape, colour, form.pixels, progress);
  return texture_of(*form.picture);
}

Texture sketched(const TextureParameters& form, const TextureShape& shape) {
  Texture texture;
  const auto sketch = [&](double relief) {
    texture.colour = {form.pixels, form.pixels, {}};
    if (relief > 0) texture.normals = texture.colour;
  };
  if (form.bark) sketch(form.bark->relief);
  if (form.leaf) sketch(form.leaf->relief);
  if (form.petal) sketch(form.petal->relief);
  texture.masked = !form.bark && shape.masked;
  if (!form.picture) return texture;
  const PictureParameters& picture = *form.picture;
  texture.masked = picture.masked;
  texture.colour = {picture.colour->width, picture.colour->height, {}};
  if (picture.normals) texture.normals = {picture.normals->width, picture.normals->height, {}};
  texture.mean = mean_light(*picture.colour, picture.masked);
  return texture;
}

std::shared_ptr<const Texture> with_fingerprint(Texture texture, std::uint64_t fingerprint) {
  texture.fingerprint = fingerprint;
  return std::make_shared<const Texture>(std::move(texture));
}

}  // namespace

const ParameterTable& texture_table() {
  static const ParameterTable table =
      Table<TextureParameters>("a texture", "Texture of a component's surface, of one of these kinds.")
          .object("bark", &TextureParameters::bark, bark_table, "Bark that the program paints.")
          .object("leaf", &TextureParameters::leaf, leaf_table, "A leaf with its veins that the program paints.")
          .object("petal", &TextureParameters::petal, petal_table, "A petal that the program paints.")
          .object("picture", &TextureParameters::picture, picture_table, "Pictures of your own (PNG or JPEG).")
          .integer("pixels", &TextureParameters::pixels, {.min = 16, .max = 2048, .fixed = true},
                   "Width and height, in pixels, of a texture that the program paints; raised, finer detail and larger "
                   "files.")
          .never_with("bark", {"leaf", "petal", "picture"})
          .never_with("leaf", {"petal", "picture"})
          .never_with("petal", {"picture"})
          .only_where({{"bark"}, {"leaf"}, {"petal"}}, {"pixels"});
  return table;
}

void lay_picture(const TextureParameters& form, Mesh& mesh) {
  if (!form.picture) return;
  const PictureParameters& picture = *form.picture;
  const Vec2 repeat(picture.repeat_u, picture.repeat_v), shift(picture.shift_u, picture.shift_v);
  if (repeat == Vec2(1) && shift == Vec2(0)) return;
  for (Vec2& uv : mesh.uvs) uv = repeat * uv + shift;
}

std::shared_ptr<const Texture> make_texture(const TextureParameters& form, const TextureShape& shape, Vec3 colour,
                                            const Progress& progress) {
  if (form.is_empty()) return nullptr;
  return with_fingerprint(painted(form, shape, colour, progress), fingerprint_of(form, shape, colour));
}

std::shared_ptr<const Texture> sketch_texture(const TextureParameters& form, const TextureShape& shape, Vec3 colour) {
  if (form.is_empty()) return nullptr;
  return with_fingerprint(sketched(form, shape), fingerprint_of(form, shape, colour));
}

}  // namespace meristem

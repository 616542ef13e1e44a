// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/texture_form.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/hash.h"
#include "meristem/base/read_image.h"
#include "meristem/graph/table/table.h"
#include "meristem/shape/texture/mean_light.h"

namespace meristem {

namespace {

constexpr NumberForm kFactor{.min = 0, .max = 4, .usual = {0, 2}, .fixed = true};
constexpr NumberForm kRepeat{.min = -1000, .max = 1000, .usual = {0, 10}, .fixed = true};
constexpr NumberForm kShift{.min = -1000, .max = 1000, .fixed = true};
constexpr NumberForm kSeed{.min = 0, .max = 1e15, .usual = {0, 100}, .fixed = true};

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
                   "Number from which the bark's pattern comes; another one gives another tile of the same kind.")
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
                   "Number from which the leaf's pattern comes; another one gives another leaf of the same kind.")
          .shorthand("veins");
  return table;
}

const ParameterTable& petal_table() {
  static const ParameterTable table =
      Table<PetalRecipe>("a petal's texture", "A petal that the program paints over the blade's outline.")
          .colour("throat", &PetalRecipe::throat, "Colour at the petal's base; by default, the petal's own.")
          .number("throat_length", &PetalRecipe::throat_length, {.min = 0.01, .max = 1, .fixed = true},
                  "Share of the petal over which the throat's colour fades.")
          .colour("stripes", &PetalRecipe::stripes,
                  "Colour of the lines that fan out from the petal's base; by default, faint ones.")
          .number("relief", &PetalRecipe::relief, kFactor, "Depth of the lines as the light shows it; 0 is flat.")
          .integer("seed", &PetalRecipe::seed, kSeed,
                   "Number from which the petal's pattern comes; another one gives another petal of the same kind.");
  return table;
}

const ParameterTable& picture_table() {
  static const ParameterTable table =
      Table<PictureForm>("a picture", "Pictures of your own (PNG or JPEG) on the surface.")
          .file("colour", &PictureForm::colour, read_image, "Picture of the surface's colours.")
          .required()
          .file("normals", &PictureForm::normals, read_image,
                "Normal map of the surface's relief: red to the right, green up, blue outward.")
          .boolean("masked", &PictureForm::masked,
                   "Whether the surface has holes where the picture's alpha is below one half.")
          .number("repeat_u", &PictureForm::repeat_u, kRepeat,
                  "Number of pictures across a surface other than a stem's tubes; raised, smaller ones; negative, "
                  "mirrored.")
          .number("repeat_v", &PictureForm::repeat_v, kRepeat,
                  "Number of pictures from base to tip of a surface other than a stem's tubes; raised, smaller ones; "
                  "negative, mirrored.")
          .number("shift_u", &PictureForm::shift_u, kShift, "Shift of the pictures across the surface, in pictures.")
          .number("shift_v", &PictureForm::shift_v, kShift,
                  "Shift of the pictures from base to tip of the surface, in pictures.")
          .shorthand("colour");
  return table;
}

/// What tells textures apart.
struct TextureKey {
  std::optional<BarkRecipe> bark;
  std::optional<LeafRecipe> leaf;
  std::optional<PetalRecipe> petal;
  std::string picture;  // hash of its pixels
  TextureShape shape;
  Vec3 colour{0};
  int pixels = 0;

  bool operator==(const TextureKey&) const = default;
};

std::string hash_of(const PictureForm& picture) {
  std::string hash = picture.masked ? "masked" : "whole";
  for (const Asset<Image>* image : {&picture.colour, &picture.normals}) {
    if (!*image) continue;
    hash += fmt::format(" {}x{} {}", (*image)->width, (*image)->height,
                        hash128_hex(std::as_bytes(std::span((*image)->rgba))));
  }
  return hash;
}

TextureKey key_of(const TextureForm& form, const TextureShape& shape, Vec3 colour) {
  if (form.picture) return {.picture = hash_of(*form.picture)};
  TextureKey key{form.bark, form.leaf, form.petal, {}, {}, colour, form.pixels};
  if (!form.bark) key.shape = shape;
  return key;
}

/// Textures in use, by what they were made of.
class TextureCache {
 public:
  std::shared_ptr<const Texture> find(const TextureKey& key) {
    const std::scoped_lock lock(mutex_);
    return find_locked(key);
  }
  /// Keeps `texture` while it is in use, or gives the one that another thread was quicker with.
  std::shared_ptr<const Texture> keep(TextureKey key, Texture texture) {
    const std::scoped_lock lock(mutex_);
    if (std::shared_ptr<const Texture> other = find_locked(key)) return other;
    entries_.erase(
        std::remove_if(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.texture.expired(); }),
        entries_.end());
    auto kept = std::make_shared<const Texture>(std::move(texture));
    entries_.push_back({std::move(key), kept});
    return kept;
  }

 private:
  struct Entry {
    TextureKey key;
    std::weak_ptr<const Texture> texture;
  };

  std::shared_ptr<const Texture> find_locked(const TextureKey& key) const {
    for (const Entry& entry : entries_) {
      if (entry.key != key) continue;
      if (std::shared_ptr<const Texture> texture = entry.texture.lock()) return texture;
    }
    return nullptr;
  }

  std::mutex mutex_;
  std::vector<Entry> entries_;
};

TextureCache& texture_cache() {
  static TextureCache cache;
  return cache;
}

Texture texture_of(const PictureForm& picture) {
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

Texture painted(const TextureForm& form, const TextureShape& shape, Vec3 colour) {
  if (form.bark) return make_bark_texture(*form.bark, colour, form.pixels);
  if (form.leaf) return make_leaf_texture(*form.leaf, shape, colour, form.pixels);
  if (form.petal) return make_petal_texture(*form.petal, shape, colour, form.pixels);
  return texture_of(*form.picture);
}

}  // namespace

const ParameterTable& texture_table() {
  static const ParameterTable table =
      Table<TextureForm>("a texture", "Texture of a component's surface, of one of these kinds.")
          .object("bark", &TextureForm::bark, bark_table, "Bark that the program paints.")
          .object("leaf", &TextureForm::leaf, leaf_table, "A leaf with its veins that the program paints.")
          .object("petal", &TextureForm::petal, petal_table, "A petal that the program paints.")
          .object("picture", &TextureForm::picture, picture_table, "Pictures of your own (PNG or JPEG).")
          .integer(
              "pixels", &TextureForm::pixels, {.min = 16, .max = 2048, .fixed = true},
              "Width and height in pixels of a texture that the program paints; raised, finer detail and larger files.")
          .never_with("bark", {"leaf", "petal", "picture"})
          .never_with("leaf", {"petal", "picture"})
          .never_with("petal", {"picture"})
          .never_with("picture", {"pixels"});
  return table;
}

void lay_picture(const TextureForm& form, Mesh& mesh) {
  if (!form.picture) return;
  const PictureForm& picture = *form.picture;
  const Vec2 repeat(picture.repeat_u, picture.repeat_v), shift(picture.shift_u, picture.shift_v);
  if (repeat == Vec2(1) && shift == Vec2(0)) return;
  for (Vec2& uv : mesh.uvs) uv = repeat * uv + shift;
}

std::shared_ptr<const Texture> make_texture(const TextureForm& form, const TextureShape& shape, Vec3 colour) {
  if (!form.bark && !form.leaf && !form.petal && !form.picture) return nullptr;
  TextureKey key = key_of(form, shape, colour);
  if (std::shared_ptr<const Texture> texture = texture_cache().find(key)) return texture;
  return texture_cache().keep(std::move(key), painted(form, shape, colour));
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Paints a leaf from above: veins sunk between swellings of the tissue, mottled tissue and, if requested, the colour of
// autumn, which spreads from the margin and reaches the veins last. Outside the outline, the picture continues the
// leaf's margin, so that filtering adds no other colour.
#include "meristem/base/colour.h"
#include "meristem/shape/texture/leaf_veins.h"
#include "meristem/shape/texture/noise_field.h"
#include "meristem/shape/texture/texture_canvas.h"
#include "meristem/shape/texture/tileable_cells.h"

namespace meristem {

namespace {

/// Colours of a leaf, linear.
struct LeafPaints {
  LeafPaints(const LeafRecipe& recipe, Vec3 colour)
      : blade(linear_from_srgb(colour)),
        veins(recipe.vein_colour ? linear_from_srgb(*recipe.vein_colour) : glm::mix(blade, Vec3(1, 1, 0.7F), 0.16F)),
        edge(recipe.edge_colour ? linear_from_srgb(*recipe.edge_colour) : 0.9F * blade),
        contrast(static_cast<float>(recipe.contrast)),
        has_autumn(recipe.edge_colour.has_value()) {}

  Vec3 blade;
  Vec3 veins;
  Vec3 edge;
  float contrast;
  bool has_autumn;
};

}  // namespace

Texture make_leaf_texture(const LeafRecipe& recipe, const TextureShape& shape, Vec3 colour, int pixels,
                          const Progress& progress) {
  const BladeMap map(shape, pixels);
  const LeafVeins veins(recipe, shape, map, pixels);
  const LeafPaints paints(recipe, colour);
  const RandomKey key = RandomKey(recipe.seed).child("leaf");
  const auto wobble = noise_field(key.child("wobble"), {.across = 6, .along = 6, .octaves = 3}, pixels);
  const auto mottle = noise_field(key.child("mottle"), {.across = 5, .along = 5, .octaves = 5, .gain = 0.6F}, pixels);
  const TileableCells net(key.child("net"), 44, 54, 0.38F);

  Canvas canvas(pixels, progress);
  paint(canvas, [&](float u, float v, std::size_t i) {
    const LeafVeins::Spot spot = veins.at(u, v, i / static_cast<std::size_t>(pixels), wobble[i]);
    const float mesh = 1 - rise(0, 0.006F, net.at(u, v).border);
    const float fine = std::max(0.7F * spot.cross, 0.35F * mesh);

    const float inward = map.widest > 0 ? map.margin[i] / map.widest : 0;
    const float turned = paints.has_autumn ? rise(0.75F, 0.05F, inward + 0.3F * mottle[i] + 0.25F * (1 - spot.swell))
                                           : rise(0.25F, 0, inward);
    Vec3 light = glm::mix(paints.blade, paints.edge, turned);
    light *= std::max(0.05F, 1 + paints.contrast * (0.13F * mottle[i] + 0.1F * (spot.swell - 0.5F)));
    const float vein =
        std::max({0.95F * spot.main, (1 - spot.main) * 0.65F * spot.side, (1 - spot.main) * 0.22F * fine});
    light = glm::mix(light, paints.veins, std::min(1.0F, paints.contrast * vein));
    const float height =
        0.0045F * spot.swell - 0.004F * spot.main - (1 - spot.main) * (0.0022F * spot.side + 0.0006F * fine);
    return Dab{light, height};
  });
  if (shape.masked) canvas.cover = map.cover;
  return finish_texture(canvas, {"leaf", colour, {.relief = recipe.relief, .aspect = shape.aspect}});
}

}  // namespace meristem

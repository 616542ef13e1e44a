// SPDX-License-Identifier: Apache-2.0
// Paints a petal: a throat with its own colour, lines that fan out from the claw, and a thin, slightly paler edge.
#include <cmath>

#include "meristem/base/colour.h"
#include "meristem/shape/texture/blade_map.h"
#include "meristem/shape/texture/noise_field.h"
#include "meristem/shape/texture/texture_canvas.h"

namespace meristem {

namespace {

constexpr int kLines = 13;  // lines that fan out from the claw to each side

/// The strength of each line, and its deviation to one side, from -1 to 1.
struct Line {
  float strength;
  float stray;
};

std::vector<Line> make_lines(RandomKey key) {
  std::vector<Line> lines;
  for (std::uint64_t k = 0; k < 2 * kLines + 1; ++k) {
    lines.push_back({static_cast<float>(key.uniform(k, 0.1, 1)), static_cast<float>(2 * key.uniform(k, 1) - 1)});
  }
  return lines;
}

}  // namespace

Texture make_petal_texture(const PetalRecipe& recipe, const TextureShape& shape, Vec3 colour, int pixels,
                           const Progress& progress) {
  const BladeMap map(shape, pixels);
  const Vec3 petal = linear_from_srgb(colour);
  const Vec3 throat = recipe.throat ? linear_from_srgb(*recipe.throat) : petal;
  const Vec3 stripes = recipe.stripes ? linear_from_srgb(*recipe.stripes) : 0.93F * petal;
  const auto throat_length = static_cast<float>(recipe.throat_length);
  const RandomKey key = RandomKey(recipe.seed).child("petal");
  const std::vector<Line> lines = make_lines(key.child("lines"));
  const auto clouds = noise_field(key.child("clouds"), {.across = 3, .along = 3, .octaves = 4}, pixels);
  const auto waver = noise_field(key.child("waver"), {.across = 4, .along = 2}, pixels);
  const float length = map.midrib.high - map.midrib.low;

  Canvas canvas(pixels, progress);
  paint(canvas, [&](float u, float v, std::size_t i) {
    const BladeMap::Reach& reach = map.rows[i / static_cast<std::size_t>(pixels)];
    const float half_width = std::max(u < 0.5F ? 0.5F - reach.low : reach.high - 0.5F, 1e-3F);
    const float along = (v - map.midrib.low) / length;

    // Near the claw, the lines are too close to be distinguished.
    const float last = static_cast<float>(kLines);
    const float place = std::clamp(last * ((u - 0.5F) / half_width + 0.04F * waver[i]), -last, last);
    const float nearest = std::floor(place + 0.5F);
    const Line& line = lines[static_cast<std::size_t>(nearest + last)];
    const float told_apart = rise(2, 6, half_width / last * static_cast<float>(pixels));
    const float off = std::abs(place - nearest - 0.2F * line.stray);
    const float fan = told_apart * line.strength * rise(0.3F, 0, off);

    const float inward = map.widest > 0 ? map.margin[i] / map.widest : 0;
    Vec3 light = (1 + 0.07F * clouds[i]) * petal;
    light = glm::mix(light, glm::mix(petal, Vec3(1), 0.35F), 0.6F * rise(0.3F, 0, inward));
    light = glm::mix(light, stripes, 0.9F * fan * rise(0.95F, 0.25F, along + 0.2F * line.stray));
    light = glm::mix(light, throat, rise(throat_length, 0, along + 0.25F * throat_length * waver[i]));
    return Dab{light, 0.0018F * clouds[i] - 0.0006F * fan};
  });
  if (shape.masked) canvas.cover = map.cover;
  return finish_texture(canvas, {"petal", colour, {.relief = recipe.relief, .aspect = shape.aspect}});
}

}  // namespace meristem

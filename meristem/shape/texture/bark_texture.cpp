// SPDX-License-Identifier: Apache-2.0
// Paints bark: prepares colours and noise from a recipe, lets the function of the style fill a canvas, and makes the
// texture from the canvas.
#include <cmath>

#include "meristem/base/colour.h"
#include "meristem/shape/texture/bark_style.h"

namespace meristem {

BarkPaints::BarkPaints(const BarkRecipe& recipe, Vec3 colour, int pixels_a_side, const Progress& work)
    : pixels(pixels_a_side),
      progress(work),
      key(RandomKey(recipe.seed).child("bark")),
      scale(static_cast<float>(recipe.scale)),
      contrast(static_cast<float>(recipe.contrast)),
      bark(linear_from_srgb(colour)),
      seams(recipe.seams ? linear_from_srgb(*recipe.seams) : Vec3(0.20F, 0.17F, 0.15F) * bark) {
  if (recipe.marks) marks = linear_from_srgb(*recipe.marks);
}

int BarkPaints::count(double usual, int min) const {
  return std::clamp(static_cast<int>(usual / static_cast<double>(scale) + 0.5), min, 400);
}

int BarkPaints::area_count(double usual) const {
  return std::clamp(static_cast<int>(usual / (static_cast<double>(scale) * static_cast<double>(scale)) + 0.5), 1,
                    100'000);
}

Texture make_bark_texture(const BarkRecipe& recipe, Vec3 colour, int pixels, const Progress& progress) {
  const BarkPaints paints(recipe, colour, pixels, progress);
  Finish finish{.name = {}, .colour = colour, .form = {.relief = recipe.relief, .wraps = true}};
  switch (recipe.style) {
    case BarkRecipe::Style::smooth:
      finish.name = "smooth bark";
      return finish_texture(paint_smooth_bark(paints), finish);
    case BarkRecipe::Style::furrowed:
      finish.name = "furrowed bark";
      return finish_texture(paint_furrowed_bark(paints), finish);
    case BarkRecipe::Style::plated:
      finish.name = "plated bark";
      return finish_texture(paint_plated_bark(paints), finish);
    case BarkRecipe::Style::peeling:
      break;
  }
  finish.name = "peeling bark";
  return finish_texture(paint_peeling_bark(paints), finish);
}

}  // namespace meristem

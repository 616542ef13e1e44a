// SPDX-License-Identifier: Apache-2.0
// Old oak, ash, poplar, willow: ridges that run along the stem, separate and join again, with dark furrows between
// them. Ridges are long cells in a brick bond, whose pointed ends form the network. The width of furrows varies, and
// neighbours grow together where it falls below 0.
#include "meristem/shape/texture/bark_style.h"
#include "meristem/shape/texture/tileable_cells.h"

namespace meristem {

Canvas paint_furrowed_bark(const BarkPaints& paints) {
  const int columns = paints.count(20, 3);
  const int rows = paints.even_count(4);
  const float ridge = 1 / static_cast<float>(columns);
  const float length = 1 / static_cast<float>(rows);
  const TileableCells ridges(paints.key.child("ridges"), columns, rows, 0.38F);
  const TileableCells blocks(paints.key.child("blocks"), 2 * columns, paints.even_count(30), 0.36F);
  const auto bend = paints.noise("bend", {.across = columns, .along = 3 * rows, .octaves = 3});
  const auto slip = paints.noise("slip", {.across = columns, .along = rows, .octaves = 2});
  const auto gaps = paints.noise("gaps", {.across = columns, .along = 2 * rows, .octaves = 3});
  const auto fibres = paints.noise("fibres", {.across = 4 * columns, .along = 5 * rows, .octaves = 3});
  const auto broad = paints.noise("broad", {.across = 3, .along = 2});
  const auto crusts = paints.noise("crusts", {.across = 4, .along = 3, .octaves = 5, .gain = 0.65F});

  Canvas canvas(paints.pixels, paints.progress);
  paint(canvas, [&](float u, float v, std::size_t i) {
    // Shift the ridges along each other, so that their ends do not form rows.
    const float bent_u = u + 0.33F * ridge * bend[i];
    const TileableCells::Spot spot = ridges.at(bent_u, v + 0.75F * length * slip[i]);

    // Rise from the furrow's floor to the ridge's crest.
    const float gap = 0.07F + 0.13F * gaps[i] + 0.03F * fibres[i];
    const float edge = spot.border / ridge;
    const float crest = rise(gap - 0.04F, gap + 0.2F, edge);
    const float top = rise(gap + 0.05F, gap + 0.4F, edge);

    // Break the crests across into short blocks.
    const auto block = crest > 0 ? blocks.at(bent_u, v + 0.1F * ridge * bend[i]) : TileableCells::Spot();
    const float crack = (1 - rise(0.01F, 0.09F, block.border / ridge)) * rise(-0.3F, 0.6F, slip[i]) * crest;

    const float shade = 0.16F * fibres[i] + 0.2F * (ridges.random(spot.cell, 0) - 0.5F) +
                        0.2F * (blocks.random(block.cell, 0) - 0.5F) + 0.14F * broad[i] + 0.25F * top;
    Vec3 light = paints.tone(shade) * paints.bark;
    light = paints.toward(light, paints.seams, 0.5F * crack);
    light = paints.toward(light, paints.tone(0.4F * fibres[i]) * paints.seams, 1 - crest);
    if (paints.marks) light = glm::mix(light, *paints.marks, 0.75F * top * rise(0.2F, 0.6F, crusts[i]));
    return Dab{light, ridge * (0.42F * crest + 0.1F * top + 0.05F * fibres[i] - 0.07F * crack)};
  });
  return canvas;
}

}  // namespace meristem

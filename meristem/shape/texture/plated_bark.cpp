// SPDX-License-Identifier: Apache-2.0
// Old pines and planes: thick plates outlined by dark cracks. Each plate is a stack of thin scales. Where upper scales
// have fallen off, lower ones with another tone are visible, with a step at their edge.
#include "meristem/shape/texture/bark_style.h"
#include "meristem/shape/texture/tileable_cells.h"

namespace meristem {

Canvas paint_plated_bark(const BarkPaints& paints) {
  const int columns = paints.count(11, 2);
  const int rows = paints.even_count(5);
  const float plate = 1 / static_cast<float>(columns);
  const TileableCells plates(paints.key.child("plates"), columns, rows, 0.4F);
  const TileableCells scales(paints.key.child("scales"), 2 * columns, 4 * rows, 0.4F);
  const NoiseParameters jagged{.across = columns, .along = 2 * rows, .octaves = 5, .gain = 0.6F};
  const auto bend = paints.noise("bend", jagged);
  const auto slip = paints.noise("slip", jagged);
  const auto gaps = paints.noise("gaps", {.across = columns, .along = 2 * rows, .octaves = 4});
  const auto grain = paints.noise("grain", {.across = 6 * columns, .along = 12 * rows, .octaves = 2});
  const auto crusts = paints.noise("crusts", {.across = 4, .along = 3, .octaves = 5, .gain = 0.65F});
  const Vec3 fresh = Vec3(1.25F, 0.93F, 0.68F) * paints.bark;  // scales that were uncovered recently

  Canvas canvas(paints.pixels, paints.progress);
  paint(canvas, [&](float u, float v, std::size_t i) {
    const float du = plate * bend[i];
    const float dv = plate * slip[i];
    const TileableCells::Spot spot = plates.at(u + 0.2F * du, v + 0.45F * dv);

    // Rise steeply from the cracks, which nearly close here and there.
    const float edge = spot.border / plate;
    const float gap = 0.035F + 0.045F * gaps[i];
    const float crest = rise(gap - 0.02F, gap + 0.07F, edge);
    const auto scale = crest > 0 ? scales.at(u + 0.35F * du, v + 0.35F * dv) : TileableCells::Spot();
    const float layer = scales.random(scale.cell, 0);
    // Scales thin out toward the plate's edge.
    const float worn = rise(0.3F, 0, edge - 0.2F * layer + 0.05F * gaps[i]);
    const float step = 1 - rise(0, 0.04F, scale.border / plate);

    const float shade = 0.14F * grain[i] + 0.35F * (layer - 0.5F) + 0.15F * (plates.random(spot.cell, 1) - 0.5F);
    const float freshness =
        0.55F * plates.random(spot.cell, 0) + 0.45F * scales.random(scale.cell, 1) + 0.25F * crusts[i] + 0.3F * worn;
    Vec3 light = paints.tone(shade) * glm::mix(paints.bark, fresh, rise(0.3F, 0.8F, freshness));
    light = paints.toward(light, paints.seams, 0.4F * step * crest);
    light = paints.toward(light, paints.tone(0.3F * grain[i]) * paints.seams, 1 - crest);
    if (paints.marks) light = glm::mix(light, *paints.marks, 0.7F * crest * rise(0.2F, 0.6F, crusts[i]));
    const float height = 0.2F * crest + 0.05F * layer * crest - 0.06F * worn - 0.02F * step * crest + 0.012F * grain[i];
    return Dab{light, plate * height};
  });
  return canvas;
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Beech, hornbeam and the young stems of most trees: even bark with soft cloudy patches, finely wrinkled across, with
// scattered lenticels.
#include "meristem/shape/texture/bark_style.h"
#include "meristem/shape/texture/mark_map.h"

namespace meristem {

namespace {

/// Returns short corky warts, wider than high.
MarkMap lenticels_of(const BarkPaints& paints) {
  const auto draw = [&](MarkMap& map, Vec2 centre, RandomKey own, int) {
    const Vec2 reach = paints.scale * Vec2(own.uniform(2, 0.003, 0.01), own.uniform(3, 0.0014, 0.003));
    const auto strength = static_cast<float>(own.uniform(4, 0.1, 0.8));
    map.add(centre, reach, [&](Vec2 position) { return strength * rise(1, 0, glm::dot(position, position)); });
  };
  return scattered_marks(paints.pixels, paints.area_count(500), paints.key.child("lenticels"), draw);
}

}  // namespace

Canvas paint_smooth_bark(const BarkPaints& paints) {
  const MarkMap lenticels = lenticels_of(paints);
  const auto clouds =
      paints.noise("clouds", {.across = paints.count(4), .along = paints.count(3), .octaves = 6, .gain = 0.6F});
  const auto patches =
      paints.noise("patches", {.across = paints.count(6), .along = paints.count(6), .octaves = 5, .gain = 0.55F});
  const auto crusts =
      paints.noise("crusts", {.across = paints.count(9), .along = paints.count(8), .octaves = 4, .gain = 0.6F});
  const auto wrinkles = paints.noise("wrinkles", {.across = paints.count(9), .along = paints.count(40)});
  const auto grain = paints.noise("grain", {.across = paints.count(64), .along = paints.count(64), .octaves = 2});

  Canvas canvas(paints.pixels, paints.progress);
  paint(canvas, [&](float, float, std::size_t i) {
    const float wart = lenticels.at(i);
    const float shade = 0.2F * clouds[i] + 0.04F * wrinkles[i] + 0.06F * grain[i];
    Vec3 light = paints.tone(shade) * paints.bark;
    // Dark stains, and pale crusts of lichen that hardly differ from the bark.
    light = paints.toward(light, 0.72F * paints.bark, 0.8F * rise(0.25F, 0.8F, crusts[i]));
    const float patch = rise(0.25F, 0.45F, patches[i] + 0.08F * grain[i]);
    light = paints.toward(light, paints.marks.value_or(Vec3(1.3F, 1.34F, 1.25F) * paints.bark), 0.7F * patch);
    light = paints.toward(light, paints.seams, 0.6F * wart + 0.1F * rise(0.4F, 1.0F, -wrinkles[i]));
    const float height = 0.0012F * wart + 0.0005F * wrinkles[i] + 0.0004F * grain[i] + 0.002F * clouds[i];
    return Dab{light, paints.scale * height};
  });
  return canvas;
}

}  // namespace meristem

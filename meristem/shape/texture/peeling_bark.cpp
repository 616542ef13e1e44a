// SPDX-License-Identifier: Apache-2.0
// Birch and cherry: thin pale sheets around the stem that peel off across it, lenticels as long dashes, and rough black
// patches where the bark has burst.
#include <cmath>

#include "meristem/shape/texture/bark_style.h"
#include "meristem/shape/texture/mark_map.h"

namespace meristem {

namespace {

constexpr float kSheet = 0.0016F;  // thickness of a peeling sheet, in widths of the tile

MarkMap dashes_of(const BarkPaints& paints) {
  const auto draw = [&](MarkMap& map, Vec2 centre, RandomKey own, int) {
    // Many are short and few are long.
    const double longer = own.uniform(2) * own.uniform(3);
    const Vec2 reach =
        paints.scale * Vec2(0.004 + 0.045 * longer, 0.0012 + 0.0022 * longer + own.uniform(4, 0, 0.0008));
    const auto strength = static_cast<float>(own.uniform(5, 0.3, 1));
    map.add(centre, reach, [&](Vec2 position) { return strength * rise(1, 0.35F, glm::dot(position, position)); });
  };
  return scattered_marks(paints.pixels, paints.area_count(300), paints.key.child("dashes"), draw);
}

/// Returns where a sheet is loose along a tear: from 0 far above to 1 at the curled edge.
MarkMap tears_of(const BarkPaints& paints) {
  const auto draw = [&](MarkMap& map, Vec2 centre, RandomKey own, int) {
    const Vec2 reach = paints.scale * Vec2(own.uniform(2, 0.06, 0.22), own.uniform(3, 0.006, 0.014));
    map.add(centre, reach, [&](Vec2 position) {
      const float depth = 1 - position.x * position.x;
      const float above = 0.5F * (1 + position.y);
      return above < depth ? 1 - above / depth : 0.0F;
    });
  };
  return scattered_marks(paints.pixels, paints.area_count(13), paints.key.child("tears"), draw);
}

/// Returns black marks, 1 in their middle and 0 at their edge: lozenges, and the two-winged beards over old branches.
MarkMap scars_of(const BarkPaints& paints) {
  const auto draw = [&](MarkMap& map, Vec2 centre, RandomKey own, int k) {
    const Vec2 reach = paints.scale * Vec2(own.uniform(2, 0.04, 0.15), own.uniform(3, 0.025, 0.07));
    if (k % 3 == 1) {
      map.add(centre, 1.2F * reach, [](Vec2 position) {
        const float across = std::min(1.0F, std::abs(position.x));
        const float ridge = 0.6F - 1.4F * across * (1.3F - 0.5F * across);
        return std::clamp(1 - std::abs(position.y - ridge) / (0.5F - 0.42F * across), 0.0F, 1.0F) * (1 - 0.4F * across);
      });
    } else {
      map.add(centre, reach, [](Vec2 position) {
        return 1 - std::min(1.0F, std::abs(position.x) + std::abs(position.y) * std::abs(position.y));
      });
    }
  };
  return scattered_marks(paints.pixels, paints.area_count(5), paints.key.child("scars"), draw);
}

}  // namespace

Canvas paint_peeling_bark(const BarkPaints& paints) {
  const MarkMap dashes = dashes_of(paints);
  const MarkMap tears = tears_of(paints);
  const MarkMap scars = scars_of(paints);
  const auto bands = paints.noise("bands", {.across = paints.count(2), .along = paints.count(12), .octaves = 4});
  const auto streaks = paints.noise("streaks", {.across = paints.count(5), .along = paints.count(60)});
  const auto wander = paints.noise("wander", {.across = paints.count(8), .along = paints.count(9), .octaves = 4});
  const auto rough =
      paints.noise("rough", {.across = paints.count(36), .along = paints.count(18), .octaves = 4, .gain = 0.7F});
  const Vec3 open = paints.marks.value_or(Vec3(0.95F, 0.74F, 0.56F) * paints.bark);

  Canvas canvas(paints.pixels, paints.progress);
  paint(canvas, [&](float u, float v, std::size_t i) {
    const float wandering = paints.scale * 0.022F * wander[i];
    Vec3 light = paints.tone(0.07F * bands[i] + 0.06F * streaks[i]) * paints.bark;
    light = paints.toward(light, open, 0.4F * rise(0.1F, 0.9F, bands[i]));
    light = paints.toward(light, paints.seams, 0.75F * dashes.at(i));

    // Open the bark above a loose sheet, whose edge curls up and casts a shadow.
    const float tear = tears.at(u, v + 0.35F * wandering + paints.scale * 0.002F * rough[i]);
    light = paints.toward(light, open, 0.7F * rise(0, 0.5F, tear));
    light = paints.toward(light, paints.seams, 0.8F * rise(0.72F, 0.95F, tear));

    // Burst it into rough black patches surrounded by grey.
    const float scar = scars.at(u + wandering, v - wandering);
    const float black = scar > 0 ? rise(0.12F, 0.34F, scar + 0.26F * rough[i]) : 0.0F;
    light =
        paints.toward(light, paints.tone(0.3F * rough[i] + 1.6F * rise(0.3F, 0.9F, rough[i])) * paints.seams, black);
    const float sheet = 0.25F * streaks[i] - rise(0, 0.4F, tear) + 1.6F * rise(0.8F, 1, tear) - 0.5F * dashes.at(i);
    return Dab{light, paints.scale * (kSheet * sheet + black * (0.004F + 0.005F * rough[i]))};
  });
  return canvas;
}

}  // namespace meristem

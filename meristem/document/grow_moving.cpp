// SPDX-License-Identifier: Apache-2.0
#include "meristem/document/grow_moving.h"

#include <optional>
#include <stdexcept>

#include "meristem/document/grow.h"
#include "meristem/document/placing_errors.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

MovingScene grow_moving(const Document& document, Progress& progress, const MovingOptions& options) {
  if (options.keys < 2 || options.keys > kMaxKeys) throw std::invalid_argument("a moving scene has 2 to 1000 keys");
  if (!document.graph.animation) {
    placing_errors(document, []() -> int {
      throw InputError(Diagnostic{.message = "the document has no animation",
                                  .expected = "the key 'animation' with a length in seconds"});
    });
  }
  const double length = document.graph.animation->length;
  MovingSceneMaker maker(document.graph.limits, options.limits, options.keys);
  GrowthCache cache;
  for (std::size_t step = 0; step < options.keys; ++step) {
    // The last key is made right after the first one, so that a scene with too much movement is refused after two
    // growths.
    const std::size_t k = step == 0 ? 0 : step == 1 ? options.keys - 1 : step - 1;
    const double time = length * static_cast<double>(k) / static_cast<double>(options.keys - 1);
    std::optional<Document> other;
    const Document& now = document_at(document, time, other, &progress);
    GrownDocument grown = grow_document(now, progress, {.time = time, .up_to = GrownPart::plant, .cache = &cache});
    placing_errors(now, [&] {
      paint_plant(now, grown.plant, progress, &cache);
      const ExpandedPlant plant(grown.plant, document.graph.limits, progress);
      maker.add(k, time, *plant, progress);
    });
  }
  return placing_errors(document, [&] { return maker.take(progress); });
}

}  // namespace meristem

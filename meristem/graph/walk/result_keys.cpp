// SPDX-License-Identifier: Apache-2.0
// Each key hashes the scene, the limits, the component's text in the document, the sites of the batch, and the parts of
// the view that change the result. Time is included only for components that depend on it.
#include "meristem/graph/walk/result_keys.h"

#include <string_view>
#include <type_traits>

#include "meristem/base/fingerprint.h"

namespace meristem {

namespace {

CacheKey key_of_surroundings(const Scene& scene, const SizeLimits& limits, const CacheRun& results) {
  static_assert(std::has_unique_object_representations_v<SizeLimits>);
  if (!scene.fingerprint) return std::nullopt;
  const std::string_view bytes(reinterpret_cast<const char*>(&limits), sizeof(SizeLimits));
  return results.key([&] { return Fingerprint().add(*scene.fingerprint).add_text(bytes).hash(); });
}

}  // namespace

ResultKeys::ResultKeys(const Graph& graph, const Scene& scene, double time, const ShownGrowth& shown,
                       const CacheRun& results)
    : graph_(graph), time_(time), shown_(shown), surroundings_(key_of_surroundings(scene, graph.limits, results)) {}

CacheKey ResultKeys::of_meshes(ComponentIndex component) const {
  const Prototype& prototype = graph_.components[component];
  return of_component(component, prototype.fingerprint, prototype.depends_on_time);
}

CacheKey ResultKeys::of_growth(const Batch& batch) const {
  const Prototype& prototype = graph_.components[batch.component];
  const CacheKey own = of_component(batch.component, prototype.growth_fingerprint, prototype.growth_depends_on_time);
  if (!own || !batch.places->hash) return std::nullopt;
  return Fingerprint()
      .add(*own)
      .add(*batch.places->hash)
      .add(shown_.unrolls(prototype))
      .add(shown_.request_for(prototype).bits())
      .hash();
}

CacheKey ResultKeys::of_result(const Batch& batch, WantedSites wanted, CacheKey growth) const {
  const Prototype& prototype = graph_.components[batch.component];
  const bool unrolls = shown_.unrolls(prototype);
  const CacheKey own = of_component(batch.component, prototype.fingerprint, prototype.depends_on_time || unrolls);
  if (!own || !batch.places->hash || (prototype.type->grow && !growth)) return std::nullopt;
  Fingerprint key;
  key.add(*own).add(*batch.places->hash).add(wanted.children).add(wanted.branches);
  if (unrolls) {
    const Animation& animation = *graph_.animation;
    key.add(*animation.steps_per_second).add(animation.unfold).add(animation.hold);
  }
  const std::optional<int> step = shown_.step_of(prototype);
  if (step && (prototype.type->grows_in_time || watches_growth(prototype))) key.add(*step).add_text("step");
  if (shown_.shows_outcome()) key.add_text("outcome");
  return key.add(growth.value_or(0)).hash();
}

/// Returns the key of one component in this scene. `of_document` hashes the component's text in the document.
CacheKey ResultKeys::of_component(ComponentIndex component, CacheKey of_document, bool depends_on_time) const {
  if (!surroundings_ || !of_document) return std::nullopt;
  const double time = depends_on_time ? time_ : 0;
  return Fingerprint().add(*surroundings_).add_text(graph_.components[component].id).add(time).add(*of_document).hash();
}

}  // namespace meristem

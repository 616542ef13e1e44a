// SPDX-License-Identifier: Apache-2.0
// Plants that compete grow in one stand, so their growth depends on all batches of that stand. The key of each batch
// therefore covers all of these batches: if one of them changes, all plants of the stand grow again. Plants that grow
// alone have a stand and a key of their own.
#include "meristem/graph/walk/batch_grower.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "meristem/base/fingerprint.h"
#include "meristem/grow/stand.h"

namespace meristem {

std::vector<Grown> BatchGrower::grow(std::span<const Batch> batches) const {
  std::vector<Batch> together;
  std::ranges::copy_if(batches, std::back_inserter(together), [&](const Batch& batch) { return !grows_alone(batch); });
  std::vector<Grown> grown_together = grow_together(together);
  auto next = grown_together.begin();
  std::vector<Grown> grown;
  for (const Batch& batch : batches) grown.push_back(grows_alone(batch) ? grow_alone(batch) : std::move(*next++));
  for (std::size_t k = 0; k < batches.size(); ++k) find_watched(batches, grown, k);
  return grown;
}

bool BatchGrower::grows_alone(const Batch& batch) const {
  const Prototype& prototype = context_.graph.components[batch.component];
  return prototype.type->grows_alone && prototype.type->grows_alone(prototype.parameters.get());
}

/// Grows the plants of all batches in one stand, unless the cache has the whole stand.
std::vector<Grown> BatchGrower::grow_together(std::span<const Batch> batches) const {
  std::vector<Grown> grown = find_stand(batches);
  const bool is_whole = std::ranges::all_of(grown, [](const Grown& one) { return one.batch != nullptr; });
  for (const Batch& batch : batches) context_.results.count<GrownBatch>(is_whole, batch.count());
  if (!is_whole) grow_stand(batches, grown);
  return grown;
}

/// Returns the keys of batches that grow in one stand, and the grown plants of each batch that the cache has. A key is
/// a hash of all batches and of the batch's index. All keys are unset if one batch has no key.
std::vector<Grown> BatchGrower::find_stand(std::span<const Batch> batches) const {
  Fingerprint of_stand;
  bool is_known = true;
  for (const Batch& batch : batches) {
    const CacheKey own = context_.keys.of_growth(batch);
    is_known = is_known && own;
    of_stand.add(own.value_or(0));
  }
  std::vector<Grown> grown(batches.size());
  for (std::size_t k = 0; k < batches.size(); ++k) {
    if (is_known) grown[k].key = Fingerprint(of_stand).add(k).hash();
    grown[k].batch = context_.results.find<GrownBatch>(grown[k].key);
  }
  return grown;
}

/// Grows batches in one stand and stores the plants under the keys of `grown`. The stand returns its plants in the
/// order of planting, so each batch takes as many of the following plants as it has instances.
void BatchGrower::grow_stand(std::span<const Batch> batches, std::span<Grown> grown) const {
  Stand stand;
  for (const Batch& batch : batches) {
    batch.read([&](const Site& site) { plant(batch, site, stand); });
  }
  stand.grow(context_.progress);
  std::vector<std::unique_ptr<GrowthTrace>> traces = stand.take_traces(context_.progress);
  std::vector<Skeleton> skeletons = stand.take_skeletons(context_.progress);
  auto skeleton = std::make_move_iterator(skeletons.begin());
  auto trace = std::make_move_iterator(traces.begin());
  for (std::size_t k = 0; k < batches.size(); ++k) {
    const auto size = static_cast<std::ptrdiff_t>(batches[k].count());
    grown[k].batch = std::make_shared<GrownBatch>(GrownBatch{{skeleton, skeleton + size}, {trace, trace + size}});
    context_.results.store(grown[k].key, grown[k].batch);
    skeleton += size;
    trace += size;
  }
}

/// Grows each instance of a batch in a stand of its own, unless the cache has the batch.
Grown BatchGrower::grow_alone(const Batch& batch) const {
  Grown grown;
  if (const CacheKey own = context_.keys.of_growth(batch)) {
    grown.key = Fingerprint().add(*own).add_text("alone").hash();
  }
  grown.batch = context_.results.find<GrownBatch>(grown.key);
  context_.results.count<GrownBatch>(grown.batch != nullptr, batch.count());
  if (grown.batch != nullptr) return grown;
  grown.batch = std::make_shared<GrownBatch>();
  batch.read([&](const Site& site) {
    Stand stand;
    plant(batch, site, stand);
    stand.grow(context_.progress);
    grown.batch->traces.push_back(std::move(stand.take_traces(context_.progress)[0]));
    grown.batch->skeletons.push_back(std::move(stand.take_skeletons(context_.progress)[0]));
  });
  context_.results.store(grown.key, grown.batch);
  return grown;
}

/// Adds the plant of one instance to a stand.
void BatchGrower::plant(const Batch& batch, const Site& site, Stand& stand) const {
  const Prototype& prototype = context_.graph.components[batch.component];
  const GrowContext context{.scene = context_.scene,
                            .directions = directions_at(site, context_.directions),
                            .limits = context_.graph.limits,
                            .component = prototype.id,
                            .stand = stand,
                            .progress = context_.progress,
                            .keeps_fallen = context_.shown.unrolls(prototype),
                            .request = context_.shown.request_for(prototype)};
  stand.add(prototype.type->grow(prototype, site, context_.time, context));
}

/// Finds the growths that the instances of one batch show. A shown instance has the random key of the instance that
/// shows it. The result of that batch then depends on the shown batches, so its key covers their keys.
void BatchGrower::find_watched(std::span<const Batch> batches, std::span<Grown> all, std::size_t watcher) const {
  const Prototype& prototype = context_.graph.components[batches[watcher].component];
  if (!watches_growth(prototype)) return;
  Grown& grown = all[watcher];
  std::unordered_map<std::uint64_t, std::shared_ptr<const GrowthTrace>> by_key;
  for (std::size_t k = 0; k < batches.size(); ++k) {
    if (context_.graph.components[batches[k].component].id != prototype.shown) continue;
    for (std::size_t s = 0; s < all[k].batch->traces.size(); ++s) {
      by_key.emplace(batches[k].site(s).key.bits(), all[k].batch->traces[s]);
    }
    if (grown.key && all[k].key) grown.key = Fingerprint().add(*grown.key).add(*all[k].key).hash();
    if (!all[k].key) grown.key.reset();
  }
  batches[watcher].read([&](const Site& site) {
    const auto found = by_key.find(site.key.bits());
    grown.watched.push_back(found == by_key.end() ? nullptr : found->second);
  });
}

Skeleton BatchGrower::take_skeleton(const Grown& grown, ComponentIndex component, std::size_t instance,
                                    Progress& progress) const {
  const std::optional<int> step = context_.shown.step_of(context_.graph.components[component]);
  const GrowthTrace* const trace = grown.batch->traces[instance].get();
  if (step && trace != nullptr && *step < trace->last_step()) return trace->standing(*step, context_.scene, progress);
  if (context_.shown.shows_outcome() && trace != nullptr && trace->outcome() != nullptr) return *trace->outcome();
  Skeleton& skeleton = grown.batch->skeletons[instance];
  if (grown.key) return skeleton;
  return std::move(skeleton);  // nobody else needs it
}

}  // namespace meristem

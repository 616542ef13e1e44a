// SPDX-License-Identifier: Apache-2.0
// Instances of one component that the same link leads to are a batch, and expand together. The result of a batch
// depends only on the component in the document, its sites, the scene and the time. A batch with the fingerprint of an
// earlier one is therefore reused. The sites of a link depend on the parents' batch, and are reused in the same way.
// Batches that grow wait until no other batch is left.
#include "meristem/graph/walk/walk.h"

#include <algorithm>
#include <typeinfo>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/emitter.h"
#include "meristem/graph/forecast.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

Walk::Walk(const Graph& graph, const Scene& scene, double time, Progress& progress, WalkOptions options)
    : options_(std::move(options)),
      graph_(graph),
      directions_(scene.directions()),
      progress_(progress),
      results_(options_.cache, {typeid(BatchResult), typeid(Sites), typeid(GrownBatch), typeid(SharedMeshes),
                                typeid(PlantVariant), typeid(PlacedGrowth)}),
      shown_(graph, options_.view),
      keys_(graph, scene, time, shown_, results_),
      context_{graph, scene, directions_, time, progress, shown_, keys_, results_},
      variables_(graph, time),
      links_(graph, scene, directions_, time, progress),
      grower_(context_),
      meshes_(context_),
      queue_(graph),
      memory_(graph.limits),
      made_(graph.components.size()) {}

void Walk::run(WalkVisitor& visitor) {
  require_bounded_counts(graph_, context_.scene, options_.will_place, options_.will_mesh);
  visitor_ = &visitor;
  add_root();
  while (!visitor.is_done()) {
    while (queue_.has_ready() && !visitor.is_done()) expand(queue_.next(), Grown());
    if (visitor.is_done()) return;
    const std::vector<Batch> growing = queue_.take_growing();
    if (growing.empty()) return;
    const std::vector<Grown> grown = grower_.grow(growing);
    for (std::size_t k = 0; k < growing.size(); ++k) expand(growing[k], grown[k]);
  }
}

void Walk::add_root() {
  const ComponentIndex component = graph_.structure.root;
  Site site;
  site.key = RandomKey(graph_.seed);
  SiteList sites;
  sites.add(site);
  Batch root{component, places_of(variables_.draw(component, std::move(sites)))};
  made_[component] = 1;
  visitor_->on_root(root);
  queue_.begin(std::move(root), options_.in_slices);
}

/// Expands the instances of a batch, or reuses their earlier result, and passes their sites on along the links.
void Walk::expand(const Batch& batch, const Grown& grown) {
  const std::vector<LinkIndex> links = links_.links_followed(batch.component, batch.site(0));
  const CacheKey key = keys_.of_result(batch, wanted_by(links), grown.key);
  std::shared_ptr<BatchResult> own;
  std::shared_ptr<const BatchResult> result = find_result(batch.component, key);
  if (result != nullptr && !result->has_sites && !has_children_of(links, key, instances_)) result = nullptr;
  results_.count<BatchResult>(result != nullptr, batch.count());
  if (result == nullptr) {
    own = make_result(batch, links, grown);
    result = own;
    results_.store(key, result);
  }
  show(batch, links, *result, grown);
  nodes_ += result->nodes;
  require_placed(batch.component, *result);
  memory_.add(graph_.components[batch.component].id, *result);
  const std::uint64_t before = instances_;
  for (const LinkIndex link : links) {
    const bool is_last = !key && link == links.back();
    place_children(link, {batch, key, *result}, is_last ? own.get() : nullptr);
  }
  // A result in the cache needs its sites only if the cache lacks children of one of its links.
  if (own != nullptr && (!key || has_children_of(links, key, before))) own->release_sites();
  if (key) own.reset();  // the cache owns it
  queue_.finish(batch, std::move(result), own.get());
}

/// Returns a batch's earlier result. Returns null if the result would exceed a limit: the batch then expands and
/// reports the error.
std::shared_ptr<const BatchResult> Walk::find_result(ComponentIndex component, CacheKey key) {
  std::shared_ptr<const BatchResult> result = results_.find<const BatchResult>(key);
  if (result == nullptr) return nullptr;
  meshes_.keep(component, *result);
  const SizeLimits& limits = graph_.limits;
  const bool fits = nodes_ + result->nodes <= limits.nodes && instances_ + result->offered <= limits.instances &&
                    mesh_bytes() <= limits.mesh_bytes;
  return fits ? result : nullptr;
}

/// Expands the instances of a batch in parallel blocks.
std::shared_ptr<BatchResult> Walk::make_result(const Batch& batch, const std::vector<LinkIndex>& links,
                                               const Grown& grown) {
  const Prototype& prototype = graph_.components[batch.component];
  EmitterContext context = context_of(batch, links);
  // A single instance may report its own stages. For several instances, only their number is reported.
  Progress part(&progress_);
  context.progress = batch.count() == 1 ? &progress_ : &part;
  const std::size_t block = per_block(batch.component);
  auto result = std::make_shared<BatchResult>();
  result->blocks.resize((batch.count() + block - 1) / block);
  progress_.begin("expanding", batch.count());
  parallel_for(batch.count(), block, [&](std::size_t begin, std::size_t end) {
    Emitter emitter(context);
    if (grown.batch != nullptr) {
      std::vector<Skeleton> skeletons(1);  // a block of a component that grows has one instance
      skeletons[0] = grower_.take_skeleton(grown, batch.component, begin, *context.progress);
      emitter.set_grown(std::move(skeletons));
    }
    if (!grown.watched.empty()) emitter.set_watched(grown.watched[begin]);
    const std::vector<Site> sites = batch.places->sites.copy(batch.begin + begin, batch.begin + end);
    prototype.type->expand(prototype, sites, emitter);
    result->blocks[begin / block] = emitter.take();
    progress_.advance(end - begin);
  });
  for (const Emitted& emitted : result->blocks) {
    result->growth_steps = std::max(result->growth_steps, emitted.growth_steps);
  }
  meshes_.measure(batch.component);
  result->nodes = context.nodes - nodes_;
  result->offered = context.instances - instances_;
  return result;
}

/// Shows an expanded batch to the visitor. Its nodes must not be counted yet, so that an instance that is expanded once
/// more stays within the limits.
void Walk::show(const Batch& batch, const std::vector<LinkIndex>& links, const BatchResult& result,
                const Grown& grown) {
  const auto expand_again = [&](std::size_t instance) { return expand_alone(batch, links, instance); };
  visitor_->on_expanded({.batch = batch,
                         .result = result,
                         .grown = grown.batch.get(),
                         .per_block = per_block(batch.component),
                         .expand_alone = expand_again});
}

Emitted Walk::expand_alone(const Batch& batch, const std::vector<LinkIndex>& links, std::size_t instance) {
  const Prototype& prototype = graph_.components[batch.component];
  EmitterContext context = context_of(batch, links);
  context.progress = &progress_;
  Emitter emitter(context);
  const Site site = batch.site(instance);
  prototype.type->expand(prototype, std::span(&site, 1), emitter);
  return emitter.take();
}

/// Returns the context for emitters of the batch's instances. The caller sets its progress.
EmitterContext Walk::context_of(const Batch& batch, const std::vector<LinkIndex>& links) {
  const Prototype& prototype = graph_.components[batch.component];
  const WantedSites wanted = wanted_by(links);
  return {.prototype = prototype,
          .scene = context_.scene,
          .directions = directions_,
          .limits = graph_.limits,
          .meshes = meshes_.of(batch.component),
          .multiplier = links_.multiplier(batch.component, links),
          .together = batch.count(),
          .time = context_.time,
          .animation = graph_.animation ? &*graph_.animation : nullptr,
          .growth_step = shown_.step_of(prototype),
          .key = RandomKey(graph_.seed).child("component").child(prototype.id),
          .wants_child_sites = wanted.children,
          .wants_branch_sites = wanted.branches,
          .site_names = graph_.site_names.size(),
          .site_names_hash = variables_.names_hash(),
          .mesh_bytes = meshes_.bytes().sum_without(batch.component),
          .instances = instances_,
          .nodes = nodes_};
}

/// Throws an InputError if an instance places a component that does not exist.
void Walk::require_placed(ComponentIndex component, const BatchResult& result) const {
  const Prototype& prototype = graph_.components[component];
  if (!prototype.type->placed) return;
  const std::vector<PlacedComponent> placed = prototype.type->placed(prototype.parameters.get());
  std::vector<bool> is_there(placed.size());
  for (const LinkIndex link : graph_.structure.outgoing[component]) {
    if (const auto* made = graph_.links[link].as<PlacedLink>()) is_there[made->name] = true;
  }
  for (const Emitted& block : result.blocks) {
    for (const std::uint32_t name : block.site_names) {
      if (is_there[name]) continue;
      throw InputError(Diagnostic{
          .message = fmt::format("'{}' places '{}', and there is no such component", prototype.id, placed[name].id),
          .expected = "a component of that name",
          .path = "components." + prototype.id});
    }
  }
}

/// Adds the batch of the children by one link. `own` is the parent's result if its sites are not needed again, else
/// null.
void Walk::place_children(LinkIndex link, const Parent& parent, BatchResult* own) {
  const ComponentIndex to = graph_.links[link].to;
  const CacheKey key = key_of_children(link, parent.key);
  std::shared_ptr<const Sites> places = results_.find<const Sites>(key);
  std::vector<std::size_t> per_block;
  if (places == nullptr || instances_ + places->sites.size() > graph_.limits.instances) {
    const LinkSites::Counts before{instances_, parent.batch.count(), made_};
    places = places_of(variables_.draw(to, links_.places(link, parent.result, before, &per_block, own)));
    results_.store(key, places);
  }
  Batch children = queue_.children(parent.batch, link, std::move(places));
  children.first = instances_;
  instances_ += children.count();
  made_[to] += children.count();
  visitor_->on_children({parent.batch, link, children, per_block});
  queue_.add(std::move(children));
}

/// Returns true if the cache has the children of a batch by all these links, and if they stay within the limit.
/// `instances` is the number of instances before.
bool Walk::has_children_of(const std::vector<LinkIndex>& links, CacheKey parent, std::uint64_t instances) {
  return std::ranges::all_of(links, [&](LinkIndex link) {
    const std::shared_ptr<const Sites> places = results_.find<const Sites>(key_of_children(link, parent));
    if (places != nullptr) instances += places->sites.size();
    return places != nullptr && instances <= graph_.limits.instances;
  });
}

/// Returns the key of the children by a link of a batch whose result has this key.
CacheKey Walk::key_of_children(LinkIndex link, CacheKey parent) const {
  const CacheKey own = links_.fingerprint(link);
  if (!parent || !own) return std::nullopt;
  return Fingerprint().add(*parent).add(*own).add(variables_.hash(graph_.links[link].to)).hash();
}

std::shared_ptr<const Sites> Walk::places_of(SiteList sites) const {
  auto places = std::make_shared<Sites>();
  places->sites = std::move(sites);
  if (keys_.are_known()) places->hash = hash_of(places->sites);
  return places;
}

WantedSites Walk::wanted_by(const std::vector<LinkIndex>& links) const {
  WantedSites wanted;
  for (const LinkIndex link : links) (graph_.links[link].is<BranchLink>() ? wanted.branches : wanted.children) = true;
  return wanted;
}

/// Returns the number of instances per block of the component's results.
std::size_t Walk::per_block(ComponentIndex component) const {
  return graph_.components[component].type->grow ? 1 : options_.per_block;
}

}  // namespace meristem

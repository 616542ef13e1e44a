// SPDX-License-Identifier: Apache-2.0
// Instances of one component that the same link leads to are a batch, and expand together. The result of a batch
// depends only on the component in the document, its sites, the scene and the time. A batch with the fingerprint of an
// earlier one is therefore reused. The same holds for the sites of a link, which depend on the batch at its beginning,
// and for a stand.
#include "meristem/graph/expand.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <typeinfo>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/batch_queue.h"
#include "meristem/graph/emitter_context.h"
#include "meristem/graph/forecast.h"
#include "meristem/graph/grow_plantings.h"
#include "meristem/graph/instance_variables.h"
#include "meristem/graph/instances.h"
#include "meristem/graph/link_sites.h"
#include "meristem/graph/memory_limit.h"
#include "meristem/graph/mesh_bytes.h"
#include "meristem/graph/omission.h"
#include "meristem/graph/plant_assembly.h"
#include "meristem/grow/stand.h"
#include "meristem/plant/plant_variant.h"

namespace meristem {

namespace {

/// The grown plants of a batch.
struct Grown {
  CacheKey key;
  std::shared_ptr<GrownBatch> batch;
  // By instance, if the component shows the growth of others
  std::vector<std::shared_ptr<const GrowthTrace>> watched{};
};

class Expansion {
 public:
  Expansion(const Graph& graph, const Scene& scene, double time, Progress& progress, const ExpandOptions& options)
      : graph_(graph),
        scene_(scene),
        directions_(scene.directions()),
        time_(time),
        progress_(progress),
        variables_(graph, time),
        links_(graph, scene, directions_, time, progress),
        queue_(graph),
        memory_(graph.limits),
        assembly_(graph),
        view_(options.view),
        traces_(options.traces),
        will_mesh_(options.will_mesh),
        results_(options.cache, {typeid(BatchResult), typeid(Sites), typeid(GrownBatch), typeid(SharedMeshes),
                                 typeid(PlantVariant), typeid(PlacedGrowth)}),
        is_sliced_(options.cache == nullptr),
        made_(graph.components.size()),
        meshes_(graph.components.size()),
        mesh_bytes_(graph.components.size()) {
    for (const Prototype& prototype : graph.components) {
      if (watches_growth(prototype)) watched_.insert(prototype.shown);
    }
  }

  Plant run() {
    if (traces_ != nullptr) {
      traces_->step = view_.step;
      traces_->of = view_.of;
      traces_->recorded = view_.request;
    }
    walk();
    for (FinishedBatch& finished : queue_.take_results()) hand_on(std::move(finished));
    Plant plant = assembly_.run(mesh_bytes_.sum(), progress_);
    plant.plantings = grow_plantings(graph_, std::move(planting_), view_, traces_, results_, progress_);
    results_.end();
    return plant;
  }

  /// Returns the tree of instances.
  InstanceTree tree(std::uint64_t max) {
    tree_.emplace();
    is_sliced_ = false;
    max_ = max;
    walk();
    return std::move(*tree_);
  }

  std::vector<std::uint64_t> counts() {
    counts_.resize(graph_.components.size());
    is_sliced_ = false;
    walk();
    return std::move(counts_);
  }

  std::vector<BegunClock> clocks() {
    clocks_.emplace();
    is_sliced_ = false;
    walk();
    const auto rank = [](const BegunClock& one) { return std::tuple(one.component, one.clock.start, one.clock.speed); };
    std::ranges::sort(*clocks_, {}, rank);
    const auto is_same = [&](const BegunClock& one, const BegunClock& other) { return rank(one) == rank(other); };
    clocks_->erase(std::unique(clocks_->begin(), clocks_->end(), is_same), clocks_->end());
    return std::move(*clocks_);
  }

  /// Walks until the instance is found. The run does not end, so the results in the cache stay.
  std::optional<FoundInstance> find(const InstanceQuery& request) {
    request_ = &request;
    is_sliced_ = false;
    walk();
    return std::move(found_);
  }

 private:
  void walk() {
    const bool will_place = !tree_ && counts_.empty() && !clocks_ && request_ == nullptr;
    require_bounded_counts(graph_, scene_, will_place, will_mesh_);
    surroundings_ = fingerprint_of_surroundings();
    Site root;
    root.key = RandomKey(graph_.seed);
    SiteList roots;
    roots.add(root);
    Batch first{graph_.structure.root, places_of(variables_.draw(graph_.structure.root, std::move(roots)))};
    if (tree_) first.numbers = note_instances(first, {1}, {kNoIndex}, kNoIndex);
    made_[first.component] = 1;
    queue_.begin(std::move(first), is_sliced_);
    while (!found_) {
      while (queue_.has_ready() && !found_) expand_batch(queue_.next(), Grown());
      const std::vector<Batch> growing = found_ ? std::vector<Batch>() : queue_.take_growing();
      if (growing.empty()) break;
      grow_waiting(growing);
    }
  }

  void hand_on(FinishedBatch finished) {
    const auto has_plants = [](const Emitted& block) { return !block.plants.empty(); };
    if (std::ranges::any_of(finished.result->blocks, has_plants)) {
      planting_.push_back({finished.component, finished.result});
    }
    assembly_.add(finished.component, std::move(finished.result), finished.own);
  }

  /// Returns a hash of the scene and the limits, on which all results depend. Returns nothing if it is unknown or not
  /// needed.
  CacheKey fingerprint_of_surroundings() const {
    static_assert(std::has_unique_object_representations_v<SizeLimits>);
    if (!scene_.fingerprint) return std::nullopt;
    const std::string_view limits(reinterpret_cast<const char*>(&graph_.limits), sizeof(SizeLimits));
    return results_.key([&] { return Fingerprint().add(*scene_.fingerprint).add_text(limits).hash(); });
  }

  /// Returns the fingerprint of one component in this scene.
  CacheKey fingerprint_of(ComponentIndex component, CacheKey of_document, bool depends_on_time) const {
    if (!surroundings_ || !of_document) return std::nullopt;
    const Prototype& prototype = graph_.components[component];
    const double time = depends_on_time ? time_ : 0;
    return Fingerprint().add(*surroundings_).add_text(prototype.id).add(time).add(*of_document).hash();
  }

  /// Returns true if the plants of a component are shown as they have grown up to the present time.
  bool unrolls(const Prototype& prototype) const {
    return prototype.type->grows_in_time && graph_.animation && graph_.animation->steps_per_second &&
           !step_of(prototype);
  }

  /// Returns the growth step at which a component is shown. A component that shows another one's growth is shown at
  /// that one's step.
  std::optional<int> step_of(const Prototype& prototype) const {
    return is_looked_at(view_, prototype.id) || is_looked_at(view_, prototype.shown) ? view_.step : std::nullopt;
  }

  bool shows_outcome() const { return view_.outcome && !view_.step; }

  bool watches_growth(const Prototype& prototype) const {
    return !prototype.shown.empty() && prototype.type->watches_growth &&
           prototype.type->watches_growth(prototype.parameters.get());
  }

  /// Returns the parts of a component's growth to record: the requested parts, and the parts that other components
  /// show.
  TraceRequest request_for(const Prototype& prototype) const {
    TraceRequest request = view_.request;
    if (request.has(TracePart::markers) || step_of(prototype)) request = request | TraceRequest{TracePart::steps};
    if (shows_outcome()) request = request | TraceRequest{TracePart::outcome};
    if (watched_.contains(prototype.id)) request = request | TraceRequest{TracePart::points};
    return request;
  }

  std::shared_ptr<const Sites> places_of(SiteList sites) const {
    auto places = std::make_shared<Sites>();
    places->sites = std::move(sites);
    if (surroundings_) places->hash = hash_of(places->sites);
    return places;
  }

  /// Grows all waiting batches in one stand, except plants that grow alone. Then expands each batch with its grown
  /// plants.
  void grow_waiting(const std::vector<Batch>& batches) {
    std::vector<Batch> together;
    std::copy_if(batches.begin(), batches.end(), std::back_inserter(together),
                 [&](const Batch& batch) { return !grows_alone(batch); });
    std::vector<Grown> grown_together = grow_together(together);
    auto next = grown_together.begin();
    std::vector<Grown> grown;
    for (const Batch& batch : batches) grown.push_back(grows_alone(batch) ? grow_alone(batch) : std::move(*next++));
    for (std::size_t k = 0; k < batches.size(); ++k) {
      find_watched(batches[k], batches, grown, grown[k]);
      expand_batch(batches[k], grown[k]);
    }
  }

  /// Finds the growths that the instances of a batch show. A shown instance has the key of the instance that shows it.
  void find_watched(const Batch& batch, const std::vector<Batch>& batches, const std::vector<Grown>& all,
                    Grown& grown) const {
    const Prototype& prototype = graph_.components[batch.component];
    if (!watches_growth(prototype)) return;
    std::unordered_map<std::uint64_t, std::shared_ptr<const GrowthTrace>> by_key;
    for (std::size_t k = 0; k < batches.size(); ++k) {
      if (graph_.components[batches[k].component].id != prototype.shown) continue;
      for (std::size_t s = 0; s < all[k].batch->traces.size(); ++s) {
        by_key.emplace(batches[k].site(s).key.bits(), all[k].batch->traces[s]);
      }
      if (grown.key && all[k].key) grown.key = Fingerprint().add(*grown.key).add(*all[k].key).hash();
      if (!all[k].key) grown.key.reset();
    }
    batch.read([&](const Site& site) {
      const auto found = by_key.find(site.key.bits());
      grown.watched.push_back(found == by_key.end() ? nullptr : found->second);
    });
  }

  bool grows_alone(const Batch& batch) const {
    const Prototype& prototype = graph_.components[batch.component];
    const auto& grows_alone = prototype.type->grows_alone;
    return grows_alone && grows_alone(prototype.parameters.get());
  }

  CacheKey fingerprint_of_growth(const Batch& batch) const {
    const Prototype& prototype = graph_.components[batch.component];
    const CacheKey own =
        fingerprint_of(batch.component, prototype.growth_fingerprint, prototype.growth_depends_on_time);
    if (!own || !batch.places->hash) return std::nullopt;
    return Fingerprint()
        .add(*own)
        .add(*batch.places->hash)
        .add(unrolls(prototype))
        .add(request_for(prototype).bits())
        .hash();
  }

  /// Grows the plants of all batches in one stand, because they compete with each other. Returns the grown plants of
  /// each batch. Each batch's key covers all batches of the stand: if one plant changes, all of them grow again.
  /// Otherwise all results come from the cache. Skeletons come out of the stand in the order of planting, and are split
  /// by the sizes of the batches.
  std::vector<Grown> grow_together(const std::vector<Batch>& batches) {
    Fingerprint whole;
    bool is_known = true;
    for (const Batch& batch : batches) {
      const CacheKey own = fingerprint_of_growth(batch);
      is_known = is_known && own;
      whole.add(own.value_or(0));
    }
    std::vector<Grown> grown(batches.size());
    bool is_there = true;
    for (std::size_t k = 0; k < batches.size(); ++k) {
      if (is_known) grown[k].key = Fingerprint(whole).add(k).hash();
      grown[k].batch = results_.find<GrownBatch>(grown[k].key);
      is_there = is_there && grown[k].batch != nullptr;
    }
    for (const Batch& batch : batches) count<GrownBatch>(is_there, batch);
    if (is_there) return grown;

    Stand stand;
    for (const Batch& batch : batches) {
      batch.read([&](const Site& site) { plant(batch.component, site, stand); });
    }
    stand.grow(progress_);
    std::vector<std::unique_ptr<GrowthTrace>> traces = stand.take_traces(progress_);
    std::vector<Skeleton> skeletons = stand.take_skeletons(progress_);
    auto next = std::make_move_iterator(skeletons.begin());
    auto trace = std::make_move_iterator(traces.begin());
    for (std::size_t k = 0; k < batches.size(); ++k) {
      const auto size = static_cast<std::ptrdiff_t>(batches[k].count());
      grown[k].batch = std::make_shared<GrownBatch>(GrownBatch{{next, next + size}, {trace, trace + size}});
      results_.store(grown[k].key, grown[k].batch);
      next += size;
      trace += size;
    }
    return grown;
  }

  Grown grow_alone(const Batch& batch) {
    Grown grown;
    if (const CacheKey own = fingerprint_of_growth(batch)) grown.key = Fingerprint().add(*own).add_text("alone").hash();
    grown.batch = results_.find<GrownBatch>(grown.key);
    count<GrownBatch>(grown.batch != nullptr, batch);
    if (grown.batch != nullptr) return grown;
    grown.batch = std::make_shared<GrownBatch>();
    batch.read([&](const Site& site) {
      Stand stand;
      plant(batch.component, site, stand);
      stand.grow(progress_);
      grown.batch->traces.push_back(std::move(stand.take_traces(progress_)[0]));
      grown.batch->skeletons.push_back(std::move(stand.take_skeletons(progress_)[0]));
    });
    results_.store(grown.key, grown.batch);
    return grown;
  }

  void plant(ComponentIndex component, const Site& site, Stand& stand) {
    const Prototype& prototype = graph_.components[component];
    const GrowContext context{scene_,
                              directions_at(site, directions_),
                              graph_.limits,
                              prototype.id,
                              stand,
                              progress_,
                              unrolls(prototype),
                              request_for(prototype)};
    stand.add(prototype.type->grow(prototype, site, time_, context));
  }

  template <class Result>
  void count(bool is_reused, const Batch& batch) {
    results_.count<Result>(is_reused, batch.count());
  }

  /// Expands the instances, or reuses their earlier result, and passes their sites on along the links.
  void expand_batch(const Batch& batch, const Grown& grown) {
    const std::vector<LinkIndex> links = links_.links_followed(batch.component, batch.site(0));
    const CacheKey key = key_of(batch, links, grown);
    std::shared_ptr<BatchResult> own;
    std::shared_ptr<const BatchResult> result = find_result(batch.component, key);
    if (result != nullptr && !result->has_sites && !has_children_of(links, key, instances_)) result = nullptr;
    count<BatchResult>(result != nullptr, batch);
    if (result == nullptr) {
      own = make_result(batch, links, grown);
      result = own;
      results_.store(key, result);
    }
    nodes_ += result->nodes;
    if (traces_ != nullptr) take_traces(batch, grown, *result);
    if (!counts_.empty()) count_instances(batch);
    if (request_ != nullptr) look_for_request(batch, links, *result);
    require_placed(batch.component, *result);
    memory_.add(graph_.components[batch.component].id, *result);
    const std::uint64_t before = instances_;
    for (const LinkIndex link : links) {
      const bool is_last = !key && link == links.back();
      follow(link, batch, key, *result, is_last ? own.get() : nullptr);
    }
    // A result in the cache needs its sites only if the cache lacks children of one of its links.
    if (own != nullptr && (!key || has_children_of(links, key, before))) own->release_sites();
    if (key) own.reset();  // the cache owns it
    queue_.finish(batch, std::move(result), own.get());
  }

  /// Returns the key of the children by a link of a batch with this key.
  CacheKey key_of_children(LinkIndex link, CacheKey parent) const {
    const CacheKey own = links_.fingerprint(link);
    if (!parent || !own) return std::nullopt;
    return Fingerprint().add(*parent).add(*own).add(variables_.hash(graph_.links[link].to)).hash();
  }

  /// Returns true if the cache has the children of a batch by all these links, and if they stay within the limit.
  /// `instances` is the number of instances before.
  bool has_children_of(const std::vector<LinkIndex>& links, CacheKey parent, std::uint64_t instances) {
    return std::ranges::all_of(links, [&](LinkIndex link) {
      const std::shared_ptr<const Sites> places = results_.find<const Sites>(key_of_children(link, parent));
      if (places != nullptr) instances += places->sites.size();
      return places != nullptr && instances <= graph_.limits.instances;
    });
  }

  /// Passes on what was recorded of a batch's growth.
  void take_traces(const Batch& batch, const Grown& grown, const BatchResult& result) {
    const std::string& id = graph_.components[batch.component].id;
    traces_->add_steps(id, result.growth_steps, view_);
    if (grown.batch == nullptr) return;
    for (const std::shared_ptr<const GrowthTrace>& trace : grown.batch->traces) {
      const std::uint32_t instance = grown_instances_[batch.component]++;
      if (trace == nullptr) continue;
      traces_->growths.push_back({id, instance, trace});
      traces_->add_steps(id, trace->last_step(), view_);
    }
  }

  bool wants(const std::vector<LinkIndex>& links, bool branches) const {
    return std::ranges::any_of(links, [&](LinkIndex link) { return graph_.links[link].is<BranchLink>() == branches; });
  }

  CacheKey key_of(const Batch& batch, const std::vector<LinkIndex>& links, const Grown& grown) const {
    const Prototype& prototype = graph_.components[batch.component];
    const CacheKey own =
        fingerprint_of(batch.component, prototype.fingerprint, prototype.depends_on_time || unrolls(prototype));
    if (!own || !batch.places->hash || (grown.batch != nullptr && !grown.key)) return std::nullopt;
    Fingerprint key;
    key.add(*own).add(*batch.places->hash).add(wants(links, false)).add(wants(links, true));
    if (unrolls(prototype)) {
      const Animation& animation = *graph_.animation;
      key.add(*animation.steps_per_second).add(animation.unfold).add(animation.hold);
    }
    const std::optional<int> step = step_of(prototype);
    if (step && (prototype.type->grows_in_time || watches_growth(prototype))) key.add(*step).add_text("step");
    if (shows_outcome()) key.add_text("outcome");
    return key.add(grown.key.value_or(0)).hash();
  }

  /// Returns a batch's earlier result. Returns null if the result would exceed a limit: the batch then expands and
  /// reports the error.
  std::shared_ptr<const BatchResult> find_result(ComponentIndex component, CacheKey key) {
    std::shared_ptr<const BatchResult> result = results_.find<const BatchResult>(key);
    if (result == nullptr) return nullptr;
    SharedMeshes& meshes = meshes_of(component);
    for (const Emitted& block : result->blocks) {
      for (const Emitted::EmittedPrototype& made : block.prototypes) meshes.keep(made.key, made.mesh);
    }
    mesh_bytes_.set(component, meshes.bytes());
    const SizeLimits& limits = graph_.limits;
    const bool fits = nodes_ + result->nodes <= limits.nodes && instances_ + result->offered <= limits.instances &&
                      mesh_bytes_.sum() <= limits.mesh_bytes;
    return fits ? result : nullptr;
  }

  /// Returns the meshes that all batches of a component share, including meshes of the previous expansion.
  SharedMeshes& meshes_of(ComponentIndex component) {
    std::shared_ptr<SharedMeshes>& meshes = meshes_[component];
    if (meshes != nullptr) return *meshes;
    const Prototype& prototype = graph_.components[component];
    const CacheKey key = fingerprint_of(component, prototype.fingerprint, prototype.depends_on_time);
    std::shared_ptr<SharedMeshes> earlier = results_.find<SharedMeshes>(key);
    if (earlier != nullptr) earlier->forget_earlier();
    meshes = std::make_shared<SharedMeshes>(std::move(earlier));
    results_.store(key, meshes);
    return *meshes;
  }

  /// Returns the context for emitters of the batch's instances. The caller sets its progress.
  EmitterContext context_of(const Batch& batch, const std::vector<LinkIndex>& links) {
    const Prototype& prototype = graph_.components[batch.component];
    SharedMeshes& meshes = meshes_of(batch.component);
    return {.prototype = prototype,
            .scene = scene_,
            .directions = directions_,
            .limits = graph_.limits,
            .meshes = meshes,
            .multiplier = links_.multiplier(batch.component, links),
            .together = batch.count(),
            .time = time_,
            .animation = graph_.animation ? &*graph_.animation : nullptr,
            .growth_step = step_of(prototype),
            .key = RandomKey(graph_.seed).child("component").child(prototype.id),
            .wants_child_sites = wants(links, false),
            .wants_branch_sites = wants(links, true),
            .site_names = graph_.site_names.size(),
            .site_names_hash = variables_.names_hash(),
            .mesh_bytes = mesh_bytes_.sum_without(batch.component),
            .instances = instances_,
            .nodes = nodes_};
  }

  /// Expands the instances of a batch in parallel blocks.
  std::shared_ptr<BatchResult> make_result(const Batch& batch, const std::vector<LinkIndex>& links,
                                           const Grown& grown) {
    const Prototype& prototype = graph_.components[batch.component];
    EmitterContext context = context_of(batch, links);
    // A single instance may report its own stages. For several instances, only their number is reported.
    Progress part(&progress_);
    context.progress = batch.count() == 1 ? &progress_ : &part;
    const std::size_t block = grown.batch == nullptr && !tree_ ? kBlock : 1;
    auto result = std::make_shared<BatchResult>();
    result->blocks.resize((batch.count() + block - 1) / block);
    progress_.begin("expanding", batch.count());
    parallel_for(batch.count(), block, [&](std::size_t begin, std::size_t end) {
      Emitter emitter(context);
      if (grown.batch != nullptr) emitter.set_grown(skeleton_of(grown, begin, step_of(prototype), *context.progress));
      if (!grown.watched.empty()) emitter.set_watched(grown.watched[begin]);
      const std::vector<Site> sites = batch.places->sites.copy(batch.begin + begin, batch.begin + end);
      prototype.type->expand(prototype, sites, emitter);
      result->blocks[begin / block] = emitter.take();
      progress_.advance(end - begin);
    });
    for (const Emitted& emitted : result->blocks) {
      result->growth_steps = std::max(result->growth_steps, emitted.growth_steps);
    }
    mesh_bytes_.set(batch.component, meshes_of(batch.component).bytes());
    result->nodes = context.nodes - nodes_;
    result->offered = context.instances - instances_;
    return result;
  }

  /// Returns the grown skeleton of an instance: at the shown step, or after its plan if the view shows the outcome.
  std::vector<Skeleton> skeleton_of(const Grown& grown, std::size_t instance, std::optional<int> step,
                                    Progress& progress) const {
    Skeleton& skeleton = grown.batch->skeletons[instance];
    const GrowthTrace* const trace = grown.batch->traces[instance].get();
    std::vector<Skeleton> one(1);
    if (step && trace != nullptr && *step < trace->last_step()) {
      one[0] = trace->standing(*step, scene_, progress);
    } else if (shows_outcome() && trace != nullptr && trace->outcome() != nullptr) {
      one[0] = *trace->outcome();
    } else if (grown.key) {
      one[0] = skeleton;
    } else {
      one[0] = std::move(skeleton);  // nobody else needs it
    }
    return one;
  }

  /// Throws an InputError if an instance places a component that does not exist.
  void require_placed(ComponentIndex component, const BatchResult& result) const {
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

  /// Adds the batch of the children by one link. `own` is the result if its sites are not needed again, else null.
  void follow(LinkIndex link, const Batch& batch, CacheKey parent, const BatchResult& result, BatchResult* own) {
    const ComponentIndex to = graph_.links[link].to;
    const CacheKey key = key_of_children(link, parent);
    std::shared_ptr<const Sites> places = results_.find<const Sites>(key);
    std::vector<std::size_t> per_parent;
    if (places == nullptr || instances_ + places->sites.size() > graph_.limits.instances) {
      const LinkSites::Counts before{instances_, batch.count(), made_};
      places = places_of(variables_.draw(to, links_.places(link, result, before, tree_ ? &per_parent : nullptr, own)));
      results_.store(key, places);
    }
    Batch children = queue_.children(batch, link, std::move(places));
    instances_ += children.count();
    made_[to] += children.count();
    if (clocks_ && graph_.components[batch.component].type->begins_clock) note_clocks(batch.component, children);
    if (tree_) children.numbers = note_instances(children, per_parent, batch.numbers, link);
    queue_.add(std::move(children));
  }

  /// Records the clocks that a component has begun for its children.
  void note_clocks(ComponentIndex component, const Batch& children) {
    std::optional<InstanceClock> last;
    children.read([&](const Site& site) {
      const bool is_new = !last || last->start != site.clock.start || last->speed != site.clock.speed;
      last = site.clock;
      if (is_new && std::isfinite(site.clock.start)) clocks_->push_back({component, site.clock});
    });
  }

  /// Adds the batch's instances to the tree, `per_parent[k]` of them below the k-th parent. Returns their numbers.
  std::vector<std::uint32_t> note_instances(const Batch& batch, const std::vector<std::size_t>& per_parent,
                                            const std::vector<std::uint32_t>& parents, LinkIndex link) {
    std::vector<InstanceTree::Instance>& all = tree_->instances;
    if (all.size() + batch.count() > max_) {
      throw InputError(Diagnostic{.message = fmt::format("there are more than {} instances", max_),
                                  .expected = "a smaller plant, or a greater number of instances that are drawn",
                                  .path = "components." + graph_.components[batch.component].id});
    }
    std::vector<std::uint32_t> numbers;
    std::size_t parent = 0, of_parent = 0;
    batch.read([&](const Site& site) {
      while (of_parent == per_parent[parent]) {
        ++parent;
        of_parent = 0;
      }
      ++of_parent;
      numbers.push_back(static_cast<std::uint32_t>(all.size()));
      all.push_back({batch.component, parents[parent], link, site.i, site.n});
    });
    return numbers;
  }

  /// Looks for the requested instance in this batch, and sets `found_` if it is there. Parts of a component are
  /// numbered over its batches in order, and `passed_` counts the parts of earlier instances. Blocks that end before
  /// the requested number are skipped by their counts. Within the right block, each instance is expanded again alone,
  /// and its own parts are counted until the number is reached.
  void look_for_request(const Batch& batch, const std::vector<LinkIndex>& links, const BatchResult& result) {
    const Prototype& prototype = graph_.components[batch.component];
    if (prototype.id != request_->component || found_) return;
    const auto count = [&](const Emitted& block) -> std::uint64_t {
      if (request_->of == InstanceQuery::Of::organ) return block.organs.size();
      return static_cast<std::uint64_t>(std::ranges::count_if(block.stems, &EmittedStem::visible));
    };
    if (request_->of == InstanceQuery::Of::instance) {
      if (request_->number - passed_ < batch.count())
        found_ = described(prototype, batch.site(request_->number - passed_));
      passed_ += batch.count();
      return;
    }
    const std::size_t size = prototype.type->grow ? 1 : kBlock;
    for (std::size_t k = 0; k < result.blocks.size(); ++k) {
      const std::uint64_t made = count(result.blocks[k]);
      if (passed_ + made <= request_->number) {
        passed_ += made;
        continue;
      }
      const std::size_t first = batch.begin + k * size;
      const std::vector<Site> of_block = batch.places->sites.copy(first, std::min(first + size, batch.end));
      const Site* site = of_block.size() == 1 ? of_block.data() : nullptr;
      // A block does not store which instance made a part, so each instance is expanded alone.
      EmitterContext context = context_of(batch, links);
      context.progress = &progress_;
      for (std::size_t s = 0; s < of_block.size() && site == nullptr; ++s) {
        Emitter emitter(context);
        prototype.type->expand(prototype, std::span(of_block).subspan(s, 1), emitter);
        const std::uint64_t own = count(emitter.take());
        if (passed_ + own > request_->number) site = &of_block[s];
        passed_ += own;
      }
      if (site != nullptr) found_ = described(prototype, *site);
      return;
    }
  }

  void count_instances(const Batch& batch) {
    const ComponentBase& base = graph_.components[batch.component].base();
    batch.read([&](const Site& site) {
      if (!is_left_out(base, site, time_)) ++counts_[batch.component];
    });
  }

  FoundInstance described(const Prototype& prototype, const Site& site) const {
    FoundInstance found{.site = site, .values = {}};
    const VaryingValues values(prototype.varyings, std::span(&site, 1), time_);
    for (std::size_t k = 0; k < prototype.varyings.size(); ++k) {
      found.values.emplace_back(prototype.varyings[k].path, values.value(k, 0) / prototype.varyings[k].scale);
    }
    return found;
  }

  const Graph& graph_;
  std::vector<PlantingBatch> planting_;
  const Scene& scene_;
  const Directions directions_;
  double time_;
  Progress& progress_;
  InstanceVariables variables_;
  LinkSites links_;
  BatchQueue queue_;
  MemoryLimit memory_;
  PlantAssembly assembly_;
  GrowthView view_;
  GrowthTraces* traces_ = nullptr;
  bool will_mesh_ = false;
  std::unordered_map<ComponentIndex, std::uint32_t> grown_instances_;  // number of instances so far
  CacheRun results_;
  CacheKey surroundings_;
  bool is_sliced_ = false;                  // batches expand in slices, because nobody needs whole ones
  std::vector<std::uint64_t> made_;         // number of instances so far, by component
  std::optional<InstanceTree> tree_;        // set if the tree is requested
  std::uint64_t max_ = 0;                   // maximum number of its instances
  const InstanceQuery* request_ = nullptr;  // the requested part; null: no request
  std::uint64_t passed_ = 0;                // number of such parts made by earlier instances
  std::optional<FoundInstance> found_;
  std::vector<std::uint64_t> counts_;              // instances by component, if requested
  std::optional<std::vector<BegunClock>> clocks_;  // set if the clocks are requested
  std::uint64_t instances_ = 1;                    // the root
  std::uint64_t nodes_ = 0;
  std::vector<std::shared_ptr<SharedMeshes>> meshes_;  // by component
  MeshBytes mesh_bytes_;
  std::unordered_set<std::string_view> watched_;  // ids of components whose growth other components show
};

}  // namespace

InstanceTree instance_tree(const Graph& graph, const Scene& scene, double time, std::uint64_t max, Progress& progress) {
  return Expansion(graph, scene, time, progress, {}).tree(max);
}

std::vector<std::uint64_t> instance_counts(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                           Cache* cache, const GrowthView& view) {
  return Expansion(graph, scene, time, progress, {cache, view}).counts();
}

std::vector<BegunClock> begun_clocks(const Graph& graph, const Scene& scene, double time, Progress& progress,
                                     Cache* cache, const GrowthView& view) {
  return Expansion(graph, scene, time, progress, {cache, view}).clocks();
}

std::optional<FoundInstance> find_instance(const Graph& graph, const Scene& scene, double time,
                                           const InstanceQuery& request, Progress& progress, Cache* cache,
                                           const GrowthView& view) {
  return Expansion(graph, scene, time, progress, {cache, view}).find(request);
}

Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, Cache* cache) {
  return Expansion(graph, scene, time, progress, {cache}).run();
}

Plant expand(const Graph& graph, const Scene& scene, double time, Progress& progress, const ExpandOptions& options) {
  return Expansion(graph, scene, time, progress, options).run();
}

}  // namespace meristem

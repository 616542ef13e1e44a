// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/expand.h"

#include <algorithm>
#include <deque>
#include <iterator>

#include <fmt/format.h>

#include "meristem/base/parallel.h"
#include "meristem/grow/stand.h"

namespace meristem {

namespace {

constexpr std::size_t kBlock = 256;  // instances an emitter takes

/// Instances of one component that expand together.
struct Batch {
  ComponentIndex component = 0;
  std::vector<Site> sites;
};

/// What all instances of one component have made.
struct ComponentOutput {
  std::unordered_map<std::uint64_t, std::uint32_t> prototype_by_key;
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<Organ> organs;
  std::vector<Stem> stems;
};

class Expansion {
 public:
  Expansion(const Graph& graph, const Structure& structure, const Scene& scene, double time, Progress& progress)
      : graph_(graph),
        structure_(structure),
        scene_(scene),
        time_(time),
        progress_(progress),
        outputs_(graph.components.size()),
        link_ordinals_(ordinals_of_links(graph)) {}

  Plant run() {
    Site root;
    root.key = RandomKey(graph_.seed);
    enqueue({structure_.root, {root}});
    while (!ready_.empty() || !growing_.empty()) {
      if (ready_.empty()) {
        grow_waiting();
      } else {
        Batch batch = std::move(ready_.front());
        ready_.pop_front();
        expand_batch(batch, {});
      }
    }
    return assemble();
  }

 private:
  /// Growing components wait for their stand; all others expand in turn.
  void enqueue(Batch batch) {
    if (batch.sites.empty()) return;
    instances_ += batch.sites.size();
    if (instances_ > graph_.limits.instances) {
      throw_limit("instances", static_cast<double>(instances_), graph_.limits.instances, "instances",
                  "components." + graph_.components[batch.component].id);
    }
    const bool grows = static_cast<bool>(graph_.components[batch.component].type->grow);
    (grows ? growing_ : ready_).push_back(std::move(batch));
  }

  /// Grows all that waits in one stand, then expands it with what has grown.
  void grow_waiting() {
    std::deque<Batch> batches = std::move(growing_);
    growing_.clear();
    std::stable_sort(batches.begin(), batches.end(),
                     [](const Batch& a, const Batch& b) { return a.component < b.component; });
    std::vector<std::unique_ptr<Grower>> members;
    for (const Batch& batch : batches) {
      const Prototype& prototype = graph_.components[batch.component];
      const GrowContext context{scene_, graph_.limits, prototype.id, progress_};
      for (const Site& site : batch.sites) members.push_back(prototype.type->grow(prototype, site, time_, context));
    }
    grow_stand(members, progress_);
    std::size_t member = 0;
    for (Batch& batch : batches) {
      std::vector<Skeleton> grown;
      for (std::size_t k = 0; k < batch.sites.size(); ++k) grown.push_back(members[member++]->take_skeleton(progress_));
      expand_batch(batch, std::move(grown));
    }
  }

  /// Expands the instances in parallel blocks and hands their places on along the links.
  void expand_batch(const Batch& batch, std::vector<Skeleton> grown) {
    const Prototype& prototype = graph_.components[batch.component];
    const std::size_t block = grown.empty() ? kBlock : 1;
    const std::size_t blocks = (batch.sites.size() + block - 1) / block;
    progress_.begin("expanding", batch.sites.size());
    std::vector<Emitter> emitters(blocks, Emitter(scene_, time_));
    for (std::size_t k = 0; k < grown.size(); ++k) {
      std::vector<Skeleton> one;
      one.push_back(std::move(grown[k]));
      emitters[k].set_grown(std::move(one));
    }
    parallel_for(batch.sites.size(), block, [&](std::size_t begin, std::size_t end) {
      prototype.type->expand(prototype, std::span(batch.sites).subspan(begin, end - begin), emitters[begin / block]);
      progress_.advance(end - begin);
    });
    for (const LinkIndex link : structure_.outgoing[batch.component]) follow(link, emitters);
    for (Emitter& emitter : emitters) merge(batch.component, emitter);
  }

  /// The places that a link gives its child, over all instances of the parent.
  void follow(LinkIndex index, const std::vector<Emitter>& emitters) {
    const Link& link = graph_.links[index];
    Batch batch{.component = link.to};
    for (const Emitter& emitter : emitters) {
      if (link.kind == LinkKind::branch && !emitter.stems.empty()) {
        for (const EmittedStem& stem : emitter.stems) add_places_along(index, stem, batch.sites);
      } else if (link.kind == LinkKind::branch && !emitter.branch_sites.empty()) {
        for (const Site& site : emitter.branch_sites) add_site(index, site, site.key, batch.sites);
      } else if (link.kind == LinkKind::leaf && !emitter.stems.empty()) {
        for (const EmittedStem& stem : emitter.stems) add_tips(index, stem, batch.sites);
      } else {
        for (const Site& site : emitter.child_sites) {
          if (link.kind != LinkKind::leaf || is_at_recursion_end(link.from, site)) {
            add_site(index, site, site.key, batch.sites);
          }
        }
      }
    }
    enqueue(std::move(batch));
  }

  void add_places_along(LinkIndex index, const EmittedStem& stem, std::vector<Site>& out) {
    const Link& link = graph_.links[index];
    PlacementContext context{.light = unit_vector(scene_.sun),
                             .parent = stem.site,
                             .limits = &graph_.limits,
                             .path = fmt::format("links[{}]", index)};
    context.parent.key = child_key(index, stem.site.key);
    for (const Site& site : place_along(stem.skeleton, link.placement, context)) add_keyed(index, site, out);
  }

  void add_tips(LinkIndex index, const EmittedStem& stem, std::vector<Site>& out) {
    const RandomKey key = child_key(index, stem.site.key);
    std::uint32_t tip = 0;
    for (Site site : tip_sites(stem.skeleton, stem.site)) {
      site.key = key.child(tip++);
      add_keyed(index, site, out);
    }
  }

  void add_site(LinkIndex index, Site site, RandomKey parent, std::vector<Site>& out) {
    site.key = child_key(index, parent).child(site.i);
    add_keyed(index, site, out);
  }

  /// A path element is the child's id, told apart where a parent links to the same child more than once.
  RandomKey child_key(LinkIndex link, RandomKey parent) const {
    return parent.child(graph_.components[graph_.links[link].to].id).child(link_ordinals_[link]);
  }

  /// Counts recursion depths; a link back past the depth that its head allows leads nowhere.
  void add_keyed(LinkIndex index, Site site, std::vector<Site>& out) const {
    const Link& link = graph_.links[index];
    const std::uint32_t closed = structure_.recursion_of_link[index];
    if (closed != kNoIndex) {
      const Structure::Recursion& recursion = structure_.recursions[closed];
      if (site.depths[recursion.level] >= graph_.components[recursion.head].base().recursion) return;
      ++site.depths[recursion.level];
      std::fill(site.depths.begin() + static_cast<std::ptrdiff_t>(recursion.level) + 1, site.depths.end(), 0);
    }
    const std::uint32_t inner = structure_.recursion_of[link.to];
    if (inner != kNoIndex) {
      // A recursion entered from outside starts at 0.
      const std::size_t level = structure_.recursions[inner].level;
      if (closed == kNoIndex && structure_.recursion_of[link.from] != inner &&
          structure_.recursions[inner].head == link.to) {
        site.depths[level] = 0;
      }
      site.depth = site.depths[level];
    }
    out.push_back(site);
  }

  bool is_at_recursion_end(ComponentIndex component, const Site& site) const {
    const std::uint32_t recursion = structure_.recursion_of[component];
    if (recursion == kNoIndex) return true;
    const Structure::Recursion& found = structure_.recursions[recursion];
    return site.depths[found.level] >= graph_.components[found.head].base().recursion;
  }

  /// Takes over what a block made, with prototypes shared by key.
  void merge(ComponentIndex component, Emitter& emitter) {
    ComponentOutput& output = outputs_[component];
    std::vector<std::uint32_t> prototype(emitter.prototypes.size());
    for (std::size_t k = 0; k < prototype.size(); ++k) {
      const auto [found, is_new] = output.prototype_by_key.try_emplace(
          emitter.prototypes[k].key, static_cast<std::uint32_t>(output.meshes.size()));
      if (is_new) output.meshes.push_back(std::move(emitter.prototypes[k].mesh));
      prototype[k] = found->second;
    }
    for (Organ& organ : emitter.organs) {
      organ.prototype = prototype[organ.prototype];
      output.organs.push_back(organ);
    }
    for (EmittedStem& emitted : emitter.stems) {
      if (!emitted.visible) continue;
      output.stems.push_back({.component = graph_.components[component].id,
                              .instance = static_cast<std::uint32_t>(output.stems.size()),
                              .material = 0,
                              .surface = emitted.surface,
                              .skeleton = std::move(emitted.skeleton)});
    }
  }

  Plant assemble() {
    Plant plant;
    for (ComponentIndex c = 0; c < outputs_.size(); ++c) {
      ComponentOutput& output = outputs_[c];
      if (output.meshes.empty() && output.stems.empty()) continue;
      const auto material = static_cast<std::uint32_t>(plant.materials.size());
      plant.materials.push_back(material_of(graph_.components[c]));
      const auto first = static_cast<std::uint32_t>(plant.prototypes.size());
      for (auto& mesh : output.meshes) plant.prototypes.push_back({graph_.components[c].id, material, std::move(mesh)});
      for (Organ& organ : output.organs) {
        organ.prototype += first;
        plant.organs.push_back(organ);
      }
      for (Stem& stem : output.stems) {
        stem.material = material;
        plant.stems.push_back(std::move(stem));
      }
      output = {};
    }
    return plant;
  }

  static Material material_of(const Prototype& prototype) {
    const ComponentBase& base = prototype.base();
    Material material = prototype.type->material;
    material.name = prototype.id;
    material.colour = base.colour.value_or(material.colour);
    material.roughness = static_cast<float>(base.roughness.value_or(material.roughness));
    material.translucency = static_cast<float>(base.translucency.value_or(material.translucency));
    return material;
  }

  static std::vector<std::uint32_t> ordinals_of_links(const Graph& graph) {
    std::unordered_map<std::uint64_t, std::uint32_t> seen;
    std::vector<std::uint32_t> ordinals;
    for (const Link& link : graph.links) ordinals.push_back(seen[std::uint64_t{link.from} << 32 | link.to]++);
    return ordinals;
  }

  const Graph& graph_;
  const Structure& structure_;
  const Scene& scene_;
  double time_;
  Progress& progress_;
  std::deque<Batch> ready_;
  std::deque<Batch> growing_;
  std::uint64_t instances_ = 0;
  std::vector<ComponentOutput> outputs_;
  std::vector<std::uint32_t> link_ordinals_;
};

}  // namespace

Plant expand(const Graph& graph, const Structure& structure, const Scene& scene, double time, Progress& progress) {
  return Expansion(graph, structure, scene, time, progress).run();
}

}  // namespace meristem

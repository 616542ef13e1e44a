// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/expand.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "meristem/base/parallel.h"
#include "meristem/graph/lofts.h"
#include "meristem/graph/looks.h"
#include "meristem/grow/stand.h"
#include "meristem/plant/join_stems.h"

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
  std::vector<Emitter::EmittedPrototype> prototypes;
  std::vector<Organ> organs;
  std::uint32_t stems = 0;
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
    ready_.push_back({structure_.root, {root}});
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
  void enqueue(Batch batch, LinkIndex link) {
    if (batch.sites.empty()) return;
    check_limit(batch.sites.size(), link);
    instances_ += batch.sites.size();
    const bool grows = static_cast<bool>(graph_.components[batch.component].type->grow);
    (grows ? growing_ : ready_).push_back(std::move(batch));
  }

  /// Throws where `more` instances by a link are too many.
  void check_limit(std::uint64_t more, LinkIndex link) const {
    if (instances_ + more <= graph_.limits.instances) return;
    const std::string& from = graph_.components[graph_.links[link].from].id;
    const std::string& to = graph_.components[graph_.links[link].to].id;
    throw_limit(fmt::format("instances, {} of them '{}' on {} of '{}',", more, to, parents_, from),
                static_cast<double>(instances_ + more), graph_.limits.instances, "instances",
                multiplier(graph_.links[link].from, std::span(&link, 1)));
  }

  /// The parameter to change where the children of a component are too many: the depth of a recursion that one of these
  /// links closes, or the component itself.
  std::string multiplier(ComponentIndex component, std::span<const LinkIndex> links) const {
    for (const LinkIndex link : links) {
      const std::uint32_t closed = structure_.recursion_of_link[link];
      if (closed == kNoIndex) continue;
      return fmt::format("components.{}.recursion", graph_.components[structure_.recursions[closed].head].id);
    }
    return "components." + graph_.components[component].id;
  }

  /// Grows all that waits in one stand, but for plants that want to be alone, and expands it with what has grown.
  void grow_waiting() {
    std::deque<Batch> batches = std::move(growing_);
    growing_.clear();
    std::stable_sort(batches.begin(), batches.end(),
                     [](const Batch& a, const Batch& b) { return a.component < b.component; });
    Stand together;
    for (const Batch& batch : batches) {
      if (grows_alone(batch)) continue;
      for (const Site& site : batch.sites) plant(batch.component, site, together);
    }
    together.grow(progress_);
    std::vector<Skeleton> skeletons = together.take_skeletons(progress_);
    auto next = skeletons.begin();
    for (const Batch& batch : batches) {
      std::vector<Skeleton> grown;
      for (const Site& site : batch.sites) {
        grown.push_back(grows_alone(batch) ? grow_alone(batch.component, site) : std::move(*next++));
      }
      expand_batch(batch, std::move(grown));
    }
  }

  bool grows_alone(const Batch& batch) const {
    const Prototype& prototype = graph_.components[batch.component];
    const auto& grows_alone = prototype.type->grows_alone;
    return grows_alone && grows_alone(prototype.parameters.get());
  }

  void plant(ComponentIndex component, const Site& site, Stand& stand) {
    const Prototype& prototype = graph_.components[component];
    const GrowContext context{scene_, graph_.limits, prototype.id, stand, progress_};
    stand.add(prototype.type->grow(prototype, site, time_, context));
  }

  Skeleton grow_alone(ComponentIndex component, const Site& site) {
    Stand stand;
    plant(component, site, stand);
    stand.grow(progress_);
    return std::move(stand.take_skeletons(progress_)[0]);
  }

  /// Expands the instances in parallel blocks and hands their places on along the links.
  void expand_batch(const Batch& batch, std::vector<Skeleton> grown) {
    const Prototype& prototype = graph_.components[batch.component];
    const std::vector<LinkIndex> links = links_followed(batch);
    const auto wants = [&](bool branches) {
      return std::any_of(links.begin(), links.end(),
                         [&](LinkIndex k) { return (graph_.links[k].kind == LinkKind::branch) == branches; });
    };
    parents_ = batch.sites.size();
    const Tinting tinting(prototype);
    EmitterContext context{.scene = scene_,
                           .limits = graph_.limits,
                           .component = prototype.id,
                           .multiplier = multiplier(batch.component, links),
                           .together = batch.sites.size(),
                           .time = time_,
                           .tinting = tinting,
                           .tropism = prototype.type->tropism,
                           .makes_stems = prototype.type->makes_stems,
                           .wants_child_sites = wants(false),
                           .wants_branch_sites = wants(true),
                           .instances = instances_,
                           .nodes = nodes_,
                           .mesh_bytes = mesh_bytes_};
    // One instance may tell its stages; many tell together how many of them are done.
    Progress part(&progress_);
    context.progress = batch.sites.size() == 1 ? &progress_ : &part;
    const std::size_t block = grown.empty() ? kBlock : 1;
    std::vector<Emitter> emitters((batch.sites.size() + block - 1) / block, Emitter(context));
    for (std::size_t k = 0; k < grown.size(); ++k) {
      std::vector<Skeleton> one;
      one.push_back(std::move(grown[k]));
      emitters[k].set_grown(std::move(one));
    }
    progress_.begin("expanding", batch.sites.size());
    parallel_for(batch.sites.size(), block, [&](std::size_t begin, std::size_t end) {
      prototype.type->expand(prototype, std::span(batch.sites).subspan(begin, end - begin), emitters[begin / block]);
      progress_.advance(end - begin);
    });
    nodes_ = context.nodes;
    std::size_t stems = stems_.size();
    for (Emitter& emitter : emitters) {
      emitter.number_stems(static_cast<std::uint32_t>(stems));
      stems += emitter.stems.size();
    }
    require_placed(batch.component, emitters);
    for (const LinkIndex link : links) follow(link, emitters);
    for (Emitter& emitter : emitters) merge(batch.component, emitter);
  }

  /// The links along which a batch has children. All its instances have come by the same links, so they are equally
  /// deep in every recursion: a link back leads on until its depth is reached, a leaf link only from there.
  std::vector<LinkIndex> links_followed(const Batch& batch) const {
    const auto is_at_end = [&](std::uint32_t recursion) {
      const Structure::Recursion& found = structure_.recursions[recursion];
      return batch.sites[0].depths[found.level] + 1 >= graph_.components[found.head].base().recursion;
    };
    std::vector<LinkIndex> links;
    for (const LinkIndex link : structure_.outgoing[batch.component]) {
      const std::uint32_t closed = structure_.recursion_of_link[link];
      const std::uint32_t inside = structure_.recursion_of[batch.component];
      const bool leads_on = closed != kNoIndex                          ? !is_at_end(closed)
                            : graph_.links[link].kind == LinkKind::leaf ? inside == kNoIndex || is_at_end(inside)
                                                                        : true;
      if (leads_on) links.push_back(link);
    }
    return links;
  }

  /// What a component places by itself needs a link to the component of that name.
  void require_placed(ComponentIndex component, const std::vector<Emitter>& emitters) const {
    const Prototype& prototype = graph_.components[component];
    if (!prototype.type->placed) return;
    const std::vector<PlacedComponent> placed = prototype.type->placed(prototype.parameters.get());
    std::vector<bool> is_there(placed.size());
    for (const LinkIndex link : structure_.outgoing[component]) {
      if (graph_.links[link].name != kNoIndex) is_there[graph_.links[link].name] = true;
    }
    for (const Emitter& emitter : emitters) {
      for (const auto& [name, site] : emitter.named_sites) {
        if (is_there[name]) continue;
        throw InputError(Diagnostic{
            .message = fmt::format("'{}' places '{}', and there is no such component", prototype.id, placed[name].id),
            .expected = "a component of that name",
            .path = "components." + prototype.id});
      }
    }
  }

  /// The places that a link gives its child, over all instances of the parent.
  void follow(LinkIndex index, const std::vector<Emitter>& emitters) {
    const Link& link = graph_.links[index];
    const bool has_stems = graph_.components[link.from].type->makes_stems;
    Batch batch{.component = link.to, .sites = {}};
    for (const Emitter& emitter : emitters) {
      std::uint32_t number = emitter.first_stem;
      if (link.kind == LinkKind::branch) {
        for (const EmittedStem& stem : emitter.stems) add_places_along(index, stem, number++, batch.sites);
        for (const Site& site : emitter.branch_sites) add_site(index, site, batch.sites);
      } else if (link.kind == LinkKind::crown) {
        for (const EmittedStem& stem : emitter.stems) add_places_in_crown(index, stem, batch.sites);
      } else if (link.name != kNoIndex) {
        for (const auto& [name, site] : emitter.named_sites) {
          if (name == link.name) add_site(index, site, batch.sites);
        }
      } else if (link.kind == LinkKind::leaf && has_stems) {
        for (const EmittedStem& stem : emitter.stems) add_tips(index, stem, number++, batch.sites);
      } else {
        for (const Site& site : emitter.child_sites) add_site(index, site, batch.sites);
      }
    }
    enqueue(std::move(batch), index);
  }

  void add_places_along(LinkIndex index, const EmittedStem& stem, std::uint32_t number, std::vector<Site>& out) {
    PlacementContext context{.light = unit_vector(scene_.sun),
                             .on_axis = graph_.components[graph_.links[index].to].type->makes_stems,
                             .has_twigs = graph_.components[graph_.links[index].from].type->has_twigs,
                             .stem = number,
                             .parent = stem.site,
                             .limits = &graph_.limits,
                             .path = link_path(graph_, index)};
    context.parent.key = child_key(index, stem.site.key);
    const Link& link = graph_.links[index];
    const Placement* placement = &link.placement;
    std::optional<Placement> own;
    if (stem.branching) {
      context.places = key_of_places(stem.site.key);
      placement = stem.branching.get();
      if (!link.given.empty()) placement = &own.emplace(overridden(*stem.branching, link.placement, link.given));
      if (!(link.placement.density || link.placement.count)) {
        context.path = "components." + graph_.components[link.from].id;
      }
    }
    for (const Site& site : place_along(stem.skeleton, *placement, context)) add_keyed(index, site, out);
    check_limit(out.size(), index);
  }

  void add_places_in_crown(LinkIndex index, const EmittedStem& stem, std::vector<Site>& out) {
    if (!stem.surface.crown) return;
    PlacementContext context{.parent = stem.site, .limits = &graph_.limits, .path = link_path(graph_, index)};
    context.parent.key = child_key(index, stem.site.key);
    for (const Site& site :
         place_in_crown(stem.skeleton, stem.surface, graph_.links[index].in_crown, context, progress_)) {
      add_keyed(index, site, out);
    }
    check_limit(out.size(), index);
  }

  void add_tips(LinkIndex index, const EmittedStem& stem, std::uint32_t number, std::vector<Site>& out) {
    const RandomKey key = child_key(index, stem.site.key);
    for (Site site : tip_sites(stem.skeleton, number, stem.site)) {
      site.key = key.child(site.i);
      add_keyed(index, site, out);
    }
    check_limit(out.size(), index);
  }

  void add_site(LinkIndex index, Site site, std::vector<Site>& out) {
    site.key = child_key(index, site.key).child(site.i);
    add_keyed(index, site, out);
  }

  /// A path element is the child's id, told apart where a parent links to the same child more than once.
  RandomKey child_key(LinkIndex link, RandomKey parent) const {
    return parent.child(graph_.components[graph_.links[link].to].id).child(link_ordinals_[link]);
  }

  /// Counts recursion depths. A recursion entered from outside, or within one that begins anew, starts at 0.
  void add_keyed(LinkIndex index, Site site, std::vector<Site>& out) const {
    const Link& link = graph_.links[index];
    const std::uint32_t closed = structure_.recursion_of_link[index];
    const std::uint32_t inside = structure_.recursion_of[link.to];
    if (closed != kNoIndex) {
      const std::size_t level = structure_.recursions[closed].level;
      ++site.depths[level];
      std::fill(site.depths.begin() + static_cast<std::ptrdiff_t>(level) + 1, site.depths.end(), 0);
    } else if (inside != kNoIndex && structure_.recursions[inside].head == link.to) {
      std::fill(site.depths.begin() + static_cast<std::ptrdiff_t>(structure_.recursions[inside].level),
                site.depths.end(), 0);
    }
    if (inside != kNoIndex) site.depth = site.depths[structure_.recursions[inside].level];
    out.push_back(site);
  }

  /// Takes over what a block made, with prototypes shared by key.
  void merge(ComponentIndex component, Emitter& emitter) {
    ComponentOutput& output = outputs_[component];
    std::vector<std::uint32_t> prototype(emitter.prototypes.size());
    for (std::size_t k = 0; k < prototype.size(); ++k) {
      const auto [found, is_new] = output.prototype_by_key.try_emplace(
          emitter.prototypes[k].key, static_cast<std::uint32_t>(output.prototypes.size()));
      if (is_new) {
        mesh_bytes_ += emitter.prototypes[k].mesh->bytes();
        output.prototypes.push_back(std::move(emitter.prototypes[k]));
      }
      prototype[k] = found->second;
    }
    for (Organ& organ : emitter.organs) {
      organ.prototype = prototype[organ.prototype];
      output.organs.push_back(organ);
    }
    for (EmittedSection& section : emitter.sections) sections_.push_back({std::move(section), component});
    for (EmittedStem& emitted : emitter.stems) {
      LooseStem& stem = stems_.emplace_back();
      component_of_stem_.push_back(component);
      if (!emitted.visible) continue;  // without a node
      stem.part = {.component = graph_.components[component].id,
                   .instance = output.stems++,
                   .surface = emitted.surface,
                   .tint = emitted.tint};
      // What `place` has moved hangs on nothing.
      const bool is_moved = emitted.moved.has_value();
      if (is_moved && stem.part.surface.crown) stem.part.surface.crown->scale(emitted.moved_scale);
      stem.mother = is_moved ? kNoStem : emitted.site.stem;
      stem.node = emitted.site.node;
      stem.along = emitted.site.along;
      stem.skeleton = std::move(is_moved ? *emitted.moved : emitted.skeleton);
    }
  }

  /// Throws where this material's texture is one too many. What it shares with others counts once.
  void count_pixels(const Material& material) {
    if (material.texture == nullptr || !textures_.insert(material.texture.get()).second) return;
    const Image& colour = material.texture->colour;
    texture_pixels_ += static_cast<std::uint64_t>(colour.width) * static_cast<std::uint64_t>(colour.height);
    if (texture_pixels_ <= graph_.limits.texture_pixels) return;
    throw_limit("pixels of textures", static_cast<double>(texture_pixels_), graph_.limits.texture_pixels,
                "texture_pixels", fmt::format("components.{}.texture", material.name));
  }

  /// Surfaces of many instances become organs of the components that their pieces belong to.
  void join_surfaces() {
    for (SurfacePiece& piece : join_sections(sections_, graph_, mesh_bytes_, progress_)) {
      ComponentOutput& output = outputs_[piece.component];
      for (Organ& organ : piece.organs) {
        organ.prototype = static_cast<std::uint32_t>(output.prototypes.size());
        output.organs.push_back(organ);
      }
      output.prototypes.push_back({.mesh = std::move(piece.mesh), .is_open = piece.is_open});
    }
  }

  Plant assemble() {
    join_surfaces();
    Plant plant;
    std::vector<std::uint32_t> material_of_component(outputs_.size(), 0);
    for (ComponentIndex c = 0; c < outputs_.size(); ++c) {
      ComponentOutput& output = outputs_[c];
      if (output.prototypes.empty() && output.stems == 0) continue;
      const auto has = [&](bool blades) {
        return std::ranges::any_of(output.prototypes, [&](const auto& made) { return made.is_blade == blades; });
      };
      progress_.check();
      const auto material = static_cast<std::uint32_t>(plant.materials.size());
      const bool has_open = std::ranges::any_of(output.prototypes, [](const auto& made) { return made.is_open; });
      const bool has_own = output.stems > 0 || has(false);
      if (has_own) {
        plant.materials.push_back(material_of(graph_.components[c]));
        if (has_open) plant.materials.back().two_sided = true;
        count_pixels(plant.materials.back());
      }
      const auto blades = static_cast<std::uint32_t>(plant.materials.size());
      if (has(true)) plant.materials.push_back(blades_of(graph_.components[c]));
      const auto first = static_cast<std::uint32_t>(plant.prototypes.size());
      for (Emitter::EmittedPrototype& made : output.prototypes) {
        plant.prototypes.push_back({graph_.components[c].id, made.is_blade ? blades : material, std::move(made.mesh)});
      }
      for (Organ& organ : output.organs) {
        organ.prototype += first;
        plant.organs.push_back(organ);
      }
      output = {};
      material_of_component[c] = material;
    }
    for (std::size_t k = 0; k < stems_.size(); ++k) {
      stems_[k].part.material = material_of_component[component_of_stem_[k]];
    }
    plant.stems = join_stems(std::move(stems_));
    std::erase_if(plant.stems, [](const Stem& stem) { return stem.skeleton.node_count() == 0; });
    return plant;
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
  std::uint64_t instances_ = 1;  // the root
  std::uint64_t parents_ = 0;    // instances whose links are followed
  std::uint64_t nodes_ = 0;
  std::uint64_t mesh_bytes_ = 0;
  std::vector<ComponentOutput> outputs_;
  std::vector<SurfaceSection> sections_;
  std::vector<LooseStem> stems_;  // by number; hidden ones have no nodes
  std::vector<ComponentIndex> component_of_stem_;
  std::vector<std::uint32_t> link_ordinals_;
  std::set<const Texture*> textures_;  // only asked, never walked: addresses have no order to rely on
  std::uint64_t texture_pixels_ = 0;
};

}  // namespace

Plant expand(const Graph& graph, const Structure& structure, const Scene& scene, double time, Progress& progress) {
  return Expansion(graph, structure, scene, time, progress).run();
}

}  // namespace meristem

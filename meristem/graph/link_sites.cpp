// SPDX-License-Identifier: Apache-2.0
// Follows a link from all blocks of the parent's instances in parallel. If several blocks fail, the first fault in the
// order of the blocks is thrown, whatever the threads do.
#include "meristem/graph/link_sites.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "meristem/base/fingerprint.h"
#include "meristem/base/parallel.h"
#include "meristem/graph/placement_parts.h"
#include "meristem/graph/recursion_depths.h"

namespace meristem {

namespace {

std::vector<std::uint32_t> ordinals_of_links(const Graph& graph) {
  std::unordered_map<std::uint64_t, std::uint32_t> seen;
  std::vector<std::uint32_t> ordinals;
  for (const Link& link : graph.links) ordinals.push_back(seen[std::uint64_t{link.from} << 32 | link.to]++);
  return ordinals;
}

/// The sum over all items before the first missing one, in whatever order threads add them.
class LeadingSum {
 public:
  explicit LeadingSum(std::size_t count) : values_(count) {}

  void add(std::size_t item, std::uint64_t value) {
    const std::scoped_lock lock(mutex_);
    values_[item] = value;
    for (; next_ < values_.size() && values_[next_]; ++next_) sum_ += *values_[next_];
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::mutex mutex_;
  std::vector<std::optional<std::uint64_t>> values_;
  std::size_t next_ = 0;
  std::atomic<std::uint64_t> sum_{0};
};

}  // namespace

/// Computes the sites of one link for one block of the parent's instances.
class LinkSites::Writer {
 public:
  Writer(const LinkSites& all, LinkIndex index, Progress& progress, std::uint64_t room)
      : all_(all),
        index_(index),
        link_(all.graph_.links[index]),
        from_(*all.graph_.components[link_.from].type),
        to_(all.graph_.components[link_.to]),
        progress_(progress),
        room_(room) {}

  /// `own` is `parents` if its sites are not needed again, else null.
  SiteList run(const Emitted& parents, Emitted* own) {
    own_ = own;
    std::visit([&](const auto& kind) { add(kind, parents); }, link_.kind);
    sites_.pack();
    return std::move(sites_);
  }

 private:
  void add(const ChildLink&, const Emitted& parents) {
    add_children(parents, &Emitted::child_sites, [](std::size_t) { return true; });
  }

  void add(const BranchLink& branch, const Emitted& parents) {
    const bool is_on_ribs = from_.has_ribs && branch.given.is_empty();
    if (!is_on_ribs) {
      for (const EmittedStem& stem : parents.stems) add_along(stem, branch);
    }
    if (is_on_ribs || !from_.has_ribs) {
      add_children(parents, &Emitted::branch_sites, [](std::size_t) { return true; });
    }
  }

  void add(const LeafLink&, const Emitted& parents) {
    if (!from_.makes_stems) return add(ChildLink(), parents);
    for (const EmittedStem& stem : parents.stems) add_tips(stem);
  }

  void add(const CrownLink& crown, const Emitted& parents) {
    for (const EmittedStem& stem : parents.stems) add_in_crown(stem, crown.placement);
  }

  void add(const PlacedLink& placed, const Emitted& parents) {
    own_ = nullptr;  // other components may stand on these sites
    add_children(parents, &Emitted::named_sites, [&](std::size_t k) { return parents.site_names[k] == placed.name; });
  }

  bool is_full() const { return sites_.size() > room_; }

  PlacementContext context_of(const EmittedStem& stem) const {
    PlacementContext context{.directions = directions_at(stem.site, all_.directions_),
                             .parent = stem.site,
                             .limits = &all_.graph_.limits,
                             .obstacles = &all_.scene_.obstacles,
                             .scene = &all_.scene_,
                             .time = all_.time_,
                             .path = link_path(all_.graph_, index_)};
    context.parent.key = child_key(stem.site.key);
    return context;
  }

  void add_along(const EmittedStem& stem, const BranchLink& branch) {
    if (is_full()) return;
    PlacementContext context = context_of(stem);
    context.stance = to_.type->stance;
    if (context.stance == BranchStance::along_axis && branch.given.contains("angle"))
      context.stance = BranchStance::on_axis;
    context.has_twigs = from_.has_twigs;
    context.stem = stem.id();
    const Skeleton& skeleton = placed_on(stem);
    if (!stem.branching) return add_placed(stem, skeleton, branch.placement, context);
    // A stem's own placement applies, except for keys that the link gives.
    if (!(branch.placement.density || branch.placement.count)) {
      context.path = "components." + all_.graph_.components[link_.from].id;
    }
    if (branch.given.is_empty()) {
      context.places = key_of_places(stem.site.key);
      return add_placed(stem, skeleton, *stem.branching, context);
    }
    add_placed(stem, skeleton, overridden(*stem.branching, branch.placement, branch.given), context);
  }

  /// Places children along a growing stem. They get their positions on the whole stem, so that they keep them while it
  /// grows. Only positions that can carry children at the present step are used.
  void add_placed(const EmittedStem& stem, const Skeleton& skeleton, const BranchPlacement& placement,
                  PlacementContext& context) {
    if (stem.growing == nullptr) {
      return place_in_parts(skeleton, placement, context,
                            [&](std::vector<Site> sites) { add_on(stem, std::move(sites)); });
    }
    if (stem.skeleton.node_count() == 0) return;
    const BearingOverTime bears(stem, placement, context);
    context.everywhere = true;
    place_in_parts(skeleton, placement, context, [&](std::vector<Site> sites) {
      std::erase_if(sites, [&](Site& site) {
        const float share = bears.share(site.node, site.along);
        site.frame.axes *= share;
        return share == 0;
      });
      add_on(stem, std::move(sites));
    });
  }

  /// The shares of a growing stem's positions that carry children. The condition of the placement is evaluated only at
  /// some steps, as far apart as children take to unfold. Between two of these steps the share changes evenly, so that
  /// children do not appear or disappear suddenly.
  class BearingOverTime {
   public:
    BearingOverTime(const EmittedStem& stem, const BranchPlacement& placement, const PlacementContext& context)
        : stem_(stem), now_(bearing_nodes(stem.skeleton, placement, context)) {
      const GrowingStem& growing = *stem.growing;
      const Skeleton& whole = stem.trimmed->whole();
      const float end = *std::ranges::max_element(growing.spans.end);
      if (!(growing.unfold > 0) || growing.step >= end) return;
      // The last step is one of them, so that the final state is exact.
      const double left = (end - growing.step) / growing.unfold;
      share_ = static_cast<float>(std::ceil(left) - left);
      const auto answer_at = [&](double step) {
        Answer answer{standing_at(whole, growing.spans, step, growing.pipe_exponent), {}};
        if (answer.standing.skeleton.node_count() > 0) {
          answer.bears = bearing_nodes(answer.standing.skeleton, placement, context);
        }
        return answer;
      };
      if (share_ < 1) before_ = answer_at(end - std::ceil(left) * growing.unfold);
      if (share_ > 0) after_ = answer_at(end - (std::ceil(left) - 1) * growing.unfold);
    }

    /// Returns the share, 0 to 1, at a position of the whole stem.
    float share(NodeIndex node, float along) const {
      const std::optional<StemPosition> left = stem_.trimmed->left_of({node, along});
      if (!left) return 0;
      const std::optional<bool> before = asked(before_, node, along), after = asked(after_, node, along);
      if (!before && !after) return now_[left->node] != 0 ? 1 : 0;
      // A position that does not exist at one of the steps has no answer there; the other answer is used.
      const bool from = before ? *before : *after, to = after ? *after : *before;
      return from == to ? (from ? 1 : 0) : from ? 1 - share_ : share_;
    }

   private:
    struct Answer {
      TrimmedSkeleton standing;
      std::vector<std::uint8_t> bears;  // by node of the standing skeleton
    };

    static std::optional<bool> asked(const std::optional<Answer>& answer, NodeIndex node, float along) {
      if (!answer) return std::nullopt;
      const float kept = answer->standing.kept[node];
      if (!(kept > 0) || along > kept) return std::nullopt;
      return answer->bears[answer->standing.node[node]] != 0;
    }

    const EmittedStem& stem_;
    std::vector<std::uint8_t> now_;
    std::optional<Answer> before_;
    std::optional<Answer> after_;
    float share_ = 0;  // share of the way from the earlier to the later answer
  };

  void add_in_crown(const EmittedStem& stem, const CrownPlacement& placement) {
    if (!stem.surface->crown || is_full()) return;
    std::vector<Site> sites = place_in_crown(stem.skeleton, *stem.surface, placement, context_of(stem), progress_);
    if (!stem.root_of_node.empty()) {
      for (Site& site : sites) site.individual = 0;  // one crown covers several plants
    }
    add_all(std::move(sites));
  }

  void add_tips(const EmittedStem& stem) {
    if (is_full()) return;
    const RandomKey key = child_key(stem.site.key);
    if (stem.growing != nullptr) return add_growing_tips(stem, key);
    std::vector<Site> tips = tip_sites(placed_on(stem), stem.id(), stem.site);
    for (Site& site : tips) site.key = key.child(site.i);
    add_on(stem, std::move(tips));
  }

  /// Adds the tips of a growing stem's present skeleton. Each is named by its axis on the whole stem, and as old as the
  /// axis.
  void add_growing_tips(const EmittedStem& stem, RandomKey key) {
    if (stem.skeleton.node_count() == 0) return;
    const Skeleton& whole = stem.trimmed->whole();
    std::vector<Site> tips = tip_sites(stem.skeleton, stem.id(), stem.site);
    std::vector<bool> is_named(tips.size(), false);
    for (NodeIndex node = 0; node < whole.node_count(); ++node) {
      const std::optional<StemPosition> left = stem.trimmed->left_of({node, 0});
      if (!left) continue;
      const AxisIndex axis = stem.skeleton.axis[left->node];
      if (is_named[axis]) continue;
      is_named[axis] = true;
      Site& site = tips[axis];
      const float birth = stem.growing->spans.begin[node];
      site.key = key.child(whole.axis[node]);
      site.birth = birth;
      site.appeared = birth / stem.growing->steps_per_second;
      site.individual = stem.individual_at(site.node);
      site.frame.axes *= stem.growing->share_unfolded(node, birth);
    }
    add_all(std::move(tips));
  }

  /// Adds a child at each site of a list whose index fulfils a condition.
  template <class Condition>
  void add_children(const Emitted& parents, SiteList Emitted::*list, const Condition& has_child) {
    std::size_t k = 0;
    const auto receive = [&](const Site& site) {
      if (has_child(k++)) add_child(site);
    };
    if (own_ != nullptr) {
      (own_->*list).consume(receive);
    } else {
      (parents.*list).read(receive);
    }
  }

  void add_child(const Site& site) {
    sites_.pack_chunks();
    Site& child = sites_.add(site);
    child.key = child_key(site.key).child(site.i);
    const bool is_plant = from_.speaks_of_space && site.individual == site.key.bits();
    if (from_.bears_plants || is_plant) child.individual = child.key.bits();
    count_depth(child);
  }

  /// Returns the skeleton along which the children of a stem are placed. For a cut stem this is the whole skeleton;
  /// children on the removed part are left out later.
  static const Skeleton& placed_on(const EmittedStem& stem) {
    const bool is_cut = stem.trimmed != nullptr && stem.trimmed->mode() == TrimMode::cut;
    return is_cut ? stem.trimmed->whole() : stem.skeleton;
  }

  static void leave_out_cut(const TrimmedStem& stem, const GrowingStem* growing, std::vector<Site>& sites) {
    std::erase_if(sites, [&](Site& site) {
      const std::optional<StemPosition> left = stem.left_of({site.node, site.along});
      if (left && growing != nullptr) stem.settle(*growing, {site.node, site.along}, *left, site);
      if (left) std::tie(site.node, site.along) = std::pair(left->node, left->along);
      return !left;
    });
  }

  /// Adds sites on nodes of the skeleton that `placed_on` returns.
  void add_on(const EmittedStem& stem, std::vector<Site> sites) {
    if (&placed_on(stem) != &stem.skeleton) leave_out_cut(*stem.trimmed, stem.growing.get(), sites);
    if (!stem.root_of_node.empty()) {
      for (Site& site : sites) site.individual = stem.individual_at(site.node);
    }
    add_all(std::move(sites));
  }

  void add_all(std::vector<Site> sites) {
    for (const Site& site : sites) {
      sites_.pack_chunks();
      count_depth(sites_.add(site));
    }
  }

  /// Returns the key of the children. It contains the child's id, or the id of the component that the child shows.
  /// Repeated links between two components are distinguished by their index.
  RandomKey child_key(RandomKey parent) const { return parent.child(to_.drawn_as()).child(all_.ordinals_[index_]); }

  void count_depth(Site& site) const {
    const LinkStructure& structure = all_.structure_;
    meristem::count_depth(structure, index_, link_.to, site.depths);
    const std::uint32_t inside = structure.recursion_of[link_.to];
    if (inside != kNoIndex) site.depth = site.depths[structure.recursions[inside].level];
  }

  const LinkSites& all_;
  LinkIndex index_;
  const Link& link_;
  const ComponentType& from_;
  const Prototype& to_;
  Progress& progress_;
  std::uint64_t room_;      // more sites than this are too many and are not computed
  Emitted* own_ = nullptr;  // the parents, if their sites are not needed again
  SiteList sites_;
};

LinkSites::LinkSites(const Graph& graph, const Scene& scene, const Directions& directions, double time,
                     Progress& progress)
    : graph_(graph),
      structure_(graph.structure),
      scene_(scene),
      directions_(directions),
      time_(time),
      progress_(progress),
      ordinals_(ordinals_of_links(graph)) {}

std::vector<LinkIndex> LinkSites::links_followed(ComponentIndex component, const Site& site) const {
  std::vector<LinkIndex> links;
  for (const LinkIndex link : structure_.outgoing[component]) {
    if (leads_on(graph_, link, site.depths)) links.push_back(link);
  }
  return links;
}

SiteList LinkSites::places(LinkIndex link, const BatchResult& parent, Counts before,
                           std::vector<std::size_t>* per_block, BatchResult* own) const {
  const std::size_t blocks = parent.blocks.size();
  const std::uint64_t limit = graph_.limits.instances;
  const std::uint64_t room = limit - std::min(limit, before.all);
  std::vector<SiteList> found(blocks);
  std::vector<std::exception_ptr> errors(blocks);
  LeadingSum lower(blocks);
  parallel_for(blocks, 1, [&](std::size_t block, std::size_t) {
    // If the earlier blocks already have too many sites, this block is skipped to save memory.
    if (lower.sum() > room) return;
    Progress part(&progress_);
    try {
      Emitted* const own_block = own != nullptr ? &own->blocks[block] : nullptr;
      found[block] = Writer(*this, link, blocks == 1 ? progress_ : part, room).run(parent.blocks[block], own_block);
    } catch (const InputError&) {
      errors[block] = std::current_exception();
    }
    lower.add(block, found[block].size());
  });

  // Throws the fault that following the blocks one after another would give.
  std::uint64_t count = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (errors[block]) std::rethrow_exception(errors[block]);
    count += found[block].size();
    if (per_block != nullptr) per_block->push_back(found[block].size());
    if (count > room) throw_too_many(link, count, before);
  }
  if (blocks == 1) return std::move(found[0]);
  SiteList sites;
  for (SiteList& of_block : found) sites.append(std::move(of_block));
  sites.pack();
  return sites;
}

/// Throws the InputError of too many instances. The message has no count, which depends on the order of the expansion.
void LinkSites::throw_too_many(LinkIndex link, std::uint64_t places, Counts before) const {
  std::vector<std::uint64_t> counts(before.by_component.begin(), before.by_component.end());
  counts.resize(graph_.components.size());
  counts[graph_.links[link].to] += places;
  const auto largest = std::ranges::max_element(counts);
  const std::string& id = graph_.components[static_cast<std::size_t>(largest - counts.begin())].id;
  const std::uint64_t limit = graph_.limits.instances;
  throw InputError(
      Diagnostic{.message = fmt::format("more than {} instances, most of them '{}', are too many", limit, id),
                 .expected = fmt::format("at most {} (limits.instances)", limit),
                 .path = multiplier(graph_.links[link].from, std::span(&link, 1))});
}

std::optional<std::uint64_t> LinkSites::fingerprint(LinkIndex index) const {
  const Link& link = graph_.links[index];
  if (!link.fingerprint) return std::nullopt;
  Fingerprint fingerprint;
  const auto* placed = link.as<PlacedLink>();
  fingerprint.add(*link.fingerprint).add(link.kind.index()).add(placed != nullptr ? placed->name : kNoIndex);
  fingerprint.add(ordinals_[index]).add_text(graph_.components[link.to].drawn_as());
  fingerprint.add(graph_.components[link.to].type->stance);
  const auto add_level = [&](std::uint32_t recursion) {
    fingerprint.add(recursion == kNoIndex ? std::size_t{0} : structure_.recursions[recursion].level + 1);
  };
  add_level(structure_.recursion_of_link[index]);
  const std::uint32_t inside = structure_.recursion_of[link.to];
  add_level(inside);
  fingerprint.add(inside != kNoIndex && structure_.recursions[inside].head == link.to);
  return fingerprint.hash();
}

std::string LinkSites::multiplier(ComponentIndex component, std::span<const LinkIndex> links) const {
  for (const LinkIndex link : links) {
    const std::uint32_t closed = structure_.recursion_of_link[link];
    if (closed == kNoIndex) continue;
    return fmt::format("components.{}.recursion", graph_.components[structure_.recursions[closed].head].id);
  }
  return "components." + graph_.components[component].id;
}

}  // namespace meristem

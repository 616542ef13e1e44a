// SPDX-License-Identifier: Apache-2.0
// Instances of one component at equal depths of all recursions have equal children. They are counted together, one
// generation after another from the root. In a recursion that branches, a generation has few kinds of instances, but
// soon many of each. Even nested recursions therefore pass a limit within some dozens of generations.
#include "meristem/graph/forecast.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "meristem/graph/grow_plantings.h"
#include "meristem/graph/recursion_depths.h"

namespace meristem {

namespace {

constexpr std::size_t kMaxWork = 4'000'000;  // followed links: about half a second
constexpr double kEnough = 1e15;             // instances at which the count stops: more would change nothing
constexpr double kFewInstances = 100;        // components of fewer instances have few triangles
constexpr double kMinVolume = 1e-30;         // smallest volume of a frame that has certainly not vanished (vanished.h)

/// Instances that have equal children.
struct Kind {
  ComponentIndex component = 0;
  RecursionDepths depths{};
  bool is_on_stem = false;  // true: its own stem begins at the bark of that stem, and may end within it
  bool is_first = true;     // true: no ancestor grows, so it grows in the first stand
  double count = 0;
  double volume = 1;  // volume of the smallest of their frames, at most 1

  auto key() const { return std::tie(component, depths, is_on_stem, is_first); }
};

class Forecast {
 public:
  Forecast(const Graph& graph, const Scene& scene)
      : graph_(graph),
        instances_(graph.components.size()),
        visible_(graph.components.size()),
        nodes_(graph.components.size()),
        points_(graph.components.size()) {
    // Bodies trim stems, and a trimmed stem bears fewer children.
    const bool is_free =
        std::ranges::none_of(graph.components, [](const Prototype& one) { return one.type->speaks_of_space; });
    for (const Prototype& prototype : graph.components) {
      MinimumCounts counts = minimum_counts(prototype);
      if (!is_free) counts.nodes = 0;
      if (!is_free || !scene.obstacles.empty()) counts.bears_along = false;
      if (!scene.obstacles.empty()) {
        counts.points = 0;
        if (counts.shuns_obstacles) counts.children = 0;
      }
      counts_.push_back(counts);
    }
  }

  void run() {
    std::vector<Kind> kinds{{.component = graph_.structure.root, .count = 1}};
    std::size_t work = 0;
    double total = 0;
    while (!kinds.empty()) {
      std::vector<Kind> next;
      for (const Kind& kind : kinds) {
        instances_[kind.component] += kind.count;
        total += kind.count;
        const double scale = counts_[kind.component].child_scale;
        const double volume = kind.volume * scale * scale * scale;
        if (!(volume > kMinVolume)) continue;  // the instances may have vanished
        add_contents(kind);
        for (const LinkIndex link : graph_.structure.outgoing[kind.component]) add_children(kind, link, volume, next);
        work += 1 + graph_.structure.outgoing[kind.component].size();
      }
      kinds = joined(std::move(next));
      if (work < kMaxWork && total < kEnough) continue;
      is_whole_ = kinds.empty();
      break;
    }
  }

  /// Returns a fault for each limit that is passed.
  std::vector<Diagnostic> errors(bool will_place, bool will_mesh) const {
    const SizeLimits& limits = graph_.limits;
    std::vector<Diagnostic> errors;
    check(instances_, {.what = "instances", .limit = limits.instances, .limit_name = "instances"}, errors);
    check(nodes_, {.what = "skeleton nodes", .limit = limits.nodes, .limit_name = "nodes"}, errors);
    check(points_, {.what = "attraction points", .limit = limits.points, .limit_name = "points"}, errors);
    if (will_mesh) {
      check(triangles(), {.what = "triangles", .limit = limits.triangles, .limit_name = "triangles"}, errors);
    }
    if (will_place) {
      check(other_plants(),
            {.what = "different plants of other documents",
             .limit = kMaxVariants,
             .expected = fmt::format("at most {}: \"variants\", or one \"seed\"", kMaxVariants)},
            errors);
    }
    return errors;
  }

 private:
  static MinimumCounts minimum_counts(const Prototype& prototype) {
    if (!prototype.type->minimum_counts) return {};
    const KnownMembers known(prototype.varyings);
    const ComponentBase& base = prototype.base();
    MinimumCounts counts = prototype.type->minimum_counts(prototype.parameters.get(), known);
    const bool may_be_left_out = base.omit || base.only;
    if (may_be_left_out) counts.nodes = 0;
    if (may_be_left_out || base.hidden) counts.grows_other = false;
    if (may_be_left_out && !base.omit_keeps_children) return {};
    if (known.varies(member_of(base, &ComponentBase::frame, &InstanceTransform::scale))) return {};
    const Vec3 scale = base.frame.scale;
    counts.child_scale =
        std::min(1.0, counts.child_scale) * std::min(1.0, std::cbrt(std::abs(double{scale.x} * scale.y * scale.z)));
    return counts;
  }

  /// Counts the contents of instances that have certainly not vanished.
  void add_contents(const Kind& kind) {
    const Prototype& prototype = graph_.components[kind.component];
    const MinimumCounts& counts = counts_[kind.component];
    const ComponentBase& base = prototype.base();
    nodes_[kind.component] += kind.count * counts.nodes;
    if (!base.omit && !base.only && !base.hidden) visible_[kind.component] += kind.count;
    const auto& alone = prototype.type->grows_alone;
    const bool is_together = kind.is_first && !(alone && alone(prototype.parameters.get()));
    if (is_together) points_[kind.component] += kind.count * counts.points;
  }

  /// Returns the triangles of each component. Components of few instances are left out, because outlines may have to be
  /// cut for the answer.
  std::vector<double> triangles() const {
    std::vector<double> triangles(visible_.size());
    for (std::size_t c = 0; c < triangles.size(); ++c) {
      const Prototype& prototype = graph_.components[c];
      if (visible_[c] < kFewInstances || !prototype.type->minimum_triangles) continue;
      const KnownMembers known(prototype.varyings);
      triangles[c] = visible_[c] * prototype.type->minimum_triangles(prototype.parameters.get(), known);
    }
    return triangles;
  }

  std::vector<double> other_plants() const {
    std::vector<double> plants(visible_.size());
    for (std::size_t c = 0; c < plants.size(); ++c) plants[c] = counts_[c].grows_other ? visible_[c] : 0;
    return plants;
  }

  void add_children(const Kind& kind, LinkIndex link, double volume, std::vector<Kind>& next) const {
    if (!leads_on(graph_, link, kind.depths)) return;
    const double per_instance = children_per_instance(kind, link);
    if (!(per_instance > 0)) return;
    Kind child = kind;
    child.component = graph_.links[link].to;
    child.is_on_stem = kind.is_on_stem || graph_.components[kind.component].type->makes_stems;
    count_depth(graph_.structure, link, child.component, child.depths);
    child.count = kind.count * per_instance;
    child.is_first = kind.is_first && !graph_.components[kind.component].type->grow;
    child.volume = volume;
    next.push_back(child);
  }

  double children_per_instance(const Kind& kind, LinkIndex index) const {
    const Link& link = graph_.links[index];
    const ComponentType& type = *graph_.components[kind.component].type;
    const MinimumCounts& counts = counts_[kind.component];
    if (link.is<ChildLink>()) return counts.children;
    if (link.is<LeafLink>()) return type.makes_stems ? 0 : counts.children;
    if (const auto* const placed = link.as<PlacedLink>()) {
      return placed->name < counts.named.size() ? counts.named[placed->name] : 0;
    }
    const auto* const branch = link.as<BranchLink>();
    if (branch == nullptr) return 0;
    if (!type.makes_stems) return type.has_ribs ? 0 : counts.children;
    const BranchPlacement& placement = branch->placement;
    const BranchPlacement plain;
    const bool is_plain = !placement.where && placement.start == 0 && placement.end == 1 &&
                          placement.size == plain.size && placement.spread == plain.spread;
    if (kind.is_on_stem || !counts.bears_along || !is_plain || !placement.count || type.grows_in_time) return 0;
    return std::floor(placement.count->value) * placement.whorl;
  }

  static std::vector<Kind> joined(std::vector<Kind> kinds) {
    std::ranges::sort(kinds, [](const Kind& a, const Kind& b) { return a.key() < b.key(); });
    std::size_t kept = 0;
    for (std::size_t k = 1; k < kinds.size(); ++k) {
      Kind& last = kinds[kept];
      if (last.key() == kinds[k].key()) {
        last.count += kinds[k].count;
        last.volume = std::min(last.volume, kinds[k].volume);
      } else {
        kinds[++kept] = kinds[k];
      }
    }
    if (!kinds.empty()) kinds.resize(kept + 1);
    return kinds;
  }

  /// Adds a fault if the components together exceed the limit of `share`.
  void check(const std::vector<double>& by_component, CountShare share, std::vector<Diagnostic>& errors) const {
    for (const double count : by_component) share.total += count;
    if (!(share.total > static_cast<double>(share.limit))) return;
    const auto largest = std::ranges::max_element(by_component);
    share.is_whole = is_whole_;
    share.largest = graph_.components[static_cast<std::size_t>(largest - by_component.begin())].id;
    share.share = *largest;
    errors.push_back(share_diagnostic(share));
  }

  const Graph& graph_;
  std::vector<MinimumCounts> counts_;  // by component
  std::vector<double> instances_;      // by component
  std::vector<double> visible_;        // by component: instances that have certainly geometry, if their type has any
  std::vector<double> nodes_;          // by component
  std::vector<double> points_;         // by component, in the first stand
  bool is_whole_ = true;               // false if a part was too long to be counted
};

}  // namespace

Diagnostic share_diagnostic(const CountShare& share) {
  const auto number = [](double count) {
    return count < 1e6 ? fmt::format("{:.0f}", count) : fmt::format("{:.2g}", count);
  };
  return {.message = fmt::format("{}{} {}, of which {} {} ({:.0f} %), are too many", share.is_whole ? "" : "at least ",
                                 number(share.total), share.what, share.largest, number(share.share),
                                 100 * share.share / share.total),
          .expected = share.expected.empty() ? fmt::format("at most {} (limits.{})", share.limit, share.limit_name)
                                             : share.expected,
          .path = "components." + share.largest};
}

void require_bounded_counts(const Graph& graph, const Scene& scene, bool will_place, bool will_mesh) {
  Forecast forecast(graph, scene);
  forecast.run();
  std::vector<Diagnostic> errors = forecast.errors(will_place, will_mesh);
  if (!errors.empty()) throw InputError(std::move(errors));
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Computes the sites of children of links from the result of a batch of instances.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meristem/base/progress.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/graph.h"
#include "meristem/scene/directions.h"
#include "meristem/scene/scene.h"

namespace meristem {

class LinkSites {
 public:
  /// Numbers of instances before the link is followed.
  struct Counts {
    std::uint64_t all = 0;
    std::uint64_t parents = 0;                      ///< instances of the link's parent in this batch
    std::span<const std::uint64_t> by_component{};  ///< `all` by component
  };

  /// All arguments must outlive this object.
  LinkSites(const Graph& graph, const Scene& scene, const Directions& directions, double time, Progress& progress);

  /// Returns the links along which a batch has children. All its instances have come by the same links and have the
  /// recursion depths of `site`. A link back makes children until its depth is reached, and a leaf link only from that
  /// depth on.
  std::vector<LinkIndex> links_followed(ComponentIndex component, const Site& site) const;

  /// Returns the sites that a link gives its child, over all instances of the parent in their order. Throws InputError
  /// if the sites would exceed the limit of instances. `per_block`, if given, receives the number of sites for each
  /// block of the parent's instances. `own`, if given, is the parent's result, whose sites are not needed again: they
  /// are freed as the link is followed.
  SiteList places(LinkIndex link, const BatchResult& parent, Counts before,
                  std::vector<std::size_t>* per_block = nullptr, BatchResult* own = nullptr) const;

  /// Returns a hash of everything except the parent's result and the scene on which the sites depend, if all of it is
  /// known.
  std::optional<std::uint64_t> fingerprint(LinkIndex link) const;

  /// Returns the document path of the parameter to change if the children of a component by these links are too many.
  /// It is the depth of a recursion that one of the links closes, or else the component.
  std::string multiplier(ComponentIndex component, std::span<const LinkIndex> links) const;

 private:
  class Writer;

  [[noreturn]] void throw_too_many(LinkIndex link, std::uint64_t places, Counts before) const;

  const Graph& graph_;
  const LinkStructure& structure_;  // structure of the graph
  const Scene& scene_;
  const Directions& directions_;  // directions of the scene
  double time_;
  Progress& progress_;
  std::vector<std::uint32_t> ordinals_;  // by link: its index among links between the same two components
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// From what a batch of instances has made to the sites where the children of its links stand.
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
  /// The number of instances.
  struct Counts {
    std::uint64_t all = 0;
    std::uint64_t parents = 0;                      ///< of the link's parent in this batch
    std::span<const std::uint64_t> by_component{};  ///< of `all`
  };

  /// All of them outlive it.
  LinkSites(const Graph& graph, const Scene& scene, const Directions& directions, double time, Progress& progress);

  /// The links along which a batch has children. All its instances have come by the same links, so they are equally
  /// deep in every recursion, as deep as `site`: a link back leads on until its depth is reached, a leaf link only from
  /// there.
  std::vector<LinkIndex> links_followed(ComponentIndex component, const Site& site) const;

  /// The sites that a link gives its child, over all instances of the parent in their order. Throws InputError where
  /// with them there would be more instances than the limit allows.
  /// `per_block`, if given, gets how many there are on each block of the parent's instances.
  std::vector<Site> places(LinkIndex link, const BatchResult& parent, Counts before,
                           std::vector<std::size_t>* per_block = nullptr) const;

  /// Hash of what they depend on besides the parent's result and the scene, where all of it is known.
  std::optional<std::uint64_t> fingerprint(LinkIndex link) const;

  /// The document path of what to change where the children of a component by these links are too many: the depth of a
  /// recursion that one of them closes, or the component itself.
  std::string multiplier(ComponentIndex component, std::span<const LinkIndex> links) const;

 private:
  class Writer;

  [[noreturn]] void throw_too_many(LinkIndex link, std::uint64_t places, Counts before) const;

  const Graph& graph_;
  const Structure& structure_;  // the graph's
  const Scene& scene_;
  const Directions& directions_;  // the scene's
  double time_;
  Progress& progress_;
  std::vector<std::uint32_t> ordinals_;  // of links among those between the same two components
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The data of an expansion: sites of instances of one component, and the results of these instances. Finished sites and
// results do not change, so both can be kept for the next expansion.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/graph/emitted.h"
#include "meristem/graph/site_list.h"
#include "meristem/graph/table/site.h"
#include "meristem/grow/growth_trace.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Number of instances that one emitter expands, and that one block of a result holds.
inline constexpr std::size_t kBlock = 256;

struct Sites {
  SiteList sites;
  std::optional<std::uint64_t> hash{};  ///< hash of the sites; unset if it is unknown or not needed

  std::uint64_t bytes() const { return sites.bytes(); }
};

/// Returns a hash of every field, or nothing if the hash of the surroundings is unknown.
std::optional<std::uint64_t> hash_of(const Site& site);
/// Returns a hash of all sites. It is equal on any number of threads.
std::optional<std::uint64_t> hash_of(const SiteList& sites);

/// The results of the instances of one batch, block by block.
struct BatchResult {
  std::vector<Emitted> blocks;
  std::uint64_t nodes = 0;    ///< number of nodes of all stems
  std::uint64_t offered = 0;  ///< sites for children
  int growth_steps = 0;       ///< largest number of growth steps of an instance, if known
  bool has_sites = true;      ///< false: the sites for children were released, because the cache keeps the children's

  /// Frees the sites for children. Call it when they are not needed again. Keeps the names of placed components, which
  /// are checked whenever the result is used.
  void release_sites();
  std::uint64_t bytes() const;
  /// Returns the heap memory, bytes, without the sites for children. limits.instances limits the sites, and without a
  /// cache they are freed early.
  std::uint64_t bytes_without_sites() const;
};

/// The grown plants of a component's instances, one skeleton per instance.
struct GrownBatch {
  std::vector<Skeleton> skeletons;
  std::vector<std::shared_ptr<const GrowthTrace>> traces{};  ///< one per instance; null if nothing is recorded

  std::uint64_t bytes() const;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// What flows through an expansion: sites where instances of one component stand, and what these have made. Neither
// changes once it is there, so both can be kept for the next expansion.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "meristem/graph/emitter.h"
#include "meristem/graph/table/site.h"
#include "meristem/grow/growth_trace.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

/// Instances that one emitter expands, and one block of a result holds.
inline constexpr std::size_t kBlock = 256;

struct Sites {
  std::vector<Site> sites;
  std::optional<std::uint64_t> hash{};  ///< of the sites; nothing where nobody will ask for it, or it is not known

  std::uint64_t bytes() const { return sites.capacity() * sizeof(Site); }
};

/// Hash of every field; nothing where that of its surroundings is not known.
std::optional<std::uint64_t> hash_of(const Site& site);
/// Hash of all of them, equal on any number of threads.
std::optional<std::uint64_t> hash_of(const std::vector<Site>& sites);

/// What the instances of one batch have made, block by block.
struct BatchResult {
  std::vector<Emitted> blocks;
  std::uint64_t nodes = 0;    ///< of all stems
  std::uint64_t offered = 0;  ///< sites for children
  int growth_steps = 0;       ///< the most that an instance has taken, where it has told

  std::uint64_t bytes() const;
  /// Without the sites for children. limits.instances bounds these, and without a cache they are released early.
  std::uint64_t bytes_without_sites() const;
};

/// What a component's instances have grown, one skeleton per instance.
struct GrownBatch {
  std::vector<Skeleton> skeletons;
  std::vector<std::shared_ptr<const GrowthTrace>> traces{};  ///< one per instance, null where nothing is recorded

  std::uint64_t bytes() const;
};

}  // namespace meristem

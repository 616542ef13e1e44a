// SPDX-License-Identifier: Apache-2.0
// What flows through an expansion: sites where instances of one component stand, and what these have made. Neither
// changes once it is there, so both can be kept for the next expansion.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/graph/emitter.h"
#include "meristem/graph/table/site.h"
#include "meristem/plant/skeleton.h"

namespace meristem {

struct Sites {
  std::vector<Site> sites;
  std::uint64_t hash = 0;  ///< of all bytes of the sites; 0 where nobody will ask for it

  std::uint64_t bytes() const { return sites.capacity() * sizeof(Site); }
};

/// Hash of every field, equal on any number of threads.
std::uint64_t hash_of(const std::vector<Site>& sites);

/// What the instances of one batch have made, block by block.
struct BatchResult {
  std::vector<Emitted> blocks;
  std::uint64_t nodes = 0;    ///< of all stems
  std::uint64_t offered = 0;  ///< sites for children

  std::uint64_t bytes() const;
};

/// What a component's instances have grown, one skeleton per instance.
struct GrownBatch {
  std::vector<Skeleton> skeletons;

  std::uint64_t bytes() const;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/expansion_cache.h"

#include "meristem/graph/kept.h"

namespace meristem {

void ExpansionCache::Kept::begin_run() {
  batches.begin_run();
  places.begin_run();
  grown.begin_run();
  meshes.begin_run();
  instances_reuse = {};
  grown_reuse = {};
}

void ExpansionCache::Kept::end_run() {
  batches.end_run();
  places.end_run();
  grown.end_run();
  meshes.end_run();
}

ExpansionCache::ExpansionCache() : kept_(std::make_unique<Kept>()) {}
ExpansionCache::~ExpansionCache() = default;
ExpansionCache::ExpansionCache(ExpansionCache&&) noexcept = default;
ExpansionCache& ExpansionCache::operator=(ExpansionCache&&) noexcept = default;

const Reuse& ExpansionCache::instances() const { return kept_->instances_reuse; }
const Reuse& ExpansionCache::grown() const { return kept_->grown_reuse; }

std::uint64_t ExpansionCache::bytes() const {
  return kept_->batches.bytes() + kept_->places.bytes() + kept_->grown.bytes() + kept_->meshes.bytes();
}

void ExpansionCache::clear() { *kept_ = {}; }

}  // namespace meristem

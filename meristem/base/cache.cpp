// SPDX-License-Identifier: Apache-2.0
// Keeps results between runs. Each entry stores the number of the run that used it last. The end of a run removes
// entries with an older number. An interrupted run is not ended, so its entries and those of the last complete run both
// stay for the next run.
#include "meristem/base/cache.h"

namespace meristem {

std::uint64_t Cache::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& [type, shelf] : shelves_) {
    for (const auto& [key, entry] : shelf.entries) sum += entry.bytes(entry.result.get());
  }
  return sum;
}

void Cache::end_run(Shelf& shelf) {
  const std::uint64_t run = shelf.run;
  std::erase_if(shelf.entries, [run](const auto& entry) { return entry.second.run != run; });
  for (auto& [key, entry] : shelf.entries) entry.is_settled = true;
}

CacheSeries::CacheSeries(Cache& cache) : cache_(cache) {
  ++cache_.series_;
  cache_.is_in_series_ = true;
}

void CacheSeries::end() {
  for (auto& [type, shelf] : cache_.shelves_) {
    if (shelf.series == cache_.series_) Cache::end_run(shelf);
  }
  cache_.is_in_series_ = false;
}

CacheRun::CacheRun(Cache* cache, std::initializer_list<std::type_index> types) : cache_(cache), types_(types) {
  if (cache_ == nullptr) return;
  for (const std::type_index type : types_) {
    Cache::Shelf& shelf = cache_->shelves_[type];
    if (cache_->is_in_series_ && std::exchange(shelf.series, cache_->series_) == cache_->series_) {
      shelf.reuse = {};  // this run continues the run before
      continue;
    }
    const std::uint64_t last = shelf.run;
    std::erase_if(shelf.entries,
                  [last](const auto& entry) { return !entry.second.is_settled && entry.second.run != last; });
    shelf.reuse = {};
    ++shelf.run;
  }
}

void CacheRun::end() {
  if (cache_ == nullptr || cache_->is_in_series_) return;
  for (const std::type_index type : types_) Cache::end_run(cache_->shelves_[type]);
}

Cache::Entry* CacheRun::find_entry(std::type_index type, CacheKey key) {
  if (cache_ == nullptr || !key) return nullptr;
  Cache::Shelf& shelf = cache_->shelves_[type];
  const auto found = shelf.entries.find(*key);
  if (found == shelf.entries.end()) return nullptr;
  found->second.run = shelf.run;
  return &found->second;
}

void CacheRun::store_entry(std::type_index type, CacheKey key, std::shared_ptr<const void> result,
                           std::uint64_t (*bytes)(const void*)) {
  if (cache_ == nullptr || !key) return;
  Cache::Shelf& shelf = cache_->shelves_[type];
  shelf.entries.insert_or_assign(*key, Cache::Entry{std::move(result), bytes, shelf.run, false});
}

void CacheRun::count(std::type_index type, bool is_reused, std::uint64_t many) {
  if (cache_ == nullptr) return;
  CacheReuse& reuse = cache_->shelves_[type].reuse;
  (is_reused ? reuse.reused : reuse.made) += many;
}

}  // namespace meristem

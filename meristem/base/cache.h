// SPDX-License-Identifier: Apache-2.0
// Keeps the results of one run of a computation for the next run. A result is found by its type and by a fingerprint of
// everything that it depends on. Any type of result can be cached; Cache knows none of these types.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <typeindex>
#include <typeinfo>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meristem {

/// The number of computed results, and the number of results found in the cache.
struct CacheReuse {
  std::uint64_t made = 0;    ///< results that had to be computed
  std::uint64_t reused = 0;  ///< results found in the cache
};

/// Fingerprint of everything that a result depends on. nullopt if the dependencies are unknown, or if the result will
/// not be needed again.
using CacheKey = std::optional<std::uint64_t>;

/// Results of any types that have a function `bytes()` for their heap memory. The cache keeps the results that the last
/// run of each type has used. The results of an interrupted run stay until the next run has begun, together with the
/// results of the run before. Only one run at a time may use the cache.
class Cache {
 public:
  /// Returns the number of results of a type that the last run has found and computed so far.
  template <class Result>
  CacheReuse reuse() const {
    const auto shelf = shelves_.find(typeid(Result));
    return shelf == shelves_.end() ? CacheReuse() : shelf->second.reuse;
  }
  /// Returns the heap memory of all results in bytes.
  std::uint64_t bytes() const;
  /// Removes all results.
  void clear() { shelves_.clear(); }

 private:
  friend class CacheRun;
  friend class CacheSeries;

  struct Entry {
    std::shared_ptr<const void> result;
    std::uint64_t (*bytes)(const void* result) = nullptr;
    std::uint64_t run = 0;    // number of the last run that used the result
    bool is_settled = false;  // true if a completed run has used the result
  };
  /// All results of one type.
  struct Shelf {
    std::unordered_map<std::uint64_t, Entry> entries;
    std::uint64_t run = 0;
    std::uint64_t series = 0;  // series of the last run
    CacheReuse reuse;
  };

  static void end_run(Shelf& shelf);

  std::unordered_map<std::type_index, Shelf> shelves_;
  std::uint64_t series_ = 0;  // the last series that has begun
  bool is_in_series_ = false;
};

/// One run that finds results of some types in a cache and stores results there. Without a cache, the run finds and
/// stores nothing.
class CacheRun {
 public:
  /// Begins a run of these types; `cache` (null: no cache) must outlive the run.
  CacheRun(Cache* cache, std::initializer_list<std::type_index> types);

  /// Ends the run and removes the results that it has not used. Must not be called if the run fails.
  void end();

  /// Returns the key that `make()` returns. Without a cache, `make` is not called and the key is nullopt.
  template <class Make>
  CacheKey key(const Make& make) const {
    return cache_ == nullptr ? std::nullopt : CacheKey(make());
  }

  /// Returns the result with this key. Returns null if there is no such result or no key.
  template <class Result>
  std::shared_ptr<Result> find(CacheKey key) {
    Cache::Entry* const entry = find_entry(typeid(Result), key);
    if (entry == nullptr) return nullptr;
    return std::static_pointer_cast<Result>(std::const_pointer_cast<void>(entry->result));
  }

  /// Stores a result and replaces an earlier result with this key. Does nothing without a key.
  template <class Result>
  void store(CacheKey key, std::shared_ptr<Result> result) {
    store_entry(typeid(Result), key, std::move(result),
                [](const void* stored) -> std::uint64_t { return static_cast<const Result*>(stored)->bytes(); });
  }

  /// Adds to the numbers of results of a type that were found or computed.
  template <class Result>
  void count(bool is_reused, std::uint64_t many = 1) {
    count(typeid(Result), is_reused, many);
  }

 private:
  Cache::Entry* find_entry(std::type_index type, CacheKey key);
  void store_entry(std::type_index type, CacheKey key, std::shared_ptr<const void> result,
                   std::uint64_t (*bytes)(const void*));
  void count(std::type_index type, bool is_reused, std::uint64_t many);

  Cache* cache_;
  std::vector<std::type_index> types_;
};

/// A series of runs that count as one, such as one computation with several values of a parameter. Until end(), the
/// cache keeps every result that any run of the series has used. The next series therefore finds the results for every
/// value. `cache` must outlive the series. Only one series at a time may use the cache.
class CacheSeries {
 public:
  /// Begins a series in `cache`.
  explicit CacheSeries(Cache& cache);
  ~CacheSeries() { cache_.is_in_series_ = false; }
  CacheSeries(const CacheSeries&) = delete;
  CacheSeries& operator=(const CacheSeries&) = delete;

  /// Ends the series and removes the results that no run of the series has used. Must not be called if the series
  /// fails. The results of a failed series stay until the next run or series has begun.
  void end();

 private:
  Cache& cache_;
};

}  // namespace meristem

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

/// Number of results that were made anew, and number that the cache had.
struct Reuse {
  std::uint64_t made = 0;    ///< results that had to be made
  std::uint64_t reused = 0;  ///< results that the cache had
};

/// Fingerprint of everything that a result depends on; nullopt if the dependencies are not known or the result will not
/// be needed again.
using CacheKey = std::optional<std::uint64_t>;

/// Results of any types with a function `bytes()` for their heap memory. The cache holds the results that the last run
/// of each type has used. The results of an interrupted run stay, beside those of the run before, until the next run
/// has begun. One run at a time may use the cache.
class Cache {
 public:
  /// How many results the last run of a type has found and made so far.
  template <class Result>
  Reuse reuse() const {
    const auto shelf = shelves_.find(typeid(Result));
    return shelf == shelves_.end() ? Reuse() : shelf->second.reuse;
  }
  /// Heap memory of all results.
  std::uint64_t bytes() const;
  /// Removes all results.
  void clear() { shelves_.clear(); }

 private:
  friend class CacheRun;
  friend class CacheSeries;

  struct Entry {
    std::shared_ptr<const void> result;
    std::uint64_t (*bytes)(const void* result) = nullptr;
    std::uint64_t run = 0;    // the last that used it
    bool is_settled = false;  // used by the last run that came to its end
  };
  /// All results of one type.
  struct Shelf {
    std::unordered_map<std::uint64_t, Entry> entries;
    std::uint64_t run = 0;
    std::uint64_t series = 0;  // that the last run was of
    Reuse reuse;
  };

  static void end_run(Shelf& shelf);

  std::unordered_map<std::type_index, Shelf> shelves_;
  std::uint64_t series_ = 0;  // the last that has begun
  bool is_in_series_ = false;
};

/// One run that finds results of some types in a cache, and stores them there. Without a cache it finds none, and
/// stores none.
class CacheRun {
 public:
  /// Begins a run of these types; `cache` (null: no cache) must outlive the run.
  CacheRun(Cache* cache, std::initializer_list<std::type_index> types);

  /// Ends the run and removes the results that it has not used. Not called if the run fails.
  void end();

  /// The key that `make()` returns. Without a cache, `make` is not called and the key is nullopt.
  template <class Make>
  CacheKey key(const Make& make) const {
    return cache_ == nullptr ? std::nullopt : CacheKey(make());
  }

  /// The result with this key, or null; always null without a key.
  template <class Result>
  std::shared_ptr<Result> find(CacheKey key) {
    Cache::Entry* const entry = find_entry(typeid(Result), key);
    if (entry == nullptr) return nullptr;
    return std::static_pointer_cast<Result>(std::const_pointer_cast<void>(entry->result));
  }

  /// Stores a result, in place of an earlier one with this key. Does nothing without a key.
  template <class Result>
  void store(CacheKey key, std::shared_ptr<Result> result) {
    store_entry(typeid(Result), key, std::move(result),
                [](const void* stored) -> std::uint64_t { return static_cast<const Result*>(stored)->bytes(); });
  }

  /// Adds to the counts of results of a type that were found, or had to be made.
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

/// Runs that count as one, such as those of one computation with several values of a parameter: from its beginning to
/// end() the cache keeps what any of its runs has used, so that the next series finds the results for every value.
/// `cache` must outlive it; one series at a time.
class CacheSeries {
 public:
  /// Begins a series in `cache`.
  explicit CacheSeries(Cache& cache);
  ~CacheSeries() { cache_.is_in_series_ = false; }
  CacheSeries(const CacheSeries&) = delete;
  CacheSeries& operator=(const CacheSeries&) = delete;

  /// Ends the series and removes the results that none of its runs has used. Not called if the series fails; what its
  /// runs have made stays until the next run or series has begun.
  void end();

 private:
  Cache& cache_;
};

}  // namespace meristem

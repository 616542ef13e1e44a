// SPDX-License-Identifier: Apache-2.0
// What one run of a computation leaves for the next one. Results are found by their type and by a fingerprint of all
// that they depend on, so whoever has a result of a type of its own can cache it; Cache knows none of them.
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

/// How much of something was made anew, and how much was there already.
struct Reuse {
  std::uint64_t made = 0;
  std::uint64_t reused = 0;
};

/// The fingerprint that a result is found by; nothing where it cannot be said what the result depends on, or nobody
/// will ask for it.
using CacheKey = std::optional<std::uint64_t>;

/// Results of any types that tell their heap memory by `bytes()`. The cache holds what the last run of each type has
/// used. The results of a run that did not come to its end stay, beside those of the run before, until the next run has
/// begun. One run at a time may use the cache.
class Cache {
 public:
  /// How many results the last run of a type has found and made, as far as it came.
  template <class Result>
  Reuse reuse() const {
    const auto shelf = shelves_.find(typeid(Result));
    return shelf == shelves_.end() ? Reuse() : shelf->second.reuse;
  }
  /// Heap memory of all results.
  std::uint64_t bytes() const;
  /// Lets go of all of it.
  void clear() { shelves_.clear(); }

 private:
  friend class CacheRun;

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
    Reuse reuse;
  };

  std::unordered_map<std::type_index, Shelf> shelves_;
};

/// One run that finds results of some types in a cache, and stores them there. Without a cache it finds none, and
/// stores none.
class CacheRun {
 public:
  /// Begins a run of these types; `cache`, if there is one (null: none), outlives it.
  CacheRun(Cache* cache, std::initializer_list<std::type_index> types);

  /// Ends it: what it has not used is let go. Not called where the run fails.
  void end();

  /// What `make()` gives, a fingerprint or none. Without a cache it is not called, as nobody will ask.
  template <class Make>
  CacheKey key(const Make& make) const {
    return cache_ == nullptr ? std::nullopt : CacheKey(make());
  }

  /// Null where there is none; without a key there never is.
  template <class Result>
  std::shared_ptr<Result> find(CacheKey key) {
    Cache::Entry* const entry = find_entry(typeid(Result), key);
    if (entry == nullptr) return nullptr;
    return std::static_pointer_cast<Result>(std::const_pointer_cast<void>(entry->result));
  }

  /// In place of an earlier one with this key. Does nothing without a key.
  template <class Result>
  void store(CacheKey key, std::shared_ptr<Result> result) {
    store_entry(typeid(Result), key, std::move(result),
                [](const void* stored) -> std::uint64_t { return static_cast<const Result*>(stored)->bytes(); });
  }

  /// Tells the cache how much of a type was found, or had to be made.
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

}  // namespace meristem

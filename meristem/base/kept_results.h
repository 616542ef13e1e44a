// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

namespace meristem {

/// How much of something was made anew, and how much was there already.
struct Reuse {
  std::uint64_t made = 0;
  std::uint64_t reused = 0;
};

/// Results by the fingerprints of what they depend on. What the last run has not used is let go at its end; of a run
/// that did not come to its end the results stay, beside those before, until the next one has begun.
template <class Result>
class KeptResults {
 public:
  void begin_run() {
    std::erase_if(entries_, [&](const auto& entry) { return !entry.second.is_settled && entry.second.run != run_; });
    ++run_;
  }

  void end_run() {
    std::erase_if(entries_, [&](const auto& entry) { return entry.second.run != run_; });
    for (auto& [key, entry] : entries_) entry.is_settled = true;
  }

  /// Null where there is none; without a key there never is.
  std::shared_ptr<Result> find(std::optional<std::uint64_t> key) {
    if (!key) return nullptr;
    const auto found = entries_.find(*key);
    if (found == entries_.end()) return nullptr;
    found->second.run = run_;
    return found->second.result;
  }

  /// In place of an earlier one with this key. Does nothing without a key.
  void keep(std::optional<std::uint64_t> key, std::shared_ptr<Result> result) {
    if (key) entries_.insert_or_assign(*key, Entry{std::move(result), run_});
  }

  /// Of all results, each of which tells its own.
  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const auto& [key, entry] : entries_) sum += entry.result->bytes();
    return sum;
  }

 private:
  struct Entry {
    std::shared_ptr<Result> result;
    std::uint64_t run = 0;    // the last that used it
    bool is_settled = false;  // used by the last run that came to its end
  };
  std::unordered_map<std::uint64_t, Entry> entries_;
  std::uint64_t run_ = 0;
};

}  // namespace meristem

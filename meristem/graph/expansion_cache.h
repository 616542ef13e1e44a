// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "meristem/base/kept_results.h"

namespace meristem {

/// Keeps what one expansion has made for the next one of the same or a changed document, which makes anew only what
/// depends on the change. It holds no more than the last expansion has used. The result is the same as without it, to
/// the byte; one that throws or is cancelled leaves it in order. One call at a time may use it.
class ExpansionCache {
 public:
  ExpansionCache();
  ~ExpansionCache();
  ExpansionCache(ExpansionCache&&) noexcept;
  ExpansionCache& operator=(ExpansionCache&&) noexcept;

  /// Of the last expansion, as far as it came.
  const Reuse& instances() const;
  const Reuse& grown() const;  ///< plants that grow in a stand
  /// Heap memory of what is kept, shapes of organs included.
  std::uint64_t bytes() const;
  /// Lets go of all of it.
  void clear();

 private:
  friend class Expansion;
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace meristem

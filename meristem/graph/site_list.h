// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "meristem/base/packed_list.h"
#include "meristem/graph/table/site.h"

namespace meristem {

/// Stores a site in a PackedList.
struct SiteCodec {
  static constexpr std::size_t kWidth = 44;       ///< words of a site
  static constexpr std::size_t kOpen = 1024;      ///< sites that are not packed yet, because their instance is expanded
  using Row = std::array<std::uint32_t, kWidth>;  ///< a site in words

  /// The values and surroundings of a chunk's sites. Neighbouring sites with equal pointers share an entry.
  struct Side {
    std::vector<std::shared_ptr<const SiteValues>> values{};          ///< without null pointers
    std::vector<std::shared_ptr<const Surroundings>> surroundings{};  ///< without null pointers

    std::uint64_t bytes() const;  ///< heap memory of the pointers
  };

  /// Writes a site into a row, and what is no number into `side`.
  static void encode(const Site& site, Row& row, Side& side);
  /// Sets a site to what a row and the side of its chunk hold.
  static void decode(const Row& row, const Side& side, Site& site);
};

/// The sites where instances stand. Most of a site's 216 bytes are equal for neighbouring sites.
using SiteList = PackedList<Site, SiteCodec>;

}  // namespace meristem

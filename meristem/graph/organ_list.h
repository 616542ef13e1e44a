// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "meristem/base/packed_list.h"
#include "meristem/plant/plant.h"

namespace meristem {

/// Stores an organ in a PackedList.
struct OrganCodec {
  static constexpr std::size_t kWidth = sizeof(Organ) / sizeof(std::uint32_t);  ///< words of an organ
  static constexpr std::size_t kOpen = 256;                                     ///< organs that are not packed yet
  using Row = std::array<std::uint32_t, kWidth>;                                ///< an organ in words

  /// Organs have no parts that are no numbers.
  struct Side {
    std::uint64_t bytes() const { return 0; }  ///< heap memory
  };

  /// Writes an organ into a row.
  static void encode(const Organ& organ, Row& row, Side&) { row = std::bit_cast<Row>(organ); }
  /// Sets an organ to what a row holds.
  static void decode(const Row& row, const Side&, Organ& organ) { organ = std::bit_cast<Organ>(row); }
};

/// The organs of a block of instances. Neighbouring organs often share prototype, birth, tint and individual.
using OrganList = PackedList<Organ, OrganCodec>;

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// Defines which numbers are valid seeds, for documents, the command line and Python.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace meristem {

/// 2^53: up to this number, JSON represents every whole number exactly.
inline constexpr std::uint64_t kLargestSeed = 1ULL << 53U;

/// The range of seeds in the messages of all programs.
inline constexpr std::string_view kSeedRange = "a whole number from 0 to 9007199254740992";

/// Returns the seed for a text of digits. Returns nullopt for any other text, even one with an additional space.
std::optional<std::uint64_t> seed_of_text(std::string_view text);

}  // namespace meristem

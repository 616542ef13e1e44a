// SPDX-License-Identifier: Apache-2.0
// Which numbers are seeds: the same for documents, the command line and Python.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace meristem {

/// Up to here a JSON number holds every whole number exactly: 2^53.
inline constexpr std::uint64_t kLargestSeed = 1ULL << 53U;

/// What the messages of all programs say that a seed must be.
inline constexpr std::string_view kSeedRange = "a whole number from 0 to 9007199254740992";

/// The seed that a text of digits gives; nullopt for any other text, even with a space added.
std::optional<std::uint64_t> seed_of_text(std::string_view text);

}  // namespace meristem

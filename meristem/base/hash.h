// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace meristem {

/// Returns the 64-bit XXH3 hash of the bytes. Equal on all machines of one byte order.
std::uint64_t hash64(std::string_view bytes);

/// Returns the 128-bit XXH3 hash of the bytes as 32 hexadecimal digits, as tests compare and manifests print it.
std::string hash128_hex(std::span<const std::byte> bytes);

}  // namespace meristem

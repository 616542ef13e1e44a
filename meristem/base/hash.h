// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace meristem {

/// 64-bit XXH3 of the bytes; the same on every machine of one byte order.
std::uint64_t hash64(std::string_view bytes);

/// 128-bit XXH3 of the bytes as 32 hexadecimal digits: what tests compare and manifests print.
std::string hash128_hex(std::span<const std::byte> bytes);

}  // namespace meristem

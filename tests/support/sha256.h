// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace meristem {

/// Returns the SHA-256 digest in hexadecimal digits (FIPS 180-4), for comparison with published digests.
inline std::string sha256(std::string_view text) {
  // The constants are the first 32 bits of the fractional parts of roots of the first primes.
  std::array<std::uint32_t, 64> constants;
  std::array<std::uint32_t, 8> state;
  std::size_t primes = 0;
  const auto fraction_bits = [](long double x) {
    return static_cast<std::uint32_t>((x - std::floor(x)) * 4294967296.0L);
  };
  for (std::uint32_t n = 2; primes < constants.size(); ++n) {
    bool is_prime = true;
    for (std::uint32_t d = 2; d * d <= n; ++d) is_prime = is_prime && n % d != 0;
    if (!is_prime) continue;
    if (primes < state.size()) state[primes] = fraction_bits(std::sqrt(static_cast<long double>(n)));
    constants[primes++] = fraction_bits(std::cbrt(static_cast<long double>(n)));
  }

  std::string message(text);
  message += '\x80';
  while (message.size() % 64 != 56) message += '\0';
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(text.size());
  for (int shift = 56; shift >= 0; shift -= 8) message += static_cast<char>(bits >> shift & 255);

  for (std::size_t block = 0; block < message.size(); block += 64) {
    std::array<std::uint32_t, 64> words;
    for (std::size_t k = 0; k < 16; ++k) {
      words[k] = 0;
      for (std::size_t b = 0; b < 4; ++b)
        words[k] = words[k] << 8 | static_cast<std::uint8_t>(message[block + 4 * k + b]);
    }
    for (std::size_t k = 16; k < 64; ++k) {
      const std::uint32_t a = words[k - 15];
      const std::uint32_t b = words[k - 2];
      words[k] = words[k - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) + words[k - 7] +
                 (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t k = 0; k < 64; ++k) {
      const std::uint32_t first =
          h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + constants[k] + words[k];
      const std::uint32_t second =
          (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
    }
    const std::array<std::uint32_t, 8> added = {a, b, c, d, e, f, g, h};
    for (std::size_t k = 0; k < 8; ++k) state[k] += added[k];
  }
  std::string digits;
  for (const std::uint32_t word : state) {
    for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
  }
  return digits;
}

}  // namespace meristem

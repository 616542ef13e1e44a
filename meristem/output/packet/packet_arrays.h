// SPDX-License-Identifier: Apache-2.0
// The arrays of a packet: numbers as small as a picture on a screen lets them be.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "meristem/base/frame.h"
#include "meristem/base/mesh.h"
#include "meristem/graph/table/value.h"

namespace meristem {

/// Collects arrays and says where each stands: [bytes from the first array, count of numbers].
class PacketArrays {
 public:
  /// Appends an array of numbers, and returns its place for the head of a packet.
  template <class Number>
  Value add(const std::vector<Number>& numbers) {
    return add_bytes(numbers.data(), numbers.size() * sizeof(Number), numbers.size());
  }
  /// Appends bytes, and returns their place for the head of a packet.
  Value add_bytes(std::string_view bytes) { return add_bytes(bytes.data(), bytes.size(), bytes.size()); }
  const std::string& bytes() const { return bytes_; }  ///< all arrays, each filled up to a multiple of 4 bytes

 private:
  Value add_bytes(const void* data, std::size_t size, std::size_t count);

  std::string bytes_;
};

/// A packet, little-endian: four letters that say what it is, u32 the bytes of the head (a multiple of 4), the head as
/// JSON in UTF-8, filled up with blanks, and behind it the arrays, which so begin at multiples of 4 bytes.
std::string packet_bytes(std::string_view letters, const Value& head, const PacketArrays& arrays);

/// Three floats a vector.
std::vector<float> packed_vectors(const std::vector<Vec3>& vectors);
/// Unit vectors as four normalised bytes each, the last 0.
std::vector<std::int8_t> packed_normals(const std::vector<Vec3>& normals);
/// Tangents as four normalised bytes each, the sign in the last.
std::vector<std::int8_t> packed_tangents(const std::vector<Vec4>& tangents);
/// Whether all lie in 0 to 1, so that 16 bits do.
bool fit_sixteen_bits(const std::vector<Vec2>& uvs);
/// Returns texture coordinates in 0 to 1 as whole numbers of 16 bits: 65535 is 1.
std::vector<std::uint16_t> packed_uvs(const std::vector<Vec2>& uvs);
/// Returns texture coordinates as floats, for coordinates outside 0 to 1.
std::vector<float> wide_uvs(const std::vector<Vec2>& uvs);
/// Three rows of four numbers a frame: what x, y and z of a point come to are the products of a row with (x, y, z, 1).
std::vector<float> packed_frames(const std::vector<Frame>& frames);

/// The greatest factor of each channel, at least a little.
Vec3 tint_scale(const std::vector<Vec3>& tints);
/// Factors as shares of `scale`, four normalised bytes each, the last 255.
std::vector<std::uint8_t> packed_tints(const std::vector<Vec3>& tints, Vec3 scale);

/// Corners of triangles.
template <class Index>
std::vector<Index> packed_indices(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Index> indices;
  indices.reserve(3 * triangles.size());
  for (const auto& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) indices.push_back(static_cast<Index>(vertex));
  }
  return indices;
}

}  // namespace meristem

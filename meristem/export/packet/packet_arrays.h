// SPDX-License-Identifier: Apache-2.0
// The arrays of a packet: numbers in the smallest form that is sufficient for a picture on a screen.
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

/// Collects arrays and returns the place of each: [bytes from the first array, number of values].
class PacketArrays {
 public:
  /// Appends an array of numbers, and returns its place for the head of a packet.
  template <class Number>
  Value add(const std::vector<Number>& numbers) {
    return add_bytes(numbers.data(), numbers.size() * sizeof(Number), numbers.size());
  }
  /// Appends bytes, and returns their place for the head of a packet.
  Value add_bytes(std::string_view bytes) { return add_bytes(bytes.data(), bytes.size(), bytes.size()); }
  const std::string& bytes() const { return bytes_; }  ///< all arrays, each padded to a multiple of 4 bytes

 private:
  Value add_bytes(const void* data, std::size_t size, std::size_t count);

  std::string bytes_;
};

/// Returns a packet, little-endian: four letters that name its kind, u32 with the bytes of the head (a multiple of 4),
/// the head as JSON in UTF-8 padded with blanks, and then the arrays. All arrays begin at multiples of 4 bytes.
std::string packet_bytes(std::string_view letters, const Value& head, const PacketArrays& arrays);

/// Returns three floats per vector. Throws InputError for numbers that are not finite.
std::vector<float> packed_vectors(const std::vector<Vec3>& vectors);
/// Returns unit vectors as four normalised bytes each, the last one 0.
std::vector<std::int8_t> packed_normals(const std::vector<Vec3>& normals);
/// Returns tangents as four normalised bytes each, with the sign in the last.
std::vector<std::int8_t> packed_tangents(const std::vector<Vec4>& tangents);
/// Returns true if all coordinates are in 0 to 1, so that 16 bits suffice.
bool fit_sixteen_bits(const std::vector<Vec2>& uvs);
/// Returns texture coordinates in 0 to 1 as 16-bit whole numbers: 65535 is 1.
std::vector<std::uint16_t> packed_uvs(const std::vector<Vec2>& uvs);
/// Returns texture coordinates as floats, for coordinates outside 0 to 1. Throws InputError for numbers that are not
/// finite.
std::vector<float> wide_uvs(const std::vector<Vec2>& uvs);
/// Returns three rows of four numbers per frame. The mapped x, y and z of a point are the products of these rows with
/// (x, y, z, 1). Throws InputError for numbers that are not finite.
std::vector<float> packed_frames(const std::vector<Frame>& frames);

/// Returns the largest factor of each channel, or a small positive number.
Vec3 tint_scale(const std::vector<Vec3>& tints);
/// Returns factors as shares of `scale`, as four normalised bytes each, the last one 255.
std::vector<std::uint8_t> packed_tints(const std::vector<Vec3>& tints, Vec3 scale);

/// Returns the corners of triangles.
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

// SPDX-License-Identifier: Apache-2.0
// Packs numbers for packets. Normals, tints and texture coordinates are quantised, and positions and frames stay
// floats.
#include "meristem/export/packet/packet_arrays.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "meristem/document/json.h"
#include "meristem/output/write/finite.h"

namespace meristem {

namespace {

std::int8_t signed_byte(float share) {
  return static_cast<std::int8_t>(std::lround(127 * std::clamp(share, -1.0F, 1.0F)));
}

}  // namespace

Value PacketArrays::add_bytes(const void* data, std::size_t size, std::size_t count) {
  const std::size_t at = bytes_.size();
  if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  bytes_.append((4 - size % 4) % 4, '\0');
  return Value::List{static_cast<double>(at), static_cast<double>(count)};
}

std::string packet_bytes(std::string_view letters, const Value& head, const PacketArrays& arrays) {
  const std::string text = write_json_line(head);
  const std::size_t padding = (4 - text.size() % 4) % 4;
  const auto size = static_cast<std::uint32_t>(text.size() + padding);
  std::string packet(letters);
  packet.reserve(8 + size + arrays.bytes().size());
  for (int shift = 0; shift < 32; shift += 8) packet.push_back(static_cast<char>(size >> shift & 0xffU));
  packet += text;
  packet.append(padding, ' ');
  packet += arrays.bytes();
  return packet;
}

std::vector<float> packed_vectors(const std::vector<Vec3>& vectors) {
  std::vector<float> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vec3 vector : vectors) numbers.insert(numbers.end(), {vector.x, vector.y, vector.z});
  require_finite_values(std::span<const float>(numbers));
  return numbers;
}

std::vector<std::int8_t> packed_normals(const std::vector<Vec3>& normals) {
  std::vector<std::int8_t> bytes;
  bytes.reserve(4 * normals.size());
  for (const Vec3 normal : normals) {
    bytes.insert(bytes.end(), {signed_byte(normal.x), signed_byte(normal.y), signed_byte(normal.z), std::int8_t{0}});
  }
  return bytes;
}

std::vector<std::int8_t> packed_tangents(const std::vector<Vec4>& tangents) {
  std::vector<std::int8_t> bytes;
  bytes.reserve(4 * tangents.size());
  for (const Vec4 tangent : tangents) {
    bytes.insert(bytes.end(), {signed_byte(tangent.x), signed_byte(tangent.y), signed_byte(tangent.z),
                               signed_byte(tangent.w < 0 ? -1.0F : 1.0F)});
  }
  return bytes;
}

bool fit_sixteen_bits(const std::vector<Vec2>& uvs) {
  return std::all_of(uvs.begin(), uvs.end(), [](Vec2 uv) { return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1; });
}

std::vector<std::uint16_t> packed_uvs(const std::vector<Vec2>& uvs) {
  const auto share = [](float number) { return static_cast<std::uint16_t>(std::lround(65535 * number)); };
  std::vector<std::uint16_t> numbers;
  numbers.reserve(2 * uvs.size());
  for (const Vec2 uv : uvs) numbers.insert(numbers.end(), {share(uv.x), share(uv.y)});
  return numbers;
}

std::vector<float> wide_uvs(const std::vector<Vec2>& uvs) {
  std::vector<float> numbers;
  numbers.reserve(2 * uvs.size());
  for (const Vec2 uv : uvs) numbers.insert(numbers.end(), {uv.x, uv.y});
  require_finite_values(std::span<const float>(numbers));
  return numbers;
}

std::vector<float> packed_frames(const std::vector<Frame>& frames) {
  std::vector<float> numbers;
  numbers.reserve(12 * frames.size());
  for (const Frame& frame : frames) {
    for (int row = 0; row < 3; ++row) {
      numbers.insert(numbers.end(), {frame.axes[0][row], frame.axes[1][row], frame.axes[2][row], frame.origin[row]});
    }
  }
  require_finite_values(std::span<const float>(numbers));
  return numbers;
}

Vec3 tint_scale(const std::vector<Vec3>& tints) {
  Vec3 scale(1e-6F);  // lower bound if all factors are 0
  for (const Vec3 tint : tints) scale = glm::max(scale, tint);
  return scale;
}

std::vector<std::uint8_t> packed_tints(const std::vector<Vec3>& tints, Vec3 scale) {
  const auto byte = [](float share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0F, 1.0F)));
  };
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * tints.size());
  for (const Vec3 tint : tints) {
    const Vec3 share = tint / scale;
    bytes.insert(bytes.end(), {byte(share.r), byte(share.g), byte(share.b), std::uint8_t{255}});
  }
  return bytes;
}

}  // namespace meristem

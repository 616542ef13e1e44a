// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "meristem/base/limits.h"

namespace meristem {

/// The component types of glTF.
inline constexpr std::uint64_t kGltfInt8 = 5120;
inline constexpr std::uint64_t kGltfUint8 = 5121;
inline constexpr std::uint64_t kGltfInt16 = 5122;
inline constexpr std::uint64_t kGltfUint16 = 5123;
inline constexpr std::uint64_t kGltfUint32 = 5125;
inline constexpr std::uint64_t kGltfFloat32 = 5126;

/// A list of elements in the binary chunk, each with a few numbers.
struct GltfNumbers {
  const char* begin = nullptr;
  std::uint64_t count = 0;   ///< number of elements
  std::uint64_t stride = 0;  ///< bytes from one element to the next
  std::uint64_t type = kGltfFloat32;
  std::uint64_t type_bytes = 4;
  bool is_normalized = false;

  double number(std::uint64_t element, std::uint64_t component) const;
};

/// The two chunks of a binary glTF 2.0 file, with checked access to the members of its JSON. All functions throw
/// InputError with the place in the JSON for invalid content. Arguments `place` are used for these messages.
class GlbFile {
 public:
  using Json = nlohmann::json;

  /// `bytes` and `file`, its name in messages, must outlive this object.
  GlbFile(std::string_view bytes, const std::string& file, const SizeLimits& limits);

  const Json& root() const { return root_; }
  [[noreturn]] void fail(const std::string& place, std::string message, std::string expected = {}) const;

  /// Returns a member of an object, or null.
  const Json* find(const Json& object, const char* key, const std::string& place) const;
  /// Returns a member that is a list, or an empty list if it is missing.
  const Json& list(const Json& object, const char* key, const std::string& place) const;
  /// Returns a whole number of at least 0, or nothing if it is missing.
  std::optional<std::uint64_t> whole(const Json& object, const char* key, const std::string& place) const;
  std::uint64_t as_whole(const Json& value, const std::string& what, const std::string& place) const;
  /// Returns the element with an index in one of the top-level lists.
  const Json& element(const char* key, std::uint64_t index, const std::string& place) const;
  /// Fills `numbers` from a list of the same length. Returns false if the member is missing.
  template <std::size_t kCount>
  bool fill(const Json& from, const char* key, const std::string& place, std::array<double, kCount>& numbers) const {
    const Json* found = find(from, key, place);
    if (found == nullptr) return false;
    const bool fits = found->is_array() && found->size() == kCount &&
                      std::all_of(found->begin(), found->end(), [](const Json& each) { return each.is_number(); });
    if (!fits) fail(place, fmt::format("'{}' is wrong", key), fmt::format("{} numbers", kCount));
    for (std::size_t k = 0; k < kCount; ++k) numbers[k] = (*found)[k].template get<double>();
    return true;
  }

  /// Returns the data of an accessor with this number of components (3 for "VEC3"). Checks that all data lie in the
  /// binary chunk.
  GltfNumbers numbers(std::uint64_t accessor, std::string_view type, std::uint64_t components) const;

 private:
  std::string_view take_chunk(std::string_view& rest, std::uint32_t type, const char* name) const;
  void parse(std::string_view json, const SizeLimits& limits);
  void check_extensions() const;
  std::uint64_t component_bytes(std::uint64_t type, const std::string& place) const;
  std::string_view view_bytes(const Json& view, const std::string& place) const;

  const std::string& file_;
  std::string_view binary_;
  Json root_;
};

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// A reader of binary glTF that is independent of the writer.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "meristem/output/gltf/gltf.h"
#include "tests/support/temporary_folder.h"

namespace meristem {

struct Glb {
  using Json = nlohmann::json;

  std::string bytes;
  Json json;
  std::string binary;

  const Json& view(const Json& index) const { return json["bufferViews"][index.get<int>()]; }
  std::string bytes_of(const Json& view) const {
    return binary.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
  }
  template <class T>
  std::vector<T> values(const Json& accessor) const {
    const std::string data = bytes_of(view(accessor["bufferView"]));
    std::vector<T> result(data.size() / sizeof(T));
    std::memcpy(result.data(), data.data(), result.size() * sizeof(T));
    return result;
  }
  const Json& accessor(const Json& index) const { return json["accessors"][index.get<int>()]; }
  const Json& accessor(const Json& primitive, const char* attribute) const {
    return accessor(primitive["attributes"][attribute]);
  }
  const Json& indices(const Json& primitive) const { return accessor(primitive["indices"]); }
};

inline std::uint32_t word(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

inline Glb read_glb(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  Glb glb;
  glb.bytes.assign(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(glb.bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(glb.bytes, 4), 2U);
  EXPECT_EQ(word(glb.bytes, 8), glb.bytes.size());
  const std::uint32_t json_bytes = word(glb.bytes, 12);
  EXPECT_EQ(json_bytes % 4, 0U);
  EXPECT_EQ(glb.bytes.substr(16, 4), "JSON");
  glb.json = Glb::Json::parse(glb.bytes.substr(20, json_bytes));
  if (glb.bytes.size() > 20 + json_bytes) {
    EXPECT_EQ(word(glb.bytes, 20 + json_bytes), glb.json["buffers"][0]["byteLength"]);
    EXPECT_EQ(glb.bytes.substr(24 + json_bytes, 4), std::string("BIN\0", 4));
    glb.binary = glb.bytes.substr(28 + json_bytes);
  }
  return glb;
}

/// Returns the bytes of the written scene.
inline std::string glb_bytes(const MeshScene& scene, const GltfOptions& options = {}) {
  const TemporaryFolder folder;
  Progress progress;
  write_glb(scene, folder / "plant.glb", options, progress);
  std::ifstream stream(folder / "plant.glb", std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Writes a scene and reads it again.
inline Glb written_glb(const MeshScene& scene, const GltfOptions& options = {}) {
  const TemporaryFolder folder;
  const std::string path = folder / "plant.glb";
  Progress progress;
  write_glb(scene, path, options, progress);
  return read_glb(path);
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
// The scene that a viewer shows after scene packets, applied as apps/studio/protocol.md defines. Violations fail the
// test.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meristem/document/json.h"

namespace meristem {

/// The head of a packet, and its arrays.
struct ReadPacket {
  Value head;
  std::string_view arrays;

  explicit ReadPacket(std::string_view packet, std::string_view letters = "MSP1") {
    EXPECT_GE(packet.size(), 8U);
    EXPECT_EQ(packet.substr(0, 4), letters);
    std::uint32_t size = 0;
    std::memcpy(&size, packet.data() + 4, 4);
    EXPECT_EQ(size % 4, 0U);
    EXPECT_LE(8 + std::uint64_t{size}, packet.size());
    head = parse_json(packet.substr(8, size));
    arrays = packet.substr(8 + size);
  }

  double number(std::string_view name) const { return *head.find(name)->number(); }
  bool flag(std::string_view name) const { return *head.find(name)->boolean(); }
  /// Returns the bytes of an array of the head. Its numbers have `width` bytes each.
  std::string_view bytes(const Value& place, std::size_t width) const {
    const auto at = static_cast<std::size_t>(*(*place.list())[0].number());
    const std::size_t size = static_cast<std::size_t>(*(*place.list())[1].number()) * width;
    EXPECT_EQ(at % 4, 0U);
    EXPECT_LE(at + size, arrays.size());
    return arrays.substr(std::min(at, arrays.size()), size);
  }
  /// Returns the number of elements of a list in the head; 0 without such a list.
  std::size_t count(std::string_view list) const {
    const Value* found = head.find(list);
    return found == nullptr ? 0 : found->list()->size();
  }
};

class ShownScene {
 public:
  void apply(std::string_view packet) {
    const ReadPacket read(packet);
    if (read.flag("whole")) *this = {};
    for (const Value& picture : list(read, "pictures")) add(pictures_, picture, read, {{"bytes", 1}});
    for (const Value& mesh : list(read, "meshes")) {
      const bool is_small = mesh.find("index_type") != nullptr && *mesh.find("index_type")->text() == "u16";
      const bool has_small_uvs = mesh.find("uv_type") != nullptr && *mesh.find("uv_type")->text() == "u16";
      add(meshes_, mesh, read,
          {{"positions", 4},
           {"normals", 1},
           {"tangents", 1},
           {"uvs", has_small_uvs ? 2 : 4},
           {"indices", is_small ? 2 : 4}});
    }
    for (const Value& set : list(read, "instances_of")) add(instances_, set, read, {{"frames", 4}, {"tints", 1}});
    for (const Value& skeleton : list(read, "skeletons"))
      add(skeletons_, skeleton, read, {{"positions", 4}, {"segments", 4}, {"orders", 1}, {"radii", 4}});
    for (const Value& material : list(read, "materials"))
      materials_[*material.find("index")->number()] = write_json_line(material);
    for (const Value& batch : list(read, "batches")) {
      batches_[{*batch.find("component")->text(), *batch.find("number")->number()}] = write_json_line(batch);
      EXPECT_TRUE(meshes_.count(*batch.find("mesh")->text()));
      EXPECT_TRUE(instances_.count(*batch.find("instances_of")->text()));
    }
    if (const Value* lines = read.head.find("lines")) lines_ = write_json_line(*lines);
    if (const Value* gone = read.head.find("gone")) take_out(*gone);
  }

  std::size_t mesh_count() const { return meshes_.size(); }
  std::size_t batch_count() const { return batches_.size(); }

  bool operator==(const ShownScene&) const = default;

 private:
  using Content = std::map<std::string, std::string>;

  static const Value::List& list(const ReadPacket& read, std::string_view name) {
    static const Value::List none;
    const Value* found = read.head.find(name);
    return found == nullptr ? none : *found->list();
  }

  /// Replaces the positions of arrays by their bytes.
  static void add(Content& to, const Value& part, const ReadPacket& read, const std::map<std::string, int>& widths) {
    std::string content;
    for (const auto& [name, value] : *part.object()) {
      content += name + "=";
      const auto width = widths.find(name);
      if (width == widths.end()) {
        content += write_json_line(value);
        continue;
      }
      content += read.bytes(value, static_cast<std::size_t>(width->second));
    }
    EXPECT_TRUE(to.emplace(*part.find("key")->text(), content).second) << "was there already";
  }

  void take_out(const Value& gone) {
    for (const auto& [name, value] : *gone.object()) {
      if (name == "materials") {
        materials_.erase(materials_.lower_bound(*value.number()), materials_.end());
        continue;
      }
      for (const Value& entry : *value.list()) {
        if (name == "batches") {
          EXPECT_EQ(batches_.erase({*(*entry.list())[0].text(), *(*entry.list())[1].number()}), 1U);
        } else {
          Content& content = name == "meshes"         ? meshes_
                             : name == "instances_of" ? instances_
                             : name == "pictures"     ? pictures_
                                                      : skeletons_;
          EXPECT_EQ(content.erase(*entry.text()), 1U) << name;
        }
      }
    }
  }

  Content meshes_;
  Content instances_;
  Content pictures_;
  Content skeletons_;
  std::map<double, std::string> materials_;
  std::map<std::pair<std::string, double>, std::string> batches_;
  std::string lines_ = "[]";
};

}  // namespace meristem

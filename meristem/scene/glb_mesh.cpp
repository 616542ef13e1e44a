// SPDX-License-Identifier: Apache-2.0
// Two chunks, one of JSON and one of bytes; of all that glTF can say, nodes, meshes and two accessors a primitive. Read
// here and not by tinygltf, which follows nested JSON by recursion, opens any file that a buffer names, and does not
// say where a fault lies. Based on: Khronos Group, glTF 2.0 Specification (2021), sections 3.5 to 3.7 and 4.
#include "meristem/scene/glb_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>

#include "meristem/base/diagnostic.h"

namespace meristem {

namespace {

static_assert(std::endian::native == std::endian::little, "the numbers of glTF are read as they stand");

using Json = nlohmann::json;

constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kMostWhole = std::uint64_t{1} << 40;  // no sum or product of what is read can overflow
constexpr std::uint64_t kMostVertices = 4294967295;

enum ComponentType : std::uint64_t { kInt8 = 5120, kUint8, kInt16, kUint16, kUint32 = 5125, kFloat32 };
enum PrimitiveMode : std::uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

/// Extensions that change nothing about where triangles are, or only what their numbers are stored as.
bool is_harmless(const std::string& extension) {
  return extension == "KHR_mesh_quantization" || extension.starts_with("KHR_materials_") ||
         extension.starts_with("KHR_texture_") || extension.starts_with("EXT_texture_") ||
         extension.starts_with("KHR_lights_");
}

template <class T>
T read_as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// A list of equal numbers in the binary chunk.
struct Numbers {
  const char* begin = nullptr;
  std::uint64_t count = 0;  // of elements
  std::uint64_t stride = 0;
  std::uint64_t type = kFloat32;
  std::uint64_t type_bytes = 4;
  bool is_normalized = false;

  double number(std::uint64_t element, std::uint64_t component) const {
    const char* at = begin + element * stride + component * type_bytes;
    const auto whole = [this](double value, double most) {
      return is_normalized ? std::max(value / most, -1.0) : value;
    };
    switch (type) {
      case kInt8:
        return whole(read_as<std::int8_t>(at), 127);
      case kUint8:
        return whole(read_as<std::uint8_t>(at), 255);
      case kInt16:
        return whole(read_as<std::int16_t>(at), 32767);
      case kUint16:
        return whole(read_as<std::uint16_t>(at), 65535);
      case kUint32:
        return read_as<std::uint32_t>(at);
      default:
        return read_as<float>(at);
    }
  }
};

/// The chunks of a file, and what its JSON says, checked member by member.
class GlbFile {
 public:
  GlbFile(std::string_view bytes, const std::string& file, const Limits& limits) : file_(file) {
    if (bytes.size() < 20) fail("", "the file is cut off in its header", "the whole file");
    if (const auto version = read_as<std::uint32_t>(bytes.data() + 4); version != 2) {
      fail("", fmt::format("the file is of glTF version {}", version), "version 2");
    }
    if (const auto length = read_as<std::uint32_t>(bytes.data() + 8); length > bytes.size()) {
      fail("", fmt::format("the file promises {} bytes, but is cut off after {}", length, bytes.size()),
           "the whole file");
    }
    std::string_view rest = bytes.substr(12);
    const std::string_view json = take_chunk(rest, kJsonChunk, "JSON");
    if (!rest.empty()) binary_ = take_chunk(rest, kBinaryChunk, "binary");
    if (json.size() > limits.document_bytes) {
      fail("", fmt::format("the JSON of the file has {} bytes", json.size()),
           fmt::format("at most {}", limits.document_bytes));
    }
    try {
      root_ = Json::parse(json);
    } catch (const Json::parse_error& error) {
      fail("", fmt::format("the JSON of the file is broken at its byte {}", error.byte), "valid JSON");
    } catch (const Json::exception&) {
      fail("", "the JSON of the file has a number too large", "finite numbers");
    }
    check_head();
  }

  const Json& root() const { return root_; }

  [[noreturn]] void fail(const std::string& place, std::string message, std::string expected = {}) const {
    if (!place.empty()) message = place + ": " + message;
    throw InputError(Diagnostic{.message = std::move(message), .expected = std::move(expected), .file = file_});
  }

  /// A member of an object, or null.
  const Json* find(const Json& object, const char* key, const std::string& place) const {
    if (!object.is_object()) fail(place, "this is no object", "an object");
    const auto found = object.find(key);
    return found != object.end() ? &*found : nullptr;
  }
  /// A member that is a list; empty where it is missing.
  const Json& list(const Json& object, const char* key, const std::string& place) const {
    static const Json kNone = Json::array();
    const Json* found = find(object, key, place);
    if (found == nullptr) return kNone;
    if (!found->is_array()) fail(place, fmt::format("'{}' is no list", key), "a list");
    return *found;
  }
  /// A whole number of at least 0; nothing where it is missing.
  std::optional<std::uint64_t> whole(const Json& object, const char* key, const std::string& place) const {
    const Json* found = find(object, key, place);
    if (found == nullptr) return std::nullopt;
    return as_whole(*found, fmt::format("'{}'", key), place);
  }
  std::uint64_t as_whole(const Json& value, const std::string& what, const std::string& place) const {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMostWhole) {
      fail(place, what + " is no whole number of at least 0, or too large", fmt::format("0 to {}", kMostWhole));
    }
    return value.get<std::uint64_t>();
  }
  /// The object with an index in one of the lists at the top.
  const Json& object(const char* key, std::uint64_t index, const std::string& place) const {
    const Json& all = list(root_, key, "");
    if (index >= all.size()) {
      fail(place, fmt::format("there is no {}[{}]", key, index), fmt::format("fewer than {}", all.size()));
    }
    return all[index];
  }
  /// Fills `numbers` from a list of as many; false where it is missing.
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

  /// An accessor of elements with so many components each, all of which lie in the binary chunk.
  Numbers numbers(std::uint64_t index, std::string_view type, std::uint64_t components) const {
    const std::string place = fmt::format("accessors[{}]", index);
    const Json& accessor = object("accessors", index, place);
    const Json* given = find(accessor, "type", place);
    if (given == nullptr || *given != type) fail(place, "the 'type' does not fit", fmt::format("\"{}\"", type));
    if (find(accessor, "sparse", place) != nullptr) fail(place, "the numbers are sparse", "plain numbers");
    const auto view_index = whole(accessor, "bufferView", place);
    if (!view_index) fail(place, "the numbers are compressed or left out", "a 'bufferView' in the file itself");
    Numbers result;
    result.count = whole(accessor, "count", place).value_or(0);
    result.type = whole(accessor, "componentType", place).value_or(0);
    result.type_bytes = component_bytes(result.type, place);
    if (const Json* normalized = find(accessor, "normalized", place)) result.is_normalized = *normalized == true;
    locate(result, *view_index, whole(accessor, "byteOffset", place).value_or(0), components * result.type_bytes,
           place);
    return result;
  }

 private:
  std::string_view take_chunk(std::string_view& rest, std::uint32_t type, const char* name) const {
    if (rest.size() < 8) fail("", fmt::format("the file is cut off before its {} chunk", name), "the whole file");
    const auto length = read_as<std::uint32_t>(rest.data());
    if (read_as<std::uint32_t>(rest.data() + 4) != type) fail("", fmt::format("the file has no {} chunk", name));
    rest.remove_prefix(8);
    if (length > rest.size()) {
      fail("", fmt::format("the {} chunk promises {} bytes, but {} are left", name, length, rest.size()),
           "the whole file");
    }
    const std::string_view chunk = rest.substr(0, length);
    rest.remove_prefix(std::min<std::size_t>((std::size_t{length} + 3) / 4 * 4, rest.size()));
    return chunk;
  }

  void check_head() const {
    if (!root_.is_object()) fail("", "the JSON of the file is no object", "an object");
    for (const Json& extension : list(root_, "extensionsRequired", "")) {
      if (!extension.is_string()) fail("extensionsRequired", "this is no name", "names of extensions");
      const auto& name = extension.get_ref<const std::string&>();
      if (!is_harmless(name)) {
        fail("", fmt::format("the file cannot be read without the extension '{}'", name.substr(0, 60)),
             "a file without compression and instancing");
      }
    }
  }

  std::uint64_t component_bytes(std::uint64_t type, const std::string& place) const {
    switch (type) {
      case kInt8:
      case kUint8:
        return 1;
      case kInt16:
      case kUint16:
        return 2;
      case kUint32:
      case kFloat32:
        return 4;
      default:
        fail(place, fmt::format("{} is no 'componentType'", type), "5120 to 5123, 5125 or 5126");
    }
  }

  /// Finds the bytes of `result` in its view, which has to hold all of them.
  void locate(Numbers& result, std::uint64_t view_index, std::uint64_t offset, std::uint64_t element_bytes,
              const std::string& accessor_place) const {
    const std::string place = fmt::format("bufferViews[{}]", view_index);
    const Json& view = object("bufferViews", view_index, accessor_place);
    const std::uint64_t buffer_index = whole(view, "buffer", place).value_or(0);
    const Json& buffer = object("buffers", buffer_index, place);
    if (buffer_index != 0 || find(buffer, "uri", place) != nullptr) {
      fail(fmt::format("buffers[{}]", buffer_index), "the bytes are not in the file's own binary chunk",
           "a binary glTF with all of its data");
    }
    const std::uint64_t begin = whole(view, "byteOffset", place).value_or(0);
    const std::uint64_t length = whole(view, "byteLength", place).value_or(0);
    if (begin + length > binary_.size()) {
      fail(place, fmt::format("the view ends at byte {} of {}", begin + length, binary_.size()),
           "a view within the binary chunk");
    }
    result.stride = whole(view, "byteStride", place).value_or(element_bytes);
    if (result.stride < element_bytes) {
      fail(place, fmt::format("the 'byteStride' {} is too small", result.stride),
           fmt::format("at least {}", element_bytes));
    }
    const std::uint64_t room =
        offset + element_bytes <= length ? (length - offset - element_bytes) / result.stride + 1 : 0;
    if (result.count > room) {
      fail(accessor_place, fmt::format("{} elements are promised, but the view has room for {}", result.count, room),
           "elements that the file holds");
    }
    result.begin = binary_.data() + begin + offset;
  }

  const std::string& file_;
  std::string_view binary_;
  Json root_;
};

/// Goes through the nodes of the scene and gathers their triangles.
class SceneReader {
 public:
  SceneReader(const GlbFile& glb, const std::string& file, const Limits& limits)
      : glb_(glb), file_(file), limits_(limits), is_seen_(glb.list(glb.root(), "nodes", "").size()) {}

  TriangleMesh read() {
    const std::uint64_t index = glb_.whole(glb_.root(), "scene", "").value_or(0);
    const Json& scene = glb_.object("scenes", index, "");
    add_nodes(scene, "nodes", fmt::format("scenes[{}]", index), glm::dmat4(1));
    while (!waiting_.empty()) {
      const auto [node_index, outer] = waiting_.back();
      waiting_.pop_back();
      const std::string place = fmt::format("nodes[{}]", node_index);
      const Json& node = glb_.object("nodes", node_index, place);
      const glm::dmat4 placed = outer * local_transform(node, place);
      if (const Json* extensions = glb_.find(node, "extensions", place);
          extensions != nullptr && glb_.find(*extensions, "EXT_mesh_gpu_instancing", place) != nullptr) {
        glb_.fail(place, "the mesh is placed by the extension 'EXT_mesh_gpu_instancing'", "a node for each place");
      }
      if (const auto mesh = glb_.whole(node, "mesh", place)) add_mesh(*mesh, place, placed);
      add_nodes(node, "children", place, placed);
    }
    return std::move(mesh_);
  }

 private:
  struct Waiting {
    std::uint64_t node = 0;
    glm::dmat4 outer;
  };

  void add_nodes(const Json& parent, const char* key, const std::string& place, const glm::dmat4& outer) {
    const Json& nodes = glb_.list(parent, key, place);
    // The last one waits on top, so they are put there from behind.
    for (std::size_t k = nodes.size(); k-- > 0;) {
      const std::uint64_t node = glb_.as_whole(nodes[k], "a node", place);
      if (node >= is_seen_.size()) glb_.fail(place, fmt::format("there is no nodes[{}]", node));
      if (is_seen_[node]) glb_.fail(place, fmt::format("nodes[{}] hangs in two places", node), "a tree of nodes");
      is_seen_[node] = true;
      waiting_.push_back({node, outer});
    }
  }

  glm::dmat4 local_transform(const Json& node, const std::string& place) const {
    std::array<double, 16> columns{};
    if (glb_.fill(node, "matrix", place, columns)) {
      glm::dmat4 matrix(1);
      for (int k = 0; k < 16; ++k) matrix[k / 4][k % 4] = columns[static_cast<std::size_t>(k)];
      return matrix;
    }
    std::array<double, 3> translation{};
    std::array<double, 4> rotation{0, 0, 0, 1};
    std::array<double, 3> scale{1, 1, 1};
    glb_.fill(node, "translation", place, translation);
    glb_.fill(node, "rotation", place, rotation);
    glb_.fill(node, "scale", place, scale);
    const glm::dquat turn(rotation[3], rotation[0], rotation[1], rotation[2]);
    glm::dmat4 matrix(glm::mat3_cast(turn));
    for (int k = 0; k < 3; ++k) matrix[k] *= scale[static_cast<std::size_t>(k)];
    matrix[3] = glm::dvec4(translation[0], translation[1], translation[2], 1);
    return matrix;
  }

  void add_mesh(std::uint64_t index, const std::string& node_place, const glm::dmat4& placed) {
    const std::string place = fmt::format("meshes[{}]", index);
    const Json& primitives = glb_.list(glb_.object("meshes", index, node_place), "primitives", place);
    check_limit("placed parts of a file", placed_ += primitives.size(), limits_.instances, "instances");
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      add_primitive(primitives[k], fmt::format("{}.primitives[{}]", place, k), placed);
    }
  }

  void add_primitive(const Json& primitive, const std::string& place, const glm::dmat4& placed) {
    const std::uint64_t mode = glb_.whole(primitive, "mode", place).value_or(kTriangles);
    if (mode > kFan) glb_.fail(place, fmt::format("{} is no 'mode'", mode), "0 to 6");
    if (mode < kTriangles) return;  // points and lines
    const Numbers positions = positions_of(primitive, place);
    const std::optional<Numbers> indices = indices_of(primitive, place);
    const std::uint64_t corners = indices ? indices->count : positions.count;
    const std::uint64_t triangles = mode == kTriangles ? corners / 3 : std::max<std::uint64_t>(corners, 2) - 2;
    check_limit("triangles of a file", mesh_.triangles.size() + triangles, limits_.triangles, "triangles");
    const std::uint64_t most_vertices = std::min(kMostVertices, 3 * std::min(limits_.triangles, kMostVertices));
    check_limit("vertices of a file", mesh_.positions.size() + positions.count, most_vertices, "triangles");

    const std::uint64_t first = mesh_.positions.size();
    add_positions(positions, placed, place);
    const auto vertex = [&](std::uint64_t corner) {
      const auto index = indices ? static_cast<std::uint64_t>(indices->number(corner, 0)) : corner;
      if (index >= positions.count) {
        glb_.fail(place, fmt::format("index {}: there is no vertex {}", corner, index),
                  fmt::format("fewer than {}", positions.count));
      }
      return static_cast<std::uint32_t>(first + index);
    };
    const bool is_mirrored = glm::determinant(glm::dmat3(placed)) < 0;
    for (std::uint64_t t = 0; t < triangles; ++t) {
      const auto [a, b, c] = corners_of(mode, t);
      std::array<std::uint32_t, 3>& triangle = mesh_.triangles.emplace_back();
      triangle = {vertex(a), vertex(b), vertex(c)};
      if (is_mirrored) std::swap(triangle[1], triangle[2]);
    }
  }

  Numbers positions_of(const Json& primitive, const std::string& place) const {
    const Json* attributes = glb_.find(primitive, "attributes", place);
    const auto index =
        attributes != nullptr ? glb_.whole(*attributes, "POSITION", place) : std::optional<std::uint64_t>();
    if (!index) glb_.fail(place, "the primitive has no positions", "the attribute 'POSITION'");
    return glb_.numbers(*index, "VEC3", 3);
  }

  /// Nothing where the positions are taken in order.
  std::optional<Numbers> indices_of(const Json& primitive, const std::string& place) const {
    const auto index = glb_.whole(primitive, "indices", place);
    if (!index) return std::nullopt;
    const Numbers indices = glb_.numbers(*index, "SCALAR", 1);
    if (indices.is_normalized || (indices.type != kUint8 && indices.type != kUint16 && indices.type != kUint32)) {
      glb_.fail(fmt::format("accessors[{}]", *index), "indices are neither negative nor fractions",
                "the 'componentType' 5121, 5123 or 5125");
    }
    return indices;
  }

  /// The places of a triangle's corners in the list of indices.
  static std::array<std::uint64_t, 3> corners_of(std::uint64_t mode, std::uint64_t triangle) {
    if (mode == kStrip) return {triangle, triangle + 1 + triangle % 2, triangle + 2 - triangle % 2};
    if (mode == kFan) return {triangle + 1, triangle + 2, 0};
    return {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
  }

  void add_positions(const Numbers& positions, const glm::dmat4& placed, const std::string& place) {
    for (std::uint64_t k = 0; k < positions.count; ++k) {
      const glm::dvec4 local(positions.number(k, 0), positions.number(k, 1), positions.number(k, 2), 1);
      const DVec3 position(placed * local);
      if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
        glb_.fail(place, fmt::format("vertex {} has a coordinate that is not finite", k), "finite numbers");
      }
      mesh_.positions.push_back(position);
    }
  }

  void check_limit(const char* what, std::uint64_t count, std::uint64_t limit, const char* name) const {
    if (count <= limit) return;
    Diagnostic diagnostic = limit_diagnostic(what, static_cast<double>(count), limit, name, "");
    diagnostic.file = file_;
    throw InputError(std::move(diagnostic));
  }

  const GlbFile& glb_;
  const std::string& file_;
  const Limits& limits_;
  std::vector<bool> is_seen_;  // of the nodes
  std::vector<Waiting> waiting_;
  std::uint64_t placed_ = 0;  // primitives
  TriangleMesh mesh_;
};

}  // namespace

bool begins_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

TriangleMesh parse_glb(std::string_view bytes, const std::string& file, const Limits& limits) {
  const GlbFile glb(bytes, file, limits);
  return SceneReader(glb, file, limits).read();
}

}  // namespace meristem

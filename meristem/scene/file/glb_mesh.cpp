// SPDX-License-Identifier: Apache-2.0
// Reads the triangles of a binary glTF file: nodes, meshes and two accessors per primitive. The project does not use
// tinygltf here, because it reads nested JSON by recursion, opens any file that a buffer names, and does not report the
// place of an error.
//
// Based on: Khronos Group, glTF 2.0 Specification (2021), sections 3.5 to 3.7 and 4.
#include "meristem/scene/file/glb_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "meristem/base/diagnostic.h"
#include "meristem/base/number_limit.h"
#include "meristem/base/reading_stop.h"
#include "meristem/scene/file/glb_file.h"

namespace meristem {

namespace {

using Json = GlbFile::Json;

constexpr std::uint64_t kMaxVertices = 4294967295;

// Modes of primitives with triangles. Smaller values are points and lines.
constexpr std::uint64_t kTriangles = 4;
constexpr std::uint64_t kStrip = 5;
constexpr std::uint64_t kFan = 6;

/// Visits the nodes of the scene and collects their triangles.
class SceneReader {
 public:
  SceneReader(const GlbFile& glb, const std::string& file, const SizeLimits& limits)
      : glb_(glb), file_(file), limits_(limits), is_seen_(glb.list(glb.root(), "nodes", "").size()) {}

  TriangleMesh read() {
    const std::uint64_t index = glb_.whole(glb_.root(), "scene", "").value_or(0);
    if (glb_.list(glb_.root(), "scenes", "").empty()) glb_.fail("", "the file has no scene", "a scene with the mesh");
    const Json& scene = glb_.element("scenes", index, "");
    add_nodes(scene, "nodes", fmt::format("scenes[{}]", index), glm::dmat4(1));
    while (!waiting_.empty()) {
      const auto [node_index, outer] = waiting_.back();
      waiting_.pop_back();
      stop_.step();
      const std::string place = fmt::format("nodes[{}]", node_index);
      const Json& node = glb_.element("nodes", node_index, place);
      const glm::dmat4 placed = outer * local_transform(node, place);
      if (const Json* extensions = glb_.find(node, "extensions", place);
          extensions != nullptr && glb_.find(*extensions, "EXT_mesh_gpu_instancing", place) != nullptr) {
        glb_.fail(place, "the mesh is placed by the extension 'EXT_mesh_gpu_instancing'", "a node for each instance");
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
    // Push in reverse order, because the last entry is processed first.
    for (std::size_t k = nodes.size(); k-- > 0;) {
      stop_.step();
      const std::uint64_t node = glb_.as_whole(nodes[k], "a node", place);
      if (node >= is_seen_.size()) glb_.fail(place, fmt::format("there is no nodes[{}]", node));
      if (is_seen_[node]) glb_.fail(place, fmt::format("nodes[{}] has two parents", node), "a tree of nodes");
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
    const Json& primitives = glb_.list(glb_.element("meshes", index, node_place), "primitives", place);
    check_limit("placed parts of a file", placed_ += primitives.size(), limits_.instances, "instances");
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      add_primitive(primitives[k], fmt::format("{}.primitives[{}]", place, k), placed);
    }
  }

  void add_primitive(const Json& primitive, const std::string& place, const glm::dmat4& placed) {
    const std::uint64_t mode = glb_.whole(primitive, "mode", place).value_or(kTriangles);
    if (mode > kFan) glb_.fail(place, fmt::format("{} is not a 'mode'", mode), "0 to 6");
    if (mode < kTriangles) return;  // points and lines
    const GltfNumbers positions = positions_of(primitive, place);
    const std::optional<GltfNumbers> indices = indices_of(primitive, place);
    const std::uint64_t corners = indices ? indices->count : positions.count;
    const std::uint64_t triangles = mode == kTriangles ? corners / 3 : std::max<std::uint64_t>(corners, 2) - 2;
    check_limit("triangles of a file", mesh_.triangles.size() + triangles, limits_.triangles, "triangles");
    const std::uint64_t max_vertices = std::min(kMaxVertices, 3 * std::min(limits_.triangles, kMaxVertices));
    check_limit("vertices of a file", mesh_.positions.size() + positions.count, max_vertices, "triangles");

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
      stop_.step();
      const auto [a, b, c] = corners_of(mode, t);
      std::array<std::uint32_t, 3>& triangle = mesh_.triangles.emplace_back();
      triangle = {vertex(a), vertex(b), vertex(c)};
      if (is_mirrored) std::swap(triangle[1], triangle[2]);
    }
  }

  GltfNumbers positions_of(const Json& primitive, const std::string& place) const {
    const Json* attributes = glb_.find(primitive, "attributes", place);
    const auto index =
        attributes != nullptr ? glb_.whole(*attributes, "POSITION", place) : std::optional<std::uint64_t>();
    if (!index) glb_.fail(place, "the primitive has no positions", "the attribute 'POSITION'");
    return glb_.numbers(*index, "VEC3", 3);
  }

  /// Returns nothing if the positions are used in order.
  std::optional<GltfNumbers> indices_of(const Json& primitive, const std::string& place) const {
    const auto index = glb_.whole(primitive, "indices", place);
    if (!index) return std::nullopt;
    const GltfNumbers indices = glb_.numbers(*index, "SCALAR", 1);
    if (indices.is_normalized ||
        (indices.type != kGltfUint8 && indices.type != kGltfUint16 && indices.type != kGltfUint32)) {
      glb_.fail(fmt::format("accessors[{}]", *index), "indices are neither negative nor fractions",
                "the 'componentType' 5121, 5123 or 5125");
    }
    return indices;
  }

  /// Returns the corners of a triangle as positions in the list of indices.
  static std::array<std::uint64_t, 3> corners_of(std::uint64_t mode, std::uint64_t triangle) {
    if (mode == kStrip) return {triangle, triangle + 1 + triangle % 2, triangle + 2 - triangle % 2};
    if (mode == kFan) return {triangle + 1, triangle + 2, 0};
    return {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
  }

  void add_positions(const GltfNumbers& positions, const glm::dmat4& placed, const std::string& place) {
    for (std::uint64_t k = 0; k < positions.count; ++k) {
      stop_.step();
      const glm::dvec4 local(positions.number(k, 0), positions.number(k, 1), positions.number(k, 2), 1);
      const DVec3 position(placed * local);
      if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
        glb_.fail(place, fmt::format("vertex {} has a coordinate that is not finite", k), "finite numbers");
      }
      for (int axis = 0; axis < 3; ++axis) {
        if (kFileCoordinate.holds(position[axis])) continue;
        const Diagnostic error =
            number_error(fmt::format("the coordinate {:.6g} of vertex {}", position[axis], k), kFileCoordinate);
        glb_.fail(place, error.message, error.expected);
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

  StopCounter stop_;
  const GlbFile& glb_;
  const std::string& file_;
  const SizeLimits& limits_;
  std::vector<bool> is_seen_;  // one flag per node
  std::vector<Waiting> waiting_;
  std::uint64_t placed_ = 0;  // number of primitives so far
  TriangleMesh mesh_;
};

}  // namespace

bool begins_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

TriangleMesh parse_glb(std::string_view bytes, const std::string& file, const SizeLimits& limits) {
  const GlbFile glb(bytes, file, limits);
  return SceneReader(glb, file, limits).read();
}

}  // namespace meristem

// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/file/glb_mesh.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/scene/file/read_mesh.h"
#include "meristem/scene/obstacle/obstacles.h"
#include "tests/support/sample_bodies.h"

namespace meristem::glb_mesh_test {

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_chunk(std::string& bytes, std::string content, std::uint32_t type, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  append(bytes, static_cast<std::uint32_t>(content.size()));
  append(bytes, type);
  bytes += content;
}

// A file of version 2 with both chunks.
std::string glb(const std::string& json, const std::string& binary) {
  std::string chunks;
  append_chunk(chunks, json, 0x4E4F534A, ' ');
  append_chunk(chunks, binary, 0x004E4942, '\0');
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return bytes + chunks;
}

// The binary data of one primitive: positions, then indices of type T.
template <class T>
std::string data_of(const TriangleMesh& mesh) {
  std::string bytes;
  for (const DVec3 position : mesh.positions) append(bytes, Vec3(position));
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) append(bytes, static_cast<T>(vertex));
  }
  return bytes;
}

constexpr const char* kOneNode = R"([{"mesh": 0}])";

// The JSON for data_of(box()): 8 vertices, 36 indices.
std::string box_json(int index_type, int index_bytes, const std::string& nodes = kOneNode,
                     const std::string& roots = "[0]") {
  return fmt::format(
      R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": {}}}], "nodes": {},
 "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
 "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"}},
               {{"bufferView": 1, "componentType": {}, "count": 36, "type": "SCALAR"}}],
 "bufferViews": [{{"buffer": 0, "byteLength": 96}}, {{"buffer": 0, "byteOffset": 96, "byteLength": {}}}],
 "buffers": [{{"byteLength": {}}}]}})",
      roots, nodes, index_type, 36 * index_bytes, 96 + 36 * index_bytes);
}

const TriangleMesh& box() {
  static const TriangleMesh mesh = box_mesh({0, 0, 0}, {1, 2, 3});
  return mesh;
}

TriangleMesh parse(const std::string& bytes, const SizeLimits& limits = {}) {
  return parse_mesh(bytes, "body", limits);
}

std::string error(const std::string& bytes, const SizeLimits& limits = {}) {
  try {
    parse(bytes, limits);
  } catch (const InputError& error) {
    return error.diagnostics().at(0).text();
  }
  return "no fault";
}

std::string box_glb(const std::string& nodes = kOneNode, const std::string& roots = "[0]") {
  return glb(box_json(5123, 2, nodes, roots), data_of<std::uint16_t>(box()));
}

// Returns the error message for the box's JSON with one part replaced.
std::string error_with(const std::string& part, const std::string& otherwise, const SizeLimits& limits = {}) {
  std::string json = box_json(5123, 2);
  const std::size_t at = json.find(part);
  if (at == std::string::npos) return "no such part";
  return error(glb(json.replace(at, part.size(), otherwise), data_of<std::uint16_t>(box())), limits);
}

TEST(GlbMesh, TakesEveryTypeOfIndex) {
  for (const std::string& bytes : {glb(box_json(5121, 1), data_of<std::uint8_t>(box())), box_glb(),
                                   glb(box_json(5125, 4), data_of<std::uint32_t>(box()))}) {
    const TriangleMesh mesh = parse(bytes);
    EXPECT_EQ(mesh.positions, box().positions);
    EXPECT_EQ(mesh.triangles, box().triangles);
    EXPECT_TRUE(closedness_errors(mesh).empty());
  }
}

TEST(GlbMesh, NodesPlaceTheirMeshes) {
  // A child of a moved node, rotated by a quarter turn about y and scaled by 2, and a node with a mirroring matrix.
  const TriangleMesh mesh = parse(box_glb(
      R"([{"translation": [10, 0, 0], "children": [1]},
          {"mesh": 0, "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476], "scale": [2, 2, 2]},
          {"mesh": 0, "matrix": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-20,1]}, {"mesh": 0}])",
      "[0, 2]"));
  ASSERT_EQ(mesh.positions.size(), 16U);
  // (x, y, z) is mapped to (10 + 2 z, 2 y, -2 x).
  EXPECT_LT(glm::distance(mesh.positions[7], DVec3(16, 4, -2)), 1e-12);
  EXPECT_LT(glm::distance(mesh.positions[15], DVec3(-1, 2, -17)), 1e-12);
  EXPECT_TRUE(closedness_errors(mesh).empty());
  const ClosedMesh closed(mesh);
  EXPECT_EQ(closed.winding_number({13, 2, -1}), 1);
  EXPECT_EQ(closed.winding_number({-0.5, 1, -18}), 1);
  EXPECT_NEAR(closed.volume(), 8 * 6 + 6, 1e-9);
}

TEST(GlbMesh, StripsFansAndPlainListsAreTriangles) {
  std::string places;
  for (const Vec3 point : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(0, 2, 0), Vec3(1, 2, 0)}) {
    append(places, point);
  }
  const auto triangles = [&](int mode) {
    return parse(glb(fmt::format(R"({{"scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"mode": 1, "attributes": {{}}}}, {{"mode": {}, "attributes": {{"POSITION": 0}}}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"}}],
"bufferViews": [{{"buffer": 0, "byteLength": 72}}], "buffers": [{{"byteLength": 72}}]}})",
                                 mode),
                     places))
        .triangles;
  };
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(triangles(4), (Triangles{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(triangles(5), (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}));
  EXPECT_EQ(triangles(6), (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}}));
}

TEST(GlbMesh, TakesInterleavedAndNormalizedNumbers) {
  std::string bytes;
  for (const std::array<std::int16_t, 4> point :
       {std::array<std::int16_t, 4>{0, 0, 0, 7}, {32767, 0, 0, 7}, {0, -32767, 0, 7}}) {
    append(bytes, point);
  }
  const TriangleMesh mesh = parse(glb(
      R"({"extensionsRequired": ["KHR_mesh_quantization"], "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "buffers": [{"byteLength": 24}],
"accessors": [{"bufferView": 0, "componentType": 5122, "normalized": true, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 24, "byteStride": 8}]})",
      bytes));
  EXPECT_EQ(mesh.positions, (std::vector<DVec3>{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
}

TEST(GlbMesh, WhatIsPromisedMustBeThere) {
  EXPECT_EQ(error_with(R"("count": 36)", R"("count": 1000000000)"),
            "body: accessors[1]: 1000000000 elements are declared, but the view has room for 36; expected elements "
            "that the file holds");
  EXPECT_EQ(error_with(R"("byteLength": 72)", R"("byteLength": 4000000000)"),
            "body: bufferViews[1]: the view ends at byte 4000000096 of 168; expected a view within the binary chunk");
  EXPECT_EQ(
      error_with(R"("count": 36)", R"("count": -3)"),
      "body: accessors[1]: 'count' is not a whole number of at least 0, or is too large; expected 0 to 1099511627776");
  EXPECT_EQ(error_with(R"("count": 36)", R"("count": 1e999)"),
            "body: the JSON of the file has a number too large; expected finite numbers");
  EXPECT_EQ(error_with(R"("byteLength": 96)", R"("byteLength": 96, "byteStride": 4)"),
            "body: bufferViews[0]: the 'byteStride' 4 is too small; expected at least 12");
  EXPECT_EQ(error_with(R"("mesh": 0)", R"("mesh": 5)"), "body: nodes[0]: there is no meshes[5]; expected fewer than 1");
  EXPECT_EQ(error_with(R"("bufferView": 1)", R"("bufferView": 2)"),
            "body: accessors[1]: there is no bufferViews[2]; expected fewer than 2");
  EXPECT_EQ(error_with(R"([{"mesh": 0}])", "[7]"), "body: nodes[0]: this is not an object; expected an object");

  TriangleMesh wrong = box();
  wrong.triangles[4][1] = 8;
  EXPECT_EQ(error(glb(box_json(5123, 2), data_of<std::uint16_t>(wrong))),
            "body: meshes[0].primitives[0]: index 13: there is no vertex 8; expected fewer than 8");
  wrong = box();
  wrong.positions[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error(glb(box_json(5123, 2), data_of<std::uint16_t>(wrong))),
            "body: meshes[0].primitives[0]: vertex 3 has a coordinate that is not finite; expected finite numbers");
  EXPECT_EQ(
      error(box_glb(R"([{"mesh": 0, "scale": [1e308, 1e308, 1e308]}])")),
      "body: meshes[0].primitives[0]: the coordinate 1e+308 of vertex 1 is out of range; expected a coordinate from "
      "-1e+12 to 1e+12");
}

TEST(GlbMesh, WhatCannotBeReadIsSaid) {
  EXPECT_EQ(error_with(R"("scene": 0)", R"("extensionsRequired": ["KHR_draco_mesh_compression"])"),
            "body: the file cannot be read without the extension 'KHR_draco_mesh_compression'; expected a file without "
            "compression and instancing");
  EXPECT_EQ(error_with(R"("bufferView": 0, )", ""),
            "body: accessors[0]: the numbers are compressed or left out; expected a 'bufferView' in the file itself");
  EXPECT_EQ(error_with(R"("bufferView": 0, )", R"("bufferView": 0, "sparse": {}, )"),
            "body: accessors[0]: the numbers are sparse; expected plain numbers");
  EXPECT_EQ(
      error_with(R"("buffers": [{)", R"("buffers": [{"uri": "other.bin", )"),
      "body: buffers[0]: the bytes are not in the file's own binary chunk; expected a binary glTF with all of its "
      "data");
  EXPECT_EQ(
      error_with(R"("componentType": 5123)", R"("componentType": 5122)"),
      "body: accessors[1]: indices are neither negative nor fractions; expected the 'componentType' 5121, 5123 or "
      "5125");
  EXPECT_EQ(error_with(R"({"POSITION": 0})", "{}"),
            "body: meshes[0].primitives[0]: the primitive has no positions; expected the attribute 'POSITION'");
  EXPECT_EQ(error_with(R"("mesh": 0)", R"("mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {}})"),
            "body: nodes[0]: the mesh is placed by the extension 'EXT_mesh_gpu_instancing'; expected a node for each "
            "instance");
  EXPECT_EQ(error_with(R"("mesh": 0)", R"("children": [0])"),
            "body: nodes[0]: nodes[0] has two parents; expected a tree of nodes");
  EXPECT_EQ(error_with(R"("mesh": 0)", R"("name": "empty")"),
            "body: the file has no faces; expected an OBJ, PLY or GLB file with faces");
}

TEST(GlbMesh, CutOffFilesAreSaidToBe) {
  const std::string whole = box_glb();
  for (std::size_t size = 4; size < whole.size(); ++size) {
    const std::string said = error(whole.substr(0, size));
    ASSERT_NE(said.find("cut off"), std::string::npos) << size << ": " << said;
  }
  std::string old = whole;
  old[4] = 1;
  EXPECT_EQ(error(old), "body: the file is of glTF version 1; expected version 2");
  EXPECT_EQ(error(glb("{\"asset\": ", "")), "body: the JSON of the file is broken at its byte 13; expected valid JSON");
  EXPECT_EQ(error(glb(std::string(1'000'000, '['), "")).substr(0, 37), "body: the JSON of the file is broken ");
}

TEST(GlbMesh, LimitsBoundWhatItMakes) {
  SizeLimits limits;
  limits.triangles = 11;
  EXPECT_EQ(error(box_glb(), limits),
            "body: 12 triangles of a file are too many; expected at most 11 (limits.triangles)");
  limits = {};
  limits.instances = 1;
  EXPECT_EQ(error(box_glb(R"([{"mesh": 0}, {"mesh": 0}])", "[0, 1]"), limits),
            "body: 2 placed parts of a file are too many; expected at most 1 (limits.instances)");
  limits = {};
  limits.document_bytes = 100;
  EXPECT_EQ(error(box_glb(), limits).substr(0, 30), "body: the JSON of the file has");
}

}  // namespace meristem::glb_mesh_test

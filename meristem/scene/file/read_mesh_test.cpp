// SPDX-License-Identifier: Apache-2.0
#include "meristem/scene/file/read_mesh.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "tests/support/test_data.h"

namespace meristem::read_mesh_test {

TriangleMesh parse(std::string_view bytes, std::uint64_t limit = 100) {
  SizeLimits limits;
  limits.triangles = limit;
  return parse_mesh(bytes, "body", limits);
}

std::string error(std::string_view bytes) {
  try {
    parse(bytes);
  } catch (const InputError& error) {
    return error.diagnostics().at(0).text();
  }
  return "no fault";
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(ReadMesh, ObjFacesTakeEveryFormOfCorner) {
  const TriangleMesh mesh = parse(
      "# a tetrahedron\nmtllib a.mtl\no body\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nv 0 0 +1e0\r\n"
      "g side\nusemtl bark\ns off\nf 1 3 2\nf 1/1 2/1 4/1 # a side\nf 1//1 4//1 3//1\nf -3/1/1 \\\n -2/1/1 -1/1/1\n");
  ASSERT_EQ(mesh.positions.size(), 4U);
  EXPECT_EQ(mesh.positions[3], DVec3(0, 0, 1));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}));
  EXPECT_TRUE(closedness_errors(mesh).empty());
}

TEST(ReadMesh, PolygonsBecomeFans) {
  EXPECT_EQ(parse("f 1 2 3 4 5\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 2 0\nv -1 1 0\n").triangles,
            (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 3 0 1 2\n9 4 0 1 2 3\n";

TEST(ReadMesh, ReadsPly) {
  EXPECT_EQ(parse(kPly).triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}));
  std::string other = kPly;
  other.replace(other.find("vertex_indices"), 14, "vertex_index");
  EXPECT_EQ(parse(other).triangles.size(), 3U);
}

TEST(ReadMesh, EveryFaultHasItsPlace) {
  EXPECT_EQ(error("v 0 0\n"), "body:1:6: the vertex has fewer than three coordinates; expected v x y z");
  EXPECT_EQ(error("v 0 0 nan\n"), "body:1:7: 'nan' is not a finite number; expected a coordinate");
  EXPECT_EQ(error("v 0 0 0\nf 1 1\n"), "body:2:6: the face has fewer than three corners; expected f a b c");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 a\n"), "body:2:7: 'a' is not a vertex; expected a number from 1, or from -1 down");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 0\n"), "body:2:7: '0' is not a vertex; expected a number from 1, or from -1 down");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 -2\n"), "body:2:7: there is no vertex -2; expected at least -1");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 1\nf 1 7 2\n"), "body:3:5: there is no vertex 7; expected at most 1");
  EXPECT_EQ(error("f 1 1 99999999999\n").substr(0, 34), "body:1:7: '99999999999' is not a v");
  EXPECT_EQ(error("v 0 0 0\n"), "body: the file has no faces; expected an OBJ, PLY or GLB file with faces");
  EXPECT_THROW(parse("v 0 0 0\nf 1 1 1 1 1\n", 2), InputError);

  std::string text = kPly;
  text.replace(text.find("4 0 1 2 3"), 9, "4 0 1 2 4");
  EXPECT_EQ(error(text), "body:16: row 2 of 'face': there is no vertex 4; expected 0 to 3");
  text.replace(text.find("4 0 1 2 4"), 9, "2 0 1    ");
  EXPECT_EQ(error(text), "body:16: row 2 of 'face': the face has fewer than three corners");
  text.replace(text.find("element face"), 12, "element fase");
  EXPECT_EQ(error(text), "body: the file has no element 'face'; expected the elements 'vertex' and 'face'");
}

TEST(ReadMesh, WhatIsNoNumberOrPromisesTooMuchIsRefused) {
  EXPECT_EQ(error("v 0 -inf 0\n"), "body:1:5: '-inf' is not a finite number; expected a coordinate");
  EXPECT_EQ(error("v 0 0 1e308\n"), "body:1:7: '1e308' is out of range; expected a coordinate from -1e+12 to 1e+12");
  EXPECT_EQ(error("v 0 1e999 0\n"), "body:1:5: '1e999' is not a finite number; expected a coordinate");
  EXPECT_EQ(error("v 0 0 0\nf 1 1 1000000000\n"), "body:2:7: there is no vertex 1000000000; expected at most 1");
  std::string text = kPly;
  text.replace(text.find("1 1 0"), 5, "nan 1");
  EXPECT_EQ(error(text), "body:13: row 3 of 'vertex': a coordinate is not a finite number; expected a number");
  text.replace(text.find("nan 1"), 5, "1e13 ");
  EXPECT_EQ(error(text).substr(0, 62), "body:13: row 3 of 'vertex': the coordinate 1e+13 is out of ran");
  text = kPly;
  text.replace(text.find("element face 2"), 14, "element face 1000000000");
  EXPECT_EQ(error(text),
            "body: the header declares 1000000000 rows of 'face', but the file is cut off: 23 bytes hold at most 6; "
            "expected the whole file");
  text = kPly;
  text.replace(text.find("4 0 1 2 3"), 9, "1000000000 0");
  EXPECT_EQ(error(text),
            "body:16: row 2 of 'face': the list 'vertex_indices' has 1000000000 entries, which the file cannot hold");
}

struct BuildingFacts {
  std::size_t vertices, triangles;
  double volume;
  Vec3 size;
};

void check_building(const std::string& file, const BuildingFacts& facts) {
  const TriangleMesh house = read_mesh(file, SizeLimits{});
  EXPECT_EQ(house.positions.size(), facts.vertices);
  EXPECT_EQ(house.triangles.size(), facts.triangles);
  EXPECT_TRUE(closedness_errors(house).empty());
  const ClosedMesh closed = read_closed_mesh(file, SizeLimits{});
  EXPECT_NEAR(closed.volume(), facts.volume, 1e-5 * facts.volume);
  Box box;
  for (const DVec3 position : closed.positions()) box.add(Vec3(position));
  EXPECT_LT(glm::length(box.size() - facts.size), 0.02F);

  // The inside's share of the bounds matches the volume within three standard deviations for this number of trials.
  constexpr int kParts = 60;
  int inside = 0;
  for (int k = 0; k < kParts * kParts * kParts; ++k) {
    const Vec3 share = (Vec3(k % kParts, k / kParts % kParts, k / kParts / kParts) + 0.5F) / float{kParts};
    inside += closed.contains(DVec3(box.low + share * box.size())) ? 1 : 0;
  }
  const Vec3 size = box.size();
  EXPECT_NEAR(inside / double{kParts * kParts * kParts} * size.x * size.y * size.z, facts.volume, 0.005 * facts.volume);
}

TEST(ReadMesh, BuildingsAreClosedAndHaveTheirVolumes) {
  // The house is a box of 9 x 6 x 11 m under a gable of 3.6 m.
  const double volume = 9 * 6 * 11 + 0.5 * 9 * 3.6 * 11;
  for (const auto& [file, facts] :
       data_sets<BuildingFacts>({{"models/house.obj", {10, 16, volume, {9, 9.6F, 11}}}},
                                {{"obstacles/house.obj", {64, 124, 991.18, {13.49F, 18.69F, 9.41F}}}})) {
    SCOPED_TRACE(file);
    check_building(file, facts);
  }
}

}  // namespace meristem::read_mesh_test

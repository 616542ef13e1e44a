// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/lofts.h"

#include <gtest/gtest.h>

#include "meristem/base/math.h"
#include "meristem/base/random.h"
#include "tests/support/build_graph.h"
#include "tests/support/check_mesh.h"
#include "tests/support/test_components.h"

namespace meristem::lofts_test {

constexpr std::uint64_t kRing = 7, kRow = 8;

std::shared_ptr<const SectionOutline> outline(std::uint64_t key) {
  SectionOutline made{.key = key, .extent = 1};
  if (key == kRow) {
    made.section = {.points = {{-1, 0, 0}, {1, 0, 0}}, .is_closed = false};
  } else {
    for (int k = 0; k < 16; ++k) made.section.points.emplace_back(math::sin(kPi * k / 8), 0, math::cos(kPi * k / 8));
  }
  return std::make_shared<const SectionOutline>(std::move(made));
}

SurfaceSection section(std::uint64_t id, std::uint64_t parent, const Frame& frame, std::uint64_t key = kRing) {
  return {{.outline = outline(key), .frame = frame, .id = id, .parent = parent}};
}

Frame at(float x, float y, float scale = 1) { return {.axes = Mat3(scale), .origin = {x, y, 0}}; }

Graph two_components() {
  return GraphBuilder(test_components()).component("low", "stick").component("high", "stick").graph();
}

std::vector<SurfacePiece> joined(const std::vector<SurfaceSection>& sections) {
  const Graph graph = two_components();
  Progress progress;
  return join_sections(sections, graph, 0, progress);
}

TEST(Lofts, ChainsBecomeOneClosedMesh) {
  const auto pieces = joined({section(1, 0, at(0, 0)), section(2, 1, at(0, 1)), section(3, 2, at(0, 2, 0.5F))});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(check_mesh(*pieces[0].mesh));
  EXPECT_FALSE(pieces[0].is_open);
  const double area = 8 * math::sin(kPi / 8);
  EXPECT_NEAR(signed_volume(*pieces[0].mesh), area * (1 + (1 + 0.5 + 0.25) / 3), 1e-4);
}

TEST(Lofts, TheFirstChildContinuesAndOthersBeginFromTheSameSection) {
  const auto pieces = joined({section(1, 0, at(0, 0)), section(2, 1, at(-1, 2)), section(3, 1, at(1, 3))});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(check_mesh(*pieces[0].mesh));
  EXPECT_TRUE(check_mesh(*pieces[1].mesh, {.closed = false}));
  const auto top = [](const SurfacePiece& piece) {
    float highest = 0;
    for (const Vec3 position : piece.mesh->positions)
      highest = std::max(highest, piece.organs[0].frame.point(position).y);
    return highest;
  };
  EXPECT_NEAR(top(pieces[0]), 2, 1e-6);
  EXPECT_NEAR(top(pieces[1]), 3, 1e-6);
}

TEST(Lofts, PiecesBelongToTheComponentAtTheirUpperEndAndHideTheirSeam) {
  std::vector<SurfaceSection> sections{section(1, 0, at(0, 0)), section(2, 1, at(0, 1)), section(3, 2, at(0, 2, 0.5F))};
  sections[2].component = 1;
  const auto pieces = joined(sections);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].component, 0U);
  EXPECT_EQ(pieces[1].component, 1U);
  const auto normals_at_seam = [](const Mesh& mesh) {
    std::vector<Vec3> normals;
    for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
      if (mesh.positions[k].y == 1) normals.push_back(mesh.normals[k]);
    }
    return normals;
  };
  const auto below = normals_at_seam(*pieces[0].mesh), above = normals_at_seam(*pieces[1].mesh);
  ASSERT_EQ(below.size(), 17U);
  ASSERT_EQ(above.size(), 17U);
  for (const Vec3 normal : above) EXPECT_NE(std::find(below.begin(), below.end(), normal), below.end());
}

TEST(Lofts, TintsPartPieces) {
  std::vector<SurfaceSection> sections{section(1, 0, at(0, 0)), section(2, 1, at(0, 1)), section(3, 2, at(0, 2))};
  sections[2].tint = Vec3(0.5F);
  const auto pieces = joined(sections);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].organs[0].tint, Vec3(1));
  EXPECT_EQ(pieces[1].organs[0].tint, Vec3(0.5F));
}

TEST(Lofts, EqualChainsShareOneMeshWhereverTheyStand) {
  std::vector<SurfaceSection> sections;
  std::uint64_t id = 1;
  const RandomKey key(5);
  for (std::uint64_t chain = 0; chain < 1000; ++chain) {
    Frame frame{.axes = rotation(key.direction(2 * chain), key.uniform(3 * chain) * 6)};
    frame.axes *= static_cast<float>(0.5 + key.uniform(chain));
    frame.origin = 5.0F * key.direction(7 * chain);
    for (int k = 0; k < 6; ++k) {
      sections.push_back(section(id, k == 0 ? 0 : id - 1, frame * at(0, 0), kRow));
      ++id;
      frame = frame * Frame{.axes = 0.9F * rotation({1, 0, 0}, 0.2), .origin = {0, 1, 0}};
    }
  }
  const auto pieces = joined(sections);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].is_open);
  ASSERT_EQ(pieces[0].organs.size(), 1000U);
  // The last row's vertices stand where the sections put them.
  for (std::size_t chain = 0; chain < 1000; ++chain) {
    const Frame& last = sections[6 * chain + 5].frame;
    const Mesh& mesh = *pieces[0].mesh;
    const Vec3 tip = pieces[0].organs[chain].frame.point(mesh.positions.back());
    EXPECT_LT(glm::distance(tip, last.point({1, 0, 0})), 1e-4F);
  }
}

TEST(Lofts, ChainsThatDifferDoNotShare) {
  std::vector<SurfaceSection> sections;
  for (std::uint64_t k = 0; k < 20; ++k) {
    sections.push_back(section(2 * k + 1, 0, at(0, 0)));
    sections.push_back(section(2 * k + 2, 2 * k + 1, at(0, 1 + 0.002F * static_cast<float>(k))));
  }
  EXPECT_EQ(joined(sections).size(), 20U);
}

TEST(Lofts, ASingleRingIsADiscAndASingleRowNothing) {
  EXPECT_EQ(joined({section(1, 0, at(0, 0))}).size(), 1U);
  EXPECT_TRUE(joined({section(1, 0, at(0, 0), kRow)}).empty());
  SurfaceSection open = section(1, 0, at(0, 0));
  open.is_capped = false;
  EXPECT_TRUE(joined({open}).empty());
  EXPECT_TRUE(joined({}).empty());
}

TEST(Lofts, TheLimitOfBytesNamesTheComponent) {
  Graph graph = two_components();
  std::vector<SurfaceSection> sections{section(1, 0, at(0, 0)), section(2, 1, at(0, 1))};
  sections[1].component = 1;
  Progress progress;
  // Seen before the mesh is made, and after.
  for (const std::uint64_t limit : {1000U, 2000U}) {
    graph.limits.mesh_bytes = limit;
    const auto errors = errors_of([&] { join_sections(sections, graph, 0, progress); });
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].path, "components.high");
  }
  graph.limits.mesh_bytes = 10'000;
  EXPECT_EQ(errors_of([&] { join_sections(sections, graph, 9'500, progress); }).size(), 1U);
  graph.limits.mesh_bytes = 10'000;
  EXPECT_TRUE(errors_of([&] { join_sections(sections, graph, 0, progress); }).empty());
}

}  // namespace meristem::lofts_test

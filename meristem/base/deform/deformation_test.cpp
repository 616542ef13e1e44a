// SPDX-License-Identifier: Apache-2.0
#include "meristem/base/deform/deformation.h"

#include <cmath>
#include <limits>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "meristem/base/deform/bezier_volume.h"
#include "meristem/base/deform/polar.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "tests/support/space_maps.h"

namespace meristem::deformation_test {

using Level = Deformation::Level;

Level level(FunctionMap map, const Frame& frame = {}, DeformedPart part = DeformedPart::geometry) {
  return {std::make_shared<const FunctionMap>(std::move(map)), frame, part, "components.wind"};
}

FunctionMap bend() { return functions("x + 0.05*y^2", "y - 0.02*x*y", ""); }
FunctionMap twist() { return functions("x*cos(15*y) + z*sin(15*y)", "", "z*cos(15*y) - x*sin(15*y)"); }

Frame tilted() { return {rotation(glm::normalize(Vec3(1, 1, 0)), 0.7) * 2.0F, {1, 2, -1}}; }

Mapped mapped(const Deformation& deformation, DVec3 point) {
  DMat3 jacobian(0);
  deformation.map(std::span(&point, 1), std::span(&jacobian, 1), "leaf");
  return {point, jacobian};
}

Diagnostic error_of(const Deformation& deformation, DVec3 point) {
  try {
    mapped(deformation, point);
  } catch (const InputError& error) {
    return error.diagnostics().at(0);
  }
  ADD_FAILURE() << "no fault";
  return {};
}

/// A mesh of scattered triangles with normals and tangents.
Mesh scattered_mesh(std::size_t vertices) {
  Mesh mesh;
  const RandomKey key = RandomKey(1).child("mesh");
  for (std::size_t k = 0; k < vertices; ++k) {
    const auto number = [&](std::uint64_t i) { return static_cast<float>(key.uniform(8 * k + i)); };
    mesh.positions.emplace_back(number(0), 3 * number(1), number(2));
    mesh.normals.push_back(glm::normalize(Vec3(number(3), number(4) - 0.5F, number(5) - 0.5F)));
    mesh.tangents.emplace_back(any_perpendicular(mesh.normals.back()), 1);
  }
  return mesh;
}

TEST(Deformation, InAFrameIsTheMapThere) {
  const Frame frame = tilted();
  const Deformation deformation({level(bend(), frame)});
  const DMat3 axes(frame.axes);
  for (const DVec3& point : scattered_points()) {
    const Mapped found = mapped(deformation, point);
    const Mapped inner = mapped_by(bend(), glm::inverse(axes) * (point - DVec3(frame.origin)));
    EXPECT_LT(glm::distance(found.point, DVec3(frame.origin) + axes * inner.point), 1e-9);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT(glm::distance(found.jacobian[k], (axes * inner.jacobian * glm::inverse(axes))[k]), 1e-9);
    }
  }
}

TEST(Deformation, OfWhatStaysChangesNoBit) {
  const Deformation deformation({level(functions("x", "y + 0", "z"), tilted())});
  Mesh mesh = scattered_mesh(1000);
  const Mesh before = mesh;
  deformation.map(mesh, Vec3(0), Vec3(0), "leaf");
  EXPECT_EQ(mesh.positions, before.positions);
  EXPECT_EQ(mesh.normals, before.normals);
  EXPECT_EQ(mesh.tangents, before.tangents);
}

TEST(Deformation, TheInnerOneComesFirst) {
  const auto outer = std::make_shared<const Deformation>(std::vector{level(bend(), tilted())});
  const auto inner_one = std::make_shared<const Deformation>(std::vector{level(twist())});
  const auto both = Deformation::nested(inner_one, outer);
  EXPECT_EQ(Deformation::nested(nullptr, outer), outer);
  EXPECT_EQ(Deformation::nested(inner_one, nullptr), inner_one);
  for (const DVec3& point : scattered_points()) {
    const Mapped inner = mapped_by(twist(), point);
    const Mapped after = mapped(*outer, inner.point);
    const Mapped found = mapped(*both, point);
    EXPECT_LT(glm::distance(found.point, after.point), 1e-12);
    for (int k = 0; k < 3; ++k)
      EXPECT_LT(glm::distance(found.jacobian[k], (after.jacobian * inner.jacobian)[k]), 1e-12);
  }
}

TEST(Deformation, NormalsStayAtRightAnglesToTheSurface) {
  const Deformation deformation({level(bend()), level(twist(), tilted())});
  Mesh mesh = scattered_mesh(200);
  const Mesh before = mesh;
  deformation.map(mesh, Vec3(0), Vec3(0), "leaf");
  constexpr double kStep = 1e-5;
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
    // Two steps on the surface, from differences of mapped points.
    const Vec3 across = any_perpendicular(before.normals[k]);
    const Vec3 along = glm::cross(before.normals[k], across);
    DVec3 sides[2];
    for (int side = 0; side < 2; ++side) {
      const DVec3 step = kStep * DVec3(side == 0 ? across : along);
      const DVec3 at(before.positions[k]);
      sides[side] = (mapped(deformation, at + step).point - mapped(deformation, at - step).point) / (2 * kStep);
    }
    const DVec3 expected = glm::normalize(glm::cross(sides[0], sides[1]));
    const double side = glm::dot(glm::cross(DVec3(across), DVec3(along)), DVec3(before.normals[k])) > 0 ? 1 : -1;
    EXPECT_LT(glm::distance(DVec3(mesh.normals[k]), side * expected), 1e-5);
    EXPECT_NEAR(glm::length(Vec3(mesh.tangents[k])), 1, 1e-5);
    EXPECT_NEAR(glm::dot(Vec3(mesh.tangents[k]), mesh.normals[k]), 0, 1e-5);
  }
}

TEST(Deformation, AMeshMayCountFromAnywhere) {
  const Deformation deformation({level(bend())});
  Mesh mesh = scattered_mesh(50);
  const Mesh before = mesh;
  deformation.map(mesh, Vec3(1, 2, 3), Vec3(1, 2, 4), "leaf");
  for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
    const DVec3 expected = mapped(deformation, DVec3(1, 2, 3) + DVec3(before.positions[k])).point - DVec3(1, 2, 4);
    EXPECT_LT(glm::distance(DVec3(mesh.positions[k]), expected), 1e-6);
  }
}

TEST(Deformation, HasTheSameBytesOnAnyNumberOfThreads) {
  const Deformation deformation({level(bend()), level(twist(), tilted())});
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    Mesh mesh = scattered_mesh(40'000);
    deformation.map(mesh, Vec3(0), Vec3(0), "leaf");
    return mesh;
  };
  const Mesh one = run(1);
  for (const int threads : {2, 3, 8}) {
    const Mesh more = run(threads);
    EXPECT_EQ(one.positions, more.positions);
    EXPECT_EQ(one.normals, more.normals);
    EXPECT_EQ(one.tangents, more.tangents);
  }
}

TEST(Deformation, AxesComeBeforeGeometry) {
  const Level axes = level(bend(), {}, DeformedPart::axes);
  const Level geometry = level(twist());
  const Deformation one({axes});
  EXPECT_EQ(one.of_axes()->levels().size(), 1U);
  EXPECT_EQ(one.of_surface(), nullptr);
  const Deformation two({axes, geometry, axes});
  EXPECT_EQ(two.of_axes()->levels().size(), 1U);
  EXPECT_EQ(two.of_surface()->levels().size(), 2U);
  const Deformation three({geometry, axes});
  EXPECT_EQ(three.of_axes(), nullptr);
  EXPECT_EQ(three.of_surface()->levels().size(), 2U);
}

TEST(Deformation, WhereItEndsAllStandsRigidly) {
  const Deformation deformation({level(bend()), level(twist(), tilted())});
  const Vec3 foot(0.5F, 2, 0.25F);
  const auto rigid = deformation.rigid_at(foot, "leaf");
  const Mapped at_foot = mapped(deformation, DVec3(foot));
  const DMat3 rotation = nearest_rotation(at_foot.jacobian);
  for (const DVec3& point : scattered_points()) {
    const Mapped found = mapped(*rigid, point);
    EXPECT_LT(glm::distance(found.point, at_foot.point + rotation * (point - DVec3(foot))), 1e-12);
    for (int k = 0; k < 3; ++k) EXPECT_LT(glm::distance(found.jacobian[k], rotation[k]), 1e-14);
  }
  EXPECT_EQ(rigid->of_surface(), nullptr);
}

TEST(Deformation, MovesWithItsWorld) {
  const Deformation deformation({level(bend(), tilted())});
  const Frame to{rotation(kUp, 1) * 0.5F, {3, 0, 1}};
  const auto moved = deformation.moved_to(to);
  for (const DVec3& point : scattered_points()) {
    const DVec3 there = DVec3(to.origin) + DMat3(to.axes) * point;
    const DVec3 expected = DVec3(to.origin) + DMat3(to.axes) * mapped(deformation, point).point;
    EXPECT_LT(glm::distance(mapped(*moved, there).point, expected), 1e-5);
  }
}

TEST(Deformation, TellsWhereItFoldsSpaceOver) {
  const Deformation deformation({level(functions("x - x^2", "", ""), {.origin = {0, 1, 0}})});
  EXPECT_GT(glm::determinant(mapped(deformation, {0.49, 0, 0}).jacobian), 0);
  const Diagnostic error = error_of(deformation, {0.75, 3, 0});
  EXPECT_EQ(error.path, "components.wind");
  EXPECT_EQ(error.message,
            "the deformation folds space over where 'leaf' stands at [0.75, 3, 0] ([0.75, 2, 0] in its own frame): the "
            "determinant of its Jacobian is -0.5 there");
  // A map that presses space flat is an error as well.
  EXPECT_NE(error_of(Deformation({level(functions("", "", "0"))}), {1, 1, 1}).message.find("folds"), std::string::npos);
}

TEST(Deformation, TellsOfTheFirstFoldOnAnyNumberOfThreads) {
  const Deformation deformation({level(functions("x < 0 ? -x : x", "", ""))});
  for (const int threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    std::vector<Vec3> positions(100'000, Vec3(1));
    for (const std::size_t k : {30'000, 60'000, 90'000}) positions[k] = Vec3(-1, static_cast<float>(k), 0);
    try {
      deformation.map(positions, "trunk");
      ADD_FAILURE() << "no fault";
    } catch (const InputError& error) {
      EXPECT_NE(error.diagnostics().at(0).message.find("at [-1, 3e+04, 0]"), std::string::npos);
    }
  }
}

TEST(Deformation, TellsWhereItHasNoFiniteValue) {
  const Diagnostic error = error_of(Deformation({level(functions("x + log(y)", "", ""))}), {0, -1, 0});
  EXPECT_NE(error.message.find("no finite value where 'leaf' stands at [0, -1, 0]"), std::string::npos);
  EXPECT_EQ(error.path, "components.wind");
  // A value without a slope is an error.
  EXPECT_NE(error_of(Deformation({level(functions("x + sqrt(y)", "", ""))}), {0, 0, 0}).message.find("no finite value"),
            std::string::npos);
}

TEST(Deformation, TellsWhereItBlowsUp) {
  const Diagnostic error = error_of(Deformation({level(functions("x + exp(20*y)", "", ""))}), {0, 1, 0});
  EXPECT_NE(error.message.find("takes a point to [4.852e+08, 1, 0]"), std::string::npos) << error.message;
  EXPECT_EQ(error.expected, "points within 1e+07 m of the origin");
}

TEST(Deformation, HasANumberForAllThatItDependsOn) {
  const std::uint64_t own = Deformation({level(bend())}).hash();
  EXPECT_EQ(own, Deformation({level(bend())}).hash());
  EXPECT_NE(own, Deformation({level(twist())}).hash());
  EXPECT_NE(own, Deformation({level(bend(), tilted())}).hash());
  EXPECT_NE(own, Deformation({level(bend(), {}, DeformedPart::axes)}).hash());
  EXPECT_NE(own, Deformation({level(bend()), level(bend())}).hash());
}

}  // namespace meristem::deformation_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/plant/deform_plant.h"

#include <cmath>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "meristem/base/deform/polar.h"
#include "meristem/base/diagnostic.h"
#include "meristem/base/hash.h"
#include "meristem/base/parallel.h"
#include "meristem/plant/operation_record.h"
#include "tests/support/space_maps.h"

namespace meristem::deform_plant_test {

using Pointer = std::shared_ptr<const Deformation>;

Deformation::Level level(const FunctionMap& map, DeformedPart part) {
  return {std::make_shared<const FunctionMap>(map), Frame{}, part, "components.wind"};
}

Pointer deformation(std::vector<Deformation::Level> levels) {
  return std::make_shared<const Deformation>(std::move(levels));
}

/// Bends so strongly that an organ of half a metre is never nearly flat.
FunctionMap bend() { return functions("x + 0.3*y^2", "y - 0.2*x^2", "z + 0.1*x*y"); }
FunctionMap shear() { return functions("1.5*x + 0.2*y", "y - 0.1*x", "2*z + 1"); }

Pointer bend_on(DeformedPart part) { return deformation({level(bend(), part)}); }

/// A sheet of half a metre, with normals.
std::shared_ptr<const Mesh> sheet() {
  Mesh mesh;
  for (int y = 0; y <= 4; ++y) {
    for (int x = 0; x <= 4; ++x) {
      mesh.positions.emplace_back(0.125F * static_cast<float>(x), 0.125F * static_cast<float>(y), 0);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.tangents.emplace_back(1, 0, 0, 1);
    }
  }
  mesh.triangles.push_back({0, 1, 5});
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// Makes a plant with organs at random places.
Plant plant_with(std::size_t organs, float scale = 1) {
  Plant plant;
  plant.materials.resize(1);
  plant.prototypes.push_back({"leaf", 0, sheet()});
  const RandomKey key = RandomKey(4).child("organs");
  for (std::size_t k = 0; k < organs; ++k) {
    const auto number = [&](std::uint64_t i) { return static_cast<float>(2 * key.uniform(8 * k + i) - 1); };
    Organ& organ = plant.organs.emplace_back();
    organ.frame.axes = rotation(glm::normalize(Vec3(number(0), number(1), number(2))), number(3)) * scale;
    organ.frame.origin = Vec3(number(4), number(5) + 1, number(6));
  }
  return plant;
}

void deform_all(Plant& plant, const Pointer& by, const SizeLimits& limits = {}) {
  const DeformedOrgans row{0, plant.organs.size(), by};
  deform_organs(plant, std::span(&row, 1), 0, limits, Progress());
}

DVec3 mapped(const Pointer& by, Vec3 position) {
  DVec3 point(position);
  DMat3 jacobian(0);
  by->map(std::span(&point, 1), std::span(&jacobian, 1), "leaf");
  return point;
}

/// Returns the largest distance of an organ's vertex from its exact deformed position.
double largest_error(const Plant& before, const Plant& after, const Pointer& by) {
  double largest = 0;
  for (std::size_t k = 0; k < before.organs.size(); ++k) {
    const Organ& was = before.organs[k];
    const Organ& is = after.organs[k];
    const Mesh& old = *before.prototypes[was.prototype].mesh;
    const Mesh& mesh = *after.prototypes[is.prototype].mesh;
    for (std::size_t i = 0; i < old.vertex_count(); ++i) {
      const DVec3 expected = mapped(by, was.frame.point(old.positions[i]));
      largest = std::max(largest, glm::distance(DVec3(is.frame.point(mesh.positions[i])), expected));
    }
  }
  return largest;
}

TEST(DeformOrgans, OnAxesTurnsAndMovesThem) {
  const Plant before = plant_with(50);
  Plant plant = before;
  deform_all(plant, bend_on(DeformedPart::axes));
  EXPECT_EQ(plant.prototypes.size(), 1U);
  for (std::size_t k = 0; k < plant.organs.size(); ++k) {
    const Frame& was = before.organs[k].frame;
    const Mapped found = mapped_by(bend(), DVec3(was.origin));
    EXPECT_LT(glm::distance(DVec3(plant.organs[k].frame.origin), found.point), 1e-6);
    const DMat3 expected = nearest_rotation(found.jacobian) * DMat3(was.axes);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LT(glm::distance(DVec3(plant.organs[k].frame.axes[axis]), expected[axis]), 1e-6);
    }
  }
}

TEST(DeformOrgans, OnGeometryMovesEveryVertex) {
  const Plant before = plant_with(50);
  Plant plant = before;
  deform_all(plant, bend_on(DeformedPart::geometry));
  EXPECT_EQ(plant.prototypes.size(), 1U + 50U);
  EXPECT_LT(largest_error(before, plant, bend_on(DeformedPart::geometry)), 1e-6);
  EXPECT_EQ(plant.prototypes.back().component, "leaf");
}

TEST(DeformOrgans, OnGeometryTurnsNormalsAndTangents) {
  const Plant before = plant_with(20);
  Plant plant = before;
  const Pointer by = bend_on(DeformedPart::geometry);
  deform_all(plant, by);
  constexpr float kStep = 1e-3F;
  for (std::size_t k = 0; k < plant.organs.size(); ++k) {
    const Frame& was = before.organs[k].frame;
    const Frame& is = plant.organs[k].frame;
    const Mesh& mesh = *plant.prototypes[plant.organs[k].prototype].mesh;
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
      const Vec3 at = sheet()->positions[i];
      const auto along = [&](Vec3 step) {
        return DVec3(mapped(by, was.point(at + step)) - mapped(by, was.point(at - step)));
      };
      const DVec3 right = along({kStep, 0, 0});
      const DVec3 normal = glm::normalize(glm::cross(right, along({0, kStep, 0})));
      EXPECT_LT(glm::distance(DVec3(is.normal(mesh.normals[i])), normal), 2e-3);
      EXPECT_GT(glm::dot(glm::normalize(DVec3(is.vector(Vec3(mesh.tangents[i])))), glm::normalize(right)), 0.999);
    }
  }
}

TEST(DeformOrgans, UnderAnAffineMapShareTheirPrototype) {
  const Plant before = plant_with(50);
  Plant plant = before;
  const Pointer by = deformation({level(shear(), DeformedPart::geometry)});
  deform_all(plant, by);
  EXPECT_EQ(plant.prototypes.size(), 1U);
  EXPECT_LT(largest_error(before, plant, by), 1e-6);
}

TEST(DeformOrgans, ThatAreSmallShareTheirPrototypeWithinTheTolerance) {
  const float scale = 0.01F;
  const Plant before = plant_with(200, scale);
  Plant plant = before;
  const Pointer by = bend_on(DeformedPart::geometry);
  deform_all(plant, by);
  EXPECT_EQ(plant.prototypes.size(), 1U);
  const double error = largest_error(before, plant, by);
  EXPECT_GT(error, 0);
  EXPECT_LT(error, kAffineTolerance * scale);
}

TEST(DeformOrgans, ThatStayKeepEveryBit) {
  const Plant before = plant_with(20);
  for (const DeformedPart part : {DeformedPart::axes, DeformedPart::geometry}) {
    Plant plant = before;
    deform_all(plant, deformation({level(functions("x", "y", "z"), part)}));
    EXPECT_EQ(plant.prototypes.size(), 1U);
    for (std::size_t k = 0; k < plant.organs.size(); ++k) {
      EXPECT_EQ(plant.organs[k].frame.axes, before.organs[k].frame.axes);
      EXPECT_EQ(plant.organs[k].frame.origin, before.organs[k].frame.origin);
    }
  }
}

TEST(DeformOrgans, UnderAxesWithinGeometryKeepTheirFormAndAreThenDeformed) {
  const Plant before = plant_with(30);
  Plant inner = before, both = before;
  deform_all(inner, bend_on(DeformedPart::axes));
  const Pointer outer = deformation({level(shear(), DeformedPart::geometry)});
  deform_all(both, deformation({level(bend(), DeformedPart::axes), level(shear(), DeformedPart::geometry)}));
  EXPECT_LT(largest_error(inner, both, outer), 1e-5);
}

TEST(DeformOrgans, UnderGeometryWithinAxesAreDeformedAndThenKeepThatForm) {
  const Plant before = plant_with(30);
  Plant inner = before, both = before;
  deform_all(inner, bend_on(DeformedPart::geometry));
  const FunctionMap turn = functions("z + 1", "y", "-x");
  deform_all(both, deformation({level(bend(), DeformedPart::geometry), level(turn, DeformedPart::axes)}));
  EXPECT_LT(largest_error(inner, both, deformation({level(turn, DeformedPart::axes)})), 1e-5);
}

TEST(DeformOrgans, HaveTheSameBytesOnAnyNumberOfThreads) {
  const auto run = [](int threads) {
    const ThreadLimit limit(threads);
    Plant plant = plant_with(3000);
    for (std::size_t k = 0; k < plant.organs.size(); k += 2) plant.organs[k].frame.axes *= 0.01F;
    deform_all(plant, bend_on(DeformedPart::geometry));
    std::string bytes;
    for (const Organ& organ : plant.organs) {
      bytes.append(reinterpret_cast<const char*>(&organ.frame), sizeof(Frame));
      bytes.append(reinterpret_cast<const char*>(&organ.prototype), sizeof(organ.prototype));
      const Mesh& mesh = *plant.prototypes[organ.prototype].mesh;
      bytes.append(reinterpret_cast<const char*>(mesh.positions.data()), mesh.positions.size() * sizeof(Vec3));
      bytes.append(reinterpret_cast<const char*>(mesh.normals.data()), mesh.normals.size() * sizeof(Vec3));
    }
    EXPECT_EQ(plant.prototypes.size(), 1U + 1500U);
    return hash64(bytes);
  };
  const std::uint64_t one = run(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(run(threads), one) << threads;
}

TEST(DeformOrgans, StopAtTheLimitOfBytes) {
  Plant plant = plant_with(1000);
  SizeLimits limits;
  limits.mesh_bytes = 100'000;
  try {
    deform_all(plant, bend_on(DeformedPart::geometry), limits);
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).path, "components.leaf");
    EXPECT_NE(error.diagnostics().at(0).message.find("bytes of deformed shapes"), std::string::npos);
  }
}

/// A straight stem along y with a branch along x that belongs to another part.
Stem fork() {
  Stem stem;
  stem.parts.resize(2);
  stem.parts[0].component = "trunk";
  stem.parts[1].component = "branch";
  stem.part_of_axis = {0, 1};
  for (NodeIndex k = 0; k < 4; ++k) stem.skeleton.add_node(k == 0 ? kNoNode : k - 1, {0, static_cast<float>(k), 0}, 0);
  for (NodeIndex k = 0; k < 3; ++k) stem.skeleton.add_node(k == 0 ? 2 : k + 3, {1 + static_cast<float>(k), 2, 0}, 0);
  for (NodeIndex k = 4; k < 7; ++k) stem.skeleton.axis[k] = stem.skeleton.order[k] = 1;
  stem.skeleton.radius.assign(7, 0.1F);
  return stem;
}

TEST(DeformStem, OnAxesMovesItsNodesAndKeepsItsThickness) {
  const Stem before = fork();
  Stem stem = before;
  const Pointer by = bend_on(DeformedPart::axes);
  deform(stem, std::vector(2, by));
  EXPECT_EQ(stem.undeformed, nullptr);
  EXPECT_EQ(stem.skeleton.radius, before.skeleton.radius);
  EXPECT_EQ(stem.parts[0].deformation, nullptr);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_LT(glm::distance(DVec3(stem.skeleton.position[k]), mapped(by, before.skeleton.position[k])), 1e-6);
  }
}

TEST(DeformStem, OnGeometryLeavesWhatItsSurfaceIsMadeOf) {
  const Stem before = fork();
  Stem stem = before;
  const Pointer by = bend_on(DeformedPart::geometry);
  deform(stem, std::vector(2, by));
  ASSERT_NE(stem.undeformed, nullptr);
  EXPECT_EQ(skeleton_hash(*stem.undeformed), skeleton_hash(before.skeleton));
  ASSERT_NE(stem.parts[1].deformation, nullptr);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_LT(glm::distance(DVec3(stem.skeleton.position[k]), mapped(by, before.skeleton.position[k])), 1e-6);
  }
}

TEST(DeformStem, OnGeometryStretchesItsRadiiAcross) {
  Stem stem = fork();
  deform(stem, std::vector(2, deformation({level(functions("2*x", "2*y", "2*z"), DeformedPart::geometry)})));
  for (const float radius : stem.skeleton.radius) EXPECT_FLOAT_EQ(radius, 0.2F);
  Stem wide = fork();
  deform(wide, std::vector(2, deformation({level(functions("4*x", "", ""), DeformedPart::geometry)})));
  EXPECT_FLOAT_EQ(wide.skeleton.radius[1], 0.2F);  // four times the area is twice the radius
  EXPECT_FLOAT_EQ(wide.skeleton.radius[0], 0.2F);
  EXPECT_FLOAT_EQ(wide.skeleton.radius[5], 0.1F);  // the branch lies along x
}

TEST(DeformStem, EachPartHasItsOwn) {
  const Stem before = fork();
  Stem stem = before;
  deform(stem, std::vector<Pointer>{nullptr, bend_on(DeformedPart::geometry)});
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(stem.skeleton.position[k], before.skeleton.position[k]);
  for (std::size_t k = 4; k < 7; ++k) EXPECT_NE(stem.skeleton.position[k], before.skeleton.position[k]);
  EXPECT_EQ(stem.parts[0].deformation, nullptr);
  EXPECT_NE(stem.parts[1].deformation, nullptr);
}

TEST(DeformStem, MovesWhatWasDoneToEachPart) {
  Stem stem = fork();
  for (const std::uint32_t part : {0U, 1U}) {
    stem.skeleton.operations.add({.position = {1, 2, 0}, .bud = {0, 0, -1}, .part = part});
  }
  const Pointer by = deformation({level(functions("x + 1", "y", "x + 2*z"), DeformedPart::geometry)});
  deform(stem, std::vector<Pointer>{nullptr, by});
  EXPECT_EQ(stem.skeleton.operations[0].position, Vec3(1, 2, 0));
  EXPECT_EQ(stem.skeleton.operations[1].position, Vec3(2, 2, 1));
  EXPECT_EQ(stem.skeleton.operations[1].bud, Vec3(0, 0, -1));
}

TEST(DeformStem, ASecondTimeActsOnWhatItsSurfaceWillBe) {
  Stem stem = fork();
  const Pointer first = bend_on(DeformedPart::geometry), second = deformation({level(shear(), DeformedPart::axes)});
  const Stem before = stem;
  deform(stem, std::vector(2, first));
  deform(stem, std::vector(2, second));
  EXPECT_EQ(skeleton_hash(*stem.undeformed), skeleton_hash(before.skeleton));
  for (std::size_t k = 0; k < 7; ++k) {
    const DVec3 own = mapped(stem.parts[0].deformation, before.skeleton.position[k]);
    EXPECT_LT(glm::distance(DVec3(stem.skeleton.position[k]), own), 1e-5);
  }
}

TEST(DeformStem, ThatFoldsIsToldByItsPart) {
  Stem stem = fork();
  try {
    deform(stem, std::vector(2, deformation({level(functions("x - x^2", "", ""), DeformedPart::axes)})));
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).path, "components.wind");
    EXPECT_NE(error.diagnostics().at(0).message.find("folds space over where 'branch' stands"), std::string::npos)
        << error.what();
  }
}

}  // namespace meristem::deform_plant_test

// SPDX-License-Identifier: Apache-2.0
#include "meristem/measure/scan/scan.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/parallel.h"
#include "meristem/measure/scan/beam.h"
#include "meristem/plant/plant_variant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/assembly/ray_meshes.h"
#include "meristem/shape/solid/primitives.h"
#include "tests/support/sample_plants.h"

namespace meristem::scan_test {

/// Adds an organ of its own prototype.
void add_organ(Plant& plant, const std::string& component, Mesh mesh, Vec3 position) {
  if (plant.materials.empty()) plant.materials.emplace_back();
  const auto prototype = static_cast<std::uint32_t>(plant.prototypes.size());
  plant.prototypes.push_back({component, 0, std::make_shared<const Mesh>(std::move(mesh))});
  plant.organs.push_back({.frame = {.origin = position}, .prototype = prototype});
}

/// Returns a camera without noise whose beams have no width.
ScanInstrument plain_camera(double field_deg, int columns, int rows) {
  ScanInstrument camera = instrument_of(ScannerClass::depth_camera);
  camera.field = radians(field_deg);
  camera.columns = columns;
  camera.rows = rows;
  camera.rays = 1;
  camera.noise = camera.noise_growth = camera.threshold = 0;
  camera.nearest = 0.01;
  camera.farthest = 100;
  return camera;
}

Scan scan_of(const Plant& plant, const ScanOptions& options) {
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  return scan(plant, {}, meshes, options, progress);
}

/// Returns the distance along a ray to a sphere, a standing cylinder or a standing cone, or infinity if the ray misses.
double to_sphere(DVec3 from, DVec3 way, DVec3 centre, double radius) {
  const DVec3 offset = from - centre;
  const double b = glm::dot(offset, way);
  const double root = b * b - glm::dot(offset, offset) + radius * radius;
  return root < 0 ? INFINITY : -b - std::sqrt(root);
}

double to_cone(DVec3 from, DVec3 way, DVec3 base, double radius, double top_radius, double height) {
  const DVec3 at = from - base;
  const double slope = (top_radius - radius) / height;
  const double a = way.x * way.x + way.z * way.z - slope * slope * way.y * way.y;
  const double edge = radius + slope * at.y;
  const double b = at.x * way.x + at.z * way.z - slope * edge * way.y;
  const double c = at.x * at.x + at.z * at.z - edge * edge;
  const double root = b * b - a * c;
  if (root < 0) return INFINITY;
  const double distance = (-b - std::sqrt(root)) / a;
  const double y = at.y + distance * way.y;
  return y > 0 && y < height ? distance : INFINITY;
}

TEST(Scan, MeetsBallsCylindersAndConesWhereTheyAre) {
  Plant plant;
  add_organ(plant, "ball", make_sphere(0.12, 480), {-0.4F, 1, 0});
  add_organ(plant, "rod", make_cylinder(0.1, 0.4, 480), {0, 0.8F, 0});
  add_organ(plant, "cone", make_cone(0.1, 0.4, 480), {0.4F, 0.8F, 0});
  const Vec3 station(0.1F, 1, 3);
  const Scan made =
      scan_of(plant, {.instrument = plain_camera(30, 90, 40), .stations = {station}, .target = Vec3(0, 1, 0)});
  std::size_t seen[3] = {};
  for (const ScanPoint& point : made.points) {
    const DVec3 way = glm::normalize(DVec3(point.position) - DVec3(station));
    const double distances[3] = {to_sphere(station, way, {-0.4, 1, 0}, 0.12),
                                 to_cone(station, way, {0, 0.8, 0}, 0.1, 0.1, 0.4),
                                 to_cone(station, way, {0.4, 0.8, 0}, 0.1, 0, 0.4)};
    // The bodies are polygons. A ray at a small angle to a surface meets the flat sides later than the round body, and
    // rays at the rim meet the caps.
    const double distance = distances[point.label.component];
    if (!std::isfinite(distance) || point.intensity < 0.6F) continue;
    ++seen[point.label.component];
    EXPECT_NEAR(point.true_range, distance, 1e-5) << made.components[point.label.component];
    EXPECT_EQ(point.range, point.true_range);
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 50U);
}

TEST(Scan, RaysOfABeamHaveItsMeanSquareDistance) {
  EXPECT_EQ(beam_offsets(1), std::vector<Vec2>{Vec2(0)});
  for (const int rays : {2, 7, 19, 100}) {
    double sum = 0;
    for (const Vec2 offset : beam_offsets(rays)) sum += glm::dot(offset, offset);
    EXPECT_NEAR(sum / rays, 0.5, 1e-6) << rays;
  }
}

/// Moves a beam across the edge of a plate 10 m away. The beam's profile is the change of the plate's reflection from
/// position to position.
TEST(Scan, FootprintsAreAsWideAsTheBeam) {
  Plant plant;
  add_organ(plant, "plate", make_box({1, 4, 0.1F}), {-0.5F, -2, -0.05F});
  ScanInstrument scanner = plain_camera(0.4, 140, 250);
  scanner.divergence = 0.35;
  scanner.exit_diameter = 0.007;
  scanner.rays = 19;
  const Scan made = scan_of(plant, {.instrument = scanner, .stations = {Vec3(0, 0, 10)}, .target = Vec3(0)});
  std::vector<double> share(140, 0);
  for (const ScanPoint& point : made.points) share[point.pulse % 140] += point.intensity / 250;
  EXPECT_NEAR(share.front(), 1, 1e-3);
  EXPECT_EQ(share.back(), 0);
  const double pixel = 2 * 10 * std::tan(radians(0.2)) / 140;
  double mean = 0;
  double square = 0;
  for (int k = 0; k + 1 < 140; ++k) {
    const double place = pixel * (k - 69);
    mean += (share[k] - share[k + 1]) * place;
    square += (share[k] - share[k + 1]) * place * place;
  }
  const double across = 4 * std::sqrt(square - mean * mean);
  EXPECT_NEAR(across, scanner.footprint(10), 0.01 * scanner.footprint(10));
  EXPECT_NEAR(scanner.footprint(10), 0.0105, 1e-9);
}

/// Returns a plate and, 3 m behind it, a wall. The scanner sees both across the plate's edge.
Plant plate_before_wall() {
  Plant plant;
  add_organ(plant, "plate", make_box({1, 4, 0.1F}), {-0.5F, -2, -0.05F});
  add_organ(plant, "wall", make_box({40, 40, 0.1F}), {0, -20, -3.05F});
  return plant;
}

TEST(Scan, EdgesGiveTwoReturnsOrOneBetweenTheSurfaces) {
  const Plant plant = plate_before_wall();
  ScanInstrument scanner = plain_camera(0.2, 60, 1);
  scanner.divergence = 0.35;
  scanner.rays = 19;
  scanner.resolution = 0.8;
  scanner.returns = 4;
  ScanOptions options{.instrument = scanner, .stations = {Vec3(0, 0, 10)}, .target = Vec3(0)};
  std::size_t pairs = 0;
  for (const ScanPoint& point : scan_of(plant, options).points) {
    const bool is_plate = point.label.component == 0;
    EXPECT_NEAR(point.true_range, is_plate ? 10 : 13, 1e-3);
    EXPECT_LE(point.number, point.count);
    if (point.count == 2) {
      EXPECT_EQ(point.number, is_plate ? 1 : 2);
    }
    if (point.count == 2 && is_plate) ++pairs;
  }
  EXPECT_GT(pairs, 4U);

  options.instrument.resolution = 100;
  std::size_t between = 0;
  for (const ScanPoint& point : scan_of(plant, options).points) {
    EXPECT_EQ(point.count, 1);
    if (point.range > 10.1F && point.range < 12.9F) ++between;
  }
  EXPECT_GT(between, 4U);
  options.instrument.resolution = 0.8;
  options.instrument.threshold = 0.6;
  for (const ScanPoint& point : scan_of(plant, options).points) EXPECT_EQ(point.count, 1);
}

TEST(Scan, NoiseHasTheDeviationOfTheInstrument) {
  Plant plant;
  add_organ(plant, "wall", make_box({40, 40, 0.1F}), {0, -20, -0.05F});
  ScanInstrument scanner = plain_camera(20, 60, 60);
  scanner.noise = 0.004;
  scanner.noise_growth = 0.00006;
  const Scan made = scan_of(plant, {.instrument = scanner, .stations = {Vec3(0, 0, 10)}, .target = Vec3(0)});
  ASSERT_EQ(made.points.size(), 3600U);
  double sum = 0;
  double square = 0;
  for (const ScanPoint& point : made.points) {
    const double deviation = 0.004 + 0.00006 * point.true_range * point.true_range;
    const double error = (point.range - point.true_range) / deviation;
    sum += error;
    square += error * error;
  }
  // Four standard errors of a mean and of a variance.
  EXPECT_NEAR(sum / 3600, 0, 4.0 / 60);
  EXPECT_NEAR(square / 3600, 1, 4 * std::sqrt(2.0 / 3600));
}

/// Returns the first triangle that a ray meets, by testing all triangles of all instances.
SurfaceLabel label_by_all(const MeshScene& scene, const SurfaceLabels& labels, DVec3 from, DVec3 way) {
  double best = INFINITY;
  SurfaceLabel label;
  for (std::uint32_t p = 0; p < scene.meshes.size(); ++p) {
    const MeshInstances& part = scene.meshes[p];
    for (std::uint32_t i = 0; i < part.count(); ++i) {
      const Frame frame = part.frame(i);
      for (std::uint32_t t = 0; t < part.mesh->triangle_count(); ++t) {
        const auto [ia, ib, ic] = part.mesh->triangles[t];
        const DVec3 a = frame.point(part.mesh->positions[ia]);
        const DVec3 b = DVec3(frame.point(part.mesh->positions[ib])) - a;
        const DVec3 c = DVec3(frame.point(part.mesh->positions[ic])) - a;
        const DVec3 q = glm::cross(way, c);
        const double determinant = glm::dot(b, q);
        if (determinant == 0) continue;
        const DVec3 offset = from - a;
        const double u = glm::dot(offset, q) / determinant;
        const DVec3 r = glm::cross(offset, b);
        const double v = glm::dot(way, r) / determinant;
        const double distance = glm::dot(c, r) / determinant;
        if (u < 0 || v < 0 || u + v > 1 || distance <= 0 || distance >= best) continue;
        best = distance;
        label = labels.of(p, i, t, Vec3(from + distance * way));
      }
    }
  }
  return label;
}

TEST(Scan, LabelsAreThoseOfTheFirstTriangleOfAll) {
  Plant plant = two_stems();
  plant.materials.emplace_back();
  add_organ(plant, "leaf", make_box({0.2F, 0.3F, 0.01F}), {0.4F, 1.4F, 0});
  add_organ(plant, "leaf", make_box({0.2F, 0.3F, 0.01F}), {3, 0.2F, 0});
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const SurfaceLabels labels(plant, {}, meshes, progress);
  const Scan made = scan(
      plant, {}, meshes,
      {.instrument = plain_camera(60, 90, 70), .stations = {Vec3(1.5F, 1, 4)}, .target = Vec3(1.5F, 1, 0)}, progress);
  ASSERT_GT(made.points.size(), 100U);
  std::size_t differ = 0;
  for (const ScanPoint& point : made.points) {
    const DVec3 from(1.5, 1, 4);
    if (label_by_all(meshes, labels, from, glm::normalize(DVec3(point.position) - from)) != point.label) ++differ;
  }
  EXPECT_EQ(differ, 0U);
  EXPECT_EQ(made.shoots, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(made.shoot_labels, (std::vector<std::string>{"main", "main.1", "main"}));
}

bool are_equal(const ScanPoint& a, const ScanPoint& b) {
  return a.position == b.position && a.range == b.range && a.label == b.label && a.pulse == b.pulse &&
         a.intensity == b.intensity && a.number == b.number;
}

TEST(Scan, IsTheSameOnAnyNumberOfThreads) {
  Plant plant = two_stems();
  plant.materials.emplace_back();
  ScanInstrument scanner = instrument_of(ScannerClass::terrestrial);
  scanner.step = radians(1.5);
  scanner.rays = 7;
  const ScanOptions options{.instrument = scanner, .around = 2, .ground = true, .seed = 3};
  const Scan one = [&] {
    const ThreadLimit limit(1);
    return scan_of(plant, options);
  }();
  ASSERT_GT(one.points.size(), 1000U);
  const ThreadLimit limit(3);
  const Scan three = scan_of(plant, options);
  EXPECT_TRUE(std::ranges::equal(one.points, three.points, are_equal));
  EXPECT_EQ(one.stations.size(), 2U);
  const auto is_ground = [](const ScanPoint& point) { return point.label.kind == SurfaceKind::ground; };
  const auto on_ground = std::ranges::find_if(one.points, is_ground);
  ASSERT_NE(on_ground, one.points.end());
  EXPECT_NEAR(on_ground->position.y, 0, 0.05);
  EXPECT_EQ(one.components[on_ground->label.component], "ground");
}

TEST(Scan, DronesFlyLinesOverThePlants) {
  Plant plant;
  add_organ(plant, "table", make_box({8, 1, 4}), {0, 0, 0});
  ScanInstrument drone = instrument_of(ScannerClass::drone);
  drone.step = radians(1);
  drone.advance = 0.5;
  drone.line_spacing = 4;
  drone.altitude = 30;
  drone.noise = 0;
  const Scan made = scan_of(plant, {.instrument = drone});
  ASSERT_GT(made.points.size(), 20U);
  ASSERT_EQ(made.stations.size(), 3U);
  EXPECT_EQ(made.stations[0].x, -4);
  for (const ScanPoint& point : made.points) {
    EXPECT_LT(point.position.y, 1.01F);
    EXPECT_GT(point.true_range, 28.9F);
  }
  drone.altitude = 0.9;
  EXPECT_THROW(scan_of(plant, {.instrument = drone}), InputError);
}

TEST(Scan, OfNothingHasNoPoints) {
  ScanInstrument scanner = instrument_of(ScannerClass::terrestrial);
  scanner.step = radians(5);
  EXPECT_TRUE(scan_of({}, {.instrument = scanner}).points.empty());
}

TEST(Scan, RefusesTooManyPulsesBeforeItPreparesAnything) {
  Plant plant;
  add_organ(plant, "wall", make_box({4, 4, 0.1F}), {0, 0, 0});
  Progress growing;
  const MeshScene meshes = make_mesh_scene(plant, {}, growing);
  ScanInstrument scanner = instrument_of(ScannerClass::terrestrial);
  scanner.step = radians(0.002);
  Progress stopped;
  stopped.cancel();  // ends all preparations
  EXPECT_THROW(Scanner(plant, {}, meshes, {.instrument = scanner}, stopped), InputError);
}

TEST(Scan, StopsWhenItIsCancelledAndAtTheMostPoints) {
  Plant plant;
  add_organ(plant, "wall", make_box({4, 4, 0.1F}), {0, 0, 0});
  Progress growing;
  const MeshScene meshes = make_mesh_scene(plant, {}, growing);
  const ScanOptions options{.instrument = plain_camera(20, 30, 30), .stations = {Vec3(0, 1, 5)}, .target = Vec3(0)};
  Progress stopped;
  const Scanner scanner(plant, {}, meshes, options, growing);
  stopped.cancel();
  EXPECT_THROW(scanner.run([](std::span<const ScanPoint>) {}, stopped), Cancelled);
  Progress progress;
  EXPECT_THROW(scan(plant, {}, meshes, options, progress, 10), InputError);
}

TEST(Scan, NeedsNeitherThePlantNorWhatOnlyPicturesShow) {
  Plant leafy = two_stems();
  leafy.materials.emplace_back();
  add_organ(leafy, "ball", make_sphere(0.12, 60), {0.3F, 1, 0});
  leafy.organs.back().tint = Vec3(0.5F);
  const auto tree = std::make_shared<PlantVariant>();
  tree->plant = std::make_shared<const Plant>(leafy);
  Plant plant;
  plant.plantings.push_back(
      {.component = "tree", .variant = tree, .places = {{{.origin = {9, 0, 0}}, 0}, {{.origin = {18, 0, 0}}, 1}}});
  const ScanOptions options{.instrument = plain_camera(40, 200, 200), .stations = {Vec3(13, 1, 12)}};
  const Scan wanted = scan_of(plant, options);
  Progress progress;
  PlantLabels labels(plant, {}, progress);
  const MeshScene meshes = make_ray_meshes(std::move(plant), {}, progress);
  for (const MeshInstances& part : meshes.meshes) EXPECT_TRUE(part.tints.empty());
  const Scanner scanner(std::move(labels), meshes, options, progress);
  const Scan made = take_scan(scanner, progress);
  ASSERT_GT(wanted.points.size(), 100U);
  EXPECT_TRUE(std::ranges::equal(made.points, wanted.points, are_equal));
  EXPECT_EQ(made.shoot_labels, wanted.shoot_labels);
}

}  // namespace meristem::scan_test

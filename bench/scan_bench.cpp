// SPDX-License-Identifier: Apache-2.0
// Scans of shipped models. Counters:
// - pulses that could meet the plant, per second, of 19 rays each on two threads;
// - points whose labels differ from the labels of the first triangle, found by testing all triangles;
// - the largest distance in metres between points on fine meshes of a ball, a cylinder and a cone and their closed
//   forms;
// - the difference between the footprint of a beam, moved across the edge of a plate, and the instrument's footprint;
// - the memory of a stand of different trees from growth to the last point: the peak of the process, and the memory
//   that rays need.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/grow.h"
#include "meristem/measure/foliage.h"
#include "meristem/measure/scan/scan.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/solid/primitives.h"

namespace {

using namespace meristem;
using meristem::bench::sized;

const int kPixels = sized(500, 20);
const std::size_t kBrutePoints = sized<std::size_t>(100'000, 100);

GrownDocument grown_model(const std::string& model) {
  const std::string file = std::string(MERISTEM_SOURCE_DIR) + "/models/" + model + ".json";
  const Document document = read_document(read_text_file(file), file, builtin_components());
  Progress progress;
  return grow_document(document, progress, {.up_to = GrownPart::textures});
}

/// A camera whose picture the plant fills, with the beams of a terrestrial scanner: all pulses look at the plant.
ScanInstrument close_scanner(int columns, int rows) {
  ScanInstrument scanner = instrument_of(ScannerClass::depth_camera);
  const ScanInstrument beam = instrument_of(ScannerClass::terrestrial);
  scanner.columns = columns;
  scanner.rows = rows;
  scanner.field = radians(20);
  scanner.divergence = beam.divergence;
  scanner.exit_diameter = beam.exit_diameter;
  scanner.rays = beam.rays;
  scanner.returns = beam.returns;
  scanner.resolution = beam.resolution;
  scanner.noise = beam.noise;
  scanner.noise_growth = 0;
  scanner.nearest = 0;
  scanner.farthest = 350;
  return scanner;
}

void pulses(benchmark::State& state, const std::string& model) {
  const ThreadLimit threads(2);
  const GrownDocument grown = grown_model(model);
  const Box box = grown.meshes.bounds();
  Progress progress;
  const ScanOptions options{.instrument = close_scanner(kPixels, kPixels),
                            .stations = {box.centre() + Vec3(0, 0, 1.5F * box.size().y + box.size().z)}};
  const Scanner scanner(grown.plant, {}, grown.meshes, options, progress);
  std::uint64_t points = 0;
  double seconds = 1e9;
  for (auto _ : state) {
    points = 0;
    const auto begin = std::chrono::steady_clock::now();
    scanner.run([&](std::span<const ScanPoint> some) { points += some.size(); }, progress);
    seconds = std::min(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  state.counters["pulses_per_s"] = static_cast<double>(scanner.pulse_count()) / seconds;
  state.counters["points_per_pulse"] = static_cast<double>(points) / static_cast<double>(scanner.pulse_count());
  state.SetLabel(model);
}
BENCHMARK_CAPTURE(pulses, oak, "oak")->Unit(benchmark::kMillisecond)->Iterations(sized(3, 1))->UseRealTime();
BENCHMARK_CAPTURE(pulses, low_poly_oak, "low-poly-oak")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(sized(3, 1))
    ->UseRealTime();

/// A triangle in the world, with the numbers that identify its label.
struct BenchTriangle {
  DVec3 a, to_b, to_c;
  std::uint32_t part, instance, triangle;
};

std::vector<BenchTriangle> triangles_of(const MeshScene& scene) {
  std::vector<BenchTriangle> triangles;
  for (std::uint32_t p = 0; p < scene.meshes.size(); ++p) {
    const MeshInstances& part = scene.meshes[p];
    for (std::uint32_t i = 0; i < part.count(); ++i) {
      const Frame frame = part.frame(i);
      for (std::uint32_t t = 0; t < part.mesh->triangle_count(); ++t) {
        const auto [ia, ib, ic] = part.mesh->triangles[t];
        const DVec3 a = frame.point(part.mesh->positions[ia]);
        triangles.push_back({a, DVec3(frame.point(part.mesh->positions[ib])) - a,
                             DVec3(frame.point(part.mesh->positions[ic])) - a, p, i, t});
      }
    }
  }
  return triangles;
}

double distance_to(const BenchTriangle& triangle, DVec3 from, DVec3 way) {
  const DVec3 q = glm::cross(way, triangle.to_c);
  const double determinant = glm::dot(triangle.to_b, q);
  if (determinant == 0) return INFINITY;
  const DVec3 offset = from - triangle.a;
  const double u = glm::dot(offset, q) / determinant;
  const DVec3 r = glm::cross(offset, triangle.to_b);
  const double v = glm::dot(way, r) / determinant;
  const double distance = glm::dot(triangle.to_c, r) / determinant;
  return u < 0 || v < 0 || u + v > 1 || distance <= 0 ? INFINITY : distance;
}

/// Compares the labels of rays without width with the labels of the first of all triangles. If two triangles with
/// different labels lie at equal distance to a micrometre, both are right.
void labels(benchmark::State& state) {
  const GrownDocument grown = grown_model("low-poly-oak");
  Progress progress;
  const Box box = grown.meshes.bounds();
  ScanInstrument scanner = close_scanner(sized(620, 20), sized(620, 20));
  scanner.rays = 1;
  scanner.noise = 0;
  scanner.field = radians(40);
  const Vec3 station = box.centre() + Vec3(0, 0, 1.5F * box.size().y);
  const Scanner ready(grown.plant, {}, grown.meshes, {.instrument = scanner, .stations = {station}}, progress);
  const std::vector<BenchTriangle> triangles = triangles_of(grown.meshes);
  std::size_t asked = 0;
  std::atomic<std::size_t> differ{0};
  for (auto _ : state) {
    Scan scan = take_scan(ready, progress);
    asked = std::min(kBrutePoints, scan.points.size());
    differ = 0;
    parallel_for(asked, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const ScanPoint& point = scan.points[k];
        const DVec3 way = glm::normalize(DVec3(point.position) - DVec3(station));
        double best = INFINITY;
        for (const BenchTriangle& triangle : triangles) best = std::min(best, distance_to(triangle, station, way));
        bool is_known = false;
        for (const BenchTriangle& triangle : triangles) {
          if (distance_to(triangle, station, way) > best + 1e-6) continue;
          is_known = is_known || ready.labels().of(triangle.part, triangle.instance, triangle.triangle,
                                                   point.position) == point.label;
        }
        if (!is_known) ++differ;
      }
    });
  }
  state.counters["points"] = static_cast<double>(asked);
  state.counters["differ"] = static_cast<double>(differ);
}
BENCHMARK(labels)->Unit(benchmark::kMillisecond)->Iterations(1);

void add_organ(Plant& plant, Mesh mesh, Vec3 position) {
  if (plant.materials.empty()) plant.materials.emplace_back();
  const auto prototype = static_cast<std::uint32_t>(plant.prototypes.size());
  plant.prototypes.push_back({std::to_string(prototype), 0, std::make_shared<const Mesh>(std::move(mesh))});
  plant.organs.push_back({.frame = {.origin = position}, .prototype = prototype});
}

ScanInstrument ray_camera(double field_deg, int columns, int rows) {
  ScanInstrument camera = close_scanner(columns, rows);
  camera.field = radians(field_deg);
  camera.rays = 1;
  camera.noise = camera.threshold = 0;
  return camera;
}

/// Measures distances to a ball, and to a cone or cylinder on a base.
double to_ball(DVec3 from, DVec3 way, DVec3 centre, double radius) {
  const DVec3 offset = from - centre;
  const double b = glm::dot(offset, way);
  return -b - std::sqrt(b * b - glm::dot(offset, offset) + radius * radius);
}
double to_cone(DVec3 from, DVec3 way, DVec3 base, double radius, double top, double height) {
  const DVec3 at = from - base;
  const double slope = (top - radius) / height;
  const double edge = radius + slope * at.y;
  const double a = way.x * way.x + way.z * way.z - slope * slope * way.y * way.y;
  const double b = at.x * way.x + at.z * way.z - slope * edge * way.y;
  const double c = at.x * at.x + at.z * at.z - edge * edge;
  const double distance = (-b - std::sqrt(b * b - a * c)) / a;
  const double y = at.y + distance * way.y;
  return y > 0 && y < height ? distance : NAN;
}

void closed_forms(benchmark::State& state) {
  Plant plant;
  add_organ(plant, make_sphere(0.12, 1024), {-0.4F, 1, 0});
  add_organ(plant, make_cylinder(0.1, 0.4, 1024), {0, 0.8F, 0});
  add_organ(plant, make_cone(0.1, 0.4, 1024), {0.4F, 0.8F, 0});
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const Vec3 station(0.1F, 1, 3);
  double worst = 0;
  for (auto _ : state) {
    worst = 0;
    const Scan made = scan(
        plant, {}, meshes,
        {.instrument = ray_camera(30, sized(600, 60), sized(300, 30)), .stations = {station}, .target = Vec3(0, 1, 0)},
        progress);
    for (const ScanPoint& point : made.points) {
      const DVec3 way = glm::normalize(DVec3(point.position) - DVec3(station));
      const std::uint32_t body = point.label.component;
      const double distance = body == 0   ? to_ball(station, way, {-0.4, 1, 0}, 0.12)
                              : body == 1 ? to_cone(station, way, {0, 0.8, 0}, 0.1, 0.1, 0.4)
                                          : to_cone(station, way, {0.4, 0.8, 0}, 0.1, 0, 0.4);
      // Rays at less than 6° to the surface may meet the next side of the polygon.
      if (std::isfinite(distance) && point.intensity > 0.1F)
        worst = std::max(worst, std::abs(point.true_range - distance));
    }
  }
  state.counters["metres"] = worst;
}
BENCHMARK(closed_forms)->Unit(benchmark::kMillisecond)->Iterations(1);

void footprint(benchmark::State& state) {
  Plant plant;
  add_organ(plant, make_box({1, 4, 0.1F}), {-0.5F, -2, -0.05F});
  Progress progress;
  const MeshScene meshes = make_mesh_scene(plant, {}, progress);
  const int columns = 140;
  const int rows = sized(2000, 50);
  const auto distance = static_cast<double>(state.range(0));
  ScanInstrument scanner = ray_camera(0.4 * 10 / distance * (0.007 + 0.00035 * distance) / 0.0105, columns, rows);
  scanner.rays = 19;
  double error = 0;
  for (auto _ : state) {
    const Scan made = scan(plant, {}, meshes,
                           {.instrument = scanner, .stations = {Vec3(0, 0, distance)}, .target = Vec3(0)}, progress);
    std::vector<double> share(columns, 0);
    for (const ScanPoint& point : made.points) share[point.pulse % columns] += point.intensity / rows;
    const double pixel = 2 * distance * std::tan(scanner.field / 2) / columns;
    double mean = 0;
    double square = 0;
    for (int k = 0; k + 1 < columns; ++k) {
      const double place = pixel * (k + 1 - columns / 2);
      mean += (share[k] - share[k + 1]) * place;
      square += (share[k] - share[k + 1]) * place * place;
    }
    error = std::abs(4 * std::sqrt(square - mean * mean) / scanner.footprint(distance) - 1);
  }
  state.counters["error"] = error;
}
BENCHMARK(footprint)->ArgName("metres")->Arg(5)->Arg(10)->Arg(50)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Different oaks in rows, old ones in a whole run.
std::string stand_of_oaks(std::int64_t trees) {
  return fmt::format(R"({{
    "meristem": 1,
    "limits": {{"triangles": 1000000000, "instances": 100000000, "nodes": 100000000, "mesh_bytes": 8000000000}},
    "components": {{
      "stand": {{"type": "field", "rows": {}, "plants": 10, "row_spacing": 12, "spacing": 12}},
      "oak": {{"type": "document", "file": "oak", "set": {{"age": {}, "leafiness": 1.25}}}}
    }},
    "links": [["stand", "oak"]]
  }})",
                     trees / 10, sized(155, 8));
}

/// Scans as `meristem scan` does, and keeps the same data in memory.
void stand(benchmark::State& state) {
  const ThreadLimit threads(2);
  const std::string models = std::string(MERISTEM_SOURCE_DIR) + "/models";
  const Document document =
      read_document(stand_of_oaks(state.range(0)), "stand.json", builtin_components(), {.models = models});
  ScanInstrument scanner = instrument_of(ScannerClass::terrestrial);
  scanner.step = radians(sized(0.4, 8.0));
  Progress progress;
  for (auto _ : state) {
    GrownDocument grown = grow_document(document, progress, {.up_to = GrownPart::plant});
    if (has_holes(grown.plant)) paint_plant(document, grown.plant, progress);
    PlantLabels labels(grown.plant, document.graph.limits, progress);
    const MeshScene meshes = mesh_for_rays(document, std::move(grown.plant), progress);
    const Scanner ready(std::move(labels), meshes, {.instrument = scanner}, progress);
    std::uint64_t points = 0;
    const auto begin = std::chrono::steady_clock::now();
    ready.run([&](std::span<const ScanPoint> some) { points += some.size(); }, progress);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    state.counters["pulses_per_s"] = static_cast<double>(ready.pulse_count()) / seconds.count();
    state.counters["points"] = static_cast<double>(points);
    state.counters["triangles"] = static_cast<double>(meshes.triangle_count());
    state.counters["rays_MB"] = static_cast<double>(ready.ray_bytes()) / (1 << 20);
  }
  state.counters["peak_MB"] = meristem::bench::peak_megabytes();
}
BENCHMARK(stand)->ArgName("trees")->Arg(sized(100, 10))->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  using meristem::bench::Asked;
  return meristem::bench::run(count, arguments,
                              {{"pulses/oak", "pulses_per_s", Asked::at_least, 3e5},
                               {"stand/trees:100", "peak_MB", Asked::at_most, 3800},
                               {"labels", "differ", Asked::at_most, 0},
                               {"closed_forms", "metres", Asked::at_most, 1e-5},
                               {"footprint/metres:5", "error", Asked::at_most, 0.01},
                               {"footprint/metres:10", "error", Asked::at_most, 0.01},
                               {"footprint/metres:50", "error", Asked::at_most, 0.01}});
}

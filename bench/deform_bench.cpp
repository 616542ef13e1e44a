// SPDX-License-Identifier: Apache-2.0
// Deformations. `axes_of_maple` expands the large maple of more than 5 million triangles under an ffd on axes.
// `more_ms` is the additional time, compared with the maple without an ffd in the same run. `geometry_of_maple` uses an
// ffd on geometry and makes the meshes; `more_ms` is the additional time, and `meshes` is the number of meshes. `ffd`
// and `hyperpatch` deform a mesh of a million vertices with normals on one thread. `to_plain` is their time divided by
// the time of a hand-written loop that computes the same sum for each vertex.
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <glm/matrix.hpp>

#include "bench/harness.h"
#include "meristem/base/deform/bezier_volume.h"
#include "meristem/base/deform/deformation.h"
#include "meristem/base/deform/function_map.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/expand.h"

namespace {

using meristem::BezierVolume;
using meristem::Deformation;
using meristem::DMat3;
using meristem::DVec3;
using meristem::Mesh;
using meristem::Progress;
using meristem::Vec3;
using meristem::bench::Asked;
using meristem::bench::is_small;
using meristem::bench::sized;

const std::string kMaple = std::string(MERISTEM_SOURCE_DIR) + "/models/large-maple.json";

template <class Call>
double seconds_of(Call call) {
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Returns the maple, under an ffd if its parameters are given.
meristem::Document maple(const std::string& ffd) {
  std::string text = meristem::read_text_file(kMaple);
  if (!ffd.empty()) {
    const auto put = [&](const std::string& before, const std::string& by) {
      text.replace(text.find(before), before.size(), by);
    };
    put(R"(["view", "trunk"])", R"(["view", "wind"], ["wind", "trunk"])");
    put(R"("components": {)", R"("components": {"wind": {"type": "ffd", )" + ffd + "}, ");
  }
  std::vector<meristem::ValueOverride> overrides;
  if (is_small()) overrides.push_back({.path = "trunk.count", .value = 1, .name = {}});
  return read_document(text, kMaple, meristem::builtin_components(), {.overrides = overrides});
}

const std::string kBend = R"("dx": "x + 0.02*y^2", "dy": "y - 0.01*x*y", "on": )";

/// Measures the additional time of `work` on the deformed maple, compared with the plain maple.
template <class Work>
void compare(benchmark::State& state, const std::string& ffd, Work work) {
  const meristem::Document plain = maple(""), deformed = maple(ffd);
  double without = 1e9, with = 1e9;
  for (auto _ : state) {
    without = std::min(without, seconds_of([&] { work(plain); }));
    with = std::min(with, seconds_of([&] { work(deformed); }));
  }
  state.counters["plain_ms"] = 1e3 * without;
  state.counters["more_ms"] = 1e3 * (with - without);
}

void axes_of_maple(benchmark::State& state) {
  compare(state, kBend + R"("axes")", [](const meristem::Document& document) {
    Progress progress;
    benchmark::DoNotOptimize(expand(document.graph, document.scene, 0, progress));
  });
}
BENCHMARK(axes_of_maple)->Iterations(sized(8, 1))->Unit(benchmark::kMillisecond)->UseRealTime();

void geometry_of_maple(benchmark::State& state) {
  std::size_t meshes = 0;
  compare(state, kBend + R"("geometry")", [&](const meristem::Document& document) {
    Progress progress;
    const meristem::Plant plant = expand(document.graph, document.scene, 0, progress);
    meshes = mesh_detail(document, plant, {}, progress).meshes.size();
  });
  state.counters["meshes"] = static_cast<double>(meshes);
}
BENCHMARK(geometry_of_maple)->Iterations(sized(3, 1))->Unit(benchmark::kMillisecond)->UseRealTime();

Mesh many_vertices() {
  const auto count = sized<std::size_t>(1'000'000, 1000);
  Mesh mesh;
  const meristem::RandomKey key(1);
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = [&](std::uint64_t i) { return static_cast<float>(key.uniform(4 * k + i)); };
    mesh.positions.emplace_back(2 * number(0) - 1, 8 * number(1), 2 * number(2) - 1);
    mesh.normals.push_back(glm::normalize(Vec3(number(3) + 0.1F, number(0) - 0.5F, number(1) - 0.5F)));
  }
  return mesh;
}

/// Moves a vertex as a plain loop does.
template <class Map>
void move_plainly(Mesh& mesh, Map map) {
  for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
    DVec3 point(mesh.positions[k]);
    DMat3 m(0);
    map(point, m);
    mesh.positions[k] = Vec3(point);
    const DMat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    mesh.normals[k] = Vec3(glm::normalize(cofactors * DVec3(mesh.normals[k])));
  }
}

template <class Map>
void on_geometry(benchmark::State& state, std::shared_ptr<const meristem::SpaceMap> map, Map plain_map) {
  const meristem::ThreadLimit limit(1);
  const Deformation deformation({{std::move(map), {}, meristem::DeformedPart::geometry, "components.wind"}});
  const Mesh mesh = many_vertices();
  double ours = 1e9, plain = 1e9;
  for (auto _ : state) {
    Mesh moved = mesh;
    ours = std::min(ours, seconds_of([&] { deformation.map(moved, Vec3(0), Vec3(0), "leaf"); }));
    Mesh plainly = mesh;
    plain = std::min(plain, seconds_of([&] { move_plainly(plainly, plain_map); }));
    if (glm::distance(moved.positions.back(), plainly.positions.back()) > 1e-4F) state.SkipWithError("they differ");
  }
  const auto count = static_cast<double>(mesh.positions.size());
  state.counters["ns_a_vertex"] = 1e9 * ours / count;
  state.counters["plain_ns"] = 1e9 * plain / count;
  state.counters["to_plain"] = ours / plain;
}

void ffd(benchmark::State& state) {
  const meristem::ExpressionNames names{meristem::FunctionMap::coordinate_names(), {}};
  const auto compiled = [&](const char* text) { return meristem::Expression::compile(text, names); };
  auto map = std::make_shared<const meristem::FunctionMap>(std::array<std::optional<meristem::Expression>, 3>{
      compiled("x + 0.02*y^2"), compiled("y - 0.01*x*y"), std::nullopt});
  on_geometry(state, std::move(map), [](DVec3& p, DMat3& m) {
    m = DMat3(DVec3(1, -0.01 * p.y, 0), DVec3(0.04 * p.y, 1 - 0.01 * p.x, 0), DVec3(0, 0, 1));
    p = DVec3(p.x + 0.02 * p.y * p.y, p.y - 0.01 * p.x * p.y, p.z);
  });
}
BENCHMARK(ffd)->Iterations(sized(20, 1))->Unit(benchmark::kMillisecond)->UseRealTime();

void hyperpatch(benchmark::State& state) {
  const DVec3 low(-1, 0, -1), high(1, 8, 1);
  std::vector<DVec3> points = BezierVolume::points_at_rest(low, high, {3, 3, 3});
  for (DVec3& point : points) point += DVec3(0.02 * point.y * point.y, -0.01 * point.x * point.y, 0);
  auto map = std::make_shared<const BezierVolume>(low, high, BezierVolume::Degree{3, 3, 3}, points);
  on_geometry(state, std::move(map), [&](DVec3& p, DMat3& m) {
    double value[3][4], slope[3][4];
    const DVec3 place = (p - low) / (high - low);
    for (int axis = 0; axis < 3; ++axis) {
      const double t = place[axis], s = 1 - t;
      const double values[] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
      const double slopes[] = {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
      std::copy_n(values, 4, value[axis]);
      std::copy_n(slopes, 4, slope[axis]);
    }
    DVec3 sum(0);
    m = DMat3(0);
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        for (int x = 0; x < 4; ++x) {
          const DVec3& point = points[static_cast<std::size_t>(16 * y + 4 * z + x)];
          sum += value[0][x] * value[1][y] * value[2][z] * point;
          m[0] += slope[0][x] * value[1][y] * value[2][z] * point;
          m[1] += value[0][x] * slope[1][y] * value[2][z] * point;
          m[2] += value[0][x] * value[1][y] * slope[2][z] * point;
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis) m[axis] /= (high - low)[axis];
    p = sum;
  });
}
BENCHMARK(hyperpatch)->Iterations(sized(10, 1))->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  return meristem::bench::run(count, arguments,
                              {{"axes_of_maple", "more_ms", Asked::at_most, 500},
                               {"ffd", "to_plain", Asked::at_most, 3},
                               {"hyperpatch", "to_plain", Asked::at_most, 3}});
}

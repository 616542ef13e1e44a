// SPDX-License-Identifier: Apache-2.0
// Binary glTF of a million triangles and of a crown of leaves, on the memory's file system. The reference is the
// smallest possible work: fwrite writes the finished bytes of the same file. Also a skeleton of a million nodes as MTG
// and as CSV. Compare ratios only within one run.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/base/random.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/skeleton/skeleton_csv.h"
#include "meristem/output/skeleton/skeleton_mtg.h"
#include "meristem/plant/plant.h"
#include "meristem/shape/assembly/make_mesh_scene.h"
#include "meristem/shape/leaf/leaf_blade.h"
#include "meristem/shape/scene/mesh_scene.h"
#include "meristem/shape/solid/primitives.h"

namespace {

using namespace meristem;

/// A file that goes with its owner.
class OutputFile {
 public:
  OutputFile() {
    const char* const folder = std::getenv("MERISTEM_BENCH_FOLDER");
    path_ = std::string(folder != nullptr ? folder : "/dev/shm") + "/meristem_files_bench.glb";
  }
  ~OutputFile() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// One smooth mesh of a million triangles, with normals and uvs.
MeshScene large_scene() {
  static const std::uint32_t kSide = bench::sized(708U, 40U);
  Mesh mesh;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const Vec2 uv = Vec2(x, y) / static_cast<float>(kSide - 1);
      mesh.positions.emplace_back(uv.x, 0.1F * uv.x * uv.y, uv.y);
      mesh.normals.push_back(glm::normalize(Vec3(-0.1F * uv.y, 1, -0.1F * uv.x)));
      mesh.uvs.push_back(uv);
      if (x == 0 || y == 0) continue;
      const std::uint32_t corner = y * kSide + x;
      mesh.triangles.push_back({corner - kSide - 1, corner - 1, corner});
      mesh.triangles.push_back({corner - kSide - 1, corner, corner - kSide});
    }
  }
  MeshScene scene;
  scene.materials.emplace_back().name = "stem";
  scene.meshes.push_back({"stem", std::make_shared<const Mesh>(std::move(mesh)), 0, {Frame()}, {}});
  return scene;
}

/// A crown of leaves in their places, each with its own colour.
Plant leafy_plant(std::size_t leaves) {
  const RandomKey key(5);
  Plant plant;
  plant.materials.emplace_back().name = "leaf";
  OrganPrototype prototype;
  prototype.component = "leaf";
  prototype.mesh = std::make_shared<const Mesh>(make_leaf_blade(LeafBlade{}));
  plant.prototypes.push_back(prototype);
  for (std::size_t i = 0; i < leaves; ++i) {
    Organ organ;
    organ.frame = frame_along(3.0F * key.direction(2 * i), key.direction(2 * i + 1), kUp);
    organ.frame.axes *= static_cast<float>(key.child(1).uniform(i, 0.5, 2.0));
    organ.tint = Vec3(key.child(2).uniform(i, 0.7, 1.3), 1, 1);
    plant.organs.push_back(organ);
  }
  return plant;
}

void write_large(benchmark::State& state) {
  const MeshScene scene = large_scene();
  const OutputFile file;
  for (auto _ : state) {
    Progress progress;
    write_glb(scene, file.path(), {}, progress);
  }
  state.counters["triangles"] = static_cast<double>(scene.triangle_count());
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(file.path()));
}
BENCHMARK(write_large)->Unit(benchmark::kMillisecond)->UseRealTime();

void place_and_write_leaves(benchmark::State& state) {
  const Plant plant = leafy_plant(bench::sized(63'000, 300));
  const OutputFile file;
  GltfOptions options;
  if (state.range(0) != 0) options.instances = GltfInstances::rows;
  for (auto _ : state) {
    Progress progress;
    write_glb(make_mesh_scene(plant, SizeLimits{}, progress), file.path(), options, progress);
  }
  state.counters["triangles"] = static_cast<double>(plant.prototypes[0].mesh->triangle_count() * plant.organs.size());
  state.counters["bytes"] = static_cast<double>(std::filesystem::file_size(file.path()));
}
BENCHMARK(place_and_write_leaves)->ArgName("instanced")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A stem of a tree: axes fork at random nodes, and each has about forty nodes.
Plant twiggy_plant(NodeIndex nodes) {
  const RandomKey key(7);
  Plant plant;
  Stem& stem = plant.stems.emplace_back();
  stem.parts[0].component = "tree";
  Skeleton& skeleton = stem.skeleton;
  skeleton.add_node(kNoNode, Vec3(0), 0);
  AxisIndex axis = 0;
  for (NodeIndex node = 1; node < nodes; ++node) {
    const bool forks = node % 40 == 0;
    const NodeIndex parent = forks ? static_cast<NodeIndex>(key.uniform(node, 0, node)) : node - 1;
    skeleton.add_node(parent, skeleton.position[parent] + 0.05F * key.child(1).direction(node), node / 1000);
    skeleton.radius[node] = static_cast<float>(key.child(2).uniform(node, 0.001, 0.1));
    skeleton.axis[node] = forks ? ++axis : axis;
    skeleton.order[node] = static_cast<std::uint16_t>(skeleton.order[parent] + (forks ? 1 : 0));
  }
  return plant;
}

template <class Write>
void write_skeleton(benchmark::State& state, Write write) {
  const Plant plant = twiggy_plant(bench::sized(1'000'000U, 2'000U));
  const OutputFile file;
  for (auto _ : state) {
    Progress progress;
    write(plant, file.path(), progress);
  }
  const auto bytes = static_cast<double>(std::filesystem::file_size(file.path()));
  const auto runs = static_cast<double>(state.iterations());
  state.counters["bytes"] = bytes;
  state.counters["MB/s"] = benchmark::Counter(1e-6 * bytes * runs, benchmark::Counter::kIsRate);
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(plant.node_count()) * runs, benchmark::Counter::kIsRate);
}

void write_mtg(benchmark::State& state) {
  write_skeleton(state, [](const Plant& plant, const std::string& path, Progress& progress) {
    write_skeleton_mtg(plant, {}, path, {}, progress);
  });
}
BENCHMARK(write_mtg)->Unit(benchmark::kMillisecond)->UseRealTime();

void write_csv(benchmark::State& state) {
  write_skeleton(state, [](const Plant& plant, const std::string& path, Progress& progress) {
    write_skeleton_csv(plant, {}, path, progress);
  });
}
BENCHMARK(write_csv)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The reference: writes the finished bytes of the same files.
void write_finished_bytes(benchmark::State& state, const MeshScene& scene) {
  const OutputFile file;
  Progress progress;
  write_glb(scene, file.path(), {}, progress);
  std::ifstream stream(file.path(), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  for (auto _ : state) {
    std::filesystem::remove(file.path());
    std::FILE* out = std::fopen(file.path().c_str(), "wb");
    if (out == nullptr) return state.SkipWithError("cannot write");
    std::fwrite(bytes.data(), 1, bytes.size(), out);
    std::fclose(out);
  }
  state.counters["bytes"] = static_cast<double>(bytes.size());
}

void reference_large(benchmark::State& state) { write_finished_bytes(state, large_scene()); }
BENCHMARK(reference_large)->Unit(benchmark::kMillisecond)->UseRealTime();

void reference_leaves(benchmark::State& state) {
  Progress progress;
  write_finished_bytes(state, make_mesh_scene(leafy_plant(bench::sized(63'000, 300)), SizeLimits{}, progress));
}
BENCHMARK(reference_leaves)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) { return meristem::bench::run(count, arguments); }

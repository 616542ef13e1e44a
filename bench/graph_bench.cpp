// SPDX-License-Identifier: Apache-2.0
// Documents from text to meshes.
// - `edit`: one number of a plant of about 200,000 triangles changes, with a cache. Counters give the share of the
//   instances and of the stems that were made anew. `to_cold` is the time without a cache divided by the time with it,
//   in one run.
// - `maple`: the large maple of more than 5 million triangles is expanded. In `whole_process`, a separate process grows
//   the maple and writes it to an instanced GLB. Counters compare the peak memory of this process with the bytes of the
//   distinct meshes, and with the bytes of all instances as separate triangles.
// - `maize`: as `maple`, for 100,000 maize plants of 13 leaves each.
// - `table`, `measured`, `written`: the work that a user waits for, from the document's text to numbers or a file, on
//   one thread. `to_all` is the time of making the whole plant divided by the time of this work.
// - `components`: a document of many components is expanded. Each component stands on the first by a link of its own.
//   `exponent` is the power of the number of components with which the processor time grows.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/batch.h"
#include "meristem/graph/expand.h"
#include "meristem/measure/measures.h"
#include "meristem/output/gltf/gltf.h"
#include "meristem/output/skeleton/skeleton_csv.h"
#include "meristem/shape/stem/cached_meshes.h"

namespace {

using meristem::BatchResult;
using meristem::CacheReuse;
using meristem::Document;
using meristem::GltfInstances;
using meristem::GrownBatch;
using meristem::GrownDocument;
using meristem::GrownPart;
using meristem::GrowthCache;
using meristem::Progress;
using meristem::StemTubes;
using meristem::ValueOverride;
using meristem::bench::Asked;
using meristem::bench::is_small;
using meristem::bench::sized;

const std::string kMaple = std::string(MERISTEM_SOURCE_DIR) + "/models/large-maple.json";  // of six levels
const std::string kMaize = std::string(MERISTEM_SOURCE_DIR) + "/bench/maize.json";         // 100,000 plants
const std::string kOak = std::string(MERISTEM_SOURCE_DIR) + "/models/oak.json";

const std::string kTulip = std::string(MERISTEM_SOURCE_DIR) + "/models/tulip.json";

Document read(const std::string& file, const std::vector<ValueOverride>& overrides = {}) {
  return read_document(meristem::read_text_file(file), file, meristem::builtin_components(), {.overrides = overrides});
}

/// Returns a large document, or a small document of its kind in small runs.
Document read_large(const std::string& file) {
  std::vector<ValueOverride> overrides;
  if (is_small()) {
    if (file == kMaple) overrides.push_back({.path = "trunk.count", .value = 1, .name = {}});
    if (file == kMaize) overrides.push_back({.path = "field.rows", .value = 2, .name = {}});
  }
  return read(file, overrides);
}

double share_made(const CacheReuse& reuse) {
  const auto all = static_cast<double>(reuse.made + reuse.reused);
  return all > 0 ? static_cast<double>(reuse.made) / all : 0;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Returns the processor seconds of all threads of this process so far.
double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The shortest time of a call, and the smallest processor time of all threads together. On a busy machine the second
/// is more reliable.
class Times {
 public:
  template <class Call>
  void measure(Call call) {
    const double processor = processor_seconds();
    best_ = std::min(best_, seconds_of(call));
    processor_ = std::min(processor_, processor_seconds() - processor);
  }
  void tell(benchmark::State& state) const {
    state.counters["best_ms"] = 1e3 * best_;
    state.counters["processor_ms"] = 1e3 * processor_;
  }
  double best() const { return best_; }
  double processor() const { return processor_; }

 private:
  template <class Call>
  static double seconds_of(Call call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  double best_ = 1e9;
  double processor_ = 1e9;
};

/// One number changes slightly at every step. Measures everything from the document's text to the meshes.
void edit(benchmark::State& state, const std::string& file, std::vector<ValueOverride> overrides, const char* path,
          double value) {
  Progress progress;
  GrowthCache cache;
  GrownDocument grown;
  overrides.push_back({.path = path, .value = value, .name = {}});
  const auto grow = [&](int step, GrowthCache* with) {
    overrides.back().value = value * (1 + 0.001 * step);
    const Document document = read(file, overrides);
    grown = grow_document(document, progress, {.cache = with});
  };
  Times cold;
  for (int k = 0; k < sized(5, 1); ++k) cold.measure([&] { grow(20 * k, nullptr); });
  grow(0, &cache);
  int step = 0;
  Times times;
  for (auto _ : state) times.measure([&] { grow(++step % 100 + 1, &cache); });
  times.tell(state);
  state.counters["cold_ms"] = 1e3 * cold.best();
  state.counters["to_cold"] = cold.best() / times.best();
  state.counters["triangles"] = static_cast<double>(grown.meshes.triangle_count());
  state.counters["instances"] =
      static_cast<double>(cache.reuse<BatchResult>().made + cache.reuse<BatchResult>().reused);
  state.counters["expanded"] = share_made(cache.reuse<BatchResult>());
  state.counters["grown"] = share_made(cache.reuse<GrownBatch>());
  state.counters["meshed"] = share_made(cache.reuse<StemTubes>());
  state.counters["cache_mb"] = 1e-6 * static_cast<double>(cache.bytes());
}

/// One limb of the crown.
const std::vector<ValueOverride> kOneLimb = {{.path = "trunk.count", .value = 1, .name = {}}};

void edit_leaves(benchmark::State& state) { edit(state, kMaple, kOneLimb, "leaf.curl", 25); }
void edit_shoots(benchmark::State& state) { edit(state, kMaple, kOneLimb, "shoot.radius", 0.0024); }
void edit_trunk(benchmark::State& state) { edit(state, kMaple, kOneLimb, "tree_height", 21); }
void edit_leaves_of_grown_oak(benchmark::State& state) { edit(state, kOak, {}, "leafiness", 1); }
BENCHMARK(edit_leaves)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(edit_shoots)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(edit_trunk)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(edit_leaves_of_grown_oak)->Unit(benchmark::kMillisecond)->UseRealTime();

void maple_expanded(benchmark::State& state) {
  const Document document = read_large(kMaple);
  Progress progress;
  meristem::Plant plant;
  Times times;
  for (auto _ : state) {
    times.measure([&] { plant = expand(document.graph, document.scene, 0, progress); });
  }
  times.tell(state);
  state.counters["organs"] = static_cast<double>(plant.organs.size());
  state.counters["nodes"] = static_cast<double>(plant.node_count());
}
BENCHMARK(maple_expanded)->Unit(benchmark::kMillisecond)->UseRealTime();

void maple_meshed(benchmark::State& state) {
  const Document document = read_large(kMaple);
  Progress progress;
  const meristem::Plant plant = expand(document.graph, document.scene, 0, progress);
  meristem::MeshScene meshes;
  Times times;
  for (auto _ : state) times.measure([&] { meshes = mesh_detail(document, plant, {}, progress); });
  times.tell(state);
  state.counters["triangles"] = static_cast<double>(meshes.triangle_count());
}
BENCHMARK(maple_meshed)->Unit(benchmark::kMillisecond)->UseRealTime();

void maple_written(benchmark::State& state) {
  const Document document = read_large(kMaple);
  Progress progress;
  const GrownDocument grown = grow_document(document, progress);
  const std::string path = std::filesystem::temp_directory_path() / "maple_written.glb";
  Times times;
  for (auto _ : state) {
    times.measure(
        [&] { write_glb(grown.meshes, path, {.instances = GltfInstances::rows, .provenance = {}}, progress); });
  }
  times.tell(state);
  state.counters["file_mb"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::remove(path);
}
BENCHMARK(maple_written)->Unit(benchmark::kMillisecond)->UseRealTime();

std::string text_of_components(std::size_t count) {
  std::string components = R"("c0": {"type": "leaf"})";
  std::string links;
  for (std::size_t k = 1; k < count; ++k) {
    const std::string id = "c" + std::to_string(k);
    components += ", \"" + id + R"(": {"type": "leaf"})";
    links += (k == 1 ? R"(["c0", ")" : R"(, ["c0", ")") + id + "\"]";
  }
  return R"({"meristem": 1, "components": {)" + components + R"(}, "links": [)" + links + "]}";
}

void components(benchmark::State& state) {
  const auto expanded = [&](std::size_t count) {
    const Document document = read_document(text_of_components(count), "", meristem::builtin_components());
    Progress progress;
    Times times;
    for (int k = 0; k < 3; ++k) {
      times.measure([&] { benchmark::DoNotOptimize(expand(document.graph, document.scene, 0, progress)); });
    }
    return times;
  };
  const auto few = sized<std::size_t>(4'000, 100);
  const std::size_t many = 25 * few;
  for (auto _ : state) {
    const Times of_many = expanded(many);
    of_many.tell(state);
    state.counters["exponent"] = std::log(of_many.processor() / expanded(few).processor()) / std::log(25);
  }
  state.counters["components"] = static_cast<double>(many);
}
BENCHMARK(components)->Unit(benchmark::kMillisecond)->Iterations(1);

/// The work of the separate process.
int grow_and_write(const char* path, const char* file) {
  Progress progress;
  const Document document = read_large(file);
  const GrownDocument grown = grow_document(document, progress);
  write_glb(grown.meshes, path, {.instances = GltfInstances::rows, .provenance = {}}, progress);
  return 0;
}

void whole_process(benchmark::State& state, const std::string& file) {
  const std::string path = std::filesystem::temp_directory_path() / "whole_process.glb";
  Times times;
  double processor = 1e9;
  double peak = 0;
  for (auto _ : state) {
    rusage usage{};
    times.measure([&] {
      const pid_t child = fork();
      if (child == 0) {
        execl("/proc/self/exe", "graph_bench", "--write", path.c_str(), file.c_str(), nullptr);
        _exit(127);
      }
      int status = 0;
      wait4(child, &status, 0, &usage);
      if (status != 0) throw std::runtime_error("the process failed");
    });
    processor = std::min(processor, seconds(usage.ru_utime) + seconds(usage.ru_stime));
    peak = std::max(peak, static_cast<double>(usage.ru_maxrss));
  }
  state.counters["file_mb"] = 1e-6 * static_cast<double>(std::filesystem::file_size(path));
  std::filesystem::remove(path);
  Progress progress;
  const GrownDocument grown = grow_document(read_large(file), progress);
  double distinct = 0;
  double flat = 0;
  for (const meristem::MeshInstances& instances : grown.meshes.meshes) {
    distinct += static_cast<double>(instances.mesh->bytes());
    flat += static_cast<double>(instances.mesh->bytes() * instances.frames.size());
  }
  state.counters["organs"] = static_cast<double>(grown.plant.organs.size());
  state.counters["processor_ms"] = 1e3 * processor;
  state.counters["peak_mb"] = 1e-3 * peak;
  state.counters["meshes_mb"] = 1e-6 * distinct;
  state.counters["flat_mb"] = 1e-6 * flat;
}
/// Measures `work` on a document on one thread, beside growing the whole document.
template <class Work>
void use(benchmark::State& state, const std::string& file, Work work) {
  const meristem::ThreadLimit limit(1);
  Times ours;
  Times all;
  for (auto _ : state) {
    Progress progress;
    ours.measure([&] { work(read(file), progress); });
    state.PauseTiming();
    all.measure([&] { benchmark::DoNotOptimize(grow_document(read(file), progress)); });
    state.ResumeTiming();
  }
  ours.tell(state);
  state.counters["to_all"] = all.best() / ours.best();
}

const std::string& target() {
  static const std::string path = std::filesystem::temp_directory_path() / "graph_bench.glb";
  return path;
}

void write_table(const Document& document, Progress& progress) {
  write_skeleton_csv(grow_document(document, progress, {.up_to = GrownPart::plant}).plant, document.graph.limits,
                     target(), progress);
}
void measure(const Document& document, Progress& progress) {
  GrownDocument grown = grow_document(document, progress, {.up_to = GrownPart::meshes});
  if (has_holes(grown.plant)) complete_growth(document, grown, progress);
  benchmark::DoNotOptimize(
      measure_plant(grown.plant, document.graph.limits, grown.meshes, document.scene, {}, progress));
}
void write(const Document& document, Progress& progress) {
  write_glb(grow_document(document, progress).meshes, target(), {}, progress);
}

void table(benchmark::State& state, const std::string& file) { use(state, file, write_table); }
void measured(benchmark::State& state, const std::string& file) { use(state, file, measure); }
void written(benchmark::State& state, const std::string& file) { use(state, file, write); }
BENCHMARK_CAPTURE(table, oak, kOak)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(measured, oak, kOak)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(measured, tulip, kTulip)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(written, oak, kOak)->Unit(benchmark::kMillisecond)->UseRealTime();

void maple_whole_process(benchmark::State& state) { whole_process(state, kMaple); }
void maize_whole_process(benchmark::State& state) { whole_process(state, kMaize); }
BENCHMARK(maple_whole_process)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(maize_whole_process)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  if (count == 4 && std::string_view(arguments[1]) == "--write") return grow_and_write(arguments[2], arguments[3]);
  const int status = meristem::bench::run(count, arguments,
                                          {{"edit_leaves", "best_ms", Asked::at_most, 10},
                                           {"edit_shoots", "best_ms", Asked::at_most, 20},
                                           {"edit_trunk", "best_ms", Asked::at_most, 20},
                                           {"edit_leaves_of_grown_oak", "best_ms", Asked::at_most, 20},
                                           {"components/iterations:1", "exponent", Asked::at_most, 1.1},
                                           {"maple_whole_process", "ms", Asked::at_most, 1000},
                                           {"table/oak", "best_ms", Asked::at_most, 70},
                                           {"measured/oak", "best_ms", Asked::at_most, 85},
                                           {"measured/tulip", "best_ms", Asked::at_most, 2},
                                           {"written/oak", "best_ms", Asked::at_most, 270}});
  std::filesystem::remove(target());
  return status;
}

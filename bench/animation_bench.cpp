// SPDX-License-Identifier: Apache-2.0
// Frames of films. `keyed_leaves` makes a frame of a tree of 200,000 triangles whose leaves have keys, with the cache.
// Only the leaves are made anew. `to_cold` is the time of growing everything, divided by the time with the cache, in
// one run. `growth` makes a frame of the oak that grows over time; `growths` is the number of skeletons that all frames
// together have grown. `maple` makes a frame of the large maple with 4 million triangles whose leaves have keys.
// `grown_mb` is the additional memory of the process after all 250 frames, compared with the memory after the first 25.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "bench/harness.h"
#include "meristem/components/registry.h"
#include "meristem/document/document.h"
#include "meristem/document/grow.h"
#include "meristem/graph/batch.h"

namespace {

using meristem::Document;
using meristem::GrownDocument;
using meristem::GrownPart;
using meristem::GrowthCache;
using meristem::Progress;
using meristem::bench::Asked;
using meristem::bench::sized;

constexpr double kFilm = 10;  // seconds

/// Returns the document with these overrides, "PATH=VALUE".
Document read(const std::string& file, const std::vector<std::string>& sets) {
  const std::string path = std::string(MERISTEM_SOURCE_DIR) + "/" + file;
  meristem::ReadOptions options;
  for (const std::string& set : sets) options.overrides.push_back(meristem::parse_override(set));
  return read_document(meristem::read_text_file(path), path, meristem::builtin_components(), options);
}

GrownDocument frame(const Document& document, double time, GrowthCache* cache) {
  Progress progress;
  return grow_document(document, progress, {.time = time, .up_to = GrownPart::meshes, .cache = cache});
}

/// Returns the present memory of the process in megabytes.
double held_mb() {
  long pages = 0;
  long resident = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r"); file != nullptr) {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return 1e-6 * static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

class Stopwatch {
 public:
  double ms() const { return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

void keyed_leaves(benchmark::State& state) {
  const Document document =
      read("models/oak.json", {"age=" + std::string(sized("70", "8")), "scene={}",
                               R"(animation={"length": 10, "keys": {"leaf.curl": [[0, -30], [10, 60]],)"
                               R"( "leaf.frame.scale": [[0, [0.2, 0.2, 0.2]], [10, [1, 1, 1]]]}})"});
  GrowthCache cache;
  frame(document, 0, &cache);
  double best = 1e9;
  double cold = 1e9;
  int k = 0;
  GrownDocument grown;
  for (auto _ : state) {
    const double time = kFilm * (++k % 100) / 100;
    const Stopwatch watch;
    grown = frame(document, time, &cache);
    best = std::min(best, watch.ms());
    state.PauseTiming();
    if (k <= 3) {
      const Stopwatch all;
      benchmark::DoNotOptimize(frame(document, time, nullptr));
      cold = std::min(cold, all.ms());
    }
    state.ResumeTiming();
  }
  state.counters["triangles"] = static_cast<double>(grown.meshes.triangle_count());
  state.counters["best_ms"] = best;
  state.counters["to_cold"] = cold / best;
}

void growth(benchmark::State& state) {
  const Document document = read("models/films/oak-life.json", {"age=" + std::string(sized("160", "10"))});
  const int frames = sized(100, 3);
  double growths = 0;
  double best = 1e9;
  for (auto _ : state) {
    GrowthCache cache;
    for (int k = 1; k <= frames; ++k) {
      const Stopwatch watch;
      benchmark::DoNotOptimize(frame(document, document.graph.animation->length * k / frames, &cache));
      best = std::min(best, watch.ms());
      growths += static_cast<double>(cache.reuse<meristem::GrownBatch>().made);
    }
  }
  state.counters["growths"] = growths / static_cast<double>(state.iterations());
  state.counters["best_ms"] = best;
}

void maple(benchmark::State& state) {
  const Document document =
      read("models/large-maple.json", {"leafiness=" + std::string(sized("0.57", "0.02")),
                                       R"(animation={"length": 10, "keys": {"leaf.curl": [[0, -30], [10, 60]]}})"});
  const int frames = sized(250, 2);
  double early = 0;
  double triangles = 0;
  for (auto _ : state) {
    GrowthCache cache;
    for (int k = 1; k <= frames; ++k) {
      const GrownDocument grown = frame(document, kFilm * k / frames, &cache);
      triangles = static_cast<double>(grown.meshes.triangle_count());
      if (k == std::max(1, frames / 10)) early = held_mb();
    }
  }
  state.counters["triangles"] = triangles;
  state.counters["held_mb"] = held_mb();
  state.counters["grown_mb"] = std::max(0.0, held_mb() - early);
}

BENCHMARK(keyed_leaves)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(growth)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(maple)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace

int main(int count, char** arguments) {
  return meristem::bench::run(count, arguments,
                              {{"keyed_leaves", "best_ms", Asked::at_most, 50},
                               {"growth", "growths", Asked::at_most, 1},
                               {"maple", "grown_mb", Asked::at_most, 100}});
}

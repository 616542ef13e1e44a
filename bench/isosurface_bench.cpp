// SPDX-License-Identifier: Apache-2.0
// Isosurfaces of blended trees. The tree is Honda's tree with one axis (P. Prusinkiewicz, A. Lindenmayer: The
// Algorithmic Beauty of Plants, 1990, figure 2.6): 511 segments, at resolution 200 by default.
//
// `everywhere` evaluates all segments at all corners of the grid and marches through all cells. `own_boxes` evaluates
// each segment only in its own padded box. Counters: triangles and bytes of the mesh. For the library also bricks, the
// samples in bricks, the number of solids in a brick (fewer in each of its blocks), and the shortest time of several
// runs, taken in turn with the reference. `scaling` uses other resolutions, with twigs as thick as the cells require;
// its peak memory is the memory of the process from this benchmark on. `first` makes the first body of a program.
// `to_again` is its time divided by the shortest time of making this body again.
//
// `spruce_trunk` and `spruce_crown` are the bodies of F. Heuer: Algorithmische Erzeugung von 3D-Low-Poly-Bäumen (2022),
// with the printed grammar, six steps. The source's figures (table 6.1) are printed beside the library's figures. The
// source's bodies lie in a fixed cube, and the library's bodies fill their grids. The source blends segment with
// segment.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/dense_isosurface.h"
#include "bench/harness.h"
#include "meristem/base/parallel.h"
#include "meristem/grow/lsystem/derive.h"
#include "meristem/grow/lsystem/grammar_reader.h"
#include "meristem/grow/lsystem/turtle.h"
#include "meristem/measure/convex_hull.h"
#include "meristem/shape/implicit/brick_field.h"
#include "meristem/shape/implicit/isosurface.h"
#include "meristem/shape/implicit/plant_body.h"

namespace {

using namespace meristem;

const int kResolution = bench::sized(200, 40);

Skeleton draw_grammar(const char* text, int steps, const TurtleParameters& turtle) {
  Progress progress;
  const Grammar grammar = read_grammar(text);
  const Word word = derive_drawn(grammar, steps, RandomKey(1), SizeLimits(), progress);
  return draw(word, grammar.alphabet, turtle, {}, SizeLimits(), "", progress).skeleton;
}

Skeleton honda_tree() {
  return draw_grammar(
      "A(1,0.14)\n"
      "A(l,w) -> !(w)F(l)[&(45)B(l*0.6,w*0.707)]/(137.5)A(l*0.9,w*0.707)\n"
      "B(l,w) -> !(w)F(l)[-(45)$C(l*0.6,w*0.707)]C(l*0.9,w*0.707)\n"
      "C(l,w) -> !(w)F(l)[+(45)$B(l*0.6,w*0.707)]B(l*0.9,w*0.707)\n",
      bench::sized(9, 5), {});
}

Skeleton spruce() {
  return draw_grammar(
      "#axiom\nP\n#rules\n"
      "P -> ^^^^FFFFM\n"
      "M -> FFF[]AAAAAM\n"
      "A -> +++[&&&&&F[]F[]^F&[]O^^^^^^]\n"
      "N -> ^^&&&[]N\n"
      "O -> [--F[]N++]++[F[]N]--&[]^&&[]N\n",
      6,
      {.reading = TurtleParameters::Reading::polar,
       .length = 0.11,
       .width = 0.1,
       .trunk_decay = 0.95,
       .branch_decay = 0.825});
}

std::vector<AxisIndex> all_axes(const Skeleton& skeleton) {
  std::vector<AxisIndex> axes(SkeletonAxes(skeleton).count());
  std::iota(axes.begin(), axes.end(), AxisIndex{0});
  return axes;
}

/// Makes the body as documents do for a resolution.
ImplicitBody stem_body(const Skeleton& skeleton, int resolution) {
  const std::vector<AxisIndex> axes = all_axes(skeleton);
  const SurfaceOptions surface{.resolution = resolution};
  return make_stem_body(skeleton, axes, surface, find_thickening(skeleton, axes, surface).min_radius);
}

Mesh extract(const ImplicitBody& body, int resolution, bool normals) {
  Progress progress;
  return extract_isosurface(body, {.resolution = resolution, .normals = normals}, SizeLimits(), "", progress);
}

Mesh extract_everywhere(const ImplicitBody& body) {
  DenseGrid grid = dense_grid(body, cell_size(body, kResolution));
  DenseTree(body).fill(grid);
  return DenseMesher(grid).run();
}

Mesh extract_own_boxes(const ImplicitBody& body) {
  DenseGrid grid = dense_grid(body, cell_size(body, kResolution));
  DenseTree(body).fill_boxes(grid, body);
  return DenseMesher(grid).run();
}

/// The shortest time of the runs, and their result.
struct Outcome {
  double seconds = 1e9;
  std::size_t triangles = 0;
  long euler = 0;
  double area = 0;

  template <class Make>
  Mesh run(Make make) {
    const auto start = std::chrono::steady_clock::now();
    Mesh mesh = make();
    seconds = std::min(seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return mesh;
  }
  void look_at(const Mesh& mesh) {
    triangles = mesh.triangle_count();
    // Closed meshes have three edges for two triangles.
    euler = static_cast<long>(mesh.vertex_count()) - static_cast<long>(triangles / 2);
    area = surface_area_of(mesh);
  }
};

/// Results by the benchmark's name and resolution or threads.
std::map<std::pair<std::string, int>, Outcome>& outcomes() {
  static std::map<std::pair<std::string, int>, Outcome> all;
  return all;
}

template <class Make>
void measure(benchmark::State& state, const std::string& name, int key, Make make) {
  Outcome& outcome = outcomes()[{name, key}];
  Mesh mesh;
  while (state.KeepRunning()) {
    mesh = {};
    mesh = outcome.run(make);
  }
  outcome.look_at(mesh);
  state.counters["triangles"] = static_cast<double>(mesh.triangle_count());
  state.counters["bytes"] = static_cast<double>(mesh.bytes());
}

void first(benchmark::State& state) {
  const ThreadLimit limit(1);
  const ImplicitBody body = stem_body(honda_tree(), kResolution);
  Outcome once;
  Outcome again;
  Mesh mesh;
  while (state.KeepRunning()) mesh = once.run([&] { return extract(body, kResolution, true); });
  for (int run = 0; run < bench::sized(20, 1); ++run) again.run([&] { return extract(body, kResolution, true); });
  state.counters["triangles"] = static_cast<double>(mesh.triangle_count());
  state.counters["to_again"] = once.seconds / again.seconds;
}
// Runs before all other benchmarks.
BENCHMARK(first)->Iterations(1)->Unit(benchmark::kMillisecond);

void everywhere(benchmark::State& state) {
  const ImplicitBody body = stem_body(honda_tree(), kResolution);
  measure(state, "everywhere", 1, [&] { return extract_everywhere(body); });
}
BENCHMARK(everywhere)->Iterations(1)->Unit(benchmark::kMillisecond);

void own_boxes(benchmark::State& state) {
  const ImplicitBody body = stem_body(honda_tree(), kResolution);
  measure(state, "own_boxes", 1, [&] { return extract_own_boxes(body); });
}
BENCHMARK(own_boxes)->Unit(benchmark::kMillisecond);

void count_bricks(benchmark::State& state, const ImplicitBody& body) {
  Progress progress;
  const BodyBricks bricks = sample_body(body, cell_size(body, kResolution), SizeLimits(), "", progress);
  std::size_t count = 0;
  std::size_t solids = 0;
  for (std::size_t chunk = 0; chunk < bricks.parts.size(); ++chunk) {
    count += bricks.grid.chunks[chunk].at.size();
    for (const FieldStep& step : bricks.parts[chunk].steps) {
      solids += body.clauses()[step.clause].kind == BodyClause::Kind::solid ? 1 : 0;
    }
  }
  state.counters["bricks"] = static_cast<double>(count);
  state.counters["samples"] = static_cast<double>(count) * kBrickSize;
  state.counters["solids_a_brick"] = static_cast<double>(solids) / static_cast<double>(count);
}

void isosurface(benchmark::State& state) {
  const auto threads = static_cast<int>(state.range(0));
  const bool normals = state.range(1) != 0;
  const ThreadLimit limit(threads);
  const ImplicitBody body = stem_body(honda_tree(), kResolution);
  const std::string name = normals ? "isosurface_normals" : "isosurface";
  const auto ours = [&] { return extract(body, kResolution, normals); };
  measure(state, name, threads, ours);
  count_bricks(state, body);
  // Compared programs run in turns.
  for (int run = 0; run < bench::sized(20, 1); ++run) {
    outcomes()[{name, threads}].run(ours);
    if (threads == 1) {
      outcomes()[{"own_boxes", 1}].run([&] { return extract_own_boxes(body); });
    } else {
      const ThreadLimit one(1);
      outcomes()[{name, 1}].run(ours);
    }
  }
  state.counters["least_ms"] = 1000 * outcomes()[{name, threads}].seconds;
}
BENCHMARK(isosurface)
    ->ArgNames({"threads", "normals"})
    ->ArgsProduct({{1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

const std::vector<std::int64_t> kResolutions = bench::sized({50, 100, 200, 400, 800, 1024}, {50});

void scaling(benchmark::State& state) {
  const ThreadLimit limit(1);
  const auto resolution = static_cast<int>(state.range(0));
  const ImplicitBody body = stem_body(honda_tree(), resolution);
  measure(state, "scaling", resolution, [&] { return extract(body, resolution, true); });
  state.counters["peak_MB"] = meristem::bench::peak_megabytes();
}
BENCHMARK(scaling)
    ->ArgName("resolution")
    ->Apply([](benchmark::internal::Benchmark* rows) {
      for (const std::int64_t resolution : kResolutions) rows->Arg(resolution);
    })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void spruce_trunk(benchmark::State& state) {
  const auto resolution = static_cast<int>(state.range(0));
  const ImplicitBody body = stem_body(spruce(), resolution);
  measure(state, "spruce_trunk", resolution, [&] { return extract(body, resolution, true); });
  state.counters["solids"] = static_cast<double>(body.solids().size());
}

void spruce_crown(benchmark::State& state) {
  const bool is_root = state.range(0) != 0;
  const auto resolution = static_cast<int>(state.range(1));
  CrownBody crown{.diameter = 0.08F, .offset = 0.06F, .fuse = 0.06F};
  // The source's k is 0.01 m²: a width of 0.1 m.
  if (is_root) crown.blend = BlendKind::root, crown.fuse = 0.1F;
  const Skeleton skeleton = spruce();
  const ImplicitBody body = make_crown_body(skeleton, all_axes(skeleton), crown);
  measure(state, is_root ? "spruce_crown_root" : "spruce_crown", resolution,
          [&] { return extract(body, resolution, true); });
  state.counters["solids"] = static_cast<double>(body.solids().size());
}

/// The source's figures: seconds with Java on a Ryzen 5800X, 16 threads.
struct SourceRow {
  int resolution;
  double trunk, crown;
  std::size_t trunk_triangles, crown_triangles;
};
constexpr std::array kSource{SourceRow{25, 0.05, 0.02, 942, 3'848},      SourceRow{50, 0.4, 0.2, 6'452, 15'992},
                             SourceRow{75, 1.1, 0.43, 14'196, 36'268},   SourceRow{100, 2.5, 1.0, 27'100, 64'476},
                             SourceRow{125, 4.4, 1.9, 40'738, 101'668},  SourceRow{150, 7.8, 3.3, 60'472, 146'604},
                             SourceRow{200, 17.9, 7.8, 111'026, 259'556}};

std::span<const SourceRow> source_rows() { return std::span(kSource).first(bench::sized(kSource.size(), 1UL)); }

BENCHMARK(spruce_trunk)
    ->ArgName("resolution")
    ->Apply([](benchmark::internal::Benchmark* rows) {
      for (const SourceRow& row : source_rows()) rows->Arg(row.resolution);
    })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(spruce_crown)
    ->ArgNames({"root", "resolution"})
    ->Apply([](benchmark::internal::Benchmark* rows) {
      for (const int root : {0, 1}) {
        for (const SourceRow& row : source_rows()) rows->Args({root, row.resolution});
      }
    })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

bool has_run(const std::string& name, int key) { return outcomes().contains({name, key}); }

void print_ratio(const std::string& of, int key, const std::string& to, int to_key) {
  if (!has_run(of, key) || !has_run(to, to_key)) return;
  std::printf("%s (%d) / %s (%d): %.1f\n", of.c_str(), key, to.c_str(), to_key,
              outcomes()[{of, key}].seconds / outcomes()[{to, to_key}].seconds);
}

void print_meshes() {
  for (const char* name : {"everywhere", "own_boxes", "isosurface"}) {
    if (!has_run(name, 1) || outcomes()[{name, 1}].triangles == 0) continue;
    const Outcome& outcome = outcomes()[{name, 1}];
    std::printf("%s: %zu triangles, Euler number %ld, %.4f m²\n", name, outcome.triangles, outcome.euler, outcome.area);
  }
}

void print_exponents() {
  for (std::size_t k = 1; k < kResolutions.size(); ++k) {
    const auto from = static_cast<int>(kResolutions[k - 1]);
    const auto to = static_cast<int>(kResolutions[k]);
    if (!has_run("scaling", from) || !has_run("scaling", to)) continue;
    std::printf("cost grows with resolution^%.2f from %d to %d\n",
                std::log(outcomes()[{"scaling", to}].seconds / outcomes()[{"scaling", from}].seconds) /
                    std::log(static_cast<double>(to) / from),
                from, to);
  }
}

void print_source_table() {
  if (!has_run("spruce_trunk", kSource[0].resolution) || !has_run("spruce_crown_root", kSource[0].resolution)) return;
  std::printf("The source's spruce, s and triangles; theirs: Java, Ryzen 5800X, 16 threads; ours: %d threads\n",
              thread_count());
  std::printf("resolution | theirs: trunk          crown | ours: trunk             crown        crown, poly\n");
  for (const SourceRow& row : kSource) {
    const Outcome& trunk = outcomes()[{"spruce_trunk", row.resolution}];
    const Outcome& root = outcomes()[{"spruce_crown_root", row.resolution}];
    const Outcome& poly = outcomes()[{"spruce_crown", row.resolution}];
    std::printf("%10d | %6.2f %7zu %6.2f %7zu | %8.4f %7zu %8.4f %7zu %8.4f %7zu\n", row.resolution, row.trunk,
                row.trunk_triangles, row.crown, row.crown_triangles, trunk.seconds, trunk.triangles, root.seconds,
                root.triangles, poly.seconds, poly.triangles);
  }
}

/// Returns true if the reference's mesh agrees with the library's mesh.
bool has_same_triangles(const std::string& reference) {
  if (!has_run(reference, 1) || !has_run("isosurface", 1)) return true;
  const Outcome& ours = outcomes()[{"isosurface", 1}];
  const Outcome& theirs = outcomes()[{reference, 1}];
  const bool is_same = ours.triangles == theirs.triangles && ours.euler == theirs.euler;
  if (!is_same) std::printf("%s makes another mesh\n", reference.c_str());
  return is_same;
}

bool print_all() {
  print_ratio("everywhere", 1, "isosurface", 1);
  print_ratio("own_boxes", 1, "isosurface", 1);
  print_ratio("isosurface", 1, "isosurface", 2);
  print_ratio("isosurface_normals", 1, "isosurface_normals", 2);
  print_meshes();
  print_exponents();
  print_source_table();
  return has_same_triangles("own_boxes") && has_same_triangles("everywhere");
}

}  // namespace

int main(int count, char** arguments) {
  return bench::run(count, arguments, {{"first", "ms", bench::Asked::at_most, 10}}, print_all);
}

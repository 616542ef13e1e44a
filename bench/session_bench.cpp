// SPDX-License-Identifier: Apache-2.0
// Edits through a session: the text, the document and the growth.
// - `edit`: one number changes at every step, from the text's patch to the meshes and their keys. Counters give the
//   time for the text and for the document, and the number of meshes that changed. `to_cold` is the time of reading and
//   growing everything divided by the time of an edit, in one run.
// - `avenue`: a leaf is edited, and the plants grow beside houses. `to_open` is the processor time divided by the
//   processor time without houses.
// - `avenue_read`: the edit and the reading alone, which also reads the houses' part of the text. `longer` is the
//   length of the text with houses divided by its length without houses. `to_longer` is the ratio of the times divided
//   by `longer`.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/harness.h"
#include "meristem/components/registry.h"
#include "meristem/document/edit/session.h"

namespace {

using meristem::Progress;
using meristem::RemoveValue;
using meristem::Session;
using meristem::SessionEdit;
using meristem::SetValue;
using meristem::bench::Asked;
using meristem::bench::sized;

const std::string kModels = std::string(MERISTEM_SOURCE_DIR) + "/models/";

Session open(const std::string& model, const std::vector<SessionEdit>& first = {}) {
  const std::string file = kModels + model;
  Session session(meristem::read_text_file(file), file, meristem::builtin_components());
  if (!first.empty()) session.edit(first);
  return session;
}

/// Returns the shortest time of all calls, ms.
class Shortest {
 public:
  template <class Call>
  void measure(Call call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    ms_ = std::min(ms_, 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  double ms() const { return ms_; }

 private:
  double ms_ = 1e9;
};

/// Returns steps around a value; each differs from the previous step.
class Values {
 public:
  explicit Values(double middle) : middle_(middle) {}
  double next() { return middle_ * (1 + 0.001 * (++step_ % 100)); }

 private:
  double middle_;
  int step_ = 0;
};

void edit(benchmark::State& state, const std::string& model, const std::vector<SessionEdit>& first, const char* path,
          double value) {
  Session session = open(model, first);
  Progress progress;
  Values values(value);
  Shortest cold;
  for (int k = 0; k < sized(5, 1); ++k) {
    cold.measure([&] {
      grow_document(read_document(session.text(), session.file(), meristem::builtin_components()), progress);
    });
  }
  session.grow(progress);
  Shortest whole;
  Shortest reading;
  std::size_t other_meshes = 0;
  for (auto _ : state) {
    whole.measure([&] {
      reading.measure([&] { session.edit(path, values.next()); });
      session.grow(progress);
    });
    other_meshes = session.difference().meshes.added.size();
  }
  state.counters["best_ms"] = whole.ms();
  state.counters["read_ms"] = reading.ms();
  state.counters["cold_ms"] = cold.ms();
  state.counters["to_cold"] = cold.ms() / whole.ms();
  state.counters["triangles"] = static_cast<double>(session.grown()->meshes.triangle_count());
  state.counters["other_meshes"] = static_cast<double>(other_meshes);
}

/// One limb of the crown: about 200,000 triangles.
const std::vector<SessionEdit> kOneLimb = {SetValue{"trunk.count", 1}};

void maple_leaves(benchmark::State& state) { edit(state, "large-maple.json", kOneLimb, "leaf.curl", 25); }
void maple_shoots(benchmark::State& state) { edit(state, "large-maple.json", kOneLimb, "shoot.radius", 0.0024); }
void maple_trunk(benchmark::State& state) { edit(state, "large-maple.json", kOneLimb, "tree_height", 21); }
void oak_leaves(benchmark::State& state) { edit(state, "oak.json", {}, "leafiness", 1); }
BENCHMARK(maple_leaves)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(maple_shoots)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(maple_trunk)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(oak_leaves)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The shipped avenue, and the avenue without its houses. A small run has few points per crown.
struct Avenues {
  Session houses = open("avenue.json", {SetValue{"lime.points.count", sized(3600, 60)}});
  Session street =
      open("avenue.json", {SetValue{"lime.points.count", sized(3600, 60)}, RemoveValue{"scene.obstacles"}});
  Values widths{0.11};
};

void avenue(benchmark::State& state) {
  Avenues avenues;
  Progress progress;
  avenues.houses.grow(progress);
  avenues.street.grow(progress);
  // Processor time of all edits, because only some edits change a mesh, and the machine may be busy.
  const auto seconds_of = [&](Session& session, double width) {
    const std::clock_t begin = std::clock();
    session.edit("leaf.width", width);
    session.grow(progress);
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  double houses = 0;
  double street = 0;
  for (auto _ : state) {
    const double width = avenues.widths.next();
    houses += seconds_of(avenues.houses, width);
    street += seconds_of(avenues.street, width);
  }
  state.counters["cpu_ms"] = 1e3 * houses / static_cast<double>(state.iterations());
  state.counters["to_open"] = houses / street;
  state.counters["triangles"] = static_cast<double>(avenues.houses.grown()->meshes.triangle_count());
}
BENCHMARK(avenue)->Iterations(sized(200, 1))->Unit(benchmark::kMillisecond)->UseRealTime();

void avenue_read(benchmark::State& state) {
  Avenues avenues;
  Shortest houses;
  Shortest street;
  for (auto _ : state) {
    const double width = avenues.widths.next();
    houses.measure([&] { avenues.houses.edit("leaf.width", width); });
    street.measure([&] { avenues.street.edit("leaf.width", width); });
  }
  const auto longer =
      static_cast<double>(avenues.houses.text().size()) / static_cast<double>(avenues.street.text().size());
  state.counters["best_ms"] = houses.ms();
  state.counters["longer"] = longer;
  state.counters["to_longer"] = houses.ms() / street.ms() / longer;
  state.counters["files_read"] = static_cast<double>(avenues.houses.read_counts().files_read);
}
BENCHMARK(avenue_read)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int count, char** arguments) {
  return meristem::bench::run(count, arguments,
                              {{"maple_leaves", "best_ms", Asked::at_most, 10},
                               {"maple_shoots", "best_ms", Asked::at_most, 20},
                               {"maple_trunk", "best_ms", Asked::at_most, 20},
                               {"oak_leaves", "best_ms", Asked::at_most, 20},
                               {"avenue", "to_open", Asked::at_most, 1},
                               {"avenue_read", "to_longer", Asked::at_most, 1},
                               {"avenue_read", "best_ms", Asked::at_most, 1}});
}

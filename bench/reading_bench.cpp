// SPDX-License-Identifier: Apache-2.0
// Reading, checking and finding positions in large documents. Each kind of document is read in two sizes. The second
// has 100 times as many components (links, variables, faults). `exponent` is the power of the size with which the
// processor time grows: 1 if the time is proportional to the size. `ms_small` and `ms_large` are the processor times of
// both sizes, which other programs on the machine hardly change, and `mb_large` is the size of the larger text.
// `cancel_ms` is the longest time from a cancel until reading has stopped, for cancels spread over the whole reading of
// the larger document.
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include <benchmark/benchmark.h>
#include <malloc.h>
#include <unistd.h>

#include "bench/harness.h"
#include "meristem/components/registry.h"
#include "meristem/document/edit/session.h"

namespace {

using meristem::InputError;
using meristem::Progress;
using meristem::bench::Asked;
using meristem::bench::sized;

constexpr std::uint64_t kNoLimit = 1'000'000'000;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string number(std::size_t k) { return std::to_string(k); }

/// Makes a document of its components and of other members. Each member begins with a comma.
std::string document(std::size_t components, const std::function<std::string(std::size_t)>& component,
                     const std::string& more) {
  std::string text = "{\n  \"meristem\": 1,\n  \"components\": {\n";
  for (std::size_t k = 0; k < components; ++k) {
    text += "    // the " + number(k) + "th\n    \"c" + number(k) + "\": " + component(k);
    text += k + 1 < components ? ",\n" : "\n";
  }
  return text + "  }" + more + "\n}\n";
}

std::string leaf(std::size_t) { return R"({"type": "leaf", "length": 0.1})"; }

std::string components(std::size_t count) { return document(count, leaf, ""); }

/// A stem and its children, each child by a link of its own with parameters.
std::string links(std::size_t count) {
  std::string all = ",\n  \"links\": [\n";
  for (std::size_t k = 1; k < count; ++k) {
    all += R"(    {"from": "c0", "to": "c)" + number(k) + R"(", "kind": "branch", "count": 3, "angle": 40})";
    all += k + 1 < count ? ",\n" : "\n";
  }
  const auto component = [](std::size_t k) {
    return k == 0 ? std::string(R"({"type": "tree", "length": 2, "radius": 0.1})") : leaf(k);
  };
  return document(count, component, all + "  ]");
}

/// A chain of links, one below the other.
std::string chain(std::size_t count) {
  std::string all = ",\n  \"links\": [\n";
  for (std::size_t k = 1; k < count; ++k) {
    all += "    [\"c" + number(k - 1) + "\", \"c" + number(k) + "\"]" + (k + 1 < count ? ",\n" : "\n");
  }
  return document(count, leaf, all + "  ]");
}

/// Variables that each instance of a component draws: the largest number that a document may have. Each component uses
/// one.
std::string drawn(std::size_t count) {
  const std::size_t variables = std::min<std::size_t>(count / 10, 1000);
  std::string all = ",\n  \"variables\": {\n";
  for (std::size_t v = 0; v < variables; ++v) {
    all += "    \"v" + number(v) + R"(": {"value": "0.01*i", "per": "c)" + number(v) + "\"}";
    all += v + 1 < variables ? ",\n" : "\n";
  }
  const auto component = [variables](std::size_t k) {
    return R"({"type": "leaf", "length": "0.1 + v)" + number(k % variables) + "\"}";
  };
  // The owners of variables form a chain, and all other components stand below the last owner.
  std::string below = "  },\n  \"links\": [\n";
  for (std::size_t k = 1; k < count; ++k) {
    below += "    [\"c" + number(std::min(k, variables) - 1) + "\", \"c" + number(k) + "\"]";
    below += k + 1 < count ? ",\n" : "\n";
  }
  // An owner uses its own variable, which it sees.
  return document(count, component, all + below + "  ]");
}

/// More variables than a document may have. They are refused in the time of reading them.
std::string too_many(std::size_t count) {
  std::string all = ",\n  \"variables\": {\n";
  for (std::size_t v = 0; v < count; ++v) {
    all += "    \"v" + number(v) + R"(": {"value": "0.01*i", "per": "c0"})" + (v + 1 < count ? ",\n" : "\n");
  }
  return document(1, leaf, all + "  }");
}

/// A fault in each component: an unknown name. Some of the faults are reported with their positions.
std::string errors(std::size_t count) {
  std::string all = ",\n  \"links\": [\n";
  for (std::size_t k = 1; k < count; ++k) {
    all += "    [\"c0\", \"d" + number(k) + "\"]" + (k + 1 < count ? ",\n" : "\n");
  }
  const auto component = [](std::size_t) { return R"({"type": "leaf", "lenght": 0.1})"; };
  return document(count, component, all + "  ]");
}

/// Reads, checks, and finds the positions of faults and of notes.
void read(const std::string& text, const Progress* progress = nullptr) {
  try {
    const meristem::Document document = meristem::read_document(text, "large.json", meristem::builtin_components(),
                                                                {.progress = progress, .document_bytes = kNoLimit});
    benchmark::DoNotOptimize(document.graph.components.size());
  } catch (const InputError& error) {
    benchmark::DoNotOptimize(error.diagnostics().size());
  }
}

/// Returns the seconds that a processor needs to read a text.
double processor_seconds_to_read(const std::string& text) {
  const std::clock_t begin = std::clock();
  read(text);
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double seconds_to_read(const std::string& text) {
  const auto begin = std::chrono::steady_clock::now();
  read(text);
  return seconds_since(begin);
}

using Maker = std::string (*)(std::size_t count);

void reading(benchmark::State& state, Maker make) {
  const std::size_t small = sized<std::size_t>(10'000, 100);
  const std::size_t large = 100 * small / sized<std::size_t>(1, 10);
  const std::string small_text = make(small);
  const std::string large_text = make(large);
  double of_small = 1e9;
  double of_large = 1e9;
  for (auto _ : state) {
    for (int k = 0; k < sized(5, 1); ++k) of_small = std::min(of_small, processor_seconds_to_read(small_text));
    for (int k = 0; k < sized(2, 1); ++k) of_large = std::min(of_large, processor_seconds_to_read(large_text));
  }
  const auto times = static_cast<double>(large_text.size()) / static_cast<double>(small_text.size());
  state.counters["exponent"] = std::log(of_large / of_small) / std::log(times);
  state.counters["ms_small"] = 1e3 * of_small;
  state.counters["ms_large"] = 1e3 * of_large;
  state.counters["mb_large"] = 1e-6 * static_cast<double>(large_text.size());
}

/// Measures the longest time from a cancel until the reading that it stops has thrown.
void cancel_reading(benchmark::State& state, const std::string& text) {
  const double whole = seconds_to_read(text);
  constexpr int kCancels = 20;
  double longest = 0;
  for (auto _ : state) {
    for (int k = 0; k < kCancels; ++k) {
      Progress progress;
      std::chrono::steady_clock::time_point cancelled;
      std::thread hand([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(whole * k / kCancels));
        cancelled = std::chrono::steady_clock::now();
        progress.cancel();
      });
      bool is_stopped = false;
      try {
        read(text, &progress);
      } catch (const meristem::Cancelled&) {
        is_stopped = true;
      }
      const auto end = std::chrono::steady_clock::now();
      hand.join();
      if (is_stopped) longest = std::max(longest, 1e3 * std::chrono::duration<double>(end - cancelled).count());
    }
  }
  state.counters["cancel_ms"] = longest;
}

void cancelling(benchmark::State& state, Maker make) { cancel_reading(state, make(sized<std::size_t>(300'000, 1000))); }

// Files that documents name. A mesh of a grid, points, a table of nodes and a table of places.

std::string rows(std::size_t count, const std::function<std::string(std::size_t)>& row) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += row(k) + "\n";
  return text;
}

std::string grid_point(std::size_t k) { return number(k % 1000) + " " + number(k / 1000) + " " + number(k % 7); }

std::string obj_file(std::size_t count) {
  const auto face = [](std::size_t k) { return "f " + number(k + 1) + " " + number(k + 2) + " " + number(k + 3); };
  return rows(count, [](std::size_t k) { return "v " + grid_point(k); }) + rows(count - 2, face);
}

std::string ply_file(std::size_t count) {
  const auto face = [](std::size_t k) { return "3 " + number(k) + " " + number(k + 1) + " " + number(k + 2); };
  return "ply\nformat ascii 1.0\nelement vertex " + number(count) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + number(count - 2) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + rows(count, grid_point) + rows(count - 2, face);
}

std::string points_file(std::size_t count) { return rows(count, grid_point); }

std::string nodes_file(std::size_t count) {
  return "node,x,y,z,parent,radius\n" + rows(count, [](std::size_t k) {
           return number(k) + ",0," + number(k % 1000) + ",1," + (k == 0 ? "-1" : number(k - 1)) + ",0.1";
         });
}

std::string table_file(std::size_t count) {
  const auto row = [](std::size_t k) { return number(k % 1000) + "," + number(k / 1000) + ",t" + number(k % 9); };
  return "x,y,kind\n" + rows(std::min<std::size_t>(count, 900'000), row);
}

/// The path of a file with that content, which is removed with this object.
class NamedFile {
 public:
  NamedFile(const std::string& name, const std::string& content)
      : path_((std::filesystem::temp_directory_path() / (number(::getpid()) + name)).string()) {
    std::ofstream(path_) << content;
  }
  ~NamedFile() { std::filesystem::remove(path_); }
  NamedFile(const NamedFile&) = delete;
  NamedFile& operator=(const NamedFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// `members` are the members of a document. PATH stands for the path of its file.
void cancelling_file(benchmark::State& state, Maker make, const char* name, std::string members) {
  const NamedFile file(name, make(sized<std::size_t>(2'000'000, 2000)));
  members.replace(members.find("PATH"), 4, file.path());
  cancel_reading(state, "{\"meristem\": 1, " + members + "}");
}

#define MERISTEM_READING_FILE(what, name, members)                     \
  BENCHMARK_CAPTURE(cancelling_file, what, what##_file, name, members) \
      ->Iterations(1)                                                  \
      ->Unit(benchmark::kMillisecond)                                  \
      ->UseRealTime()
constexpr const char* kObstacle =
    R"("scene": {"obstacles": [{"mesh": "PATH", "broken": true}]}, "components": {"t": {"type": "tree"}})";
MERISTEM_READING_FILE(obj, "m.obj", kObstacle);
MERISTEM_READING_FILE(ply, "m.ply", kObstacle);
MERISTEM_READING_FILE(points, "p.xyz", R"("components": {"t": {"type": "colonize", "points": {"file": "PATH"}}})");
MERISTEM_READING_FILE(nodes, "n.csv", R"("components": {"t": {"type": "skeleton", "file": "PATH"}})");
MERISTEM_READING_FILE(table, "t.csv", R"("components": {"t": {"type": "places", "table": "PATH"}})");

#define MERISTEM_READING(what)                                                                         \
  BENCHMARK_CAPTURE(reading, what, what)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime(); \
  BENCHMARK_CAPTURE(cancelling, what, what)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime()
MERISTEM_READING(components);
MERISTEM_READING(links);
MERISTEM_READING(chain);
MERISTEM_READING(drawn);
MERISTEM_READING(too_many);
MERISTEM_READING(errors);

}  // namespace

int main(int count, char** arguments) {
  // Keeps freed memory in the program, so that neither size waits for the system to clear pages.
  mallopt(M_MMAP_THRESHOLD, std::numeric_limits<int>::max());
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  std::vector<Asked> asked;
  for (const char* const what : {"components", "links", "chain", "drawn", "too_many", "faults"}) {
    asked.push_back({std::string("reading/") + what, "exponent", Asked::at_most, 1.1});
    asked.push_back({std::string("cancelling/") + what, "cancel_ms", Asked::at_most, 50});
  }
  for (const char* const what : {"obj", "ply", "points", "nodes", "table"}) {
    asked.push_back({std::string("cancelling_file/") + what, "cancel_ms", Asked::at_most, 50});
  }
  return meristem::bench::run(count, arguments, asked);
}

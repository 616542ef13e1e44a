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
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include <benchmark/benchmark.h>
#include <malloc.h>

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
std::string faults(std::size_t count) {
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

/// The longest time from a cancel until the reading that it stops has thrown.
void cancelling(benchmark::State& state, Maker make) {
  const std::string text = make(sized<std::size_t>(300'000, 1000));
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

#define MERISTEM_READING(what)                                                                         \
  BENCHMARK_CAPTURE(reading, what, what)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime(); \
  BENCHMARK_CAPTURE(cancelling, what, what)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime()
MERISTEM_READING(components);
MERISTEM_READING(links);
MERISTEM_READING(chain);
MERISTEM_READING(drawn);
MERISTEM_READING(too_many);
MERISTEM_READING(faults);

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
  return meristem::bench::run(count, arguments, asked);
}

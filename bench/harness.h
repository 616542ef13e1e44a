// SPDX-License-Identifier: Apache-2.0
// Shared code of all benchmarks. A table at the end lists the figures that have a bound, and the figures with a
// reference measured in the same run: names, figures, ratios, bounds, and whether the bounds are met. In a small run
// (MERISTEM_BENCH=small, which the tests set) everything runs once, in tiny sizes. A small run only checks that the
// benchmarks still work.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

namespace meristem::bench {

inline bool is_small() {
  static const bool is_small = [] {
    const char* const run = std::getenv("MERISTEM_BENCH");
    return run != nullptr && std::string_view(run) == "small";
  }();
  return is_small;
}

/// Returns a size, or its replacement in a small run.
template <class Size>
Size sized(Size whole, Size small) {
  return is_small() ? small : whole;
}
inline std::vector<std::int64_t> sized(std::vector<std::int64_t> whole, std::vector<std::int64_t> small) {
  return is_small() ? small : whole;
}

/// Returns the largest memory that the process has had so far, in megabytes (2^20 bytes).
inline double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// The bound of a figure.
struct Asked {
  std::string benchmark;  ///< its name in the table
  std::string counter;    ///< one of its counters, or "ms": the time of an iteration
  enum Bound { at_most, at_least } bound = at_most;
  double value = 0;
};

/// A line of the table.
struct Figure {
  std::string name, value, reference, ratio, asked, held;
};

inline std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value >= 1e5 || value < 1e-3 ? "%.3g" : "%.4g", value);
  return text;
}

class TableReporter : public benchmark::ConsoleReporter {
 public:
  explicit TableReporter(std::vector<Asked> asked)
      : ConsoleReporter(isatty(STDOUT_FILENO) != 0 ? OO_Color : OO_None), asked_(std::move(asked)) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      has_failed_ |= run.error_occurred;
      if (run.run_type == Run::RT_Iteration && !run.error_occurred) add_figures(run);
    }
  }

  bool has_failed() const { return has_failed_; }
  const std::vector<Figure>& figures() const { return figures_; }

 private:
  /// Returns a name such as `tubes/nodes:10000`, without the library's additions about timing.
  static std::string name_of(const Run& run) {
    const std::string& arguments = run.run_name.args;
    return run.run_name.function_name + (arguments.empty() ? "" : "/" + arguments);
  }

  static double milliseconds(const Run& run) {
    return 1e3 * run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
  }

  void add_figures(const Run& run) {
    Figure figure{.name = name_of(run)};
    for (const auto& [name, counter] : run.counters) {
      if (!name.starts_with("to_")) continue;
      figure.reference = name.substr(3);
      figure.ratio = short_number(counter.value);
    }
    bool is_asked = false;
    for (const Asked& asked : asked_) {
      if (asked.benchmark != figure.name) continue;
      const auto counter = run.counters.find(asked.counter);
      if (asked.counter != "ms" && counter == run.counters.end()) continue;
      const double value = asked.counter == "ms" ? milliseconds(run) : double{counter->second.value};
      const bool is_max = asked.bound == Asked::at_most;
      Figure line = figure;
      line.value = short_number(value) + " " + asked.counter;
      line.asked = (is_max ? "<= " : ">= ") + short_number(asked.value);
      line.held = (is_max ? value <= asked.value : value >= asked.value) ? "held" : "NOT HELD";
      figures_.push_back(std::move(line));
      is_asked = true;
    }
    if (is_asked || figure.reference.empty()) return;
    figure.value = short_number(milliseconds(run)) + " ms";
    figures_.push_back(std::move(figure));
  }

  std::vector<Asked> asked_;
  std::vector<Figure> figures_;
  bool has_failed_ = false;
};

/// Runs the benchmarks; main() calls it. `after`, if given, checks the results and returns true if they are right. The
/// lines of the table are appended to the file named by MERISTEM_BENCH_TABLE, with fields separated by tabs.
inline int run(int count, char** arguments, std::vector<Asked> asked = {}, const std::function<bool()>& after = {}) {
  std::vector<char*> given(arguments, arguments + count);
  char once[] = "--benchmark_min_time=0.000001";
  if (is_small()) given.push_back(once);
  auto given_count = static_cast<int>(given.size());
  given.push_back(nullptr);
  benchmark::Initialize(&given_count, given.data());
  if (benchmark::ReportUnrecognizedArguments(given_count, given.data())) return EXIT_FAILURE;
  TableReporter reporter(std::move(asked));
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  const bool is_right = !after || after();
  if (const char* const path = std::getenv("MERISTEM_BENCH_TABLE"); path != nullptr && !is_small()) {
    std::string program(arguments[0]);
    program.erase(0, program.rfind('/') + 1);
    std::ofstream table(path, std::ios::app);
    for (const Figure& f : reporter.figures()) {
      table << program.substr(0, program.rfind("_bench")) << ' ' << f.name << '\t' << f.value << '\t' << f.reference
            << '\t' << f.ratio << '\t' << f.asked << '\t' << f.held << '\n';
    }
  }
  return is_right && !reporter.has_failed() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace meristem::bench

// SPDX-License-Identifier: Apache-2.0
#include "frames.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "meristem/base/diagnostic.h"

namespace meristem::film {

namespace {

InputError wrong_time(const std::string& text, std::string expected) {
  return InputError(Diagnostic{.message = fmt::format("--time cannot be '{}'", text), .expected = std::move(expected)});
}

/// All of the finite numbers between colons; none where there is anything else.
std::vector<double> numbers_between_colons(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double number = 0;
    const auto read = std::from_chars(at, end, number);
    if (read.ec != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (read.ptr == end) return numbers;
    if (*read.ptr != ':') return {};
    at = read.ptr + 1;
  }
}

}  // namespace

std::vector<std::string> frame_paths(const std::string& path, int frames) {
  if (path == "-") {
    throw InputError(Diagnostic{.message = "numbered frames cannot be written to standard output",
                                .expected = "a file name such as oak.png for oak_000.png, oak_001.png, ..."});
  }
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(frames - 1).size());
  const std::string ending = std::filesystem::path(path).extension().string();
  const std::string stem = path.substr(0, path.size() - ending.size());
  std::vector<std::string> paths;
  for (int k = 0; k < frames; ++k) {
    paths.push_back(fmt::format("{}_{:0{}}{}", stem, k, digits, ending));
  }
  return paths;
}

/// A last step that rounding has carried past the end still counts.
std::size_t FrameTimes::count() const { return 1 + static_cast<std::size_t>(std::floor((to - from) / step + 1e-9)); }

std::vector<double> FrameTimes::all() const {
  std::vector<double> times;
  for (std::size_t k = 0; k < count(); ++k) times.push_back(at(k));
  return times;
}

std::string wanting(const FrameTimes& times) {
  if (!(times.step > 0)) return "a step above 0";
  if (!(times.to >= times.from)) return "an end that is not before the start";
  const bool are_few = (times.to - times.from) / times.step + 1e-9 < kMaxFrames;
  return are_few ? "" : fmt::format("at most {} frames", kMaxFrames);
}

FrameTimes frame_times(double length, double fps) {
  const FrameTimes times{.from = 0, .to = length, .step = 1 / fps};
  const std::string wanted = wanting(times);
  if (!wanted.empty()) {
    throw InputError(Diagnostic{
        .message = fmt::format("no film is made of an animation of {} s with {} frames per second", length, fps),
        .expected = wanted,
        .path = "animation"});
  }
  return times;
}

std::vector<double> frame_times(const std::string& text) {
  const std::vector<double> numbers = numbers_between_colons(text);
  if (numbers.size() == 1) return numbers;
  if (numbers.size() != 3) throw wrong_time(text, "seconds, such as 2.5, or FROM:TO:STEP, such as 0:10:0.5");
  const FrameTimes times{.from = numbers[0], .to = numbers[1], .step = numbers[2]};
  const std::string wanted = wanting(times);
  if (!wanted.empty()) throw wrong_time(text, wanted);
  return times.all();
}

double checked_time(double time) {
  if (!std::isfinite(time)) throw wrong_time(fmt::format("{}", time), "a time in seconds, such as 2.5");
  return time;
}

}  // namespace meristem::film

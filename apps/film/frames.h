// SPDX-License-Identifier: Apache-2.0
// Pictures that belong together: their names and the times that they show.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace meristem::film {

/// The most pictures that one call writes.
inline constexpr int kMaxFrames = 10'000;

/// One name for each of `frames` pictures: `oak_000.png`, `oak_001.png`, ... for `oak.png`, with as many digits as the
/// last needs and at least three. Throws InputError for standard output.
std::vector<std::string> frame_paths(const std::string& path, int frames);

/// Times of pictures at equal distances, seconds.
struct FrameTimes {
  double from = 0;
  double to = 0;
  double step = 0;

  std::size_t count() const;
  double at(std::size_t frame) const { return from + static_cast<double>(frame) * step; }
  std::vector<double> all() const;
};

/// What such times must have and these have not: "a step above 0"; empty where they are right. At most kMaxFrames
/// times are.
std::string wanting(const FrameTimes& times);

/// The times of the film of an animation of that many seconds. Throws InputError where they would be too many.
FrameTimes frame_times(double length, double fps);

/// The times, in seconds, of "T" or of "A:B:STEP": from A in steps up to B. Throws InputError for other texts, for
/// steps that lead nowhere and for more than kMaxFrames times.
std::vector<double> frame_times(const std::string& text);

/// The time of `--time T`. Throws InputError for numbers that are not finite.
double checked_time(double time);

}  // namespace meristem::film

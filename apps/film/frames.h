// SPDX-License-Identifier: Apache-2.0
// Pictures that belong together: their names and the times that they show.
#pragma once

#include <string>
#include <vector>

namespace meristem::film {

/// The most pictures that one call writes.
inline constexpr int kMostFrames = 10'000;

/// One name for each of `frames` pictures: `oak_000.png`, `oak_001.png`, ... for `oak.png`, with as many digits as the
/// last needs and at least three. Throws InputError for standard output.
std::vector<std::string> frame_paths(const std::string& path, int frames);

/// The times, in seconds, of "T" or of "A:B:STEP": from A in steps up to B. Throws InputError for other texts, for
/// steps that lead nowhere and for more than kMostFrames times.
std::vector<double> frame_times(const std::string& text);

/// The time of `--time T`. Throws InputError for numbers that are not finite.
double checked_time(double time);

}  // namespace meristem::film

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// The Strahler number of every node: 1 at tips; before a fork the largest of its children's, one more if two or more
/// share it.
std::vector<std::uint8_t> strahler_numbers(const Skeleton& skeleton, const Children& children);

/// How many streams there are of each Strahler number from 1: runs of nodes of one number, counted where they begin.
std::vector<std::uint64_t> strahler_streams(const Skeleton& skeleton, std::span<const std::uint8_t> numbers);

/// Streams of each number over those of the next: one entry less than `streams`.
std::vector<double> bifurcation_ratios(std::span<const std::uint64_t> streams);

/// The geometric mean of all bifurcation ratios, which is the root of first over last. `streams` has at least two.
double mean_bifurcation_ratio(std::span<const std::uint64_t> streams);

}  // namespace meristem

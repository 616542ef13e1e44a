// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Returns the Strahler number of every node. Tips have 1. A node before a fork has the largest number of its children,
/// plus one if two or more children share this number.
std::vector<std::uint8_t> strahler_numbers(const Skeleton& skeleton, const NodeChildren& children);

/// Returns the number of streams of each Strahler number, from 1. A stream is a run of nodes with one number and is
/// counted where it begins.
std::vector<std::uint64_t> strahler_streams(const Skeleton& skeleton, std::span<const std::uint8_t> numbers);

/// Returns the streams of each number divided by the streams of the next number. The result has one entry less than
/// `streams`.
std::vector<double> bifurcation_ratios(std::span<const std::uint64_t> streams);

/// Returns the geometric mean of all bifurcation ratios, which is a root of the first count divided by the last. Throws
/// std::invalid_argument for fewer than two entries.
double mean_bifurcation_ratio(std::span<const std::uint64_t> streams);

}  // namespace meristem

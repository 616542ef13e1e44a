// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Succeeds if the skeleton is valid. All columns have one entry per node, parents come before children, and numbers
/// are finite. Radii are positive and not larger than the parent's, births are not before the parent's, and no segment
/// is shorter than 1e-7 m. Axes are numbered in the order of their first nodes, each axis is one chain, and orders
/// increase by one from an axis to its laterals. The failure names the node.
testing::AssertionResult check_skeleton(const Skeleton& skeleton);

}  // namespace meristem

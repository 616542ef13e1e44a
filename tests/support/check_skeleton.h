// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "meristem/plant/skeleton.h"

namespace meristem {

/// Success if all columns have one entry per node, parents come before children, numbers are finite, radii positive and
/// not larger than the parent's, births not before the parent's, no segment is shorter than 1e-7 m, axes are numbered
/// in the order of their first nodes, each axis is one chain, and orders rise by one from an axis to its laterals. The
/// failure names the node.
testing::AssertionResult check_skeleton(const Skeleton& skeleton);

}  // namespace meristem

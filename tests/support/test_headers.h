// SPDX-License-Identifier: Apache-2.0
// What most tests include, precompiled once for all of them: parsing it takes longer than most tests' own code.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/base/frame.h"
#include "meristem/base/random.h"

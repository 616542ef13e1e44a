// SPDX-License-Identifier: Apache-2.0
// Headers that most tests include, precompiled once. Parsing them takes longer than compiling most tests.
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

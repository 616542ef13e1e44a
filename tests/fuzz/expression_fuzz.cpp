// SPDX-License-Identifier: Apache-2.0
// Fuzzes expressions: either an error inside the text, or a formula whose 75 lanes in one call have the values of
// single calls.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "meristem/base/expression/expression.h"
#include "tests/fuzz/require.h"

namespace {

using meristem::Expression;
using meristem::ExpressionError;
using meristem::ExpressionNames;
using meristem::RandomKey;
using meristem::require;

constexpr std::size_t kLanes = 75;  // a block of 64, a block of 8 and three single lanes

void compare_lanes(const Expression& expression) {
  std::vector<double> i(kLanes);
  std::vector<double> u(kLanes);
  std::vector<RandomKey> keys(kLanes);
  for (std::size_t k = 0; k < kLanes; ++k) {
    i[k] = static_cast<double>(k) - 3;
    u[k] = static_cast<double>(k) / kLanes;
    keys[k] = RandomKey(5).child(k);
  }
  const double* const variables[] = {i.data(), u.data()};
  std::vector<double> together(kLanes);
  expression.evaluate(kLanes, variables, keys, together.data());
  for (std::size_t k = 0; k < kLanes; ++k) {
    const double values[] = {i[k], u[k]};
    const double alone = expression.evaluate(values, keys[k]);
    require(together[k] == alone || (std::isnan(together[k]) && std::isnan(alone)));
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer requires this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static const ExpressionNames kNames{{"i", "u"}, {{"age", 12}}};
  try {
    compare_lanes(Expression::compile(text, kNames));
  } catch (const ExpressionError& error) {
    require(error.details().offset <= size);
    require(!error.details().message.empty() && !error.details().expected.empty());
  }
  return 0;
}
